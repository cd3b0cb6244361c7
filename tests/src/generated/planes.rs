// Generated from light case `Planes`, f580f15ac2a7262b. Do not edit.

/// Both cases of the camera space paper behind one shader: every plan takes four planes or one, whichever promises the
/// smaller footprint, here with the bands that the paper does not have.
///
/// Tables and shaders of light case `Planes`.
#[allow(dead_code, unreachable_pub, clippy::all, clippy::pedantic, clippy::nursery)]
pub mod planes {
    /// The declaration.
    pub fn case() -> ::cssm::core::LightCase {
        use ::cssm::core::case::*;
        use ::cssm::core::schema::*;
        LightCase {
            name: "Planes".into(),
            doc: "Both cases of the camera space paper behind one shader: every plan takes four planes or one, whichever promises the\nsmaller footprint, here with the bands that the paper does not have."
                .into(),
            public: true,
            light: LightKind::Directional,
            far: FarKind::Infinite,
            shadow_distance_metres: Some(1000.0),
            scene_bounds: false,
            technique: Word::plain("camera_space"),
            configurations: Vec::from([
                Word::plain("one_plane"),
                Word::with(
                    "four_plane",
                    [
                        ("push", Value::Word(Word::plain("t"))),
                        ("focus", Value::Number(10.0)),
                    ],
                ),
            ]),
            distribution: Some(
                Word::with(
                    "bands",
                    [("count", Value::Count(8)), ("horizon", Value::Number(100000.0))],
                ),
            ),
            stretch: Stretch::None,
            dominant_plane: None,
            fit: Fit::None,
            stability: Stability::None,
            map: MapSpec {
                width: 2048,
                height: 2048,
                columns: None,
                format: DepthFormat::Depth32Float,
                gutter: None,
            },
            filter: Filter::Gather2x2,
            bias: Bias::ReceiverPlane,
            casters: Casters::Opaque,
            axes: Axes::Camera,
            resolve: Vec::from([
                Resolve::Mask {
                    depth: MaskDepth::ReversedZ,
                    normal: MaskNormal::Reconstructed,
                },
                Resolve::Function {
                    group: 2,
                    first_binding: 0,
                },
            ]),
            prefix: "planes".into(),
        }
    }
    /// Width and height of the map in texels.
    pub const PLANES_MAP_SIZE: [f32; 2] = [2048.0, 2048.0];
    /// Sectors around the eye.
    pub const PLANES_SECTORS: u32 = 4;
    /// Bands of distance in each sector.
    pub const PLANES_BANDS: u32 = 8;
    /// Vectors of four band limits in each sector.
    pub const PLANES_THRESHOLD_VECTORS: u32 = 2;
    /// What resolving needs of one facet; all zero where a plan has none.
    #[derive(
        Clone,
        Copy,
        Debug,
        PartialEq,
        ::cssm::bytemuck::Pod,
        ::cssm::bytemuck::Zeroable
    )]
    #[bytemuck(crate = "::cssm::bytemuck")]
    #[repr(C)]
    pub struct PlanesFacet {
        /// Clip x of the tile, to the right.
        pub row_x: [f32; 4],
        /// Clip y of the tile, upwards.
        pub row_y: [f32; 4],
        /// Clip z: depth along the light times w.
        pub row_z: [f32; 4],
        /// Clip w, positive on receivers.
        pub row_w: [f32; 4],
        /// Map texel coordinates = clip space after division * xy + zw.
        pub texel_from_ndc: [f32; 4],
        /// Smallest (xy) and largest (zw) map texel coordinates of the facet's receivers.
        pub texel_limits: [f32; 4],
        /// Depth by which an exact receiver plane is lowered.
        pub receiver_plane_depth: f32,
        /// Unused; keeps the offsets of the shader.
        pub padding_0: [f32; 3],
    }
    const _: () = {
        let size_bytes = ::core::mem::size_of::<PlanesFacet>();
        assert!(size_bytes == 112);
        assert!(::core::mem::offset_of!(PlanesFacet, row_x) == 0);
        assert!(::core::mem::offset_of!(PlanesFacet, row_y) == 16);
        assert!(::core::mem::offset_of!(PlanesFacet, row_z) == 32);
        assert!(::core::mem::offset_of!(PlanesFacet, row_w) == 48);
        assert!(::core::mem::offset_of!(PlanesFacet, texel_from_ndc) == 64);
        assert!(::core::mem::offset_of!(PlanesFacet, texel_limits) == 80);
        assert!(::core::mem::offset_of!(PlanesFacet, receiver_plane_depth) == 96);
    };
    /// What resolving needs of a plan.
    #[derive(
        Clone,
        Copy,
        Debug,
        PartialEq,
        ::cssm::bytemuck::Pod,
        ::cssm::bytemuck::Zeroable
    )]
    #[bytemuck(crate = "::cssm::bytemuck")]
    #[repr(C)]
    pub struct PlanesShadow {
        /// Border rows of the sectors, in walking order; the first closes the ring.
        pub borders: [[f32; 4]; 4],
        /// Distance row of each sector.
        pub distances: [[f32; 4]; 4],
        /// Ascending band limits of each sector, four to a vector; unused ones are out of reach.
        pub thresholds: [[f32; 4]; 8],
        /// What x and y gain per z by the shear along the light: twelve leading bits, then the rest.
        pub shear: [f32; 4],
        /// 1 where stored depth grows away from the light, -1 where it falls.
        pub depth_sign: f32,
        /// Unused; keeps the offsets of the shader.
        pub padding_0: [f32; 3],
        /// The facets: cell = (half * sectors + sector) * bands + band.
        pub facets: [PlanesFacet; 32],
    }
    const _: () = {
        let size_bytes = ::core::mem::size_of::<PlanesShadow>();
        assert!(size_bytes == 3872);
        assert!(::core::mem::offset_of!(PlanesShadow, borders) == 0);
        assert!(::core::mem::offset_of!(PlanesShadow, distances) == 64);
        assert!(::core::mem::offset_of!(PlanesShadow, thresholds) == 128);
        assert!(::core::mem::offset_of!(PlanesShadow, shear) == 256);
        assert!(::core::mem::offset_of!(PlanesShadow, depth_sign) == 272);
        assert!(::core::mem::offset_of!(PlanesShadow, facets) == 288);
    };
    /// What capturing needs of one facet, in the capture's axes: its matrix, row by row.
    #[derive(
        Clone,
        Copy,
        Debug,
        PartialEq,
        ::cssm::bytemuck::Pod,
        ::cssm::bytemuck::Zeroable
    )]
    #[bytemuck(crate = "::cssm::bytemuck")]
    #[repr(C)]
    pub struct PlanesCapture {
        /// Clip x of the tile, to the right.
        pub row_x: [f32; 4],
        /// Clip y of the tile, upwards.
        pub row_y: [f32; 4],
        /// Clip z: depth along the light times w.
        pub row_z: [f32; 4],
        /// Clip w, positive on receivers.
        pub row_w: [f32; 4],
        /// Half-spaces that casters are cut with.
        pub clips: [[f32; 4]; 2],
    }
    const _: () = {
        let size_bytes = ::core::mem::size_of::<PlanesCapture>();
        assert!(size_bytes == 96);
        assert!(::core::mem::offset_of!(PlanesCapture, row_x) == 0);
        assert!(::core::mem::offset_of!(PlanesCapture, row_y) == 16);
        assert!(::core::mem::offset_of!(PlanesCapture, row_z) == 32);
        assert!(::core::mem::offset_of!(PlanesCapture, row_w) == 48);
        assert!(::core::mem::offset_of!(PlanesCapture, clips) == 64);
    };
    /// What the mask pass needs of the view.
    #[derive(
        Clone,
        Copy,
        Debug,
        PartialEq,
        ::cssm::bytemuck::Pod,
        ::cssm::bytemuck::Zeroable
    )]
    #[bytemuck(crate = "::cssm::bytemuck")]
    #[repr(C)]
    pub struct PlanesMask {
        /// Direction through the image's upper left corner, depth 1, in the case's axes.
        pub ray_corner: [f32; 4],
        /// Change of that direction across the whole image.
        pub ray_across: [f32; 4],
        /// Change of that direction down the whole image.
        pub ray_down: [f32; 4],
        /// One over the depth in metres = stored depth * x + y.
        pub inverse_depth: [f32; 2],
        /// Unused; keeps the offsets of the shader.
        pub padding_0: [f32; 2],
    }
    const _: () = {
        let size_bytes = ::core::mem::size_of::<PlanesMask>();
        assert!(size_bytes == 64);
        assert!(::core::mem::offset_of!(PlanesMask, ray_corner) == 0);
        assert!(::core::mem::offset_of!(PlanesMask, ray_across) == 16);
        assert!(::core::mem::offset_of!(PlanesMask, ray_down) == 32);
        assert!(::core::mem::offset_of!(PlanesMask, inverse_depth) == 48);
    };
    /// Everything that the CPU and the GPU agree on.
    pub static TABLE: ::cssm::core::table::CaseTable = tables::TABLE;
    mod tables {
        use ::std::borrow::Cow;
        use ::cssm::core::case::{Axes, DepthFormat, Stretch};
        use ::cssm::core::distribution::RemapKind;
        use ::cssm::core::table::*;
        pub(super) const TABLE: CaseTable = CaseTable {
            case: Cow::Borrowed("Planes"),
            prefix: Cow::Borrowed("planes"),
            fingerprint: 0xf580f15ac2a7262b,
            map_width: 2048,
            map_height: 2048,
            map_format: DepthFormat::Depth32Float,
            halves: 1,
            sectors: 4,
            bands: 8,
            clips: 2,
            dominant: false,
            scales_thresholds: false,
            local_light: false,
            remap: RemapKind::None,
            stretch: Stretch::None,
            may_reverse_depth: true,
            axes: Axes::Camera,
            shears: true,
            fetches_per_pixel: 1,
            constants: Cow::Borrowed(CONSTANTS),
            records: Cow::Borrowed(RECORDS),
            groups: Cow::Borrowed(GROUPS),
            passes: Cow::Borrowed(PASSES),
            reduction: None,
            shaders: Cow::Borrowed(SHADERS),
        };
        const CONSTANTS: &[Constant] = &[
            Constant {
                kind: ConstantKind::MapSize,
                name: Cow::Borrowed("PLANES_MAP_SIZE"),
                value: ConstantValue::Vec2([2048.0, 2048.0]),
            },
            Constant {
                kind: ConstantKind::Sectors,
                name: Cow::Borrowed("PLANES_SECTORS"),
                value: ConstantValue::U32(4),
            },
            Constant {
                kind: ConstantKind::Bands,
                name: Cow::Borrowed("PLANES_BANDS"),
                value: ConstantValue::U32(8),
            },
            Constant {
                kind: ConstantKind::ThresholdVectors,
                name: Cow::Borrowed("PLANES_THRESHOLD_VECTORS"),
                value: ConstantValue::U32(2),
            },
        ];
        const RECORDS: &[Record] = &[
            Record {
                kind: RecordKind::Facet,
                name: Cow::Borrowed("PlanesFacet"),
                size_bytes: 112,
                fields: Cow::Borrowed(FACET_FIELDS),
            },
            Record {
                kind: RecordKind::Shadow,
                name: Cow::Borrowed("PlanesShadow"),
                size_bytes: 3872,
                fields: Cow::Borrowed(SHADOW_FIELDS),
            },
            Record {
                kind: RecordKind::Capture,
                name: Cow::Borrowed("PlanesCapture"),
                size_bytes: 96,
                fields: Cow::Borrowed(CAPTURE_FIELDS),
            },
            Record {
                kind: RecordKind::Mask,
                name: Cow::Borrowed("PlanesMask"),
                size_bytes: 64,
                fields: Cow::Borrowed(MASK_FIELDS),
            },
        ];
        const FACET_FIELDS: &[RecordField] = &[
            RecordField {
                name: Cow::Borrowed("row_x"),
                meaning: Meaning::RowX,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 0,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("row_y"),
                meaning: Meaning::RowY,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 16,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("row_z"),
                meaning: Meaning::RowZ,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 32,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("row_w"),
                meaning: Meaning::RowW,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 48,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("texel_from_ndc"),
                meaning: Meaning::TexelFromNdc,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 64,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("texel_limits"),
                meaning: Meaning::TexelLimits,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 80,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("receiver_plane_depth"),
                meaning: Meaning::ReceiverPlaneDepth,
                ty: FieldType::F32,
                elements: 0,
                offset_bytes: 96,
                stride_bytes: 0,
            },
        ];
        const SHADOW_FIELDS: &[RecordField] = &[
            RecordField {
                name: Cow::Borrowed("borders"),
                meaning: Meaning::Borders,
                ty: FieldType::Vec4,
                elements: 4,
                offset_bytes: 0,
                stride_bytes: 16,
            },
            RecordField {
                name: Cow::Borrowed("distances"),
                meaning: Meaning::Distances,
                ty: FieldType::Vec4,
                elements: 4,
                offset_bytes: 64,
                stride_bytes: 16,
            },
            RecordField {
                name: Cow::Borrowed("thresholds"),
                meaning: Meaning::Thresholds,
                ty: FieldType::Vec4,
                elements: 8,
                offset_bytes: 128,
                stride_bytes: 16,
            },
            RecordField {
                name: Cow::Borrowed("shear"),
                meaning: Meaning::Shear,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 256,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("depth_sign"),
                meaning: Meaning::DepthSign,
                ty: FieldType::F32,
                elements: 0,
                offset_bytes: 272,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("facets"),
                meaning: Meaning::Facets,
                ty: FieldType::Facet,
                elements: 32,
                offset_bytes: 288,
                stride_bytes: 112,
            },
        ];
        const CAPTURE_FIELDS: &[RecordField] = &[
            RecordField {
                name: Cow::Borrowed("row_x"),
                meaning: Meaning::RowX,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 0,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("row_y"),
                meaning: Meaning::RowY,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 16,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("row_z"),
                meaning: Meaning::RowZ,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 32,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("row_w"),
                meaning: Meaning::RowW,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 48,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("clips"),
                meaning: Meaning::Clips,
                ty: FieldType::Vec4,
                elements: 2,
                offset_bytes: 64,
                stride_bytes: 16,
            },
        ];
        const MASK_FIELDS: &[RecordField] = &[
            RecordField {
                name: Cow::Borrowed("ray_corner"),
                meaning: Meaning::RayCorner,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 0,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("ray_across"),
                meaning: Meaning::RayAcross,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 16,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("ray_down"),
                meaning: Meaning::RayDown,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 32,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("inverse_depth"),
                meaning: Meaning::InverseDepth,
                ty: FieldType::Vec2,
                elements: 0,
                offset_bytes: 48,
                stride_bytes: 0,
            },
        ];
        const GROUPS: &[BindGroup] = &[
            BindGroup {
                shader: ShaderKind::Capture,
                content: GroupContent::CaptureFacet,
                group: 0,
                bindings: Cow::Borrowed(CAPTURE_GROUP_0),
            },
            BindGroup {
                shader: ShaderKind::CaptureClamped,
                content: GroupContent::CaptureFacet,
                group: 0,
                bindings: Cow::Borrowed(CAPTURE_CLAMPED_GROUP_0),
            },
            BindGroup {
                shader: ShaderKind::Mask,
                content: GroupContent::MaskInput,
                group: 0,
                bindings: Cow::Borrowed(MASK_GROUP_0),
            },
            BindGroup {
                shader: ShaderKind::Mask,
                content: GroupContent::Shadow,
                group: 1,
                bindings: Cow::Borrowed(MASK_GROUP_1),
            },
            BindGroup {
                shader: ShaderKind::Function,
                content: GroupContent::Shadow,
                group: 2,
                bindings: Cow::Borrowed(FUNCTION_GROUP_2),
            },
        ];
        const CAPTURE_GROUP_0: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("planes_capture"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Capture,
                    dynamic_offset: true,
                },
            },
        ];
        const CAPTURE_CLAMPED_GROUP_0: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("planes_capture"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Capture,
                    dynamic_offset: true,
                },
            },
        ];
        const MASK_GROUP_0: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("planes_mask"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Mask,
                    dynamic_offset: false,
                },
            },
            Binding {
                binding: 1,
                name: Cow::Borrowed("planes_scene_depth"),
                kind: BindingKind::SceneDepth,
            },
        ];
        const MASK_GROUP_1: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("planes_shadow"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Shadow,
                    dynamic_offset: false,
                },
            },
            Binding {
                binding: 1,
                name: Cow::Borrowed("planes_map"),
                kind: BindingKind::Map,
            },
            Binding {
                binding: 2,
                name: Cow::Borrowed("planes_map_sampler"),
                kind: BindingKind::GatherSampler,
            },
        ];
        const FUNCTION_GROUP_2: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("planes_shadow"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Shadow,
                    dynamic_offset: false,
                },
            },
            Binding {
                binding: 1,
                name: Cow::Borrowed("planes_map"),
                kind: BindingKind::Map,
            },
            Binding {
                binding: 2,
                name: Cow::Borrowed("planes_map_sampler"),
                kind: BindingKind::GatherSampler,
            },
        ];
        const PASSES: &[Pass] = &[
            Pass {
                shader: ShaderKind::Capture,
                vertex: Cow::Borrowed("planes_capture_vertex"),
                fragment: None,
                reads: Cow::Borrowed(&[Resource::Casters]),
                writes: Cow::Borrowed(&[Resource::Map]),
            },
            Pass {
                shader: ShaderKind::CaptureClamped,
                vertex: Cow::Borrowed("planes_capture_clamped_vertex"),
                fragment: Some(Cow::Borrowed("planes_capture_clamped_fragment")),
                reads: Cow::Borrowed(&[Resource::Casters]),
                writes: Cow::Borrowed(&[Resource::Map]),
            },
            Pass {
                shader: ShaderKind::Mask,
                vertex: Cow::Borrowed("planes_mask_vertex"),
                fragment: Some(Cow::Borrowed("planes_mask_fragment")),
                reads: Cow::Borrowed(&[Resource::Map, Resource::SceneDepth]),
                writes: Cow::Borrowed(&[Resource::Mask]),
            },
        ];
        const SHADERS: &[Shader] = &[
            Shader {
                kind: ShaderKind::Capture,
                wgsl: Cow::Borrowed(super::CAPTURE_WGSL),
                spirv: Cow::Borrowed(super::CAPTURE_SPIRV),
            },
            Shader {
                kind: ShaderKind::CaptureClamped,
                wgsl: Cow::Borrowed(super::CAPTURE_CLAMPED_WGSL),
                spirv: Cow::Borrowed(super::CAPTURE_CLAMPED_SPIRV),
            },
            Shader {
                kind: ShaderKind::Mask,
                wgsl: Cow::Borrowed(super::MASK_WGSL),
                spirv: Cow::Borrowed(super::MASK_SPIRV),
            },
            Shader {
                kind: ShaderKind::Function,
                wgsl: Cow::Borrowed(super::FUNCTION_WGSL),
                spirv: Cow::Borrowed(&[]),
            },
        ];
    }
    /// WGSL of the capture shader.
    pub const CAPTURE_WGSL: &str = r#"// Planes: renders casters into one facet of the shadow map; needs unclipped depth and clip distances.
