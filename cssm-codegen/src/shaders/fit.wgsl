// The reduction of the engine's depth: how many pixels see each depth, where, and between which depths.

/// Numbers: smallest and largest depth, then of each bin the pixels and their rectangle. All begin at zero and grow;
/// what is to be smallest is kept as its complement.
const WORDS: u32 = 322u;
/// Numbers of a bin: pixels, complements of the left and the upper edge, the right and the lower edge.
const BIN_WORDS: u32 = 5u;
/// Numbers before the first bin.
const HEAD_WORDS: u32 = 2u;
/// Side of the square of threads of a group.
const GROUP_SIDE: u32 = 16u;
/// Side of the square of pixels of a thread; they lie a group's side apart.
const PIXELS_SIDE: u32 = 4u;

/// The group's own numbers.
var<workgroup> own: array<atomic<u32>, WORDS>;

/// Adds a pixel to the group's numbers.
fn count_pixel(pixel: vec2<u32>, metres: f32) {
    let bits = bitcast<u32>(metres);
    atomicMax(&own[0], ~bits);
    atomicMax(&own[1], bits);
    let bin = HEAD_WORDS + depth_bin(metres) * BIN_WORDS;
    atomicAdd(&own[bin], 1u);
    atomicMax(&own[bin + 1u], ~pixel.x);
    atomicMax(&own[bin + 2u], ~pixel.y);
    atomicMax(&own[bin + 3u], pixel.x + 1u);
    atomicMax(&own[bin + 4u], pixel.y + 1u);
}

/// Measures a square of pixels and adds what it finds to the frame's numbers.
@compute @workgroup_size(16, 16)
fn fit_measure(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(local_invocation_id) thread: vec3<u32>,
    @builtin(local_invocation_index) first: u32,
) {
    for (var word = first; word < WORDS; word += GROUP_SIDE * GROUP_SIDE) {
        atomicStore(&own[word], 0u);
    }
    workgroupBarrier();

    let size = vec2<u32>(textureDimensions(scene_depth));
    let corner = group.xy * (GROUP_SIDE * PIXELS_SIDE) + thread.xy;
    for (var index = 0u; index < PIXELS_SIDE * PIXELS_SIDE; index += 1u) {
        let pixel = corner + vec2<u32>(index % PIXELS_SIDE, index / PIXELS_SIDE) * GROUP_SIDE;
        if all(pixel < size) {
            let metres = measured_metres(vec2<i32>(pixel));
            if metres > 0.0 && bitcast<u32>(metres) < INFINITE_BITS {
                count_pixel(pixel, metres);
            }
        }
    }
    workgroupBarrier();

    for (var word = first; word < WORDS; word += GROUP_SIDE * GROUP_SIDE) {
        let value = atomicLoad(&own[word]);
        if value > 0u {
            let counts = word >= HEAD_WORDS && (word - HEAD_WORDS) % BIN_WORDS == 0u;
            if counts {
                atomicAdd(&measured[word], value);
            } else {
                atomicMax(&measured[word], value);
            }
        }
    }
}
