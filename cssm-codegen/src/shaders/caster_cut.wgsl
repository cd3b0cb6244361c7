// The facet's half-spaces, fragment by fragment.

/// Whether a fragment lies outside one of the facet's half-spaces.
fn is_cut(clips: vec2<f32>) -> bool {
    return any(clips < vec2<f32>(0.0));
}