// Positions are relative to the eye, in the capture's axes: the camera's (x right, y up, looking along -z), sheared as the plan says.
// Both cases of the camera space paper behind one shader: every plan takes four planes or one, whichever promises the
// smaller footprint, here with the bands that the paper does not have.
// Generated from light case `Planes`, f580f15ac2a7262b. Do not edit.

enable clip_distances;

/// What capturing needs of one facet, in the capture's axes: its matrix, row by row.
struct PlanesCapture {
    /// Clip x of the tile, to the right.
    row_x: vec4<f32>,
    /// Clip y of the tile, upwards.
    row_y: vec4<f32>,
    /// Clip z: depth along the light times w.
    row_z: vec4<f32>,
    /// Clip w, positive on receivers.
    row_w: vec4<f32>,
    /// Half-spaces that casters are cut with.
    clips: array<vec4<f32>, 2>,
}

/// The facet that is captured.
@group(0) @binding(0)
var<uniform> planes_capture: PlanesCapture;

/// A vertex of a caster.
struct PlanesCasterVertex {
    /// Position in the object's own space.
    @location(0) position: vec3<f32>,
    /// First of the instance's rows; they take the object's space to the capture's axes, relative to the eye.
    @location(1) eye_from_object_x: vec4<f32>,
    /// Second row.
    @location(2) eye_from_object_y: vec4<f32>,
    /// Third row.
    @location(3) eye_from_object_z: vec4<f32>,
}

/// Moves a vertex from its object to the eye, into the capture's axes: no coordinate is large that the view or the
/// light shows small.
fn planes_capture_position(vertex: PlanesCasterVertex) -> vec4<f32> {
    let object = vec4<f32>(vertex.position, 1.0);
    return vec4<f32>(
        dot(vertex.eye_from_object_x, object),
        dot(vertex.eye_from_object_y, object),
        dot(vertex.eye_from_object_z, object),
        1.0,
    );
}

/// Applies the facet's matrix, row by row, to a position in the capture's axes.
fn planes_tile_position(position: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(
        dot(planes_capture.row_x, position),
        dot(planes_capture.row_y, position),
        dot(planes_capture.row_z, position),
        dot(planes_capture.row_w, position),
    );
}

/// Distances of a position in the capture's axes from the facet's half-spaces; negative outside.
fn planes_clip_values(position: vec4<f32>) -> vec2<f32> {
    return vec2<f32>(dot(planes_capture.clips[0], position), dot(planes_capture.clips[1], position));
}

/// A caster's vertex in the tile.
struct PlanesClippedCaster {
    /// Position in the tile.
    @builtin(position) tile: vec4<f32>,
    /// Distances from the facet's half-spaces; the pipeline cuts where one is negative.
    @builtin(clip_distances) clips: array<f32, 2>,
}

/// Places a caster's vertex in the tile and measures the facet's half-spaces there.
@vertex
fn planes_capture_vertex(vertex: PlanesCasterVertex) -> PlanesClippedCaster {
    let position = planes_capture_position(vertex);
    let clips = planes_clip_values(position);
    return PlanesClippedCaster(planes_tile_position(position), array<f32, 2>(clips.x, clips.y));
}
"#;
    /// SPIR-V of the capture shader, little-endian words.
    pub const CAPTURE_SPIRV: &[u8] = b"\x03\x02#\x07\0\x03\x01\0\x1C\0\0\0d\0\0\0\0\0\0\0\x11\0\x02\0\x01\0\0\0\x11\0\x02\0 \0\0\0\x0B\0\x06\0\x01\0\0\0GLSL.std.450\0\0\0\0\x0E\0\x03\0\0\0\0\0\x01\0\0\0\x0F\0\x0F\0\0\0\0\0W\0\0\0planes_capture_vertex\0\0\0I\0\0\0L\0\0\0O\0\0\0Q\0\0\0S\0\0\0U\0\0\0G\0\x04\0\x05\0\0\0\x06\0\0\0\x10\0\0\0H\0\x05\0\x08\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x08\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x08\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\x08\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\x08\0\0\0\x04\0\0\0#\0\0\0@\0\0\0H\0\x05\0\n\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\n\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\n\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\n\0\0\0\x03\0\0\0#\0\0\x000\0\0\0G\0\x04\0\x0C\0\0\0\x06\0\0\0\x04\0\0\0H\0\x05\0\r\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\r\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0G\0\x04\0\x0E\0\0\0\"\0\0\0\0\0\0\0G\0\x04\0\x0E\0\0\0!\0\0\0\0\0\0\0G\0\x03\0\x0F\0\0\0\x02\0\0\0H\0\x05\0\x0F\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0I\0\0\0\x1E\0\0\0\0\0\0\0G\0\x04\0L\0\0\0\x1E\0\0\0\x01\0\0\0G\0\x04\0O\0\0\0\x1E\0\0\0\x02\0\0\0G\0\x04\0Q\0\0\0\x1E\0\0\0\x03\0\0\0G\0\x04\0S\0\0\0\x0B\0\0\0\0\0\0\0G\0\x04\0U\0\0\0\x0B\0\0\0\x03\0\0\0\x13\0\x02\0\x02\0\0\0\x16\0\x03\0\x03\0\0\0 \0\0\0\x17\0\x04\0\x04\0\0\0\x03\0\0\0\x04\0\0\0\x15\0\x04\0\x07\0\0\0 \0\0\0\0\0\0\0+\0\x04\0\x07\0\0\0\x06\0\0\0\x02\0\0\0\x1C\0\x04\0\x05\0\0\0\x04\0\0\0\x06\0\0\0\x1E\0\x07\0\x08\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x05\0\0\0\x17\0\x04\0\t\0\0\0\x03\0\0\0\x03\0\0\0\x1E\0\x06\0\n\0\0\0\t\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x17\0\x04\0\x0B\0\0\0\x03\0\0\0\x02\0\0\0\x1C\0\x04\0\x0C\0\0\0\x03\0\0\0\x06\0\0\0\x1E\0\x04\0\r\0\0\0\x04\0\0\0\x0C\0\0\0\x1E\0\x03\0\x0F\0\0\0\x08\0\0\0 \0\x04\0\x10\0\0\0\x02\0\0\0\x0F\0\0\0;\0\x04\0\x10\0\0\0\x0E\0\0\0\x02\0\0\0!\0\x04\0\x14\0\0\0\x04\0\0\0\n\0\0\0+\0\x04\0\x03\0\0\0\x15\0\0\0\0\0\x80?!\0\x04\0#\0\0\0\x04\0\0\0\x04\0\0\0 \0\x04\0$\0\0\0\x02\0\0\0\x08\0\0\0+\0\x04\0\x07\0\0\0%\0\0\0\0\0\0\0 \0\x04\0(\0\0\0\x02\0\0\0\x04\0\0\0+\0\x04\0\x07\0\0\0,\0\0\0\x01\0\0\0+\0\x04\0\x07\0\0\x003\0\0\0\x03\0\0\0!\0\x04\0;\0\0\0\x0B\0\0\0\x04\0\0\0 \0\x04\0>\0\0\0\x02\0\0\0\x05\0\0\0+\0\x04\0\x07\0\0\0?\0\0\0\x04\0\0\0 \0\x04\0J\0\0\0\x01\0\0\0\t\0\0\0;\0\x04\0J\0\0\0I\0\0\0\x01\0\0\0 \0\x04\0M\0\0\0\x01\0\0\0\x04\0\0\0;\0\x04\0M\0\0\0L\0\0\0\x01\0\0\0;\0\x04\0M\0\0\0O\0\0\0\x01\0\0\0;\0\x04\0M\0\0\0Q\0\0\0\x01\0\0\0 \0\x04\0T\0\0\0\x03\0\0\0\x04\0\0\0;\0\x04\0T\0\0\0S\0\0\0\x03\0\0\0 \0\x04\0V\0\0\0\x03\0\0\0\x0C\0\0\0;\0\x04\0V\0\0\0U\0\0\0\x03\0\0\0!\0\x03\0X\0\0\0\x02\0\0\x006\0\x05\0\x04\0\0\0\x13\0\0\0\0\0\0\0\x14\0\0\x007\0\x03\0\n\0\0\0\x12\0\0\0\xF8\0\x02\0\x11\0\0\0\xF9\0\x02\0\x16\0\0\0\xF8\0\x02\0\x16\0\0\0Q\0\x05\0\t\0\0\0\x17\0\0\0\x12\0\0\0\0\0\0\0P\0\x05\0\x04\0\0\0\x18\0\0\0\x17\0\0\0\x15\0\0\0Q\0\x05\0\x04\0\0\0\x19\0\0\0\x12\0\0\0\x01\0\0\0\x94\0\x05\0\x03\0\0\0\x1A\0\0\0\x19\0\0\0\x18\0\0\0Q\0\x05\0\x04\0\0\0\x1B\0\0\0\x12\0\0\0\x02\0\0\0\x94\0\x05\0\x03\0\0\0\x1C\0\0\0\x1B\0\0\0\x18\0\0\0Q\0\x05\0\x04\0\0\0\x1D\0\0\0\x12\0\0\0\x03\0\0\0\x94\0\x05\0\x03\0\0\0\x1E\0\0\0\x1D\0\0\0\x18\0\0\0P\0\x07\0\x04\0\0\0\x1F\0\0\0\x1A\0\0\0\x1C\0\0\0\x1E\0\0\0\x15\0\0\0\xFE\0\x02\0\x1F\0\0\08\0\x01\x006\0\x05\0\x04\0\0\0\"\0\0\0\0\0\0\0#\0\0\x007\0\x03\0\x04\0\0\0!\0\0\0\xF8\0\x02\0 \0\0\0A\0\x05\0$\0\0\0&\0\0\0\x0E\0\0\0%\0\0\0\xF9\0\x02\0'\0\0\0\xF8\0\x02\0'\0\0\0A\0\x05\0(\0\0\0)\0\0\0&\0\0\0%\0\0\0=\0\x04\0\x04\0\0\0*\0\0\0)\0\0\0\x94\0\x05\0\x03\0\0\0+\0\0\0*\0\0\0!\0\0\0A\0\x05\0(\0\0\0-\0\0\0&\0\0\0,\0\0\0=\0\x04\0\x04\0\0\0.\0\0\0-\0\0\0\x94\0\x05\0\x03\0\0\0/\0\0\0.\0\0\0!\0\0\0A\0\x05\0(\0\0\x000\0\0\0&\0\0\0\x06\0\0\0=\0\x04\0\x04\0\0\x001\0\0\x000\0\0\0\x94\0\x05\0\x03\0\0\x002\0\0\x001\0\0\0!\0\0\0A\0\x05\0(\0\0\x004\0\0\0&\0\0\x003\0\0\0=\0\x04\0\x04\0\0\x005\0\0\x004\0\0\0\x94\0\x05\0\x03\0\0\x006\0\0\x005\0\0\0!\0\0\0P\0\x07\0\x04\0\0\x007\0\0\0+\0\0\0/\0\0\x002\0\0\x006\0\0\0\xFE\0\x02\x007\0\0\08\0\x01\x006\0\x05\0\x0B\0\0\0:\0\0\0\0\0\0\0;\0\0\x007\0\x03\0\x04\0\0\09\0\0\0\xF8\0\x02\08\0\0\0A\0\x05\0$\0\0\0<\0\0\0\x0E\0\0\0%\0\0\0\xF9\0\x02\0=\0\0\0\xF8\0\x02\0=\0\0\0A\0\x06\0(\0\0\0@\0\0\0<\0\0\0?\0\0\0%\0\0\0=\0\x04\0\x04\0\0\0A\0\0\0@\0\0\0\x94\0\x05\0\x03\0\0\0B\0\0\0A\0\0\09\0\0\0A\0\x06\0(\0\0\0C\0\0\0<\0\0\0?\0\0\0,\0\0\0=\0\x04\0\x04\0\0\0D\0\0\0C\0\0\0\x94\0\x05\0\x03\0\0\0E\0\0\0D\0\0\09\0\0\0P\0\x05\0\x0B\0\0\0F\0\0\0B\0\0\0E\0\0\0\xFE\0\x02\0F\0\0\08\0\x01\x006\0\x05\0\x02\0\0\0W\0\0\0\0\0\0\0X\0\0\0\xF8\0\x02\0G\0\0\0=\0\x04\0\t\0\0\0K\0\0\0I\0\0\0=\0\x04\0\x04\0\0\0N\0\0\0L\0\0\0=\0\x04\0\x04\0\0\0P\0\0\0O\0\0\0=\0\x04\0\x04\0\0\0R\0\0\0Q\0\0\0P\0\x07\0\n\0\0\0H\0\0\0K\0\0\0N\0\0\0P\0\0\0R\0\0\0A\0\x05\0$\0\0\0Y\0\0\0\x0E\0\0\0%\0\0\0\xF9\0\x02\0Z\0\0\0\xF8\0\x02\0Z\0\0\09\0\x05\0\x04\0\0\0[\0\0\0\x13\0\0\0H\0\0\09\0\x05\0\x0B\0\0\0\\\0\0\0:\0\0\0[\0\0\09\0\x05\0\x04\0\0\0]\0\0\0\"\0\0\0[\0\0\0Q\0\x05\0\x03\0\0\0^\0\0\0\\\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0_\0\0\0\\\0\0\0\x01\0\0\0P\0\x05\0\x0C\0\0\0`\0\0\0^\0\0\0_\0\0\0P\0\x05\0\r\0\0\0a\0\0\0]\0\0\0`\0\0\0Q\0\x05\0\x04\0\0\0b\0\0\0a\0\0\0\0\0\0\0>\0\x03\0S\0\0\0b\0\0\0Q\0\x05\0\x0C\0\0\0c\0\0\0a\0\0\0\x01\0\0\0>\0\x03\0U\0\0\0c\0\0\0\xFD\0\x01\08\0\x01\0";
    /// WGSL of the capture_clamped shader.
    pub const CAPTURE_CLAMPED_WGSL: &str = r#"// Planes: renders casters into one facet of the shadow map; clamps depth and cuts by itself.
// Positions are relative to the eye, in the capture's axes: the camera's (x right, y up, looking along -z), sheared as the plan says.
// Both cases of the camera space paper behind one shader: every plan takes four planes or one, whichever promises the
// smaller footprint, here with the bands that the paper does not have.
// Generated from light case `Planes`, f580f15ac2a7262b. Do not edit.

/// What capturing needs of one facet, in the capture's axes: its matrix, row by row.
struct PlanesCapture {
    /// Clip x of the tile, to the right.
    row_x: vec4<f32>,
    /// Clip y of the tile, upwards.
    row_y: vec4<f32>,
    /// Clip z: depth along the light times w.
    row_z: vec4<f32>,
    /// Clip w, positive on receivers.
    row_w: vec4<f32>,
    /// Half-spaces that casters are cut with.
    clips: array<vec4<f32>, 2>,
}

/// The facet that is captured.
@group(0) @binding(0)
var<uniform> planes_capture: PlanesCapture;

/// A vertex of a caster.
struct PlanesCasterVertex {
    /// Position in the object's own space.
    @location(0) position: vec3<f32>,
    /// First of the instance's rows; they take the object's space to the capture's axes, relative to the eye.
    @location(1) eye_from_object_x: vec4<f32>,
    /// Second row.
    @location(2) eye_from_object_y: vec4<f32>,
    /// Third row.
    @location(3) eye_from_object_z: vec4<f32>,
}

/// Moves a vertex from its object to the eye, into the capture's axes: no coordinate is large that the view or the
/// light shows small.
fn planes_capture_position(vertex: PlanesCasterVertex) -> vec4<f32> {
    let object = vec4<f32>(vertex.position, 1.0);
    return vec4<f32>(
        dot(vertex.eye_from_object_x, object),
        dot(vertex.eye_from_object_y, object),
        dot(vertex.eye_from_object_z, object),
        1.0,
    );
}

/// Applies the facet's matrix, row by row, to a position in the capture's axes.
fn planes_tile_position(position: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(
        dot(planes_capture.row_x, position),
        dot(planes_capture.row_y, position),
        dot(planes_capture.row_z, position),
        dot(planes_capture.row_w, position),
    );
}

/// Distances of a position in the capture's axes from the facet's half-spaces; negative outside.
fn planes_clip_values(position: vec4<f32>) -> vec2<f32> {
    return vec2<f32>(dot(planes_capture.clips[0], position), dot(planes_capture.clips[1], position));
}

/// Whether a fragment lies outside one of the facet's half-spaces.
fn planes_is_cut(clips: vec2<f32>) -> bool {
    return any(clips < vec2<f32>(0.0));
}

/// A position of the tile at a depth that no clip plane meets: half way between the clipper's limits.
fn planes_hidden_depth(tile: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(tile.xy, 0.5 * tile.w, tile.w);
}

/// The depth that an unclipped capture would store, from the facet's clip z and w.
fn planes_clamped_depth(depth_times_w: f32, w: f32) -> f32 {
    return clamp(depth_times_w / w, 0.0, 1.0);
}

/// What the vertex stage of the clamped capture hands to its fragment stage.
struct PlanesClampedCaster {
    /// Position in the tile, at a depth that no clip plane meets.
    @builtin(position) tile: vec4<f32>,
    /// Clip z of the facet: depth times w.
    @location(0) depth_times_w: f32,
    /// Clip w of the facet.
    @location(1) w: f32,
    /// Distances from the facet's half-spaces.
    @location(2) clips: vec2<f32>,
}

/// Places a caster's vertex in the tile, but keeps its depth and the cuts for the fragment stage.
@vertex
fn planes_capture_clamped_vertex(vertex: PlanesCasterVertex) -> PlanesClampedCaster {
    let position = planes_capture_position(vertex);
    let tile = planes_tile_position(position);
    return PlanesClampedCaster(planes_hidden_depth(tile), tile.z, tile.w, planes_clip_values(position));
}

