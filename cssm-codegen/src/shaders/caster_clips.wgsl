// Where facets share a tile, two half-spaces keep each facet's casters on its own part of it.

/// Distances of a position in the capture's axes from the facet's half-spaces; negative outside.
fn clip_values(position: vec4<f32>) -> vec2<f32> {
    return vec2<f32>(dot(capture.clips[0], position), dot(capture.clips[1], position));
}
