// Slot: how texels become visibility. Here: by mean and variance of the warped depths around the receiver, which the
// prefilter has blurred.

/// Least standard deviation, in shares of the warped receiver depth: what rounding of the moments may hide.
const LEAST_DEVIATION: f32 = 0.005;

/// Blurred mean and mean square at a texel.
fn moments_at(texel: vec2<i32>) -> vec2<f32> {
    return textureLoad(moments, texel, 0).xy;
}

/// Share of light that reaches the receiver, at most.
fn filtered_visibility(receiver: Receiver) -> f32 {
    // Blend the moments of four texels: no device has to filter such textures.
    let corner = floor(receiver.texel - 0.5);
    let weight = receiver.texel - 0.5 - corner;
    let first = vec2<i32>(corner);
    let upper = mix(moments_at(first), moments_at(first + vec2<i32>(1, 0)), weight.x);
    let lower = mix(moments_at(first + vec2<i32>(0, 1)), moments_at(first + vec2<i32>(1, 1)), weight.x);
    let blended = mix(upper, lower, weight.y);

    // Bound the share of casters behind the receiver by Chebyshev's inequality, one-tailed.
    let depth = warped(held_depth(receiver.reference));
    let before = depth - blended.x;
    if before <= 0.0 {
        return 1.0;
    }
    let least = LEAST_DEVIATION * depth;
    let variance = max(blended.y - blended.x * blended.x, least * least);
    let share = variance / (variance + before * before);
    return clamp((share - BLEEDING) / (1.0 - BLEEDING), 0.0, 1.0);
}