/// Cuts the caster and writes the depth that an unclipped capture would store.
@fragment
fn planes_capture_clamped_fragment(caster: PlanesClampedCaster) -> @builtin(frag_depth) f32 {
    if planes_is_cut(caster.clips) {
        discard;
    }
    return planes_clamped_depth(caster.depth_times_w, caster.w);
}
"#;
    /// SPIR-V of the capture_clamped shader, little-endian words.
    pub const CAPTURE_CLAMPED_SPIRV: &[u8] = b"\x03\x02#\x07\0\x03\x01\0\x1C\0\0\0\x9B\0\0\0\0\0\0\0\x11\0\x02\0\x01\0\0\0\x0B\0\x06\0\x01\0\0\0GLSL.std.450\0\0\0\0\x0E\0\x03\0\0\0\0\0\x01\0\0\0\x0F\0\x13\0\0\0\0\0v\0\0\0planes_capture_clamped_vertex\0\0\0e\0\0\0h\0\0\0k\0\0\0m\0\0\0o\0\0\0q\0\0\0s\0\0\0t\0\0\0\x0F\0\x10\0\x04\0\0\0\x92\0\0\0planes_capture_clamped_fragment\0\x87\0\0\0\x89\0\0\0\x8C\0\0\0\x8E\0\0\0\x91\0\0\0\x10\0\x03\0\x92\0\0\0\x07\0\0\0\x10\0\x03\0\x92\0\0\0\x0C\0\0\0G\0\x04\0\x05\0\0\0\x06\0\0\0\x10\0\0\0H\0\x05\0\x08\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x08\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x08\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\x08\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\x08\0\0\0\x04\0\0\0#\0\0\0@\0\0\0H\0\x05\0\n\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\n\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\n\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\n\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\r\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\r\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\r\0\0\0\x02\0\0\0#\0\0\0\x14\0\0\0H\0\x05\0\r\0\0\0\x03\0\0\0#\0\0\0\x18\0\0\0G\0\x04\0\x0E\0\0\0\"\0\0\0\0\0\0\0G\0\x04\0\x0E\0\0\0!\0\0\0\0\0\0\0G\0\x03\0\x0F\0\0\0\x02\0\0\0H\0\x05\0\x0F\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0e\0\0\0\x1E\0\0\0\0\0\0\0G\0\x04\0h\0\0\0\x1E\0\0\0\x01\0\0\0G\0\x04\0k\0\0\0\x1E\0\0\0\x02\0\0\0G\0\x04\0m\0\0\0\x1E\0\0\0\x03\0\0\0G\0\x04\0o\0\0\0\x0B\0\0\0\0\0\0\0G\0\x04\0q\0\0\0\x1E\0\0\0\0\0\0\0G\0\x04\0s\0\0\0\x1E\0\0\0\x01\0\0\0G\0\x04\0t\0\0\0\x1E\0\0\0\x02\0\0\0G\0\x04\0\x87\0\0\0\x0B\0\0\0\x0F\0\0\0G\0\x04\0\x89\0\0\0\x1E\0\0\0\0\0\0\0G\0\x04\0\x8C\0\0\0\x1E\0\0\0\x01\0\0\0G\0\x04\0\x8E\0\0\0\x1E\0\0\0\x02\0\0\0G\0\x04\0\x91\0\0\0\x0B\0\0\0\x16\0\0\0\x13\0\x02\0\x02\0\0\0\x16\0\x03\0\x03\0\0\0 \0\0\0\x17\0\x04\0\x04\0\0\0\x03\0\0\0\x04\0\0\0\x15\0\x04\0\x07\0\0\0 \0\0\0\0\0\0\0+\0\x04\0\x07\0\0\0\x06\0\0\0\x02\0\0\0\x1C\0\x04\0\x05\0\0\0\x04\0\0\0\x06\0\0\0\x1E\0\x07\0\x08\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x05\0\0\0\x17\0\x04\0\t\0\0\0\x03\0\0\0\x03\0\0\0\x1E\0\x06\0\n\0\0\0\t\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x17\0\x04\0\x0B\0\0\0\x03\0\0\0\x02\0\0\0\x14\0\x02\0\x0C\0\0\0\x1E\0\x06\0\r\0\0\0\x04\0\0\0\x03\0\0\0\x03\0\0\0\x0B\0\0\0\x1E\0\x03\0\x0F\0\0\0\x08\0\0\0 \0\x04\0\x10\0\0\0\x02\0\0\0\x0F\0\0\0;\0\x04\0\x10\0\0\0\x0E\0\0\0\x02\0\0\0!\0\x04\0\x14\0\0\0\x04\0\0\0\n\0\0\0+\0\x04\0\x03\0\0\0\x15\0\0\0\0\0\x80?!\0\x04\0#\0\0\0\x04\0\0\0\x04\0\0\0 \0\x04\0$\0\0\0\x02\0\0\0\x08\0\0\0+\0\x04\0\x07\0\0\0%\0\0\0\0\0\0\0 \0\x04\0(\0\0\0\x02\0\0\0\x04\0\0\0+\0\x04\0\x07\0\0\0,\0\0\0\x01\0\0\0+\0\x04\0\x07\0\0\x003\0\0\0\x03\0\0\0!\0\x04\0;\0\0\0\x0B\0\0\0\x04\0\0\0 \0\x04\0>\0\0\0\x02\0\0\0\x05\0\0\0+\0\x04\0\x07\0\0\0?\0\0\0\x04\0\0\0!\0\x04\0J\0\0\0\x0C\0\0\0\x0B\0\0\0+\0\x04\0\x03\0\0\0K\0\0\0\0\0\0\0,\0\x05\0\x0B\0\0\0L\0\0\0K\0\0\0K\0\0\0\x17\0\x04\0N\0\0\0\x0C\0\0\0\x02\0\0\0+\0\x04\0\x03\0\0\0T\0\0\0\0\0\0?!\0\x05\0_\0\0\0\x03\0\0\0\x03\0\0\0\x03\0\0\0 \0\x04\0f\0\0\0\x01\0\0\0\t\0\0\0;\0\x04\0f\0\0\0e\0\0\0\x01\0\0\0 \0\x04\0i\0\0\0\x01\0\0\0\x04\0\0\0;\0\x04\0i\0\0\0h\0\0\0\x01\0\0\0;\0\x04\0i\0\0\0k\0\0\0\x01\0\0\0;\0\x04\0i\0\0\0m\0\0\0\x01\0\0\0 \0\x04\0p\0\0\0\x03\0\0\0\x04\0\0\0;\0\x04\0p\0\0\0o\0\0\0\x03\0\0\0 \0\x04\0r\0\0\0\x03\0\0\0\x03\0\0\0;\0\x04\0r\0\0\0q\0\0\0\x03\0\0\0;\0\x04\0r\0\0\0s\0\0\0\x03\0\0\0 \0\x04\0u\0\0\0\x03\0\0\0\x0B\0\0\0;\0\x04\0u\0\0\0t\0\0\0\x03\0\0\0!\0\x03\0w\0\0\0\x02\0\0\0;\0\x04\0i\0\0\0\x87\0\0\0\x01\0\0\0 \0\x04\0\x8A\0\0\0\x01\0\0\0\x03\0\0\0;\0\x04\0\x8A\0\0\0\x89\0\0\0\x01\0\0\0;\0\x04\0\x8A\0\0\0\x8C\0\0\0\x01\0\0\0 \0\x04\0\x8F\0\0\0\x01\0\0\0\x0B\0\0\0;\0\x04\0\x8F\0\0\0\x8E\0\0\0\x01\0\0\0;\0\x04\0r\0\0\0\x91\0\0\0\x03\0\0\x006\0\x05\0\x04\0\0\0\x13\0\0\0\0\0\0\0\x14\0\0\x007\0\x03\0\n\0\0\0\x12\0\0\0\xF8\0\x02\0\x11\0\0\0\xF9\0\x02\0\x16\0\0\0\xF8\0\x02\0\x16\0\0\0Q\0\x05\0\t\0\0\0\x17\0\0\0\x12\0\0\0\0\0\0\0P\0\x05\0\x04\0\0\0\x18\0\0\0\x17\0\0\0\x15\0\0\0Q\0\x05\0\x04\0\0\0\x19\0\0\0\x12\0\0\0\x01\0\0\0\x94\0\x05\0\x03\0\0\0\x1A\0\0\0\x19\0\0\0\x18\0\0\0Q\0\x05\0\x04\0\0\0\x1B\0\0\0\x12\0\0\0\x02\0\0\0\x94\0\x05\0\x03\0\0\0\x1C\0\0\0\x1B\0\0\0\x18\0\0\0Q\0\x05\0\x04\0\0\0\x1D\0\0\0\x12\0\0\0\x03\0\0\0\x94\0\x05\0\x03\0\0\0\x1E\0\0\0\x1D\0\0\0\x18\0\0\0P\0\x07\0\x04\0\0\0\x1F\0\0\0\x1A\0\0\0\x1C\0\0\0\x1E\0\0\0\x15\0\0\0\xFE\0\x02\0\x1F\0\0\08\0\x01\x006\0\x05\0\x04\0\0\0\"\0\0\0\0\0\0\0#\0\0\x007\0\x03\0\x04\0\0\0!\0\0\0\xF8\0\x02\0 \0\0\0A\0\x05\0$\0\0\0&\0\0\0\x0E\0\0\0%\0\0\0\xF9\0\x02\0'\0\0\0\xF8\0\x02\0'\0\0\0A\0\x05\0(\0\0\0)\0\0\0&\0\0\0%\0\0\0=\0\x04\0\x04\0\0\0*\0\0\0)\0\0\0\x94\0\x05\0\x03\0\0\0+\0\0\0*\0\0\0!\0\0\0A\0\x05\0(\0\0\0-\0\0\0&\0\0\0,\0\0\0=\0\x04\0\x04\0\0\0.\0\0\0-\0\0\0\x94\0\x05\0\x03\0\0\0/\0\0\0.\0\0\0!\0\0\0A\0\x05\0(\0\0\x000\0\0\0&\0\0\0\x06\0\0\0=\0\x04\0\x04\0\0\x001\0\0\x000\0\0\0\x94\0\x05\0\x03\0\0\x002\0\0\x001\0\0\0!\0\0\0A\0\x05\0(\0\0\x004\0\0\0&\0\0\x003\0\0\0=\0\x04\0\x04\0\0\x005\0\0\x004\0\0\0\x94\0\x05\0\x03\0\0\x006\0\0\x005\0\0\0!\0\0\0P\0\x07\0\x04\0\0\x007\0\0\0+\0\0\0/\0\0\x002\0\0\x006\0\0\0\xFE\0\x02\x007\0\0\08\0\x01\x006\0\x05\0\x0B\0\0\0:\0\0\0\0\0\0\0;\0\0\x007\0\x03\0\x04\0\0\09\0\0\0\xF8\0\x02\08\0\0\0A\0\x05\0$\0\0\0<\0\0\0\x0E\0\0\0%\0\0\0\xF9\0\x02\0=\0\0\0\xF8\0\x02\0=\0\0\0A\0\x06\0(\0\0\0@\0\0\0<\0\0\0?\0\0\0%\0\0\0=\0\x04\0\x04\0\0\0A\0\0\0@\0\0\0\x94\0\x05\0\x03\0\0\0B\0\0\0A\0\0\09\0\0\0A\0\x06\0(\0\0\0C\0\0\0<\0\0\0?\0\0\0,\0\0\0=\0\x04\0\x04\0\0\0D\0\0\0C\0\0\0\x94\0\x05\0\x03\0\0\0E\0\0\0D\0\0\09\0\0\0P\0\x05\0\x0B\0\0\0F\0\0\0B\0\0\0E\0\0\0\xFE\0\x02\0F\0\0\08\0\x01\x006\0\x05\0\x0C\0\0\0I\0\0\0\0\0\0\0J\0\0\x007\0\x03\0\x0B\0\0\0H\0\0\0\xF8\0\x02\0G\0\0\0\xF9\0\x02\0M\0\0\0\xF8\0\x02\0M\0\0\0\xB8\0\x05\0N\0\0\0O\0\0\0H\0\0\0L\0\0\0\x9A\0\x04\0\x0C\0\0\0P\0\0\0O\0\0\0\xFE\0\x02\0P\0\0\08\0\x01\x006\0\x05\0\x04\0\0\0S\0\0\0\0\0\0\0#\0\0\x007\0\x03\0\x04\0\0\0R\0\0\0\xF8\0\x02\0Q\0\0\0\xF9\0\x02\0U\0\0\0\xF8\0\x02\0U\0\0\0O\0\x07\0\x0B\0\0\0V\0\0\0R\0\0\0R\0\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0W\0\0\0R\0\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0X\0\0\0T\0\0\0W\0\0\0Q\0\x05\0\x03\0\0\0Y\0\0\0R\0\0\0\x03\0\0\0P\0\x06\0\x04\0\0\0Z\0\0\0V\0\0\0X\0\0\0Y\0\0\0\xFE\0\x02\0Z\0\0\08\0\x01\x006\0\x05\0\x03\0\0\0^\0\0\0\0\0\0\0_\0\0\x007\0\x03\0\x03\0\0\0\\\0\0\x007\0\x03\0\x03\0\0\0]\0\0\0\xF8\0\x02\0[\0\0\0\xF9\0\x02\0`\0\0\0\xF8\0\x02\0`\0\0\0\x88\0\x05\0\x03\0\0\0a\0\0\0\\\0\0\0]\0\0\0\x0C\0\x08\0\x03\0\0\0b\0\0\0\x01\0\0\0+\0\0\0a\0\0\0K\0\0\0\x15\0\0\0\xFE\0\x02\0b\0\0\08\0\x01\x006\0\x05\0\x02\0\0\0v\0\0\0\0\0\0\0w\0\0\0\xF8\0\x02\0c\0\0\0=\0\x04\0\t\0\0\0g\0\0\0e\0\0\0=\0\x04\0\x04\0\0\0j\0\0\0h\0\0\0=\0\x04\0\x04\0\0\0l\0\0\0k\0\0\0=\0\x04\0\x04\0\0\0n\0\0\0m\0\0\0P\0\x07\0\n\0\0\0d\0\0\0g\0\0\0j\0\0\0l\0\0\0n\0\0\0A\0\x05\0$\0\0\0x\0\0\0\x0E\0\0\0%\0\0\0\xF9\0\x02\0y\0\0\0\xF8\0\x02\0y\0\0\09\0\x05\0\x04\0\0\0z\0\0\0\x13\0\0\0d\0\0\09\0\x05\0\x04\0\0\0{\0\0\0\"\0\0\0z\0\0\09\0\x05\0\x04\0\0\0|\0\0\0S\0\0\0{\0\0\0Q\0\x05\0\x03\0\0\0}\0\0\0{\0\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0~\0\0\0{\0\0\0\x03\0\0\09\0\x05\0\x0B\0\0\0\x7F\0\0\0:\0\0\0z\0\0\0P\0\x07\0\r\0\0\0\x80\0\0\0|\0\0\0}\0\0\0~\0\0\0\x7F\0\0\0Q\0\x05\0\x04\0\0\0\x81\0\0\0\x80\0\0\0\0\0\0\0>\0\x03\0o\0\0\0\x81\0\0\0Q\0\x05\0\x03\0\0\0\x82\0\0\0\x80\0\0\0\x01\0\0\0>\0\x03\0q\0\0\0\x82\0\0\0Q\0\x05\0\x03\0\0\0\x83\0\0\0\x80\0\0\0\x02\0\0\0>\0\x03\0s\0\0\0\x83\0\0\0Q\0\x05\0\x0B\0\0\0\x84\0\0\0\x80\0\0\0\x03\0\0\0>\0\x03\0t\0\0\0\x84\0\0\0\xFD\0\x01\08\0\x01\x006\0\x05\0\x02\0\0\0\x92\0\0\0\0\0\0\0w\0\0\0\xF8\0\x02\0\x85\0\0\0=\0\x04\0\x04\0\0\0\x88\0\0\0\x87\0\0\0=\0\x04\0\x03\0\0\0\x8B\0\0\0\x89\0\0\0=\0\x04\0\x03\0\0\0\x8D\0\0\0\x8C\0\0\0=\0\x04\0\x0B\0\0\0\x90\0\0\0\x8E\0\0\0P\0\x07\0\r\0\0\0\x86\0\0\0\x88\0\0\0\x8B\0\0\0\x8D\0\0\0\x90\0\0\0\xF9\0\x02\0\x93\0\0\0\xF8\0\x02\0\x93\0\0\0Q\0\x05\0\x0B\0\0\0\x94\0\0\0\x86\0\0\0\x03\0\0\09\0\x05\0\x0C\0\0\0\x95\0\0\0I\0\0\0\x94\0\0\0\xF7\0\x03\0\x96\0\0\0\0\0\0\0\xFA\0\x04\0\x95\0\0\0\x97\0\0\0\x96\0\0\0\xF8\0\x02\0\x97\0\0\0\xFC\0\x01\0\xF8\0\x02\0\x96\0\0\0Q\0\x05\0\x03\0\0\0\x98\0\0\0\x86\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\x99\0\0\0\x86\0\0\0\x02\0\0\09\0\x06\0\x03\0\0\0\x9A\0\0\0^\0\0\0\x98\0\0\0\x99\0\0\0>\0\x03\0\x91\0\0\0\x9A\0\0\0\xFD\0\x01\08\0\x01\0";
    /// WGSL of the mask shader.
    pub const MASK_WGSL: &str = r#"// Planes: turns the view's depth into a visibility mask.
// Positions and normals are relative to the eye, in camera axes: x right, y up, looking along -z.
// Both cases of the camera space paper behind one shader: every plan takes four planes or one, whichever promises the
// smaller footprint, here with the bands that the paper does not have.
// Generated from light case `Planes`, f580f15ac2a7262b. Do not edit.

/// Width and height of the map in texels.
const PLANES_MAP_SIZE: vec2<f32> = vec2<f32>(2048.0, 2048.0);
/// Sectors around the eye.
const PLANES_SECTORS: u32 = 4u;
/// Bands of distance in each sector.
const PLANES_BANDS: u32 = 8u;
/// Vectors of four band limits in each sector.
const PLANES_THRESHOLD_VECTORS: u32 = 2u;

/// What resolving needs of one facet; all zero where a plan has none.
struct PlanesFacet {
    /// Clip x of the tile, to the right.
    row_x: vec4<f32>,
    /// Clip y of the tile, upwards.
    row_y: vec4<f32>,
    /// Clip z: depth along the light times w.
    row_z: vec4<f32>,
    /// Clip w, positive on receivers.
    row_w: vec4<f32>,
    /// Map texel coordinates = clip space after division * xy + zw.
    texel_from_ndc: vec4<f32>,
    /// Smallest (xy) and largest (zw) map texel coordinates of the facet's receivers.
    texel_limits: vec4<f32>,
    /// Depth by which an exact receiver plane is lowered.
    receiver_plane_depth: f32,
}

/// What resolving needs of a plan.
struct PlanesShadow {
    /// Border rows of the sectors, in walking order; the first closes the ring.
    borders: array<vec4<f32>, 4>,
    /// Distance row of each sector.
    distances: array<vec4<f32>, 4>,
    /// Ascending band limits of each sector, four to a vector; unused ones are out of reach.
    thresholds: array<vec4<f32>, 8>,
    /// What x and y gain per z by the shear along the light: twelve leading bits, then the rest.
    shear: vec4<f32>,
    /// 1 where stored depth grows away from the light, -1 where it falls.
    depth_sign: f32,
    /// The facets: cell = (half * sectors + sector) * bands + band.
    facets: array<PlanesFacet, 32>,
}

/// What the mask pass needs of the view.
struct PlanesMask {
    /// Direction through the image's upper left corner, depth 1, in the case's axes.
    ray_corner: vec4<f32>,
    /// Change of that direction across the whole image.
    ray_across: vec4<f32>,
    /// Change of that direction down the whole image.
    ray_down: vec4<f32>,
    /// One over the depth in metres = stored depth * x + y.
    inverse_depth: vec2<f32>,
}

/// The view.
@group(0) @binding(0)
var<uniform> planes_mask: PlanesMask;
/// The engine's depth, reversed-z.
@group(0) @binding(1)
var planes_scene_depth: texture_depth_2d;
/// The plan.
@group(1) @binding(0)
var<uniform> planes_shadow: PlanesShadow;
/// The shadow map.
@group(1) @binding(1)
var planes_map: texture_depth_2d;
/// Takes the nearest texel, clamps to the edge.
@group(1) @binding(2)
var planes_map_sampler: sampler;

/// Two to the power of -23: the last bit of a float's mantissa.
const PLANES_LAST_BIT: f32 = 1.1920928955078125e-7;

