// Holes of casters that an alpha mask cuts out.

/// Whether a caster has a hole at its mask's coordinates; the sample takes derivatives, so every fragment must call it.
fn is_hole(uv: vec2<f32>) -> bool {
    return textureSample(caster_mask_texture, caster_mask_sampler, uv).a < caster_mask.alpha_cutoff;
}
