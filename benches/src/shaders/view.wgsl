// The view's own passes: depth, normals and colours of what is seen, then light on them.

struct ViewRecord {
    clip_x: vec4<f32>,
    clip_y: vec4<f32>,
    near_metres: vec4<f32>,
    to_light: vec4<f32>,
}

@group(0) @binding(0) var<uniform> view_record: ViewRecord;

struct SeenVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) colour: vec3<f32>,
}

struct SeenSurface {
    @location(0) normal: vec4<f32>,
    @location(1) colour: vec4<f32>,
}

// Rows of an instance lead from object space to camera axes relative to the eye.
@vertex
fn view_vertex(
    @location(0) object: vec3<f32>,
    @location(1) row_x: vec4<f32>,
    @location(2) row_y: vec4<f32>,
    @location(3) row_z: vec4<f32>,
    @location(4) colour: vec4<f32>,
) -> SeenVertex {
    let point = vec4<f32>(object, 1.0);
    let camera = vec3<f32>(dot(row_x, point), dot(row_y, point), dot(row_z, point));
    let clip_x = dot(view_record.clip_x.xyz, camera);
    let clip_y = dot(view_record.clip_y.xyz, camera);
    let clip = vec4<f32>(clip_x, clip_y, view_record.near_metres.x, -camera.z);
    return SeenVertex(clip, camera, colour.rgb);
}

@fragment
fn view_fragment(seen: SeenVertex) -> SeenSurface {
    let normal = normalize(cross(dpdx(seen.position), dpdy(seen.position)));
    let facing = select(normal, -normal, dot(normal, seen.position) > 0.0);
    return SeenSurface(vec4<f32>(facing, 1.0), vec4<f32>(seen.colour, 1.0));
}

@group(0) @binding(1) var seen_normals: texture_2d<f32>;
@group(0) @binding(2) var seen_colours: texture_2d<f32>;
@group(0) @binding(3) var seen_light: texture_2d<f32>;

@vertex
fn shade_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(vec2<u32>((index << 1u) & 2u, index & 2u));
    return vec4<f32>(2.0 * corner - 1.0, 0.0, 1.0);
}

@fragment
fn shade_fragment(@builtin(position) place: vec4<f32>) -> @location(0) vec4<f32> {
    let pixel = vec2<i32>(place.xy);
    let normal = textureLoad(seen_normals, pixel, 0).xyz;
    let colour = textureLoad(seen_colours, pixel, 0).rgb;
    let lit = textureLoad(seen_light, pixel, 0).x * max(dot(normal, view_record.to_light.xyz), 0.0);
    return vec4<f32>(colour * (0.25 + 0.75 * lit), 1.0);
}