/// The position as facet rows take it: moved along the light to the plane z = 0, z kept.
///
/// What is added may cancel the position nearly, so its products must not be rounded, and a fused multiplication is not
/// to be had everywhere. The leading parts of the shear have twelve bits; so have both halves of z. The lower half is
/// taken as a whole number, from which no compiler finds the way back to one rounded product.
fn planes_facet_position(position: vec3<f32>) -> vec3<f32> {
    // Split z.
    let bits = bitcast<u32>(position.z);
    let upper = bitcast<f32>(bits & 0xfffff000u);
    let lower = f32(bits & 0xfffu);
    let step = bitcast<f32>(bits & 0xff800000u) * PLANES_LAST_BIT;

    // Add the largest product first: each sum is exact while it cancels.
    var moved = position.xy + planes_shadow.shear.xy * upper;
    moved += (planes_shadow.shear.xy * step) * lower;
    moved += planes_shadow.shear.zw * position.z;
    return vec3<f32>(moved, position.z);
}

/// The normal as facet rows take it.
fn planes_facet_normal(normal: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(normal.xy, normal.z - dot(planes_shadow.shear.xy + planes_shadow.shear.zw, normal.xy));
}

/// Finds the sector of a receiver: its first border decides the direction, then each border is passed or not.
fn planes_sector_index(position: vec3<f32>) -> u32 {
    let point = vec4<f32>(position, 1.0);

    // Walk forwards from the ring's start up to the first border that is not passed, and backwards from its end down to
    // the first that is: both at once, without a branch.
    var is_ahead = 1u;
    var forwards = 0u;
    var backwards = 0u;
    for (var border = 1u; border < PLANES_SECTORS; border += 1u) {
        let is_passed = dot(planes_shadow.borders[border], point) >= 0.0;
        is_ahead = select(0u, is_ahead, is_passed);
        forwards += is_ahead;
        backwards = select(backwards, border, is_passed);
    }
    return select(backwards, forwards, dot(planes_shadow.borders[0], point) >= 0.0);
}

/// Finds the facet of a receiver: its sector, then the number of that sector's thresholds that its distance has
/// reached.
fn planes_facet_index(position: vec3<f32>) -> u32 {
    let sector = planes_sector_index(position);
    let distance = dot(planes_shadow.distances[sector], vec4<f32>(position, 1.0));
    var reached = vec4<u32>(0u);
    for (var index = 0u; index < PLANES_THRESHOLD_VECTORS; index += 1u) {
        let limits = planes_shadow.thresholds[sector * PLANES_THRESHOLD_VECTORS + index];
        reached += select(vec4<u32>(0u), vec4<u32>(1u), vec4<f32>(distance) >= limits);
    }
    return sector * PLANES_BANDS + min(reached.x + reached.y + reached.z + reached.w, PLANES_BANDS - 1u);
}

/// The facet of a receiver.
fn planes_own_facet(position: vec3<f32>) -> PlanesFacet {
    return planes_shadow.facets[planes_facet_index(position)];
}

/// Where a receiver falls in its facet.
struct PlanesPlace {
    /// Clip space of the tile after division: x and y in [-1, 1], z growing away from the light.
    ndc: vec3<f32>,
    /// What was divided by.
    w: f32,
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Whether every texel that a filter takes here belongs to the tile.
    covered: bool,
}

/// Applies a facet's matrix, row by row, to a position relative to the eye.
fn planes_place_in_facet(facet: PlanesFacet, position: vec3<f32>) -> PlanesPlace {
    let point = vec4<f32>(position, 1.0);
    let w = dot(facet.row_w, point);
    let clip = vec3<f32>(dot(facet.row_x, point), dot(facet.row_y, point), dot(facet.row_z, point));
    let ndc = clip / w;
    let texel = ndc.xy * facet.texel_from_ndc.xy + facet.texel_from_ndc.zw;

    // Facets without receivers are all zero, so w refuses them.
    let inside = all(texel >= facet.texel_limits.xy) && all(texel <= facet.texel_limits.zw);
    return PlanesPlace(ndc, w, texel, w > 0.0 && inside);
}

/// The nearest signed depth that the map can hold.
fn planes_held_depth(depth: f32) -> f32 {
    return clamp(depth, min(planes_shadow.depth_sign, 0.0), max(planes_shadow.depth_sign, 0.0));
}

/// Share of light that each of four stored depths lets through to its signed reference: all or none.
fn planes_lit_by_four(references: vec4<f32>, stored: vec4<f32>) -> vec4<f32> {
    return select(vec4<f32>(0.0), vec4<f32>(1.0), references <= planes_shadow.depth_sign * stored);
}

/// A receiver in the map, with its plane.
struct PlanesReceiver {
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Depth of the lowered plane at the receiver itself.
    reference: f32,
    /// Change of the plane's depth per texel along x and y.
    gradient: vec2<f32>,
}

/// Depth of the receiver's plane at an offset in texels, within the depths that the map can hold.
fn planes_plane_reference(receiver: PlanesReceiver, offset: vec2<f32>) -> f32 {
    return planes_held_depth(receiver.reference + dot(receiver.gradient, offset));
}

/// Gradient of clip y after division, times w.
fn planes_up_gradient(facet: PlanesFacet, place: PlanesPlace) -> vec3<f32> {
    return facet.row_y.xyz - place.ndc.y * facet.row_w.xyz;
}

/// Largest change of depth from one texel to the next that a plane is followed to: the map's whole range.
const PLANES_STEEPEST_PLANE: f32 = 1.0;

/// Change of depth per texel along x and y over the plane through a receiver; a normal of any length will do.
fn planes_plane_gradient(facet: PlanesFacet, place: PlanesPlace, normal: vec3<f32>) -> vec2<f32> {
    // Take the gradients of the facet's coordinates; their common factor 1/w cancels below.
    let across = facet.row_x.xyz - place.ndc.x * facet.row_w.xyz;
    let up = planes_up_gradient(facet, place);
    let away = facet.row_z.xyz - place.ndc.z * facet.row_w.xyz;

    // Solve for the depth that x and y change by while the point stays on the plane.
    let area = dot(normal, cross(across, up));
    let slope = vec2<f32>(dot(away, cross(up, normal)), dot(away, cross(normal, across)));

    // Turn it into depth per texel; a plane that the light only grazes is as steep as the map allows.
    let exact = slope / (area * facet.texel_from_ndc.xy);
    let followed = clamp(exact, vec2<f32>(-PLANES_STEEPEST_PLANE), vec2<f32>(PLANES_STEEPEST_PLANE));
    return select(followed, vec2<f32>(0.0), area == 0.0);
}

/// The receiver with the plane through it; a normal of any length will do.
fn planes_biased_receiver(facet: PlanesFacet, place: PlanesPlace, normal: vec3<f32>) -> PlanesReceiver {
    let gradient = planes_plane_gradient(facet, place, normal);
    return PlanesReceiver(place.texel, place.ndc.z - facet.receiver_plane_depth, gradient);
}

/// Share of light that reaches the receiver.
fn planes_filtered_visibility(receiver: PlanesReceiver) -> f32 {
    // Gather around the corner that the four texels share: rounding cannot reach another four from there.
    let corner = floor(receiver.texel - 0.5) + 1.0;
    let stored = textureGather(planes_map, planes_map_sampler, corner / PLANES_MAP_SIZE);

    // Follow the plane to each centre; a gather begins at the lower left and runs against the clock.
    let offset = corner - receiver.texel;
    let references = vec4<f32>(
        planes_plane_reference(receiver, offset + vec2<f32>(-0.5, 0.5)),
        planes_plane_reference(receiver, offset + vec2<f32>(0.5, 0.5)),
        planes_plane_reference(receiver, offset + vec2<f32>(0.5, -0.5)),
        planes_plane_reference(receiver, offset + vec2<f32>(-0.5, -0.5)),
    );

    // Compare, then blend.
    let lit = planes_lit_by_four(references, stored);
    let weight = vec2<f32>(0.5) - offset;
    return mix(mix(lit.w, lit.z, weight.x), mix(lit.x, lit.y, weight.x), weight.y);
}

/// Share of the light that reaches a receiver: 1 in the light and outside the map, 0 in shadow.
///
/// `position` is relative to the eye, in metres; `normal` is the geometric normal there; both are in the case's axes.
/// The function takes no derivatives, so any control flow may call it.
fn planes_visibility(position: vec3<f32>, normal: vec3<f32>) -> f32 {
    let point = planes_facet_position(position);
    let facet = planes_own_facet(point);
    let place = planes_place_in_facet(facet, point);
    if !place.covered {
        return 1.0;
    }
    return planes_filtered_visibility(planes_biased_receiver(facet, place, planes_facet_normal(normal)));
}

/// One over the depth in metres at a pixel; 0 where nothing was drawn.
fn planes_inverse_depth_at(pixel: vec2<i32>) -> f32 {
    let stored = textureLoad(planes_scene_depth, pixel, 0);
    return select(0.0, stored * planes_mask.inverse_depth.x + planes_mask.inverse_depth.y, stored > 0.0);
}

/// Direction of a pixel, relative to the eye, in the case's axes, with a depth of one metre.
fn planes_view_ray(pixel: vec2<f32>) -> vec3<f32> {
    let part = pixel / vec2<f32>(textureDimensions(planes_scene_depth));
    return planes_mask.ray_corner.xyz + planes_mask.ray_across.xyz * part.x + planes_mask.ray_down.xyz * part.y;
}

/// Change of one over depth per pixel along one axis of the image.
fn planes_inverse_depth_slope(pixel: vec2<i32>, axis: vec2<i32>, centre: f32) -> f32 {
    // Take two neighbours on either side; beyond the image's edge the nearest pixel stands in.
    let last = vec2<i32>(textureDimensions(planes_scene_depth)) - 1;
    let behind_near = planes_inverse_depth_at(max(pixel - axis, vec2<i32>(0)));
    let behind_far = planes_inverse_depth_at(max(pixel - 2 * axis, vec2<i32>(0)));
    let ahead_near = planes_inverse_depth_at(min(pixel + axis, last));
    let ahead_far = planes_inverse_depth_at(min(pixel + 2 * axis, last));

    // Prefer the side that predicts the centre better, unless the image ends there.
    let behind_error = abs(2.0 * behind_near - behind_far - centre);
    let ahead_error = abs(2.0 * ahead_near - ahead_far - centre);
    let behind_ends = any(pixel - 2 * axis < vec2<i32>(0));
    let ahead_ends = any(pixel + 2 * axis > last);
    let behind_is_better = !behind_ends && (ahead_ends || behind_error <= ahead_error);
    return select(ahead_near - centre, centre - behind_near, behind_is_better);
}

/// Unit normal of the surface behind a pixel, in the case's axes, on the side that faces the eye.
fn planes_reconstructed_normal(pixel: vec2<i32>, ray: vec3<f32>, inverse_depth: f32) -> vec3<f32> {
    // Measure how one over depth changes across the whole image and down it.
    let size = vec2<f32>(textureDimensions(planes_scene_depth));
    let across_slope = planes_inverse_depth_slope(pixel, vec2<i32>(1, 0), inverse_depth) * size.x;
    let down_slope = planes_inverse_depth_slope(pixel, vec2<i32>(0, 1), inverse_depth) * size.y;

    // Cross the two tangents of ray / inverse_depth; this sum is free of divisions.
    let across = planes_mask.ray_across.xyz;
    let down = planes_mask.ray_down.xyz;
    let level = inverse_depth * cross(across, down);
    let normal = level + across_slope * cross(down, ray) + down_slope * cross(ray, across);
    return normalize(select(normal, -normal, dot(normal, ray) > 0.0));
}

/// Covers the image with one triangle: corners (-1, 1), (-1, -3) and (3, 1).
@vertex
fn planes_mask_vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    let x = select(-1.0, 3.0, corner == 2u);
    let y = select(1.0, -3.0, corner == 1u);
    return vec4<f32>(x, y, 0.0, 1.0);
}

