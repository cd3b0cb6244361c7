// Which of a facet's candidates draw anything in it: those that reach it whole become rows of one draw, those that
// its half-spaces cut wait for `cull_clusters`.

// The casters of a block that a facet may be reached by, and the half-spaces that cut through the block.
struct Block {
    first_plane: u32,
    planes: u32,
    draw: u32,
    first_candidate: u32,
    candidates: u32,
}

// Half-spaces of unit normals in the axes of the capture, relative to the eye.
@group(0) @binding(0) var<storage, read> planes: array<vec4<f32>>;
// Three rows for each, from object space to the axes of the capture, relative to the eye.
@group(0) @binding(1) var<storage, read> candidates: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> blocks: array<Block>;
@group(0) @binding(3) var<storage, read> draws: array<Draw>;
// Three for each instance that is drawn.
@group(0) @binding(4) var<storage, read_write> rows: array<vec4<f32>>;
// The number of cut instances, the number of blocks, one, then arguments and counters of draws.
@group(0) @binding(5) var<storage, read_write> arguments: array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> cuts: array<Cut>;

const BLOCK_CASTERS: u32 = 16u;
@compute @workgroup_size(64)
fn cull_instances(
    @builtin(workgroup_id) workgroup: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    // Four blocks for each workgroup.
    let number = (workgroup.x + workgroup.y * workgroups.x) * (64u / BLOCK_CASTERS) + lane / BLOCK_CASTERS;
    if number >= atomicLoad(&arguments[1]) {
        return;
    }
    let block = blocks[number];
    let member = lane % BLOCK_CASTERS;
    if member >= block.candidates {
        return;
    }
    let draw = draws[block.draw];
    let candidate = 3u * (block.first_candidate + member);
    let x = candidates[candidate];
    let y = candidates[candidate + 1u];
    let z = candidates[candidate + 2u];

    // Test the instance's own box.
    var is_cut = false;
    for (var plane = 0u; plane < block.planes; plane++) {
        let side = side_of(planes[block.first_plane + plane], x, y, z, draw.centre, draw.half);
        if side == OUTSIDE {
            return;
        }
        is_cut = is_cut || side == CROSSING;
    }

    // Put its row where the draw finds it.
    var row = 0u;
    if is_cut && draw.clusters > 1u {
        row = draw.rows_end - 1u - atomicAdd(&arguments[draw.counters + 1u], 1u);
        let cut = atomicAdd(&arguments[0], 1u);
        cuts[cut] = Cut(block.draw, row, block.first_plane, block.planes);
    } else {
        row = draw.rows_start + atomicAdd(&arguments[draw.arguments + 1u], 1u);
    }
    rows[3u * row] = x;
    rows[3u * row + 1u] = y;
    rows[3u * row + 2u] = z;
}
