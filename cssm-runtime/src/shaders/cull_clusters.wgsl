// Which clusters of cut instances reach their facets: neighbours that do share a draw.

struct Cluster {
    // Its box in object space, rounded outward.
    centre: vec3<f32>,
    // Its corners.
    first: u32,
    half: vec3<f32>,
    end: u32,
}

@group(0) @binding(0) var<storage, read> planes: array<vec4<f32>>;
@group(0) @binding(1) var<storage, read> clusters: array<Cluster>;
@group(0) @binding(2) var<storage, read> draws: array<Draw>;
@group(0) @binding(3) var<storage, read> rows: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> arguments: array<atomic<u32>>;
@group(0) @binding(5) var<storage, read> cuts: array<Cut>;
// Arguments of one draw after another.
@group(0) @binding(6) var<storage, read_write> cluster_arguments: array<u32>;

const LANES: u32 = 64u;

var<workgroup> cut_count: u32;
var<workgroup> cut_here: Cut;
var<workgroup> clusters_here: u32;
// One for each lane whose cluster reaches the facet.
var<workgroup> reaches: array<u32, LANES>;

// Whether nothing keeps a cluster from reaching its facet.
fn is_reached(cut: Cut, cluster: Cluster) -> bool {
    let x = rows[3u * cut.row];
    let y = rows[3u * cut.row + 1u];
    let z = rows[3u * cut.row + 2u];
    for (var plane = 0u; plane < cut.planes; plane++) {
        if side_of(planes[cut.first_plane + plane], x, y, z, cluster.centre, cluster.half) == OUTSIDE {
            return false;
        }
    }
    return true;
}

// Appends a draw of a range of corners.
fn append(draw: Draw, row: u32, first: u32, end: u32) {
    let number = atomicAdd(&arguments[draw.counters], 1u);
    let at = draw.cluster_arguments + number * (4u + draw.is_indexed);
    cluster_arguments[at] = end - first;
    cluster_arguments[at + 1u] = 1u;
    cluster_arguments[at + 2u] = first;
    if draw.is_indexed == 1u {
        cluster_arguments[at + 3u] = 0u;
    }
    cluster_arguments[at + 3u + draw.is_indexed] = row;
}

@compute @workgroup_size(64)
fn cull_clusters(
    @builtin(workgroup_id) workgroup: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    if lane == 0u {
        cut_count = atomicLoad(&arguments[0]);
    }
    let count = workgroupUniformLoad(&cut_count);
    for (var number = workgroup.x; number < count; number += workgroups.x) {
        if lane == 0u {
            cut_here = cuts[number];
            clusters_here = draws[cuts[number].draw].clusters;
        }
        let cut = workgroupUniformLoad(&cut_here);
        let clusters_of_mesh = workgroupUniformLoad(&clusters_here);
        let draw = draws[cut.draw];
        for (var start = 0u; start < clusters_of_mesh; start += LANES) {
            // Test a cluster in each lane.
            let own = draw.first_cluster + start + lane;
            var is_drawn = false;
            if start + lane < clusters_of_mesh {
                is_drawn = is_reached(cut, clusters[own]);
            }
            reaches[lane] = u32(is_drawn);
            workgroupBarrier();

            // Let the first lane of each run draw all of it.
            var is_first = is_drawn;
            if lane > 0u {
                is_first = is_drawn && reaches[lane - 1u] == 0u;
            }
            if is_first {
                var last = lane;
                while last + 1u < LANES && reaches[last + 1u] == 1u {
                    last++;
                }
                append(draw, cut.row, clusters[own].first, clusters[own + last - lane].end);
            }
            workgroupBarrier();
        }
    }
}