/// Writes the visibility of the surface behind a pixel to red; sky is lit.
@fragment
fn planes_mask_fragment(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
    let inverse_depth = planes_inverse_depth_at(vec2<i32>(pixel.xy));
    if inverse_depth <= 0.0 {
        return vec4<f32>(1.0, 0.0, 0.0, 1.0);
    }
    let ray = planes_view_ray(pixel.xy);
    let normal = planes_reconstructed_normal(vec2<i32>(pixel.xy), ray, inverse_depth);
    let lit = planes_visibility(ray / inverse_depth, normal);
    return vec4<f32>(lit, 0.0, 0.0, 1.0);
}
"#;
    /// SPIR-V of the mask shader, little-endian words.
    pub const MASK_SPIRV: &[u8] = b"\x03\x02#\x07\0\x03\x01\0\x1C\0\0\0\x8C\x02\0\0\0\0\0\0\x11\0\x02\0\x01\0\0\0\x11\0\x02\x002\0\0\0\x0B\0\x06\0\x01\0\0\0GLSL.std.450\0\0\0\0\x0E\0\x03\0\0\0\0\0\x01\0\0\0\x0F\0\n\0\0\0\0\0`\x02\0\0planes_mask_vertex\0\0[\x02\0\0^\x02\0\0\x0F\0\x0B\0\x04\0\0\0o\x02\0\0planes_mask_fragment\0\0\0\0k\x02\0\0n\x02\0\0\x10\0\x03\0o\x02\0\0\x07\0\0\0H\0\x05\0\x07\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x07\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x07\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\x07\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\x07\0\0\0\x04\0\0\0#\0\0\0@\0\0\0H\0\x05\0\x07\0\0\0\x05\0\0\0#\0\0\0P\0\0\0H\0\x05\0\x07\0\0\0\x06\0\0\0#\0\0\0`\0\0\0G\0\x04\0\x08\0\0\0\x06\0\0\0\x10\0\0\0G\0\x04\0\n\0\0\0\x06\0\0\0\x10\0\0\0G\0\x04\0\x0C\0\0\0\x06\0\0\0p\0\0\0H\0\x05\0\x0E\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x0E\0\0\0\x01\0\0\0#\0\0\0@\0\0\0H\0\x05\0\x0E\0\0\0\x02\0\0\0#\0\0\0\x80\0\0\0H\0\x05\0\x0E\0\0\0\x03\0\0\0#\0\0\0\0\x01\0\0H\0\x05\0\x0E\0\0\0\x04\0\0\0#\0\0\0\x10\x01\0\0H\0\x05\0\x0E\0\0\0\x05\0\0\0#\0\0\0 \x01\0\0H\0\x05\0\x0F\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x0F\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x0F\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\x0F\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\x15\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x15\0\0\0\x01\0\0\0#\0\0\0\x0C\0\0\0H\0\x05\0\x15\0\0\0\x02\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x15\0\0\0\x03\0\0\0#\0\0\0\x18\0\0\0H\0\x05\0\x16\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x16\0\0\0\x01\0\0\0#\0\0\0\x08\0\0\0H\0\x05\0\x16\0\0\0\x02\0\0\0#\0\0\0\x10\0\0\0G\0\x04\0\x1E\0\0\0\"\0\0\0\0\0\0\0G\0\x04\0\x1E\0\0\0!\0\0\0\0\0\0\0G\0\x03\0\x1F\0\0\0\x02\0\0\0H\0\x05\0\x1F\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0!\0\0\0\"\0\0\0\0\0\0\0G\0\x04\0!\0\0\0!\0\0\0\x01\0\0\0G\0\x04\0#\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0#\0\0\0!\0\0\0\0\0\0\0G\0\x03\0$\0\0\0\x02\0\0\0H\0\x05\0$\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0&\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0&\0\0\0!\0\0\0\x01\0\0\0G\0\x04\0'\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0'\0\0\0!\0\0\0\x02\0\0\0G\0\x04\0[\x02\0\0\x0B\0\0\0*\0\0\0G\0\x04\0^\x02\0\0\x0B\0\0\0\0\0\0\0G\0\x04\0k\x02\0\0\x0B\0\0\0\x0F\0\0\0G\0\x04\0n\x02\0\0\x1E\0\0\0\0\0\0\0\x13\0\x02\0\x02\0\0\0\x16\0\x03\0\x03\0\0\0 \0\0\0\x17\0\x04\0\x04\0\0\0\x03\0\0\0\x02\0\0\0\x15\0\x04\0\x05\0\0\0 \0\0\0\0\0\0\0\x17\0\x04\0\x06\0\0\0\x03\0\0\0\x04\0\0\0\x1E\0\t\0\x07\0\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0\x03\0\0\0+\0\x04\0\x05\0\0\0\t\0\0\0\x04\0\0\0\x1C\0\x04\0\x08\0\0\0\x06\0\0\0\t\0\0\0+\0\x04\0\x05\0\0\0\x0B\0\0\0\x08\0\0\0\x1C\0\x04\0\n\0\0\0\x06\0\0\0\x0B\0\0\0+\0\x04\0\x05\0\0\0\r\0\0\0 \0\0\0\x1C\0\x04\0\x0C\0\0\0\x07\0\0\0\r\0\0\0\x1E\0\x08\0\x0E\0\0\0\x08\0\0\0\x08\0\0\0\n\0\0\0\x06\0\0\0\x03\0\0\0\x0C\0\0\0\x1E\0\x06\0\x0F\0\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0\x04\0\0\0\x19\0\t\0\x10\0\0\0\x03\0\0\0\x01\0\0\0\x01\0\0\0\0\0\0\0\0\0\0\0\x01\0\0\0\0\0\0\0\x1A\0\x02\0\x11\0\0\0\x17\0\x04\0\x12\0\0\0\x03\0\0\0\x03\0\0\0\x14\0\x02\0\x13\0\0\0\x17\0\x04\0\x14\0\0\0\x05\0\0\0\x04\0\0\0\x1E\0\x06\0\x15\0\0\0\x12\0\0\0\x03\0\0\0\x04\0\0\0\x13\0\0\0\x1E\0\x05\0\x16\0\0\0\x04\0\0\0\x03\0\0\0\x04\0\0\0\x15\0\x04\0\x18\0\0\0 \0\0\0\x01\0\0\0\x17\0\x04\0\x17\0\0\0\x18\0\0\0\x02\0\0\0+\0\x04\0\x03\0\0\0\x19\0\0\0\0\0\0E,\0\x05\0\x04\0\0\0\x1A\0\0\0\x19\0\0\0\x19\0\0\0+\0\x04\0\x05\0\0\0\x1B\0\0\0\x02\0\0\0+\0\x04\0\x03\0\0\0\x1C\0\0\0\0\0\x004+\0\x04\0\x03\0\0\0\x1D\0\0\0\0\0\x80?\x1E\0\x03\0\x1F\0\0\0\x0F\0\0\0 \0\x04\0 \0\0\0\x02\0\0\0\x1F\0\0\0;\0\x04\0 \0\0\0\x1E\0\0\0\x02\0\0\0 \0\x04\0\"\0\0\0\0\0\0\0\x10\0\0\0;\0\x04\0\"\0\0\0!\0\0\0\0\0\0\0\x1E\0\x03\0$\0\0\0\x0E\0\0\0 \0\x04\0%\0\0\0\x02\0\0\0$\0\0\0;\0\x04\0%\0\0\0#\0\0\0\x02\0\0\0;\0\x04\0\"\0\0\0&\0\0\0\0\0\0\0 \0\x04\0(\0\0\0\0\0\0\0\x11\0\0\0;\0\x04\0(\0\0\0'\0\0\0\0\0\0\0!\0\x04\0,\0\0\0\x12\0\0\0\x12\0\0\0 \0\x04\0-\0\0\0\x02\0\0\0\x0E\0\0\0+\0\x04\0\x05\0\0\0.\0\0\0\0\0\0\0+\0\x04\0\x05\0\0\x000\0\0\0\0\xF0\xFF\xFF+\0\x04\0\x05\0\0\x001\0\0\0\xFF\x0F\0\0+\0\x04\0\x05\0\0\x002\0\0\0\0\0\x80\xFF \0\x04\x004\0\0\0\x07\0\0\0\x04\0\0\0.\0\x03\0\x04\0\0\x005\0\0\0 \0\x04\0A\0\0\0\x02\0\0\0\x06\0\0\0+\0\x04\0\x05\0\0\0B\0\0\0\x03\0\0\0!\0\x04\0n\0\0\0\x05\0\0\0\x12\0\0\0+\0\x04\0\x05\0\0\0p\0\0\0\x01\0\0\0+\0\x04\0\x03\0\0\0q\0\0\0\0\0\0\0 \0\x04\0s\0\0\0\x07\0\0\0\x05\0\0\0 \0\x04\0\x83\0\0\0\x02\0\0\0\x08\0\0\0,\0\x07\0\x14\0\0\0\x9E\0\0\0.\0\0\0.\0\0\0.\0\0\0.\0\0\0,\0\x07\0\x14\0\0\0\x9F\0\0\0p\0\0\0p\0\0\0p\0\0\0p\0\0\0+\0\x04\0\x05\0\0\0\xA0\0\0\0\x07\0\0\0 \0\x04\0\xA2\0\0\0\x07\0\0\0\x14\0\0\0 \0\x04\0\xB4\0\0\0\x02\0\0\0\n\0\0\0\x17\0\x04\0\xBC\0\0\0\x13\0\0\0\x04\0\0\0!\0\x04\0\xD3\0\0\0\x07\0\0\0\x12\0\0\0 \0\x04\0\xD6\0\0\0\x02\0\0\0\x0C\0\0\0 \0\x04\0\xD8\0\0\0\x02\0\0\0\x07\0\0\0+\0\x04\0\x05\0\0\0\xD9\0\0\0\x05\0\0\0!\0\x05\0\xE0\0\0\0\x15\0\0\0\x07\0\0\0\x12\0\0\0*\0\x03\0\x13\0\0\0\xE1\0\0\0 \0\x04\0\xE3\0\0\0\x07\0\0\0\x13\0\0\0.\0\x03\0\x13\0\0\0\xE4\0\0\0.\0\x03\0\x13\0\0\0\xE6\0\0\0\x17\0\x04\0\xFD\0\0\0\x13\0\0\0\x02\0\0\0!\0\x04\0\x11\x01\0\0\x03\0\0\0\x03\0\0\0 \0\x04\0\x14\x01\0\0\x02\0\0\0\x03\0\0\0!\0\x05\0 \x01\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0,\0\x07\0\x06\0\0\0\"\x01\0\0q\0\0\0q\0\0\0q\0\0\0q\0\0\0,\0\x07\0\x06\0\0\0#\x01\0\0\x1D\0\0\0\x1D\0\0\0\x1D\0\0\0\x1D\0\0\0!\0\x05\0.\x01\0\0\x03\0\0\0\x16\0\0\0\x04\0\0\0!\0\x05\0:\x01\0\0\x12\0\0\0\x07\0\0\0\x15\0\0\0!\0\x06\0I\x01\0\0\x04\0\0\0\x07\0\0\0\x15\0\0\0\x12\0\0\0+\0\x04\0\x03\0\0\0J\x01\0\0\0\0\x80\xBF,\0\x05\0\x04\0\0\0K\x01\0\0J\x01\0\0J\x01\0\0,\0\x05\0\x04\0\0\0L\x01\0\0\x1D\0\0\0\x1D\0\0\0,\0\x05\0\x04\0\0\0M\x01\0\0q\0\0\0q\0\0\0!\0\x06\0t\x01\0\0\x16\0\0\0\x07\0\0\0\x15\0\0\0\x12\0\0\0!\0\x04\0\x80\x01\0\0\x03\0\0\0\x16\0\0\0+\0\x04\0\x03\0\0\0\x84\x01\0\0\0\0\0?,\0\x05\0\x04\0\0\0\x85\x01\0\0\x84\x01\0\0\x84\x01\0\0+\0\x04\0\x03\0\0\0\x86\x01\0\0\0\0\0\xBF,\0\x05\0\x04\0\0\0\x87\x01\0\0\x86\x01\0\0\x84\x01\0\0,\0\x05\0\x04\0\0\0\x88\x01\0\0\x84\x01\0\0\x84\x01\0\0,\0\x05\0\x04\0\0\0\x89\x01\0\0\x84\x01\0\0\x86\x01\0\0,\0\x05\0\x04\0\0\0\x8A\x01\0\0\x86\x01\0\0\x86\x01\0\0\x1B\0\x03\0\x91\x01\0\0\x10\0\0\0!\0\x05\0\xAF\x01\0\0\x03\0\0\0\x12\0\0\0\x12\0\0\0!\0\x04\0\xC1\x01\0\0\x03\0\0\0\x17\0\0\0 \0\x04\0\xC2\x01\0\0\x02\0\0\0\x0F\0\0\0+\0\x04\0\x18\0\0\0\xC5\x01\0\0\0\0\0\0 \0\x04\0\xC9\x01\0\0\x02\0\0\0\x04\0\0\0!\0\x04\0\xD5\x01\0\0\x12\0\0\0\x04\0\0\0\x17\0\x04\0\xD9\x01\0\0\x05\0\0\0\x02\0\0\0!\0\x06\0\xF1\x01\0\0\x03\0\0\0\x17\0\0\0\x17\0\0\0\x03\0\0\0+\0\x04\0\x18\0\0\0\xF4\x01\0\0\x01\0\0\0,\0\x05\0\x17\0\0\0\xF5\x01\0\0\xF4\x01\0\0\xF4\x01\0\0,\0\x05\0\x17\0\0\0\xF6\x01\0\0\xC5\x01\0\0\xC5\x01\0\0+\0\x04\0\x18\0\0\0\xF7\x01\0\0\x02\0\0\0+\0\x04\0\x03\0\0\0\xF8\x01\0\0\0\0\0@)\0\x03\0\x13\0\0\0\xF9\x01\0\0.\0\x03\0\x13\0\0\0\xFB\x01\0\0.\0\x03\0\x13\0\0\0\xFD\x01\0\0!\0\x06\x007\x02\0\0\x12\0\0\0\x17\0\0\0\x12\0\0\0\x03\0\0\0,\0\x05\0\x17\0\0\0:\x02\0\0\xF4\x01\0\0\xC5\x01\0\0,\0\x05\0\x17\0\0\0;\x02\0\0\xC5\x01\0\0\xF4\x01\0\0\x17\0\x04\0W\x02\0\0\x13\0\0\0\x03\0\0\0 \0\x04\0\\\x02\0\0\x01\0\0\0\x05\0\0\0;\0\x04\0\\\x02\0\0[\x02\0\0\x01\0\0\0 \0\x04\0_\x02\0\0\x03\0\0\0\x06\0\0\0;\0\x04\0_\x02\0\0^\x02\0\0\x03\0\0\0!\0\x03\0a\x02\0\0\x02\0\0\0+\0\x04\0\x03\0\0\0b\x02\0\0\0\0@@+\0\x04\0\x03\0\0\0c\x02\0\0\0\0@\xC0 \0\x04\0l\x02\0\0\x01\0\0\0\x06\0\0\0;\0\x04\0l\x02\0\0k\x02\0\0\x01\0\0\0;\0\x04\0_\x02\0\0n\x02\0\0\x03\0\0\0,\0\x07\0\x06\0\0\0u\x02\0\0\x1D\0\0\0q\0\0\0q\0\0\0\x1D\0\0\0+\0\x04\0\x03\0\0\0x\x02\0\0\0\0\0\xCF,\0\x05\0\x04\0\0\0y\x02\0\0x\x02\0\0x\x02\0\0+\0\x04\0\x03\0\0\0z\x02\0\0\xFF\xFF\xFFN,\0\x05\0\x04\0\0\0{\x02\0\0z\x02\0\0z\x02\0\x006\0\x05\0\x12\0\0\0+\0\0\0\0\0\0\0,\0\0\x007\0\x03\0\x12\0\0\0*\0\0\0\xF8\0\x02\0)\0\0\0;\0\x05\x004\0\0\x003\0\0\0\x07\0\0\x005\0\0\0A\0\x05\0-\0\0\0/\0\0\0#\0\0\0.\0\0\0\xF9\0\x02\x006\0\0\0\xF8\0\x02\x006\0\0\0Q\0\x05\0\x03\0\0\x007\0\0\0*\0\0\0\x02\0\0\0|\0\x04\0\x05\0\0\08\0\0\x007\0\0\0\xC7\0\x05\0\x05\0\0\09\0\0\08\0\0\x000\0\0\0|\0\x04\0\x03\0\0\0:\0\0\09\0\0\0\xC7\0\x05\0\x05\0\0\0;\0\0\08\0\0\x001\0\0\0p\0\x04\0\x03\0\0\0<\0\0\0;\0\0\0\xC7\0\x05\0\x05\0\0\0=\0\0\08\0\0\x002\0\0\0|\0\x04\0\x03\0\0\0>\0\0\0=\0\0\0\x85\0\x05\0\x03\0\0\0?\0\0\0>\0\0\0\x1C\0\0\0O\0\x07\0\x04\0\0\0@\0\0\0*\0\0\0*\0\0\0\0\0\0\0\x01\0\0\0A\0\x05\0A\0\0\0C\0\0\0/\0\0\0B\0\0\0=\0\x04\0\x06\0\0\0D\0\0\0C\0\0\0O\0\x07\0\x04\0\0\0E\0\0\0D\0\0\0D\0\0\0\0\0\0\0\x01\0\0\0\x8E\0\x05\0\x04\0\0\0F\0\0\0E\0\0\0:\0\0\0\x81\0\x05\0\x04\0\0\0G\0\0\0@\0\0\0F\0\0\0>\0\x03\x003\0\0\0G\0\0\0=\0\x04\0\x04\0\0\0H\0\0\x003\0\0\0A\0\x05\0A\0\0\0I\0\0\0/\0\0\0B\0\0\0=\0\x04\0\x06\0\0\0J\0\0\0I\0\0\0O\0\x07\0\x04\0\0\0K\0\0\0J\0\0\0J\0\0\0\0\0\0\0\x01\0\0\0\x8E\0\x05\0\x04\0\0\0L\0\0\0K\0\0\0?\0\0\0\x8E\0\x05\0\x04\0\0\0M\0\0\0L\0\0\0<\0\0\0\x81\0\x05\0\x04\0\0\0N\0\0\0H\0\0\0M\0\0\0>\0\x03\x003\0\0\0N\0\0\0=\0\x04\0\x04\0\0\0O\0\0\x003\0\0\0A\0\x05\0A\0\0\0P\0\0\0/\0\0\0B\0\0\0=\0\x04\0\x06\0\0\0Q\0\0\0P\0\0\0O\0\x07\0\x04\0\0\0R\0\0\0Q\0\0\0Q\0\0\0\x02\0\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0S\0\0\0*\0\0\0\x02\0\0\0\x8E\0\x05\0\x04\0\0\0T\0\0\0R\0\0\0S\0\0\0\x81\0\x05\0\x04\0\0\0U\0\0\0O\0\0\0T\0\0\0>\0\x03\x003\0\0\0U\0\0\0=\0\x04\0\x04\0\0\0V\0\0\x003\0\0\0Q\0\x05\0\x03\0\0\0W\0\0\0*\0\0\0\x02\0\0\0P\0\x05\0\x12\0\0\0X\0\0\0V\0\0\0W\0\0\0\xFE\0\x02\0X\0\0\08\0\x01\x006\0\x05\0\x12\0\0\0[\0\0\0\0\0\0\0,\0\0\x007\0\x03\0\x12\0\0\0Z\0\0\0\xF8\0\x02\0Y\0\0\0A\0\x05\0-\0\0\0\\\0\0\0#\0\0\0.\0\0\0\xF9\0\x02\0]\0\0\0\xF8\0\x02\0]\0\0\0O\0\x07\0\x04\0\0\0^\0\0\0Z\0\0\0Z\0\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0_\0\0\0Z\0\0\0\x02\0\0\0A\0\x05\0A\0\0\0`\0\0\0\\\0\0\0B\0\0\0=\0\x04\0\x06\0\0\0a\0\0\0`\0\0\0O\0\x07\0\x04\0\0\0b\0\0\0a\0\0\0a\0\0\0\0\0\0\0\x01\0\0\0A\0\x05\0A\0\0\0c\0\0\0\\\0\0\0B\0\0\0=\0\x04\0\x06\0\0\0d\0\0\0c\0\0\0O\0\x07\0\x04\0\0\0e\0\0\0d\0\0\0d\0\0\0\x02\0\0\0\x03\0\0\0\x81\0\x05\0\x04\0\0\0f\0\0\0b\0\0\0e\0\0\0O\0\x07\0\x04\0\0\0g\0\0\0Z\0\0\0Z\0\0\0\0\0\0\0\x01\0\0\0\x94\0\x05\0\x03\0\0\0h\0\0\0f\0\0\0g\0\0\0\x83\0\x05\0\x03\0\0\0i\0\0\0_\0\0\0h\0\0\0P\0\x05\0\x12\0\0\0j\0\0\0^\0\0\0i\0\0\0\xFE\0\x02\0j\0\0\08\0\x01\x006\0\x05\0\x05\0\0\0m\0\0\0\0\0\0\0n\0\0\x007\0\x03\0\x12\0\0\0l\0\0\0\xF8\0\x02\0k\0\0\0;\0\x05\0s\0\0\0t\0\0\0\x07\0\0\0.\0\0\0;\0\x05\0s\0\0\0v\0\0\0\x07\0\0\0p\0\0\0;\0\x05\0s\0\0\0r\0\0\0\x07\0\0\0p\0\0\0;\0\x05\0s\0\0\0u\0\0\0\x07\0\0\0.\0\0\0A\0\x05\0-\0\0\0o\0\0\0#\0\0\0.\0\0\0\xF9\0\x02\0w\0\0\0\xF8\0\x02\0w\0\0\0P\0\x05\0\x06\0\0\0x\0\0\0l\0\0\0\x1D\0\0\0\xF9\0\x02\0y\0\0\0\xF8\0\x02\0y\0\0\0\xF6\0\x04\0z\0\0\0|\0\0\0\0\0\0\0\xF9\0\x02\0{\0\0\0\xF8\0\x02\0{\0\0\0=\0\x04\0\x05\0\0\0}\0\0\0v\0\0\0\xB0\0\x05\0\x13\0\0\0~\0\0\0}\0\0\0\t\0\0\0\xF7\0\x03\0\x7F\0\0\0\0\0\0\0\xFA\0\x04\0~\0\0\0\x7F\0\0\0\x80\0\0\0\xF8\0\x02\0\x80\0\0\0\xF9\0\x02\0z\0\0\0\xF8\0\x02\0\x7F\0\0\0\xF9\0\x02\0\x81\0\0\0\xF8\0\x02\0\x81\0\0\0=\0\x04\0\x05\0\0\0\x84\0\0\0v\0\0\0A\0\x06\0A\0\0\0\x85\0\0\0o\0\0\0.\0\0\0\x84\0\0\0=\0\x04\0\x06\0\0\0\x86\0\0\0\x85\0\0\0\x94\0\x05\0\x03\0\0\0\x87\0\0\0\x86\0\0\0x\0\0\0\xBE\0\x05\0\x13\0\0\0\x88\0\0\0\x87\0\0\0q\0\0\0=\0\x04\0\x05\0\0\0\x89\0\0\0r\0\0\0\xA9\0\x06\0\x05\0\0\0\x8A\0\0\0\x88\0\0\0\x89\0\0\0.\0\0\0>\0\x03\0r\0\0\0\x8A\0\0\0=\0\x04\0\x05\0\0\0\x8B\0\0\0t\0\0\0=\0\x04\0\x05\0\0\0\x8C\0\0\0r\0\0\0\x80\0\x05\0\x05\0\0\0\x8D\0\0\0\x8B\0\0\0\x8C\0\0\0>\0\x03\0t\0\0\0\x8D\0\0\0=\0\x04\0\x05\0\0\0\x8E\0\0\0u\0\0\0=\0\x04\0\x05\0\0\0\x8F\0\0\0v\0\0\0\xA9\0\x06\0\x05\0\0\0\x90\0\0\0\x88\0\0\0\x8F\0\0\0\x8E\0\0\0>\0\x03\0u\0\0\0\x90\0\0\0\xF9\0\x02\0\x82\0\0\0\xF8\0\x02\0\x82\0\0\0\xF9\0\x02\0|\0\0\0\xF8\0\x02\0|\0\0\0=\0\x04\0\x05\0\0\0\x91\0\0\0v\0\0\0\x80\0\x05\0\x05\0\0\0\x92\0\0\0\x91\0\0\0p\0\0\0>\0\x03\0v\0\0\0\x92\0\0\0\xF9\0\x02\0y\0\0\0\xF8\0\x02\0z\0\0\0=\0\x04\0\x05\0\0\0\x93\0\0\0u\0\0\0=\0\x04\0\x05\0\0\0\x94\0\0\0t\0\0\0A\0\x06\0A\0\0\0\x95\0\0\0o\0\0\0.\0\0\0.\0\0\0=\0\x04\0\x06\0\0\0\x96\0\0\0\x95\0\0\0\x94\0\x05\0\x03\0\0\0\x97\0\0\0\x96\0\0\0x\0\0\0\xBE\0\x05\0\x13\0\0\0\x98\0\0\0\x97\0\0\0q\0\0\0\xA9\0\x06\0\x05\0\0\0\x99\0\0\0\x98\0\0\0\x94\0\0\0\x93\0\0\0\xFE\0\x02\0\x99\0\0\08\0\x01\x006\0\x05\0\x05\0\0\0\x9C\0\0\0\0\0\0\0n\0\0\x007\0\x03\0\x12\0\0\0\x9B\0\0\0\xF8\0\x02\0\x9A\0\0\0;\0\x05\0\xA2\0\0\0\xA1\0\0\0\x07\0\0\0\x9E\0\0\0;\0\x05\0s\0\0\0\xA3\0\0\0\x07\0\0\0.\0\0\0A\0\x05\0-\0\0\0\x9D\0\0\0#\0\0\0.\0\0\0\xF9\0\x02\0\xA4\0\0\0\xF8\0\x02\0\xA4\0\0\09\0\x05\0\x05\0\0\0\xA5\0\0\0m\0\0\0\x9B\0\0\0A\0\x06\0A\0\0\0\xA6\0\0\0\x9D\0\0\0p\0\0\0\xA5\0\0\0=\0\x04\0\x06\0\0\0\xA7\0\0\0\xA6\0\0\0P\0\x05\0\x06\0\0\0\xA8\0\0\0\x9B\0\0\0\x1D\0\0\0\x94\0\x05\0\x03\0\0\0\xA9\0\0\0\xA7\0\0\0\xA8\0\0\0\xF9\0\x02\0\xAA\0\0\0\xF8\0\x02\0\xAA\0\0\0\xF6\0\x04\0\xAB\0\0\0\xAD\0\0\0\0\0\0\0\xF9\0\x02\0\xAC\0\0\0\xF8\0\x02\0\xAC\0\0\0=\0\x04\0\x05\0\0\0\xAE\0\0\0\xA3\0\0\0\xB0\0\x05\0\x13\0\0\0\xAF\0\0\0\xAE\0\0\0\x1B\0\0\0\xF7\0\x03\0\xB0\0\0\0\0\0\0\0\xFA\0\x04\0\xAF\0\0\0\xB0\0\0\0\xB1\0\0\0\xF8\0\x02\0\xB1\0\0\0\xF9\0\x02\0\xAB\0\0\0\xF8\0\x02\0\xB0\0\0\0\xF9\0\x02\0\xB2\0\0\0\xF8\0\x02\0\xB2\0\0\0\x84\0\x05\0\x05\0\0\0\xB5\0\0\0\xA5\0\0\0\x1B\0\0\0=\0\x04\0\x05\0\0\0\xB6\0\0\0\xA3\0\0\0\x80\0\x05\0\x05\0\0\0\xB7\0\0\0\xB5\0\0\0\xB6\0\0\0A\0\x06\0A\0\0\0\xB8\0\0\0\x9D\0\0\0\x1B\0\0\0\xB7\0\0\0=\0\x04\0\x06\0\0\0\xB9\0\0\0\xB8\0\0\0=\0\x04\0\x14\0\0\0\xBA\0\0\0\xA1\0\0\0P\0\x07\0\x06\0\0\0\xBB\0\0\0\xA9\0\0\0\xA9\0\0\0\xA9\0\0\0\xA9\0\0\0\xBE\0\x05\0\xBC\0\0\0\xBD\0\0\0\xBB\0\0\0\xB9\0\0\0\xA9\0\x06\0\x14\0\0\0\xBE\0\0\0\xBD\0\0\0\x9F\0\0\0\x9E\0\0\0\x80\0\x05\0\x14\0\0\0\xBF\0\0\0\xBA\0\0\0\xBE\0\0\0>\0\x03\0\xA1\0\0\0\xBF\0\0\0\xF9\0\x02\0\xB3\0\0\0\xF8\0\x02\0\xB3\0\0\0\xF9\0\x02\0\xAD\0\0\0\xF8\0\x02\0\xAD\0\0\0=\0\x04\0\x05\0\0\0\xC0\0\0\0\xA3\0\0\0\x80\0\x05\0\x05\0\0\0\xC1\0\0\0\xC0\0\0\0p\0\0\0>\0\x03\0\xA3\0\0\0\xC1\0\0\0\xF9\0\x02\0\xAA\0\0\0\xF8\0\x02\0\xAB\0\0\0\x84\0\x05\0\x05\0\0\0\xC2\0\0\0\xA5\0\0\0\x0B\0\0\0A\0\x05\0s\0\0\0\xC3\0\0\0\xA1\0\0\0.\0\0\0=\0\x04\0\x05\0\0\0\xC4\0\0\0\xC3\0\0\0A\0\x05\0s\0\0\0\xC5\0\0\0\xA1\0\0\0p\0\0\0=\0\x04\0\x05\0\0\0\xC6\0\0\0\xC5\0\0\0\x80\0\x05\0\x05\0\0\0\xC7\0\0\0\xC4\0\0\0\xC6\0\0\0A\0\x05\0s\0\0\0\xC8\0\0\0\xA1\0\0\0\x1B\0\0\0=\0\x04\0\x05\0\0\0\xC9\0\0\0\xC8\0\0\0\x80\0\x05\0\x05\0\0\0\xCA\0\0\0\xC7\0\0\0\xC9\0\0\0A\0\x05\0s\0\0\0\xCB\0\0\0\xA1\0\0\0B\0\0\0=\0\x04\0\x05\0\0\0\xCC\0\0\0\xCB\0\0\0\x80\0\x05\0\x05\0\0\0\xCD\0\0\0\xCA\0\0\0\xCC\0\0\0\x0C\0\x07\0\x05\0\0\0\xCE\0\0\0\x01\0\0\0&\0\0\0\xCD\0\0\0\xA0\0\0\0\x80\0\x05\0\x05\0\0\0\xCF\0\0\0\xC2\0\0\0\xCE\0\0\0\xFE\0\x02\0\xCF\0\0\08\0\x01\x006\0\x05\0\x07\0\0\0\xD2\0\0\0\0\0\0\0\xD3\0\0\x007\0\x03\0\x12\0\0\0\xD1\0\0\0\xF8\0\x02\0\xD0\0\0\0A\0\x05\0-\0\0\0\xD4\0\0\0#\0\0\0.\0\0\0\xF9\0\x02\0\xD5\0\0\0\xF8\0\x02\0\xD5\0\0\09\0\x05\0\x05\0\0\0\xD7\0\0\0\x9C\0\0\0\xD1\0\0\0A\0\x06\0\xD8\0\0\0\xDA\0\0\0\xD4\0\0\0\xD9\0\0\0\xD7\0\0\0=\0\x04\0\x07\0\0\0\xDB\0\0\0\xDA\0\0\0\xFE\0\x02\0\xDB\0\0\08\0\x01\x006\0\x05\0\x15\0\0\0\xDF\0\0\0\0\0\0\0\xE0\0\0\x007\0\x03\0\x07\0\0\0\xDD\0\0\x007\0\x03\0\x12\0\0\0\xDE\0\0\0\xF8\0\x02\0\xDC\0\0\0;\0\x05\0\xE3\0\0\0\xE2\0\0\0\x07\0\0\0\xE4\0\0\0;\0\x05\0\xE3\0\0\0\xE5\0\0\0\x07\0\0\0\xE6\0\0\0\xF9\0\x02\0\xE7\0\0\0\xF8\0\x02\0\xE7\0\0\0P\0\x05\0\x06\0\0\0\xE8\0\0\0\xDE\0\0\0\x1D\0\0\0Q\0\x05\0\x06\0\0\0\xE9\0\0\0\xDD\0\0\0\x03\0\0\0\x94\0\x05\0\x03\0\0\0\xEA\0\0\0\xE9\0\0\0\xE8\0\0\0Q\0\x05\0\x06\0\0\0\xEB\0\0\0\xDD\0\0\0\0\0\0\0\x94\0\x05\0\x03\0\0\0\xEC\0\0\0\xEB\0\0\0\xE8\0\0\0Q\0\x05\0\x06\0\0\0\xED\0\0\0\xDD\0\0\0\x01\0\0\0\x94\0\x05\0\x03\0\0\0\xEE\0\0\0\xED\0\0\0\xE8\0\0\0Q\0\x05\0\x06\0\0\0\xEF\0\0\0\xDD\0\0\0\x02\0\0\0\x94\0\x05\0\x03\0\0\0\xF0\0\0\0\xEF\0\0\0\xE8\0\0\0P\0\x06\0\x12\0\0\0\xF1\0\0\0\xEC\0\0\0\xEE\0\0\0\xF0\0\0\0P\0\x06\0\x12\0\0\0\xF2\0\0\0\xEA\0\0\0\xEA\0\0\0\xEA\0\0\0\x88\0\x05\0\x12\0\0\0\xF3\0\0\0\xF1\0\0\0\xF2\0\0\0O\0\x07\0\x04\0\0\0\xF4\0\0\0\xF3\0\0\0\xF3\0\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x06\0\0\0\xF5\0\0\0\xDD\0\0\0\x04\0\0\0O\0\x07\0\x04\0\0\0\xF6\0\0\0\xF5\0\0\0\xF5\0\0\0\0\0\0\0\x01\0\0\0\x85\0\x05\0\x04\0\0\0\xF7\0\0\0\xF4\0\0\0\xF6\0\0\0Q\0\x05\0\x06\0\0\0\xF8\0\0\0\xDD\0\0\0\x04\0\0\0O\0\x07\0\x04\0\0\0\xF9\0\0\0\xF8\0\0\0\xF8\0\0\0\x02\0\0\0\x03\0\0\0\x81\0\x05\0\x04\0\0\0\xFA\0\0\0\xF7\0\0\0\xF9\0\0\0Q\0\x05\0\x06\0\0\0\xFB\0\0\0\xDD\0\0\0\x05\0\0\0O\0\x07\0\x04\0\0\0\xFC\0\0\0\xFB\0\0\0\xFB\0\0\0\0\0\0\0\x01\0\0\0\xBE\0\x05\0\xFD\0\0\0\xFE\0\0\0\xFA\0\0\0\xFC\0\0\0\x9B\0\x04\0\x13\0\0\0\xFF\0\0\0\xFE\0\0\0\xF7\0\x03\0\0\x01\0\0\0\0\0\0\xFA\0\x04\0\xFF\0\0\0\x01\x01\0\0\x02\x01\0\0\xF8\0\x02\0\x01\x01\0\0Q\0\x05\0\x06\0\0\0\x03\x01\0\0\xDD\0\0\0\x05\0\0\0O\0\x07\0\x04\0\0\0\x04\x01\0\0\x03\x01\0\0\x03\x01\0\0\x02\0\0\0\x03\0\0\0\xBC\0\x05\0\xFD\0\0\0\x05\x01\0\0\xFA\0\0\0\x04\x01\0\0\x9B\0\x04\0\x13\0\0\0\x06\x01\0\0\x05\x01\0\0>\0\x03\0\xE2\0\0\0\x06\x01\0\0\xF9\0\x02\0\0\x01\0\0\xF8\0\x02\0\x02\x01\0\0>\0\x03\0\xE2\0\0\0\xE1\0\0\0\xF9\0\x02\0\0\x01\0\0\xF8\0\x02\0\0\x01\0\0=\0\x04\0\x13\0\0\0\x07\x01\0\0\xE2\0\0\0\xBA\0\x05\0\x13\0\0\0\x08\x01\0\0\xEA\0\0\0q\0\0\0\xF7\0\x03\0\t\x01\0\0\0\0\0\0\xFA\0\x04\0\x08\x01\0\0\n\x01\0\0\x0B\x01\0\0\xF8\0\x02\0\n\x01\0\0>\0\x03\0\xE5\0\0\0\x07\x01\0\0\xF9\0\x02\0\t\x01\0\0\xF8\0\x02\0\x0B\x01\0\0>\0\x03\0\xE5\0\0\0\xE1\0\0\0\xF9\0\x02\0\t\x01\0\0\xF8\0\x02\0\t\x01\0\0=\0\x04\0\x13\0\0\0\x0C\x01\0\0\xE5\0\0\0P\0\x07\0\x15\0\0\0\r\x01\0\0\xF3\0\0\0\xEA\0\0\0\xFA\0\0\0\x0C\x01\0\0\xFE\0\x02\0\r\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\x10\x01\0\0\0\0\0\0\x11\x01\0\x007\0\x03\0\x03\0\0\0\x0F\x01\0\0\xF8\0\x02\0\x0E\x01\0\0A\0\x05\0-\0\0\0\x12\x01\0\0#\0\0\0.\0\0\0\xF9\0\x02\0\x13\x01\0\0\xF8\0\x02\0\x13\x01\0\0A\0\x05\0\x14\x01\0\0\x15\x01\0\0\x12\x01\0\0\t\0\0\0=\0\x04\0\x03\0\0\0\x16\x01\0\0\x15\x01\0\0\x0C\0\x07\0\x03\0\0\0\x17\x01\0\0\x01\0\0\0%\0\0\0\x16\x01\0\0q\0\0\0A\0\x05\0\x14\x01\0\0\x18\x01\0\0\x12\x01\0\0\t\0\0\0=\0\x04\0\x03\0\0\0\x19\x01\0\0\x18\x01\0\0\x0C\0\x07\0\x03\0\0\0\x1A\x01\0\0\x01\0\0\0(\0\0\0\x19\x01\0\0q\0\0\0\x0C\0\x08\0\x03\0\0\0\x1B\x01\0\0\x01\0\0\0+\0\0\0\x0F\x01\0\0\x17\x01\0\0\x1A\x01\0\0\xFE\0\x02\0\x1B\x01\0\08\0\x01\x006\0\x05\0\x06\0\0\0\x1F\x01\0\0\0\0\0\0 \x01\0\x007\0\x03\0\x06\0\0\0\x1D\x01\0\x007\0\x03\0\x06\0\0\0\x1E\x01\0\0\xF8\0\x02\0\x1C\x01\0\0A\0\x05\0-\0\0\0!\x01\0\0#\0\0\0.\0\0\0\xF9\0\x02\0$\x01\0\0\xF8\0\x02\0$\x01\0\0A\0\x05\0\x14\x01\0\0%\x01\0\0!\x01\0\0\t\0\0\0=\0\x04\0\x03\0\0\0&\x01\0\0%\x01\0\0\x8E\0\x05\0\x06\0\0\0'\x01\0\0\x1E\x01\0\0&\x01\0\0\xBC\0\x05\0\xBC\0\0\0(\x01\0\0\x1D\x01\0\0'\x01\0\0\xA9\0\x06\0\x06\0\0\0)\x01\0\0(\x01\0\0#\x01\0\0\"\x01\0\0\xFE\0\x02\0)\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0-\x01\0\0\0\0\0\0.\x01\0\x007\0\x03\0\x16\0\0\0+\x01\0\x007\0\x03\0\x04\0\0\0,\x01\0\0\xF8\0\x02\0*\x01\0\0A\0\x05\0-\0\0\0/\x01\0\0#\0\0\0.\0\0\0\xF9\0\x02\x000\x01\0\0\xF8\0\x02\x000\x01\0\0Q\0\x05\0\x03\0\0\x001\x01\0\0+\x01\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\x002\x01\0\0+\x01\0\0\x02\0\0\0\x94\0\x05\0\x03\0\0\x003\x01\0\x002\x01\0\0,\x01\0\0\x81\0\x05\0\x03\0\0\x004\x01\0\x001\x01\0\x003\x01\0\09\0\x05\0\x03\0\0\x005\x01\0\0\x10\x01\0\x004\x01\0\0\xFE\0\x02\x005\x01\0\08\0\x01\x006\0\x05\0\x12\0\0\09\x01\0\0\0\0\0\0:\x01\0\x007\0\x03\0\x07\0\0\x007\x01\0\x007\0\x03\0\x15\0\0\08\x01\0\0\xF8\0\x02\x006\x01\0\0\xF9\0\x02\0;\x01\0\0\xF8\0\x02\0;\x01\0\0Q\0\x05\0\x06\0\0\0<\x01\0\x007\x01\0\0\x01\0\0\0O\0\x08\0\x12\0\0\0=\x01\0\0<\x01\0\0<\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0Q\0\x05\0\x12\0\0\0>\x01\0\08\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0?\x01\0\0>\x01\0\0\x01\0\0\0Q\0\x05\0\x06\0\0\0@\x01\0\x007\x01\0\0\x03\0\0\0O\0\x08\0\x12\0\0\0A\x01\0\0@\x01\0\0@\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\x8E\0\x05\0\x12\0\0\0B\x01\0\0A\x01\0\0?\x01\0\0\x83\0\x05\0\x12\0\0\0C\x01\0\0=\x01\0\0B\x01\0\0\xFE\0\x02\0C\x01\0\08\0\x01\x006\0\x05\0\x04\0\0\0H\x01\0\0\0\0\0\0I\x01\0\x007\0\x03\0\x07\0\0\0E\x01\0\x007\0\x03\0\x15\0\0\0F\x01\0\x007\0\x03\0\x12\0\0\0G\x01\0\0\xF8\0\x02\0D\x01\0\0\xF9\0\x02\0N\x01\0\0\xF8\0\x02\0N\x01\0\0Q\0\x05\0\x06\0\0\0O\x01\0\0E\x01\0\0\0\0\0\0O\0\x08\0\x12\0\0\0P\x01\0\0O\x01\0\0O\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0Q\0\x05\0\x12\0\0\0Q\x01\0\0F\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0R\x01\0\0Q\x01\0\0\0\0\0\0Q\0\x05\0\x06\0\0\0S\x01\0\0E\x01\0\0\x03\0\0\0O\0\x08\0\x12\0\0\0T\x01\0\0S\x01\0\0S\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\x8E\0\x05\0\x12\0\0\0U\x01\0\0T\x01\0\0R\x01\0\0\x83\0\x05\0\x12\0\0\0V\x01\0\0P\x01\0\0U\x01\0\09\0\x06\0\x12\0\0\0W\x01\0\09\x01\0\0E\x01\0\0F\x01\0\0Q\0\x05\0\x06\0\0\0X\x01\0\0E\x01\0\0\x02\0\0\0O\0\x08\0\x12\0\0\0Y\x01\0\0X\x01\0\0X\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0Q\0\x05\0\x12\0\0\0Z\x01\0\0F\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0[\x01\0\0Z\x01\0\0\x02\0\0\0Q\0\x05\0\x06\0\0\0\\\x01\0\0E\x01\0\0\x03\0\0\0O\0\x08\0\x12\0\0\0]\x01\0\0\\\x01\0\0\\\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\x8E\0\x05\0\x12\0\0\0^\x01\0\0]\x01\0\0[\x01\0\0\x83\0\x05\0\x12\0\0\0_\x01\0\0Y\x01\0\0^\x01\0\0\x0C\0\x07\0\x12\0\0\0`\x01\0\0\x01\0\0\0D\0\0\0V\x01\0\0W\x01\0\0\x94\0\x05\0\x03\0\0\0a\x01\0\0G\x01\0\0`\x01\0\0\x0C\0\x07\0\x12\0\0\0b\x01\0\0\x01\0\0\0D\0\0\0W\x01\0\0G\x01\0\0\x94\0\x05\0\x03\0\0\0c\x01\0\0_\x01\0\0b\x01\0\0\x0C\0\x07\0\x12\0\0\0d\x01\0\0\x01\0\0\0D\0\0\0G\x01\0\0V\x01\0\0\x94\0\x05\0\x03\0\0\0e\x01\0\0_\x01\0\0d\x01\0\0P\0\x05\0\x04\0\0\0f\x01\0\0c\x01\0\0e\x01\0\0Q\0\x05\0\x06\0\0\0g\x01\0\0E\x01\0\0\x04\0\0\0O\0\x07\0\x04\0\0\0h\x01\0\0g\x01\0\0g\x01\0\0\0\0\0\0\x01\0\0\0\x8E\0\x05\0\x04\0\0\0i\x01\0\0h\x01\0\0a\x01\0\0\x88\0\x05\0\x04\0\0\0j\x01\0\0f\x01\0\0i\x01\0\0\x0C\0\x08\0\x04\0\0\0k\x01\0\0\x01\0\0\0+\0\0\0j\x01\0\0K\x01\0\0L\x01\0\0\xB4\0\x05\0\x13\0\0\0l\x01\0\0a\x01\0\0q\0\0\0P\0\x05\0\xFD\0\0\0n\x01\0\0l\x01\0\0l\x01\0\0\xA9\0\x06\0\x04\0\0\0m\x01\0\0n\x01\0\0M\x01\0\0k\x01\0\0\xFE\0\x02\0m\x01\0\08\0\x01\x006\0\x05\0\x16\0\0\0s\x01\0\0\0\0\0\0t\x01\0\x007\0\x03\0\x07\0\0\0p\x01\0\x007\0\x03\0\x15\0\0\0q\x01\0\x007\0\x03\0\x12\0\0\0r\x01\0\0\xF8\0\x02\0o\x01\0\0\xF9\0\x02\0u\x01\0\0\xF8\0\x02\0u\x01\0\09\0\x07\0\x04\0\0\0v\x01\0\0H\x01\0\0p\x01\0\0q\x01\0\0r\x01\0\0Q\0\x05\0\x04\0\0\0w\x01\0\0q\x01\0\0\x02\0\0\0Q\0\x05\0\x12\0\0\0x\x01\0\0q\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0y\x01\0\0x\x01\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0z\x01\0\0p\x01\0\0\x06\0\0\0\x83\0\x05\0\x03\0\0\0{\x01\0\0y\x01\0\0z\x01\0\0P\0\x06\0\x16\0\0\0|\x01\0\0w\x01\0\0{\x01\0\0v\x01\0\0\xFE\0\x02\0|\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\x7F\x01\0\0\0\0\0\0\x80\x01\0\x007\0\x03\0\x16\0\0\0~\x01\0\0\xF8\0\x02\0}\x01\0\0A\0\x05\0-\0\0\0\x81\x01\0\0#\0\0\0.\0\0\0=\0\x04\0\x10\0\0\0\x82\x01\0\0&\0\0\0=\0\x04\0\x11\0\0\0\x83\x01\0\0'\0\0\0\xF9\0\x02\0\x8B\x01\0\0\xF8\0\x02\0\x8B\x01\0\0Q\0\x05\0\x04\0\0\0\x8C\x01\0\0~\x01\0\0\0\0\0\0\x83\0\x05\0\x04\0\0\0\x8D\x01\0\0\x8C\x01\0\0\x85\x01\0\0\x0C\0\x06\0\x04\0\0\0\x8E\x01\0\0\x01\0\0\0\x08\0\0\0\x8D\x01\0\0\x81\0\x05\0\x04\0\0\0\x8F\x01\0\0\x8E\x01\0\0L\x01\0\0\x88\0\x05\0\x04\0\0\0\x90\x01\0\0\x8F\x01\0\0\x1A\0\0\0V\0\x05\0\x91\x01\0\0\x92\x01\0\0\x82\x01\0\0\x83\x01\0\0`\0\x06\0\x06\0\0\0\x93\x01\0\0\x92\x01\0\0\x90\x01\0\0.\0\0\0Q\0\x05\0\x04\0\0\0\x94\x01\0\0~\x01\0\0\0\0\0\0\x83\0\x05\0\x04\0\0\0\x95\x01\0\0\x8F\x01\0\0\x94\x01\0\0\x81\0\x05\0\x04\0\0\0\x96\x01\0\0\x95\x01\0\0\x87\x01\0\09\0\x06\0\x03\0\0\0\x97\x01\0\0-\x01\0\0~\x01\0\0\x96\x01\0\0\x81\0\x05\0\x04\0\0\0\x98\x01\0\0\x95\x01\0\0\x88\x01\0\09\0\x06\0\x03\0\0\0\x99\x01\0\0-\x01\0\0~\x01\0\0\x98\x01\0\0\x81\0\x05\0\x04\0\0\0\x9A\x01\0\0\x95\x01\0\0\x89\x01\0\09\0\x06\0\x03\0\0\0\x9B\x01\0\0-\x01\0\0~\x01\0\0\x9A\x01\0\0\x81\0\x05\0\x04\0\0\0\x9C\x01\0\0\x95\x01\0\0\x8A\x01\0\09\0\x06\0\x03\0\0\0\x9D\x01\0\0-\x01\0\0~\x01\0\0\x9C\x01\0\0P\0\x07\0\x06\0\0\0\x9E\x01\0\0\x97\x01\0\0\x99\x01\0\0\x9B\x01\0\0\x9D\x01\0\09\0\x06\0\x06\0\0\0\x9F\x01\0\0\x1F\x01\0\0\x9E\x01\0\0\x93\x01\0\0\x83\0\x05\0\x04\0\0\0\xA0\x01\0\0\x85\x01\0\0\x95\x01\0\0Q\0\x05\0\x03\0\0\0\xA1\x01\0\0\x9F\x01\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\xA2\x01\0\0\x9F\x01\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\xA3\x01\0\0\xA0\x01\0\0\0\0\0\0\x0C\0\x08\0\x03\0\0\0\xA4\x01\0\0\x01\0\0\0.\0\0\0\xA1\x01\0\0\xA2\x01\0\0\xA3\x01\0\0Q\0\x05\0\x03\0\0\0\xA5\x01\0\0\x9F\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xA6\x01\0\0\x9F\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xA7\x01\0\0\xA0\x01\0\0\0\0\0\0\x0C\0\x08\0\x03\0\0\0\xA8\x01\0\0\x01\0\0\0.\0\0\0\xA5\x01\0\0\xA6\x01\0\0\xA7\x01\0\0Q\0\x05\0\x03\0\0\0\xA9\x01\0\0\xA0\x01\0\0\x01\0\0\0\x0C\0\x08\0\x03\0\0\0\xAA\x01\0\0\x01\0\0\0.\0\0\0\xA4\x01\0\0\xA8\x01\0\0\xA9\x01\0\0\xFE\0\x02\0\xAA\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xAE\x01\0\0\0\0\0\0\xAF\x01\0\x007\0\x03\0\x12\0\0\0\xAC\x01\0\x007\0\x03\0\x12\0\0\0\xAD\x01\0\0\xF8\0\x02\0\xAB\x01\0\0A\0\x05\0-\0\0\0\xB0\x01\0\0#\0\0\0.\0\0\0=\0\x04\0\x10\0\0\0\xB1\x01\0\0&\0\0\0=\0\x04\0\x11\0\0\0\xB2\x01\0\0'\0\0\0\xF9\0\x02\0\xB3\x01\0\0\xF8\0\x02\0\xB3\x01\0\09\0\x05\0\x12\0\0\0\xB4\x01\0\0+\0\0\0\xAC\x01\0\09\0\x05\0\x07\0\0\0\xB5\x01\0\0\xD2\0\0\0\xB4\x01\0\09\0\x06\0\x15\0\0\0\xB6\x01\0\0\xDF\0\0\0\xB5\x01\0\0\xB4\x01\0\0Q\0\x05\0\x13\0\0\0\xB7\x01\0\0\xB6\x01\0\0\x03\0\0\0\xA8\0\x04\0\x13\0\0\0\xB8\x01\0\0\xB7\x01\0\0\xF7\0\x03\0\xB9\x01\0\0\0\0\0\0\xFA\0\x04\0\xB8\x01\0\0\xBA\x01\0\0\xB9\x01\0\0\xF8\0\x02\0\xBA\x01\0\0\xFE\0\x02\0\x1D\0\0\0\xF8\0\x02\0\xB9\x01\0\09\0\x05\0\x12\0\0\0\xBB\x01\0\0[\0\0\0\xAD\x01\0\09\0\x07\0\x16\0\0\0\xBC\x01\0\0s\x01\0\0\xB5\x01\0\0\xB6\x01\0\0\xBB\x01\0\09\0\x05\0\x03\0\0\0\xBD\x01\0\0\x7F\x01\0\0\xBC\x01\0\0\xFE\0\x02\0\xBD\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xC0\x01\0\0\0\0\0\0\xC1\x01\0\x007\0\x03\0\x17\0\0\0\xBF\x01\0\0\xF8\0\x02\0\xBE\x01\0\0A\0\x05\0\xC2\x01\0\0\xC3\x01\0\0\x1E\0\0\0.\0\0\0=\0\x04\0\x10\0\0\0\xC4\x01\0\0!\0\0\0\xF9\0\x02\0\xC6\x01\0\0\xF8\0\x02\0\xC6\x01\0\0_\0\x07\0\x06\0\0\0\xC7\x01\0\0\xC4\x01\0\0\xBF\x01\0\0\x02\0\0\0\xC5\x01\0\0Q\0\x05\0\x03\0\0\0\xC8\x01\0\0\xC7\x01\0\0\0\0\0\0A\0\x06\0\x14\x01\0\0\xCA\x01\0\0\xC3\x01\0\0B\0\0\0.\0\0\0=\0\x04\0\x03\0\0\0\xCB\x01\0\0\xCA\x01\0\0\x85\0\x05\0\x03\0\0\0\xCC\x01\0\0\xC8\x01\0\0\xCB\x01\0\0A\0\x06\0\x14\x01\0\0\xCD\x01\0\0\xC3\x01\0\0B\0\0\0p\0\0\0=\0\x04\0\x03\0\0\0\xCE\x01\0\0\xCD\x01\0\0\x81\0\x05\0\x03\0\0\0\xCF\x01\0\0\xCC\x01\0\0\xCE\x01\0\0\xBA\0\x05\0\x13\0\0\0\xD0\x01\0\0\xC8\x01\0\0q\0\0\0\xA9\0\x06\0\x03\0\0\0\xD1\x01\0\0\xD0\x01\0\0\xCF\x01\0\0q\0\0\0\xFE\0\x02\0\xD1\x01\0\08\0\x01\x006\0\x05\0\x12\0\0\0\xD4\x01\0\0\0\0\0\0\xD5\x01\0\x007\0\x03\0\x04\0\0\0\xD3\x01\0\0\xF8\0\x02\0\xD2\x01\0\0A\0\x05\0\xC2\x01\0\0\xD6\x01\0\0\x1E\0\0\0.\0\0\0=\0\x04\0\x10\0\0\0\xD7\x01\0\0!\0\0\0\xF9\0\x02\0\xD8\x01\0\0\xF8\0\x02\0\xD8\x01\0\0g\0\x05\0\xD9\x01\0\0\xDA\x01\0\0\xD7\x01\0\0.\0\0\0p\0\x04\0\x04\0\0\0\xDB\x01\0\0\xDA\x01\0\0\x88\0\x05\0\x04\0\0\0\xDC\x01\0\0\xD3\x01\0\0\xDB\x01\0\0A\0\x05\0A\0\0\0\xDD\x01\0\0\xD6\x01\0\0.\0\0\0=\0\x04\0\x06\0\0\0\xDE\x01\0\0\xDD\x01\0\0O\0\x08\0\x12\0\0\0\xDF\x01\0\0\xDE\x01\0\0\xDE\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0A\0\x05\0A\0\0\0\xE0\x01\0\0\xD6\x01\0\0p\0\0\0=\0\x04\0\x06\0\0\0\xE1\x01\0\0\xE0\x01\0\0O\0\x08\0\x12\0\0\0\xE2\x01\0\0\xE1\x01\0\0\xE1\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\xE3\x01\0\0\xDC\x01\0\0\0\0\0\0\x8E\0\x05\0\x12\0\0\0\xE4\x01\0\0\xE2\x01\0\0\xE3\x01\0\0\x81\0\x05\0\x12\0\0\0\xE5\x01\0\0\xDF\x01\0\0\xE4\x01\0\0A\0\x05\0A\0\0\0\xE6\x01\0\0\xD6\x01\0\0\x1B\0\0\0=\0\x04\0\x06\0\0\0\xE7\x01\0\0\xE6\x01\0\0O\0\x08\0\x12\0\0\0\xE8\x01\0\0\xE7\x01\0\0\xE7\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\xE9\x01\0\0\xDC\x01\0\0\x01\0\0\0\x8E\0\x05\0\x12\0\0\0\xEA\x01\0\0\xE8\x01\0\0\xE9\x01\0\0\x81\0\x05\0\x12\0\0\0\xEB\x01\0\0\xE5\x01\0\0\xEA\x01\0\0\xFE\0\x02\0\xEB\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xF0\x01\0\0\0\0\0\0\xF1\x01\0\x007\0\x03\0\x17\0\0\0\xED\x01\0\x007\0\x03\0\x17\0\0\0\xEE\x01\0\x007\0\x03\0\x03\0\0\0\xEF\x01\0\0\xF8\0\x02\0\xEC\x01\0\0;\0\x05\0\xE3\0\0\0\xFA\x01\0\0\x07\0\0\0\xFB\x01\0\0;\0\x05\0\xE3\0\0\0\xFC\x01\0\0\x07\0\0\0\xFD\x01\0\0A\0\x05\0\xC2\x01\0\0\xF2\x01\0\0\x1E\0\0\0.\0\0\0=\0\x04\0\x10\0\0\0\xF3\x01\0\0!\0\0\0\xF9\0\x02\0\xFE\x01\0\0\xF8\0\x02\0\xFE\x01\0\0g\0\x05\0\xD9\x01\0\0\xFF\x01\0\0\xF3\x01\0\0.\0\0\0|\0\x04\0\x17\0\0\0\0\x02\0\0\xFF\x01\0\0\x82\0\x05\0\x17\0\0\0\x01\x02\0\0\0\x02\0\0\xF5\x01\0\0\x82\0\x05\0\x17\0\0\0\x02\x02\0\0\xED\x01\0\0\xEE\x01\0\0\x0C\0\x07\0\x17\0\0\0\x03\x02\0\0\x01\0\0\0*\0\0\0\x02\x02\0\0\xF6\x01\0\09\0\x05\0\x03\0\0\0\x04\x02\0\0\xC0\x01\0\0\x03\x02\0\0P\0\x05\0\x17\0\0\0\x06\x02\0\0\xF7\x01\0\0\xF7\x01\0\0\x84\0\x05\0\x17\0\0\0\x05\x02\0\0\xEE\x01\0\0\x06\x02\0\0\x82\0\x05\0\x17\0\0\0\x07\x02\0\0\xED\x01\0\0\x05\x02\0\0\x0C\0\x07\0\x17\0\0\0\x08\x02\0\0\x01\0\0\0*\0\0\0\x07\x02\0\0\xF6\x01\0\09\0\x05\0\x03\0\0\0\t\x02\0\0\xC0\x01\0\0\x08\x02\0\0\x80\0\x05\0\x17\0\0\0\n\x02\0\0\xED\x01\0\0\xEE\x01\0\0\x0C\0\x07\0\x17\0\0\0\x0B\x02\0\0\x01\0\0\0'\0\0\0\n\x02\0\0\x01\x02\0\09\0\x05\0\x03\0\0\0\x0C\x02\0\0\xC0\x01\0\0\x0B\x02\0\0P\0\x05\0\x17\0\0\0\x0E\x02\0\0\xF7\x01\0\0\xF7\x01\0\0\x84\0\x05\0\x17\0\0\0\r\x02\0\0\xEE\x01\0\0\x0E\x02\0\0\x80\0\x05\0\x17\0\0\0\x0F\x02\0\0\xED\x01\0\0\r\x02\0\0\x0C\0\x07\0\x17\0\0\0\x10\x02\0\0\x01\0\0\0'\0\0\0\x0F\x02\0\0\x01\x02\0\09\0\x05\0\x03\0\0\0\x11\x02\0\0\xC0\x01\0\0\x10\x02\0\0\x85\0\x05\0\x03\0\0\0\x12\x02\0\0\xF8\x01\0\0\x04\x02\0\0\x83\0\x05\0\x03\0\0\0\x13\x02\0\0\x12\x02\0\0\t\x02\0\0\x83\0\x05\0\x03\0\0\0\x14\x02\0\0\x13\x02\0\0\xEF\x01\0\0\x0C\0\x06\0\x03\0\0\0\x15\x02\0\0\x01\0\0\0\x04\0\0\0\x14\x02\0\0\x85\0\x05\0\x03\0\0\0\x16\x02\0\0\xF8\x01\0\0\x0C\x02\0\0\x83\0\x05\0\x03\0\0\0\x17\x02\0\0\x16\x02\0\0\x11\x02\0\0\x83\0\x05\0\x03\0\0\0\x18\x02\0\0\x17\x02\0\0\xEF\x01\0\0\x0C\0\x06\0\x03\0\0\0\x19\x02\0\0\x01\0\0\0\x04\0\0\0\x18\x02\0\0P\0\x05\0\x17\0\0\0\x1B\x02\0\0\xF7\x01\0\0\xF7\x01\0\0\x84\0\x05\0\x17\0\0\0\x1A\x02\0\0\xEE\x01\0\0\x1B\x02\0\0\x82\0\x05\0\x17\0\0\0\x1C\x02\0\0\xED\x01\0\0\x1A\x02\0\0\xB1\0\x05\0\xFD\0\0\0\x1D\x02\0\0\x1C\x02\0\0\xF6\x01\0\0\x9A\0\x04\0\x13\0\0\0\x1E\x02\0\0\x1D\x02\0\0P\0\x05\0\x17\0\0\0 \x02\0\0\xF7\x01\0\0\xF7\x01\0\0\x84\0\x05\0\x17\0\0\0\x1F\x02\0\0\xEE\x01\0\0 \x02\0\0\x80\0\x05\0\x17\0\0\0!\x02\0\0\xED\x01\0\0\x1F\x02\0\0\xAD\0\x05\0\xFD\0\0\0\"\x02\0\0!\x02\0\0\x01\x02\0\0\x9A\0\x04\0\x13\0\0\0#\x02\0\0\"\x02\0\0\xA8\0\x04\0\x13\0\0\0$\x02\0\0\x1E\x02\0\0\xF7\0\x03\0%\x02\0\0\0\0\0\0\xFA\0\x04\0$\x02\0\0&\x02\0\0'\x02\0\0\xF8\0\x02\0&\x02\0\0\xA8\0\x04\0\x13\0\0\0(\x02\0\0#\x02\0\0\xF7\0\x03\0)\x02\0\0\0\0\0\0\xFA\0\x04\0(\x02\0\0*\x02\0\0+\x02\0\0\xF8\0\x02\0*\x02\0\0\xBC\0\x05\0\x13\0\0\0,\x02\0\0\x15\x02\0\0\x19\x02\0\0>\0\x03\0\xFC\x01\0\0,\x02\0\0\xF9\0\x02\0)\x02\0\0\xF8\0\x02\0+\x02\0\0>\0\x03\0\xFC\x01\0\0\xF9\x01\0\0\xF9\0\x02\0)\x02\0\0\xF8\0\x02\0)\x02\0\0=\0\x04\0\x13\0\0\0-\x02\0\0\xFC\x01\0\0>\0\x03\0\xFA\x01\0\0-\x02\0\0\xF9\0\x02\0%\x02\0\0\xF8\0\x02\0'\x02\0\0>\0\x03\0\xFA\x01\0\0\xE1\0\0\0\xF9\0\x02\0%\x02\0\0\xF8\0\x02\0%\x02\0\0=\0\x04\0\x13\0\0\0.\x02\0\0\xFA\x01\0\0\x83\0\x05\0\x03\0\0\0/\x02\0\0\x0C\x02\0\0\xEF\x01\0\0\x83\0\x05\0\x03\0\0\x000\x02\0\0\xEF\x01\0\0\x04\x02\0\0\xA9\0\x06\0\x03\0\0\x001\x02\0\0.\x02\0\x000\x02\0\0/\x02\0\0\xFE\0\x02\x001\x02\0\08\0\x01\x006\0\x05\0\x12\0\0\x006\x02\0\0\0\0\0\x007\x02\0\x007\0\x03\0\x17\0\0\x003\x02\0\x007\0\x03\0\x12\0\0\x004\x02\0\x007\0\x03\0\x03\0\0\x005\x02\0\0\xF8\0\x02\x002\x02\0\0A\0\x05\0\xC2\x01\0\08\x02\0\0\x1E\0\0\0.\0\0\0=\0\x04\0\x10\0\0\09\x02\0\0!\0\0\0\xF9\0\x02\0<\x02\0\0\xF8\0\x02\0<\x02\0\0g\0\x05\0\xD9\x01\0\0=\x02\0\09\x02\0\0.\0\0\0p\0\x04\0\x04\0\0\0>\x02\0\0=\x02\0\09\0\x07\0\x03\0\0\0?\x02\0\0\xF0\x01\0\x003\x02\0\0:\x02\0\x005\x02\0\0Q\0\x05\0\x03\0\0\0@\x02\0\0>\x02\0\0\0\0\0\0\x85\0\x05\0\x03\0\0\0A\x02\0\0?\x02\0\0@\x02\0\09\0\x07\0\x03\0\0\0B\x02\0\0\xF0\x01\0\x003\x02\0\0;\x02\0\x005\x02\0\0Q\0\x05\0\x03\0\0\0C\x02\0\0>\x02\0\0\x01\0\0\0\x85\0\x05\0\x03\0\0\0D\x02\0\0B\x02\0\0C\x02\0\0A\0\x05\0A\0\0\0E\x02\0\08\x02\0\0p\0\0\0=\0\x04\0\x06\0\0\0F\x02\0\0E\x02\0\0O\0\x08\0\x12\0\0\0G\x02\0\0F\x02\0\0F\x02\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0A\0\x05\0A\0\0\0H\x02\0\08\x02\0\0\x1B\0\0\0=\0\x04\0\x06\0\0\0I\x02\0\0H\x02\0\0O\0\x08\0\x12\0\0\0J\x02\0\0I\x02\0\0I\x02\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\x0C\0\x07\0\x12\0\0\0K\x02\0\0\x01\0\0\0D\0\0\0G\x02\0\0J\x02\0\0\x8E\0\x05\0\x12\0\0\0L\x02\0\0K\x02\0\x005\x02\0\0\x0C\0\x07\0\x12\0\0\0M\x02\0\0\x01\0\0\0D\0\0\0J\x02\0\x004\x02\0\0\x8E\0\x05\0\x12\0\0\0N\x02\0\0M\x02\0\0A\x02\0\0\x81\0\x05\0\x12\0\0\0O\x02\0\0L\x02\0\0N\x02\0\0\x0C\0\x07\0\x12\0\0\0P\x02\0\0\x01\0\0\0D\0\0\x004\x02\0\0G\x02\0\0\x8E\0\x05\0\x12\0\0\0Q\x02\0\0P\x02\0\0D\x02\0\0\x81\0\x05\0\x12\0\0\0R\x02\0\0O\x02\0\0Q\x02\0\0\x7F\0\x04\0\x12\0\0\0S\x02\0\0R\x02\0\0\x94\0\x05\0\x03\0\0\0T\x02\0\0R\x02\0\x004\x02\0\0\xBA\0\x05\0\x13\0\0\0U\x02\0\0T\x02\0\0q\0\0\0P\0\x06\0W\x02\0\0X\x02\0\0U\x02\0\0U\x02\0\0U\x02\0\0\xA9\0\x06\0\x12\0\0\0V\x02\0\0X\x02\0\0S\x02\0\0R\x02\0\0\x0C\0\x06\0\x12\0\0\0Y\x02\0\0\x01\0\0\0E\0\0\0V\x02\0\0\xFE\0\x02\0Y\x02\0\08\0\x01\x006\0\x05\0\x02\0\0\0`\x02\0\0\0\0\0\0a\x02\0\0\xF8\0\x02\0Z\x02\0\0=\0\x04\0\x05\0\0\0]\x02\0\0[\x02\0\0\xF9\0\x02\0d\x02\0\0\xF8\0\x02\0d\x02\0\0\xAA\0\x05\0\x13\0\0\0e\x02\0\0]\x02\0\0\x1B\0\0\0\xA9\0\x06\0\x03\0\0\0f\x02\0\0e\x02\0\0b\x02\0\0J\x01\0\0\xAA\0\x05\0\x13\0\0\0g\x02\0\0]\x02\0\0p\0\0\0\xA9\0\x06\0\x03\0\0\0h\x02\0\0g\x02\0\0c\x02\0\0\x1D\0\0\0P\0\x07\0\x06\0\0\0i\x02\0\0f\x02\0\0h\x02\0\0q\0\0\0\x1D\0\0\0>\0\x03\0^\x02\0\0i\x02\0\0\xFD\0\x01\08\0\x01\x006\0\x05\0\x02\0\0\0o\x02\0\0\0\0\0\0a\x02\0\0\xF8\0\x02\0j\x02\0\0=\0\x04\0\x06\0\0\0m\x02\0\0k\x02\0\0A\0\x05\0\xC2\x01\0\0p\x02\0\0\x1E\0\0\0.\0\0\0=\0\x04\0\x10\0\0\0q\x02\0\0!\0\0\0A\0\x05\0-\0\0\0r\x02\0\0#\0\0\0.\0\0\0=\0\x04\0\x10\0\0\0s\x02\0\0&\0\0\0=\0\x04\0\x11\0\0\0t\x02\0\0'\0\0\0\xF9\0\x02\0v\x02\0\0\xF8\0\x02\0v\x02\0\0O\0\x07\0\x04\0\0\0w\x02\0\0m\x02\0\0m\x02\0\0\0\0\0\0\x01\0\0\0\x0C\0\x08\0\x04\0\0\0|\x02\0\0\x01\0\0\0+\0\0\0w\x02\0\0y\x02\0\0{\x02\0\0n\0\x04\0\x17\0\0\0}\x02\0\0|\x02\0\09\0\x05\0\x03\0\0\0~\x02\0\0\xC0\x01\0\0}\x02\0\0\xBC\0\x05\0\x13\0\0\0\x7F\x02\0\0~\x02\0\0q\0\0\0\xF7\0\x03\0\x80\x02\0\0\0\0\0\0\xFA\0\x04\0\x7F\x02\0\0\x81\x02\0\0\x80\x02\0\0\xF8\0\x02\0\x81\x02\0\0>\0\x03\0n\x02\0\0u\x02\0\0\xFD\0\x01\0\xF8\0\x02\0\x80\x02\0\0O\0\x07\0\x04\0\0\0\x82\x02\0\0m\x02\0\0m\x02\0\0\0\0\0\0\x01\0\0\09\0\x05\0\x12\0\0\0\x83\x02\0\0\xD4\x01\0\0\x82\x02\0\0O\0\x07\0\x04\0\0\0\x84\x02\0\0m\x02\0\0m\x02\0\0\0\0\0\0\x01\0\0\0\x0C\0\x08\0\x04\0\0\0\x85\x02\0\0\x01\0\0\0+\0\0\0\x84\x02\0\0y\x02\0\0{\x02\0\0n\0\x04\0\x17\0\0\0\x86\x02\0\0\x85\x02\0\09\0\x07\0\x12\0\0\0\x87\x02\0\x006\x02\0\0\x86\x02\0\0\x83\x02\0\0~\x02\0\0P\0\x06\0\x12\0\0\0\x88\x02\0\0~\x02\0\0~\x02\0\0~\x02\0\0\x88\0\x05\0\x12\0\0\0\x89\x02\0\0\x83\x02\0\0\x88\x02\0\09\0\x06\0\x03\0\0\0\x8A\x02\0\0\xAE\x01\0\0\x89\x02\0\0\x87\x02\0\0P\0\x07\0\x06\0\0\0\x8B\x02\0\0\x8A\x02\0\0q\0\0\0q\0\0\0\x1D\0\0\0>\0\x03\0n\x02\0\0\x8B\x02\0\0\xFD\0\x01\08\0\x01\0";
    /// WGSL of the function shader.
    pub const FUNCTION_WGSL: &str = r#"// Planes: visibility of a point, for the engine's own materials.
