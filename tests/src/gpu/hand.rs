//! A table and plans made by hand: what the service executes knows neither generator nor technique.

use cssm_core::case::{Bias, DepthFormat, Filter, LightCase, MaskDepth, MaskNormal, Resolve};
use cssm_core::choose::{ChoiceReason, ConfigurationChoice};
use cssm_core::facet::{Facet, FacetRows, Selection, Tile};
use cssm_core::fit::Cut;
use cssm_core::glam::{DVec2, DVec3, DVec4};
use cssm_core::light::LightPosition;
use cssm_core::plan::{DepthOrder, MapRegion, PlanBasis};
use cssm_core::remap::Remap;
use cssm_core::schema::{Value, Word};
use cssm_core::table::{CaseTable, Shader, ShaderKind};
use cssm_core::{Light, ShadowPlan, View};

/// Side of the hand-made map in texels.
pub const MAP_SIDE: u32 = 64;

/// One facet, no filter, no bias, both resolve interfaces.
///
/// # Panics
/// When the declaration is refused.
pub fn case(format: DepthFormat) -> LightCase {
    LightCase::builder("Hand")
        .technique(Word::plain("standard"))
        .shadow_distance_metres(100.0)
        .map_size_texels(MAP_SIDE, MAP_SIDE)
        .map_format(format)
        .filter(Filter::None)
        .bias(Bias::None)
        .resolve(&[
            Resolve::Mask { depth: MaskDepth::Linear, normal: MaskNormal::Reconstructed },
            Resolve::Function { group: 1, first_binding: 0 },
        ])
        .prefix("hand")
        .build()
        .expect("the hand-made declaration is valid")
}

/// Its table with shaders written by hand.
pub fn table(format: DepthFormat) -> CaseTable {
    let shader = |kind, wgsl: String| Shader { kind, wgsl: wgsl.into(), spirv: Vec::new().into() };
    CaseTable {
        shaders: vec![
            shader(ShaderKind::Capture, CAPTURE.to_owned() + CAPTURE_UNCLIPPED),
            shader(ShaderKind::CaptureClamped, CAPTURE.to_owned() + CAPTURE_CLAMPED),
            shader(ShaderKind::Mask, VISIBILITY.to_owned() + MASK),
            shader(ShaderKind::Function, VISIBILITY.to_owned()),
        ]
        .into(),
        ..CaseTable::describe(&case(format))
    }
}

/// Four facets in a row, captured by the same shaders; resolved by whatever the engine writes.
///
/// # Panics
/// When the declaration is refused.
pub fn four_facet_table() -> CaseTable {
    let case = LightCase::builder("Hand")
        .technique(Word::with("parallel_split", [("splits", Value::Count(4))]))
        .shadow_distance_metres(100.0)
        .map_size_texels(MAP_SIDE, MAP_SIDE)
        .resolve(&[Resolve::Function { group: 1, first_binding: 0 }])
        .prefix("hand")
        .build()
        .expect("the hand-made declaration is valid");
    CaseTable { shaders: table(DepthFormat::Depth32Float).shaders, ..CaseTable::describe(&case) }
}

/// A plan of one facet that looks straight down: x to the right, z down the map, depth 0 at `top` to 1 at `bottom`
/// metres above the eye, `half` metres to each side.
pub fn plan_from_above(view: &View, half: f64, top: f64, bottom: f64) -> ShadowPlan {
    let tile = Tile { x: 0, y: 0, width: MAP_SIDE, height: MAP_SIDE, gutter: 0 };
    ShadowPlan {
        configuration: "single",
        choice: ConfigurationChoice {
            position: LightPosition::General,
            configuration: "single",
            reason: ChoiceReason::Only,
            predictions: Vec::new(),
            complete: true,
            fallback: None,
            made_for_position: Vec::new(),
        },
        eye_world: view.eye_world,
        camera_from_world: view.camera_from_world,
        shear: DVec2::ZERO,
        pixel_metres: view.pixel_metres(),
        depth_order: DepthOrder::Standard,
        light: DVec4::Y,
        map_size_texels: (MAP_SIDE, MAP_SIDE),
        region: MapRegion { x: 0, y: 0, width: MAP_SIDE, height: MAP_SIDE },
        basis: PlanBasis {
            light: Light::Directional { toward_light_world: DVec3::Y },
            follows_camera: false,
            receivers: Vec::new(),
            cut: Cut::None,
            lit: Vec::new(),
            ground_planes: [None; 4],
            samples: 0,
            p95_pixels: 1.0,
        },
        selection: Selection::single(),
        facets: vec![facet_from_above(tile, half, top, bottom)],
    }
}

