// What both passes of culling share.

// What a facet draws of a mesh.
struct Draw {
    // The box of the mesh in object space, rounded outward.
    centre: vec3<f32>,
    first_cluster: u32,
    half: vec3<f32>,
    clusters: u32,
    // Rows of its own: whole instances fill them from the start, cut ones from the end.
    rows_start: u32,
    rows_end: u32,
    // Words of its arguments, and of two counters: draws of clusters, cut instances.
    arguments: u32,
    counters: u32,
    // Words of the arguments of its clusters.
    cluster_arguments: u32,
    is_indexed: u32,
    unused_first: u32,
    unused_second: u32,
}

// An instance that is cut.
struct Cut {
    draw: u32,
    row: u32,
    first_plane: u32,
    planes: u32,
}

// Share of the sum of all magnitudes in a test that f32 may be wrong by: the test takes at most two dozen roundings of
// half a unit in the last place, and its inputs were rounded once.
const MARGIN: f32 = 1.9073486e-6;

const INSIDE: u32 = 0u;
const CROSSING: u32 = 1u;
const OUTSIDE: u32 = 2u;

// How a box of object space lies to a half-space; where f32 cannot tell, it crosses.
fn side_of(plane: vec4<f32>, x: vec4<f32>, y: vec4<f32>, z: vec4<f32>, centre: vec3<f32>, half: vec3<f32>) -> u32 {
    // Bring the half-space to object space.
    let in_object = plane.x * x + plane.y * y + plane.z * z;
    let distance = dot(in_object.xyz, centre) + in_object.w + plane.w;
    let reach = dot(abs(in_object.xyz), half);

    // Sum up what may have been rounded.
    let sizes = abs(plane.x * x) + abs(plane.y * y) + abs(plane.z * z);
    let margin = MARGIN * (dot(sizes.xyz, abs(centre) + half) + sizes.w + abs(plane.w));
    if distance + reach < -margin {
        return OUTSIDE;
    }
    if distance - reach >= margin {
        return INSIDE;
    }
    return CROSSING;
}