// Positions and normals are relative to the eye, in camera axes: x right, y up, looking along -z.
// Both cases of the camera space paper behind one shader: every plan takes four planes or one, whichever promises the
// smaller footprint, here with the bands that the paper does not have.
// Generated from light case `Planes`, f580f15ac2a7262b. Do not edit.

/// Width and height of the map in texels.
const PLANES_MAP_SIZE: vec2<f32> = vec2<f32>(2048.0, 2048.0);
/// Sectors around the eye.
const PLANES_SECTORS: u32 = 4u;
/// Bands of distance in each sector.
const PLANES_BANDS: u32 = 8u;
/// Vectors of four band limits in each sector.
const PLANES_THRESHOLD_VECTORS: u32 = 2u;

/// What resolving needs of one facet; all zero where a plan has none.
struct PlanesFacet {
    /// Clip x of the tile, to the right.
    row_x: vec4<f32>,
    /// Clip y of the tile, upwards.
    row_y: vec4<f32>,
    /// Clip z: depth along the light times w.
    row_z: vec4<f32>,
    /// Clip w, positive on receivers.
    row_w: vec4<f32>,
    /// Map texel coordinates = clip space after division * xy + zw.
    texel_from_ndc: vec4<f32>,
    /// Smallest (xy) and largest (zw) map texel coordinates of the facet's receivers.
    texel_limits: vec4<f32>,
    /// Depth by which an exact receiver plane is lowered.
    receiver_plane_depth: f32,
}