/// The facet of such a plan in any tile.
pub fn facet_from_above(tile: Tile, half: f64, top: f64, bottom: f64) -> Facet {
    let per_metre = 1.0 / (top - bottom);
    Facet {
        cells: vec![0],
        rows: FacetRows {
            x: DVec4::new(1.0 / half, 0.0, 0.0, 0.0),
            y: DVec4::new(0.0, 0.0, -1.0 / half, 0.0),
            z: DVec4::new(0.0, -per_metre, 0.0, top * per_metre),
            w: DVec4::W,
            remap: Remap::NONE,
        },
        select: Vec::new(),
        clip: Vec::new(),
        tile,
        receivers: Vec::new(),
        casters: vec![
            DVec4::new(1.0, 0.0, 0.0, half),
            DVec4::new(-1.0, 0.0, 0.0, half),
            DVec4::new(0.0, 0.0, 1.0, half),
            DVec4::new(0.0, 0.0, -1.0, half),
        ],
        depth_per_metre: per_metre,
        texel_metres_per_w: 2.0 * half / f64::from(tile.width),
        receiver_plane_depth: 0.0,
        rounding_depth: 0.0,
    }
}

const CAPTURE: &str = "
struct HandCapture { row_x: vec4<f32>, row_y: vec4<f32>, row_z: vec4<f32>, row_w: vec4<f32> }
@group(0) @binding(0) var<uniform> hand_capture: HandCapture;

fn from_eye(position: vec3<f32>, x: vec4<f32>, y: vec4<f32>, z: vec4<f32>) -> vec4<f32> {
    let object = vec4<f32>(position, 1.0);
    return vec4<f32>(dot(x, object), dot(y, object), dot(z, object), 1.0);
}
";

const CAPTURE_UNCLIPPED: &str = "
@vertex
fn hand_capture_vertex(
    @location(0) position: vec3<f32>,
    @location(1) x: vec4<f32>,
    @location(2) y: vec4<f32>,
    @location(3) z: vec4<f32>,
) -> @builtin(position) vec4<f32> {
    let p = from_eye(position, x, y, z);
    let c = hand_capture;
    return vec4<f32>(dot(c.row_x, p), dot(c.row_y, p), dot(c.row_z, p), dot(c.row_w, p));
}
";

const CAPTURE_CLAMPED: &str = "
struct Varyings { @builtin(position) clip: vec4<f32>, @location(0) zeta: f32, @location(1) w: f32 }

@vertex
fn hand_capture_clamped_vertex(
    @location(0) position: vec3<f32>,
    @location(1) x: vec4<f32>,
    @location(2) y: vec4<f32>,
    @location(3) z: vec4<f32>,
) -> Varyings {
    let p = from_eye(position, x, y, z);
    let w = dot(hand_capture.row_w, p);
    let clip = vec4<f32>(dot(hand_capture.row_x, p), dot(hand_capture.row_y, p), 0.5 * w, w);
    return Varyings(clip, dot(hand_capture.row_z, p), w);
}

@fragment
fn hand_capture_clamped_fragment(in: Varyings) -> @builtin(frag_depth) f32 {
    return clamp(in.zeta / in.w, 0.0, 1.0);
}
";

const VISIBILITY: &str = "
struct HandFacet {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
    texel_from_ndc: vec4<f32>,
    texel_limits: vec4<f32>,
}
struct HandShadow { facets: array<HandFacet, 1> }
@group(1) @binding(0) var<uniform> hand_shadow: HandShadow;
@group(1) @binding(1) var hand_map: texture_depth_2d;

fn hand_visibility(position: vec3<f32>) -> f32 {
    let p = vec4<f32>(position, 1.0);
    let facet = hand_shadow.facets[0];
    let w = dot(facet.row_w, p);
    if w <= 0.0 { return 1.0; }
    let ndc = vec3<f32>(dot(facet.row_x, p), dot(facet.row_y, p), dot(facet.row_z, p)) / w;
    let texel = ndc.xy * facet.texel_from_ndc.xy + facet.texel_from_ndc.zw;
    if any(texel < facet.texel_limits.xy) || any(texel > facet.texel_limits.zw) { return 1.0; }
    return select(0.0, 1.0, clamp(ndc.z, 0.0, 1.0) <= textureLoad(hand_map, vec2<i32>(texel), 0));
}
";

const MASK: &str = "
struct HandMask { ray_corner: vec4<f32>, ray_across: vec4<f32>, ray_down: vec4<f32> }
@group(0) @binding(0) var<uniform> hand_mask: HandMask;
@group(0) @binding(1) var hand_scene_depth: texture_2d<f32>;

@vertex
fn hand_mask_vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(select(-1.0, 3.0, corner == 2u), select(1.0, -3.0, corner == 1u), 0.0, 1.0);
}

@fragment
fn hand_mask_fragment(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
    let depth = textureLoad(hand_scene_depth, vec2<i32>(pixel.xy), 0).x;
    if depth <= 0.0 { return vec4<f32>(1.0, 0.0, 0.0, 1.0); }
    let part = pixel.xy / vec2<f32>(textureDimensions(hand_scene_depth));
    let ray = hand_mask.ray_corner.xyz + hand_mask.ray_across.xyz * part.x + hand_mask.ray_down.xyz * part.y;
    return vec4<f32>(hand_visibility(ray * depth), 0.0, 0.0, 1.0);
}
";
