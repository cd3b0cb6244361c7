// Where this engine's plants are. Its own passes place vertices with these functions, and so does the shadow capture.

/// What animates the plants this frame.
struct Plants {
    /// Joints of the stem, from the stem's rest to its object space.
    joints: array<mat4x4<f32>, 2>,
    /// Centres of the leaves relative to the meadow's origin, and the angle each is turned by.
    leaves: array<vec4<f32>, 40>,
    /// How far the wind moves a leaf, and its phase.
    wind: vec4<f32>,
}
@group(1) @binding(0) var<uniform> plants: Plants;

/// A vertex of the stem at rest.
struct StemVertex {
    @location(0) position: vec3<f32>,
    /// Share of the second joint.
    @location(1) bend: f32,
}

/// A skinned vertex, in the stem's object space.
fn stem_position(vertex: StemVertex) -> vec3<f32> {
    let rest = vec4<f32>(vertex.position, 1.0);
    return mix(plants.joints[0] * rest, plants.joints[1] * rest, vertex.bend).xyz;
}

/// A corner of one of many leaves.
struct LeafVertex {
    @location(0) corner: vec2<f32>,
    @builtin(instance_index) instance: u32,
}

/// A leaf's corner where the wind moves it.
struct Leaf {
    /// Relative to the meadow's origin, world axes.
    position: vec3<f32>,
    /// From -1 to 1 across the leaf.
    uv: vec2<f32>,
}

/// Half the side of a leaf's square in metres.
const LEAF_SIZE: f32 = 0.7;

/// Places a leaf's corner.
fn leaf(vertex: LeafVertex) -> Leaf {
    let place = plants.leaves[vertex.instance];
    let across = vec3<f32>(cos(place.w), 0.0, sin(place.w));
    let along = vec3<f32>(0.6 * across.z, 0.8, -0.6 * across.x);
    let swayed = place.xyz + plants.wind.xyz * sin(plants.wind.w + place.x);
    let corner = across * vertex.corner.x + along * vertex.corner.y;
    return Leaf(swayed + LEAF_SIZE * corner, vertex.corner);
}

/// Whether a leaf has a hole: outside its rim, and where a snail has been.
fn leaf_hole(uv: vec2<f32>) -> bool {
    return length(uv) > 1.0 || length(uv - vec2<f32>(0.35, 0.25)) < 0.4;
}