/// What resolving needs of a plan.
struct PlanesShadow {
    /// Border rows of the sectors, in walking order; the first closes the ring.
    borders: array<vec4<f32>, 4>,
    /// Distance row of each sector.
    distances: array<vec4<f32>, 4>,
    /// Ascending band limits of each sector, four to a vector; unused ones are out of reach.
    thresholds: array<vec4<f32>, 8>,
    /// What x and y gain per z by the shear along the light: twelve leading bits, then the rest.
    shear: vec4<f32>,
    /// 1 where stored depth grows away from the light, -1 where it falls.
    depth_sign: f32,
    /// The facets: cell = (half * sectors + sector) * bands + band.
    facets: array<PlanesFacet, 32>,
}

/// The plan.
@group(2) @binding(0)
var<uniform> planes_shadow: PlanesShadow;
/// The shadow map.
@group(2) @binding(1)
var planes_map: texture_depth_2d;
/// Takes the nearest texel, clamps to the edge.
@group(2) @binding(2)
var planes_map_sampler: sampler;

/// Two to the power of -23: the last bit of a float's mantissa.
const PLANES_LAST_BIT: f32 = 1.1920928955078125e-7;

/// The position as facet rows take it: moved along the light to the plane z = 0, z kept.
///
/// What is added may cancel the position nearly, so its products must not be rounded, and a fused multiplication is not
/// to be had everywhere. The leading parts of the shear have twelve bits; so have both halves of z. The lower half is
/// taken as a whole number, from which no compiler finds the way back to one rounded product.
fn planes_facet_position(position: vec3<f32>) -> vec3<f32> {
    // Split z.
    let bits = bitcast<u32>(position.z);
    let upper = bitcast<f32>(bits & 0xfffff000u);
    let lower = f32(bits & 0xfffu);
    let step = bitcast<f32>(bits & 0xff800000u) * PLANES_LAST_BIT;

    // Add the largest product first: each sum is exact while it cancels.
    var moved = position.xy + planes_shadow.shear.xy * upper;
    moved += (planes_shadow.shear.xy * step) * lower;
    moved += planes_shadow.shear.zw * position.z;
    return vec3<f32>(moved, position.z);
}

/// The normal as facet rows take it.
fn planes_facet_normal(normal: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(normal.xy, normal.z - dot(planes_shadow.shear.xy + planes_shadow.shear.zw, normal.xy));
}

/// Finds the sector of a receiver: its first border decides the direction, then each border is passed or not.
fn planes_sector_index(position: vec3<f32>) -> u32 {
    let point = vec4<f32>(position, 1.0);

    // Walk forwards from the ring's start up to the first border that is not passed, and backwards from its end down to
    // the first that is: both at once, without a branch.
    var is_ahead = 1u;
    var forwards = 0u;
    var backwards = 0u;
    for (var border = 1u; border < PLANES_SECTORS; border += 1u) {
        let is_passed = dot(planes_shadow.borders[border], point) >= 0.0;
        is_ahead = select(0u, is_ahead, is_passed);
        forwards += is_ahead;
        backwards = select(backwards, border, is_passed);
    }
    return select(backwards, forwards, dot(planes_shadow.borders[0], point) >= 0.0);
}

/// Finds the facet of a receiver: its sector, then the number of that sector's thresholds that its distance has
/// reached.
fn planes_facet_index(position: vec3<f32>) -> u32 {
    let sector = planes_sector_index(position);
    let distance = dot(planes_shadow.distances[sector], vec4<f32>(position, 1.0));
    var reached = vec4<u32>(0u);
    for (var index = 0u; index < PLANES_THRESHOLD_VECTORS; index += 1u) {
        let limits = planes_shadow.thresholds[sector * PLANES_THRESHOLD_VECTORS + index];
        reached += select(vec4<u32>(0u), vec4<u32>(1u), vec4<f32>(distance) >= limits);
    }
    return sector * PLANES_BANDS + min(reached.x + reached.y + reached.z + reached.w, PLANES_BANDS - 1u);
}

/// The facet of a receiver.
fn planes_own_facet(position: vec3<f32>) -> PlanesFacet {
    return planes_shadow.facets[planes_facet_index(position)];
}

/// Where a receiver falls in its facet.
struct PlanesPlace {
    /// Clip space of the tile after division: x and y in [-1, 1], z growing away from the light.
    ndc: vec3<f32>,
    /// What was divided by.
    w: f32,
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Whether every texel that a filter takes here belongs to the tile.
    covered: bool,
}

/// Applies a facet's matrix, row by row, to a position relative to the eye.
fn planes_place_in_facet(facet: PlanesFacet, position: vec3<f32>) -> PlanesPlace {
    let point = vec4<f32>(position, 1.0);
    let w = dot(facet.row_w, point);
    let clip = vec3<f32>(dot(facet.row_x, point), dot(facet.row_y, point), dot(facet.row_z, point));
    let ndc = clip / w;
    let texel = ndc.xy * facet.texel_from_ndc.xy + facet.texel_from_ndc.zw;

    // Facets without receivers are all zero, so w refuses them.
    let inside = all(texel >= facet.texel_limits.xy) && all(texel <= facet.texel_limits.zw);
    return PlanesPlace(ndc, w, texel, w > 0.0 && inside);
}

/// The nearest signed depth that the map can hold.
fn planes_held_depth(depth: f32) -> f32 {
    return clamp(depth, min(planes_shadow.depth_sign, 0.0), max(planes_shadow.depth_sign, 0.0));
}

/// Share of light that each of four stored depths lets through to its signed reference: all or none.
fn planes_lit_by_four(references: vec4<f32>, stored: vec4<f32>) -> vec4<f32> {
    return select(vec4<f32>(0.0), vec4<f32>(1.0), references <= planes_shadow.depth_sign * stored);
}

/// A receiver in the map, with its plane.
struct PlanesReceiver {
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Depth of the lowered plane at the receiver itself.
    reference: f32,
    /// Change of the plane's depth per texel along x and y.
    gradient: vec2<f32>,
}

/// Depth of the receiver's plane at an offset in texels, within the depths that the map can hold.
fn planes_plane_reference(receiver: PlanesReceiver, offset: vec2<f32>) -> f32 {
    return planes_held_depth(receiver.reference + dot(receiver.gradient, offset));
}

/// Gradient of clip y after division, times w.
fn planes_up_gradient(facet: PlanesFacet, place: PlanesPlace) -> vec3<f32> {
    return facet.row_y.xyz - place.ndc.y * facet.row_w.xyz;
}

/// Largest change of depth from one texel to the next that a plane is followed to: the map's whole range.
const PLANES_STEEPEST_PLANE: f32 = 1.0;

/// Change of depth per texel along x and y over the plane through a receiver; a normal of any length will do.
fn planes_plane_gradient(facet: PlanesFacet, place: PlanesPlace, normal: vec3<f32>) -> vec2<f32> {
    // Take the gradients of the facet's coordinates; their common factor 1/w cancels below.
    let across = facet.row_x.xyz - place.ndc.x * facet.row_w.xyz;
    let up = planes_up_gradient(facet, place);
    let away = facet.row_z.xyz - place.ndc.z * facet.row_w.xyz;

    // Solve for the depth that x and y change by while the point stays on the plane.
    let area = dot(normal, cross(across, up));
    let slope = vec2<f32>(dot(away, cross(up, normal)), dot(away, cross(normal, across)));

    // Turn it into depth per texel; a plane that the light only grazes is as steep as the map allows.
    let exact = slope / (area * facet.texel_from_ndc.xy);
    let followed = clamp(exact, vec2<f32>(-PLANES_STEEPEST_PLANE), vec2<f32>(PLANES_STEEPEST_PLANE));
    return select(followed, vec2<f32>(0.0), area == 0.0);
}

/// The receiver with the plane through it; a normal of any length will do.
fn planes_biased_receiver(facet: PlanesFacet, place: PlanesPlace, normal: vec3<f32>) -> PlanesReceiver {
    let gradient = planes_plane_gradient(facet, place, normal);
    return PlanesReceiver(place.texel, place.ndc.z - facet.receiver_plane_depth, gradient);
}

/// Share of light that reaches the receiver.
fn planes_filtered_visibility(receiver: PlanesReceiver) -> f32 {
    // Gather around the corner that the four texels share: rounding cannot reach another four from there.
    let corner = floor(receiver.texel - 0.5) + 1.0;
    let stored = textureGather(planes_map, planes_map_sampler, corner / PLANES_MAP_SIZE);

    // Follow the plane to each centre; a gather begins at the lower left and runs against the clock.
    let offset = corner - receiver.texel;
    let references = vec4<f32>(
        planes_plane_reference(receiver, offset + vec2<f32>(-0.5, 0.5)),
        planes_plane_reference(receiver, offset + vec2<f32>(0.5, 0.5)),
        planes_plane_reference(receiver, offset + vec2<f32>(0.5, -0.5)),
        planes_plane_reference(receiver, offset + vec2<f32>(-0.5, -0.5)),
    );

    // Compare, then blend.
    let lit = planes_lit_by_four(references, stored);
    let weight = vec2<f32>(0.5) - offset;
    return mix(mix(lit.w, lit.z, weight.x), mix(lit.x, lit.y, weight.x), weight.y);
}

/// Share of the light that reaches a receiver: 1 in the light and outside the map, 0 in shadow.
///
/// `position` is relative to the eye, in metres; `normal` is the geometric normal there; both are in the case's axes.
/// The function takes no derivatives, so any control flow may call it.
fn planes_visibility(position: vec3<f32>, normal: vec3<f32>) -> f32 {
    let point = planes_facet_position(position);
    let facet = planes_own_facet(point);
    let place = planes_place_in_facet(facet, point);
    if !place.covered {
        return 1.0;
    }
    return planes_filtered_visibility(planes_biased_receiver(facet, place, planes_facet_normal(normal)));
}
"#;
}
