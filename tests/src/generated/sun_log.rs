// Generated from light case `SunLog`, ed72eb4d5233de5a. Do not edit.

/// Sun over an open world without a step: face columns whose rows run with the logarithm of distance, casters that
/// span many rows decided pixel by pixel.
///
/// Tables and shaders of light case `SunLog`.
#[allow(dead_code, unreachable_pub, clippy::all, clippy::pedantic, clippy::nursery)]
pub mod sun_log {
    /// The declaration.
    pub fn case() -> ::cssm::core::LightCase {
        use ::cssm::core::case::*;
        use ::cssm::core::schema::*;
        LightCase {
            name: "SunLog".into(),
            doc: "Sun over an open world without a step: face columns whose rows run with the logarithm of distance, casters that\nspan many rows decided pixel by pixel."
                .into(),
            public: true,
            light: LightKind::Directional,
            far: FarKind::Infinite,
            shadow_distance_metres: None,
            scene_bounds: false,
            technique: Word::plain("camera_space"),
            configurations: Vec::from([Word::plain("face_columns")]),
            distribution: Some(
                Word::with(
                    "logarithmic",
                    [("horizon", Value::Number(100000.0)), ("folds", Value::Count(8))],
                ),
            ),
            stretch: Stretch::Exact {
                bound_texels: 0.25,
            },
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
            prefix: "sun_log".into(),
        }
    }
    /// Width and height of the map in texels.
    pub const SUN_LOG_MAP_SIZE: [f32; 2] = [2048.0, 2048.0];
    /// Sectors around the eye.
    pub const SUN_LOG_SECTORS: u32 = 4;
    /// Bands of distance in each sector.
    pub const SUN_LOG_BANDS: u32 = 8;
    /// Vectors of four band limits in each sector.
    pub const SUN_LOG_THRESHOLD_VECTORS: u32 = 2;
    /// Texels along the rows that edges of casters may be off.
    pub const SUN_LOG_STRETCH_BOUND: f32 = 0.25;
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
    pub struct SunLogFacet {
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
        /// How y/w becomes clip y: shifts and scales of a monotone curve.
        pub remap: [[f32; 4]; 2],
    }
    const _: () = {
        let size_bytes = ::core::mem::size_of::<SunLogFacet>();
        assert!(size_bytes == 144);
        assert!(::core::mem::offset_of!(SunLogFacet, row_x) == 0);
        assert!(::core::mem::offset_of!(SunLogFacet, row_y) == 16);
        assert!(::core::mem::offset_of!(SunLogFacet, row_z) == 32);
        assert!(::core::mem::offset_of!(SunLogFacet, row_w) == 48);
        assert!(::core::mem::offset_of!(SunLogFacet, texel_from_ndc) == 64);
        assert!(::core::mem::offset_of!(SunLogFacet, texel_limits) == 80);
        assert!(::core::mem::offset_of!(SunLogFacet, receiver_plane_depth) == 96);
        assert!(::core::mem::offset_of!(SunLogFacet, remap) == 112);
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
    pub struct SunLogShadow {
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
        pub facets: [SunLogFacet; 32],
    }
    const _: () = {
        let size_bytes = ::core::mem::size_of::<SunLogShadow>();
        assert!(size_bytes == 4896);
        assert!(::core::mem::offset_of!(SunLogShadow, borders) == 0);
        assert!(::core::mem::offset_of!(SunLogShadow, distances) == 64);
        assert!(::core::mem::offset_of!(SunLogShadow, thresholds) == 128);
        assert!(::core::mem::offset_of!(SunLogShadow, shear) == 256);
        assert!(::core::mem::offset_of!(SunLogShadow, depth_sign) == 272);
        assert!(::core::mem::offset_of!(SunLogShadow, facets) == 288);
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
    pub struct SunLogCapture {
        /// Clip x of the tile, to the right.
        pub row_x: [f32; 4],
        /// Clip y of the tile, upwards.
        pub row_y: [f32; 4],
        /// Clip z: depth along the light times w.
        pub row_z: [f32; 4],
        /// Clip w, positive on receivers.
        pub row_w: [f32; 4],
        /// How y/w becomes clip y: shifts and scales of a monotone curve.
        pub remap: [[f32; 4]; 2],
        /// Width and height of the tile in texels.
        pub tile_size: [f32; 2],
        /// Unused; keeps the offsets of the shader.
        pub padding_0: [f32; 2],
        /// Smallest and largest k of the tile (xy), map texel of its upper left corner (zw).
        pub stretch_tile: [f32; 4],
    }
    const _: () = {
        let size_bytes = ::core::mem::size_of::<SunLogCapture>();
        assert!(size_bytes == 128);
        assert!(::core::mem::offset_of!(SunLogCapture, row_x) == 0);
        assert!(::core::mem::offset_of!(SunLogCapture, row_y) == 16);
        assert!(::core::mem::offset_of!(SunLogCapture, row_z) == 32);
        assert!(::core::mem::offset_of!(SunLogCapture, row_w) == 48);
        assert!(::core::mem::offset_of!(SunLogCapture, remap) == 64);
        assert!(::core::mem::offset_of!(SunLogCapture, tile_size) == 96);
        assert!(::core::mem::offset_of!(SunLogCapture, stretch_tile) == 112);
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
    pub struct SunLogMask {
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
        let size_bytes = ::core::mem::size_of::<SunLogMask>();
        assert!(size_bytes == 64);
        assert!(::core::mem::offset_of!(SunLogMask, ray_corner) == 0);
        assert!(::core::mem::offset_of!(SunLogMask, ray_across) == 16);
        assert!(::core::mem::offset_of!(SunLogMask, ray_down) == 32);
        assert!(::core::mem::offset_of!(SunLogMask, inverse_depth) == 48);
    };
    /// Everything that the CPU and the GPU agree on.
    pub static TABLE: ::cssm::core::table::CaseTable = tables::TABLE;
    mod tables {
        use ::std::borrow::Cow;
        use ::cssm::core::case::{Axes, DepthFormat, Stretch};
        use ::cssm::core::distribution::RemapKind;
        use ::cssm::core::table::*;
        pub(super) const TABLE: CaseTable = CaseTable {
            case: Cow::Borrowed("SunLog"),
            prefix: Cow::Borrowed("sun_log"),
            fingerprint: 0xed72eb4d5233de5a,
            map_width: 2048,
            map_height: 2048,
            map_format: DepthFormat::Depth32Float,
            halves: 1,
            sectors: 4,
            bands: 8,
            clips: 0,
            dominant: false,
            scales_thresholds: false,
            local_light: false,
            remap: RemapKind::Logarithmic,
            stretch: Stretch::Exact {
                bound_texels: 0.25,
            },
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
                name: Cow::Borrowed("SUN_LOG_MAP_SIZE"),
                value: ConstantValue::Vec2([2048.0, 2048.0]),
            },
            Constant {
                kind: ConstantKind::Sectors,
                name: Cow::Borrowed("SUN_LOG_SECTORS"),
                value: ConstantValue::U32(4),
            },
            Constant {
                kind: ConstantKind::Bands,
                name: Cow::Borrowed("SUN_LOG_BANDS"),
                value: ConstantValue::U32(8),
            },
            Constant {
                kind: ConstantKind::ThresholdVectors,
                name: Cow::Borrowed("SUN_LOG_THRESHOLD_VECTORS"),
                value: ConstantValue::U32(2),
            },
            Constant {
                kind: ConstantKind::StretchBound,
                name: Cow::Borrowed("SUN_LOG_STRETCH_BOUND"),
                value: ConstantValue::F32(0.25),
            },
        ];
        const RECORDS: &[Record] = &[
            Record {
                kind: RecordKind::Facet,
                name: Cow::Borrowed("SunLogFacet"),
                size_bytes: 144,
                fields: Cow::Borrowed(FACET_FIELDS),
            },
            Record {
                kind: RecordKind::Shadow,
                name: Cow::Borrowed("SunLogShadow"),
                size_bytes: 4896,
                fields: Cow::Borrowed(SHADOW_FIELDS),
            },
            Record {
                kind: RecordKind::Capture,
                name: Cow::Borrowed("SunLogCapture"),
                size_bytes: 128,
                fields: Cow::Borrowed(CAPTURE_FIELDS),
            },
            Record {
                kind: RecordKind::Mask,
                name: Cow::Borrowed("SunLogMask"),
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
            RecordField {
                name: Cow::Borrowed("remap"),
                meaning: Meaning::Remap,
                ty: FieldType::Vec4,
                elements: 2,
                offset_bytes: 112,
                stride_bytes: 16,
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
                stride_bytes: 144,
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
                name: Cow::Borrowed("remap"),
                meaning: Meaning::Remap,
                ty: FieldType::Vec4,
                elements: 2,
                offset_bytes: 64,
                stride_bytes: 16,
            },
            RecordField {
                name: Cow::Borrowed("tile_size"),
                meaning: Meaning::TileSize,
                ty: FieldType::Vec2,
                elements: 0,
                offset_bytes: 96,
                stride_bytes: 0,
            },
            RecordField {
                name: Cow::Borrowed("stretch_tile"),
                meaning: Meaning::StretchTile,
                ty: FieldType::Vec4,
                elements: 0,
                offset_bytes: 112,
                stride_bytes: 0,
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
                shader: ShaderKind::Capture,
                content: GroupContent::CasterMesh,
                group: 1,
                bindings: Cow::Borrowed(CAPTURE_GROUP_1),
            },
            BindGroup {
                shader: ShaderKind::CaptureClamped,
                content: GroupContent::CaptureFacet,
                group: 0,
                bindings: Cow::Borrowed(CAPTURE_CLAMPED_GROUP_0),
            },
            BindGroup {
                shader: ShaderKind::CaptureClamped,
                content: GroupContent::CasterMesh,
                group: 1,
                bindings: Cow::Borrowed(CAPTURE_CLAMPED_GROUP_1),
            },
            BindGroup {
                shader: ShaderKind::CaptureBent,
                content: GroupContent::CaptureFacet,
                group: 0,
                bindings: Cow::Borrowed(CAPTURE_BENT_GROUP_0),
            },
            BindGroup {
                shader: ShaderKind::CaptureBent,
                content: GroupContent::CasterMesh,
                group: 1,
                bindings: Cow::Borrowed(CAPTURE_BENT_GROUP_1),
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
                name: Cow::Borrowed("sun_log_capture"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Capture,
                    dynamic_offset: true,
                },
            },
        ];
        const CAPTURE_GROUP_1: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("sun_log_mesh_layout"),
                kind: BindingKind::MeshLayout,
            },
            Binding {
                binding: 1,
                name: Cow::Borrowed("sun_log_mesh_positions"),
                kind: BindingKind::MeshPositions,
            },
            Binding {
                binding: 2,
                name: Cow::Borrowed("sun_log_mesh_indices"),
                kind: BindingKind::MeshIndices,
            },
        ];
        const CAPTURE_CLAMPED_GROUP_0: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("sun_log_capture"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Capture,
                    dynamic_offset: true,
                },
            },
        ];
        const CAPTURE_CLAMPED_GROUP_1: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("sun_log_mesh_layout"),
                kind: BindingKind::MeshLayout,
            },
            Binding {
                binding: 1,
                name: Cow::Borrowed("sun_log_mesh_positions"),
                kind: BindingKind::MeshPositions,
            },
            Binding {
                binding: 2,
                name: Cow::Borrowed("sun_log_mesh_indices"),
                kind: BindingKind::MeshIndices,
            },
        ];
        const CAPTURE_BENT_GROUP_0: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("sun_log_capture"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Capture,
                    dynamic_offset: true,
                },
            },
        ];
        const CAPTURE_BENT_GROUP_1: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("sun_log_mesh_layout"),
                kind: BindingKind::MeshLayout,
            },
            Binding {
                binding: 1,
                name: Cow::Borrowed("sun_log_mesh_positions"),
                kind: BindingKind::MeshPositions,
            },
            Binding {
                binding: 2,
                name: Cow::Borrowed("sun_log_mesh_indices"),
                kind: BindingKind::MeshIndices,
            },
        ];
        const MASK_GROUP_0: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("sun_log_mask"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Mask,
                    dynamic_offset: false,
                },
            },
            Binding {
                binding: 1,
                name: Cow::Borrowed("sun_log_scene_depth"),
                kind: BindingKind::SceneDepth,
            },
        ];
        const MASK_GROUP_1: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("sun_log_shadow"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Shadow,
                    dynamic_offset: false,
                },
            },
            Binding {
                binding: 1,
                name: Cow::Borrowed("sun_log_map"),
                kind: BindingKind::Map,
            },
            Binding {
                binding: 2,
                name: Cow::Borrowed("sun_log_map_sampler"),
                kind: BindingKind::GatherSampler,
            },
        ];
        const FUNCTION_GROUP_2: &[Binding] = &[
            Binding {
                binding: 0,
                name: Cow::Borrowed("sun_log_shadow"),
                kind: BindingKind::Uniform {
                    record: RecordKind::Shadow,
                    dynamic_offset: false,
                },
            },
            Binding {
                binding: 1,
                name: Cow::Borrowed("sun_log_map"),
                kind: BindingKind::Map,
            },
            Binding {
                binding: 2,
                name: Cow::Borrowed("sun_log_map_sampler"),
                kind: BindingKind::GatherSampler,
            },
        ];
        const PASSES: &[Pass] = &[
            Pass {
                shader: ShaderKind::Capture,
                vertex: Cow::Borrowed("sun_log_capture_vertex"),
                fragment: None,
                reads: Cow::Borrowed(&[Resource::Casters]),
                writes: Cow::Borrowed(&[Resource::Map]),
            },
            Pass {
                shader: ShaderKind::CaptureClamped,
                vertex: Cow::Borrowed("sun_log_capture_clamped_vertex"),
                fragment: Some(Cow::Borrowed("sun_log_capture_clamped_fragment")),
                reads: Cow::Borrowed(&[Resource::Casters]),
                writes: Cow::Borrowed(&[Resource::Map]),
            },
            Pass {
                shader: ShaderKind::CaptureBent,
                vertex: Cow::Borrowed("sun_log_capture_bent_vertex"),
                fragment: Some(Cow::Borrowed("sun_log_capture_bent_fragment")),
                reads: Cow::Borrowed(&[Resource::Casters]),
                writes: Cow::Borrowed(&[Resource::Map]),
            },
            Pass {
                shader: ShaderKind::Mask,
                vertex: Cow::Borrowed("sun_log_mask_vertex"),
                fragment: Some(Cow::Borrowed("sun_log_mask_fragment")),
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
                kind: ShaderKind::CaptureBent,
                wgsl: Cow::Borrowed(super::CAPTURE_BENT_WGSL),
                spirv: Cow::Borrowed(super::CAPTURE_BENT_SPIRV),
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
    pub const CAPTURE_WGSL: &str = r#"// SunLog: renders casters into one tile of the shadow map; needs unclipped depth.
// Positions are relative to the eye, in the capture's axes: the camera's (x right, y up, looking along -z), sheared as the plan says.
// Sun over an open world without a step: face columns whose rows run with the logarithm of distance, casters that
// span many rows decided pixel by pixel.
// Generated from light case `SunLog`, ed72eb4d5233de5a. Do not edit.

/// Texels along the rows that edges of casters may be off.
const SUN_LOG_STRETCH_BOUND: f32 = 0.25;

/// What capturing needs of one facet, in the capture's axes: its matrix, row by row.
struct SunLogCapture {
    /// Clip x of the tile, to the right.
    row_x: vec4<f32>,
    /// Clip y of the tile, upwards.
    row_y: vec4<f32>,
    /// Clip z: depth along the light times w.
    row_z: vec4<f32>,
    /// Clip w, positive on receivers.
    row_w: vec4<f32>,
    /// How y/w becomes clip y: shifts and scales of a monotone curve.
    remap: array<vec4<f32>, 2>,
    /// Width and height of the tile in texels.
    tile_size: vec2<f32>,
    /// Smallest and largest k of the tile (xy), map texel of its upper left corner (zw).
    stretch_tile: vec4<f32>,
}

/// The facet that is captured.
@group(0) @binding(0)
var<uniform> sun_log_capture: SunLogCapture;
/// Where the caster's vertices lie in its buffers.
@group(1) @binding(0)
var<uniform> sun_log_mesh_layout: array<vec4<u32>, 2>;
/// Positions of the caster, as words.
@group(1) @binding(1)
var<storage, read> sun_log_mesh_positions: array<u32>;
/// Indices of the caster, as words.
@group(1) @binding(2)
var<storage, read> sun_log_mesh_indices: array<u32>;

/// Clip y after division, of one over distance.
fn sun_log_remapped(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].y + remap[1].z * inverse_distance;
    }
    return remap[0].x + remap[0].y * log(inverse_distance * remap[0].z);
}

/// Change of clip y after division per change of one over distance.
fn sun_log_remap_slope(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].z;
    }
    return remap[0].y / inverse_distance;
}

/// Places a caster's vertex in the tile.
@vertex
fn sun_log_capture_vertex(vertex: SunLogCasterVertex) -> @builtin(position) vec4<f32> {
    return sun_log_tile_position(sun_log_capture_position(vertex));
}

/// Largest k of a horizon; rows without any bend end there.
const SUN_LOG_STRAIGHT_HORIZON: f32 = 1e38;

/// Whether the facet's rows are bent at all.
fn sun_log_is_bent() -> bool {
    return sun_log_capture.remap[1].x < SUN_LOG_STRAIGHT_HORIZON;
}

/// Bound of the distance, in clip y, between the bent rows from one k to a larger one and the chord across them.
fn sun_log_chord_error(low: f32, high: f32) -> f32 {
    let horizon = sun_log_capture.remap[1].x;
    if high <= horizon {
        return 0.0;
    }

    // The second derivative is largest where the curve begins.
    let relative = (high - low) / max(low, horizon);
    return 0.125 * relative * relative * abs(sun_log_remap_slope(sun_log_capture.remap, high) * high);
}

/// A corner of a caster's triangle, or of what is drawn for it.
struct SunLogCasterVertex {
    /// Its number in the draw.
    @builtin(vertex_index) number: u32,
    /// First of the instance's rows; they take the object's space to the capture's axes, relative to the eye.
    @location(1) eye_from_object_x: vec4<f32>,
    /// Second row.
    @location(2) eye_from_object_y: vec4<f32>,
    /// Third row.
    @location(3) eye_from_object_z: vec4<f32>,
}

/// Position of a corner of the mesh's triangle list in the capture's axes.
fn sun_log_corner_position(caster: SunLogCasterVertex, corner: u32) -> vec4<f32> {
    let word = sun_log_mesh_layout[0].x + sun_log_mesh_vertex(corner) * sun_log_mesh_layout[0].y;
    let words = vec3<u32>(sun_log_mesh_positions[word], sun_log_mesh_positions[word + 1u], sun_log_mesh_positions[word + 2u]);
    let object = vec4<f32>(sun_log_decoded(words, sun_log_mesh_layout[1].x), 1.0);
    return vec4<f32>(
        dot(caster.eye_from_object_x, object),
        dot(caster.eye_from_object_y, object),
        dot(caster.eye_from_object_z, object),
        1.0,
    );
}

/// The vertex of a corner of the mesh's triangle list.
fn sun_log_mesh_vertex(corner: u32) -> u32 {
    let index = sun_log_mesh_layout[0].z + corner;
    switch sun_log_mesh_layout[0].w {
        case 0u: {
            return corner;
        }
        case 1u: {
            return extractBits(sun_log_mesh_indices[index / 2u], 16u * (index % 2u), 16u);
        }
        default: {
            return sun_log_mesh_indices[index];
        }
    }
}

/// The floats that a vertex fetch makes of words.
fn sun_log_decoded(words: vec3<u32>, format: u32) -> vec3<f32> {
    switch format {
        case 0u: {
            return bitcast<vec3<f32>>(words);
        }
        case 1u: {
            return vec3<f32>(sun_log_half_floats(words.x), sun_log_half_floats(words.y).x);
        }
        case 2u: {
            return vec3<f32>(unpack2x16snorm(words.x), unpack2x16snorm(words.y).x);
        }
        case 3u: {
            return vec3<f32>(unpack2x16unorm(words.x), unpack2x16unorm(words.y).x);
        }
        case 4u: {
            return unpack4x8snorm(words.x).xyz;
        }
        case 5u: {
            return unpack4x8unorm(words.x).xyz;
        }
        default: {
            return vec3<f32>((vec3<u32>(words.x) >> vec3<u32>(0u, 10u, 20u)) & vec3<u32>(1023u)) / 1023.0;
        }
    }
}

/// The two half floats of a word; infinities are large numbers.
fn sun_log_half_floats(word: u32) -> vec2<f32> {
    let halves = vec2<u32>(word & 0xffffu, word >> 16u);
    let magnitudes = halves & vec2<u32>(0x7fffu);
    let normal = bitcast<vec2<f32>>((magnitudes << vec2<u32>(13u)) + vec2<u32>(112u << 23u));
    let small = vec2<f32>(magnitudes) * SUN_LOG_SMALLEST_HALF;
    let values = select(normal, small, magnitudes < vec2<u32>(0x400u));
    return select(values, -values, halves > vec2<u32>(0x7fffu));
}

/// The smallest half float above zero.
const SUN_LOG_SMALLEST_HALF: f32 = 5.9604645e-8;

/// Applies the facet's matrix, row by row, to a position in the capture's axes; y/w is k, which is not bent yet.
fn sun_log_straight_corner(position: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(
        dot(sun_log_capture.row_x, position),
        dot(sun_log_capture.row_y, position),
        dot(sun_log_capture.row_z, position),
        dot(sun_log_capture.row_w, position),
    );
}

/// How far from the tile a corner may lie, in tiles, and in multiples of the nearest and farthest k.
const SUN_LOG_FARTHEST_CORNER: vec3<f32> = vec3<f32>(64.0, 4.0, 0.25);

/// Whether a corner has a place in the bent tile or not too far from it; none has at w = 0 and behind.
fn sun_log_has_place(corner: vec4<f32>) -> bool {
    let low = min(sun_log_capture.stretch_tile.x, SUN_LOG_FARTHEST_CORNER.z * sun_log_capture.stretch_tile.x);
    let high = SUN_LOG_FARTHEST_CORNER.y * sun_log_capture.stretch_tile.y;
    let is_beside = abs(corner.x) <= SUN_LOG_FARTHEST_CORNER.x * corner.w;
    return corner.w > 0.0 && is_beside && corner.y >= low * corner.w && corner.y <= high * corner.w;
}

/// Whether all of a triangle lies outside one edge of the tile.
fn sun_log_is_outside(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> bool {
    let x = vec3<f32>(one.x, two.x, three.x);
    let y = vec3<f32>(one.y, two.y, three.y);
    let w = vec3<f32>(one.w, two.w, three.w);
    let is_aside = all(x > w) || all(x < -w);
    let is_before = all(y > sun_log_capture.stretch_tile.y * w) || all(y < sun_log_capture.stretch_tile.x * w);
    return is_aside || is_before || all(w <= vec3<f32>(0.0));
}

/// Texels by which an edge with straight ends misses the bent one; beyond any bound where an end has no place.
fn sun_log_edge_error(one: vec4<f32>, two: vec4<f32>) -> f32 {
    if !(sun_log_has_place(one) && sun_log_has_place(two)) {
        return SUN_LOG_NO_PLACE;
    }
    let start = one.y / one.w;
    let end = two.y / two.w;
    return 0.5 * sun_log_capture.tile_size.y * sun_log_chord_error(min(start, end), max(start, end));
}

/// An error beyond any bound.
const SUN_LOG_NO_PLACE: f32 = 1e30;

/// The largest of a triangle's edges' errors; no point inside is farther off.
fn sun_log_triangle_error(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> f32 {
    return max(sun_log_edge_error(one, two), max(sun_log_edge_error(two, three), sun_log_edge_error(three, one)));
}

/// A position that no tile shows.
const SUN_LOG_HIDDEN: vec4<f32> = vec4<f32>(2.0, 2.0, 0.5, 1.0);

/// Moves a corner from its object to the eye, into the capture's axes; zero where the triangle is left out.
fn sun_log_capture_position(caster: SunLogCasterVertex) -> vec4<f32> {
    let number = caster.number % 3u;
    let first = caster.number - number;
    let positions = array<vec4<f32>, 3>(
        sun_log_corner_position(caster, first),
        sun_log_corner_position(caster, first + 1u),
        sun_log_corner_position(caster, first + 2u),
    );
    let position = select(select(positions[2], positions[1], number == 1u), positions[0], number == 0u);
    if sun_log_is_bent() {
        let one = sun_log_straight_corner(positions[0]);
        let two = sun_log_straight_corner(positions[1]);
        let three = sun_log_straight_corner(positions[2]);
        if sun_log_is_outside(one, two, three) || !(sun_log_triangle_error(one, two, three) <= SUN_LOG_STRETCH_BOUND) {
            return vec4<f32>(0.0);
        }
    }
    return position;
}

/// Applies the facet's matrix to a position in the capture's axes, and bends its y.
fn sun_log_tile_position(position: vec4<f32>) -> vec4<f32> {
    if position.w == 0.0 {
        return SUN_LOG_HIDDEN;
    }
    let corner = sun_log_straight_corner(position);
    if sun_log_is_bent() {
        return vec4<f32>(corner.x, sun_log_remapped(sun_log_capture.remap, corner.y / corner.w) * corner.w, corner.zw);
    }
    let y = sun_log_remapped(sun_log_capture.remap, 0.0) * corner.w + sun_log_remap_slope(sun_log_capture.remap, 0.0) * corner.y;
    return vec4<f32>(corner.x, y, corner.zw);
}
"#;
    /// SPIR-V of the capture shader, little-endian words.
    pub const CAPTURE_SPIRV: &[u8] = b"\x03\x02#\x07\0\x03\x01\0\x1C\0\0\0?\x02\0\0\0\0\0\0\x11\0\x02\0\x01\0\0\0\x0B\0\x06\0\x01\0\0\0GLSL.std.450\0\0\0\0\x0E\0\x03\0\0\0\0\0\x01\0\0\0\x0F\0\x0E\0\0\0\0\x006\x02\0\0sun_log_capture_vertex\0\0*\x02\0\0-\x02\0\x000\x02\0\x002\x02\0\x004\x02\0\0G\0\x04\0\x05\0\0\0\x06\0\0\0\x10\0\0\0H\0\x05\0\t\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\t\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\t\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\t\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\t\0\0\0\x04\0\0\0#\0\0\0@\0\0\0H\0\x05\0\t\0\0\0\x05\0\0\0#\0\0\0`\0\0\0H\0\x05\0\t\0\0\0\x06\0\0\0#\0\0\0p\0\0\0G\0\x04\0\x0B\0\0\0\x06\0\0\0\x10\0\0\0G\0\x04\0\x0C\0\0\0\x06\0\0\0\x04\0\0\0H\0\x05\0\r\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\r\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\r\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\r\0\0\0\x03\0\0\0#\0\0\x000\0\0\0G\0\x04\0\x12\0\0\0\x06\0\0\0\x10\0\0\0G\0\x04\0\x1F\0\0\0\"\0\0\0\0\0\0\0G\0\x04\0\x1F\0\0\0!\0\0\0\0\0\0\0G\0\x03\0 \0\0\0\x02\0\0\0H\0\x05\0 \0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0\"\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0\"\0\0\0!\0\0\0\0\0\0\0G\0\x03\0#\0\0\0\x02\0\0\0H\0\x05\0#\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x03\0%\0\0\0\x18\0\0\0G\0\x04\0%\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0%\0\0\0!\0\0\0\x01\0\0\0G\0\x03\0&\0\0\0\x02\0\0\0H\0\x05\0&\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x03\0(\0\0\0\x18\0\0\0G\0\x04\0(\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0(\0\0\0!\0\0\0\x02\0\0\0G\0\x03\0)\0\0\0\x02\0\0\0H\0\x05\0)\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0*\x02\0\0\x0B\0\0\0*\0\0\0G\0\x04\0-\x02\0\0\x1E\0\0\0\x01\0\0\0G\0\x04\x000\x02\0\0\x1E\0\0\0\x02\0\0\0G\0\x04\x002\x02\0\0\x1E\0\0\0\x03\0\0\0G\0\x04\x004\x02\0\0\x0B\0\0\0\0\0\0\0\x13\0\x02\0\x02\0\0\0\x16\0\x03\0\x03\0\0\0 \0\0\0\x17\0\x04\0\x04\0\0\0\x03\0\0\0\x04\0\0\0\x15\0\x04\0\x07\0\0\0 \0\0\0\0\0\0\0+\0\x04\0\x07\0\0\0\x06\0\0\0\x02\0\0\0\x1C\0\x04\0\x05\0\0\0\x04\0\0\0\x06\0\0\0\x17\0\x04\0\x08\0\0\0\x03\0\0\0\x02\0\0\0\x1E\0\t\0\t\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x05\0\0\0\x08\0\0\0\x04\0\0\0\x17\0\x04\0\n\0\0\0\x07\0\0\0\x04\0\0\0\x1C\0\x04\0\x0B\0\0\0\n\0\0\0\x06\0\0\0\x1D\0\x03\0\x0C\0\0\0\x07\0\0\0\x1E\0\x06\0\r\0\0\0\x07\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x14\0\x02\0\x0E\0\0\0\x17\0\x04\0\x0F\0\0\0\x07\0\0\0\x02\0\0\0\x17\0\x04\0\x10\0\0\0\x07\0\0\0\x03\0\0\0\x17\0\x04\0\x11\0\0\0\x03\0\0\0\x03\0\0\0+\0\x04\0\x07\0\0\0\x13\0\0\0\x03\0\0\0\x1C\0\x04\0\x12\0\0\0\x04\0\0\0\x13\0\0\0+\0\x04\0\x03\0\0\0\x14\0\0\0\0\0\x80>+\0\x04\0\x03\0\0\0\x15\0\0\0\0\0\0@+\0\x04\0\x03\0\0\0\x16\0\0\0\0\0\0?+\0\x04\0\x03\0\0\0\x17\0\0\0\0\0\x80?,\0\x07\0\x04\0\0\0\x18\0\0\0\x15\0\0\0\x15\0\0\0\x16\0\0\0\x17\0\0\0+\0\x04\0\x03\0\0\0\x19\0\0\0\x99v\x96~+\0\x04\0\x03\0\0\0\x1A\0\0\0\0\0\x803+\0\x04\0\x03\0\0\0\x1B\0\0\0\0\0\x80B+\0\x04\0\x03\0\0\0\x1C\0\0\0\0\0\x80@,\0\x06\0\x11\0\0\0\x1D\0\0\0\x1B\0\0\0\x1C\0\0\0\x14\0\0\0+\0\x04\0\x03\0\0\0\x1E\0\0\0\xCA\xF2Iq\x1E\0\x03\0 \0\0\0\t\0\0\0 \0\x04\0!\0\0\0\x02\0\0\0 \0\0\0;\0\x04\0!\0\0\0\x1F\0\0\0\x02\0\0\0\x1E\0\x03\0#\0\0\0\x0B\0\0\0 \0\x04\0$\0\0\0\x02\0\0\0#\0\0\0;\0\x04\0$\0\0\0\"\0\0\0\x02\0\0\0\x1E\0\x03\0&\0\0\0\x0C\0\0\0 \0\x04\0'\0\0\0\x0C\0\0\0&\0\0\0;\0\x04\0'\0\0\0%\0\0\0\x0C\0\0\0\x1E\0\x03\0)\0\0\0\x0C\0\0\0 \0\x04\0*\0\0\0\x0C\0\0\0)\0\0\0;\0\x04\0*\0\0\0(\0\0\0\x0C\0\0\0!\0\x05\0/\0\0\0\x03\0\0\0\x05\0\0\0\x03\0\0\0!\0\x04\0X\0\0\0\x04\0\0\0\x04\0\0\0 \0\x04\0Y\0\0\0\x02\0\0\0\t\0\0\0+\0\x04\0\x07\0\0\0Z\0\0\0\0\0\0\0 \0\x04\0]\0\0\0\x02\0\0\0\x04\0\0\0+\0\x04\0\x07\0\0\0a\0\0\0\x01\0\0\0!\0\x03\0n\0\0\0\x0E\0\0\0 \0\x04\0q\0\0\0\x02\0\0\0\x05\0\0\0 \0\x04\0r\0\0\0\x02\0\0\0\x03\0\0\0+\0\x04\0\x07\0\0\0s\0\0\0\x04\0\0\0+\0\x04\0\x03\0\0\0{\0\0\0\0\0\0\0!\0\x04\0\xA1\0\0\0\x07\0\0\0\x07\0\0\0 \0\x04\0\xA2\0\0\0\x02\0\0\0\x0B\0\0\0 \0\x04\0\xA4\0\0\0\x0C\0\0\0\x0C\0\0\0+\0\x04\0\x07\0\0\0\xA6\0\0\0\x10\0\0\0 \0\x04\0\xA8\0\0\0\x02\0\0\0\n\0\0\0 \0\x04\0\xA9\0\0\0\x02\0\0\0\x07\0\0\0 \0\x04\0\xB4\0\0\0\x0C\0\0\0\x07\0\0\0+\0\x04\0\x07\0\0\0\xBA\0\0\0 \0\0\0.\0\x03\0\x07\0\0\0\xC0\0\0\0!\0\x04\0\xC4\0\0\0\x08\0\0\0\x07\0\0\0+\0\x04\0\x07\0\0\0\xC5\0\0\0\xFF\xFF\0\0+\0\x04\0\x07\0\0\0\xC6\0\0\0\xFF\x7F\0\0,\0\x05\0\x0F\0\0\0\xC7\0\0\0\xC6\0\0\0\xC6\0\0\0+\0\x04\0\x07\0\0\0\xC8\0\0\0\r\0\0\0,\0\x05\0\x0F\0\0\0\xC9\0\0\0\xC8\0\0\0\xC8\0\0\0+\0\x04\0\x07\0\0\0\xCA\0\0\0\0\0\08,\0\x05\0\x0F\0\0\0\xCB\0\0\0\xCA\0\0\0\xCA\0\0\0+\0\x04\0\x07\0\0\0\xCC\0\0\0\0\x04\0\0,\0\x05\0\x0F\0\0\0\xCD\0\0\0\xCC\0\0\0\xCC\0\0\0\x17\0\x04\0\xD8\0\0\0\x0E\0\0\0\x02\0\0\0!\0\x05\0\xE2\0\0\0\x11\0\0\0\x10\0\0\0\x07\0\0\0+\0\x04\0\x07\0\0\0\xE3\0\0\0\n\0\0\0+\0\x04\0\x07\0\0\0\xE4\0\0\0\x14\0\0\0,\0\x06\0\x10\0\0\0\xE5\0\0\0Z\0\0\0\xE3\0\0\0\xE4\0\0\0+\0\x04\0\x07\0\0\0\xE6\0\0\0\xFF\x03\0\0,\0\x06\0\x10\0\0\0\xE7\0\0\0\xE6\0\0\0\xE6\0\0\0\xE6\0\0\0+\0\x04\0\x03\0\0\0\xE8\0\0\0\0\xC0\x7FD,\0\x06\0\x11\0\0\0\xE9\0\0\0\xE8\0\0\0\xE8\0\0\0\xE8\0\0\0.\0\x03\0\x11\0\0\0\x12\x01\0\0!\0\x05\0\x17\x01\0\0\x04\0\0\0\r\0\0\0\x07\0\0\0!\0\x06\0<\x01\0\0\x0E\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0)\0\x03\0\x0E\0\0\0>\x01\0\0,\0\x06\0\x11\0\0\0?\x01\0\0{\0\0\0{\0\0\0{\0\0\0 \0\x04\0A\x01\0\0\x07\0\0\0\x0E\0\0\0.\0\x03\0\x0E\0\0\0B\x01\0\0.\0\x03\0\x0E\0\0\0D\x01\0\0.\0\x03\0\x0E\0\0\0F\x01\0\0.\0\x03\0\x0E\0\0\0H\x01\0\0\x17\0\x04\0V\x01\0\0\x0E\0\0\0\x03\0\0\0+\0\x04\0\x07\0\0\0a\x01\0\0\x06\0\0\0!\0\x04\0\x80\x01\0\0\x0E\0\0\0\x04\0\0\0*\0\x03\0\x0E\0\0\0\x82\x01\0\0.\0\x03\0\x0E\0\0\0\x84\x01\0\0.\0\x03\0\x0E\0\0\0\x86\x01\0\0.\0\x03\0\x0E\0\0\0\x88\x01\0\0!\0\x05\0\xB2\x01\0\0\x03\0\0\0\x03\0\0\0\x03\0\0\0+\0\x04\0\x03\0\0\0\xB4\x01\0\0\0\0\0>!\0\x05\0\xCA\x01\0\0\x03\0\0\0\x04\0\0\0\x04\0\0\0.\0\x03\0\x0E\0\0\0\xCD\x01\0\0 \0\x04\0\xDE\x01\0\0\x02\0\0\0\x08\0\0\0+\0\x04\0\x07\0\0\0\xDF\x01\0\0\x05\0\0\0!\0\x06\0\xEC\x01\0\0\x03\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0!\0\x04\0\xF7\x01\0\0\x04\0\0\0\r\0\0\0,\0\x07\0\x04\0\0\0\xFC\x01\0\0{\0\0\0{\0\0\0{\0\0\0{\0\0\0.\0\x03\0\x0E\0\0\0\xFE\x01\0\0\x17\0\x04\0\x0E\x02\0\0\x0E\0\0\0\x04\0\0\0 \0\x04\0+\x02\0\0\x01\0\0\0\x07\0\0\0;\0\x04\0+\x02\0\0*\x02\0\0\x01\0\0\0 \0\x04\0.\x02\0\0\x01\0\0\0\x04\0\0\0;\0\x04\0.\x02\0\0-\x02\0\0\x01\0\0\0;\0\x04\0.\x02\0\x000\x02\0\0\x01\0\0\0;\0\x04\0.\x02\0\x002\x02\0\0\x01\0\0\0 \0\x04\x005\x02\0\0\x03\0\0\0\x04\0\0\0;\0\x04\x005\x02\0\x004\x02\0\0\x03\0\0\0!\0\x03\x007\x02\0\0\x02\0\0\x006\0\x05\0\x03\0\0\0.\0\0\0\0\0\0\0/\0\0\x007\0\x03\0\x05\0\0\0,\0\0\x007\0\x03\0\x03\0\0\0-\0\0\0\xF8\0\x02\0+\0\0\0\xF9\0\x02\x000\0\0\0\xF8\0\x02\x000\0\0\0Q\0\x05\0\x04\0\0\x001\0\0\0,\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\x002\0\0\x001\0\0\0\0\0\0\0\xBC\0\x05\0\x0E\0\0\x003\0\0\0-\0\0\x002\0\0\0\xF7\0\x03\x004\0\0\0\0\0\0\0\xFA\0\x04\x003\0\0\x005\0\0\x004\0\0\0\xF8\0\x02\x005\0\0\0Q\0\x05\0\x04\0\0\x006\0\0\0,\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\x007\0\0\x006\0\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\08\0\0\0,\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\09\0\0\08\0\0\0\x02\0\0\0\x85\0\x05\0\x03\0\0\0:\0\0\09\0\0\0-\0\0\0\x81\0\x05\0\x03\0\0\0;\0\0\x007\0\0\0:\0\0\0\xFE\0\x02\0;\0\0\0\xF8\0\x02\x004\0\0\0Q\0\x05\0\x04\0\0\0<\0\0\0,\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0=\0\0\0<\0\0\0\0\0\0\0Q\0\x05\0\x04\0\0\0>\0\0\0,\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0?\0\0\0>\0\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\0@\0\0\0,\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0A\0\0\0@\0\0\0\x02\0\0\0\x85\0\x05\0\x03\0\0\0B\0\0\0-\0\0\0A\0\0\0\x0C\0\x06\0\x03\0\0\0C\0\0\0\x01\0\0\0\x1C\0\0\0B\0\0\0\x85\0\x05\0\x03\0\0\0D\0\0\0?\0\0\0C\0\0\0\x81\0\x05\0\x03\0\0\0E\0\0\0=\0\0\0D\0\0\0\xFE\0\x02\0E\0\0\08\0\x01\x006\0\x05\0\x03\0\0\0I\0\0\0\0\0\0\0/\0\0\x007\0\x03\0\x05\0\0\0G\0\0\x007\0\x03\0\x03\0\0\0H\0\0\0\xF8\0\x02\0F\0\0\0\xF9\0\x02\0J\0\0\0\xF8\0\x02\0J\0\0\0Q\0\x05\0\x04\0\0\0K\0\0\0G\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0L\0\0\0K\0\0\0\0\0\0\0\xBC\0\x05\0\x0E\0\0\0M\0\0\0H\0\0\0L\0\0\0\xF7\0\x03\0N\0\0\0\0\0\0\0\xFA\0\x04\0M\0\0\0O\0\0\0N\0\0\0\xF8\0\x02\0O\0\0\0Q\0\x05\0\x04\0\0\0P\0\0\0G\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0Q\0\0\0P\0\0\0\x02\0\0\0\xFE\0\x02\0Q\0\0\0\xF8\0\x02\0N\0\0\0Q\0\x05\0\x04\0\0\0R\0\0\0G\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0S\0\0\0R\0\0\0\x01\0\0\0\x88\0\x05\0\x03\0\0\0T\0\0\0S\0\0\0H\0\0\0\xFE\0\x02\0T\0\0\08\0\x01\x006\0\x05\0\x04\0\0\0W\0\0\0\0\0\0\0X\0\0\x007\0\x03\0\x04\0\0\0V\0\0\0\xF8\0\x02\0U\0\0\0A\0\x05\0Y\0\0\0[\0\0\0\x1F\0\0\0Z\0\0\0\xF9\0\x02\0\\\0\0\0\xF8\0\x02\0\\\0\0\0A\0\x05\0]\0\0\0^\0\0\0[\0\0\0Z\0\0\0=\0\x04\0\x04\0\0\0_\0\0\0^\0\0\0\x94\0\x05\0\x03\0\0\0`\0\0\0_\0\0\0V\0\0\0A\0\x05\0]\0\0\0b\0\0\0[\0\0\0a\0\0\0=\0\x04\0\x04\0\0\0c\0\0\0b\0\0\0\x94\0\x05\0\x03\0\0\0d\0\0\0c\0\0\0V\0\0\0A\0\x05\0]\0\0\0e\0\0\0[\0\0\0\x06\0\0\0=\0\x04\0\x04\0\0\0f\0\0\0e\0\0\0\x94\0\x05\0\x03\0\0\0g\0\0\0f\0\0\0V\0\0\0A\0\x05\0]\0\0\0h\0\0\0[\0\0\0\x13\0\0\0=\0\x04\0\x04\0\0\0i\0\0\0h\0\0\0\x94\0\x05\0\x03\0\0\0j\0\0\0i\0\0\0V\0\0\0P\0\x07\0\x04\0\0\0k\0\0\0`\0\0\0d\0\0\0g\0\0\0j\0\0\0\xFE\0\x02\0k\0\0\08\0\x01\x006\0\x05\0\x0E\0\0\0m\0\0\0\0\0\0\0n\0\0\0\xF8\0\x02\0l\0\0\0A\0\x05\0Y\0\0\0o\0\0\0\x1F\0\0\0Z\0\0\0\xF9\0\x02\0p\0\0\0\xF8\0\x02\0p\0\0\0A\0\x07\0r\0\0\0t\0\0\0o\0\0\0s\0\0\0a\0\0\0Z\0\0\0=\0\x04\0\x03\0\0\0u\0\0\0t\0\0\0\xB8\0\x05\0\x0E\0\0\0v\0\0\0u\0\0\0\x19\0\0\0\xFE\0\x02\0v\0\0\08\0\x01\x006\0\x05\0\x04\0\0\0y\0\0\0\0\0\0\0X\0\0\x007\0\x03\0\x04\0\0\0x\0\0\0\xF8\0\x02\0w\0\0\0A\0\x05\0Y\0\0\0z\0\0\0\x1F\0\0\0Z\0\0\0\xF9\0\x02\0|\0\0\0\xF8\0\x02\0|\0\0\0Q\0\x05\0\x03\0\0\0}\0\0\0x\0\0\0\x03\0\0\0\xB4\0\x05\0\x0E\0\0\0~\0\0\0}\0\0\0{\0\0\0\xF7\0\x03\0\x7F\0\0\0\0\0\0\0\xFA\0\x04\0~\0\0\0\x80\0\0\0\x7F\0\0\0\xF8\0\x02\0\x80\0\0\0\xFE\0\x02\0\x18\0\0\0\xF8\0\x02\0\x7F\0\0\09\0\x05\0\x04\0\0\0\x81\0\0\0W\0\0\0x\0\0\09\0\x04\0\x0E\0\0\0\x82\0\0\0m\0\0\0\xF7\0\x03\0\x83\0\0\0\0\0\0\0\xFA\0\x04\0\x82\0\0\0\x84\0\0\0\x83\0\0\0\xF8\0\x02\0\x84\0\0\0Q\0\x05\0\x03\0\0\0\x85\0\0\0\x81\0\0\0\0\0\0\0A\0\x05\0q\0\0\0\x86\0\0\0z\0\0\0s\0\0\0=\0\x04\0\x05\0\0\0\x87\0\0\0\x86\0\0\0Q\0\x05\0\x03\0\0\0\x88\0\0\0\x81\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\x89\0\0\0\x81\0\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\x8A\0\0\0\x88\0\0\0\x89\0\0\09\0\x06\0\x03\0\0\0\x8B\0\0\0.\0\0\0\x87\0\0\0\x8A\0\0\0Q\0\x05\0\x03\0\0\0\x8C\0\0\0\x81\0\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\x8D\0\0\0\x8B\0\0\0\x8C\0\0\0O\0\x07\0\x08\0\0\0\x8E\0\0\0\x81\0\0\0\x81\0\0\0\x02\0\0\0\x03\0\0\0P\0\x06\0\x04\0\0\0\x8F\0\0\0\x85\0\0\0\x8D\0\0\0\x8E\0\0\0\xFE\0\x02\0\x8F\0\0\0\xF8\0\x02\0\x83\0\0\0A\0\x05\0q\0\0\0\x90\0\0\0z\0\0\0s\0\0\0=\0\x04\0\x05\0\0\0\x91\0\0\0\x90\0\0\09\0\x06\0\x03\0\0\0\x92\0\0\0.\0\0\0\x91\0\0\0{\0\0\0Q\0\x05\0\x03\0\0\0\x93\0\0\0\x81\0\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\x94\0\0\0\x92\0\0\0\x93\0\0\0A\0\x05\0q\0\0\0\x95\0\0\0z\0\0\0s\0\0\0=\0\x04\0\x05\0\0\0\x96\0\0\0\x95\0\0\09\0\x06\0\x03\0\0\0\x97\0\0\0I\0\0\0\x96\0\0\0{\0\0\0Q\0\x05\0\x03\0\0\0\x98\0\0\0\x81\0\0\0\x01\0\0\0\x85\0\x05\0\x03\0\0\0\x99\0\0\0\x97\0\0\0\x98\0\0\0\x81\0\x05\0\x03\0\0\0\x9A\0\0\0\x94\0\0\0\x99\0\0\0Q\0\x05\0\x03\0\0\0\x9B\0\0\0\x81\0\0\0\0\0\0\0O\0\x07\0\x08\0\0\0\x9C\0\0\0\x81\0\0\0\x81\0\0\0\x02\0\0\0\x03\0\0\0P\0\x06\0\x04\0\0\0\x9D\0\0\0\x9B\0\0\0\x9A\0\0\0\x9C\0\0\0\xFE\0\x02\0\x9D\0\0\08\0\x01\x006\0\x05\0\x07\0\0\0\xA0\0\0\0\0\0\0\0\xA1\0\0\x007\0\x03\0\x07\0\0\0\x9F\0\0\0\xF8\0\x02\0\x9E\0\0\0A\0\x05\0\xA2\0\0\0\xA3\0\0\0\"\0\0\0Z\0\0\0A\0\x05\0\xA4\0\0\0\xA5\0\0\0(\0\0\0Z\0\0\0\xF9\0\x02\0\xA7\0\0\0\xF8\0\x02\0\xA7\0\0\0A\0\x06\0\xA9\0\0\0\xAA\0\0\0\xA3\0\0\0Z\0\0\0\x06\0\0\0=\0\x04\0\x07\0\0\0\xAB\0\0\0\xAA\0\0\0\x80\0\x05\0\x07\0\0\0\xAC\0\0\0\xAB\0\0\0\x9F\0\0\0A\0\x06\0\xA9\0\0\0\xAD\0\0\0\xA3\0\0\0Z\0\0\0\x13\0\0\0=\0\x04\0\x07\0\0\0\xAE\0\0\0\xAD\0\0\0\xF7\0\x03\0\xAF\0\0\0\0\0\0\0\xFB\0\x07\0\xAE\0\0\0\xB2\0\0\0\0\0\0\0\xB0\0\0\0\x01\0\0\0\xB1\0\0\0\xF8\0\x02\0\xB0\0\0\0\xFE\0\x02\0\x9F\0\0\0\xF8\0\x02\0\xB1\0\0\0\x86\0\x05\0\x07\0\0\0\xB3\0\0\0\xAC\0\0\0\x06\0\0\0A\0\x05\0\xB4\0\0\0\xB5\0\0\0\xA5\0\0\0\xB3\0\0\0=\0\x04\0\x07\0\0\0\xB6\0\0\0\xB5\0\0\0\x89\0\x05\0\x07\0\0\0\xB7\0\0\0\xAC\0\0\0\x06\0\0\0\x84\0\x05\0\x07\0\0\0\xB8\0\0\0\xA6\0\0\0\xB7\0\0\0\x0C\0\x07\0\x07\0\0\0\xBB\0\0\0\x01\0\0\0&\0\0\0\xB8\0\0\0\xBA\0\0\0\x82\0\x05\0\x07\0\0\0\xBC\0\0\0\xBA\0\0\0\xBB\0\0\0\x0C\0\x07\0\x07\0\0\0\xBD\0\0\0\x01\0\0\0&\0\0\0\xA6\0\0\0\xBC\0\0\0\xCB\0\x06\0\x07\0\0\0\xB9\0\0\0\xB6\0\0\0\xBB\0\0\0\xBD\0\0\0\xFE\0\x02\0\xB9\0\0\0\xF8\0\x02\0\xB2\0\0\0A\0\x05\0\xB4\0\0\0\xBE\0\0\0\xA5\0\0\0\xAC\0\0\0=\0\x04\0\x07\0\0\0\xBF\0\0\0\xBE\0\0\0\xFE\0\x02\0\xBF\0\0\0\xF8\0\x02\0\xAF\0\0\0\xFE\0\x02\0\xC0\0\0\08\0\x01\x006\0\x05\0\x08\0\0\0\xC3\0\0\0\0\0\0\0\xC4\0\0\x007\0\x03\0\x07\0\0\0\xC2\0\0\0\xF8\0\x02\0\xC1\0\0\0\xF9\0\x02\0\xCE\0\0\0\xF8\0\x02\0\xCE\0\0\0\xC7\0\x05\0\x07\0\0\0\xCF\0\0\0\xC2\0\0\0\xC5\0\0\0\xC2\0\x05\0\x07\0\0\0\xD0\0\0\0\xC2\0\0\0\xA6\0\0\0P\0\x05\0\x0F\0\0\0\xD1\0\0\0\xCF\0\0\0\xD0\0\0\0\xC7\0\x05\0\x0F\0\0\0\xD2\0\0\0\xD1\0\0\0\xC7\0\0\0\xC4\0\x05\0\x0F\0\0\0\xD3\0\0\0\xD2\0\0\0\xC9\0\0\0\x80\0\x05\0\x0F\0\0\0\xD4\0\0\0\xD3\0\0\0\xCB\0\0\0|\0\x04\0\x08\0\0\0\xD5\0\0\0\xD4\0\0\0p\0\x04\0\x08\0\0\0\xD6\0\0\0\xD2\0\0\0\x8E\0\x05\0\x08\0\0\0\xD7\0\0\0\xD6\0\0\0\x1A\0\0\0\xB0\0\x05\0\xD8\0\0\0\xD9\0\0\0\xD2\0\0\0\xCD\0\0\0\xA9\0\x06\0\x08\0\0\0\xDA\0\0\0\xD9\0\0\0\xD7\0\0\0\xD5\0\0\0\x7F\0\x04\0\x08\0\0\0\xDB\0\0\0\xDA\0\0\0\xAC\0\x05\0\xD8\0\0\0\xDC\0\0\0\xD1\0\0\0\xC7\0\0\0\xA9\0\x06\0\x08\0\0\0\xDD\0\0\0\xDC\0\0\0\xDB\0\0\0\xDA\0\0\0\xFE\0\x02\0\xDD\0\0\08\0\x01\x006\0\x05\0\x11\0\0\0\xE1\0\0\0\0\0\0\0\xE2\0\0\x007\0\x03\0\x10\0\0\0\xDF\0\0\x007\0\x03\0\x07\0\0\0\xE0\0\0\0\xF8\0\x02\0\xDE\0\0\0\xF9\0\x02\0\xEA\0\0\0\xF8\0\x02\0\xEA\0\0\0\xF7\0\x03\0\xEB\0\0\0\0\0\0\0\xFB\0\x0F\0\xE0\0\0\0\xF2\0\0\0\0\0\0\0\xEC\0\0\0\x01\0\0\0\xED\0\0\0\x02\0\0\0\xEE\0\0\0\x03\0\0\0\xEF\0\0\0\x04\0\0\0\xF0\0\0\0\x05\0\0\0\xF1\0\0\0\xF8\0\x02\0\xEC\0\0\0|\0\x04\0\x11\0\0\0\xF3\0\0\0\xDF\0\0\0\xFE\0\x02\0\xF3\0\0\0\xF8\0\x02\0\xED\0\0\0Q\0\x05\0\x07\0\0\0\xF4\0\0\0\xDF\0\0\0\0\0\0\09\0\x05\0\x08\0\0\0\xF5\0\0\0\xC3\0\0\0\xF4\0\0\0Q\0\x05\0\x07\0\0\0\xF6\0\0\0\xDF\0\0\0\x01\0\0\09\0\x05\0\x08\0\0\0\xF7\0\0\0\xC3\0\0\0\xF6\0\0\0Q\0\x05\0\x03\0\0\0\xF8\0\0\0\xF7\0\0\0\0\0\0\0P\0\x05\0\x11\0\0\0\xF9\0\0\0\xF5\0\0\0\xF8\0\0\0\xFE\0\x02\0\xF9\0\0\0\xF8\0\x02\0\xEE\0\0\0Q\0\x05\0\x07\0\0\0\xFA\0\0\0\xDF\0\0\0\0\0\0\0\x0C\0\x06\0\x08\0\0\0\xFB\0\0\0\x01\0\0\0<\0\0\0\xFA\0\0\0Q\0\x05\0\x07\0\0\0\xFC\0\0\0\xDF\0\0\0\x01\0\0\0\x0C\0\x06\0\x08\0\0\0\xFD\0\0\0\x01\0\0\0<\0\0\0\xFC\0\0\0Q\0\x05\0\x03\0\0\0\xFE\0\0\0\xFD\0\0\0\0\0\0\0P\0\x05\0\x11\0\0\0\xFF\0\0\0\xFB\0\0\0\xFE\0\0\0\xFE\0\x02\0\xFF\0\0\0\xF8\0\x02\0\xEF\0\0\0Q\0\x05\0\x07\0\0\0\0\x01\0\0\xDF\0\0\0\0\0\0\0\x0C\0\x06\0\x08\0\0\0\x01\x01\0\0\x01\0\0\0=\0\0\0\0\x01\0\0Q\0\x05\0\x07\0\0\0\x02\x01\0\0\xDF\0\0\0\x01\0\0\0\x0C\0\x06\0\x08\0\0\0\x03\x01\0\0\x01\0\0\0=\0\0\0\x02\x01\0\0Q\0\x05\0\x03\0\0\0\x04\x01\0\0\x03\x01\0\0\0\0\0\0P\0\x05\0\x11\0\0\0\x05\x01\0\0\x01\x01\0\0\x04\x01\0\0\xFE\0\x02\0\x05\x01\0\0\xF8\0\x02\0\xF0\0\0\0Q\0\x05\0\x07\0\0\0\x06\x01\0\0\xDF\0\0\0\0\0\0\0\x0C\0\x06\0\x04\0\0\0\x07\x01\0\0\x01\0\0\0?\0\0\0\x06\x01\0\0O\0\x08\0\x11\0\0\0\x08\x01\0\0\x07\x01\0\0\x07\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\xFE\0\x02\0\x08\x01\0\0\xF8\0\x02\0\xF1\0\0\0Q\0\x05\0\x07\0\0\0\t\x01\0\0\xDF\0\0\0\0\0\0\0\x0C\0\x06\0\x04\0\0\0\n\x01\0\0\x01\0\0\0@\0\0\0\t\x01\0\0O\0\x08\0\x11\0\0\0\x0B\x01\0\0\n\x01\0\0\n\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\xFE\0\x02\0\x0B\x01\0\0\xF8\0\x02\0\xF2\0\0\0Q\0\x05\0\x07\0\0\0\x0C\x01\0\0\xDF\0\0\0\0\0\0\0P\0\x06\0\x10\0\0\0\r\x01\0\0\x0C\x01\0\0\x0C\x01\0\0\x0C\x01\0\0\xC2\0\x05\0\x10\0\0\0\x0E\x01\0\0\r\x01\0\0\xE5\0\0\0\xC7\0\x05\0\x10\0\0\0\x0F\x01\0\0\x0E\x01\0\0\xE7\0\0\0p\0\x04\0\x11\0\0\0\x10\x01\0\0\x0F\x01\0\0\x88\0\x05\0\x11\0\0\0\x11\x01\0\0\x10\x01\0\0\xE9\0\0\0\xFE\0\x02\0\x11\x01\0\0\xF8\0\x02\0\xEB\0\0\0\xFE\0\x02\0\x12\x01\0\08\0\x01\x006\0\x05\0\x04\0\0\0\x16\x01\0\0\0\0\0\0\x17\x01\0\x007\0\x03\0\r\0\0\0\x14\x01\0\x007\0\x03\0\x07\0\0\0\x15\x01\0\0\xF8\0\x02\0\x13\x01\0\0A\0\x05\0\xA2\0\0\0\x18\x01\0\0\"\0\0\0Z\0\0\0A\0\x05\0\xA4\0\0\0\x19\x01\0\0%\0\0\0Z\0\0\0A\0\x05\0\xA4\0\0\0\x1A\x01\0\0(\0\0\0Z\0\0\0\xF9\0\x02\0\x1B\x01\0\0\xF8\0\x02\0\x1B\x01\0\0A\0\x06\0\xA9\0\0\0\x1C\x01\0\0\x18\x01\0\0Z\0\0\0Z\0\0\0=\0\x04\0\x07\0\0\0\x1D\x01\0\0\x1C\x01\0\09\0\x05\0\x07\0\0\0\x1E\x01\0\0\xA0\0\0\0\x15\x01\0\0A\0\x06\0\xA9\0\0\0\x1F\x01\0\0\x18\x01\0\0Z\0\0\0a\0\0\0=\0\x04\0\x07\0\0\0 \x01\0\0\x1F\x01\0\0\x84\0\x05\0\x07\0\0\0!\x01\0\0\x1E\x01\0\0 \x01\0\0\x80\0\x05\0\x07\0\0\0\"\x01\0\0\x1D\x01\0\0!\x01\0\0A\0\x05\0\xB4\0\0\0#\x01\0\0\x19\x01\0\0\"\x01\0\0=\0\x04\0\x07\0\0\0$\x01\0\0#\x01\0\0\x80\0\x05\0\x07\0\0\0%\x01\0\0\"\x01\0\0a\0\0\0A\0\x05\0\xB4\0\0\0&\x01\0\0\x19\x01\0\0%\x01\0\0=\0\x04\0\x07\0\0\0'\x01\0\0&\x01\0\0\x80\0\x05\0\x07\0\0\0(\x01\0\0\"\x01\0\0\x06\0\0\0A\0\x05\0\xB4\0\0\0)\x01\0\0\x19\x01\0\0(\x01\0\0=\0\x04\0\x07\0\0\0*\x01\0\0)\x01\0\0P\0\x06\0\x10\0\0\0+\x01\0\0$\x01\0\0'\x01\0\0*\x01\0\0A\0\x06\0\xA9\0\0\0,\x01\0\0\x18\x01\0\0a\0\0\0Z\0\0\0=\0\x04\0\x07\0\0\0-\x01\0\0,\x01\0\09\0\x06\0\x11\0\0\0.\x01\0\0\xE1\0\0\0+\x01\0\0-\x01\0\0P\0\x05\0\x04\0\0\0/\x01\0\0.\x01\0\0\x17\0\0\0Q\0\x05\0\x04\0\0\x000\x01\0\0\x14\x01\0\0\x01\0\0\0\x94\0\x05\0\x03\0\0\x001\x01\0\x000\x01\0\0/\x01\0\0Q\0\x05\0\x04\0\0\x002\x01\0\0\x14\x01\0\0\x02\0\0\0\x94\0\x05\0\x03\0\0\x003\x01\0\x002\x01\0\0/\x01\0\0Q\0\x05\0\x04\0\0\x004\x01\0\0\x14\x01\0\0\x03\0\0\0\x94\0\x05\0\x03\0\0\x005\x01\0\x004\x01\0\0/\x01\0\0P\0\x07\0\x04\0\0\x006\x01\0\x001\x01\0\x003\x01\0\x005\x01\0\0\x17\0\0\0\xFE\0\x02\x006\x01\0\08\0\x01\x006\0\x05\0\x0E\0\0\0;\x01\0\0\0\0\0\0<\x01\0\x007\0\x03\0\x04\0\0\08\x01\0\x007\0\x03\0\x04\0\0\09\x01\0\x007\0\x03\0\x04\0\0\0:\x01\0\0\xF8\0\x02\x007\x01\0\0;\0\x05\0A\x01\0\0C\x01\0\0\x07\0\0\0D\x01\0\0;\0\x05\0A\x01\0\0G\x01\0\0\x07\0\0\0H\x01\0\0;\0\x05\0A\x01\0\0@\x01\0\0\x07\0\0\0B\x01\0\0;\0\x05\0A\x01\0\0E\x01\0\0\x07\0\0\0F\x01\0\0A\0\x05\0Y\0\0\0=\x01\0\0\x1F\0\0\0Z\0\0\0\xF9\0\x02\0I\x01\0\0\xF8\0\x02\0I\x01\0\0Q\0\x05\0\x03\0\0\0J\x01\0\08\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0K\x01\0\09\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0L\x01\0\0:\x01\0\0\0\0\0\0P\0\x06\0\x11\0\0\0M\x01\0\0J\x01\0\0K\x01\0\0L\x01\0\0Q\0\x05\0\x03\0\0\0N\x01\0\08\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0O\x01\0\09\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0P\x01\0\0:\x01\0\0\x01\0\0\0P\0\x06\0\x11\0\0\0Q\x01\0\0N\x01\0\0O\x01\0\0P\x01\0\0Q\0\x05\0\x03\0\0\0R\x01\0\08\x01\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0S\x01\0\09\x01\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0T\x01\0\0:\x01\0\0\x03\0\0\0P\0\x06\0\x11\0\0\0U\x01\0\0R\x01\0\0S\x01\0\0T\x01\0\0\xBA\0\x05\0V\x01\0\0W\x01\0\0M\x01\0\0U\x01\0\0\x9B\0\x04\0\x0E\0\0\0X\x01\0\0W\x01\0\0\xA8\0\x04\0\x0E\0\0\0Y\x01\0\0X\x01\0\0\xF7\0\x03\0Z\x01\0\0\0\0\0\0\xFA\0\x04\0Y\x01\0\0[\x01\0\0\\\x01\0\0\xF8\0\x02\0[\x01\0\0\x7F\0\x04\0\x11\0\0\0]\x01\0\0U\x01\0\0\xB8\0\x05\0V\x01\0\0^\x01\0\0M\x01\0\0]\x01\0\0\x9B\0\x04\0\x0E\0\0\0_\x01\0\0^\x01\0\0>\0\x03\0@\x01\0\0_\x01\0\0\xF9\0\x02\0Z\x01\0\0\xF8\0\x02\0\\\x01\0\0>\0\x03\0@\x01\0\0>\x01\0\0\xF9\0\x02\0Z\x01\0\0\xF8\0\x02\0Z\x01\0\0=\0\x04\0\x0E\0\0\0`\x01\0\0@\x01\0\0A\0\x06\0r\0\0\0b\x01\0\0=\x01\0\0a\x01\0\0a\0\0\0=\0\x04\0\x03\0\0\0c\x01\0\0b\x01\0\0\x8E\0\x05\0\x11\0\0\0d\x01\0\0U\x01\0\0c\x01\0\0\xBA\0\x05\0V\x01\0\0e\x01\0\0Q\x01\0\0d\x01\0\0\x9B\0\x04\0\x0E\0\0\0f\x01\0\0e\x01\0\0\xA8\0\x04\0\x0E\0\0\0g\x01\0\0f\x01\0\0\xF7\0\x03\0h\x01\0\0\0\0\0\0\xFA\0\x04\0g\x01\0\0i\x01\0\0j\x01\0\0\xF8\0\x02\0i\x01\0\0A\0\x06\0r\0\0\0k\x01\0\0=\x01\0\0a\x01\0\0Z\0\0\0=\0\x04\0\x03\0\0\0l\x01\0\0k\x01\0\0\x8E\0\x05\0\x11\0\0\0m\x01\0\0U\x01\0\0l\x01\0\0\xB8\0\x05\0V\x01\0\0n\x01\0\0Q\x01\0\0m\x01\0\0\x9B\0\x04\0\x0E\0\0\0o\x01\0\0n\x01\0\0>\0\x03\0C\x01\0\0o\x01\0\0\xF9\0\x02\0h\x01\0\0\xF8\0\x02\0j\x01\0\0>\0\x03\0C\x01\0\0>\x01\0\0\xF9\0\x02\0h\x01\0\0\xF8\0\x02\0h\x01\0\0=\0\x04\0\x0E\0\0\0p\x01\0\0C\x01\0\0\xA8\0\x04\0\x0E\0\0\0q\x01\0\0`\x01\0\0\xF7\0\x03\0r\x01\0\0\0\0\0\0\xFA\0\x04\0q\x01\0\0s\x01\0\0t\x01\0\0\xF8\0\x02\0s\x01\0\0>\0\x03\0E\x01\0\0p\x01\0\0\xF9\0\x02\0r\x01\0\0\xF8\0\x02\0t\x01\0\0>\0\x03\0E\x01\0\0>\x01\0\0\xF9\0\x02\0r\x01\0\0\xF8\0\x02\0r\x01\0\0=\0\x04\0\x0E\0\0\0u\x01\0\0E\x01\0\0\xA8\0\x04\0\x0E\0\0\0v\x01\0\0u\x01\0\0\xF7\0\x03\0w\x01\0\0\0\0\0\0\xFA\0\x04\0v\x01\0\0x\x01\0\0y\x01\0\0\xF8\0\x02\0x\x01\0\0\xBC\0\x05\0V\x01\0\0z\x01\0\0U\x01\0\0?\x01\0\0\x9B\0\x04\0\x0E\0\0\0{\x01\0\0z\x01\0\0>\0\x03\0G\x01\0\0{\x01\0\0\xF9\0\x02\0w\x01\0\0\xF8\0\x02\0y\x01\0\0>\0\x03\0G\x01\0\0>\x01\0\0\xF9\0\x02\0w\x01\0\0\xF8\0\x02\0w\x01\0\0=\0\x04\0\x0E\0\0\0|\x01\0\0G\x01\0\0\xFE\0\x02\0|\x01\0\08\0\x01\x006\0\x05\0\x0E\0\0\0\x7F\x01\0\0\0\0\0\0\x80\x01\0\x007\0\x03\0\x04\0\0\0~\x01\0\0\xF8\0\x02\0}\x01\0\0;\0\x05\0A\x01\0\0\x83\x01\0\0\x07\0\0\0\x84\x01\0\0;\0\x05\0A\x01\0\0\x85\x01\0\0\x07\0\0\0\x86\x01\0\0;\0\x05\0A\x01\0\0\x87\x01\0\0\x07\0\0\0\x88\x01\0\0A\0\x05\0Y\0\0\0\x81\x01\0\0\x1F\0\0\0Z\0\0\0\xF9\0\x02\0\x89\x01\0\0\xF8\0\x02\0\x89\x01\0\0A\0\x06\0r\0\0\0\x8A\x01\0\0\x81\x01\0\0a\x01\0\0Z\0\0\0=\0\x04\0\x03\0\0\0\x8B\x01\0\0\x8A\x01\0\0A\0\x06\0r\0\0\0\x8C\x01\0\0\x81\x01\0\0a\x01\0\0Z\0\0\0=\0\x04\0\x03\0\0\0\x8D\x01\0\0\x8C\x01\0\0\x85\0\x05\0\x03\0\0\0\x8E\x01\0\0\x14\0\0\0\x8D\x01\0\0\x0C\0\x07\0\x03\0\0\0\x8F\x01\0\0\x01\0\0\0%\0\0\0\x8B\x01\0\0\x8E\x01\0\0A\0\x06\0r\0\0\0\x90\x01\0\0\x81\x01\0\0a\x01\0\0a\0\0\0=\0\x04\0\x03\0\0\0\x91\x01\0\0\x90\x01\0\0\x85\0\x05\0\x03\0\0\0\x92\x01\0\0\x1C\0\0\0\x91\x01\0\0Q\0\x05\0\x03\0\0\0\x93\x01\0\0~\x01\0\0\0\0\0\0\x0C\0\x06\0\x03\0\0\0\x94\x01\0\0\x01\0\0\0\x04\0\0\0\x93\x01\0\0Q\0\x05\0\x03\0\0\0\x95\x01\0\0~\x01\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\x96\x01\0\0\x1B\0\0\0\x95\x01\0\0\xBC\0\x05\0\x0E\0\0\0\x97\x01\0\0\x94\x01\0\0\x96\x01\0\0Q\0\x05\0\x03\0\0\0\x98\x01\0\0~\x01\0\0\x03\0\0\0\xBA\0\x05\0\x0E\0\0\0\x99\x01\0\0\x98\x01\0\0{\0\0\0\xF7\0\x03\0\x9A\x01\0\0\0\0\0\0\xFA\0\x04\0\x99\x01\0\0\x9B\x01\0\0\x9C\x01\0\0\xF8\0\x02\0\x9B\x01\0\0>\0\x03\0\x83\x01\0\0\x97\x01\0\0\xF9\0\x02\0\x9A\x01\0\0\xF8\0\x02\0\x9C\x01\0\0>\0\x03\0\x83\x01\0\0\x82\x01\0\0\xF9\0\x02\0\x9A\x01\0\0\xF8\0\x02\0\x9A\x01\0\0=\0\x04\0\x0E\0\0\0\x9D\x01\0\0\x83\x01\0\0\xF7\0\x03\0\x9E\x01\0\0\0\0\0\0\xFA\0\x04\0\x9D\x01\0\0\x9F\x01\0\0\xA0\x01\0\0\xF8\0\x02\0\x9F\x01\0\0Q\0\x05\0\x03\0\0\0\xA1\x01\0\0~\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xA2\x01\0\0~\x01\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\xA3\x01\0\0\x8F\x01\0\0\xA2\x01\0\0\xBE\0\x05\0\x0E\0\0\0\xA4\x01\0\0\xA1\x01\0\0\xA3\x01\0\0>\0\x03\0\x85\x01\0\0\xA4\x01\0\0\xF9\0\x02\0\x9E\x01\0\0\xF8\0\x02\0\xA0\x01\0\0>\0\x03\0\x85\x01\0\0\x82\x01\0\0\xF9\0\x02\0\x9E\x01\0\0\xF8\0\x02\0\x9E\x01\0\0=\0\x04\0\x0E\0\0\0\xA5\x01\0\0\x85\x01\0\0\xF7\0\x03\0\xA6\x01\0\0\0\0\0\0\xFA\0\x04\0\xA5\x01\0\0\xA7\x01\0\0\xA8\x01\0\0\xF8\0\x02\0\xA7\x01\0\0Q\0\x05\0\x03\0\0\0\xA9\x01\0\0~\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xAA\x01\0\0~\x01\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\xAB\x01\0\0\x92\x01\0\0\xAA\x01\0\0\xBC\0\x05\0\x0E\0\0\0\xAC\x01\0\0\xA9\x01\0\0\xAB\x01\0\0>\0\x03\0\x87\x01\0\0\xAC\x01\0\0\xF9\0\x02\0\xA6\x01\0\0\xF8\0\x02\0\xA8\x01\0\0>\0\x03\0\x87\x01\0\0\x82\x01\0\0\xF9\0\x02\0\xA6\x01\0\0\xF8\0\x02\0\xA6\x01\0\0=\0\x04\0\x0E\0\0\0\xAD\x01\0\0\x87\x01\0\0\xFE\0\x02\0\xAD\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xB1\x01\0\0\0\0\0\0\xB2\x01\0\x007\0\x03\0\x03\0\0\0\xAF\x01\0\x007\0\x03\0\x03\0\0\0\xB0\x01\0\0\xF8\0\x02\0\xAE\x01\0\0A\0\x05\0Y\0\0\0\xB3\x01\0\0\x1F\0\0\0Z\0\0\0\xF9\0\x02\0\xB5\x01\0\0\xF8\0\x02\0\xB5\x01\0\0A\0\x07\0r\0\0\0\xB6\x01\0\0\xB3\x01\0\0s\0\0\0a\0\0\0Z\0\0\0=\0\x04\0\x03\0\0\0\xB7\x01\0\0\xB6\x01\0\0\xBC\0\x05\0\x0E\0\0\0\xB8\x01\0\0\xB0\x01\0\0\xB7\x01\0\0\xF7\0\x03\0\xB9\x01\0\0\0\0\0\0\xFA\0\x04\0\xB8\x01\0\0\xBA\x01\0\0\xB9\x01\0\0\xF8\0\x02\0\xBA\x01\0\0\xFE\0\x02\0{\0\0\0\xF8\0\x02\0\xB9\x01\0\0\x83\0\x05\0\x03\0\0\0\xBB\x01\0\0\xB0\x01\0\0\xAF\x01\0\0\x0C\0\x07\0\x03\0\0\0\xBC\x01\0\0\x01\0\0\0(\0\0\0\xAF\x01\0\0\xB7\x01\0\0\x88\0\x05\0\x03\0\0\0\xBD\x01\0\0\xBB\x01\0\0\xBC\x01\0\0\x85\0\x05\0\x03\0\0\0\xBE\x01\0\0\xB4\x01\0\0\xBD\x01\0\0\x85\0\x05\0\x03\0\0\0\xBF\x01\0\0\xBE\x01\0\0\xBD\x01\0\0A\0\x05\0q\0\0\0\xC0\x01\0\0\xB3\x01\0\0s\0\0\0=\0\x04\0\x05\0\0\0\xC1\x01\0\0\xC0\x01\0\09\0\x06\0\x03\0\0\0\xC2\x01\0\0I\0\0\0\xC1\x01\0\0\xB0\x01\0\0\x85\0\x05\0\x03\0\0\0\xC3\x01\0\0\xC2\x01\0\0\xB0\x01\0\0\x0C\0\x06\0\x03\0\0\0\xC4\x01\0\0\x01\0\0\0\x04\0\0\0\xC3\x01\0\0\x85\0\x05\0\x03\0\0\0\xC5\x01\0\0\xBF\x01\0\0\xC4\x01\0\0\xFE\0\x02\0\xC5\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xC9\x01\0\0\0\0\0\0\xCA\x01\0\x007\0\x03\0\x04\0\0\0\xC7\x01\0\x007\0\x03\0\x04\0\0\0\xC8\x01\0\0\xF8\0\x02\0\xC6\x01\0\0;\0\x05\0A\x01\0\0\xCC\x01\0\0\x07\0\0\0\xCD\x01\0\0A\0\x05\0Y\0\0\0\xCB\x01\0\0\x1F\0\0\0Z\0\0\0\xF9\0\x02\0\xCE\x01\0\0\xF8\0\x02\0\xCE\x01\0\09\0\x05\0\x0E\0\0\0\xCF\x01\0\0\x7F\x01\0\0\xC7\x01\0\0\xF7\0\x03\0\xD0\x01\0\0\0\0\0\0\xFA\0\x04\0\xCF\x01\0\0\xD1\x01\0\0\xD2\x01\0\0\xF8\0\x02\0\xD1\x01\0\09\0\x05\0\x0E\0\0\0\xD3\x01\0\0\x7F\x01\0\0\xC8\x01\0\0>\0\x03\0\xCC\x01\0\0\xD3\x01\0\0\xF9\0\x02\0\xD0\x01\0\0\xF8\0\x02\0\xD2\x01\0\0>\0\x03\0\xCC\x01\0\0\x82\x01\0\0\xF9\0\x02\0\xD0\x01\0\0\xF8\0\x02\0\xD0\x01\0\0=\0\x04\0\x0E\0\0\0\xD4\x01\0\0\xCC\x01\0\0\xA8\0\x04\0\x0E\0\0\0\xD5\x01\0\0\xD4\x01\0\0\xF7\0\x03\0\xD6\x01\0\0\0\0\0\0\xFA\0\x04\0\xD5\x01\0\0\xD7\x01\0\0\xD6\x01\0\0\xF8\0\x02\0\xD7\x01\0\0\xFE\0\x02\0\x1E\0\0\0\xF8\0\x02\0\xD6\x01\0\0Q\0\x05\0\x03\0\0\0\xD8\x01\0\0\xC7\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xD9\x01\0\0\xC7\x01\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\xDA\x01\0\0\xD8\x01\0\0\xD9\x01\0\0Q\0\x05\0\x03\0\0\0\xDB\x01\0\0\xC8\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xDC\x01\0\0\xC8\x01\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\xDD\x01\0\0\xDB\x01\0\0\xDC\x01\0\0A\0\x06\0r\0\0\0\xE0\x01\0\0\xCB\x01\0\0\xDF\x01\0\0a\0\0\0=\0\x04\0\x03\0\0\0\xE1\x01\0\0\xE0\x01\0\0\x85\0\x05\0\x03\0\0\0\xE2\x01\0\0\x16\0\0\0\xE1\x01\0\0\x0C\0\x07\0\x03\0\0\0\xE3\x01\0\0\x01\0\0\0%\0\0\0\xDA\x01\0\0\xDD\x01\0\0\x0C\0\x07\0\x03\0\0\0\xE4\x01\0\0\x01\0\0\0(\0\0\0\xDA\x01\0\0\xDD\x01\0\09\0\x06\0\x03\0\0\0\xE5\x01\0\0\xB1\x01\0\0\xE3\x01\0\0\xE4\x01\0\0\x85\0\x05\0\x03\0\0\0\xE6\x01\0\0\xE2\x01\0\0\xE5\x01\0\0\xFE\0\x02\0\xE6\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xEB\x01\0\0\0\0\0\0\xEC\x01\0\x007\0\x03\0\x04\0\0\0\xE8\x01\0\x007\0\x03\0\x04\0\0\0\xE9\x01\0\x007\0\x03\0\x04\0\0\0\xEA\x01\0\0\xF8\0\x02\0\xE7\x01\0\0A\0\x05\0Y\0\0\0\xED\x01\0\0\x1F\0\0\0Z\0\0\0\xF9\0\x02\0\xEE\x01\0\0\xF8\0\x02\0\xEE\x01\0\09\0\x06\0\x03\0\0\0\xEF\x01\0\0\xC9\x01\0\0\xE8\x01\0\0\xE9\x01\0\09\0\x06\0\x03\0\0\0\xF0\x01\0\0\xC9\x01\0\0\xE9\x01\0\0\xEA\x01\0\09\0\x06\0\x03\0\0\0\xF1\x01\0\0\xC9\x01\0\0\xEA\x01\0\0\xE8\x01\0\0\x0C\0\x07\0\x03\0\0\0\xF2\x01\0\0\x01\0\0\0(\0\0\0\xF0\x01\0\0\xF1\x01\0\0\x0C\0\x07\0\x03\0\0\0\xF3\x01\0\0\x01\0\0\0(\0\0\0\xEF\x01\0\0\xF2\x01\0\0\xFE\0\x02\0\xF3\x01\0\08\0\x01\x006\0\x05\0\x04\0\0\0\xF6\x01\0\0\0\0\0\0\xF7\x01\0\x007\0\x03\0\r\0\0\0\xF5\x01\0\0\xF8\0\x02\0\xF4\x01\0\0;\0\x05\0A\x01\0\0\xFD\x01\0\0\x07\0\0\0\xFE\x01\0\0A\0\x05\0Y\0\0\0\xF8\x01\0\0\x1F\0\0\0Z\0\0\0A\0\x05\0\xA2\0\0\0\xF9\x01\0\0\"\0\0\0Z\0\0\0A\0\x05\0\xA4\0\0\0\xFA\x01\0\0%\0\0\0Z\0\0\0A\0\x05\0\xA4\0\0\0\xFB\x01\0\0(\0\0\0Z\0\0\0\xF9\0\x02\0\xFF\x01\0\0\xF8\0\x02\0\xFF\x01\0\0Q\0\x05\0\x07\0\0\0\0\x02\0\0\xF5\x01\0\0\0\0\0\0\x89\0\x05\0\x07\0\0\0\x01\x02\0\0\0\x02\0\0\x13\0\0\0Q\0\x05\0\x07\0\0\0\x02\x02\0\0\xF5\x01\0\0\0\0\0\0\x82\0\x05\0\x07\0\0\0\x03\x02\0\0\x02\x02\0\0\x01\x02\0\09\0\x06\0\x04\0\0\0\x04\x02\0\0\x16\x01\0\0\xF5\x01\0\0\x03\x02\0\0\x80\0\x05\0\x07\0\0\0\x05\x02\0\0\x03\x02\0\0a\0\0\09\0\x06\0\x04\0\0\0\x06\x02\0\0\x16\x01\0\0\xF5\x01\0\0\x05\x02\0\0\x80\0\x05\0\x07\0\0\0\x07\x02\0\0\x03\x02\0\0\x06\0\0\09\0\x06\0\x04\0\0\0\x08\x02\0\0\x16\x01\0\0\xF5\x01\0\0\x07\x02\0\0P\0\x06\0\x12\0\0\0\t\x02\0\0\x04\x02\0\0\x06\x02\0\0\x08\x02\0\0Q\0\x05\0\x04\0\0\0\n\x02\0\0\t\x02\0\0\x02\0\0\0Q\0\x05\0\x04\0\0\0\x0B\x02\0\0\t\x02\0\0\x01\0\0\0\xAA\0\x05\0\x0E\0\0\0\x0C\x02\0\0\x01\x02\0\0a\0\0\0P\0\x07\0\x0E\x02\0\0\x0F\x02\0\0\x0C\x02\0\0\x0C\x02\0\0\x0C\x02\0\0\x0C\x02\0\0\xA9\0\x06\0\x04\0\0\0\r\x02\0\0\x0F\x02\0\0\x0B\x02\0\0\n\x02\0\0Q\0\x05\0\x04\0\0\0\x10\x02\0\0\t\x02\0\0\0\0\0\0\xAA\0\x05\0\x0E\0\0\0\x11\x02\0\0\x01\x02\0\0Z\0\0\0P\0\x07\0\x0E\x02\0\0\x13\x02\0\0\x11\x02\0\0\x11\x02\0\0\x11\x02\0\0\x11\x02\0\0\xA9\0\x06\0\x04\0\0\0\x12\x02\0\0\x13\x02\0\0\x10\x02\0\0\r\x02\0\09\0\x04\0\x0E\0\0\0\x14\x02\0\0m\0\0\0\xF7\0\x03\0\x15\x02\0\0\0\0\0\0\xFA\0\x04\0\x14\x02\0\0\x16\x02\0\0\x15\x02\0\0\xF8\0\x02\0\x16\x02\0\0Q\0\x05\0\x04\0\0\0\x17\x02\0\0\t\x02\0\0\0\0\0\09\0\x05\0\x04\0\0\0\x18\x02\0\0W\0\0\0\x17\x02\0\0Q\0\x05\0\x04\0\0\0\x19\x02\0\0\t\x02\0\0\x01\0\0\09\0\x05\0\x04\0\0\0\x1A\x02\0\0W\0\0\0\x19\x02\0\0Q\0\x05\0\x04\0\0\0\x1B\x02\0\0\t\x02\0\0\x02\0\0\09\0\x05\0\x04\0\0\0\x1C\x02\0\0W\0\0\0\x1B\x02\0\09\0\x07\0\x0E\0\0\0\x1D\x02\0\0;\x01\0\0\x18\x02\0\0\x1A\x02\0\0\x1C\x02\0\0\xA8\0\x04\0\x0E\0\0\0\x1E\x02\0\0\x1D\x02\0\0\xF7\0\x03\0\x1F\x02\0\0\0\0\0\0\xFA\0\x04\0\x1E\x02\0\0 \x02\0\0!\x02\0\0\xF8\0\x02\0 \x02\0\09\0\x07\0\x03\0\0\0\"\x02\0\0\xEB\x01\0\0\x18\x02\0\0\x1A\x02\0\0\x1C\x02\0\0\xBC\0\x05\0\x0E\0\0\0#\x02\0\0\"\x02\0\0\x14\0\0\0\xA8\0\x04\0\x0E\0\0\0$\x02\0\0#\x02\0\0>\0\x03\0\xFD\x01\0\0$\x02\0\0\xF9\0\x02\0\x1F\x02\0\0\xF8\0\x02\0!\x02\0\0>\0\x03\0\xFD\x01\0\0>\x01\0\0\xF9\0\x02\0\x1F\x02\0\0\xF8\0\x02\0\x1F\x02\0\0=\0\x04\0\x0E\0\0\0%\x02\0\0\xFD\x01\0\0\xF7\0\x03\0&\x02\0\0\0\0\0\0\xFA\0\x04\0%\x02\0\0'\x02\0\0&\x02\0\0\xF8\0\x02\0'\x02\0\0\xFE\0\x02\0\xFC\x01\0\0\xF8\0\x02\0&\x02\0\0\xF9\0\x02\0\x15\x02\0\0\xF8\0\x02\0\x15\x02\0\0\xFE\0\x02\0\x12\x02\0\08\0\x01\x006\0\x05\0\x02\0\0\x006\x02\0\0\0\0\0\x007\x02\0\0\xF8\0\x02\0(\x02\0\0=\0\x04\0\x07\0\0\0,\x02\0\0*\x02\0\0=\0\x04\0\x04\0\0\0/\x02\0\0-\x02\0\0=\0\x04\0\x04\0\0\x001\x02\0\x000\x02\0\0=\0\x04\0\x04\0\0\x003\x02\0\x002\x02\0\0P\0\x07\0\r\0\0\0)\x02\0\0,\x02\0\0/\x02\0\x001\x02\0\x003\x02\0\0A\0\x05\0Y\0\0\08\x02\0\0\x1F\0\0\0Z\0\0\0A\0\x05\0\xA2\0\0\09\x02\0\0\"\0\0\0Z\0\0\0A\0\x05\0\xA4\0\0\0:\x02\0\0%\0\0\0Z\0\0\0A\0\x05\0\xA4\0\0\0;\x02\0\0(\0\0\0Z\0\0\0\xF9\0\x02\0<\x02\0\0\xF8\0\x02\0<\x02\0\09\0\x05\0\x04\0\0\0=\x02\0\0\xF6\x01\0\0)\x02\0\09\0\x05\0\x04\0\0\0>\x02\0\0y\0\0\0=\x02\0\0>\0\x03\x004\x02\0\0>\x02\0\0\xFD\0\x01\08\0\x01\0";
    /// WGSL of the capture_clamped shader.
    pub const CAPTURE_CLAMPED_WGSL: &str = r#"// SunLog: renders casters into one tile of the shadow map; clamps depth by itself.
// Positions are relative to the eye, in the capture's axes: the camera's (x right, y up, looking along -z), sheared as the plan says.
// Sun over an open world without a step: face columns whose rows run with the logarithm of distance, casters that
// span many rows decided pixel by pixel.
// Generated from light case `SunLog`, ed72eb4d5233de5a. Do not edit.

/// Texels along the rows that edges of casters may be off.
const SUN_LOG_STRETCH_BOUND: f32 = 0.25;

/// What capturing needs of one facet, in the capture's axes: its matrix, row by row.
struct SunLogCapture {
    /// Clip x of the tile, to the right.
    row_x: vec4<f32>,
    /// Clip y of the tile, upwards.
    row_y: vec4<f32>,
    /// Clip z: depth along the light times w.
    row_z: vec4<f32>,
    /// Clip w, positive on receivers.
    row_w: vec4<f32>,
    /// How y/w becomes clip y: shifts and scales of a monotone curve.
    remap: array<vec4<f32>, 2>,
    /// Width and height of the tile in texels.
    tile_size: vec2<f32>,
    /// Smallest and largest k of the tile (xy), map texel of its upper left corner (zw).
    stretch_tile: vec4<f32>,
}

/// The facet that is captured.
@group(0) @binding(0)
var<uniform> sun_log_capture: SunLogCapture;
/// Where the caster's vertices lie in its buffers.
@group(1) @binding(0)
var<uniform> sun_log_mesh_layout: array<vec4<u32>, 2>;
/// Positions of the caster, as words.
@group(1) @binding(1)
var<storage, read> sun_log_mesh_positions: array<u32>;
/// Indices of the caster, as words.
@group(1) @binding(2)
var<storage, read> sun_log_mesh_indices: array<u32>;

/// Clip y after division, of one over distance.
fn sun_log_remapped(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].y + remap[1].z * inverse_distance;
    }
    return remap[0].x + remap[0].y * log(inverse_distance * remap[0].z);
}

/// Change of clip y after division per change of one over distance.
fn sun_log_remap_slope(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].z;
    }
    return remap[0].y / inverse_distance;
}

/// A position of the tile at a depth that no clip plane meets: half way between the clipper's limits.
fn sun_log_hidden_depth(tile: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(tile.xy, 0.5 * tile.w, tile.w);
}

/// The depth that an unclipped capture would store, from the facet's clip z and w.
fn sun_log_clamped_depth(depth_times_w: f32, w: f32) -> f32 {
    return clamp(depth_times_w / w, 0.0, 1.0);
}

/// What the vertex stage of the clamped capture hands to its fragment stage.
struct SunLogClampedCaster {
    /// Position in the tile, at a depth that no clip plane meets.
    @builtin(position) tile: vec4<f32>,
    /// Clip z of the facet: depth times w.
    @location(0) depth_times_w: f32,
    /// Clip w of the facet.
    @location(1) w: f32,
}

/// Places a caster's vertex in the tile, but keeps its depth for the fragment stage.
@vertex
fn sun_log_capture_clamped_vertex(vertex: SunLogCasterVertex) -> SunLogClampedCaster {
    let tile = sun_log_tile_position(sun_log_capture_position(vertex));
    return SunLogClampedCaster(sun_log_hidden_depth(tile), tile.z, tile.w);
}

/// Writes the depth that an unclipped capture would store.
@fragment
fn sun_log_capture_clamped_fragment(caster: SunLogClampedCaster) -> @builtin(frag_depth) f32 {
    return sun_log_clamped_depth(caster.depth_times_w, caster.w);
}

/// Largest k of a horizon; rows without any bend end there.
const SUN_LOG_STRAIGHT_HORIZON: f32 = 1e38;

/// Whether the facet's rows are bent at all.
fn sun_log_is_bent() -> bool {
    return sun_log_capture.remap[1].x < SUN_LOG_STRAIGHT_HORIZON;
}

/// Bound of the distance, in clip y, between the bent rows from one k to a larger one and the chord across them.
fn sun_log_chord_error(low: f32, high: f32) -> f32 {
    let horizon = sun_log_capture.remap[1].x;
    if high <= horizon {
        return 0.0;
    }

    // The second derivative is largest where the curve begins.
    let relative = (high - low) / max(low, horizon);
    return 0.125 * relative * relative * abs(sun_log_remap_slope(sun_log_capture.remap, high) * high);
}

/// A corner of a caster's triangle, or of what is drawn for it.
struct SunLogCasterVertex {
    /// Its number in the draw.
    @builtin(vertex_index) number: u32,
    /// First of the instance's rows; they take the object's space to the capture's axes, relative to the eye.
    @location(1) eye_from_object_x: vec4<f32>,
    /// Second row.
    @location(2) eye_from_object_y: vec4<f32>,
    /// Third row.
    @location(3) eye_from_object_z: vec4<f32>,
}

/// Position of a corner of the mesh's triangle list in the capture's axes.
fn sun_log_corner_position(caster: SunLogCasterVertex, corner: u32) -> vec4<f32> {
    let word = sun_log_mesh_layout[0].x + sun_log_mesh_vertex(corner) * sun_log_mesh_layout[0].y;
    let words = vec3<u32>(sun_log_mesh_positions[word], sun_log_mesh_positions[word + 1u], sun_log_mesh_positions[word + 2u]);
    let object = vec4<f32>(sun_log_decoded(words, sun_log_mesh_layout[1].x), 1.0);
    return vec4<f32>(
        dot(caster.eye_from_object_x, object),
        dot(caster.eye_from_object_y, object),
        dot(caster.eye_from_object_z, object),
        1.0,
    );
}

/// The vertex of a corner of the mesh's triangle list.
fn sun_log_mesh_vertex(corner: u32) -> u32 {
    let index = sun_log_mesh_layout[0].z + corner;
    switch sun_log_mesh_layout[0].w {
        case 0u: {
            return corner;
        }
        case 1u: {
            return extractBits(sun_log_mesh_indices[index / 2u], 16u * (index % 2u), 16u);
        }
        default: {
            return sun_log_mesh_indices[index];
        }
    }
}

/// The floats that a vertex fetch makes of words.
fn sun_log_decoded(words: vec3<u32>, format: u32) -> vec3<f32> {
    switch format {
        case 0u: {
            return bitcast<vec3<f32>>(words);
        }
        case 1u: {
            return vec3<f32>(sun_log_half_floats(words.x), sun_log_half_floats(words.y).x);
        }
        case 2u: {
            return vec3<f32>(unpack2x16snorm(words.x), unpack2x16snorm(words.y).x);
        }
        case 3u: {
            return vec3<f32>(unpack2x16unorm(words.x), unpack2x16unorm(words.y).x);
        }
        case 4u: {
            return unpack4x8snorm(words.x).xyz;
        }
        case 5u: {
            return unpack4x8unorm(words.x).xyz;
        }
        default: {
            return vec3<f32>((vec3<u32>(words.x) >> vec3<u32>(0u, 10u, 20u)) & vec3<u32>(1023u)) / 1023.0;
        }
    }
}

/// The two half floats of a word; infinities are large numbers.
fn sun_log_half_floats(word: u32) -> vec2<f32> {
    let halves = vec2<u32>(word & 0xffffu, word >> 16u);
    let magnitudes = halves & vec2<u32>(0x7fffu);
    let normal = bitcast<vec2<f32>>((magnitudes << vec2<u32>(13u)) + vec2<u32>(112u << 23u));
    let small = vec2<f32>(magnitudes) * SUN_LOG_SMALLEST_HALF;
    let values = select(normal, small, magnitudes < vec2<u32>(0x400u));
    return select(values, -values, halves > vec2<u32>(0x7fffu));
}

/// The smallest half float above zero.
const SUN_LOG_SMALLEST_HALF: f32 = 5.9604645e-8;

/// Applies the facet's matrix, row by row, to a position in the capture's axes; y/w is k, which is not bent yet.
fn sun_log_straight_corner(position: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(
        dot(sun_log_capture.row_x, position),
        dot(sun_log_capture.row_y, position),
        dot(sun_log_capture.row_z, position),
        dot(sun_log_capture.row_w, position),
    );
}

/// How far from the tile a corner may lie, in tiles, and in multiples of the nearest and farthest k.
const SUN_LOG_FARTHEST_CORNER: vec3<f32> = vec3<f32>(64.0, 4.0, 0.25);

/// Whether a corner has a place in the bent tile or not too far from it; none has at w = 0 and behind.
fn sun_log_has_place(corner: vec4<f32>) -> bool {
    let low = min(sun_log_capture.stretch_tile.x, SUN_LOG_FARTHEST_CORNER.z * sun_log_capture.stretch_tile.x);
    let high = SUN_LOG_FARTHEST_CORNER.y * sun_log_capture.stretch_tile.y;
    let is_beside = abs(corner.x) <= SUN_LOG_FARTHEST_CORNER.x * corner.w;
    return corner.w > 0.0 && is_beside && corner.y >= low * corner.w && corner.y <= high * corner.w;
}

/// Whether all of a triangle lies outside one edge of the tile.
fn sun_log_is_outside(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> bool {
    let x = vec3<f32>(one.x, two.x, three.x);
    let y = vec3<f32>(one.y, two.y, three.y);
    let w = vec3<f32>(one.w, two.w, three.w);
    let is_aside = all(x > w) || all(x < -w);
    let is_before = all(y > sun_log_capture.stretch_tile.y * w) || all(y < sun_log_capture.stretch_tile.x * w);
    return is_aside || is_before || all(w <= vec3<f32>(0.0));
}

/// Texels by which an edge with straight ends misses the bent one; beyond any bound where an end has no place.
fn sun_log_edge_error(one: vec4<f32>, two: vec4<f32>) -> f32 {
    if !(sun_log_has_place(one) && sun_log_has_place(two)) {
        return SUN_LOG_NO_PLACE;
    }
    let start = one.y / one.w;
    let end = two.y / two.w;
    return 0.5 * sun_log_capture.tile_size.y * sun_log_chord_error(min(start, end), max(start, end));
}

/// An error beyond any bound.
const SUN_LOG_NO_PLACE: f32 = 1e30;

/// The largest of a triangle's edges' errors; no point inside is farther off.
fn sun_log_triangle_error(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> f32 {
    return max(sun_log_edge_error(one, two), max(sun_log_edge_error(two, three), sun_log_edge_error(three, one)));
}

/// A position that no tile shows.
const SUN_LOG_HIDDEN: vec4<f32> = vec4<f32>(2.0, 2.0, 0.5, 1.0);

/// Moves a corner from its object to the eye, into the capture's axes; zero where the triangle is left out.
fn sun_log_capture_position(caster: SunLogCasterVertex) -> vec4<f32> {
    let number = caster.number % 3u;
    let first = caster.number - number;
    let positions = array<vec4<f32>, 3>(
        sun_log_corner_position(caster, first),
        sun_log_corner_position(caster, first + 1u),
        sun_log_corner_position(caster, first + 2u),
    );
    let position = select(select(positions[2], positions[1], number == 1u), positions[0], number == 0u);
    if sun_log_is_bent() {
        let one = sun_log_straight_corner(positions[0]);
        let two = sun_log_straight_corner(positions[1]);
        let three = sun_log_straight_corner(positions[2]);
        if sun_log_is_outside(one, two, three) || !(sun_log_triangle_error(one, two, three) <= SUN_LOG_STRETCH_BOUND) {
            return vec4<f32>(0.0);
        }
    }
    return position;
}

/// Applies the facet's matrix to a position in the capture's axes, and bends its y.
fn sun_log_tile_position(position: vec4<f32>) -> vec4<f32> {
    if position.w == 0.0 {
        return SUN_LOG_HIDDEN;
    }
    let corner = sun_log_straight_corner(position);
    if sun_log_is_bent() {
        return vec4<f32>(corner.x, sun_log_remapped(sun_log_capture.remap, corner.y / corner.w) * corner.w, corner.zw);
    }
    let y = sun_log_remapped(sun_log_capture.remap, 0.0) * corner.w + sun_log_remap_slope(sun_log_capture.remap, 0.0) * corner.y;
    return vec4<f32>(corner.x, y, corner.zw);
}
"#;
    /// SPIR-V of the capture_clamped shader, little-endian words.
    pub const CAPTURE_CLAMPED_SPIRV: &[u8] = b"\x03\x02#\x07\0\x03\x01\0\x1C\0\0\0i\x02\0\0\0\0\0\0\x11\0\x02\0\x01\0\0\0\x0B\0\x06\0\x01\0\0\0GLSL.std.450\0\0\0\0\x0E\0\x03\0\0\0\0\0\x01\0\0\0\x0F\0\x12\0\0\0\0\0J\x02\0\0sun_log_capture_clamped_vertex\0\0;\x02\0\0>\x02\0\0A\x02\0\0C\x02\0\0E\x02\0\0G\x02\0\0I\x02\0\0\x0F\0\x10\0\x04\0\0\0d\x02\0\0sun_log_capture_clamped_fragment\0\0\0\0\\\x02\0\0^\x02\0\0a\x02\0\0c\x02\0\0\x10\0\x03\0d\x02\0\0\x07\0\0\0\x10\0\x03\0d\x02\0\0\x0C\0\0\0G\0\x04\0\x05\0\0\0\x06\0\0\0\x10\0\0\0H\0\x05\0\t\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\t\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\t\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\t\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\t\0\0\0\x04\0\0\0#\0\0\0@\0\0\0H\0\x05\0\t\0\0\0\x05\0\0\0#\0\0\0`\0\0\0H\0\x05\0\t\0\0\0\x06\0\0\0#\0\0\0p\0\0\0G\0\x04\0\x0B\0\0\0\x06\0\0\0\x10\0\0\0G\0\x04\0\x0C\0\0\0\x06\0\0\0\x04\0\0\0H\0\x05\0\r\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\r\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\r\0\0\0\x02\0\0\0#\0\0\0\x14\0\0\0H\0\x05\0\x0E\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x0E\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x0E\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\x0E\0\0\0\x03\0\0\0#\0\0\x000\0\0\0G\0\x04\0\x13\0\0\0\x06\0\0\0\x10\0\0\0G\0\x04\0 \0\0\0\"\0\0\0\0\0\0\0G\0\x04\0 \0\0\0!\0\0\0\0\0\0\0G\0\x03\0!\0\0\0\x02\0\0\0H\0\x05\0!\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0#\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0#\0\0\0!\0\0\0\0\0\0\0G\0\x03\0$\0\0\0\x02\0\0\0H\0\x05\0$\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x03\0&\0\0\0\x18\0\0\0G\0\x04\0&\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0&\0\0\0!\0\0\0\x01\0\0\0G\0\x03\0'\0\0\0\x02\0\0\0H\0\x05\0'\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x03\0)\0\0\0\x18\0\0\0G\0\x04\0)\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0)\0\0\0!\0\0\0\x02\0\0\0G\0\x03\0*\0\0\0\x02\0\0\0H\0\x05\0*\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0;\x02\0\0\x0B\0\0\0*\0\0\0G\0\x04\0>\x02\0\0\x1E\0\0\0\x01\0\0\0G\0\x04\0A\x02\0\0\x1E\0\0\0\x02\0\0\0G\0\x04\0C\x02\0\0\x1E\0\0\0\x03\0\0\0G\0\x04\0E\x02\0\0\x0B\0\0\0\0\0\0\0G\0\x04\0G\x02\0\0\x1E\0\0\0\0\0\0\0G\0\x04\0I\x02\0\0\x1E\0\0\0\x01\0\0\0G\0\x04\0\\\x02\0\0\x0B\0\0\0\x0F\0\0\0G\0\x04\0^\x02\0\0\x1E\0\0\0\0\0\0\0G\0\x04\0a\x02\0\0\x1E\0\0\0\x01\0\0\0G\0\x04\0c\x02\0\0\x0B\0\0\0\x16\0\0\0\x13\0\x02\0\x02\0\0\0\x16\0\x03\0\x03\0\0\0 \0\0\0\x17\0\x04\0\x04\0\0\0\x03\0\0\0\x04\0\0\0\x15\0\x04\0\x07\0\0\0 \0\0\0\0\0\0\0+\0\x04\0\x07\0\0\0\x06\0\0\0\x02\0\0\0\x1C\0\x04\0\x05\0\0\0\x04\0\0\0\x06\0\0\0\x17\0\x04\0\x08\0\0\0\x03\0\0\0\x02\0\0\0\x1E\0\t\0\t\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x05\0\0\0\x08\0\0\0\x04\0\0\0\x17\0\x04\0\n\0\0\0\x07\0\0\0\x04\0\0\0\x1C\0\x04\0\x0B\0\0\0\n\0\0\0\x06\0\0\0\x1D\0\x03\0\x0C\0\0\0\x07\0\0\0\x1E\0\x05\0\r\0\0\0\x04\0\0\0\x03\0\0\0\x03\0\0\0\x1E\0\x06\0\x0E\0\0\0\x07\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x14\0\x02\0\x0F\0\0\0\x17\0\x04\0\x10\0\0\0\x07\0\0\0\x02\0\0\0\x17\0\x04\0\x11\0\0\0\x07\0\0\0\x03\0\0\0\x17\0\x04\0\x12\0\0\0\x03\0\0\0\x03\0\0\0+\0\x04\0\x07\0\0\0\x14\0\0\0\x03\0\0\0\x1C\0\x04\0\x13\0\0\0\x04\0\0\0\x14\0\0\0+\0\x04\0\x03\0\0\0\x15\0\0\0\0\0\x80>+\0\x04\0\x03\0\0\0\x16\0\0\0\0\0\0@+\0\x04\0\x03\0\0\0\x17\0\0\0\0\0\0?+\0\x04\0\x03\0\0\0\x18\0\0\0\0\0\x80?,\0\x07\0\x04\0\0\0\x19\0\0\0\x16\0\0\0\x16\0\0\0\x17\0\0\0\x18\0\0\0+\0\x04\0\x03\0\0\0\x1A\0\0\0\x99v\x96~+\0\x04\0\x03\0\0\0\x1B\0\0\0\0\0\x803+\0\x04\0\x03\0\0\0\x1C\0\0\0\0\0\x80B+\0\x04\0\x03\0\0\0\x1D\0\0\0\0\0\x80@,\0\x06\0\x12\0\0\0\x1E\0\0\0\x1C\0\0\0\x1D\0\0\0\x15\0\0\0+\0\x04\0\x03\0\0\0\x1F\0\0\0\xCA\xF2Iq\x1E\0\x03\0!\0\0\0\t\0\0\0 \0\x04\0\"\0\0\0\x02\0\0\0!\0\0\0;\0\x04\0\"\0\0\0 \0\0\0\x02\0\0\0\x1E\0\x03\0$\0\0\0\x0B\0\0\0 \0\x04\0%\0\0\0\x02\0\0\0$\0\0\0;\0\x04\0%\0\0\0#\0\0\0\x02\0\0\0\x1E\0\x03\0'\0\0\0\x0C\0\0\0 \0\x04\0(\0\0\0\x0C\0\0\0'\0\0\0;\0\x04\0(\0\0\0&\0\0\0\x0C\0\0\0\x1E\0\x03\0*\0\0\0\x0C\0\0\0 \0\x04\0+\0\0\0\x0C\0\0\0*\0\0\0;\0\x04\0+\0\0\0)\0\0\0\x0C\0\0\0!\0\x05\x000\0\0\0\x03\0\0\0\x05\0\0\0\x03\0\0\0!\0\x04\0Y\0\0\0\x04\0\0\0\x04\0\0\0!\0\x05\0d\0\0\0\x03\0\0\0\x03\0\0\0\x03\0\0\0+\0\x04\0\x03\0\0\0e\0\0\0\0\0\0\0 \0\x04\0l\0\0\0\x02\0\0\0\t\0\0\0+\0\x04\0\x07\0\0\0m\0\0\0\0\0\0\0 \0\x04\0p\0\0\0\x02\0\0\0\x04\0\0\0+\0\x04\0\x07\0\0\0t\0\0\0\x01\0\0\0!\0\x03\0\x81\0\0\0\x0F\0\0\0 \0\x04\0\x84\0\0\0\x02\0\0\0\x05\0\0\0 \0\x04\0\x85\0\0\0\x02\0\0\0\x03\0\0\0+\0\x04\0\x07\0\0\0\x86\0\0\0\x04\0\0\0!\0\x04\0\xB3\0\0\0\x07\0\0\0\x07\0\0\0 \0\x04\0\xB4\0\0\0\x02\0\0\0\x0B\0\0\0 \0\x04\0\xB6\0\0\0\x0C\0\0\0\x0C\0\0\0+\0\x04\0\x07\0\0\0\xB8\0\0\0\x10\0\0\0 \0\x04\0\xBA\0\0\0\x02\0\0\0\n\0\0\0 \0\x04\0\xBB\0\0\0\x02\0\0\0\x07\0\0\0 \0\x04\0\xC6\0\0\0\x0C\0\0\0\x07\0\0\0+\0\x04\0\x07\0\0\0\xCC\0\0\0 \0\0\0.\0\x03\0\x07\0\0\0\xD2\0\0\0!\0\x04\0\xD6\0\0\0\x08\0\0\0\x07\0\0\0+\0\x04\0\x07\0\0\0\xD7\0\0\0\xFF\xFF\0\0+\0\x04\0\x07\0\0\0\xD8\0\0\0\xFF\x7F\0\0,\0\x05\0\x10\0\0\0\xD9\0\0\0\xD8\0\0\0\xD8\0\0\0+\0\x04\0\x07\0\0\0\xDA\0\0\0\r\0\0\0,\0\x05\0\x10\0\0\0\xDB\0\0\0\xDA\0\0\0\xDA\0\0\0+\0\x04\0\x07\0\0\0\xDC\0\0\0\0\0\08,\0\x05\0\x10\0\0\0\xDD\0\0\0\xDC\0\0\0\xDC\0\0\0+\0\x04\0\x07\0\0\0\xDE\0\0\0\0\x04\0\0,\0\x05\0\x10\0\0\0\xDF\0\0\0\xDE\0\0\0\xDE\0\0\0\x17\0\x04\0\xEA\0\0\0\x0F\0\0\0\x02\0\0\0!\0\x05\0\xF4\0\0\0\x12\0\0\0\x11\0\0\0\x07\0\0\0+\0\x04\0\x07\0\0\0\xF5\0\0\0\n\0\0\0+\0\x04\0\x07\0\0\0\xF6\0\0\0\x14\0\0\0,\0\x06\0\x11\0\0\0\xF7\0\0\0m\0\0\0\xF5\0\0\0\xF6\0\0\0+\0\x04\0\x07\0\0\0\xF8\0\0\0\xFF\x03\0\0,\0\x06\0\x11\0\0\0\xF9\0\0\0\xF8\0\0\0\xF8\0\0\0\xF8\0\0\0+\0\x04\0\x03\0\0\0\xFA\0\0\0\0\xC0\x7FD,\0\x06\0\x12\0\0\0\xFB\0\0\0\xFA\0\0\0\xFA\0\0\0\xFA\0\0\0.\0\x03\0\x12\0\0\0$\x01\0\0!\0\x05\0)\x01\0\0\x04\0\0\0\x0E\0\0\0\x07\0\0\0!\0\x06\0N\x01\0\0\x0F\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0)\0\x03\0\x0F\0\0\0P\x01\0\0,\0\x06\0\x12\0\0\0Q\x01\0\0e\0\0\0e\0\0\0e\0\0\0 \0\x04\0S\x01\0\0\x07\0\0\0\x0F\0\0\0.\0\x03\0\x0F\0\0\0T\x01\0\0.\0\x03\0\x0F\0\0\0V\x01\0\0.\0\x03\0\x0F\0\0\0X\x01\0\0.\0\x03\0\x0F\0\0\0Z\x01\0\0\x17\0\x04\0h\x01\0\0\x0F\0\0\0\x03\0\0\0+\0\x04\0\x07\0\0\0s\x01\0\0\x06\0\0\0!\0\x04\0\x92\x01\0\0\x0F\0\0\0\x04\0\0\0*\0\x03\0\x0F\0\0\0\x94\x01\0\0.\0\x03\0\x0F\0\0\0\x96\x01\0\0.\0\x03\0\x0F\0\0\0\x98\x01\0\0.\0\x03\0\x0F\0\0\0\x9A\x01\0\0+\0\x04\0\x03\0\0\0\xC5\x01\0\0\0\0\0>!\0\x05\0\xDB\x01\0\0\x03\0\0\0\x04\0\0\0\x04\0\0\0.\0\x03\0\x0F\0\0\0\xDE\x01\0\0 \0\x04\0\xEF\x01\0\0\x02\0\0\0\x08\0\0\0+\0\x04\0\x07\0\0\0\xF0\x01\0\0\x05\0\0\0!\0\x06\0\xFD\x01\0\0\x03\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0!\0\x04\0\x08\x02\0\0\x04\0\0\0\x0E\0\0\0,\0\x07\0\x04\0\0\0\r\x02\0\0e\0\0\0e\0\0\0e\0\0\0e\0\0\0.\0\x03\0\x0F\0\0\0\x0F\x02\0\0\x17\0\x04\0\x1F\x02\0\0\x0F\0\0\0\x04\0\0\0 \0\x04\0<\x02\0\0\x01\0\0\0\x07\0\0\0;\0\x04\0<\x02\0\0;\x02\0\0\x01\0\0\0 \0\x04\0?\x02\0\0\x01\0\0\0\x04\0\0\0;\0\x04\0?\x02\0\0>\x02\0\0\x01\0\0\0;\0\x04\0?\x02\0\0A\x02\0\0\x01\0\0\0;\0\x04\0?\x02\0\0C\x02\0\0\x01\0\0\0 \0\x04\0F\x02\0\0\x03\0\0\0\x04\0\0\0;\0\x04\0F\x02\0\0E\x02\0\0\x03\0\0\0 \0\x04\0H\x02\0\0\x03\0\0\0\x03\0\0\0;\0\x04\0H\x02\0\0G\x02\0\0\x03\0\0\0;\0\x04\0H\x02\0\0I\x02\0\0\x03\0\0\0!\0\x03\0K\x02\0\0\x02\0\0\0;\0\x04\0?\x02\0\0\\\x02\0\0\x01\0\0\0 \0\x04\0_\x02\0\0\x01\0\0\0\x03\0\0\0;\0\x04\0_\x02\0\0^\x02\0\0\x01\0\0\0;\0\x04\0_\x02\0\0a\x02\0\0\x01\0\0\0;\0\x04\0H\x02\0\0c\x02\0\0\x03\0\0\x006\0\x05\0\x03\0\0\0/\0\0\0\0\0\0\x000\0\0\x007\0\x03\0\x05\0\0\0-\0\0\x007\0\x03\0\x03\0\0\0.\0\0\0\xF8\0\x02\0,\0\0\0\xF9\0\x02\x001\0\0\0\xF8\0\x02\x001\0\0\0Q\0\x05\0\x04\0\0\x002\0\0\0-\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\x003\0\0\x002\0\0\0\0\0\0\0\xBC\0\x05\0\x0F\0\0\x004\0\0\0.\0\0\x003\0\0\0\xF7\0\x03\x005\0\0\0\0\0\0\0\xFA\0\x04\x004\0\0\x006\0\0\x005\0\0\0\xF8\0\x02\x006\0\0\0Q\0\x05\0\x04\0\0\x007\0\0\0-\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\08\0\0\x007\0\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\09\0\0\0-\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0:\0\0\09\0\0\0\x02\0\0\0\x85\0\x05\0\x03\0\0\0;\0\0\0:\0\0\0.\0\0\0\x81\0\x05\0\x03\0\0\0<\0\0\08\0\0\0;\0\0\0\xFE\0\x02\0<\0\0\0\xF8\0\x02\x005\0\0\0Q\0\x05\0\x04\0\0\0=\0\0\0-\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0>\0\0\0=\0\0\0\0\0\0\0Q\0\x05\0\x04\0\0\0?\0\0\0-\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0@\0\0\0?\0\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\0A\0\0\0-\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0B\0\0\0A\0\0\0\x02\0\0\0\x85\0\x05\0\x03\0\0\0C\0\0\0.\0\0\0B\0\0\0\x0C\0\x06\0\x03\0\0\0D\0\0\0\x01\0\0\0\x1C\0\0\0C\0\0\0\x85\0\x05\0\x03\0\0\0E\0\0\0@\0\0\0D\0\0\0\x81\0\x05\0\x03\0\0\0F\0\0\0>\0\0\0E\0\0\0\xFE\0\x02\0F\0\0\08\0\x01\x006\0\x05\0\x03\0\0\0J\0\0\0\0\0\0\x000\0\0\x007\0\x03\0\x05\0\0\0H\0\0\x007\0\x03\0\x03\0\0\0I\0\0\0\xF8\0\x02\0G\0\0\0\xF9\0\x02\0K\0\0\0\xF8\0\x02\0K\0\0\0Q\0\x05\0\x04\0\0\0L\0\0\0H\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0M\0\0\0L\0\0\0\0\0\0\0\xBC\0\x05\0\x0F\0\0\0N\0\0\0I\0\0\0M\0\0\0\xF7\0\x03\0O\0\0\0\0\0\0\0\xFA\0\x04\0N\0\0\0P\0\0\0O\0\0\0\xF8\0\x02\0P\0\0\0Q\0\x05\0\x04\0\0\0Q\0\0\0H\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0R\0\0\0Q\0\0\0\x02\0\0\0\xFE\0\x02\0R\0\0\0\xF8\0\x02\0O\0\0\0Q\0\x05\0\x04\0\0\0S\0\0\0H\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0T\0\0\0S\0\0\0\x01\0\0\0\x88\0\x05\0\x03\0\0\0U\0\0\0T\0\0\0I\0\0\0\xFE\0\x02\0U\0\0\08\0\x01\x006\0\x05\0\x04\0\0\0X\0\0\0\0\0\0\0Y\0\0\x007\0\x03\0\x04\0\0\0W\0\0\0\xF8\0\x02\0V\0\0\0\xF9\0\x02\0Z\0\0\0\xF8\0\x02\0Z\0\0\0O\0\x07\0\x08\0\0\0[\0\0\0W\0\0\0W\0\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\\\0\0\0W\0\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0]\0\0\0\x17\0\0\0\\\0\0\0Q\0\x05\0\x03\0\0\0^\0\0\0W\0\0\0\x03\0\0\0P\0\x06\0\x04\0\0\0_\0\0\0[\0\0\0]\0\0\0^\0\0\0\xFE\0\x02\0_\0\0\08\0\x01\x006\0\x05\0\x03\0\0\0c\0\0\0\0\0\0\0d\0\0\x007\0\x03\0\x03\0\0\0a\0\0\x007\0\x03\0\x03\0\0\0b\0\0\0\xF8\0\x02\0`\0\0\0\xF9\0\x02\0f\0\0\0\xF8\0\x02\0f\0\0\0\x88\0\x05\0\x03\0\0\0g\0\0\0a\0\0\0b\0\0\0\x0C\0\x08\0\x03\0\0\0h\0\0\0\x01\0\0\0+\0\0\0g\0\0\0e\0\0\0\x18\0\0\0\xFE\0\x02\0h\0\0\08\0\x01\x006\0\x05\0\x04\0\0\0k\0\0\0\0\0\0\0Y\0\0\x007\0\x03\0\x04\0\0\0j\0\0\0\xF8\0\x02\0i\0\0\0A\0\x05\0l\0\0\0n\0\0\0 \0\0\0m\0\0\0\xF9\0\x02\0o\0\0\0\xF8\0\x02\0o\0\0\0A\0\x05\0p\0\0\0q\0\0\0n\0\0\0m\0\0\0=\0\x04\0\x04\0\0\0r\0\0\0q\0\0\0\x94\0\x05\0\x03\0\0\0s\0\0\0r\0\0\0j\0\0\0A\0\x05\0p\0\0\0u\0\0\0n\0\0\0t\0\0\0=\0\x04\0\x04\0\0\0v\0\0\0u\0\0\0\x94\0\x05\0\x03\0\0\0w\0\0\0v\0\0\0j\0\0\0A\0\x05\0p\0\0\0x\0\0\0n\0\0\0\x06\0\0\0=\0\x04\0\x04\0\0\0y\0\0\0x\0\0\0\x94\0\x05\0\x03\0\0\0z\0\0\0y\0\0\0j\0\0\0A\0\x05\0p\0\0\0{\0\0\0n\0\0\0\x14\0\0\0=\0\x04\0\x04\0\0\0|\0\0\0{\0\0\0\x94\0\x05\0\x03\0\0\0}\0\0\0|\0\0\0j\0\0\0P\0\x07\0\x04\0\0\0~\0\0\0s\0\0\0w\0\0\0z\0\0\0}\0\0\0\xFE\0\x02\0~\0\0\08\0\x01\x006\0\x05\0\x0F\0\0\0\x80\0\0\0\0\0\0\0\x81\0\0\0\xF8\0\x02\0\x7F\0\0\0A\0\x05\0l\0\0\0\x82\0\0\0 \0\0\0m\0\0\0\xF9\0\x02\0\x83\0\0\0\xF8\0\x02\0\x83\0\0\0A\0\x07\0\x85\0\0\0\x87\0\0\0\x82\0\0\0\x86\0\0\0t\0\0\0m\0\0\0=\0\x04\0\x03\0\0\0\x88\0\0\0\x87\0\0\0\xB8\0\x05\0\x0F\0\0\0\x89\0\0\0\x88\0\0\0\x1A\0\0\0\xFE\0\x02\0\x89\0\0\08\0\x01\x006\0\x05\0\x04\0\0\0\x8C\0\0\0\0\0\0\0Y\0\0\x007\0\x03\0\x04\0\0\0\x8B\0\0\0\xF8\0\x02\0\x8A\0\0\0A\0\x05\0l\0\0\0\x8D\0\0\0 \0\0\0m\0\0\0\xF9\0\x02\0\x8E\0\0\0\xF8\0\x02\0\x8E\0\0\0Q\0\x05\0\x03\0\0\0\x8F\0\0\0\x8B\0\0\0\x03\0\0\0\xB4\0\x05\0\x0F\0\0\0\x90\0\0\0\x8F\0\0\0e\0\0\0\xF7\0\x03\0\x91\0\0\0\0\0\0\0\xFA\0\x04\0\x90\0\0\0\x92\0\0\0\x91\0\0\0\xF8\0\x02\0\x92\0\0\0\xFE\0\x02\0\x19\0\0\0\xF8\0\x02\0\x91\0\0\09\0\x05\0\x04\0\0\0\x93\0\0\0k\0\0\0\x8B\0\0\09\0\x04\0\x0F\0\0\0\x94\0\0\0\x80\0\0\0\xF7\0\x03\0\x95\0\0\0\0\0\0\0\xFA\0\x04\0\x94\0\0\0\x96\0\0\0\x95\0\0\0\xF8\0\x02\0\x96\0\0\0Q\0\x05\0\x03\0\0\0\x97\0\0\0\x93\0\0\0\0\0\0\0A\0\x05\0\x84\0\0\0\x98\0\0\0\x8D\0\0\0\x86\0\0\0=\0\x04\0\x05\0\0\0\x99\0\0\0\x98\0\0\0Q\0\x05\0\x03\0\0\0\x9A\0\0\0\x93\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\x9B\0\0\0\x93\0\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\x9C\0\0\0\x9A\0\0\0\x9B\0\0\09\0\x06\0\x03\0\0\0\x9D\0\0\0/\0\0\0\x99\0\0\0\x9C\0\0\0Q\0\x05\0\x03\0\0\0\x9E\0\0\0\x93\0\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\x9F\0\0\0\x9D\0\0\0\x9E\0\0\0O\0\x07\0\x08\0\0\0\xA0\0\0\0\x93\0\0\0\x93\0\0\0\x02\0\0\0\x03\0\0\0P\0\x06\0\x04\0\0\0\xA1\0\0\0\x97\0\0\0\x9F\0\0\0\xA0\0\0\0\xFE\0\x02\0\xA1\0\0\0\xF8\0\x02\0\x95\0\0\0A\0\x05\0\x84\0\0\0\xA2\0\0\0\x8D\0\0\0\x86\0\0\0=\0\x04\0\x05\0\0\0\xA3\0\0\0\xA2\0\0\09\0\x06\0\x03\0\0\0\xA4\0\0\0/\0\0\0\xA3\0\0\0e\0\0\0Q\0\x05\0\x03\0\0\0\xA5\0\0\0\x93\0\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\xA6\0\0\0\xA4\0\0\0\xA5\0\0\0A\0\x05\0\x84\0\0\0\xA7\0\0\0\x8D\0\0\0\x86\0\0\0=\0\x04\0\x05\0\0\0\xA8\0\0\0\xA7\0\0\09\0\x06\0\x03\0\0\0\xA9\0\0\0J\0\0\0\xA8\0\0\0e\0\0\0Q\0\x05\0\x03\0\0\0\xAA\0\0\0\x93\0\0\0\x01\0\0\0\x85\0\x05\0\x03\0\0\0\xAB\0\0\0\xA9\0\0\0\xAA\0\0\0\x81\0\x05\0\x03\0\0\0\xAC\0\0\0\xA6\0\0\0\xAB\0\0\0Q\0\x05\0\x03\0\0\0\xAD\0\0\0\x93\0\0\0\0\0\0\0O\0\x07\0\x08\0\0\0\xAE\0\0\0\x93\0\0\0\x93\0\0\0\x02\0\0\0\x03\0\0\0P\0\x06\0\x04\0\0\0\xAF\0\0\0\xAD\0\0\0\xAC\0\0\0\xAE\0\0\0\xFE\0\x02\0\xAF\0\0\08\0\x01\x006\0\x05\0\x07\0\0\0\xB2\0\0\0\0\0\0\0\xB3\0\0\x007\0\x03\0\x07\0\0\0\xB1\0\0\0\xF8\0\x02\0\xB0\0\0\0A\0\x05\0\xB4\0\0\0\xB5\0\0\0#\0\0\0m\0\0\0A\0\x05\0\xB6\0\0\0\xB7\0\0\0)\0\0\0m\0\0\0\xF9\0\x02\0\xB9\0\0\0\xF8\0\x02\0\xB9\0\0\0A\0\x06\0\xBB\0\0\0\xBC\0\0\0\xB5\0\0\0m\0\0\0\x06\0\0\0=\0\x04\0\x07\0\0\0\xBD\0\0\0\xBC\0\0\0\x80\0\x05\0\x07\0\0\0\xBE\0\0\0\xBD\0\0\0\xB1\0\0\0A\0\x06\0\xBB\0\0\0\xBF\0\0\0\xB5\0\0\0m\0\0\0\x14\0\0\0=\0\x04\0\x07\0\0\0\xC0\0\0\0\xBF\0\0\0\xF7\0\x03\0\xC1\0\0\0\0\0\0\0\xFB\0\x07\0\xC0\0\0\0\xC4\0\0\0\0\0\0\0\xC2\0\0\0\x01\0\0\0\xC3\0\0\0\xF8\0\x02\0\xC2\0\0\0\xFE\0\x02\0\xB1\0\0\0\xF8\0\x02\0\xC3\0\0\0\x86\0\x05\0\x07\0\0\0\xC5\0\0\0\xBE\0\0\0\x06\0\0\0A\0\x05\0\xC6\0\0\0\xC7\0\0\0\xB7\0\0\0\xC5\0\0\0=\0\x04\0\x07\0\0\0\xC8\0\0\0\xC7\0\0\0\x89\0\x05\0\x07\0\0\0\xC9\0\0\0\xBE\0\0\0\x06\0\0\0\x84\0\x05\0\x07\0\0\0\xCA\0\0\0\xB8\0\0\0\xC9\0\0\0\x0C\0\x07\0\x07\0\0\0\xCD\0\0\0\x01\0\0\0&\0\0\0\xCA\0\0\0\xCC\0\0\0\x82\0\x05\0\x07\0\0\0\xCE\0\0\0\xCC\0\0\0\xCD\0\0\0\x0C\0\x07\0\x07\0\0\0\xCF\0\0\0\x01\0\0\0&\0\0\0\xB8\0\0\0\xCE\0\0\0\xCB\0\x06\0\x07\0\0\0\xCB\0\0\0\xC8\0\0\0\xCD\0\0\0\xCF\0\0\0\xFE\0\x02\0\xCB\0\0\0\xF8\0\x02\0\xC4\0\0\0A\0\x05\0\xC6\0\0\0\xD0\0\0\0\xB7\0\0\0\xBE\0\0\0=\0\x04\0\x07\0\0\0\xD1\0\0\0\xD0\0\0\0\xFE\0\x02\0\xD1\0\0\0\xF8\0\x02\0\xC1\0\0\0\xFE\0\x02\0\xD2\0\0\08\0\x01\x006\0\x05\0\x08\0\0\0\xD5\0\0\0\0\0\0\0\xD6\0\0\x007\0\x03\0\x07\0\0\0\xD4\0\0\0\xF8\0\x02\0\xD3\0\0\0\xF9\0\x02\0\xE0\0\0\0\xF8\0\x02\0\xE0\0\0\0\xC7\0\x05\0\x07\0\0\0\xE1\0\0\0\xD4\0\0\0\xD7\0\0\0\xC2\0\x05\0\x07\0\0\0\xE2\0\0\0\xD4\0\0\0\xB8\0\0\0P\0\x05\0\x10\0\0\0\xE3\0\0\0\xE1\0\0\0\xE2\0\0\0\xC7\0\x05\0\x10\0\0\0\xE4\0\0\0\xE3\0\0\0\xD9\0\0\0\xC4\0\x05\0\x10\0\0\0\xE5\0\0\0\xE4\0\0\0\xDB\0\0\0\x80\0\x05\0\x10\0\0\0\xE6\0\0\0\xE5\0\0\0\xDD\0\0\0|\0\x04\0\x08\0\0\0\xE7\0\0\0\xE6\0\0\0p\0\x04\0\x08\0\0\0\xE8\0\0\0\xE4\0\0\0\x8E\0\x05\0\x08\0\0\0\xE9\0\0\0\xE8\0\0\0\x1B\0\0\0\xB0\0\x05\0\xEA\0\0\0\xEB\0\0\0\xE4\0\0\0\xDF\0\0\0\xA9\0\x06\0\x08\0\0\0\xEC\0\0\0\xEB\0\0\0\xE9\0\0\0\xE7\0\0\0\x7F\0\x04\0\x08\0\0\0\xED\0\0\0\xEC\0\0\0\xAC\0\x05\0\xEA\0\0\0\xEE\0\0\0\xE3\0\0\0\xD9\0\0\0\xA9\0\x06\0\x08\0\0\0\xEF\0\0\0\xEE\0\0\0\xED\0\0\0\xEC\0\0\0\xFE\0\x02\0\xEF\0\0\08\0\x01\x006\0\x05\0\x12\0\0\0\xF3\0\0\0\0\0\0\0\xF4\0\0\x007\0\x03\0\x11\0\0\0\xF1\0\0\x007\0\x03\0\x07\0\0\0\xF2\0\0\0\xF8\0\x02\0\xF0\0\0\0\xF9\0\x02\0\xFC\0\0\0\xF8\0\x02\0\xFC\0\0\0\xF7\0\x03\0\xFD\0\0\0\0\0\0\0\xFB\0\x0F\0\xF2\0\0\0\x04\x01\0\0\0\0\0\0\xFE\0\0\0\x01\0\0\0\xFF\0\0\0\x02\0\0\0\0\x01\0\0\x03\0\0\0\x01\x01\0\0\x04\0\0\0\x02\x01\0\0\x05\0\0\0\x03\x01\0\0\xF8\0\x02\0\xFE\0\0\0|\0\x04\0\x12\0\0\0\x05\x01\0\0\xF1\0\0\0\xFE\0\x02\0\x05\x01\0\0\xF8\0\x02\0\xFF\0\0\0Q\0\x05\0\x07\0\0\0\x06\x01\0\0\xF1\0\0\0\0\0\0\09\0\x05\0\x08\0\0\0\x07\x01\0\0\xD5\0\0\0\x06\x01\0\0Q\0\x05\0\x07\0\0\0\x08\x01\0\0\xF1\0\0\0\x01\0\0\09\0\x05\0\x08\0\0\0\t\x01\0\0\xD5\0\0\0\x08\x01\0\0Q\0\x05\0\x03\0\0\0\n\x01\0\0\t\x01\0\0\0\0\0\0P\0\x05\0\x12\0\0\0\x0B\x01\0\0\x07\x01\0\0\n\x01\0\0\xFE\0\x02\0\x0B\x01\0\0\xF8\0\x02\0\0\x01\0\0Q\0\x05\0\x07\0\0\0\x0C\x01\0\0\xF1\0\0\0\0\0\0\0\x0C\0\x06\0\x08\0\0\0\r\x01\0\0\x01\0\0\0<\0\0\0\x0C\x01\0\0Q\0\x05\0\x07\0\0\0\x0E\x01\0\0\xF1\0\0\0\x01\0\0\0\x0C\0\x06\0\x08\0\0\0\x0F\x01\0\0\x01\0\0\0<\0\0\0\x0E\x01\0\0Q\0\x05\0\x03\0\0\0\x10\x01\0\0\x0F\x01\0\0\0\0\0\0P\0\x05\0\x12\0\0\0\x11\x01\0\0\r\x01\0\0\x10\x01\0\0\xFE\0\x02\0\x11\x01\0\0\xF8\0\x02\0\x01\x01\0\0Q\0\x05\0\x07\0\0\0\x12\x01\0\0\xF1\0\0\0\0\0\0\0\x0C\0\x06\0\x08\0\0\0\x13\x01\0\0\x01\0\0\0=\0\0\0\x12\x01\0\0Q\0\x05\0\x07\0\0\0\x14\x01\0\0\xF1\0\0\0\x01\0\0\0\x0C\0\x06\0\x08\0\0\0\x15\x01\0\0\x01\0\0\0=\0\0\0\x14\x01\0\0Q\0\x05\0\x03\0\0\0\x16\x01\0\0\x15\x01\0\0\0\0\0\0P\0\x05\0\x12\0\0\0\x17\x01\0\0\x13\x01\0\0\x16\x01\0\0\xFE\0\x02\0\x17\x01\0\0\xF8\0\x02\0\x02\x01\0\0Q\0\x05\0\x07\0\0\0\x18\x01\0\0\xF1\0\0\0\0\0\0\0\x0C\0\x06\0\x04\0\0\0\x19\x01\0\0\x01\0\0\0?\0\0\0\x18\x01\0\0O\0\x08\0\x12\0\0\0\x1A\x01\0\0\x19\x01\0\0\x19\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\xFE\0\x02\0\x1A\x01\0\0\xF8\0\x02\0\x03\x01\0\0Q\0\x05\0\x07\0\0\0\x1B\x01\0\0\xF1\0\0\0\0\0\0\0\x0C\0\x06\0\x04\0\0\0\x1C\x01\0\0\x01\0\0\0@\0\0\0\x1B\x01\0\0O\0\x08\0\x12\0\0\0\x1D\x01\0\0\x1C\x01\0\0\x1C\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\xFE\0\x02\0\x1D\x01\0\0\xF8\0\x02\0\x04\x01\0\0Q\0\x05\0\x07\0\0\0\x1E\x01\0\0\xF1\0\0\0\0\0\0\0P\0\x06\0\x11\0\0\0\x1F\x01\0\0\x1E\x01\0\0\x1E\x01\0\0\x1E\x01\0\0\xC2\0\x05\0\x11\0\0\0 \x01\0\0\x1F\x01\0\0\xF7\0\0\0\xC7\0\x05\0\x11\0\0\0!\x01\0\0 \x01\0\0\xF9\0\0\0p\0\x04\0\x12\0\0\0\"\x01\0\0!\x01\0\0\x88\0\x05\0\x12\0\0\0#\x01\0\0\"\x01\0\0\xFB\0\0\0\xFE\0\x02\0#\x01\0\0\xF8\0\x02\0\xFD\0\0\0\xFE\0\x02\0$\x01\0\08\0\x01\x006\0\x05\0\x04\0\0\0(\x01\0\0\0\0\0\0)\x01\0\x007\0\x03\0\x0E\0\0\0&\x01\0\x007\0\x03\0\x07\0\0\0'\x01\0\0\xF8\0\x02\0%\x01\0\0A\0\x05\0\xB4\0\0\0*\x01\0\0#\0\0\0m\0\0\0A\0\x05\0\xB6\0\0\0+\x01\0\0&\0\0\0m\0\0\0A\0\x05\0\xB6\0\0\0,\x01\0\0)\0\0\0m\0\0\0\xF9\0\x02\0-\x01\0\0\xF8\0\x02\0-\x01\0\0A\0\x06\0\xBB\0\0\0.\x01\0\0*\x01\0\0m\0\0\0m\0\0\0=\0\x04\0\x07\0\0\0/\x01\0\0.\x01\0\09\0\x05\0\x07\0\0\x000\x01\0\0\xB2\0\0\0'\x01\0\0A\0\x06\0\xBB\0\0\x001\x01\0\0*\x01\0\0m\0\0\0t\0\0\0=\0\x04\0\x07\0\0\x002\x01\0\x001\x01\0\0\x84\0\x05\0\x07\0\0\x003\x01\0\x000\x01\0\x002\x01\0\0\x80\0\x05\0\x07\0\0\x004\x01\0\0/\x01\0\x003\x01\0\0A\0\x05\0\xC6\0\0\x005\x01\0\0+\x01\0\x004\x01\0\0=\0\x04\0\x07\0\0\x006\x01\0\x005\x01\0\0\x80\0\x05\0\x07\0\0\x007\x01\0\x004\x01\0\0t\0\0\0A\0\x05\0\xC6\0\0\08\x01\0\0+\x01\0\x007\x01\0\0=\0\x04\0\x07\0\0\09\x01\0\08\x01\0\0\x80\0\x05\0\x07\0\0\0:\x01\0\x004\x01\0\0\x06\0\0\0A\0\x05\0\xC6\0\0\0;\x01\0\0+\x01\0\0:\x01\0\0=\0\x04\0\x07\0\0\0<\x01\0\0;\x01\0\0P\0\x06\0\x11\0\0\0=\x01\0\x006\x01\0\09\x01\0\0<\x01\0\0A\0\x06\0\xBB\0\0\0>\x01\0\0*\x01\0\0t\0\0\0m\0\0\0=\0\x04\0\x07\0\0\0?\x01\0\0>\x01\0\09\0\x06\0\x12\0\0\0@\x01\0\0\xF3\0\0\0=\x01\0\0?\x01\0\0P\0\x05\0\x04\0\0\0A\x01\0\0@\x01\0\0\x18\0\0\0Q\0\x05\0\x04\0\0\0B\x01\0\0&\x01\0\0\x01\0\0\0\x94\0\x05\0\x03\0\0\0C\x01\0\0B\x01\0\0A\x01\0\0Q\0\x05\0\x04\0\0\0D\x01\0\0&\x01\0\0\x02\0\0\0\x94\0\x05\0\x03\0\0\0E\x01\0\0D\x01\0\0A\x01\0\0Q\0\x05\0\x04\0\0\0F\x01\0\0&\x01\0\0\x03\0\0\0\x94\0\x05\0\x03\0\0\0G\x01\0\0F\x01\0\0A\x01\0\0P\0\x07\0\x04\0\0\0H\x01\0\0C\x01\0\0E\x01\0\0G\x01\0\0\x18\0\0\0\xFE\0\x02\0H\x01\0\08\0\x01\x006\0\x05\0\x0F\0\0\0M\x01\0\0\0\0\0\0N\x01\0\x007\0\x03\0\x04\0\0\0J\x01\0\x007\0\x03\0\x04\0\0\0K\x01\0\x007\0\x03\0\x04\0\0\0L\x01\0\0\xF8\0\x02\0I\x01\0\0;\0\x05\0S\x01\0\0U\x01\0\0\x07\0\0\0V\x01\0\0;\0\x05\0S\x01\0\0Y\x01\0\0\x07\0\0\0Z\x01\0\0;\0\x05\0S\x01\0\0R\x01\0\0\x07\0\0\0T\x01\0\0;\0\x05\0S\x01\0\0W\x01\0\0\x07\0\0\0X\x01\0\0A\0\x05\0l\0\0\0O\x01\0\0 \0\0\0m\0\0\0\xF9\0\x02\0[\x01\0\0\xF8\0\x02\0[\x01\0\0Q\0\x05\0\x03\0\0\0\\\x01\0\0J\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0]\x01\0\0K\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0^\x01\0\0L\x01\0\0\0\0\0\0P\0\x06\0\x12\0\0\0_\x01\0\0\\\x01\0\0]\x01\0\0^\x01\0\0Q\0\x05\0\x03\0\0\0`\x01\0\0J\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0a\x01\0\0K\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0b\x01\0\0L\x01\0\0\x01\0\0\0P\0\x06\0\x12\0\0\0c\x01\0\0`\x01\0\0a\x01\0\0b\x01\0\0Q\0\x05\0\x03\0\0\0d\x01\0\0J\x01\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0e\x01\0\0K\x01\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0f\x01\0\0L\x01\0\0\x03\0\0\0P\0\x06\0\x12\0\0\0g\x01\0\0d\x01\0\0e\x01\0\0f\x01\0\0\xBA\0\x05\0h\x01\0\0i\x01\0\0_\x01\0\0g\x01\0\0\x9B\0\x04\0\x0F\0\0\0j\x01\0\0i\x01\0\0\xA8\0\x04\0\x0F\0\0\0k\x01\0\0j\x01\0\0\xF7\0\x03\0l\x01\0\0\0\0\0\0\xFA\0\x04\0k\x01\0\0m\x01\0\0n\x01\0\0\xF8\0\x02\0m\x01\0\0\x7F\0\x04\0\x12\0\0\0o\x01\0\0g\x01\0\0\xB8\0\x05\0h\x01\0\0p\x01\0\0_\x01\0\0o\x01\0\0\x9B\0\x04\0\x0F\0\0\0q\x01\0\0p\x01\0\0>\0\x03\0R\x01\0\0q\x01\0\0\xF9\0\x02\0l\x01\0\0\xF8\0\x02\0n\x01\0\0>\0\x03\0R\x01\0\0P\x01\0\0\xF9\0\x02\0l\x01\0\0\xF8\0\x02\0l\x01\0\0=\0\x04\0\x0F\0\0\0r\x01\0\0R\x01\0\0A\0\x06\0\x85\0\0\0t\x01\0\0O\x01\0\0s\x01\0\0t\0\0\0=\0\x04\0\x03\0\0\0u\x01\0\0t\x01\0\0\x8E\0\x05\0\x12\0\0\0v\x01\0\0g\x01\0\0u\x01\0\0\xBA\0\x05\0h\x01\0\0w\x01\0\0c\x01\0\0v\x01\0\0\x9B\0\x04\0\x0F\0\0\0x\x01\0\0w\x01\0\0\xA8\0\x04\0\x0F\0\0\0y\x01\0\0x\x01\0\0\xF7\0\x03\0z\x01\0\0\0\0\0\0\xFA\0\x04\0y\x01\0\0{\x01\0\0|\x01\0\0\xF8\0\x02\0{\x01\0\0A\0\x06\0\x85\0\0\0}\x01\0\0O\x01\0\0s\x01\0\0m\0\0\0=\0\x04\0\x03\0\0\0~\x01\0\0}\x01\0\0\x8E\0\x05\0\x12\0\0\0\x7F\x01\0\0g\x01\0\0~\x01\0\0\xB8\0\x05\0h\x01\0\0\x80\x01\0\0c\x01\0\0\x7F\x01\0\0\x9B\0\x04\0\x0F\0\0\0\x81\x01\0\0\x80\x01\0\0>\0\x03\0U\x01\0\0\x81\x01\0\0\xF9\0\x02\0z\x01\0\0\xF8\0\x02\0|\x01\0\0>\0\x03\0U\x01\0\0P\x01\0\0\xF9\0\x02\0z\x01\0\0\xF8\0\x02\0z\x01\0\0=\0\x04\0\x0F\0\0\0\x82\x01\0\0U\x01\0\0\xA8\0\x04\0\x0F\0\0\0\x83\x01\0\0r\x01\0\0\xF7\0\x03\0\x84\x01\0\0\0\0\0\0\xFA\0\x04\0\x83\x01\0\0\x85\x01\0\0\x86\x01\0\0\xF8\0\x02\0\x85\x01\0\0>\0\x03\0W\x01\0\0\x82\x01\0\0\xF9\0\x02\0\x84\x01\0\0\xF8\0\x02\0\x86\x01\0\0>\0\x03\0W\x01\0\0P\x01\0\0\xF9\0\x02\0\x84\x01\0\0\xF8\0\x02\0\x84\x01\0\0=\0\x04\0\x0F\0\0\0\x87\x01\0\0W\x01\0\0\xA8\0\x04\0\x0F\0\0\0\x88\x01\0\0\x87\x01\0\0\xF7\0\x03\0\x89\x01\0\0\0\0\0\0\xFA\0\x04\0\x88\x01\0\0\x8A\x01\0\0\x8B\x01\0\0\xF8\0\x02\0\x8A\x01\0\0\xBC\0\x05\0h\x01\0\0\x8C\x01\0\0g\x01\0\0Q\x01\0\0\x9B\0\x04\0\x0F\0\0\0\x8D\x01\0\0\x8C\x01\0\0>\0\x03\0Y\x01\0\0\x8D\x01\0\0\xF9\0\x02\0\x89\x01\0\0\xF8\0\x02\0\x8B\x01\0\0>\0\x03\0Y\x01\0\0P\x01\0\0\xF9\0\x02\0\x89\x01\0\0\xF8\0\x02\0\x89\x01\0\0=\0\x04\0\x0F\0\0\0\x8E\x01\0\0Y\x01\0\0\xFE\0\x02\0\x8E\x01\0\08\0\x01\x006\0\x05\0\x0F\0\0\0\x91\x01\0\0\0\0\0\0\x92\x01\0\x007\0\x03\0\x04\0\0\0\x90\x01\0\0\xF8\0\x02\0\x8F\x01\0\0;\0\x05\0S\x01\0\0\x95\x01\0\0\x07\0\0\0\x96\x01\0\0;\0\x05\0S\x01\0\0\x97\x01\0\0\x07\0\0\0\x98\x01\0\0;\0\x05\0S\x01\0\0\x99\x01\0\0\x07\0\0\0\x9A\x01\0\0A\0\x05\0l\0\0\0\x93\x01\0\0 \0\0\0m\0\0\0\xF9\0\x02\0\x9B\x01\0\0\xF8\0\x02\0\x9B\x01\0\0A\0\x06\0\x85\0\0\0\x9C\x01\0\0\x93\x01\0\0s\x01\0\0m\0\0\0=\0\x04\0\x03\0\0\0\x9D\x01\0\0\x9C\x01\0\0A\0\x06\0\x85\0\0\0\x9E\x01\0\0\x93\x01\0\0s\x01\0\0m\0\0\0=\0\x04\0\x03\0\0\0\x9F\x01\0\0\x9E\x01\0\0\x85\0\x05\0\x03\0\0\0\xA0\x01\0\0\x15\0\0\0\x9F\x01\0\0\x0C\0\x07\0\x03\0\0\0\xA1\x01\0\0\x01\0\0\0%\0\0\0\x9D\x01\0\0\xA0\x01\0\0A\0\x06\0\x85\0\0\0\xA2\x01\0\0\x93\x01\0\0s\x01\0\0t\0\0\0=\0\x04\0\x03\0\0\0\xA3\x01\0\0\xA2\x01\0\0\x85\0\x05\0\x03\0\0\0\xA4\x01\0\0\x1D\0\0\0\xA3\x01\0\0Q\0\x05\0\x03\0\0\0\xA5\x01\0\0\x90\x01\0\0\0\0\0\0\x0C\0\x06\0\x03\0\0\0\xA6\x01\0\0\x01\0\0\0\x04\0\0\0\xA5\x01\0\0Q\0\x05\0\x03\0\0\0\xA7\x01\0\0\x90\x01\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\xA8\x01\0\0\x1C\0\0\0\xA7\x01\0\0\xBC\0\x05\0\x0F\0\0\0\xA9\x01\0\0\xA6\x01\0\0\xA8\x01\0\0Q\0\x05\0\x03\0\0\0\xAA\x01\0\0\x90\x01\0\0\x03\0\0\0\xBA\0\x05\0\x0F\0\0\0\xAB\x01\0\0\xAA\x01\0\0e\0\0\0\xF7\0\x03\0\xAC\x01\0\0\0\0\0\0\xFA\0\x04\0\xAB\x01\0\0\xAD\x01\0\0\xAE\x01\0\0\xF8\0\x02\0\xAD\x01\0\0>\0\x03\0\x95\x01\0\0\xA9\x01\0\0\xF9\0\x02\0\xAC\x01\0\0\xF8\0\x02\0\xAE\x01\0\0>\0\x03\0\x95\x01\0\0\x94\x01\0\0\xF9\0\x02\0\xAC\x01\0\0\xF8\0\x02\0\xAC\x01\0\0=\0\x04\0\x0F\0\0\0\xAF\x01\0\0\x95\x01\0\0\xF7\0\x03\0\xB0\x01\0\0\0\0\0\0\xFA\0\x04\0\xAF\x01\0\0\xB1\x01\0\0\xB2\x01\0\0\xF8\0\x02\0\xB1\x01\0\0Q\0\x05\0\x03\0\0\0\xB3\x01\0\0\x90\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xB4\x01\0\0\x90\x01\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\xB5\x01\0\0\xA1\x01\0\0\xB4\x01\0\0\xBE\0\x05\0\x0F\0\0\0\xB6\x01\0\0\xB3\x01\0\0\xB5\x01\0\0>\0\x03\0\x97\x01\0\0\xB6\x01\0\0\xF9\0\x02\0\xB0\x01\0\0\xF8\0\x02\0\xB2\x01\0\0>\0\x03\0\x97\x01\0\0\x94\x01\0\0\xF9\0\x02\0\xB0\x01\0\0\xF8\0\x02\0\xB0\x01\0\0=\0\x04\0\x0F\0\0\0\xB7\x01\0\0\x97\x01\0\0\xF7\0\x03\0\xB8\x01\0\0\0\0\0\0\xFA\0\x04\0\xB7\x01\0\0\xB9\x01\0\0\xBA\x01\0\0\xF8\0\x02\0\xB9\x01\0\0Q\0\x05\0\x03\0\0\0\xBB\x01\0\0\x90\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xBC\x01\0\0\x90\x01\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\xBD\x01\0\0\xA4\x01\0\0\xBC\x01\0\0\xBC\0\x05\0\x0F\0\0\0\xBE\x01\0\0\xBB\x01\0\0\xBD\x01\0\0>\0\x03\0\x99\x01\0\0\xBE\x01\0\0\xF9\0\x02\0\xB8\x01\0\0\xF8\0\x02\0\xBA\x01\0\0>\0\x03\0\x99\x01\0\0\x94\x01\0\0\xF9\0\x02\0\xB8\x01\0\0\xF8\0\x02\0\xB8\x01\0\0=\0\x04\0\x0F\0\0\0\xBF\x01\0\0\x99\x01\0\0\xFE\0\x02\0\xBF\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xC3\x01\0\0\0\0\0\0d\0\0\x007\0\x03\0\x03\0\0\0\xC1\x01\0\x007\0\x03\0\x03\0\0\0\xC2\x01\0\0\xF8\0\x02\0\xC0\x01\0\0A\0\x05\0l\0\0\0\xC4\x01\0\0 \0\0\0m\0\0\0\xF9\0\x02\0\xC6\x01\0\0\xF8\0\x02\0\xC6\x01\0\0A\0\x07\0\x85\0\0\0\xC7\x01\0\0\xC4\x01\0\0\x86\0\0\0t\0\0\0m\0\0\0=\0\x04\0\x03\0\0\0\xC8\x01\0\0\xC7\x01\0\0\xBC\0\x05\0\x0F\0\0\0\xC9\x01\0\0\xC2\x01\0\0\xC8\x01\0\0\xF7\0\x03\0\xCA\x01\0\0\0\0\0\0\xFA\0\x04\0\xC9\x01\0\0\xCB\x01\0\0\xCA\x01\0\0\xF8\0\x02\0\xCB\x01\0\0\xFE\0\x02\0e\0\0\0\xF8\0\x02\0\xCA\x01\0\0\x83\0\x05\0\x03\0\0\0\xCC\x01\0\0\xC2\x01\0\0\xC1\x01\0\0\x0C\0\x07\0\x03\0\0\0\xCD\x01\0\0\x01\0\0\0(\0\0\0\xC1\x01\0\0\xC8\x01\0\0\x88\0\x05\0\x03\0\0\0\xCE\x01\0\0\xCC\x01\0\0\xCD\x01\0\0\x85\0\x05\0\x03\0\0\0\xCF\x01\0\0\xC5\x01\0\0\xCE\x01\0\0\x85\0\x05\0\x03\0\0\0\xD0\x01\0\0\xCF\x01\0\0\xCE\x01\0\0A\0\x05\0\x84\0\0\0\xD1\x01\0\0\xC4\x01\0\0\x86\0\0\0=\0\x04\0\x05\0\0\0\xD2\x01\0\0\xD1\x01\0\09\0\x06\0\x03\0\0\0\xD3\x01\0\0J\0\0\0\xD2\x01\0\0\xC2\x01\0\0\x85\0\x05\0\x03\0\0\0\xD4\x01\0\0\xD3\x01\0\0\xC2\x01\0\0\x0C\0\x06\0\x03\0\0\0\xD5\x01\0\0\x01\0\0\0\x04\0\0\0\xD4\x01\0\0\x85\0\x05\0\x03\0\0\0\xD6\x01\0\0\xD0\x01\0\0\xD5\x01\0\0\xFE\0\x02\0\xD6\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xDA\x01\0\0\0\0\0\0\xDB\x01\0\x007\0\x03\0\x04\0\0\0\xD8\x01\0\x007\0\x03\0\x04\0\0\0\xD9\x01\0\0\xF8\0\x02\0\xD7\x01\0\0;\0\x05\0S\x01\0\0\xDD\x01\0\0\x07\0\0\0\xDE\x01\0\0A\0\x05\0l\0\0\0\xDC\x01\0\0 \0\0\0m\0\0\0\xF9\0\x02\0\xDF\x01\0\0\xF8\0\x02\0\xDF\x01\0\09\0\x05\0\x0F\0\0\0\xE0\x01\0\0\x91\x01\0\0\xD8\x01\0\0\xF7\0\x03\0\xE1\x01\0\0\0\0\0\0\xFA\0\x04\0\xE0\x01\0\0\xE2\x01\0\0\xE3\x01\0\0\xF8\0\x02\0\xE2\x01\0\09\0\x05\0\x0F\0\0\0\xE4\x01\0\0\x91\x01\0\0\xD9\x01\0\0>\0\x03\0\xDD\x01\0\0\xE4\x01\0\0\xF9\0\x02\0\xE1\x01\0\0\xF8\0\x02\0\xE3\x01\0\0>\0\x03\0\xDD\x01\0\0\x94\x01\0\0\xF9\0\x02\0\xE1\x01\0\0\xF8\0\x02\0\xE1\x01\0\0=\0\x04\0\x0F\0\0\0\xE5\x01\0\0\xDD\x01\0\0\xA8\0\x04\0\x0F\0\0\0\xE6\x01\0\0\xE5\x01\0\0\xF7\0\x03\0\xE7\x01\0\0\0\0\0\0\xFA\0\x04\0\xE6\x01\0\0\xE8\x01\0\0\xE7\x01\0\0\xF8\0\x02\0\xE8\x01\0\0\xFE\0\x02\0\x1F\0\0\0\xF8\0\x02\0\xE7\x01\0\0Q\0\x05\0\x03\0\0\0\xE9\x01\0\0\xD8\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xEA\x01\0\0\xD8\x01\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\xEB\x01\0\0\xE9\x01\0\0\xEA\x01\0\0Q\0\x05\0\x03\0\0\0\xEC\x01\0\0\xD9\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xED\x01\0\0\xD9\x01\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\xEE\x01\0\0\xEC\x01\0\0\xED\x01\0\0A\0\x06\0\x85\0\0\0\xF1\x01\0\0\xDC\x01\0\0\xF0\x01\0\0t\0\0\0=\0\x04\0\x03\0\0\0\xF2\x01\0\0\xF1\x01\0\0\x85\0\x05\0\x03\0\0\0\xF3\x01\0\0\x17\0\0\0\xF2\x01\0\0\x0C\0\x07\0\x03\0\0\0\xF4\x01\0\0\x01\0\0\0%\0\0\0\xEB\x01\0\0\xEE\x01\0\0\x0C\0\x07\0\x03\0\0\0\xF5\x01\0\0\x01\0\0\0(\0\0\0\xEB\x01\0\0\xEE\x01\0\09\0\x06\0\x03\0\0\0\xF6\x01\0\0\xC3\x01\0\0\xF4\x01\0\0\xF5\x01\0\0\x85\0\x05\0\x03\0\0\0\xF7\x01\0\0\xF3\x01\0\0\xF6\x01\0\0\xFE\0\x02\0\xF7\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xFC\x01\0\0\0\0\0\0\xFD\x01\0\x007\0\x03\0\x04\0\0\0\xF9\x01\0\x007\0\x03\0\x04\0\0\0\xFA\x01\0\x007\0\x03\0\x04\0\0\0\xFB\x01\0\0\xF8\0\x02\0\xF8\x01\0\0A\0\x05\0l\0\0\0\xFE\x01\0\0 \0\0\0m\0\0\0\xF9\0\x02\0\xFF\x01\0\0\xF8\0\x02\0\xFF\x01\0\09\0\x06\0\x03\0\0\0\0\x02\0\0\xDA\x01\0\0\xF9\x01\0\0\xFA\x01\0\09\0\x06\0\x03\0\0\0\x01\x02\0\0\xDA\x01\0\0\xFA\x01\0\0\xFB\x01\0\09\0\x06\0\x03\0\0\0\x02\x02\0\0\xDA\x01\0\0\xFB\x01\0\0\xF9\x01\0\0\x0C\0\x07\0\x03\0\0\0\x03\x02\0\0\x01\0\0\0(\0\0\0\x01\x02\0\0\x02\x02\0\0\x0C\0\x07\0\x03\0\0\0\x04\x02\0\0\x01\0\0\0(\0\0\0\0\x02\0\0\x03\x02\0\0\xFE\0\x02\0\x04\x02\0\08\0\x01\x006\0\x05\0\x04\0\0\0\x07\x02\0\0\0\0\0\0\x08\x02\0\x007\0\x03\0\x0E\0\0\0\x06\x02\0\0\xF8\0\x02\0\x05\x02\0\0;\0\x05\0S\x01\0\0\x0E\x02\0\0\x07\0\0\0\x0F\x02\0\0A\0\x05\0l\0\0\0\t\x02\0\0 \0\0\0m\0\0\0A\0\x05\0\xB4\0\0\0\n\x02\0\0#\0\0\0m\0\0\0A\0\x05\0\xB6\0\0\0\x0B\x02\0\0&\0\0\0m\0\0\0A\0\x05\0\xB6\0\0\0\x0C\x02\0\0)\0\0\0m\0\0\0\xF9\0\x02\0\x10\x02\0\0\xF8\0\x02\0\x10\x02\0\0Q\0\x05\0\x07\0\0\0\x11\x02\0\0\x06\x02\0\0\0\0\0\0\x89\0\x05\0\x07\0\0\0\x12\x02\0\0\x11\x02\0\0\x14\0\0\0Q\0\x05\0\x07\0\0\0\x13\x02\0\0\x06\x02\0\0\0\0\0\0\x82\0\x05\0\x07\0\0\0\x14\x02\0\0\x13\x02\0\0\x12\x02\0\09\0\x06\0\x04\0\0\0\x15\x02\0\0(\x01\0\0\x06\x02\0\0\x14\x02\0\0\x80\0\x05\0\x07\0\0\0\x16\x02\0\0\x14\x02\0\0t\0\0\09\0\x06\0\x04\0\0\0\x17\x02\0\0(\x01\0\0\x06\x02\0\0\x16\x02\0\0\x80\0\x05\0\x07\0\0\0\x18\x02\0\0\x14\x02\0\0\x06\0\0\09\0\x06\0\x04\0\0\0\x19\x02\0\0(\x01\0\0\x06\x02\0\0\x18\x02\0\0P\0\x06\0\x13\0\0\0\x1A\x02\0\0\x15\x02\0\0\x17\x02\0\0\x19\x02\0\0Q\0\x05\0\x04\0\0\0\x1B\x02\0\0\x1A\x02\0\0\x02\0\0\0Q\0\x05\0\x04\0\0\0\x1C\x02\0\0\x1A\x02\0\0\x01\0\0\0\xAA\0\x05\0\x0F\0\0\0\x1D\x02\0\0\x12\x02\0\0t\0\0\0P\0\x07\0\x1F\x02\0\0 \x02\0\0\x1D\x02\0\0\x1D\x02\0\0\x1D\x02\0\0\x1D\x02\0\0\xA9\0\x06\0\x04\0\0\0\x1E\x02\0\0 \x02\0\0\x1C\x02\0\0\x1B\x02\0\0Q\0\x05\0\x04\0\0\0!\x02\0\0\x1A\x02\0\0\0\0\0\0\xAA\0\x05\0\x0F\0\0\0\"\x02\0\0\x12\x02\0\0m\0\0\0P\0\x07\0\x1F\x02\0\0$\x02\0\0\"\x02\0\0\"\x02\0\0\"\x02\0\0\"\x02\0\0\xA9\0\x06\0\x04\0\0\0#\x02\0\0$\x02\0\0!\x02\0\0\x1E\x02\0\09\0\x04\0\x0F\0\0\0%\x02\0\0\x80\0\0\0\xF7\0\x03\0&\x02\0\0\0\0\0\0\xFA\0\x04\0%\x02\0\0'\x02\0\0&\x02\0\0\xF8\0\x02\0'\x02\0\0Q\0\x05\0\x04\0\0\0(\x02\0\0\x1A\x02\0\0\0\0\0\09\0\x05\0\x04\0\0\0)\x02\0\0k\0\0\0(\x02\0\0Q\0\x05\0\x04\0\0\0*\x02\0\0\x1A\x02\0\0\x01\0\0\09\0\x05\0\x04\0\0\0+\x02\0\0k\0\0\0*\x02\0\0Q\0\x05\0\x04\0\0\0,\x02\0\0\x1A\x02\0\0\x02\0\0\09\0\x05\0\x04\0\0\0-\x02\0\0k\0\0\0,\x02\0\09\0\x07\0\x0F\0\0\0.\x02\0\0M\x01\0\0)\x02\0\0+\x02\0\0-\x02\0\0\xA8\0\x04\0\x0F\0\0\0/\x02\0\0.\x02\0\0\xF7\0\x03\x000\x02\0\0\0\0\0\0\xFA\0\x04\0/\x02\0\x001\x02\0\x002\x02\0\0\xF8\0\x02\x001\x02\0\09\0\x07\0\x03\0\0\x003\x02\0\0\xFC\x01\0\0)\x02\0\0+\x02\0\0-\x02\0\0\xBC\0\x05\0\x0F\0\0\x004\x02\0\x003\x02\0\0\x15\0\0\0\xA8\0\x04\0\x0F\0\0\x005\x02\0\x004\x02\0\0>\0\x03\0\x0E\x02\0\x005\x02\0\0\xF9\0\x02\x000\x02\0\0\xF8\0\x02\x002\x02\0\0>\0\x03\0\x0E\x02\0\0P\x01\0\0\xF9\0\x02\x000\x02\0\0\xF8\0\x02\x000\x02\0\0=\0\x04\0\x0F\0\0\x006\x02\0\0\x0E\x02\0\0\xF7\0\x03\x007\x02\0\0\0\0\0\0\xFA\0\x04\x006\x02\0\08\x02\0\x007\x02\0\0\xF8\0\x02\08\x02\0\0\xFE\0\x02\0\r\x02\0\0\xF8\0\x02\x007\x02\0\0\xF9\0\x02\0&\x02\0\0\xF8\0\x02\0&\x02\0\0\xFE\0\x02\0#\x02\0\08\0\x01\x006\0\x05\0\x02\0\0\0J\x02\0\0\0\0\0\0K\x02\0\0\xF8\0\x02\09\x02\0\0=\0\x04\0\x07\0\0\0=\x02\0\0;\x02\0\0=\0\x04\0\x04\0\0\0@\x02\0\0>\x02\0\0=\0\x04\0\x04\0\0\0B\x02\0\0A\x02\0\0=\0\x04\0\x04\0\0\0D\x02\0\0C\x02\0\0P\0\x07\0\x0E\0\0\0:\x02\0\0=\x02\0\0@\x02\0\0B\x02\0\0D\x02\0\0A\0\x05\0l\0\0\0L\x02\0\0 \0\0\0m\0\0\0A\0\x05\0\xB4\0\0\0M\x02\0\0#\0\0\0m\0\0\0A\0\x05\0\xB6\0\0\0N\x02\0\0&\0\0\0m\0\0\0A\0\x05\0\xB6\0\0\0O\x02\0\0)\0\0\0m\0\0\0\xF9\0\x02\0P\x02\0\0\xF8\0\x02\0P\x02\0\09\0\x05\0\x04\0\0\0Q\x02\0\0\x07\x02\0\0:\x02\0\09\0\x05\0\x04\0\0\0R\x02\0\0\x8C\0\0\0Q\x02\0\09\0\x05\0\x04\0\0\0S\x02\0\0X\0\0\0R\x02\0\0Q\0\x05\0\x03\0\0\0T\x02\0\0R\x02\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0U\x02\0\0R\x02\0\0\x03\0\0\0P\0\x06\0\r\0\0\0V\x02\0\0S\x02\0\0T\x02\0\0U\x02\0\0Q\0\x05\0\x04\0\0\0W\x02\0\0V\x02\0\0\0\0\0\0>\0\x03\0E\x02\0\0W\x02\0\0Q\0\x05\0\x03\0\0\0X\x02\0\0V\x02\0\0\x01\0\0\0>\0\x03\0G\x02\0\0X\x02\0\0Q\0\x05\0\x03\0\0\0Y\x02\0\0V\x02\0\0\x02\0\0\0>\0\x03\0I\x02\0\0Y\x02\0\0\xFD\0\x01\08\0\x01\x006\0\x05\0\x02\0\0\0d\x02\0\0\0\0\0\0K\x02\0\0\xF8\0\x02\0Z\x02\0\0=\0\x04\0\x04\0\0\0]\x02\0\0\\\x02\0\0=\0\x04\0\x03\0\0\0`\x02\0\0^\x02\0\0=\0\x04\0\x03\0\0\0b\x02\0\0a\x02\0\0P\0\x06\0\r\0\0\0[\x02\0\0]\x02\0\0`\x02\0\0b\x02\0\0\xF9\0\x02\0e\x02\0\0\xF8\0\x02\0e\x02\0\0Q\0\x05\0\x03\0\0\0f\x02\0\0[\x02\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0g\x02\0\0[\x02\0\0\x02\0\0\09\0\x06\0\x03\0\0\0h\x02\0\0c\0\0\0f\x02\0\0g\x02\0\0>\0\x03\0c\x02\0\0h\x02\0\0\xFD\0\x01\08\0\x01\0";
    /// WGSL of the capture_bent shader.
    pub const CAPTURE_BENT_WGSL: &str = r#"// SunLog: decides texel by texel the casters that bent rows bend too far for straight edges.
// Positions are relative to the eye, in the capture's axes: the camera's (x right, y up, looking along -z), sheared as the plan says.
// Sun over an open world without a step: face columns whose rows run with the logarithm of distance, casters that
// span many rows decided pixel by pixel.
// Generated from light case `SunLog`, ed72eb4d5233de5a. Do not edit.

/// Texels along the rows that edges of casters may be off.
const SUN_LOG_STRETCH_BOUND: f32 = 0.25;

/// What capturing needs of one facet, in the capture's axes: its matrix, row by row.
struct SunLogCapture {
    /// Clip x of the tile, to the right.
    row_x: vec4<f32>,
    /// Clip y of the tile, upwards.
    row_y: vec4<f32>,
    /// Clip z: depth along the light times w.
    row_z: vec4<f32>,
    /// Clip w, positive on receivers.
    row_w: vec4<f32>,
    /// How y/w becomes clip y: shifts and scales of a monotone curve.
    remap: array<vec4<f32>, 2>,
    /// Width and height of the tile in texels.
    tile_size: vec2<f32>,
    /// Smallest and largest k of the tile (xy), map texel of its upper left corner (zw).
    stretch_tile: vec4<f32>,
}

/// The facet that is captured.
@group(0) @binding(0)
var<uniform> sun_log_capture: SunLogCapture;
/// Where the caster's vertices lie in its buffers.
@group(1) @binding(0)
var<uniform> sun_log_mesh_layout: array<vec4<u32>, 2>;
/// Positions of the caster, as words.
@group(1) @binding(1)
var<storage, read> sun_log_mesh_positions: array<u32>;
/// Indices of the caster, as words.
@group(1) @binding(2)
var<storage, read> sun_log_mesh_indices: array<u32>;

/// Clip y after division, of one over distance.
fn sun_log_remapped(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].y + remap[1].z * inverse_distance;
    }
    return remap[0].x + remap[0].y * log(inverse_distance * remap[0].z);
}

/// Change of clip y after division per change of one over distance.
fn sun_log_remap_slope(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].z;
    }
    return remap[0].y / inverse_distance;
}

/// One over distance, of clip y after division: the inverse of `sun_log_remapped`.
fn sun_log_unremapped(remap: array<vec4<f32>, 2>, y: f32) -> f32 {
    let beyond_horizon = (y - remap[1].y) / remap[1].z;
    if beyond_horizon <= remap[1].x {
        return beyond_horizon;
    }
    return exp((y - remap[0].x) / remap[0].y) / remap[0].z;
}

/// How rows bend between two k.
struct SunLogBend {
    /// Least change of clip y per change of k.
    least: f32,
    /// Greatest change.
    most: f32,
    /// Whether rows lie above the chord.
    is_up: bool,
    /// Whether rows lie below the chord.
    is_down: bool,
}

/// Whether a bent edge bulges out of its triangle; `inner` is positive where the inside lies to the left of the way
/// from one end to the other, x to the right and y up.
fn sun_log_bulges_out(bend: SunLogBend, width: f32, inner: f32) -> bool {
    return select(bend.is_down, bend.is_up, inner * width < 0.0);
}

/// Texels by which a straight edge is widened, so that it meets what a rasteriser makes of the same edge.
const SUN_LOG_CHORD_MARGIN: f32 = 0.0078125;

/// 1 where clip y grows with k, -1 where it falls.
fn sun_log_row_sign() -> f32 {
    return sign(sun_log_remap_slope(sun_log_capture.remap, sun_log_capture.stretch_tile.y));
}

/// Largest k of a horizon; rows without any bend end there.
const SUN_LOG_STRAIGHT_HORIZON: f32 = 1e38;

/// Whether the facet's rows are bent at all.
fn sun_log_is_bent() -> bool {
    return sun_log_capture.remap[1].x < SUN_LOG_STRAIGHT_HORIZON;
}

/// Bound of the distance, in clip y, between the bent rows from one k to a larger one and the chord across them.
fn sun_log_chord_error(low: f32, high: f32) -> f32 {
    let horizon = sun_log_capture.remap[1].x;
    if high <= horizon {
        return 0.0;
    }

    // The second derivative is largest where the curve begins.
    let relative = (high - low) / max(low, horizon);
    return 0.125 * relative * relative * abs(sun_log_remap_slope(sun_log_capture.remap, high) * high);
}

/// How the rows bend from one k to a larger one.
fn sun_log_bend_between(low: f32, high: f32) -> SunLogBend {
    let start = sun_log_remap_slope(sun_log_capture.remap, low);
    let end = sun_log_remap_slope(sun_log_capture.remap, high);
    return SunLogBend(min(start, end), max(start, end), start > end, start < end);
}

/// A corner of a caster's triangle, or of what is drawn for it.
struct SunLogCasterVertex {
    /// Its number in the draw.
    @builtin(vertex_index) number: u32,
    /// First of the instance's rows; they take the object's space to the capture's axes, relative to the eye.
    @location(1) eye_from_object_x: vec4<f32>,
    /// Second row.
    @location(2) eye_from_object_y: vec4<f32>,
    /// Third row.
    @location(3) eye_from_object_z: vec4<f32>,
}

/// Position of a corner of the mesh's triangle list in the capture's axes.
fn sun_log_corner_position(caster: SunLogCasterVertex, corner: u32) -> vec4<f32> {
    let word = sun_log_mesh_layout[0].x + sun_log_mesh_vertex(corner) * sun_log_mesh_layout[0].y;
    let words = vec3<u32>(sun_log_mesh_positions[word], sun_log_mesh_positions[word + 1u], sun_log_mesh_positions[word + 2u]);
    let object = vec4<f32>(sun_log_decoded(words, sun_log_mesh_layout[1].x), 1.0);
    return vec4<f32>(
        dot(caster.eye_from_object_x, object),
        dot(caster.eye_from_object_y, object),
        dot(caster.eye_from_object_z, object),
        1.0,
    );
}

/// The vertex of a corner of the mesh's triangle list.
fn sun_log_mesh_vertex(corner: u32) -> u32 {
    let index = sun_log_mesh_layout[0].z + corner;
    switch sun_log_mesh_layout[0].w {
        case 0u: {
            return corner;
        }
        case 1u: {
            return extractBits(sun_log_mesh_indices[index / 2u], 16u * (index % 2u), 16u);
        }
        default: {
            return sun_log_mesh_indices[index];
        }
    }
}

/// The floats that a vertex fetch makes of words.
fn sun_log_decoded(words: vec3<u32>, format: u32) -> vec3<f32> {
    switch format {
        case 0u: {
            return bitcast<vec3<f32>>(words);
        }
        case 1u: {
            return vec3<f32>(sun_log_half_floats(words.x), sun_log_half_floats(words.y).x);
        }
        case 2u: {
            return vec3<f32>(unpack2x16snorm(words.x), unpack2x16snorm(words.y).x);
        }
        case 3u: {
            return vec3<f32>(unpack2x16unorm(words.x), unpack2x16unorm(words.y).x);
        }
        case 4u: {
            return unpack4x8snorm(words.x).xyz;
        }
        case 5u: {
            return unpack4x8unorm(words.x).xyz;
        }
        default: {
            return vec3<f32>((vec3<u32>(words.x) >> vec3<u32>(0u, 10u, 20u)) & vec3<u32>(1023u)) / 1023.0;
        }
    }
}

/// The two half floats of a word; infinities are large numbers.
fn sun_log_half_floats(word: u32) -> vec2<f32> {
    let halves = vec2<u32>(word & 0xffffu, word >> 16u);
    let magnitudes = halves & vec2<u32>(0x7fffu);
    let normal = bitcast<vec2<f32>>((magnitudes << vec2<u32>(13u)) + vec2<u32>(112u << 23u));
    let small = vec2<f32>(magnitudes) * SUN_LOG_SMALLEST_HALF;
    let values = select(normal, small, magnitudes < vec2<u32>(0x400u));
    return select(values, -values, halves > vec2<u32>(0x7fffu));
}

/// The smallest half float above zero.
const SUN_LOG_SMALLEST_HALF: f32 = 5.9604645e-8;

/// Applies the facet's matrix, row by row, to a position in the capture's axes; y/w is k, which is not bent yet.
fn sun_log_straight_corner(position: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(
        dot(sun_log_capture.row_x, position),
        dot(sun_log_capture.row_y, position),
        dot(sun_log_capture.row_z, position),
        dot(sun_log_capture.row_w, position),
    );
}

/// How far from the tile a corner may lie, in tiles, and in multiples of the nearest and farthest k.
const SUN_LOG_FARTHEST_CORNER: vec3<f32> = vec3<f32>(64.0, 4.0, 0.25);

/// Whether a corner has a place in the bent tile or not too far from it; none has at w = 0 and behind.
fn sun_log_has_place(corner: vec4<f32>) -> bool {
    let low = min(sun_log_capture.stretch_tile.x, SUN_LOG_FARTHEST_CORNER.z * sun_log_capture.stretch_tile.x);
    let high = SUN_LOG_FARTHEST_CORNER.y * sun_log_capture.stretch_tile.y;
    let is_beside = abs(corner.x) <= SUN_LOG_FARTHEST_CORNER.x * corner.w;
    return corner.w > 0.0 && is_beside && corner.y >= low * corner.w && corner.y <= high * corner.w;
}

/// Whether all of a triangle lies outside one edge of the tile.
fn sun_log_is_outside(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> bool {
    let x = vec3<f32>(one.x, two.x, three.x);
    let y = vec3<f32>(one.y, two.y, three.y);
    let w = vec3<f32>(one.w, two.w, three.w);
    let is_aside = all(x > w) || all(x < -w);
    let is_before = all(y > sun_log_capture.stretch_tile.y * w) || all(y < sun_log_capture.stretch_tile.x * w);
    return is_aside || is_before || all(w <= vec3<f32>(0.0));
}

/// Texels by which an edge with straight ends misses the bent one; beyond any bound where an end has no place.
fn sun_log_edge_error(one: vec4<f32>, two: vec4<f32>) -> f32 {
    if !(sun_log_has_place(one) && sun_log_has_place(two)) {
        return SUN_LOG_NO_PLACE;
    }
    let start = one.y / one.w;
    let end = two.y / two.w;
    return 0.5 * sun_log_capture.tile_size.y * sun_log_chord_error(min(start, end), max(start, end));
}

/// An error beyond any bound.
const SUN_LOG_NO_PLACE: f32 = 1e30;

/// The largest of a triangle's edges' errors; no point inside is farther off.
fn sun_log_triangle_error(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> f32 {
    return max(sun_log_edge_error(one, two), max(sun_log_edge_error(two, three), sun_log_edge_error(three, one)));
}

/// A position that no tile shows.
const SUN_LOG_HIDDEN: vec4<f32> = vec4<f32>(2.0, 2.0, 0.5, 1.0);

/// Twice the signed area between the origin and two points. Both triangles of an edge get the same digits with opposite
/// signs, so that no texel falls between them.
fn sun_log_turned(one: vec2<f32>, two: vec2<f32>) -> f32 {
    let is_swapped = one.x > two.x || (one.x == two.x && one.y > two.y);
    let start = select(one, two, is_swapped);
    let end = select(two, one, is_swapped);
    let turn = start.x * end.y - end.x * start.y;
    return select(turn, -turn, is_swapped);
}

/// Weights of a triangle's corners at a place, up to a common factor; inside, all have the sign of their sum times w.
/// Corners at w = 0 and behind are corners like all others (Olano and Greer, triangle scan conversion using 2D
/// homogeneous coordinates).
fn sun_log_straight_weights(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>, place: vec2<f32>) -> vec3<f32> {
    let from_one = one.xy - place * one.w;
    let from_two = two.xy - place * two.w;
    let from_three = three.xy - place * three.w;
    return vec3<f32>(sun_log_turned(from_two, from_three), sun_log_turned(from_three, from_one), sun_log_turned(from_one, from_two));
}

/// Corners of a triangle whose bent edges are decided texel by texel.
struct SunLogBentTriangle {
    /// Clip x, k times w, clip z and w of the first corner.
    one: vec4<f32>,
    /// Second corner.
    two: vec4<f32>,
    /// Third corner.
    three: vec4<f32>,
    /// Clip y of the corners after division (xyz), and the sum of 1, 2 and 4 for each of the edges opposite them that
    /// is taken straight, as the triangle on its other side may have it.
    chords: vec4<f32>,
}

/// Share of each corner at a texel of the map (xyz), and 1 inside, -1 outside (w).
fn sun_log_bent_shares(triangle: SunLogBentTriangle, texel: vec2<f32>) -> vec4<f32> {
    let half_size = 0.5 * sun_log_capture.tile_size;
    let offset = (texel - sun_log_capture.stretch_tile.zw - half_size) / half_size;
    let ndc = vec2<f32>(offset.x, -offset.y);
    let place = vec2<f32>(ndc.x, sun_log_unremapped(sun_log_capture.remap, ndc.y));
    let w = vec3<f32>(triangle.one.w, triangle.two.w, triangle.three.w);
    let unsigned_weights = sun_log_straight_weights(triangle.one, triangle.two, triangle.three, place);
    let side = sign(dot(unsigned_weights, w));
    let weights = unsigned_weights * side;

    // Straight edges are decided in texels, with a margin that no rasteriser rounds away.
    let x = vec3<f32>(triangle.one.x, triangle.two.x, triangle.three.x) / w;
    let one = (vec2<f32>(x.x, triangle.chords.x) - ndc) * half_size;
    let two = (vec2<f32>(x.y, triangle.chords.y) - ndc) * half_size;
    let three = (vec2<f32>(x.z, triangle.chords.z) - ndc) * half_size;
    let lengths = vec3<f32>(distance(two, three), distance(three, one), distance(one, two));
    let turns = vec3<f32>(sun_log_turned(two, three), sun_log_turned(three, one), sun_log_turned(one, two));
    let chord_tests = turns * side * sun_log_row_sign() + SUN_LOG_CHORD_MARGIN * lengths;
    let chords = vec3<u32>(u32(triangle.chords.w)) & vec3<u32>(1u, 2u, 4u);
    let tests = select(weights, chord_tests, chords != vec3<u32>(0u));

    // Beside a straight edge the nearest point of the triangle counts.
    let kept = max(weights, vec3<f32>(0.0));
    let is_inside = all(tests >= vec3<f32>(0.0)) && dot(kept, w) > 0.0;
    return vec4<f32>(kept / max(kept.x + kept.y + kept.z, SUN_LOG_SMALLEST_SUM), select(-1.0, 1.0, is_inside));
}

/// Smallest sum of weights that is divided by.
const SUN_LOG_SMALLEST_SUM: f32 = 1e-37;

/// The depth of a triangle's point with these shares of its corners.
fn sun_log_bent_depth(triangle: SunLogBentTriangle, shares: vec3<f32>) -> f32 {
    let z = dot(shares, vec3<f32>(triangle.one.z, triangle.two.z, triangle.three.z));
    let w = dot(shares, vec3<f32>(triangle.one.w, triangle.two.w, triangle.three.w));
    return clamp(z / w, 0.0, 1.0);
}

/// The triangle of three corners with its straight edges.
fn sun_log_bent_triangle(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> SunLogBentTriangle {
    let inner = sun_log_inner_side(one, two, three);
    let first = select(0.0, 1.0, sun_log_is_chord(two, three, inner));
    let second = select(0.0, 2.0, sun_log_is_chord(three, one, inner));
    let third = select(0.0, 4.0, sun_log_is_chord(one, two, inner));
    let rows = vec3<f32>(sun_log_chord_row(one), sun_log_chord_row(two), sun_log_chord_row(three));
    return SunLogBentTriangle(one, two, three, vec4<f32>(rows, first + second + third));
}

/// Clip y of a corner after division; zero where it has no place.
fn sun_log_chord_row(corner: vec4<f32>) -> f32 {
    if !sun_log_has_place(corner) {
        return 0.0;
    }
    return sun_log_remapped(sun_log_capture.remap, corner.y / corner.w);
}

/// Whether an edge is taken straight: it misses the bent one by no more than the bound and does not lie within it.
fn sun_log_is_chord(one: vec4<f32>, two: vec4<f32>, inner: f32) -> bool {
    let error = sun_log_edge_error(one, two);
    if error > SUN_LOG_STRETCH_BOUND || !sun_log_is_bent() {
        return false;
    }
    let start = one.y / one.w;
    let end = two.y / two.w;
    let bend = sun_log_bend_between(min(start, end), max(start, end));
    return error <= SUN_LOG_CHORD_MARGIN || !sun_log_bulges_out(bend, two.x / two.w - one.x / one.w, inner);
}

/// First corner, in the mesh's triangle list, of the triangle that a vertex is drawn for.
fn sun_log_fan_triangle(vertex: u32) -> u32 {
    return vertex / 12u * 3u;
}

/// Which of the six corners a vertex is.
fn sun_log_fan_corner(vertex: u32) -> u32 {
    let corner = vertex % 3u;
    return select(vertex % 12u / 3u + corner, 0u, corner == 0u);
}

/// Texels by which a polygon is widened, so that no rounding loses a texel.
const SUN_LOG_COVER_MARGIN: f32 = 0.0625;
/// Height in texels below which a triangle gets a box.
const SUN_LOG_THIN: f32 = 1.5;

/// A corner of what covers a triangle; six of them go around it.
fn sun_log_covering_corner(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>, number: u32) -> vec4<f32> {
    if sun_log_has_place(one) && sun_log_has_place(two) && sun_log_has_place(three) {
        return sun_log_tile_corner(sun_log_cover(one, two, three, number));
    }
    let box = sun_log_cut_box(one, two, three);
    if !(box.x <= box.z && box.y <= box.w) {
        return SUN_LOG_HIDDEN;
    }
    return sun_log_tile_corner(sun_log_box_corner(box, number));
}

/// Position in the tile of a point in texels, right and up from the tile's centre.
fn sun_log_tile_corner(point: vec2<f32>) -> vec4<f32> {
    return vec4<f32>(2.0 * point / sun_log_capture.tile_size, 0.5, 1.0);
}

/// The point of a corner that has a place, in texels, right and up from the tile's centre.
fn sun_log_bent_point(corner: vec4<f32>) -> vec2<f32> {
    let y = sun_log_remapped(sun_log_capture.remap, corner.y / corner.w);
    return 0.5 * sun_log_capture.tile_size * vec2<f32>(corner.x / corner.w, y);
}

/// Side on which the inside of a triangle lies: 1 to the left of its edges, x to the right and y up; 0 where rounding
/// could decide.
fn sun_log_inner_side(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> f32 {
    let start = one.xy / one.w;
    let second = two.xy / two.w - start;
    let third = three.xy / three.w - start;
    let left = second.x * third.y;
    let right = second.y * third.x;
    let turn = left - right;
    return select(0.0, sign(turn) * sun_log_row_sign(), abs(turn) > SUN_LOG_SURE_TURN * (abs(left) + abs(right)));
}

/// Share of its parts beyond which a difference has a sure sign.
const SUN_LOG_SURE_TURN: f32 = 1e-4;

/// A corner of the polygon around a triangle whose corners all have a place.
fn sun_log_cover(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>, number: u32) -> vec2<f32> {
    let at_one = sun_log_bent_point(one);
    let at_two = sun_log_bent_point(two);
    let at_three = sun_log_bent_point(three);
    let first_edge = at_two - at_one;
    let last_edge = at_three - at_one;
    let area = first_edge.x * last_edge.y - first_edge.y * last_edge.x;
    let longest = max(max(length(first_edge), length(last_edge)), distance(at_two, at_three));
    let inner = sun_log_inner_side(one, two, three);
    if !(area * inner >= SUN_LOG_THIN * longest) {
        return sun_log_thin_cover(one, two, three, number);
    }

    // Go around, then away from the centre, by the margin at least.
    var point = at_one;
    switch number {
        case 0u: {}
        case 1u: {
            point = sun_log_outer_point(one, two, inner);
        }
        case 2u: {
            point = at_two;
        }
        case 3u: {
            point = sun_log_outer_point(two, three, inner);
        }
        case 4u: {
            point = at_three;
        }
        default: {
            point = sun_log_outer_point(three, one, inner);
        }
    }
    let centre = (at_one + at_two + at_three) / 3.0;
    return centre + (point - centre) * (1.0 + 3.0 * SUN_LOG_COVER_MARGIN * longest / (area * inner));
}

/// Where the end tangents of an edge that bulges out meet; the middle of an edge that does not.
fn sun_log_outer_point(one: vec4<f32>, two: vec4<f32>, inner: f32) -> vec2<f32> {
    let at_one = sun_log_bent_point(one);
    let way = sun_log_bent_point(two) - at_one;
    let start = one.y / one.w;
    let end = two.y / two.w;
    let bend = sun_log_bend_between(min(start, end), max(start, end));
    if !sun_log_bulges_out(bend, way.x, inner) {
        return at_one + 0.5 * way;
    }

    // Slopes along the edge, from end to end.
    let rise = 0.5 * sun_log_capture.tile_size.y * (end - start);
    let highest = max(bend.least * rise, bend.most * rise);
    let lowest = min(bend.least * rise, bend.most * rise);
    let is_up = inner * way.x < 0.0;
    let leaving = select(lowest, highest, is_up);
    let arriving = select(highest, lowest, is_up);
    let part = (way.y - arriving) / (leaving - arriving);
    if !(part > 0.0 && part < 1.0) {
        return at_one + 0.5 * way;
    }
    return at_one + vec2<f32>(way.x, leaving) * part;
}

/// A corner of the box around a thin triangle, along its longest edge. Bulges to either side are in it.
fn sun_log_thin_cover(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>, number: u32) -> vec2<f32> {
    let at_one = sun_log_bent_point(one);
    let first_edge = sun_log_bent_point(two) - at_one;
    let last_edge = sun_log_bent_point(three) - at_one;
    let middle_edge = last_edge - first_edge;
    var longest = first_edge;
    longest = select(longest, last_edge, length(last_edge) > length(longest));
    longest = select(longest, middle_edge, length(middle_edge) > length(longest));
    let size = length(longest);
    let along = select(vec2<f32>(1.0, 0.0), longest / max(size, SUN_LOG_COVER_MARGIN), size > SUN_LOG_COVER_MARGIN);
    let axes = mat2x2<f32>(along, vec2<f32>(-along.y, along.x));

    var box = vec4<f32>(0.0);
    box = sun_log_widened(box, first_edge * axes);
    box = sun_log_widened(box, last_edge * axes);
    box = sun_log_widened(box, (sun_log_outer_point(one, two, 1.0) - at_one) * axes);
    box = sun_log_widened(box, (sun_log_outer_point(one, two, -1.0) - at_one) * axes);
    box = sun_log_widened(box, (sun_log_outer_point(two, three, 1.0) - at_one) * axes);
    box = sun_log_widened(box, (sun_log_outer_point(two, three, -1.0) - at_one) * axes);
    box = sun_log_widened(box, (sun_log_outer_point(three, one, 1.0) - at_one) * axes);
    box = sun_log_widened(box, (sun_log_outer_point(three, one, -1.0) - at_one) * axes);
    let margin = vec4<f32>(-SUN_LOG_COVER_MARGIN, -SUN_LOG_COVER_MARGIN, SUN_LOG_COVER_MARGIN, SUN_LOG_COVER_MARGIN);
    return at_one + axes * sun_log_box_corner(box + margin, number);
}

/// The smallest box that holds a box, given by its least and greatest corner, and a point.
fn sun_log_widened(box: vec4<f32>, point: vec2<f32>) -> vec4<f32> {
    return vec4<f32>(min(box.xy, point), max(box.zw, point));
}

/// A corner of a box; those after the fourth are the first again.
fn sun_log_box_corner(box: vec4<f32>, number: u32) -> vec2<f32> {
    let is_right = number == 1u || number == 2u;
    let is_upper = number == 2u || number == 3u;
    return vec2<f32>(select(box.x, box.z, is_right), select(box.y, box.w, is_upper));
}

/// The box, in texels from the tile's centre, around what the tile holds of a triangle; inside out where that is
/// nothing. It is decided where edges are straight: the tile's part of each edge, and the tile's corners that lie
/// inside.
fn sun_log_cut_box(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> vec4<f32> {
    let limits = sun_log_capture.stretch_tile;
    var box = vec4<f32>(SUN_LOG_NO_PLACE, SUN_LOG_NO_PLACE, -SUN_LOG_NO_PLACE, -SUN_LOG_NO_PLACE);
    box = sun_log_with_edge(box, one, two);
    box = sun_log_with_edge(box, two, three);
    box = sun_log_with_edge(box, three, one);
    for (var number = 0u; number < 4u; number++) {
        let corner = sun_log_box_corner(vec4<f32>(-1.0, limits.x, 1.0, limits.y), number);
        let weights = sun_log_straight_weights(one, two, three, corner);
        let side = sign(dot(weights, vec3<f32>(one.w, two.w, three.w)));
        if side != 0.0 && all(weights * side >= vec3<f32>(0.0)) {
            box = sun_log_widened(box, corner);
        }
    }

    // Bend its rows.
    let lower = sun_log_remapped(sun_log_capture.remap, box.y);
    let upper = sun_log_remapped(sun_log_capture.remap, box.w);
    let scale = 0.5 * vec4<f32>(sun_log_capture.tile_size, sun_log_capture.tile_size);
    let bent = vec4<f32>(box.x, min(lower, upper), box.z, max(lower, upper)) * scale;
    return select(bent + vec4<f32>(-1.0, -1.0, 1.0, 1.0), box, vec4<bool>(box.x > box.z));
}

/// A box in x/w and k that also holds the tile's part of an edge.
fn sun_log_with_edge(box: vec4<f32>, one: vec4<f32>, two: vec4<f32>) -> vec4<f32> {
    // Clip where the tile's four edges are planes through w = 0.
    let start = sun_log_tile_distances(one);
    let end = sun_log_tile_distances(two);
    let meets = start / (start - end);
    let entries = select(vec4<f32>(0.0), meets, start < vec4<f32>(0.0));
    let exits = select(vec4<f32>(1.0), meets, end < vec4<f32>(0.0));
    let entry = max(max(entries.x, entries.y), max(entries.z, entries.w));
    let exit = min(min(exits.x, exits.y), min(exits.z, exits.w));
    let is_missed = (start < vec4<f32>(0.0)) & (end < vec4<f32>(0.0));
    if any(is_missed) || entry > exit {
        return box;
    }
    return sun_log_widened(sun_log_widened(box, sun_log_tile_place(mix(one, two, entry))), sun_log_tile_place(mix(one, two, exit)));
}

/// Distances from the tile's left, right, far and near edge, times w; none is negative inside.
fn sun_log_tile_distances(corner: vec4<f32>) -> vec4<f32> {
    let limits = sun_log_capture.stretch_tile.xy * corner.w;
    return vec4<f32>(corner.w + corner.x, corner.w - corner.x, corner.y - limits.x, limits.y - corner.y);
}

/// x/w and k of a point on or inside the tile's edges.
fn sun_log_tile_place(corner: vec4<f32>) -> vec2<f32> {
    let place = corner.xy / max(corner.w, SUN_LOG_SMALLEST_SUM);
    return clamp(place, vec2<f32>(-1.0, sun_log_capture.stretch_tile.x), vec2<f32>(1.0, sun_log_capture.stretch_tile.y));
}

/// What the vertex stage of the bent capture hands to its fragment stage.
struct SunLogBentCaster {
    /// Position in the tile.
    @builtin(position) tile: vec4<f32>,
    /// First corner of the triangle.
    @location(0) @interpolate(flat) one: vec4<f32>,
    /// Second corner.
    @location(1) @interpolate(flat) two: vec4<f32>,
    /// Third corner.
    @location(2) @interpolate(flat) three: vec4<f32>,
    /// Its straight edges.
    @location(3) @interpolate(flat) chords: vec4<f32>,
}

/// Places a corner of what covers a triangle in the tile.
@vertex
fn sun_log_capture_bent_vertex(caster: SunLogCasterVertex) -> SunLogBentCaster {
    let first = sun_log_fan_triangle(caster.number);
    let one = sun_log_straight_corner(sun_log_corner_position(caster, first));
    let two = sun_log_straight_corner(sun_log_corner_position(caster, first + 1u));
    let three = sun_log_straight_corner(sun_log_corner_position(caster, first + 2u));
    let is_ordinary = !sun_log_is_bent() || sun_log_triangle_error(one, two, three) <= SUN_LOG_STRETCH_BOUND * SUN_LOG_SURE_BOUND;
    if is_ordinary || sun_log_is_outside(one, two, three) {
        return SunLogBentCaster(SUN_LOG_HIDDEN, one, two, three, vec4<f32>(0.0));
    }
    let triangle = sun_log_bent_triangle(one, two, three);
    let corner = sun_log_covering_corner(one, two, three, sun_log_fan_corner(caster.number));
    return SunLogBentCaster(corner, one, two, three, triangle.chords);
}

/// Share of the bound below which the ordinary pass draws a triangle, whatever the last digit of its error.
const SUN_LOG_SURE_BOUND: f32 = 0.9999;

/// Writes the depth of the triangle where it holds the texel's centre.
@fragment
fn sun_log_capture_bent_fragment(caster: SunLogBentCaster) -> @builtin(frag_depth) f32 {
    let triangle = SunLogBentTriangle(caster.one, caster.two, caster.three, caster.chords);
    let shares = sun_log_bent_shares(triangle, caster.tile.xy);
    if shares.w < 0.0 {
        discard;
    }
    return sun_log_bent_depth(triangle, shares.xyz);
}
"#;
    /// SPIR-V of the capture_bent shader, little-endian words.
    pub const CAPTURE_BENT_SPIRV: &[u8] = b"\x03\x02#\x07\0\x03\x01\0\x1C\0\0\0\xE7\x05\0\0\0\0\0\0\x11\0\x02\0\x01\0\0\0\x0B\0\x06\0\x01\0\0\0GLSL.std.450\0\0\0\0\x0E\0\x03\0\0\0\0\0\x01\0\0\0\x0F\0\x13\0\0\0\0\0\x90\x05\0\0sun_log_capture_bent_vertex\0\x80\x05\0\0\x83\x05\0\0\x86\x05\0\0\x88\x05\0\0\x8A\x05\0\0\x8C\x05\0\0\x8D\x05\0\0\x8E\x05\0\0\x8F\x05\0\0\x0F\0\x11\0\x04\0\0\0\xD6\x05\0\0sun_log_capture_bent_fragment\0\0\0\xCA\x05\0\0\xCC\x05\0\0\xCE\x05\0\0\xD0\x05\0\0\xD2\x05\0\0\xD4\x05\0\0\x10\0\x03\0\xD6\x05\0\0\x07\0\0\0\x10\0\x03\0\xD6\x05\0\0\x0C\0\0\0G\0\x04\0\x05\0\0\0\x06\0\0\0\x10\0\0\0H\0\x05\0\t\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\t\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\t\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\t\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\t\0\0\0\x04\0\0\0#\0\0\0@\0\0\0H\0\x05\0\t\0\0\0\x05\0\0\0#\0\0\0`\0\0\0H\0\x05\0\t\0\0\0\x06\0\0\0#\0\0\0p\0\0\0G\0\x04\0\x0B\0\0\0\x06\0\0\0\x10\0\0\0G\0\x04\0\x0C\0\0\0\x06\0\0\0\x04\0\0\0H\0\x05\0\x0E\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x0E\0\0\0\x01\0\0\0#\0\0\0\x04\0\0\0H\0\x05\0\x0E\0\0\0\x02\0\0\0#\0\0\0\x08\0\0\0H\0\x05\0\x0E\0\0\0\x03\0\0\0#\0\0\0\t\0\0\0H\0\x05\0\x0F\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x0F\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x0F\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\x0F\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\x13\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x13\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x13\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\x13\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\x15\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x15\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x15\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\x15\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\x15\0\0\0\x04\0\0\0#\0\0\0@\0\0\0G\0\x04\0'\0\0\0\"\0\0\0\0\0\0\0G\0\x04\0'\0\0\0!\0\0\0\0\0\0\0G\0\x03\0(\0\0\0\x02\0\0\0H\0\x05\0(\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0*\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0*\0\0\0!\0\0\0\0\0\0\0G\0\x03\0+\0\0\0\x02\0\0\0H\0\x05\0+\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x03\0-\0\0\0\x18\0\0\0G\0\x04\0-\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0-\0\0\0!\0\0\0\x01\0\0\0G\0\x03\0.\0\0\0\x02\0\0\0H\0\x05\0.\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x03\x000\0\0\0\x18\0\0\0G\0\x04\x000\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\x000\0\0\0!\0\0\0\x02\0\0\0G\0\x03\x001\0\0\0\x02\0\0\0H\0\x05\x001\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0\x80\x05\0\0\x0B\0\0\0*\0\0\0G\0\x04\0\x83\x05\0\0\x1E\0\0\0\x01\0\0\0G\0\x04\0\x86\x05\0\0\x1E\0\0\0\x02\0\0\0G\0\x04\0\x88\x05\0\0\x1E\0\0\0\x03\0\0\0G\0\x04\0\x8A\x05\0\0\x0B\0\0\0\0\0\0\0G\0\x04\0\x8C\x05\0\0\x1E\0\0\0\0\0\0\0G\0\x03\0\x8C\x05\0\0\x0E\0\0\0G\0\x04\0\x8D\x05\0\0\x1E\0\0\0\x01\0\0\0G\0\x03\0\x8D\x05\0\0\x0E\0\0\0G\0\x04\0\x8E\x05\0\0\x1E\0\0\0\x02\0\0\0G\0\x03\0\x8E\x05\0\0\x0E\0\0\0G\0\x04\0\x8F\x05\0\0\x1E\0\0\0\x03\0\0\0G\0\x03\0\x8F\x05\0\0\x0E\0\0\0G\0\x04\0\xCA\x05\0\0\x0B\0\0\0\x0F\0\0\0G\0\x04\0\xCC\x05\0\0\x1E\0\0\0\0\0\0\0G\0\x03\0\xCC\x05\0\0\x0E\0\0\0G\0\x04\0\xCE\x05\0\0\x1E\0\0\0\x01\0\0\0G\0\x03\0\xCE\x05\0\0\x0E\0\0\0G\0\x04\0\xD0\x05\0\0\x1E\0\0\0\x02\0\0\0G\0\x03\0\xD0\x05\0\0\x0E\0\0\0G\0\x04\0\xD2\x05\0\0\x1E\0\0\0\x03\0\0\0G\0\x03\0\xD2\x05\0\0\x0E\0\0\0G\0\x04\0\xD4\x05\0\0\x0B\0\0\0\x16\0\0\0\x13\0\x02\0\x02\0\0\0\x16\0\x03\0\x03\0\0\0 \0\0\0\x17\0\x04\0\x04\0\0\0\x03\0\0\0\x04\0\0\0\x15\0\x04\0\x07\0\0\0 \0\0\0\0\0\0\0+\0\x04\0\x07\0\0\0\x06\0\0\0\x02\0\0\0\x1C\0\x04\0\x05\0\0\0\x04\0\0\0\x06\0\0\0\x17\0\x04\0\x08\0\0\0\x03\0\0\0\x02\0\0\0\x1E\0\t\0\t\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x05\0\0\0\x08\0\0\0\x04\0\0\0\x17\0\x04\0\n\0\0\0\x07\0\0\0\x04\0\0\0\x1C\0\x04\0\x0B\0\0\0\n\0\0\0\x06\0\0\0\x1D\0\x03\0\x0C\0\0\0\x07\0\0\0\x14\0\x02\0\r\0\0\0\x1E\0\x06\0\x0E\0\0\0\x03\0\0\0\x03\0\0\0\r\0\0\0\r\0\0\0\x1E\0\x06\0\x0F\0\0\0\x07\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x17\0\x04\0\x10\0\0\0\x07\0\0\0\x02\0\0\0\x17\0\x04\0\x11\0\0\0\x07\0\0\0\x03\0\0\0\x17\0\x04\0\x12\0\0\0\x03\0\0\0\x03\0\0\0\x1E\0\x06\0\x13\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x18\0\x04\0\x14\0\0\0\x08\0\0\0\x02\0\0\0\x1E\0\x07\0\x15\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0+\0\x04\0\x03\0\0\0\x16\0\0\0\0\0\x80>+\0\x04\0\x03\0\0\0\x17\0\0\0\0\0\0<+\0\x04\0\x03\0\0\0\x18\0\0\0\x99v\x96~+\0\x04\0\x03\0\0\0\x19\0\0\0\0\0\x803+\0\x04\0\x03\0\0\0\x1A\0\0\0\0\0\x80B+\0\x04\0\x03\0\0\0\x1B\0\0\0\0\0\x80@,\0\x06\0\x12\0\0\0\x1C\0\0\0\x1A\0\0\0\x1B\0\0\0\x16\0\0\0+\0\x04\0\x03\0\0\0\x1D\0\0\0\xCA\xF2Iq+\0\x04\0\x03\0\0\0\x1E\0\0\0\0\0\0@+\0\x04\0\x03\0\0\0\x1F\0\0\0\0\0\0?+\0\x04\0\x03\0\0\0 \0\0\0\0\0\x80?,\0\x07\0\x04\0\0\0!\0\0\0\x1E\0\0\0\x1E\0\0\0\x1F\0\0\0 \0\0\0+\0\x04\0\x03\0\0\0\"\0\0\0\xEA\x1C\x08\x02+\0\x04\0\x03\0\0\0#\0\0\0\x17\xB7\xD18+\0\x04\0\x03\0\0\0$\0\0\0\0\0\x80=+\0\x04\0\x03\0\0\0%\0\0\0\0\0\xC0?+\0\x04\0\x03\0\0\0&\0\0\0r\xF9\x7F?\x1E\0\x03\0(\0\0\0\t\0\0\0 \0\x04\0)\0\0\0\x02\0\0\0(\0\0\0;\0\x04\0)\0\0\0'\0\0\0\x02\0\0\0\x1E\0\x03\0+\0\0\0\x0B\0\0\0 \0\x04\0,\0\0\0\x02\0\0\0+\0\0\0;\0\x04\0,\0\0\0*\0\0\0\x02\0\0\0\x1E\0\x03\0.\0\0\0\x0C\0\0\0 \0\x04\0/\0\0\0\x0C\0\0\0.\0\0\0;\0\x04\0/\0\0\0-\0\0\0\x0C\0\0\0\x1E\0\x03\x001\0\0\0\x0C\0\0\0 \0\x04\x002\0\0\0\x0C\0\0\x001\0\0\0;\0\x04\x002\0\0\x000\0\0\0\x0C\0\0\0!\0\x05\x007\0\0\0\x03\0\0\0\x05\0\0\0\x03\0\0\0!\0\x06\0|\0\0\0\r\0\0\0\x0E\0\0\0\x03\0\0\0\x03\0\0\0+\0\x04\0\x03\0\0\0}\0\0\0\0\0\0\0!\0\x03\0\x86\0\0\0\x03\0\0\0 \0\x04\0\x87\0\0\0\x02\0\0\0\t\0\0\0+\0\x04\0\x07\0\0\0\x88\0\0\0\0\0\0\0 \0\x04\0\x8B\0\0\0\x02\0\0\0\x05\0\0\0+\0\x04\0\x07\0\0\0\x8C\0\0\0\x04\0\0\0 \0\x04\0\x8F\0\0\0\x02\0\0\0\x04\0\0\0 \0\x04\0\x90\0\0\0\x02\0\0\0\x03\0\0\0+\0\x04\0\x07\0\0\0\x91\0\0\0\x01\0\0\0+\0\x04\0\x07\0\0\0\x92\0\0\0\x06\0\0\0!\0\x03\0\x99\0\0\0\r\0\0\0!\0\x05\0\xA3\0\0\0\x03\0\0\0\x03\0\0\0\x03\0\0\0+\0\x04\0\x03\0\0\0\xA5\0\0\0\0\0\0>!\0\x05\0\xBB\0\0\0\x0E\0\0\0\x03\0\0\0\x03\0\0\0!\0\x04\0\xCC\0\0\0\x07\0\0\0\x07\0\0\0 \0\x04\0\xCD\0\0\0\x02\0\0\0\x0B\0\0\0 \0\x04\0\xCF\0\0\0\x0C\0\0\0\x0C\0\0\0+\0\x04\0\x07\0\0\0\xD1\0\0\0\x10\0\0\0 \0\x04\0\xD3\0\0\0\x02\0\0\0\n\0\0\0 \0\x04\0\xD4\0\0\0\x02\0\0\0\x07\0\0\0+\0\x04\0\x07\0\0\0\xD8\0\0\0\x03\0\0\0 \0\x04\0\xE0\0\0\0\x0C\0\0\0\x07\0\0\0+\0\x04\0\x07\0\0\0\xE6\0\0\0 \0\0\0.\0\x03\0\x07\0\0\0\xEC\0\0\0!\0\x04\0\xF0\0\0\0\x08\0\0\0\x07\0\0\0+\0\x04\0\x07\0\0\0\xF1\0\0\0\xFF\xFF\0\0+\0\x04\0\x07\0\0\0\xF2\0\0\0\xFF\x7F\0\0,\0\x05\0\x10\0\0\0\xF3\0\0\0\xF2\0\0\0\xF2\0\0\0+\0\x04\0\x07\0\0\0\xF4\0\0\0\r\0\0\0,\0\x05\0\x10\0\0\0\xF5\0\0\0\xF4\0\0\0\xF4\0\0\0+\0\x04\0\x07\0\0\0\xF6\0\0\0\0\0\08,\0\x05\0\x10\0\0\0\xF7\0\0\0\xF6\0\0\0\xF6\0\0\0+\0\x04\0\x07\0\0\0\xF8\0\0\0\0\x04\0\0,\0\x05\0\x10\0\0\0\xF9\0\0\0\xF8\0\0\0\xF8\0\0\0\x17\0\x04\0\x04\x01\0\0\r\0\0\0\x02\0\0\0!\0\x05\0\x0E\x01\0\0\x12\0\0\0\x11\0\0\0\x07\0\0\0+\0\x04\0\x07\0\0\0\x0F\x01\0\0\n\0\0\0+\0\x04\0\x07\0\0\0\x10\x01\0\0\x14\0\0\0,\0\x06\0\x11\0\0\0\x11\x01\0\0\x88\0\0\0\x0F\x01\0\0\x10\x01\0\0+\0\x04\0\x07\0\0\0\x12\x01\0\0\xFF\x03\0\0,\0\x06\0\x11\0\0\0\x13\x01\0\0\x12\x01\0\0\x12\x01\0\0\x12\x01\0\0+\0\x04\0\x03\0\0\0\x14\x01\0\0\0\xC0\x7FD,\0\x06\0\x12\0\0\0\x15\x01\0\0\x14\x01\0\0\x14\x01\0\0\x14\x01\0\0.\0\x03\0\x12\0\0\0>\x01\0\0!\0\x05\0C\x01\0\0\x04\0\0\0\x0F\0\0\0\x07\0\0\0!\0\x04\0f\x01\0\0\x04\0\0\0\x04\0\0\0!\0\x04\0y\x01\0\0\r\0\0\0\x04\0\0\0*\0\x03\0\r\0\0\0{\x01\0\0 \0\x04\0}\x01\0\0\x07\0\0\0\r\0\0\0.\0\x03\0\r\0\0\0~\x01\0\0.\0\x03\0\r\0\0\0\x80\x01\0\0.\0\x03\0\r\0\0\0\x82\x01\0\0!\0\x06\0\xAD\x01\0\0\r\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0)\0\x03\0\r\0\0\0\xAF\x01\0\0,\0\x06\0\x12\0\0\0\xB0\x01\0\0}\0\0\0}\0\0\0}\0\0\0.\0\x03\0\r\0\0\0\xB2\x01\0\0.\0\x03\0\r\0\0\0\xB4\x01\0\0.\0\x03\0\r\0\0\0\xB6\x01\0\0.\0\x03\0\r\0\0\0\xB8\x01\0\0\x17\0\x04\0\xC6\x01\0\0\r\0\0\0\x03\0\0\0!\0\x05\0\xF0\x01\0\0\x03\0\0\0\x04\0\0\0\x04\0\0\0.\0\x03\0\r\0\0\0\xF3\x01\0\0 \0\x04\0\x04\x02\0\0\x02\0\0\0\x08\0\0\0+\0\x04\0\x07\0\0\0\x05\x02\0\0\x05\0\0\0!\0\x06\0\x12\x02\0\0\x03\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0!\0\x05\0\x1E\x02\0\0\x03\0\0\0\x08\0\0\0\x08\0\0\0.\0\x03\0\r\0\0\0 \x02\0\0.\0\x03\0\r\0\0\0\"\x02\0\0!\0\x07\0I\x02\0\0\x12\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x08\0\0\0!\0\x05\0_\x02\0\0\x04\0\0\0\x13\0\0\0\x08\0\0\0,\0\x06\0\x11\0\0\0a\x02\0\0\x91\0\0\0\x06\0\0\0\x8C\0\0\0,\0\x06\0\x11\0\0\0b\x02\0\0\x88\0\0\0\x88\0\0\0\x88\0\0\0+\0\x04\0\x03\0\0\0c\x02\0\0\0\0\x80\xBF.\0\x03\0\r\0\0\0e\x02\0\0+\0\x04\0\x03\0\0\0\xB1\x02\0\0\xFF\xFF\x7FO!\0\x05\0\xCF\x02\0\0\x03\0\0\0\x13\0\0\0\x12\0\0\0!\0\x06\0\x0E\x03\0\0\r\0\0\0\x04\0\0\0\x04\0\0\0\x03\0\0\0.\0\x03\0\r\0\0\0\x11\x03\0\0.\0\x03\0\r\0\0\0\x13\x03\0\0!\0\x04\0;\x03\0\0\x03\0\0\0\x04\0\0\0!\0\x06\0M\x03\0\0\x13\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0+\0\x04\0\x07\0\0\0b\x03\0\0\x0C\0\0\0!\0\x04\0s\x03\0\0\x04\0\0\0\x08\0\0\0!\0\x04\0~\x03\0\0\x08\0\0\0\x04\0\0\0!\0\x05\0\x93\x03\0\0\x04\0\0\0\x04\0\0\0\x08\0\0\0!\0\x06\0\x9F\x03\0\0\x08\0\0\0\x04\0\0\0\x04\0\0\0\x03\0\0\0.\0\x03\0\r\0\0\0\xA2\x03\0\0!\0\x05\0\xE2\x03\0\0\x08\0\0\0\x04\0\0\0\x07\0\0\0.\0\x03\0\r\0\0\0\xE4\x03\0\0.\0\x03\0\r\0\0\0\xE6\x03\0\0!\0\x07\0\x03\x04\0\0\x08\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x07\0\0\0,\0\x05\0\x08\0\0\0\x05\x04\0\0 \0\0\0}\0\0\0,\0\x07\0\x04\0\0\0\x06\x04\0\0}\0\0\0}\0\0\0}\0\0\0}\0\0\0+\0\x04\0\x03\0\0\0\x07\x04\0\0\0\0\x80\xBD,\0\x07\0\x04\0\0\0\x08\x04\0\0\x07\x04\0\0\x07\x04\0\0$\0\0\0$\0\0\0 \0\x04\0\n\x04\0\0\x07\0\0\0\x08\0\0\0.\0\x03\0\x08\0\0\0\x0B\x04\0\0 \0\x04\0\r\x04\0\0\x07\0\0\0\x04\0\0\0+\0\x04\0\x03\0\0\0a\x04\0\0\0\0@@,\0\x05\0\x08\0\0\0b\x04\0\0a\x04\0\0a\x04\0\0+\0\x04\0\x03\0\0\0c\x04\0\0\0\0@>.\0\x03\0\x08\0\0\0e\x04\0\0!\0\x06\0\xC2\x04\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0,\0\x07\0\x04\0\0\0\xC4\x04\0\0 \0\0\0 \0\0\0 \0\0\0 \0\0\0.\0\x03\0\r\0\0\0\xC6\x04\0\0\x17\0\x04\0\xCC\x04\0\0\r\0\0\0\x04\0\0\0+\0\x04\0\x03\0\0\0\xF9\x04\0\0\xCA\xF2I\xF1,\0\x07\0\x04\0\0\0\xFA\x04\0\0\x1D\0\0\0\x1D\0\0\0\xF9\x04\0\0\xF9\x04\0\0,\0\x07\0\x04\0\0\0\xFB\x04\0\0c\x02\0\0c\x02\0\0 \0\0\0 \0\0\0 \0\x04\0\xFE\x04\0\0\x07\0\0\0\x07\0\0\0.\0\x03\0\r\0\0\0\0\x05\0\0 \0\x04\x000\x05\0\0\x07\0\0\0\x03\0\0\0!\0\x07\0V\x05\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x04\0\0\0\x07\0\0\0.\0\x03\0\r\0\0\0Y\x05\0\0.\0\x03\0\r\0\0\0[\x05\0\0.\0\x03\0\r\0\0\0]\x05\0\0 \0\x04\0\x81\x05\0\0\x01\0\0\0\x07\0\0\0;\0\x04\0\x81\x05\0\0\x80\x05\0\0\x01\0\0\0 \0\x04\0\x84\x05\0\0\x01\0\0\0\x04\0\0\0;\0\x04\0\x84\x05\0\0\x83\x05\0\0\x01\0\0\0;\0\x04\0\x84\x05\0\0\x86\x05\0\0\x01\0\0\0;\0\x04\0\x84\x05\0\0\x88\x05\0\0\x01\0\0\0 \0\x04\0\x8B\x05\0\0\x03\0\0\0\x04\0\0\0;\0\x04\0\x8B\x05\0\0\x8A\x05\0\0\x03\0\0\0;\0\x04\0\x8B\x05\0\0\x8C\x05\0\0\x03\0\0\0;\0\x04\0\x8B\x05\0\0\x8D\x05\0\0\x03\0\0\0;\0\x04\0\x8B\x05\0\0\x8E\x05\0\0\x03\0\0\0;\0\x04\0\x8B\x05\0\0\x8F\x05\0\0\x03\0\0\0!\0\x03\0\x91\x05\0\0\x02\0\0\0+\0\x04\0\x03\0\0\0\x96\x05\0\0r\xF9\x7F>.\0\x03\0\r\0\0\0\x98\x05\0\0.\0\x03\0\r\0\0\0\x9A\x05\0\0;\0\x04\0\x84\x05\0\0\xCA\x05\0\0\x01\0\0\0;\0\x04\0\x84\x05\0\0\xCC\x05\0\0\x01\0\0\0;\0\x04\0\x84\x05\0\0\xCE\x05\0\0\x01\0\0\0;\0\x04\0\x84\x05\0\0\xD0\x05\0\0\x01\0\0\0;\0\x04\0\x84\x05\0\0\xD2\x05\0\0\x01\0\0\0 \0\x04\0\xD5\x05\0\0\x03\0\0\0\x03\0\0\0;\0\x04\0\xD5\x05\0\0\xD4\x05\0\0\x03\0\0\x006\0\x05\0\x03\0\0\x006\0\0\0\0\0\0\x007\0\0\x007\0\x03\0\x05\0\0\x004\0\0\x007\0\x03\0\x03\0\0\x005\0\0\0\xF8\0\x02\x003\0\0\0\xF9\0\x02\08\0\0\0\xF8\0\x02\08\0\0\0Q\0\x05\0\x04\0\0\09\0\0\x004\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0:\0\0\09\0\0\0\0\0\0\0\xBC\0\x05\0\r\0\0\0;\0\0\x005\0\0\0:\0\0\0\xF7\0\x03\0<\0\0\0\0\0\0\0\xFA\0\x04\0;\0\0\0=\0\0\0<\0\0\0\xF8\0\x02\0=\0\0\0Q\0\x05\0\x04\0\0\0>\0\0\x004\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0?\0\0\0>\0\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\0@\0\0\x004\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0A\0\0\0@\0\0\0\x02\0\0\0\x85\0\x05\0\x03\0\0\0B\0\0\0A\0\0\x005\0\0\0\x81\0\x05\0\x03\0\0\0C\0\0\0?\0\0\0B\0\0\0\xFE\0\x02\0C\0\0\0\xF8\0\x02\0<\0\0\0Q\0\x05\0\x04\0\0\0D\0\0\x004\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0E\0\0\0D\0\0\0\0\0\0\0Q\0\x05\0\x04\0\0\0F\0\0\x004\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0G\0\0\0F\0\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\0H\0\0\x004\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0I\0\0\0H\0\0\0\x02\0\0\0\x85\0\x05\0\x03\0\0\0J\0\0\x005\0\0\0I\0\0\0\x0C\0\x06\0\x03\0\0\0K\0\0\0\x01\0\0\0\x1C\0\0\0J\0\0\0\x85\0\x05\0\x03\0\0\0L\0\0\0G\0\0\0K\0\0\0\x81\0\x05\0\x03\0\0\0M\0\0\0E\0\0\0L\0\0\0\xFE\0\x02\0M\0\0\08\0\x01\x006\0\x05\0\x03\0\0\0Q\0\0\0\0\0\0\x007\0\0\x007\0\x03\0\x05\0\0\0O\0\0\x007\0\x03\0\x03\0\0\0P\0\0\0\xF8\0\x02\0N\0\0\0\xF9\0\x02\0R\0\0\0\xF8\0\x02\0R\0\0\0Q\0\x05\0\x04\0\0\0S\0\0\0O\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0T\0\0\0S\0\0\0\0\0\0\0\xBC\0\x05\0\r\0\0\0U\0\0\0P\0\0\0T\0\0\0\xF7\0\x03\0V\0\0\0\0\0\0\0\xFA\0\x04\0U\0\0\0W\0\0\0V\0\0\0\xF8\0\x02\0W\0\0\0Q\0\x05\0\x04\0\0\0X\0\0\0O\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0Y\0\0\0X\0\0\0\x02\0\0\0\xFE\0\x02\0Y\0\0\0\xF8\0\x02\0V\0\0\0Q\0\x05\0\x04\0\0\0Z\0\0\0O\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0[\0\0\0Z\0\0\0\x01\0\0\0\x88\0\x05\0\x03\0\0\0\\\0\0\0[\0\0\0P\0\0\0\xFE\0\x02\0\\\0\0\08\0\x01\x006\0\x05\0\x03\0\0\0`\0\0\0\0\0\0\x007\0\0\x007\0\x03\0\x05\0\0\0^\0\0\x007\0\x03\0\x03\0\0\0_\0\0\0\xF8\0\x02\0]\0\0\0\xF9\0\x02\0a\0\0\0\xF8\0\x02\0a\0\0\0Q\0\x05\0\x04\0\0\0b\0\0\0^\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0c\0\0\0b\0\0\0\x01\0\0\0\x83\0\x05\0\x03\0\0\0d\0\0\0_\0\0\0c\0\0\0Q\0\x05\0\x04\0\0\0e\0\0\0^\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0f\0\0\0e\0\0\0\x02\0\0\0\x88\0\x05\0\x03\0\0\0g\0\0\0d\0\0\0f\0\0\0Q\0\x05\0\x04\0\0\0h\0\0\0^\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0i\0\0\0h\0\0\0\0\0\0\0\xBC\0\x05\0\r\0\0\0j\0\0\0g\0\0\0i\0\0\0\xF7\0\x03\0k\0\0\0\0\0\0\0\xFA\0\x04\0j\0\0\0l\0\0\0k\0\0\0\xF8\0\x02\0l\0\0\0\xFE\0\x02\0g\0\0\0\xF8\0\x02\0k\0\0\0Q\0\x05\0\x04\0\0\0m\0\0\0^\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0n\0\0\0m\0\0\0\0\0\0\0\x83\0\x05\0\x03\0\0\0o\0\0\0_\0\0\0n\0\0\0Q\0\x05\0\x04\0\0\0p\0\0\0^\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0q\0\0\0p\0\0\0\x01\0\0\0\x88\0\x05\0\x03\0\0\0r\0\0\0o\0\0\0q\0\0\0\x0C\0\x06\0\x03\0\0\0s\0\0\0\x01\0\0\0\x1B\0\0\0r\0\0\0Q\0\x05\0\x04\0\0\0t\0\0\0^\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0u\0\0\0t\0\0\0\x02\0\0\0\x88\0\x05\0\x03\0\0\0v\0\0\0s\0\0\0u\0\0\0\xFE\0\x02\0v\0\0\08\0\x01\x006\0\x05\0\r\0\0\0{\0\0\0\0\0\0\0|\0\0\x007\0\x03\0\x0E\0\0\0x\0\0\x007\0\x03\0\x03\0\0\0y\0\0\x007\0\x03\0\x03\0\0\0z\0\0\0\xF8\0\x02\0w\0\0\0\xF9\0\x02\0~\0\0\0\xF8\0\x02\0~\0\0\0Q\0\x05\0\r\0\0\0\x7F\0\0\0x\0\0\0\x03\0\0\0Q\0\x05\0\r\0\0\0\x80\0\0\0x\0\0\0\x02\0\0\0\x85\0\x05\0\x03\0\0\0\x81\0\0\0z\0\0\0y\0\0\0\xB8\0\x05\0\r\0\0\0\x82\0\0\0\x81\0\0\0}\0\0\0\xA9\0\x06\0\r\0\0\0\x83\0\0\0\x82\0\0\0\x80\0\0\0\x7F\0\0\0\xFE\0\x02\0\x83\0\0\08\0\x01\x006\0\x05\0\x03\0\0\0\x85\0\0\0\0\0\0\0\x86\0\0\0\xF8\0\x02\0\x84\0\0\0A\0\x05\0\x87\0\0\0\x89\0\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\x8A\0\0\0\xF8\0\x02\0\x8A\0\0\0A\0\x05\0\x8B\0\0\0\x8D\0\0\0\x89\0\0\0\x8C\0\0\0=\0\x04\0\x05\0\0\0\x8E\0\0\0\x8D\0\0\0A\0\x06\0\x90\0\0\0\x93\0\0\0\x89\0\0\0\x92\0\0\0\x91\0\0\0=\0\x04\0\x03\0\0\0\x94\0\0\0\x93\0\0\09\0\x06\0\x03\0\0\0\x95\0\0\0Q\0\0\0\x8E\0\0\0\x94\0\0\0\x0C\0\x06\0\x03\0\0\0\x96\0\0\0\x01\0\0\0\x06\0\0\0\x95\0\0\0\xFE\0\x02\0\x96\0\0\08\0\x01\x006\0\x05\0\r\0\0\0\x98\0\0\0\0\0\0\0\x99\0\0\0\xF8\0\x02\0\x97\0\0\0A\0\x05\0\x87\0\0\0\x9A\0\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\x9B\0\0\0\xF8\0\x02\0\x9B\0\0\0A\0\x07\0\x90\0\0\0\x9C\0\0\0\x9A\0\0\0\x8C\0\0\0\x91\0\0\0\x88\0\0\0=\0\x04\0\x03\0\0\0\x9D\0\0\0\x9C\0\0\0\xB8\0\x05\0\r\0\0\0\x9E\0\0\0\x9D\0\0\0\x18\0\0\0\xFE\0\x02\0\x9E\0\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xA2\0\0\0\0\0\0\0\xA3\0\0\x007\0\x03\0\x03\0\0\0\xA0\0\0\x007\0\x03\0\x03\0\0\0\xA1\0\0\0\xF8\0\x02\0\x9F\0\0\0A\0\x05\0\x87\0\0\0\xA4\0\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\xA6\0\0\0\xF8\0\x02\0\xA6\0\0\0A\0\x07\0\x90\0\0\0\xA7\0\0\0\xA4\0\0\0\x8C\0\0\0\x91\0\0\0\x88\0\0\0=\0\x04\0\x03\0\0\0\xA8\0\0\0\xA7\0\0\0\xBC\0\x05\0\r\0\0\0\xA9\0\0\0\xA1\0\0\0\xA8\0\0\0\xF7\0\x03\0\xAA\0\0\0\0\0\0\0\xFA\0\x04\0\xA9\0\0\0\xAB\0\0\0\xAA\0\0\0\xF8\0\x02\0\xAB\0\0\0\xFE\0\x02\0}\0\0\0\xF8\0\x02\0\xAA\0\0\0\x83\0\x05\0\x03\0\0\0\xAC\0\0\0\xA1\0\0\0\xA0\0\0\0\x0C\0\x07\0\x03\0\0\0\xAD\0\0\0\x01\0\0\0(\0\0\0\xA0\0\0\0\xA8\0\0\0\x88\0\x05\0\x03\0\0\0\xAE\0\0\0\xAC\0\0\0\xAD\0\0\0\x85\0\x05\0\x03\0\0\0\xAF\0\0\0\xA5\0\0\0\xAE\0\0\0\x85\0\x05\0\x03\0\0\0\xB0\0\0\0\xAF\0\0\0\xAE\0\0\0A\0\x05\0\x8B\0\0\0\xB1\0\0\0\xA4\0\0\0\x8C\0\0\0=\0\x04\0\x05\0\0\0\xB2\0\0\0\xB1\0\0\09\0\x06\0\x03\0\0\0\xB3\0\0\0Q\0\0\0\xB2\0\0\0\xA1\0\0\0\x85\0\x05\0\x03\0\0\0\xB4\0\0\0\xB3\0\0\0\xA1\0\0\0\x0C\0\x06\0\x03\0\0\0\xB5\0\0\0\x01\0\0\0\x04\0\0\0\xB4\0\0\0\x85\0\x05\0\x03\0\0\0\xB6\0\0\0\xB0\0\0\0\xB5\0\0\0\xFE\0\x02\0\xB6\0\0\08\0\x01\x006\0\x05\0\x0E\0\0\0\xBA\0\0\0\0\0\0\0\xBB\0\0\x007\0\x03\0\x03\0\0\0\xB8\0\0\x007\0\x03\0\x03\0\0\0\xB9\0\0\0\xF8\0\x02\0\xB7\0\0\0A\0\x05\0\x87\0\0\0\xBC\0\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\xBD\0\0\0\xF8\0\x02\0\xBD\0\0\0A\0\x05\0\x8B\0\0\0\xBE\0\0\0\xBC\0\0\0\x8C\0\0\0=\0\x04\0\x05\0\0\0\xBF\0\0\0\xBE\0\0\09\0\x06\0\x03\0\0\0\xC0\0\0\0Q\0\0\0\xBF\0\0\0\xB8\0\0\0A\0\x05\0\x8B\0\0\0\xC1\0\0\0\xBC\0\0\0\x8C\0\0\0=\0\x04\0\x05\0\0\0\xC2\0\0\0\xC1\0\0\09\0\x06\0\x03\0\0\0\xC3\0\0\0Q\0\0\0\xC2\0\0\0\xB9\0\0\0\x0C\0\x07\0\x03\0\0\0\xC4\0\0\0\x01\0\0\0%\0\0\0\xC0\0\0\0\xC3\0\0\0\x0C\0\x07\0\x03\0\0\0\xC5\0\0\0\x01\0\0\0(\0\0\0\xC0\0\0\0\xC3\0\0\0\xBA\0\x05\0\r\0\0\0\xC6\0\0\0\xC0\0\0\0\xC3\0\0\0\xB8\0\x05\0\r\0\0\0\xC7\0\0\0\xC0\0\0\0\xC3\0\0\0P\0\x07\0\x0E\0\0\0\xC8\0\0\0\xC4\0\0\0\xC5\0\0\0\xC6\0\0\0\xC7\0\0\0\xFE\0\x02\0\xC8\0\0\08\0\x01\x006\0\x05\0\x07\0\0\0\xCB\0\0\0\0\0\0\0\xCC\0\0\x007\0\x03\0\x07\0\0\0\xCA\0\0\0\xF8\0\x02\0\xC9\0\0\0A\0\x05\0\xCD\0\0\0\xCE\0\0\0*\0\0\0\x88\0\0\0A\0\x05\0\xCF\0\0\0\xD0\0\0\x000\0\0\0\x88\0\0\0\xF9\0\x02\0\xD2\0\0\0\xF8\0\x02\0\xD2\0\0\0A\0\x06\0\xD4\0\0\0\xD5\0\0\0\xCE\0\0\0\x88\0\0\0\x06\0\0\0=\0\x04\0\x07\0\0\0\xD6\0\0\0\xD5\0\0\0\x80\0\x05\0\x07\0\0\0\xD7\0\0\0\xD6\0\0\0\xCA\0\0\0A\0\x06\0\xD4\0\0\0\xD9\0\0\0\xCE\0\0\0\x88\0\0\0\xD8\0\0\0=\0\x04\0\x07\0\0\0\xDA\0\0\0\xD9\0\0\0\xF7\0\x03\0\xDB\0\0\0\0\0\0\0\xFB\0\x07\0\xDA\0\0\0\xDE\0\0\0\0\0\0\0\xDC\0\0\0\x01\0\0\0\xDD\0\0\0\xF8\0\x02\0\xDC\0\0\0\xFE\0\x02\0\xCA\0\0\0\xF8\0\x02\0\xDD\0\0\0\x86\0\x05\0\x07\0\0\0\xDF\0\0\0\xD7\0\0\0\x06\0\0\0A\0\x05\0\xE0\0\0\0\xE1\0\0\0\xD0\0\0\0\xDF\0\0\0=\0\x04\0\x07\0\0\0\xE2\0\0\0\xE1\0\0\0\x89\0\x05\0\x07\0\0\0\xE3\0\0\0\xD7\0\0\0\x06\0\0\0\x84\0\x05\0\x07\0\0\0\xE4\0\0\0\xD1\0\0\0\xE3\0\0\0\x0C\0\x07\0\x07\0\0\0\xE7\0\0\0\x01\0\0\0&\0\0\0\xE4\0\0\0\xE6\0\0\0\x82\0\x05\0\x07\0\0\0\xE8\0\0\0\xE6\0\0\0\xE7\0\0\0\x0C\0\x07\0\x07\0\0\0\xE9\0\0\0\x01\0\0\0&\0\0\0\xD1\0\0\0\xE8\0\0\0\xCB\0\x06\0\x07\0\0\0\xE5\0\0\0\xE2\0\0\0\xE7\0\0\0\xE9\0\0\0\xFE\0\x02\0\xE5\0\0\0\xF8\0\x02\0\xDE\0\0\0A\0\x05\0\xE0\0\0\0\xEA\0\0\0\xD0\0\0\0\xD7\0\0\0=\0\x04\0\x07\0\0\0\xEB\0\0\0\xEA\0\0\0\xFE\0\x02\0\xEB\0\0\0\xF8\0\x02\0\xDB\0\0\0\xFE\0\x02\0\xEC\0\0\08\0\x01\x006\0\x05\0\x08\0\0\0\xEF\0\0\0\0\0\0\0\xF0\0\0\x007\0\x03\0\x07\0\0\0\xEE\0\0\0\xF8\0\x02\0\xED\0\0\0\xF9\0\x02\0\xFA\0\0\0\xF8\0\x02\0\xFA\0\0\0\xC7\0\x05\0\x07\0\0\0\xFB\0\0\0\xEE\0\0\0\xF1\0\0\0\xC2\0\x05\0\x07\0\0\0\xFC\0\0\0\xEE\0\0\0\xD1\0\0\0P\0\x05\0\x10\0\0\0\xFD\0\0\0\xFB\0\0\0\xFC\0\0\0\xC7\0\x05\0\x10\0\0\0\xFE\0\0\0\xFD\0\0\0\xF3\0\0\0\xC4\0\x05\0\x10\0\0\0\xFF\0\0\0\xFE\0\0\0\xF5\0\0\0\x80\0\x05\0\x10\0\0\0\0\x01\0\0\xFF\0\0\0\xF7\0\0\0|\0\x04\0\x08\0\0\0\x01\x01\0\0\0\x01\0\0p\0\x04\0\x08\0\0\0\x02\x01\0\0\xFE\0\0\0\x8E\0\x05\0\x08\0\0\0\x03\x01\0\0\x02\x01\0\0\x19\0\0\0\xB0\0\x05\0\x04\x01\0\0\x05\x01\0\0\xFE\0\0\0\xF9\0\0\0\xA9\0\x06\0\x08\0\0\0\x06\x01\0\0\x05\x01\0\0\x03\x01\0\0\x01\x01\0\0\x7F\0\x04\0\x08\0\0\0\x07\x01\0\0\x06\x01\0\0\xAC\0\x05\0\x04\x01\0\0\x08\x01\0\0\xFD\0\0\0\xF3\0\0\0\xA9\0\x06\0\x08\0\0\0\t\x01\0\0\x08\x01\0\0\x07\x01\0\0\x06\x01\0\0\xFE\0\x02\0\t\x01\0\08\0\x01\x006\0\x05\0\x12\0\0\0\r\x01\0\0\0\0\0\0\x0E\x01\0\x007\0\x03\0\x11\0\0\0\x0B\x01\0\x007\0\x03\0\x07\0\0\0\x0C\x01\0\0\xF8\0\x02\0\n\x01\0\0\xF9\0\x02\0\x16\x01\0\0\xF8\0\x02\0\x16\x01\0\0\xF7\0\x03\0\x17\x01\0\0\0\0\0\0\xFB\0\x0F\0\x0C\x01\0\0\x1E\x01\0\0\0\0\0\0\x18\x01\0\0\x01\0\0\0\x19\x01\0\0\x02\0\0\0\x1A\x01\0\0\x03\0\0\0\x1B\x01\0\0\x04\0\0\0\x1C\x01\0\0\x05\0\0\0\x1D\x01\0\0\xF8\0\x02\0\x18\x01\0\0|\0\x04\0\x12\0\0\0\x1F\x01\0\0\x0B\x01\0\0\xFE\0\x02\0\x1F\x01\0\0\xF8\0\x02\0\x19\x01\0\0Q\0\x05\0\x07\0\0\0 \x01\0\0\x0B\x01\0\0\0\0\0\09\0\x05\0\x08\0\0\0!\x01\0\0\xEF\0\0\0 \x01\0\0Q\0\x05\0\x07\0\0\0\"\x01\0\0\x0B\x01\0\0\x01\0\0\09\0\x05\0\x08\0\0\0#\x01\0\0\xEF\0\0\0\"\x01\0\0Q\0\x05\0\x03\0\0\0$\x01\0\0#\x01\0\0\0\0\0\0P\0\x05\0\x12\0\0\0%\x01\0\0!\x01\0\0$\x01\0\0\xFE\0\x02\0%\x01\0\0\xF8\0\x02\0\x1A\x01\0\0Q\0\x05\0\x07\0\0\0&\x01\0\0\x0B\x01\0\0\0\0\0\0\x0C\0\x06\0\x08\0\0\0'\x01\0\0\x01\0\0\0<\0\0\0&\x01\0\0Q\0\x05\0\x07\0\0\0(\x01\0\0\x0B\x01\0\0\x01\0\0\0\x0C\0\x06\0\x08\0\0\0)\x01\0\0\x01\0\0\0<\0\0\0(\x01\0\0Q\0\x05\0\x03\0\0\0*\x01\0\0)\x01\0\0\0\0\0\0P\0\x05\0\x12\0\0\0+\x01\0\0'\x01\0\0*\x01\0\0\xFE\0\x02\0+\x01\0\0\xF8\0\x02\0\x1B\x01\0\0Q\0\x05\0\x07\0\0\0,\x01\0\0\x0B\x01\0\0\0\0\0\0\x0C\0\x06\0\x08\0\0\0-\x01\0\0\x01\0\0\0=\0\0\0,\x01\0\0Q\0\x05\0\x07\0\0\0.\x01\0\0\x0B\x01\0\0\x01\0\0\0\x0C\0\x06\0\x08\0\0\0/\x01\0\0\x01\0\0\0=\0\0\0.\x01\0\0Q\0\x05\0\x03\0\0\x000\x01\0\0/\x01\0\0\0\0\0\0P\0\x05\0\x12\0\0\x001\x01\0\0-\x01\0\x000\x01\0\0\xFE\0\x02\x001\x01\0\0\xF8\0\x02\0\x1C\x01\0\0Q\0\x05\0\x07\0\0\x002\x01\0\0\x0B\x01\0\0\0\0\0\0\x0C\0\x06\0\x04\0\0\x003\x01\0\0\x01\0\0\0?\0\0\x002\x01\0\0O\0\x08\0\x12\0\0\x004\x01\0\x003\x01\0\x003\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\xFE\0\x02\x004\x01\0\0\xF8\0\x02\0\x1D\x01\0\0Q\0\x05\0\x07\0\0\x005\x01\0\0\x0B\x01\0\0\0\0\0\0\x0C\0\x06\0\x04\0\0\x006\x01\0\0\x01\0\0\0@\0\0\x005\x01\0\0O\0\x08\0\x12\0\0\x007\x01\0\x006\x01\0\x006\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\xFE\0\x02\x007\x01\0\0\xF8\0\x02\0\x1E\x01\0\0Q\0\x05\0\x07\0\0\08\x01\0\0\x0B\x01\0\0\0\0\0\0P\0\x06\0\x11\0\0\09\x01\0\08\x01\0\08\x01\0\08\x01\0\0\xC2\0\x05\0\x11\0\0\0:\x01\0\09\x01\0\0\x11\x01\0\0\xC7\0\x05\0\x11\0\0\0;\x01\0\0:\x01\0\0\x13\x01\0\0p\0\x04\0\x12\0\0\0<\x01\0\0;\x01\0\0\x88\0\x05\0\x12\0\0\0=\x01\0\0<\x01\0\0\x15\x01\0\0\xFE\0\x02\0=\x01\0\0\xF8\0\x02\0\x17\x01\0\0\xFE\0\x02\0>\x01\0\08\0\x01\x006\0\x05\0\x04\0\0\0B\x01\0\0\0\0\0\0C\x01\0\x007\0\x03\0\x0F\0\0\0@\x01\0\x007\0\x03\0\x07\0\0\0A\x01\0\0\xF8\0\x02\0?\x01\0\0A\0\x05\0\xCD\0\0\0D\x01\0\0*\0\0\0\x88\0\0\0A\0\x05\0\xCF\0\0\0E\x01\0\0-\0\0\0\x88\0\0\0A\0\x05\0\xCF\0\0\0F\x01\0\x000\0\0\0\x88\0\0\0\xF9\0\x02\0G\x01\0\0\xF8\0\x02\0G\x01\0\0A\0\x06\0\xD4\0\0\0H\x01\0\0D\x01\0\0\x88\0\0\0\x88\0\0\0=\0\x04\0\x07\0\0\0I\x01\0\0H\x01\0\09\0\x05\0\x07\0\0\0J\x01\0\0\xCB\0\0\0A\x01\0\0A\0\x06\0\xD4\0\0\0K\x01\0\0D\x01\0\0\x88\0\0\0\x91\0\0\0=\0\x04\0\x07\0\0\0L\x01\0\0K\x01\0\0\x84\0\x05\0\x07\0\0\0M\x01\0\0J\x01\0\0L\x01\0\0\x80\0\x05\0\x07\0\0\0N\x01\0\0I\x01\0\0M\x01\0\0A\0\x05\0\xE0\0\0\0O\x01\0\0E\x01\0\0N\x01\0\0=\0\x04\0\x07\0\0\0P\x01\0\0O\x01\0\0\x80\0\x05\0\x07\0\0\0Q\x01\0\0N\x01\0\0\x91\0\0\0A\0\x05\0\xE0\0\0\0R\x01\0\0E\x01\0\0Q\x01\0\0=\0\x04\0\x07\0\0\0S\x01\0\0R\x01\0\0\x80\0\x05\0\x07\0\0\0T\x01\0\0N\x01\0\0\x06\0\0\0A\0\x05\0\xE0\0\0\0U\x01\0\0E\x01\0\0T\x01\0\0=\0\x04\0\x07\0\0\0V\x01\0\0U\x01\0\0P\0\x06\0\x11\0\0\0W\x01\0\0P\x01\0\0S\x01\0\0V\x01\0\0A\0\x06\0\xD4\0\0\0X\x01\0\0D\x01\0\0\x91\0\0\0\x88\0\0\0=\0\x04\0\x07\0\0\0Y\x01\0\0X\x01\0\09\0\x06\0\x12\0\0\0Z\x01\0\0\r\x01\0\0W\x01\0\0Y\x01\0\0P\0\x05\0\x04\0\0\0[\x01\0\0Z\x01\0\0 \0\0\0Q\0\x05\0\x04\0\0\0\\\x01\0\0@\x01\0\0\x01\0\0\0\x94\0\x05\0\x03\0\0\0]\x01\0\0\\\x01\0\0[\x01\0\0Q\0\x05\0\x04\0\0\0^\x01\0\0@\x01\0\0\x02\0\0\0\x94\0\x05\0\x03\0\0\0_\x01\0\0^\x01\0\0[\x01\0\0Q\0\x05\0\x04\0\0\0`\x01\0\0@\x01\0\0\x03\0\0\0\x94\0\x05\0\x03\0\0\0a\x01\0\0`\x01\0\0[\x01\0\0P\0\x07\0\x04\0\0\0b\x01\0\0]\x01\0\0_\x01\0\0a\x01\0\0 \0\0\0\xFE\0\x02\0b\x01\0\08\0\x01\x006\0\x05\0\x04\0\0\0e\x01\0\0\0\0\0\0f\x01\0\x007\0\x03\0\x04\0\0\0d\x01\0\0\xF8\0\x02\0c\x01\0\0A\0\x05\0\x87\0\0\0g\x01\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0h\x01\0\0\xF8\0\x02\0h\x01\0\0A\0\x05\0\x8F\0\0\0i\x01\0\0g\x01\0\0\x88\0\0\0=\0\x04\0\x04\0\0\0j\x01\0\0i\x01\0\0\x94\0\x05\0\x03\0\0\0k\x01\0\0j\x01\0\0d\x01\0\0A\0\x05\0\x8F\0\0\0l\x01\0\0g\x01\0\0\x91\0\0\0=\0\x04\0\x04\0\0\0m\x01\0\0l\x01\0\0\x94\0\x05\0\x03\0\0\0n\x01\0\0m\x01\0\0d\x01\0\0A\0\x05\0\x8F\0\0\0o\x01\0\0g\x01\0\0\x06\0\0\0=\0\x04\0\x04\0\0\0p\x01\0\0o\x01\0\0\x94\0\x05\0\x03\0\0\0q\x01\0\0p\x01\0\0d\x01\0\0A\0\x05\0\x8F\0\0\0r\x01\0\0g\x01\0\0\xD8\0\0\0=\0\x04\0\x04\0\0\0s\x01\0\0r\x01\0\0\x94\0\x05\0\x03\0\0\0t\x01\0\0s\x01\0\0d\x01\0\0P\0\x07\0\x04\0\0\0u\x01\0\0k\x01\0\0n\x01\0\0q\x01\0\0t\x01\0\0\xFE\0\x02\0u\x01\0\08\0\x01\x006\0\x05\0\r\0\0\0x\x01\0\0\0\0\0\0y\x01\0\x007\0\x03\0\x04\0\0\0w\x01\0\0\xF8\0\x02\0v\x01\0\0;\0\x05\0}\x01\0\0|\x01\0\0\x07\0\0\0~\x01\0\0;\0\x05\0}\x01\0\0\x7F\x01\0\0\x07\0\0\0\x80\x01\0\0;\0\x05\0}\x01\0\0\x81\x01\0\0\x07\0\0\0\x82\x01\0\0A\0\x05\0\x87\0\0\0z\x01\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\x83\x01\0\0\xF8\0\x02\0\x83\x01\0\0A\0\x06\0\x90\0\0\0\x84\x01\0\0z\x01\0\0\x92\0\0\0\x88\0\0\0=\0\x04\0\x03\0\0\0\x85\x01\0\0\x84\x01\0\0A\0\x06\0\x90\0\0\0\x86\x01\0\0z\x01\0\0\x92\0\0\0\x88\0\0\0=\0\x04\0\x03\0\0\0\x87\x01\0\0\x86\x01\0\0\x85\0\x05\0\x03\0\0\0\x88\x01\0\0\x16\0\0\0\x87\x01\0\0\x0C\0\x07\0\x03\0\0\0\x89\x01\0\0\x01\0\0\0%\0\0\0\x85\x01\0\0\x88\x01\0\0A\0\x06\0\x90\0\0\0\x8A\x01\0\0z\x01\0\0\x92\0\0\0\x91\0\0\0=\0\x04\0\x03\0\0\0\x8B\x01\0\0\x8A\x01\0\0\x85\0\x05\0\x03\0\0\0\x8C\x01\0\0\x1B\0\0\0\x8B\x01\0\0Q\0\x05\0\x03\0\0\0\x8D\x01\0\0w\x01\0\0\0\0\0\0\x0C\0\x06\0\x03\0\0\0\x8E\x01\0\0\x01\0\0\0\x04\0\0\0\x8D\x01\0\0Q\0\x05\0\x03\0\0\0\x8F\x01\0\0w\x01\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\x90\x01\0\0\x1A\0\0\0\x8F\x01\0\0\xBC\0\x05\0\r\0\0\0\x91\x01\0\0\x8E\x01\0\0\x90\x01\0\0Q\0\x05\0\x03\0\0\0\x92\x01\0\0w\x01\0\0\x03\0\0\0\xBA\0\x05\0\r\0\0\0\x93\x01\0\0\x92\x01\0\0}\0\0\0\xF7\0\x03\0\x94\x01\0\0\0\0\0\0\xFA\0\x04\0\x93\x01\0\0\x95\x01\0\0\x96\x01\0\0\xF8\0\x02\0\x95\x01\0\0>\0\x03\0|\x01\0\0\x91\x01\0\0\xF9\0\x02\0\x94\x01\0\0\xF8\0\x02\0\x96\x01\0\0>\0\x03\0|\x01\0\0{\x01\0\0\xF9\0\x02\0\x94\x01\0\0\xF8\0\x02\0\x94\x01\0\0=\0\x04\0\r\0\0\0\x97\x01\0\0|\x01\0\0\xF7\0\x03\0\x98\x01\0\0\0\0\0\0\xFA\0\x04\0\x97\x01\0\0\x99\x01\0\0\x9A\x01\0\0\xF8\0\x02\0\x99\x01\0\0Q\0\x05\0\x03\0\0\0\x9B\x01\0\0w\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\x9C\x01\0\0w\x01\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\x9D\x01\0\0\x89\x01\0\0\x9C\x01\0\0\xBE\0\x05\0\r\0\0\0\x9E\x01\0\0\x9B\x01\0\0\x9D\x01\0\0>\0\x03\0\x7F\x01\0\0\x9E\x01\0\0\xF9\0\x02\0\x98\x01\0\0\xF8\0\x02\0\x9A\x01\0\0>\0\x03\0\x7F\x01\0\0{\x01\0\0\xF9\0\x02\0\x98\x01\0\0\xF8\0\x02\0\x98\x01\0\0=\0\x04\0\r\0\0\0\x9F\x01\0\0\x7F\x01\0\0\xF7\0\x03\0\xA0\x01\0\0\0\0\0\0\xFA\0\x04\0\x9F\x01\0\0\xA1\x01\0\0\xA2\x01\0\0\xF8\0\x02\0\xA1\x01\0\0Q\0\x05\0\x03\0\0\0\xA3\x01\0\0w\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xA4\x01\0\0w\x01\0\0\x03\0\0\0\x85\0\x05\0\x03\0\0\0\xA5\x01\0\0\x8C\x01\0\0\xA4\x01\0\0\xBC\0\x05\0\r\0\0\0\xA6\x01\0\0\xA3\x01\0\0\xA5\x01\0\0>\0\x03\0\x81\x01\0\0\xA6\x01\0\0\xF9\0\x02\0\xA0\x01\0\0\xF8\0\x02\0\xA2\x01\0\0>\0\x03\0\x81\x01\0\0{\x01\0\0\xF9\0\x02\0\xA0\x01\0\0\xF8\0\x02\0\xA0\x01\0\0=\0\x04\0\r\0\0\0\xA7\x01\0\0\x81\x01\0\0\xFE\0\x02\0\xA7\x01\0\08\0\x01\x006\0\x05\0\r\0\0\0\xAC\x01\0\0\0\0\0\0\xAD\x01\0\x007\0\x03\0\x04\0\0\0\xA9\x01\0\x007\0\x03\0\x04\0\0\0\xAA\x01\0\x007\0\x03\0\x04\0\0\0\xAB\x01\0\0\xF8\0\x02\0\xA8\x01\0\0;\0\x05\0}\x01\0\0\xB3\x01\0\0\x07\0\0\0\xB4\x01\0\0;\0\x05\0}\x01\0\0\xB7\x01\0\0\x07\0\0\0\xB8\x01\0\0;\0\x05\0}\x01\0\0\xB1\x01\0\0\x07\0\0\0\xB2\x01\0\0;\0\x05\0}\x01\0\0\xB5\x01\0\0\x07\0\0\0\xB6\x01\0\0A\0\x05\0\x87\0\0\0\xAE\x01\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\xB9\x01\0\0\xF8\0\x02\0\xB9\x01\0\0Q\0\x05\0\x03\0\0\0\xBA\x01\0\0\xA9\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xBB\x01\0\0\xAA\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xBC\x01\0\0\xAB\x01\0\0\0\0\0\0P\0\x06\0\x12\0\0\0\xBD\x01\0\0\xBA\x01\0\0\xBB\x01\0\0\xBC\x01\0\0Q\0\x05\0\x03\0\0\0\xBE\x01\0\0\xA9\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xBF\x01\0\0\xAA\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xC0\x01\0\0\xAB\x01\0\0\x01\0\0\0P\0\x06\0\x12\0\0\0\xC1\x01\0\0\xBE\x01\0\0\xBF\x01\0\0\xC0\x01\0\0Q\0\x05\0\x03\0\0\0\xC2\x01\0\0\xA9\x01\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\xC3\x01\0\0\xAA\x01\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\xC4\x01\0\0\xAB\x01\0\0\x03\0\0\0P\0\x06\0\x12\0\0\0\xC5\x01\0\0\xC2\x01\0\0\xC3\x01\0\0\xC4\x01\0\0\xBA\0\x05\0\xC6\x01\0\0\xC7\x01\0\0\xBD\x01\0\0\xC5\x01\0\0\x9B\0\x04\0\r\0\0\0\xC8\x01\0\0\xC7\x01\0\0\xA8\0\x04\0\r\0\0\0\xC9\x01\0\0\xC8\x01\0\0\xF7\0\x03\0\xCA\x01\0\0\0\0\0\0\xFA\0\x04\0\xC9\x01\0\0\xCB\x01\0\0\xCC\x01\0\0\xF8\0\x02\0\xCB\x01\0\0\x7F\0\x04\0\x12\0\0\0\xCD\x01\0\0\xC5\x01\0\0\xB8\0\x05\0\xC6\x01\0\0\xCE\x01\0\0\xBD\x01\0\0\xCD\x01\0\0\x9B\0\x04\0\r\0\0\0\xCF\x01\0\0\xCE\x01\0\0>\0\x03\0\xB1\x01\0\0\xCF\x01\0\0\xF9\0\x02\0\xCA\x01\0\0\xF8\0\x02\0\xCC\x01\0\0>\0\x03\0\xB1\x01\0\0\xAF\x01\0\0\xF9\0\x02\0\xCA\x01\0\0\xF8\0\x02\0\xCA\x01\0\0=\0\x04\0\r\0\0\0\xD0\x01\0\0\xB1\x01\0\0A\0\x06\0\x90\0\0\0\xD1\x01\0\0\xAE\x01\0\0\x92\0\0\0\x91\0\0\0=\0\x04\0\x03\0\0\0\xD2\x01\0\0\xD1\x01\0\0\x8E\0\x05\0\x12\0\0\0\xD3\x01\0\0\xC5\x01\0\0\xD2\x01\0\0\xBA\0\x05\0\xC6\x01\0\0\xD4\x01\0\0\xC1\x01\0\0\xD3\x01\0\0\x9B\0\x04\0\r\0\0\0\xD5\x01\0\0\xD4\x01\0\0\xA8\0\x04\0\r\0\0\0\xD6\x01\0\0\xD5\x01\0\0\xF7\0\x03\0\xD7\x01\0\0\0\0\0\0\xFA\0\x04\0\xD6\x01\0\0\xD8\x01\0\0\xD9\x01\0\0\xF8\0\x02\0\xD8\x01\0\0A\0\x06\0\x90\0\0\0\xDA\x01\0\0\xAE\x01\0\0\x92\0\0\0\x88\0\0\0=\0\x04\0\x03\0\0\0\xDB\x01\0\0\xDA\x01\0\0\x8E\0\x05\0\x12\0\0\0\xDC\x01\0\0\xC5\x01\0\0\xDB\x01\0\0\xB8\0\x05\0\xC6\x01\0\0\xDD\x01\0\0\xC1\x01\0\0\xDC\x01\0\0\x9B\0\x04\0\r\0\0\0\xDE\x01\0\0\xDD\x01\0\0>\0\x03\0\xB3\x01\0\0\xDE\x01\0\0\xF9\0\x02\0\xD7\x01\0\0\xF8\0\x02\0\xD9\x01\0\0>\0\x03\0\xB3\x01\0\0\xAF\x01\0\0\xF9\0\x02\0\xD7\x01\0\0\xF8\0\x02\0\xD7\x01\0\0=\0\x04\0\r\0\0\0\xDF\x01\0\0\xB3\x01\0\0\xA8\0\x04\0\r\0\0\0\xE0\x01\0\0\xD0\x01\0\0\xF7\0\x03\0\xE1\x01\0\0\0\0\0\0\xFA\0\x04\0\xE0\x01\0\0\xE2\x01\0\0\xE3\x01\0\0\xF8\0\x02\0\xE2\x01\0\0>\0\x03\0\xB5\x01\0\0\xDF\x01\0\0\xF9\0\x02\0\xE1\x01\0\0\xF8\0\x02\0\xE3\x01\0\0>\0\x03\0\xB5\x01\0\0\xAF\x01\0\0\xF9\0\x02\0\xE1\x01\0\0\xF8\0\x02\0\xE1\x01\0\0=\0\x04\0\r\0\0\0\xE4\x01\0\0\xB5\x01\0\0\xA8\0\x04\0\r\0\0\0\xE5\x01\0\0\xE4\x01\0\0\xF7\0\x03\0\xE6\x01\0\0\0\0\0\0\xFA\0\x04\0\xE5\x01\0\0\xE7\x01\0\0\xE8\x01\0\0\xF8\0\x02\0\xE7\x01\0\0\xBC\0\x05\0\xC6\x01\0\0\xE9\x01\0\0\xC5\x01\0\0\xB0\x01\0\0\x9B\0\x04\0\r\0\0\0\xEA\x01\0\0\xE9\x01\0\0>\0\x03\0\xB7\x01\0\0\xEA\x01\0\0\xF9\0\x02\0\xE6\x01\0\0\xF8\0\x02\0\xE8\x01\0\0>\0\x03\0\xB7\x01\0\0\xAF\x01\0\0\xF9\0\x02\0\xE6\x01\0\0\xF8\0\x02\0\xE6\x01\0\0=\0\x04\0\r\0\0\0\xEB\x01\0\0\xB7\x01\0\0\xFE\0\x02\0\xEB\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xEF\x01\0\0\0\0\0\0\xF0\x01\0\x007\0\x03\0\x04\0\0\0\xED\x01\0\x007\0\x03\0\x04\0\0\0\xEE\x01\0\0\xF8\0\x02\0\xEC\x01\0\0;\0\x05\0}\x01\0\0\xF2\x01\0\0\x07\0\0\0\xF3\x01\0\0A\0\x05\0\x87\0\0\0\xF1\x01\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\xF4\x01\0\0\xF8\0\x02\0\xF4\x01\0\09\0\x05\0\r\0\0\0\xF5\x01\0\0x\x01\0\0\xED\x01\0\0\xF7\0\x03\0\xF6\x01\0\0\0\0\0\0\xFA\0\x04\0\xF5\x01\0\0\xF7\x01\0\0\xF8\x01\0\0\xF8\0\x02\0\xF7\x01\0\09\0\x05\0\r\0\0\0\xF9\x01\0\0x\x01\0\0\xEE\x01\0\0>\0\x03\0\xF2\x01\0\0\xF9\x01\0\0\xF9\0\x02\0\xF6\x01\0\0\xF8\0\x02\0\xF8\x01\0\0>\0\x03\0\xF2\x01\0\0{\x01\0\0\xF9\0\x02\0\xF6\x01\0\0\xF8\0\x02\0\xF6\x01\0\0=\0\x04\0\r\0\0\0\xFA\x01\0\0\xF2\x01\0\0\xA8\0\x04\0\r\0\0\0\xFB\x01\0\0\xFA\x01\0\0\xF7\0\x03\0\xFC\x01\0\0\0\0\0\0\xFA\0\x04\0\xFB\x01\0\0\xFD\x01\0\0\xFC\x01\0\0\xF8\0\x02\0\xFD\x01\0\0\xFE\0\x02\0\x1D\0\0\0\xF8\0\x02\0\xFC\x01\0\0Q\0\x05\0\x03\0\0\0\xFE\x01\0\0\xED\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xFF\x01\0\0\xED\x01\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\0\x02\0\0\xFE\x01\0\0\xFF\x01\0\0Q\0\x05\0\x03\0\0\0\x01\x02\0\0\xEE\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\x02\x02\0\0\xEE\x01\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\x03\x02\0\0\x01\x02\0\0\x02\x02\0\0A\0\x06\0\x90\0\0\0\x06\x02\0\0\xF1\x01\0\0\x05\x02\0\0\x91\0\0\0=\0\x04\0\x03\0\0\0\x07\x02\0\0\x06\x02\0\0\x85\0\x05\0\x03\0\0\0\x08\x02\0\0\x1F\0\0\0\x07\x02\0\0\x0C\0\x07\0\x03\0\0\0\t\x02\0\0\x01\0\0\0%\0\0\0\0\x02\0\0\x03\x02\0\0\x0C\0\x07\0\x03\0\0\0\n\x02\0\0\x01\0\0\0(\0\0\0\0\x02\0\0\x03\x02\0\09\0\x06\0\x03\0\0\0\x0B\x02\0\0\xA2\0\0\0\t\x02\0\0\n\x02\0\0\x85\0\x05\0\x03\0\0\0\x0C\x02\0\0\x08\x02\0\0\x0B\x02\0\0\xFE\0\x02\0\x0C\x02\0\08\0\x01\x006\0\x05\0\x03\0\0\0\x11\x02\0\0\0\0\0\0\x12\x02\0\x007\0\x03\0\x04\0\0\0\x0E\x02\0\x007\0\x03\0\x04\0\0\0\x0F\x02\0\x007\0\x03\0\x04\0\0\0\x10\x02\0\0\xF8\0\x02\0\r\x02\0\0A\0\x05\0\x87\0\0\0\x13\x02\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\x14\x02\0\0\xF8\0\x02\0\x14\x02\0\09\0\x06\0\x03\0\0\0\x15\x02\0\0\xEF\x01\0\0\x0E\x02\0\0\x0F\x02\0\09\0\x06\0\x03\0\0\0\x16\x02\0\0\xEF\x01\0\0\x0F\x02\0\0\x10\x02\0\09\0\x06\0\x03\0\0\0\x17\x02\0\0\xEF\x01\0\0\x10\x02\0\0\x0E\x02\0\0\x0C\0\x07\0\x03\0\0\0\x18\x02\0\0\x01\0\0\0(\0\0\0\x16\x02\0\0\x17\x02\0\0\x0C\0\x07\0\x03\0\0\0\x19\x02\0\0\x01\0\0\0(\0\0\0\x15\x02\0\0\x18\x02\0\0\xFE\0\x02\0\x19\x02\0\08\0\x01\x006\0\x05\0\x03\0\0\0\x1D\x02\0\0\0\0\0\0\x1E\x02\0\x007\0\x03\0\x08\0\0\0\x1B\x02\0\x007\0\x03\0\x08\0\0\0\x1C\x02\0\0\xF8\0\x02\0\x1A\x02\0\0;\0\x05\0}\x01\0\0\x1F\x02\0\0\x07\0\0\0 \x02\0\0;\0\x05\0}\x01\0\0!\x02\0\0\x07\0\0\0\"\x02\0\0\xF9\0\x02\0#\x02\0\0\xF8\0\x02\0#\x02\0\0Q\0\x05\0\x03\0\0\0$\x02\0\0\x1B\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0%\x02\0\0\x1C\x02\0\0\0\0\0\0\xBA\0\x05\0\r\0\0\0&\x02\0\0$\x02\0\0%\x02\0\0\xA8\0\x04\0\r\0\0\0'\x02\0\0&\x02\0\0\xF7\0\x03\0(\x02\0\0\0\0\0\0\xFA\0\x04\0'\x02\0\0)\x02\0\0*\x02\0\0\xF8\0\x02\0)\x02\0\0Q\0\x05\0\x03\0\0\0+\x02\0\0\x1B\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0,\x02\0\0\x1C\x02\0\0\0\0\0\0\xB4\0\x05\0\r\0\0\0-\x02\0\0+\x02\0\0,\x02\0\0\xF7\0\x03\0.\x02\0\0\0\0\0\0\xFA\0\x04\0-\x02\0\0/\x02\0\x000\x02\0\0\xF8\0\x02\0/\x02\0\0Q\0\x05\0\x03\0\0\x001\x02\0\0\x1B\x02\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\x002\x02\0\0\x1C\x02\0\0\x01\0\0\0\xBA\0\x05\0\r\0\0\x003\x02\0\x001\x02\0\x002\x02\0\0>\0\x03\0!\x02\0\x003\x02\0\0\xF9\0\x02\0.\x02\0\0\xF8\0\x02\x000\x02\0\0>\0\x03\0!\x02\0\0{\x01\0\0\xF9\0\x02\0.\x02\0\0\xF8\0\x02\0.\x02\0\0=\0\x04\0\r\0\0\x004\x02\0\0!\x02\0\0>\0\x03\0\x1F\x02\0\x004\x02\0\0\xF9\0\x02\0(\x02\0\0\xF8\0\x02\0*\x02\0\0>\0\x03\0\x1F\x02\0\0\xAF\x01\0\0\xF9\0\x02\0(\x02\0\0\xF8\0\x02\0(\x02\0\0=\0\x04\0\r\0\0\x005\x02\0\0\x1F\x02\0\0P\0\x05\0\x04\x01\0\x007\x02\0\x005\x02\0\x005\x02\0\0\xA9\0\x06\0\x08\0\0\x006\x02\0\x007\x02\0\0\x1C\x02\0\0\x1B\x02\0\0P\0\x05\0\x04\x01\0\09\x02\0\x005\x02\0\x005\x02\0\0\xA9\0\x06\0\x08\0\0\08\x02\0\09\x02\0\0\x1B\x02\0\0\x1C\x02\0\0Q\0\x05\0\x03\0\0\0:\x02\0\x006\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0;\x02\0\08\x02\0\0\x01\0\0\0\x85\0\x05\0\x03\0\0\0<\x02\0\0:\x02\0\0;\x02\0\0Q\0\x05\0\x03\0\0\0=\x02\0\08\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0>\x02\0\x006\x02\0\0\x01\0\0\0\x85\0\x05\0\x03\0\0\0?\x02\0\0=\x02\0\0>\x02\0\0\x83\0\x05\0\x03\0\0\0@\x02\0\0<\x02\0\0?\x02\0\0\x7F\0\x04\0\x03\0\0\0A\x02\0\0@\x02\0\0\xA9\0\x06\0\x03\0\0\0B\x02\0\x005\x02\0\0A\x02\0\0@\x02\0\0\xFE\0\x02\0B\x02\0\08\0\x01\x006\0\x05\0\x12\0\0\0H\x02\0\0\0\0\0\0I\x02\0\x007\0\x03\0\x04\0\0\0D\x02\0\x007\0\x03\0\x04\0\0\0E\x02\0\x007\0\x03\0\x04\0\0\0F\x02\0\x007\0\x03\0\x08\0\0\0G\x02\0\0\xF8\0\x02\0C\x02\0\0\xF9\0\x02\0J\x02\0\0\xF8\0\x02\0J\x02\0\0O\0\x07\0\x08\0\0\0K\x02\0\0D\x02\0\0D\x02\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0L\x02\0\0D\x02\0\0\x03\0\0\0\x8E\0\x05\0\x08\0\0\0M\x02\0\0G\x02\0\0L\x02\0\0\x83\0\x05\0\x08\0\0\0N\x02\0\0K\x02\0\0M\x02\0\0O\0\x07\0\x08\0\0\0O\x02\0\0E\x02\0\0E\x02\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0P\x02\0\0E\x02\0\0\x03\0\0\0\x8E\0\x05\0\x08\0\0\0Q\x02\0\0G\x02\0\0P\x02\0\0\x83\0\x05\0\x08\0\0\0R\x02\0\0O\x02\0\0Q\x02\0\0O\0\x07\0\x08\0\0\0S\x02\0\0F\x02\0\0F\x02\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0T\x02\0\0F\x02\0\0\x03\0\0\0\x8E\0\x05\0\x08\0\0\0U\x02\0\0G\x02\0\0T\x02\0\0\x83\0\x05\0\x08\0\0\0V\x02\0\0S\x02\0\0U\x02\0\09\0\x06\0\x03\0\0\0W\x02\0\0\x1D\x02\0\0R\x02\0\0V\x02\0\09\0\x06\0\x03\0\0\0X\x02\0\0\x1D\x02\0\0V\x02\0\0N\x02\0\09\0\x06\0\x03\0\0\0Y\x02\0\0\x1D\x02\0\0N\x02\0\0R\x02\0\0P\0\x06\0\x12\0\0\0Z\x02\0\0W\x02\0\0X\x02\0\0Y\x02\0\0\xFE\0\x02\0Z\x02\0\08\0\x01\x006\0\x05\0\x04\0\0\0^\x02\0\0\0\0\0\0_\x02\0\x007\0\x03\0\x13\0\0\0\\\x02\0\x007\0\x03\0\x08\0\0\0]\x02\0\0\xF8\0\x02\0[\x02\0\0;\0\x05\0}\x01\0\0d\x02\0\0\x07\0\0\0e\x02\0\0A\0\x05\0\x87\0\0\0`\x02\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0f\x02\0\0\xF8\0\x02\0f\x02\0\0A\0\x05\0\x04\x02\0\0g\x02\0\0`\x02\0\0\x05\x02\0\0=\0\x04\0\x08\0\0\0h\x02\0\0g\x02\0\0\x8E\0\x05\0\x08\0\0\0i\x02\0\0h\x02\0\0\x1F\0\0\0A\0\x05\0\x8F\0\0\0j\x02\0\0`\x02\0\0\x92\0\0\0=\0\x04\0\x04\0\0\0k\x02\0\0j\x02\0\0O\0\x07\0\x08\0\0\0l\x02\0\0k\x02\0\0k\x02\0\0\x02\0\0\0\x03\0\0\0\x83\0\x05\0\x08\0\0\0m\x02\0\0]\x02\0\0l\x02\0\0\x83\0\x05\0\x08\0\0\0n\x02\0\0m\x02\0\0i\x02\0\0\x88\0\x05\0\x08\0\0\0o\x02\0\0n\x02\0\0i\x02\0\0Q\0\x05\0\x03\0\0\0p\x02\0\0o\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0q\x02\0\0o\x02\0\0\x01\0\0\0\x7F\0\x04\0\x03\0\0\0r\x02\0\0q\x02\0\0P\0\x05\0\x08\0\0\0s\x02\0\0p\x02\0\0r\x02\0\0Q\0\x05\0\x03\0\0\0t\x02\0\0s\x02\0\0\0\0\0\0A\0\x05\0\x8B\0\0\0u\x02\0\0`\x02\0\0\x8C\0\0\0=\0\x04\0\x05\0\0\0v\x02\0\0u\x02\0\0Q\0\x05\0\x03\0\0\0w\x02\0\0s\x02\0\0\x01\0\0\09\0\x06\0\x03\0\0\0x\x02\0\0`\0\0\0v\x02\0\0w\x02\0\0P\0\x05\0\x08\0\0\0y\x02\0\0t\x02\0\0x\x02\0\0Q\0\x05\0\x04\0\0\0z\x02\0\0\\\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0{\x02\0\0z\x02\0\0\x03\0\0\0Q\0\x05\0\x04\0\0\0|\x02\0\0\\\x02\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0}\x02\0\0|\x02\0\0\x03\0\0\0Q\0\x05\0\x04\0\0\0~\x02\0\0\\\x02\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\x7F\x02\0\0~\x02\0\0\x03\0\0\0P\0\x06\0\x12\0\0\0\x80\x02\0\0{\x02\0\0}\x02\0\0\x7F\x02\0\0Q\0\x05\0\x04\0\0\0\x81\x02\0\0\\\x02\0\0\0\0\0\0Q\0\x05\0\x04\0\0\0\x82\x02\0\0\\\x02\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\0\x83\x02\0\0\\\x02\0\0\x02\0\0\09\0\x08\0\x12\0\0\0\x84\x02\0\0H\x02\0\0\x81\x02\0\0\x82\x02\0\0\x83\x02\0\0y\x02\0\0\x94\0\x05\0\x03\0\0\0\x85\x02\0\0\x84\x02\0\0\x80\x02\0\0\x0C\0\x06\0\x03\0\0\0\x86\x02\0\0\x01\0\0\0\x06\0\0\0\x85\x02\0\0\x8E\0\x05\0\x12\0\0\0\x87\x02\0\0\x84\x02\0\0\x86\x02\0\0Q\0\x05\0\x04\0\0\0\x88\x02\0\0\\\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\x89\x02\0\0\x88\x02\0\0\0\0\0\0Q\0\x05\0\x04\0\0\0\x8A\x02\0\0\\\x02\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\x8B\x02\0\0\x8A\x02\0\0\0\0\0\0Q\0\x05\0\x04\0\0\0\x8C\x02\0\0\\\x02\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\x8D\x02\0\0\x8C\x02\0\0\0\0\0\0P\0\x06\0\x12\0\0\0\x8E\x02\0\0\x89\x02\0\0\x8B\x02\0\0\x8D\x02\0\0\x88\0\x05\0\x12\0\0\0\x8F\x02\0\0\x8E\x02\0\0\x80\x02\0\0Q\0\x05\0\x03\0\0\0\x90\x02\0\0\x8F\x02\0\0\0\0\0\0Q\0\x05\0\x04\0\0\0\x91\x02\0\0\\\x02\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\x92\x02\0\0\x91\x02\0\0\0\0\0\0P\0\x05\0\x08\0\0\0\x93\x02\0\0\x90\x02\0\0\x92\x02\0\0\x83\0\x05\0\x08\0\0\0\x94\x02\0\0\x93\x02\0\0s\x02\0\0\x85\0\x05\0\x08\0\0\0\x95\x02\0\0\x94\x02\0\0i\x02\0\0Q\0\x05\0\x03\0\0\0\x96\x02\0\0\x8F\x02\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\0\x97\x02\0\0\\\x02\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\x98\x02\0\0\x97\x02\0\0\x01\0\0\0P\0\x05\0\x08\0\0\0\x99\x02\0\0\x96\x02\0\0\x98\x02\0\0\x83\0\x05\0\x08\0\0\0\x9A\x02\0\0\x99\x02\0\0s\x02\0\0\x85\0\x05\0\x08\0\0\0\x9B\x02\0\0\x9A\x02\0\0i\x02\0\0Q\0\x05\0\x03\0\0\0\x9C\x02\0\0\x8F\x02\0\0\x02\0\0\0Q\0\x05\0\x04\0\0\0\x9D\x02\0\0\\\x02\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\x9E\x02\0\0\x9D\x02\0\0\x02\0\0\0P\0\x05\0\x08\0\0\0\x9F\x02\0\0\x9C\x02\0\0\x9E\x02\0\0\x83\0\x05\0\x08\0\0\0\xA0\x02\0\0\x9F\x02\0\0s\x02\0\0\x85\0\x05\0\x08\0\0\0\xA1\x02\0\0\xA0\x02\0\0i\x02\0\0\x0C\0\x07\0\x03\0\0\0\xA2\x02\0\0\x01\0\0\0C\0\0\0\x9B\x02\0\0\xA1\x02\0\0\x0C\0\x07\0\x03\0\0\0\xA3\x02\0\0\x01\0\0\0C\0\0\0\xA1\x02\0\0\x95\x02\0\0\x0C\0\x07\0\x03\0\0\0\xA4\x02\0\0\x01\0\0\0C\0\0\0\x95\x02\0\0\x9B\x02\0\0P\0\x06\0\x12\0\0\0\xA5\x02\0\0\xA2\x02\0\0\xA3\x02\0\0\xA4\x02\0\09\0\x06\0\x03\0\0\0\xA6\x02\0\0\x1D\x02\0\0\x9B\x02\0\0\xA1\x02\0\09\0\x06\0\x03\0\0\0\xA7\x02\0\0\x1D\x02\0\0\xA1\x02\0\0\x95\x02\0\09\0\x06\0\x03\0\0\0\xA8\x02\0\0\x1D\x02\0\0\x95\x02\0\0\x9B\x02\0\0P\0\x06\0\x12\0\0\0\xA9\x02\0\0\xA6\x02\0\0\xA7\x02\0\0\xA8\x02\0\0\x8E\0\x05\0\x12\0\0\0\xAA\x02\0\0\xA9\x02\0\0\x86\x02\0\09\0\x04\0\x03\0\0\0\xAB\x02\0\0\x85\0\0\0\x8E\0\x05\0\x12\0\0\0\xAC\x02\0\0\xAA\x02\0\0\xAB\x02\0\0\x8E\0\x05\0\x12\0\0\0\xAD\x02\0\0\xA5\x02\0\0\x17\0\0\0\x81\0\x05\0\x12\0\0\0\xAE\x02\0\0\xAC\x02\0\0\xAD\x02\0\0Q\0\x05\0\x04\0\0\0\xAF\x02\0\0\\\x02\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\xB0\x02\0\0\xAF\x02\0\0\x03\0\0\0\x0C\0\x08\0\x03\0\0\0\xB2\x02\0\0\x01\0\0\0+\0\0\0\xB0\x02\0\0}\0\0\0\xB1\x02\0\0m\0\x04\0\x07\0\0\0\xB3\x02\0\0\xB2\x02\0\0P\0\x06\0\x11\0\0\0\xB4\x02\0\0\xB3\x02\0\0\xB3\x02\0\0\xB3\x02\0\0\xC7\0\x05\0\x11\0\0\0\xB5\x02\0\0\xB4\x02\0\0a\x02\0\0\xAB\0\x05\0\xC6\x01\0\0\xB6\x02\0\0\xB5\x02\0\0b\x02\0\0\xA9\0\x06\0\x12\0\0\0\xB7\x02\0\0\xB6\x02\0\0\xAE\x02\0\0\x87\x02\0\0\x0C\0\x07\0\x12\0\0\0\xB8\x02\0\0\x01\0\0\0(\0\0\0\x87\x02\0\0\xB0\x01\0\0\xBE\0\x05\0\xC6\x01\0\0\xB9\x02\0\0\xB7\x02\0\0\xB0\x01\0\0\x9B\0\x04\0\r\0\0\0\xBA\x02\0\0\xB9\x02\0\0\xF7\0\x03\0\xBB\x02\0\0\0\0\0\0\xFA\0\x04\0\xBA\x02\0\0\xBC\x02\0\0\xBD\x02\0\0\xF8\0\x02\0\xBC\x02\0\0\x94\0\x05\0\x03\0\0\0\xBE\x02\0\0\xB8\x02\0\0\x80\x02\0\0\xBA\0\x05\0\r\0\0\0\xBF\x02\0\0\xBE\x02\0\0}\0\0\0>\0\x03\0d\x02\0\0\xBF\x02\0\0\xF9\0\x02\0\xBB\x02\0\0\xF8\0\x02\0\xBD\x02\0\0>\0\x03\0d\x02\0\0{\x01\0\0\xF9\0\x02\0\xBB\x02\0\0\xF8\0\x02\0\xBB\x02\0\0=\0\x04\0\r\0\0\0\xC0\x02\0\0d\x02\0\0Q\0\x05\0\x03\0\0\0\xC1\x02\0\0\xB8\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xC2\x02\0\0\xB8\x02\0\0\x01\0\0\0\x81\0\x05\0\x03\0\0\0\xC3\x02\0\0\xC1\x02\0\0\xC2\x02\0\0Q\0\x05\0\x03\0\0\0\xC4\x02\0\0\xB8\x02\0\0\x02\0\0\0\x81\0\x05\0\x03\0\0\0\xC5\x02\0\0\xC3\x02\0\0\xC4\x02\0\0\x0C\0\x07\0\x03\0\0\0\xC6\x02\0\0\x01\0\0\0(\0\0\0\xC5\x02\0\0\"\0\0\0P\0\x06\0\x12\0\0\0\xC7\x02\0\0\xC6\x02\0\0\xC6\x02\0\0\xC6\x02\0\0\x88\0\x05\0\x12\0\0\0\xC8\x02\0\0\xB8\x02\0\0\xC7\x02\0\0\xA9\0\x06\0\x03\0\0\0\xC9\x02\0\0\xC0\x02\0\0 \0\0\0c\x02\0\0P\0\x05\0\x04\0\0\0\xCA\x02\0\0\xC8\x02\0\0\xC9\x02\0\0\xFE\0\x02\0\xCA\x02\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xCE\x02\0\0\0\0\0\0\xCF\x02\0\x007\0\x03\0\x13\0\0\0\xCC\x02\0\x007\0\x03\0\x12\0\0\0\xCD\x02\0\0\xF8\0\x02\0\xCB\x02\0\0\xF9\0\x02\0\xD0\x02\0\0\xF8\0\x02\0\xD0\x02\0\0Q\0\x05\0\x04\0\0\0\xD1\x02\0\0\xCC\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xD2\x02\0\0\xD1\x02\0\0\x02\0\0\0Q\0\x05\0\x04\0\0\0\xD3\x02\0\0\xCC\x02\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xD4\x02\0\0\xD3\x02\0\0\x02\0\0\0Q\0\x05\0\x04\0\0\0\xD5\x02\0\0\xCC\x02\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\xD6\x02\0\0\xD5\x02\0\0\x02\0\0\0P\0\x06\0\x12\0\0\0\xD7\x02\0\0\xD2\x02\0\0\xD4\x02\0\0\xD6\x02\0\0\x94\0\x05\0\x03\0\0\0\xD8\x02\0\0\xCD\x02\0\0\xD7\x02\0\0Q\0\x05\0\x04\0\0\0\xD9\x02\0\0\xCC\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xDA\x02\0\0\xD9\x02\0\0\x03\0\0\0Q\0\x05\0\x04\0\0\0\xDB\x02\0\0\xCC\x02\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xDC\x02\0\0\xDB\x02\0\0\x03\0\0\0Q\0\x05\0\x04\0\0\0\xDD\x02\0\0\xCC\x02\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\xDE\x02\0\0\xDD\x02\0\0\x03\0\0\0P\0\x06\0\x12\0\0\0\xDF\x02\0\0\xDA\x02\0\0\xDC\x02\0\0\xDE\x02\0\0\x94\0\x05\0\x03\0\0\0\xE0\x02\0\0\xCD\x02\0\0\xDF\x02\0\0\x88\0\x05\0\x03\0\0\0\xE1\x02\0\0\xD8\x02\0\0\xE0\x02\0\0\x0C\0\x08\0\x03\0\0\0\xE2\x02\0\0\x01\0\0\0+\0\0\0\xE1\x02\0\0}\0\0\0 \0\0\0\xFE\0\x02\0\xE2\x02\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xE7\x02\0\0\0\0\0\0\x12\x02\0\x007\0\x03\0\x04\0\0\0\xE4\x02\0\x007\0\x03\0\x04\0\0\0\xE5\x02\0\x007\0\x03\0\x04\0\0\0\xE6\x02\0\0\xF8\0\x02\0\xE3\x02\0\0A\0\x05\0\x87\0\0\0\xE8\x02\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\xE9\x02\0\0\xF8\0\x02\0\xE9\x02\0\0O\0\x07\0\x08\0\0\0\xEA\x02\0\0\xE4\x02\0\0\xE4\x02\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xEB\x02\0\0\xE4\x02\0\0\x03\0\0\0P\0\x05\0\x08\0\0\0\xEC\x02\0\0\xEB\x02\0\0\xEB\x02\0\0\x88\0\x05\0\x08\0\0\0\xED\x02\0\0\xEA\x02\0\0\xEC\x02\0\0O\0\x07\0\x08\0\0\0\xEE\x02\0\0\xE5\x02\0\0\xE5\x02\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xEF\x02\0\0\xE5\x02\0\0\x03\0\0\0P\0\x05\0\x08\0\0\0\xF0\x02\0\0\xEF\x02\0\0\xEF\x02\0\0\x88\0\x05\0\x08\0\0\0\xF1\x02\0\0\xEE\x02\0\0\xF0\x02\0\0\x83\0\x05\0\x08\0\0\0\xF2\x02\0\0\xF1\x02\0\0\xED\x02\0\0O\0\x07\0\x08\0\0\0\xF3\x02\0\0\xE6\x02\0\0\xE6\x02\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xF4\x02\0\0\xE6\x02\0\0\x03\0\0\0P\0\x05\0\x08\0\0\0\xF5\x02\0\0\xF4\x02\0\0\xF4\x02\0\0\x88\0\x05\0\x08\0\0\0\xF6\x02\0\0\xF3\x02\0\0\xF5\x02\0\0\x83\0\x05\0\x08\0\0\0\xF7\x02\0\0\xF6\x02\0\0\xED\x02\0\0Q\0\x05\0\x03\0\0\0\xF8\x02\0\0\xF2\x02\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xF9\x02\0\0\xF7\x02\0\0\x01\0\0\0\x85\0\x05\0\x03\0\0\0\xFA\x02\0\0\xF8\x02\0\0\xF9\x02\0\0Q\0\x05\0\x03\0\0\0\xFB\x02\0\0\xF2\x02\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xFC\x02\0\0\xF7\x02\0\0\0\0\0\0\x85\0\x05\0\x03\0\0\0\xFD\x02\0\0\xFB\x02\0\0\xFC\x02\0\0\x83\0\x05\0\x03\0\0\0\xFE\x02\0\0\xFA\x02\0\0\xFD\x02\0\0\x0C\0\x06\0\x03\0\0\0\xFF\x02\0\0\x01\0\0\0\x06\0\0\0\xFE\x02\0\09\0\x04\0\x03\0\0\0\0\x03\0\0\x85\0\0\0\x85\0\x05\0\x03\0\0\0\x01\x03\0\0\xFF\x02\0\0\0\x03\0\0\x0C\0\x06\0\x03\0\0\0\x02\x03\0\0\x01\0\0\0\x04\0\0\0\xFE\x02\0\0\x0C\0\x06\0\x03\0\0\0\x03\x03\0\0\x01\0\0\0\x04\0\0\0\xFA\x02\0\0\x0C\0\x06\0\x03\0\0\0\x04\x03\0\0\x01\0\0\0\x04\0\0\0\xFD\x02\0\0\x81\0\x05\0\x03\0\0\0\x05\x03\0\0\x03\x03\0\0\x04\x03\0\0\x85\0\x05\0\x03\0\0\0\x06\x03\0\0#\0\0\0\x05\x03\0\0\xBA\0\x05\0\r\0\0\0\x07\x03\0\0\x02\x03\0\0\x06\x03\0\0\xA9\0\x06\0\x03\0\0\0\x08\x03\0\0\x07\x03\0\0\x01\x03\0\0}\0\0\0\xFE\0\x02\0\x08\x03\0\08\0\x01\x006\0\x05\0\r\0\0\0\r\x03\0\0\0\0\0\0\x0E\x03\0\x007\0\x03\0\x04\0\0\0\n\x03\0\x007\0\x03\0\x04\0\0\0\x0B\x03\0\x007\0\x03\0\x03\0\0\0\x0C\x03\0\0\xF8\0\x02\0\t\x03\0\0;\0\x05\0}\x01\0\0\x10\x03\0\0\x07\0\0\0\x11\x03\0\0;\0\x05\0}\x01\0\0\x12\x03\0\0\x07\0\0\0\x13\x03\0\0A\0\x05\0\x87\0\0\0\x0F\x03\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\x14\x03\0\0\xF8\0\x02\0\x14\x03\0\09\0\x06\0\x03\0\0\0\x15\x03\0\0\xEF\x01\0\0\n\x03\0\0\x0B\x03\0\0\xBA\0\x05\0\r\0\0\0\x16\x03\0\0\x15\x03\0\0\x16\0\0\0\xA8\0\x04\0\r\0\0\0\x17\x03\0\0\x16\x03\0\0\xF7\0\x03\0\x18\x03\0\0\0\0\0\0\xFA\0\x04\0\x17\x03\0\0\x19\x03\0\0\x1A\x03\0\0\xF8\0\x02\0\x19\x03\0\09\0\x04\0\r\0\0\0\x1B\x03\0\0\x98\0\0\0\xA8\0\x04\0\r\0\0\0\x1C\x03\0\0\x1B\x03\0\0>\0\x03\0\x10\x03\0\0\x1C\x03\0\0\xF9\0\x02\0\x18\x03\0\0\xF8\0\x02\0\x1A\x03\0\0>\0\x03\0\x10\x03\0\0\xAF\x01\0\0\xF9\0\x02\0\x18\x03\0\0\xF8\0\x02\0\x18\x03\0\0=\0\x04\0\r\0\0\0\x1D\x03\0\0\x10\x03\0\0\xF7\0\x03\0\x1E\x03\0\0\0\0\0\0\xFA\0\x04\0\x1D\x03\0\0\x1F\x03\0\0\x1E\x03\0\0\xF8\0\x02\0\x1F\x03\0\0\xFE\0\x02\0{\x01\0\0\xF8\0\x02\0\x1E\x03\0\0Q\0\x05\0\x03\0\0\0 \x03\0\0\n\x03\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0!\x03\0\0\n\x03\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\"\x03\0\0 \x03\0\0!\x03\0\0Q\0\x05\0\x03\0\0\0#\x03\0\0\x0B\x03\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0$\x03\0\0\x0B\x03\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0%\x03\0\0#\x03\0\0$\x03\0\0\x0C\0\x07\0\x03\0\0\0&\x03\0\0\x01\0\0\0%\0\0\0\"\x03\0\0%\x03\0\0\x0C\0\x07\0\x03\0\0\0'\x03\0\0\x01\0\0\0(\0\0\0\"\x03\0\0%\x03\0\09\0\x06\0\x0E\0\0\0(\x03\0\0\xBA\0\0\0&\x03\0\0'\x03\0\0\xBC\0\x05\0\r\0\0\0)\x03\0\0\x15\x03\0\0\x17\0\0\0\xA8\0\x04\0\r\0\0\0*\x03\0\0)\x03\0\0\xF7\0\x03\0+\x03\0\0\0\0\0\0\xFA\0\x04\0*\x03\0\0,\x03\0\0-\x03\0\0\xF8\0\x02\0,\x03\0\0Q\0\x05\0\x03\0\0\0.\x03\0\0\x0B\x03\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0/\x03\0\0\x0B\x03\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\x000\x03\0\0.\x03\0\0/\x03\0\0Q\0\x05\0\x03\0\0\x001\x03\0\0\n\x03\0\0\0\0\0\0Q\0\x05\0\x03\0\0\x002\x03\0\0\n\x03\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\x003\x03\0\x001\x03\0\x002\x03\0\0\x83\0\x05\0\x03\0\0\x004\x03\0\x000\x03\0\x003\x03\0\09\0\x07\0\r\0\0\x005\x03\0\0{\0\0\0(\x03\0\x004\x03\0\0\x0C\x03\0\0\xA8\0\x04\0\r\0\0\x006\x03\0\x005\x03\0\0>\0\x03\0\x12\x03\0\x006\x03\0\0\xF9\0\x02\0+\x03\0\0\xF8\0\x02\0-\x03\0\0>\0\x03\0\x12\x03\0\0\xAF\x01\0\0\xF9\0\x02\0+\x03\0\0\xF8\0\x02\0+\x03\0\0=\0\x04\0\r\0\0\x007\x03\0\0\x12\x03\0\0\xFE\0\x02\x007\x03\0\08\0\x01\x006\0\x05\0\x03\0\0\0:\x03\0\0\0\0\0\0;\x03\0\x007\0\x03\0\x04\0\0\09\x03\0\0\xF8\0\x02\08\x03\0\0A\0\x05\0\x87\0\0\0<\x03\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0=\x03\0\0\xF8\0\x02\0=\x03\0\09\0\x05\0\r\0\0\0>\x03\0\0x\x01\0\09\x03\0\0\xA8\0\x04\0\r\0\0\0?\x03\0\0>\x03\0\0\xF7\0\x03\0@\x03\0\0\0\0\0\0\xFA\0\x04\0?\x03\0\0A\x03\0\0@\x03\0\0\xF8\0\x02\0A\x03\0\0\xFE\0\x02\0}\0\0\0\xF8\0\x02\0@\x03\0\0A\0\x05\0\x8B\0\0\0B\x03\0\0<\x03\0\0\x8C\0\0\0=\0\x04\0\x05\0\0\0C\x03\0\0B\x03\0\0Q\0\x05\0\x03\0\0\0D\x03\0\09\x03\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0E\x03\0\09\x03\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0F\x03\0\0D\x03\0\0E\x03\0\09\0\x06\0\x03\0\0\0G\x03\0\x006\0\0\0C\x03\0\0F\x03\0\0\xFE\0\x02\0G\x03\0\08\0\x01\x006\0\x05\0\x13\0\0\0L\x03\0\0\0\0\0\0M\x03\0\x007\0\x03\0\x04\0\0\0I\x03\0\x007\0\x03\0\x04\0\0\0J\x03\0\x007\0\x03\0\x04\0\0\0K\x03\0\0\xF8\0\x02\0H\x03\0\0A\0\x05\0\x87\0\0\0N\x03\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0O\x03\0\0\xF8\0\x02\0O\x03\0\09\0\x07\0\x03\0\0\0P\x03\0\0\xE7\x02\0\0I\x03\0\0J\x03\0\0K\x03\0\09\0\x07\0\r\0\0\0Q\x03\0\0\r\x03\0\0J\x03\0\0K\x03\0\0P\x03\0\0\xA9\0\x06\0\x03\0\0\0R\x03\0\0Q\x03\0\0 \0\0\0}\0\0\09\0\x07\0\r\0\0\0S\x03\0\0\r\x03\0\0K\x03\0\0I\x03\0\0P\x03\0\0\xA9\0\x06\0\x03\0\0\0T\x03\0\0S\x03\0\0\x1E\0\0\0}\0\0\09\0\x07\0\r\0\0\0U\x03\0\0\r\x03\0\0I\x03\0\0J\x03\0\0P\x03\0\0\xA9\0\x06\0\x03\0\0\0V\x03\0\0U\x03\0\0\x1B\0\0\0}\0\0\09\0\x05\0\x03\0\0\0W\x03\0\0:\x03\0\0I\x03\0\09\0\x05\0\x03\0\0\0X\x03\0\0:\x03\0\0J\x03\0\09\0\x05\0\x03\0\0\0Y\x03\0\0:\x03\0\0K\x03\0\0P\0\x06\0\x12\0\0\0Z\x03\0\0W\x03\0\0X\x03\0\0Y\x03\0\0\x81\0\x05\0\x03\0\0\0[\x03\0\0R\x03\0\0T\x03\0\0\x81\0\x05\0\x03\0\0\0\\\x03\0\0[\x03\0\0V\x03\0\0P\0\x05\0\x04\0\0\0]\x03\0\0Z\x03\0\0\\\x03\0\0P\0\x07\0\x13\0\0\0^\x03\0\0I\x03\0\0J\x03\0\0K\x03\0\0]\x03\0\0\xFE\0\x02\0^\x03\0\08\0\x01\x006\0\x05\0\x07\0\0\0a\x03\0\0\0\0\0\0\xCC\0\0\x007\0\x03\0\x07\0\0\0`\x03\0\0\xF8\0\x02\0_\x03\0\0\xF9\0\x02\0c\x03\0\0\xF8\0\x02\0c\x03\0\0\x86\0\x05\0\x07\0\0\0d\x03\0\0`\x03\0\0b\x03\0\0\x84\0\x05\0\x07\0\0\0e\x03\0\0d\x03\0\0\xD8\0\0\0\xFE\0\x02\0e\x03\0\08\0\x01\x006\0\x05\0\x07\0\0\0h\x03\0\0\0\0\0\0\xCC\0\0\x007\0\x03\0\x07\0\0\0g\x03\0\0\xF8\0\x02\0f\x03\0\0\xF9\0\x02\0i\x03\0\0\xF8\0\x02\0i\x03\0\0\x89\0\x05\0\x07\0\0\0j\x03\0\0g\x03\0\0\xD8\0\0\0\x89\0\x05\0\x07\0\0\0k\x03\0\0g\x03\0\0b\x03\0\0\x86\0\x05\0\x07\0\0\0l\x03\0\0k\x03\0\0\xD8\0\0\0\x80\0\x05\0\x07\0\0\0m\x03\0\0l\x03\0\0j\x03\0\0\xAA\0\x05\0\r\0\0\0n\x03\0\0j\x03\0\0\x88\0\0\0\xA9\0\x06\0\x07\0\0\0o\x03\0\0n\x03\0\0\x88\0\0\0m\x03\0\0\xFE\0\x02\0o\x03\0\08\0\x01\x006\0\x05\0\x04\0\0\0r\x03\0\0\0\0\0\0s\x03\0\x007\0\x03\0\x08\0\0\0q\x03\0\0\xF8\0\x02\0p\x03\0\0A\0\x05\0\x87\0\0\0t\x03\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0u\x03\0\0\xF8\0\x02\0u\x03\0\0\x8E\0\x05\0\x08\0\0\0v\x03\0\0q\x03\0\0\x1E\0\0\0A\0\x05\0\x04\x02\0\0w\x03\0\0t\x03\0\0\x05\x02\0\0=\0\x04\0\x08\0\0\0x\x03\0\0w\x03\0\0\x88\0\x05\0\x08\0\0\0y\x03\0\0v\x03\0\0x\x03\0\0P\0\x06\0\x04\0\0\0z\x03\0\0y\x03\0\0\x1F\0\0\0 \0\0\0\xFE\0\x02\0z\x03\0\08\0\x01\x006\0\x05\0\x08\0\0\0}\x03\0\0\0\0\0\0~\x03\0\x007\0\x03\0\x04\0\0\0|\x03\0\0\xF8\0\x02\0{\x03\0\0A\0\x05\0\x87\0\0\0\x7F\x03\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\x80\x03\0\0\xF8\0\x02\0\x80\x03\0\0A\0\x05\0\x8B\0\0\0\x81\x03\0\0\x7F\x03\0\0\x8C\0\0\0=\0\x04\0\x05\0\0\0\x82\x03\0\0\x81\x03\0\0Q\0\x05\0\x03\0\0\0\x83\x03\0\0|\x03\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\x84\x03\0\0|\x03\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\x85\x03\0\0\x83\x03\0\0\x84\x03\0\09\0\x06\0\x03\0\0\0\x86\x03\0\x006\0\0\0\x82\x03\0\0\x85\x03\0\0A\0\x05\0\x04\x02\0\0\x87\x03\0\0\x7F\x03\0\0\x05\x02\0\0=\0\x04\0\x08\0\0\0\x88\x03\0\0\x87\x03\0\0\x8E\0\x05\0\x08\0\0\0\x89\x03\0\0\x88\x03\0\0\x1F\0\0\0Q\0\x05\0\x03\0\0\0\x8A\x03\0\0|\x03\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\x8B\x03\0\0|\x03\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\x8C\x03\0\0\x8A\x03\0\0\x8B\x03\0\0P\0\x05\0\x08\0\0\0\x8D\x03\0\0\x8C\x03\0\0\x86\x03\0\0\x85\0\x05\0\x08\0\0\0\x8E\x03\0\0\x89\x03\0\0\x8D\x03\0\0\xFE\0\x02\0\x8E\x03\0\08\0\x01\x006\0\x05\0\x04\0\0\0\x92\x03\0\0\0\0\0\0\x93\x03\0\x007\0\x03\0\x04\0\0\0\x90\x03\0\x007\0\x03\0\x08\0\0\0\x91\x03\0\0\xF8\0\x02\0\x8F\x03\0\0\xF9\0\x02\0\x94\x03\0\0\xF8\0\x02\0\x94\x03\0\0O\0\x07\0\x08\0\0\0\x95\x03\0\0\x90\x03\0\0\x90\x03\0\0\0\0\0\0\x01\0\0\0\x0C\0\x07\0\x08\0\0\0\x96\x03\0\0\x01\0\0\0%\0\0\0\x95\x03\0\0\x91\x03\0\0O\0\x07\0\x08\0\0\0\x97\x03\0\0\x90\x03\0\0\x90\x03\0\0\x02\0\0\0\x03\0\0\0\x0C\0\x07\0\x08\0\0\0\x98\x03\0\0\x01\0\0\0(\0\0\0\x97\x03\0\0\x91\x03\0\0P\0\x05\0\x04\0\0\0\x99\x03\0\0\x96\x03\0\0\x98\x03\0\0\xFE\0\x02\0\x99\x03\0\08\0\x01\x006\0\x05\0\x08\0\0\0\x9E\x03\0\0\0\0\0\0\x9F\x03\0\x007\0\x03\0\x04\0\0\0\x9B\x03\0\x007\0\x03\0\x04\0\0\0\x9C\x03\0\x007\0\x03\0\x03\0\0\0\x9D\x03\0\0\xF8\0\x02\0\x9A\x03\0\0;\0\x05\0}\x01\0\0\xA1\x03\0\0\x07\0\0\0\xA2\x03\0\0A\0\x05\0\x87\0\0\0\xA0\x03\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\xA3\x03\0\0\xF8\0\x02\0\xA3\x03\0\09\0\x05\0\x08\0\0\0\xA4\x03\0\0}\x03\0\0\x9B\x03\0\09\0\x05\0\x08\0\0\0\xA5\x03\0\0}\x03\0\0\x9C\x03\0\0\x83\0\x05\0\x08\0\0\0\xA6\x03\0\0\xA5\x03\0\0\xA4\x03\0\0Q\0\x05\0\x03\0\0\0\xA7\x03\0\0\x9B\x03\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xA8\x03\0\0\x9B\x03\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\xA9\x03\0\0\xA7\x03\0\0\xA8\x03\0\0Q\0\x05\0\x03\0\0\0\xAA\x03\0\0\x9C\x03\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xAB\x03\0\0\x9C\x03\0\0\x03\0\0\0\x88\0\x05\0\x03\0\0\0\xAC\x03\0\0\xAA\x03\0\0\xAB\x03\0\0\x0C\0\x07\0\x03\0\0\0\xAD\x03\0\0\x01\0\0\0%\0\0\0\xA9\x03\0\0\xAC\x03\0\0\x0C\0\x07\0\x03\0\0\0\xAE\x03\0\0\x01\0\0\0(\0\0\0\xA9\x03\0\0\xAC\x03\0\09\0\x06\0\x0E\0\0\0\xAF\x03\0\0\xBA\0\0\0\xAD\x03\0\0\xAE\x03\0\0Q\0\x05\0\x03\0\0\0\xB0\x03\0\0\xA6\x03\0\0\0\0\0\09\0\x07\0\r\0\0\0\xB1\x03\0\0{\0\0\0\xAF\x03\0\0\xB0\x03\0\0\x9D\x03\0\0\xA8\0\x04\0\r\0\0\0\xB2\x03\0\0\xB1\x03\0\0\xF7\0\x03\0\xB3\x03\0\0\0\0\0\0\xFA\0\x04\0\xB2\x03\0\0\xB4\x03\0\0\xB3\x03\0\0\xF8\0\x02\0\xB4\x03\0\0\x8E\0\x05\0\x08\0\0\0\xB5\x03\0\0\xA6\x03\0\0\x1F\0\0\0\x81\0\x05\0\x08\0\0\0\xB6\x03\0\0\xA4\x03\0\0\xB5\x03\0\0\xFE\0\x02\0\xB6\x03\0\0\xF8\0\x02\0\xB3\x03\0\0A\0\x06\0\x90\0\0\0\xB7\x03\0\0\xA0\x03\0\0\x05\x02\0\0\x91\0\0\0=\0\x04\0\x03\0\0\0\xB8\x03\0\0\xB7\x03\0\0\x85\0\x05\0\x03\0\0\0\xB9\x03\0\0\x1F\0\0\0\xB8\x03\0\0\x83\0\x05\0\x03\0\0\0\xBA\x03\0\0\xAC\x03\0\0\xA9\x03\0\0\x85\0\x05\0\x03\0\0\0\xBB\x03\0\0\xB9\x03\0\0\xBA\x03\0\0Q\0\x05\0\x03\0\0\0\xBC\x03\0\0\xAF\x03\0\0\0\0\0\0\x85\0\x05\0\x03\0\0\0\xBD\x03\0\0\xBC\x03\0\0\xBB\x03\0\0Q\0\x05\0\x03\0\0\0\xBE\x03\0\0\xAF\x03\0\0\x01\0\0\0\x85\0\x05\0\x03\0\0\0\xBF\x03\0\0\xBE\x03\0\0\xBB\x03\0\0\x0C\0\x07\0\x03\0\0\0\xC0\x03\0\0\x01\0\0\0(\0\0\0\xBD\x03\0\0\xBF\x03\0\0Q\0\x05\0\x03\0\0\0\xC1\x03\0\0\xAF\x03\0\0\0\0\0\0\x85\0\x05\0\x03\0\0\0\xC2\x03\0\0\xC1\x03\0\0\xBB\x03\0\0Q\0\x05\0\x03\0\0\0\xC3\x03\0\0\xAF\x03\0\0\x01\0\0\0\x85\0\x05\0\x03\0\0\0\xC4\x03\0\0\xC3\x03\0\0\xBB\x03\0\0\x0C\0\x07\0\x03\0\0\0\xC5\x03\0\0\x01\0\0\0%\0\0\0\xC2\x03\0\0\xC4\x03\0\0Q\0\x05\0\x03\0\0\0\xC6\x03\0\0\xA6\x03\0\0\0\0\0\0\x85\0\x05\0\x03\0\0\0\xC7\x03\0\0\x9D\x03\0\0\xC6\x03\0\0\xB8\0\x05\0\r\0\0\0\xC8\x03\0\0\xC7\x03\0\0}\0\0\0\xA9\0\x06\0\x03\0\0\0\xC9\x03\0\0\xC8\x03\0\0\xC0\x03\0\0\xC5\x03\0\0\xA9\0\x06\0\x03\0\0\0\xCA\x03\0\0\xC8\x03\0\0\xC5\x03\0\0\xC0\x03\0\0Q\0\x05\0\x03\0\0\0\xCB\x03\0\0\xA6\x03\0\0\x01\0\0\0\x83\0\x05\0\x03\0\0\0\xCC\x03\0\0\xCB\x03\0\0\xCA\x03\0\0\x83\0\x05\0\x03\0\0\0\xCD\x03\0\0\xC9\x03\0\0\xCA\x03\0\0\x88\0\x05\0\x03\0\0\0\xCE\x03\0\0\xCC\x03\0\0\xCD\x03\0\0\xBA\0\x05\0\r\0\0\0\xCF\x03\0\0\xCE\x03\0\0}\0\0\0\xF7\0\x03\0\xD0\x03\0\0\0\0\0\0\xFA\0\x04\0\xCF\x03\0\0\xD1\x03\0\0\xD2\x03\0\0\xF8\0\x02\0\xD1\x03\0\0\xB8\0\x05\0\r\0\0\0\xD3\x03\0\0\xCE\x03\0\0 \0\0\0>\0\x03\0\xA1\x03\0\0\xD3\x03\0\0\xF9\0\x02\0\xD0\x03\0\0\xF8\0\x02\0\xD2\x03\0\0>\0\x03\0\xA1\x03\0\0{\x01\0\0\xF9\0\x02\0\xD0\x03\0\0\xF8\0\x02\0\xD0\x03\0\0=\0\x04\0\r\0\0\0\xD4\x03\0\0\xA1\x03\0\0\xA8\0\x04\0\r\0\0\0\xD5\x03\0\0\xD4\x03\0\0\xF7\0\x03\0\xD6\x03\0\0\0\0\0\0\xFA\0\x04\0\xD5\x03\0\0\xD7\x03\0\0\xD6\x03\0\0\xF8\0\x02\0\xD7\x03\0\0\x8E\0\x05\0\x08\0\0\0\xD8\x03\0\0\xA6\x03\0\0\x1F\0\0\0\x81\0\x05\0\x08\0\0\0\xD9\x03\0\0\xA4\x03\0\0\xD8\x03\0\0\xFE\0\x02\0\xD9\x03\0\0\xF8\0\x02\0\xD6\x03\0\0Q\0\x05\0\x03\0\0\0\xDA\x03\0\0\xA6\x03\0\0\0\0\0\0P\0\x05\0\x08\0\0\0\xDB\x03\0\0\xDA\x03\0\0\xC9\x03\0\0\x8E\0\x05\0\x08\0\0\0\xDC\x03\0\0\xDB\x03\0\0\xCE\x03\0\0\x81\0\x05\0\x08\0\0\0\xDD\x03\0\0\xA4\x03\0\0\xDC\x03\0\0\xFE\0\x02\0\xDD\x03\0\08\0\x01\x006\0\x05\0\x08\0\0\0\xE1\x03\0\0\0\0\0\0\xE2\x03\0\x007\0\x03\0\x04\0\0\0\xDF\x03\0\x007\0\x03\0\x07\0\0\0\xE0\x03\0\0\xF8\0\x02\0\xDE\x03\0\0;\0\x05\0}\x01\0\0\xE3\x03\0\0\x07\0\0\0\xE4\x03\0\0;\0\x05\0}\x01\0\0\xE5\x03\0\0\x07\0\0\0\xE6\x03\0\0\xF9\0\x02\0\xE7\x03\0\0\xF8\0\x02\0\xE7\x03\0\0\xAA\0\x05\0\r\0\0\0\xE8\x03\0\0\xE0\x03\0\0\x91\0\0\0\xA8\0\x04\0\r\0\0\0\xE9\x03\0\0\xE8\x03\0\0\xF7\0\x03\0\xEA\x03\0\0\0\0\0\0\xFA\0\x04\0\xE9\x03\0\0\xEB\x03\0\0\xEC\x03\0\0\xF8\0\x02\0\xEB\x03\0\0\xAA\0\x05\0\r\0\0\0\xED\x03\0\0\xE0\x03\0\0\x06\0\0\0>\0\x03\0\xE3\x03\0\0\xED\x03\0\0\xF9\0\x02\0\xEA\x03\0\0\xF8\0\x02\0\xEC\x03\0\0>\0\x03\0\xE3\x03\0\0\xAF\x01\0\0\xF9\0\x02\0\xEA\x03\0\0\xF8\0\x02\0\xEA\x03\0\0=\0\x04\0\r\0\0\0\xEE\x03\0\0\xE3\x03\0\0\xAA\0\x05\0\r\0\0\0\xEF\x03\0\0\xE0\x03\0\0\x06\0\0\0\xA8\0\x04\0\r\0\0\0\xF0\x03\0\0\xEF\x03\0\0\xF7\0\x03\0\xF1\x03\0\0\0\0\0\0\xFA\0\x04\0\xF0\x03\0\0\xF2\x03\0\0\xF3\x03\0\0\xF8\0\x02\0\xF2\x03\0\0\xAA\0\x05\0\r\0\0\0\xF4\x03\0\0\xE0\x03\0\0\xD8\0\0\0>\0\x03\0\xE5\x03\0\0\xF4\x03\0\0\xF9\0\x02\0\xF1\x03\0\0\xF8\0\x02\0\xF3\x03\0\0>\0\x03\0\xE5\x03\0\0\xAF\x01\0\0\xF9\0\x02\0\xF1\x03\0\0\xF8\0\x02\0\xF1\x03\0\0=\0\x04\0\r\0\0\0\xF5\x03\0\0\xE5\x03\0\0Q\0\x05\0\x03\0\0\0\xF6\x03\0\0\xDF\x03\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xF7\x03\0\0\xDF\x03\0\0\x02\0\0\0\xA9\0\x06\0\x03\0\0\0\xF8\x03\0\0\xEE\x03\0\0\xF7\x03\0\0\xF6\x03\0\0Q\0\x05\0\x03\0\0\0\xF9\x03\0\0\xDF\x03\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xFA\x03\0\0\xDF\x03\0\0\x03\0\0\0\xA9\0\x06\0\x03\0\0\0\xFB\x03\0\0\xF5\x03\0\0\xFA\x03\0\0\xF9\x03\0\0P\0\x05\0\x08\0\0\0\xFC\x03\0\0\xF8\x03\0\0\xFB\x03\0\0\xFE\0\x02\0\xFC\x03\0\08\0\x01\x006\0\x05\0\x08\0\0\0\x02\x04\0\0\0\0\0\0\x03\x04\0\x007\0\x03\0\x04\0\0\0\xFE\x03\0\x007\0\x03\0\x04\0\0\0\xFF\x03\0\x007\0\x03\0\x04\0\0\0\0\x04\0\x007\0\x03\0\x07\0\0\0\x01\x04\0\0\xF8\0\x02\0\xFD\x03\0\0;\0\x05\0\n\x04\0\0\t\x04\0\0\x07\0\0\0\x0B\x04\0\0;\0\x05\0\r\x04\0\0\x0C\x04\0\0\x07\0\0\0\x06\x04\0\0A\0\x05\0\x87\0\0\0\x04\x04\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\x0E\x04\0\0\xF8\0\x02\0\x0E\x04\0\09\0\x05\0\x08\0\0\0\x0F\x04\0\0}\x03\0\0\xFE\x03\0\09\0\x05\0\x08\0\0\0\x10\x04\0\0}\x03\0\0\xFF\x03\0\0\x83\0\x05\0\x08\0\0\0\x11\x04\0\0\x10\x04\0\0\x0F\x04\0\09\0\x05\0\x08\0\0\0\x12\x04\0\0}\x03\0\0\0\x04\0\0\x83\0\x05\0\x08\0\0\0\x13\x04\0\0\x12\x04\0\0\x0F\x04\0\0\x83\0\x05\0\x08\0\0\0\x14\x04\0\0\x13\x04\0\0\x11\x04\0\0>\0\x03\0\t\x04\0\0\x11\x04\0\0=\0\x04\0\x08\0\0\0\x15\x04\0\0\t\x04\0\0\x0C\0\x06\0\x03\0\0\0\x16\x04\0\0\x01\0\0\0B\0\0\0\x13\x04\0\0=\0\x04\0\x08\0\0\0\x17\x04\0\0\t\x04\0\0\x0C\0\x06\0\x03\0\0\0\x18\x04\0\0\x01\0\0\0B\0\0\0\x17\x04\0\0\xBA\0\x05\0\r\0\0\0\x19\x04\0\0\x16\x04\0\0\x18\x04\0\0P\0\x05\0\x04\x01\0\0\x1B\x04\0\0\x19\x04\0\0\x19\x04\0\0\xA9\0\x06\0\x08\0\0\0\x1A\x04\0\0\x1B\x04\0\0\x13\x04\0\0\x15\x04\0\0>\0\x03\0\t\x04\0\0\x1A\x04\0\0=\0\x04\0\x08\0\0\0\x1C\x04\0\0\t\x04\0\0\x0C\0\x06\0\x03\0\0\0\x1D\x04\0\0\x01\0\0\0B\0\0\0\x14\x04\0\0=\0\x04\0\x08\0\0\0\x1E\x04\0\0\t\x04\0\0\x0C\0\x06\0\x03\0\0\0\x1F\x04\0\0\x01\0\0\0B\0\0\0\x1E\x04\0\0\xBA\0\x05\0\r\0\0\0 \x04\0\0\x1D\x04\0\0\x1F\x04\0\0P\0\x05\0\x04\x01\0\0\"\x04\0\0 \x04\0\0 \x04\0\0\xA9\0\x06\0\x08\0\0\0!\x04\0\0\"\x04\0\0\x14\x04\0\0\x1C\x04\0\0>\0\x03\0\t\x04\0\0!\x04\0\0=\0\x04\0\x08\0\0\0#\x04\0\0\t\x04\0\0\x0C\0\x06\0\x03\0\0\0$\x04\0\0\x01\0\0\0B\0\0\0#\x04\0\0=\0\x04\0\x08\0\0\0%\x04\0\0\t\x04\0\0\x0C\0\x07\0\x03\0\0\0&\x04\0\0\x01\0\0\0(\0\0\0$\x04\0\0$\0\0\0P\0\x05\0\x08\0\0\0'\x04\0\0&\x04\0\0&\x04\0\0\x88\0\x05\0\x08\0\0\0(\x04\0\0%\x04\0\0'\x04\0\0\xBA\0\x05\0\r\0\0\0)\x04\0\0$\x04\0\0$\0\0\0P\0\x05\0\x04\x01\0\0+\x04\0\0)\x04\0\0)\x04\0\0\xA9\0\x06\0\x08\0\0\0*\x04\0\0+\x04\0\0(\x04\0\0\x05\x04\0\0Q\0\x05\0\x03\0\0\0,\x04\0\0*\x04\0\0\x01\0\0\0\x7F\0\x04\0\x03\0\0\0-\x04\0\0,\x04\0\0Q\0\x05\0\x03\0\0\0.\x04\0\0*\x04\0\0\0\0\0\0P\0\x05\0\x08\0\0\0/\x04\0\0-\x04\0\0.\x04\0\0P\0\x05\0\x14\0\0\x000\x04\0\0*\x04\0\0/\x04\0\0=\0\x04\0\x04\0\0\x001\x04\0\0\x0C\x04\0\0\x90\0\x05\0\x08\0\0\x002\x04\0\0\x11\x04\0\x000\x04\0\09\0\x06\0\x04\0\0\x003\x04\0\0\x92\x03\0\x001\x04\0\x002\x04\0\0>\0\x03\0\x0C\x04\0\x003\x04\0\0=\0\x04\0\x04\0\0\x004\x04\0\0\x0C\x04\0\0\x90\0\x05\0\x08\0\0\x005\x04\0\0\x13\x04\0\x000\x04\0\09\0\x06\0\x04\0\0\x006\x04\0\0\x92\x03\0\x004\x04\0\x005\x04\0\0>\0\x03\0\x0C\x04\0\x006\x04\0\0=\0\x04\0\x04\0\0\x007\x04\0\0\x0C\x04\0\09\0\x07\0\x08\0\0\08\x04\0\0\x9E\x03\0\0\xFE\x03\0\0\xFF\x03\0\0 \0\0\0\x83\0\x05\0\x08\0\0\09\x04\0\08\x04\0\0\x0F\x04\0\0\x90\0\x05\0\x08\0\0\0:\x04\0\09\x04\0\x000\x04\0\09\0\x06\0\x04\0\0\0;\x04\0\0\x92\x03\0\x007\x04\0\0:\x04\0\0>\0\x03\0\x0C\x04\0\0;\x04\0\0=\0\x04\0\x04\0\0\0<\x04\0\0\x0C\x04\0\09\0\x07\0\x08\0\0\0=\x04\0\0\x9E\x03\0\0\xFE\x03\0\0\xFF\x03\0\0c\x02\0\0\x83\0\x05\0\x08\0\0\0>\x04\0\0=\x04\0\0\x0F\x04\0\0\x90\0\x05\0\x08\0\0\0?\x04\0\0>\x04\0\x000\x04\0\09\0\x06\0\x04\0\0\0@\x04\0\0\x92\x03\0\0<\x04\0\0?\x04\0\0>\0\x03\0\x0C\x04\0\0@\x04\0\0=\0\x04\0\x04\0\0\0A\x04\0\0\x0C\x04\0\09\0\x07\0\x08\0\0\0B\x04\0\0\x9E\x03\0\0\xFF\x03\0\0\0\x04\0\0 \0\0\0\x83\0\x05\0\x08\0\0\0C\x04\0\0B\x04\0\0\x0F\x04\0\0\x90\0\x05\0\x08\0\0\0D\x04\0\0C\x04\0\x000\x04\0\09\0\x06\0\x04\0\0\0E\x04\0\0\x92\x03\0\0A\x04\0\0D\x04\0\0>\0\x03\0\x0C\x04\0\0E\x04\0\0=\0\x04\0\x04\0\0\0F\x04\0\0\x0C\x04\0\09\0\x07\0\x08\0\0\0G\x04\0\0\x9E\x03\0\0\xFF\x03\0\0\0\x04\0\0c\x02\0\0\x83\0\x05\0\x08\0\0\0H\x04\0\0G\x04\0\0\x0F\x04\0\0\x90\0\x05\0\x08\0\0\0I\x04\0\0H\x04\0\x000\x04\0\09\0\x06\0\x04\0\0\0J\x04\0\0\x92\x03\0\0F\x04\0\0I\x04\0\0>\0\x03\0\x0C\x04\0\0J\x04\0\0=\0\x04\0\x04\0\0\0K\x04\0\0\x0C\x04\0\09\0\x07\0\x08\0\0\0L\x04\0\0\x9E\x03\0\0\0\x04\0\0\xFE\x03\0\0 \0\0\0\x83\0\x05\0\x08\0\0\0M\x04\0\0L\x04\0\0\x0F\x04\0\0\x90\0\x05\0\x08\0\0\0N\x04\0\0M\x04\0\x000\x04\0\09\0\x06\0\x04\0\0\0O\x04\0\0\x92\x03\0\0K\x04\0\0N\x04\0\0>\0\x03\0\x0C\x04\0\0O\x04\0\0=\0\x04\0\x04\0\0\0P\x04\0\0\x0C\x04\0\09\0\x07\0\x08\0\0\0Q\x04\0\0\x9E\x03\0\0\0\x04\0\0\xFE\x03\0\0c\x02\0\0\x83\0\x05\0\x08\0\0\0R\x04\0\0Q\x04\0\0\x0F\x04\0\0\x90\0\x05\0\x08\0\0\0S\x04\0\0R\x04\0\x000\x04\0\09\0\x06\0\x04\0\0\0T\x04\0\0\x92\x03\0\0P\x04\0\0S\x04\0\0>\0\x03\0\x0C\x04\0\0T\x04\0\0=\0\x04\0\x04\0\0\0U\x04\0\0\x0C\x04\0\0\x81\0\x05\0\x04\0\0\0V\x04\0\0U\x04\0\0\x08\x04\0\09\0\x06\0\x08\0\0\0W\x04\0\0\xE1\x03\0\0V\x04\0\0\x01\x04\0\0\x91\0\x05\0\x08\0\0\0X\x04\0\x000\x04\0\0W\x04\0\0\x81\0\x05\0\x08\0\0\0Y\x04\0\0\x0F\x04\0\0X\x04\0\0\xFE\0\x02\0Y\x04\0\08\0\x01\x006\0\x05\0\x08\0\0\0_\x04\0\0\0\0\0\0\x03\x04\0\x007\0\x03\0\x04\0\0\0[\x04\0\x007\0\x03\0\x04\0\0\0\\\x04\0\x007\0\x03\0\x04\0\0\0]\x04\0\x007\0\x03\0\x07\0\0\0^\x04\0\0\xF8\0\x02\0Z\x04\0\0;\0\x05\0\n\x04\0\0d\x04\0\0\x07\0\0\0e\x04\0\0A\0\x05\0\x87\0\0\0`\x04\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0f\x04\0\0\xF8\0\x02\0f\x04\0\09\0\x05\0\x08\0\0\0g\x04\0\0}\x03\0\0[\x04\0\09\0\x05\0\x08\0\0\0h\x04\0\0}\x03\0\0\\\x04\0\09\0\x05\0\x08\0\0\0i\x04\0\0}\x03\0\0]\x04\0\0\x83\0\x05\0\x08\0\0\0j\x04\0\0h\x04\0\0g\x04\0\0\x83\0\x05\0\x08\0\0\0k\x04\0\0i\x04\0\0g\x04\0\0Q\0\x05\0\x03\0\0\0l\x04\0\0j\x04\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0m\x04\0\0k\x04\0\0\x01\0\0\0\x85\0\x05\0\x03\0\0\0n\x04\0\0l\x04\0\0m\x04\0\0Q\0\x05\0\x03\0\0\0o\x04\0\0j\x04\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0p\x04\0\0k\x04\0\0\0\0\0\0\x85\0\x05\0\x03\0\0\0q\x04\0\0o\x04\0\0p\x04\0\0\x83\0\x05\0\x03\0\0\0r\x04\0\0n\x04\0\0q\x04\0\0\x0C\0\x06\0\x03\0\0\0s\x04\0\0\x01\0\0\0B\0\0\0j\x04\0\0\x0C\0\x06\0\x03\0\0\0t\x04\0\0\x01\0\0\0B\0\0\0k\x04\0\0\x0C\0\x07\0\x03\0\0\0u\x04\0\0\x01\0\0\0(\0\0\0s\x04\0\0t\x04\0\0\x0C\0\x07\0\x03\0\0\0v\x04\0\0\x01\0\0\0C\0\0\0h\x04\0\0i\x04\0\0\x0C\0\x07\0\x03\0\0\0w\x04\0\0\x01\0\0\0(\0\0\0u\x04\0\0v\x04\0\09\0\x07\0\x03\0\0\0x\x04\0\0\xE7\x02\0\0[\x04\0\0\\\x04\0\0]\x04\0\0\x85\0\x05\0\x03\0\0\0y\x04\0\0r\x04\0\0x\x04\0\0\x85\0\x05\0\x03\0\0\0z\x04\0\0%\0\0\0w\x04\0\0\xBE\0\x05\0\r\0\0\0{\x04\0\0y\x04\0\0z\x04\0\0\xA8\0\x04\0\r\0\0\0|\x04\0\0{\x04\0\0\xF7\0\x03\0}\x04\0\0\0\0\0\0\xFA\0\x04\0|\x04\0\0~\x04\0\0}\x04\0\0\xF8\0\x02\0~\x04\0\09\0\x08\0\x08\0\0\0\x7F\x04\0\0\x02\x04\0\0[\x04\0\0\\\x04\0\0]\x04\0\0^\x04\0\0\xFE\0\x02\0\x7F\x04\0\0\xF8\0\x02\0}\x04\0\0>\0\x03\0d\x04\0\0g\x04\0\0\xF7\0\x03\0\x80\x04\0\0\0\0\0\0\xFB\0\r\0^\x04\0\0\x86\x04\0\0\0\0\0\0\x81\x04\0\0\x01\0\0\0\x82\x04\0\0\x02\0\0\0\x83\x04\0\0\x03\0\0\0\x84\x04\0\0\x04\0\0\0\x85\x04\0\0\xF8\0\x02\0\x81\x04\0\0\xF9\0\x02\0\x80\x04\0\0\xF8\0\x02\0\x82\x04\0\09\0\x07\0\x08\0\0\0\x87\x04\0\0\x9E\x03\0\0[\x04\0\0\\\x04\0\0x\x04\0\0>\0\x03\0d\x04\0\0\x87\x04\0\0\xF9\0\x02\0\x80\x04\0\0\xF8\0\x02\0\x83\x04\0\0>\0\x03\0d\x04\0\0h\x04\0\0\xF9\0\x02\0\x80\x04\0\0\xF8\0\x02\0\x84\x04\0\09\0\x07\0\x08\0\0\0\x88\x04\0\0\x9E\x03\0\0\\\x04\0\0]\x04\0\0x\x04\0\0>\0\x03\0d\x04\0\0\x88\x04\0\0\xF9\0\x02\0\x80\x04\0\0\xF8\0\x02\0\x85\x04\0\0>\0\x03\0d\x04\0\0i\x04\0\0\xF9\0\x02\0\x80\x04\0\0\xF8\0\x02\0\x86\x04\0\09\0\x07\0\x08\0\0\0\x89\x04\0\0\x9E\x03\0\0]\x04\0\0[\x04\0\0x\x04\0\0>\0\x03\0d\x04\0\0\x89\x04\0\0\xF9\0\x02\0\x80\x04\0\0\xF8\0\x02\0\x80\x04\0\0\x81\0\x05\0\x08\0\0\0\x8A\x04\0\0g\x04\0\0h\x04\0\0\x81\0\x05\0\x08\0\0\0\x8B\x04\0\0\x8A\x04\0\0i\x04\0\0\x88\0\x05\0\x08\0\0\0\x8C\x04\0\0\x8B\x04\0\0b\x04\0\0=\0\x04\0\x08\0\0\0\x8D\x04\0\0d\x04\0\0\x83\0\x05\0\x08\0\0\0\x8E\x04\0\0\x8D\x04\0\0\x8C\x04\0\0\x85\0\x05\0\x03\0\0\0\x8F\x04\0\0c\x04\0\0w\x04\0\0\x85\0\x05\0\x03\0\0\0\x90\x04\0\0r\x04\0\0x\x04\0\0\x88\0\x05\0\x03\0\0\0\x91\x04\0\0\x8F\x04\0\0\x90\x04\0\0\x81\0\x05\0\x03\0\0\0\x92\x04\0\0 \0\0\0\x91\x04\0\0\x8E\0\x05\0\x08\0\0\0\x93\x04\0\0\x8E\x04\0\0\x92\x04\0\0\x81\0\x05\0\x08\0\0\0\x94\x04\0\0\x8C\x04\0\0\x93\x04\0\0\xFE\0\x02\0\x94\x04\0\08\0\x01\x006\0\x05\0\x04\0\0\0\x97\x04\0\0\0\0\0\0f\x01\0\x007\0\x03\0\x04\0\0\0\x96\x04\0\0\xF8\0\x02\0\x95\x04\0\0A\0\x05\0\x87\0\0\0\x98\x04\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\x99\x04\0\0\xF8\0\x02\0\x99\x04\0\0A\0\x05\0\x8F\0\0\0\x9A\x04\0\0\x98\x04\0\0\x92\0\0\0=\0\x04\0\x04\0\0\0\x9B\x04\0\0\x9A\x04\0\0O\0\x07\0\x08\0\0\0\x9C\x04\0\0\x9B\x04\0\0\x9B\x04\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\x9D\x04\0\0\x96\x04\0\0\x03\0\0\0\x8E\0\x05\0\x08\0\0\0\x9E\x04\0\0\x9C\x04\0\0\x9D\x04\0\0Q\0\x05\0\x03\0\0\0\x9F\x04\0\0\x96\x04\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\xA0\x04\0\0\x96\x04\0\0\0\0\0\0\x81\0\x05\0\x03\0\0\0\xA1\x04\0\0\x9F\x04\0\0\xA0\x04\0\0Q\0\x05\0\x03\0\0\0\xA2\x04\0\0\x96\x04\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\xA3\x04\0\0\x96\x04\0\0\0\0\0\0\x83\0\x05\0\x03\0\0\0\xA4\x04\0\0\xA2\x04\0\0\xA3\x04\0\0Q\0\x05\0\x03\0\0\0\xA5\x04\0\0\x96\x04\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xA6\x04\0\0\x9E\x04\0\0\0\0\0\0\x83\0\x05\0\x03\0\0\0\xA7\x04\0\0\xA5\x04\0\0\xA6\x04\0\0Q\0\x05\0\x03\0\0\0\xA8\x04\0\0\x9E\x04\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xA9\x04\0\0\x96\x04\0\0\x01\0\0\0\x83\0\x05\0\x03\0\0\0\xAA\x04\0\0\xA8\x04\0\0\xA9\x04\0\0P\0\x07\0\x04\0\0\0\xAB\x04\0\0\xA1\x04\0\0\xA4\x04\0\0\xA7\x04\0\0\xAA\x04\0\0\xFE\0\x02\0\xAB\x04\0\08\0\x01\x006\0\x05\0\x08\0\0\0\xAE\x04\0\0\0\0\0\0~\x03\0\x007\0\x03\0\x04\0\0\0\xAD\x04\0\0\xF8\0\x02\0\xAC\x04\0\0A\0\x05\0\x87\0\0\0\xAF\x04\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\xB0\x04\0\0\xF8\0\x02\0\xB0\x04\0\0O\0\x07\0\x08\0\0\0\xB1\x04\0\0\xAD\x04\0\0\xAD\x04\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xB2\x04\0\0\xAD\x04\0\0\x03\0\0\0\x0C\0\x07\0\x03\0\0\0\xB3\x04\0\0\x01\0\0\0(\0\0\0\xB2\x04\0\0\"\0\0\0P\0\x05\0\x08\0\0\0\xB4\x04\0\0\xB3\x04\0\0\xB3\x04\0\0\x88\0\x05\0\x08\0\0\0\xB5\x04\0\0\xB1\x04\0\0\xB4\x04\0\0A\0\x06\0\x90\0\0\0\xB6\x04\0\0\xAF\x04\0\0\x92\0\0\0\x88\0\0\0=\0\x04\0\x03\0\0\0\xB7\x04\0\0\xB6\x04\0\0P\0\x05\0\x08\0\0\0\xB8\x04\0\0c\x02\0\0\xB7\x04\0\0A\0\x06\0\x90\0\0\0\xB9\x04\0\0\xAF\x04\0\0\x92\0\0\0\x91\0\0\0=\0\x04\0\x03\0\0\0\xBA\x04\0\0\xB9\x04\0\0P\0\x05\0\x08\0\0\0\xBB\x04\0\0 \0\0\0\xBA\x04\0\0\x0C\0\x08\0\x08\0\0\0\xBC\x04\0\0\x01\0\0\0+\0\0\0\xB5\x04\0\0\xB8\x04\0\0\xBB\x04\0\0\xFE\0\x02\0\xBC\x04\0\08\0\x01\x006\0\x05\0\x04\0\0\0\xC1\x04\0\0\0\0\0\0\xC2\x04\0\x007\0\x03\0\x04\0\0\0\xBE\x04\0\x007\0\x03\0\x04\0\0\0\xBF\x04\0\x007\0\x03\0\x04\0\0\0\xC0\x04\0\0\xF8\0\x02\0\xBD\x04\0\0;\0\x05\0}\x01\0\0\xC5\x04\0\0\x07\0\0\0\xC6\x04\0\0A\0\x05\0\x87\0\0\0\xC3\x04\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\xC7\x04\0\0\xF8\0\x02\0\xC7\x04\0\09\0\x05\0\x04\0\0\0\xC8\x04\0\0\x97\x04\0\0\xBF\x04\0\09\0\x05\0\x04\0\0\0\xC9\x04\0\0\x97\x04\0\0\xC0\x04\0\0\x83\0\x05\0\x04\0\0\0\xCA\x04\0\0\xC8\x04\0\0\xC9\x04\0\0\x88\0\x05\0\x04\0\0\0\xCB\x04\0\0\xC8\x04\0\0\xCA\x04\0\0\xB8\0\x05\0\xCC\x04\0\0\xCD\x04\0\0\xC8\x04\0\0\x06\x04\0\0\xA9\0\x06\0\x04\0\0\0\xCE\x04\0\0\xCD\x04\0\0\xCB\x04\0\0\x06\x04\0\0\xB8\0\x05\0\xCC\x04\0\0\xCF\x04\0\0\xC9\x04\0\0\x06\x04\0\0\xA9\0\x06\0\x04\0\0\0\xD0\x04\0\0\xCF\x04\0\0\xCB\x04\0\0\xC4\x04\0\0Q\0\x05\0\x03\0\0\0\xD1\x04\0\0\xCE\x04\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xD2\x04\0\0\xCE\x04\0\0\x01\0\0\0\x0C\0\x07\0\x03\0\0\0\xD3\x04\0\0\x01\0\0\0(\0\0\0\xD1\x04\0\0\xD2\x04\0\0Q\0\x05\0\x03\0\0\0\xD4\x04\0\0\xCE\x04\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\xD5\x04\0\0\xCE\x04\0\0\x03\0\0\0\x0C\0\x07\0\x03\0\0\0\xD6\x04\0\0\x01\0\0\0(\0\0\0\xD4\x04\0\0\xD5\x04\0\0\x0C\0\x07\0\x03\0\0\0\xD7\x04\0\0\x01\0\0\0(\0\0\0\xD3\x04\0\0\xD6\x04\0\0Q\0\x05\0\x03\0\0\0\xD8\x04\0\0\xD0\x04\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xD9\x04\0\0\xD0\x04\0\0\x01\0\0\0\x0C\0\x07\0\x03\0\0\0\xDA\x04\0\0\x01\0\0\0%\0\0\0\xD8\x04\0\0\xD9\x04\0\0Q\0\x05\0\x03\0\0\0\xDB\x04\0\0\xD0\x04\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\xDC\x04\0\0\xD0\x04\0\0\x03\0\0\0\x0C\0\x07\0\x03\0\0\0\xDD\x04\0\0\x01\0\0\0%\0\0\0\xDB\x04\0\0\xDC\x04\0\0\x0C\0\x07\0\x03\0\0\0\xDE\x04\0\0\x01\0\0\0%\0\0\0\xDA\x04\0\0\xDD\x04\0\0\xB8\0\x05\0\xCC\x04\0\0\xDF\x04\0\0\xC8\x04\0\0\x06\x04\0\0\xB8\0\x05\0\xCC\x04\0\0\xE0\x04\0\0\xC9\x04\0\0\x06\x04\0\0\xA7\0\x05\0\xCC\x04\0\0\xE1\x04\0\0\xDF\x04\0\0\xE0\x04\0\0\x9A\0\x04\0\r\0\0\0\xE2\x04\0\0\xE1\x04\0\0\xA8\0\x04\0\r\0\0\0\xE3\x04\0\0\xE2\x04\0\0\xF7\0\x03\0\xE4\x04\0\0\0\0\0\0\xFA\0\x04\0\xE3\x04\0\0\xE5\x04\0\0\xE6\x04\0\0\xF8\0\x02\0\xE5\x04\0\0\xBA\0\x05\0\r\0\0\0\xE7\x04\0\0\xD7\x04\0\0\xDE\x04\0\0>\0\x03\0\xC5\x04\0\0\xE7\x04\0\0\xF9\0\x02\0\xE4\x04\0\0\xF8\0\x02\0\xE6\x04\0\0>\0\x03\0\xC5\x04\0\0\xAF\x01\0\0\xF9\0\x02\0\xE4\x04\0\0\xF8\0\x02\0\xE4\x04\0\0=\0\x04\0\r\0\0\0\xE8\x04\0\0\xC5\x04\0\0\xF7\0\x03\0\xE9\x04\0\0\0\0\0\0\xFA\0\x04\0\xE8\x04\0\0\xEA\x04\0\0\xE9\x04\0\0\xF8\0\x02\0\xEA\x04\0\0\xFE\0\x02\0\xBE\x04\0\0\xF8\0\x02\0\xE9\x04\0\0P\0\x07\0\x04\0\0\0\xEC\x04\0\0\xD7\x04\0\0\xD7\x04\0\0\xD7\x04\0\0\xD7\x04\0\0\x0C\0\x08\0\x04\0\0\0\xEB\x04\0\0\x01\0\0\0.\0\0\0\xBF\x04\0\0\xC0\x04\0\0\xEC\x04\0\09\0\x05\0\x08\0\0\0\xED\x04\0\0\xAE\x04\0\0\xEB\x04\0\09\0\x06\0\x04\0\0\0\xEE\x04\0\0\x92\x03\0\0\xBE\x04\0\0\xED\x04\0\0P\0\x07\0\x04\0\0\0\xF0\x04\0\0\xDE\x04\0\0\xDE\x04\0\0\xDE\x04\0\0\xDE\x04\0\0\x0C\0\x08\0\x04\0\0\0\xEF\x04\0\0\x01\0\0\0.\0\0\0\xBF\x04\0\0\xC0\x04\0\0\xF0\x04\0\09\0\x05\0\x08\0\0\0\xF1\x04\0\0\xAE\x04\0\0\xEF\x04\0\09\0\x06\0\x04\0\0\0\xF2\x04\0\0\x92\x03\0\0\xEE\x04\0\0\xF1\x04\0\0\xFE\0\x02\0\xF2\x04\0\08\0\x01\x006\0\x05\0\x04\0\0\0\xF7\x04\0\0\0\0\0\0\xC2\x04\0\x007\0\x03\0\x04\0\0\0\xF4\x04\0\x007\0\x03\0\x04\0\0\0\xF5\x04\0\x007\0\x03\0\x04\0\0\0\xF6\x04\0\0\xF8\0\x02\0\xF3\x04\0\0;\0\x05\0\r\x04\0\0\xFC\x04\0\0\x07\0\0\0\xFA\x04\0\0;\0\x05\0\xFE\x04\0\0\xFD\x04\0\0\x07\0\0\0\x88\0\0\0;\0\x05\0}\x01\0\0\xFF\x04\0\0\x07\0\0\0\0\x05\0\0A\0\x05\0\x87\0\0\0\xF8\x04\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\x01\x05\0\0\xF8\0\x02\0\x01\x05\0\0A\0\x05\0\x8F\0\0\0\x02\x05\0\0\xF8\x04\0\0\x92\0\0\0=\0\x04\0\x04\0\0\0\x03\x05\0\0\x02\x05\0\0=\0\x04\0\x04\0\0\0\x04\x05\0\0\xFC\x04\0\09\0\x07\0\x04\0\0\0\x05\x05\0\0\xC1\x04\0\0\x04\x05\0\0\xF4\x04\0\0\xF5\x04\0\0>\0\x03\0\xFC\x04\0\0\x05\x05\0\0=\0\x04\0\x04\0\0\0\x06\x05\0\0\xFC\x04\0\09\0\x07\0\x04\0\0\0\x07\x05\0\0\xC1\x04\0\0\x06\x05\0\0\xF5\x04\0\0\xF6\x04\0\0>\0\x03\0\xFC\x04\0\0\x07\x05\0\0=\0\x04\0\x04\0\0\0\x08\x05\0\0\xFC\x04\0\09\0\x07\0\x04\0\0\0\t\x05\0\0\xC1\x04\0\0\x08\x05\0\0\xF6\x04\0\0\xF4\x04\0\0>\0\x03\0\xFC\x04\0\0\t\x05\0\0\xF9\0\x02\0\n\x05\0\0\xF8\0\x02\0\n\x05\0\0\xF6\0\x04\0\x0B\x05\0\0\r\x05\0\0\0\0\0\0\xF9\0\x02\0\x0C\x05\0\0\xF8\0\x02\0\x0C\x05\0\0=\0\x04\0\x07\0\0\0\x0E\x05\0\0\xFD\x04\0\0\xB0\0\x05\0\r\0\0\0\x0F\x05\0\0\x0E\x05\0\0\x8C\0\0\0\xF7\0\x03\0\x10\x05\0\0\0\0\0\0\xFA\0\x04\0\x0F\x05\0\0\x10\x05\0\0\x11\x05\0\0\xF8\0\x02\0\x11\x05\0\0\xF9\0\x02\0\x0B\x05\0\0\xF8\0\x02\0\x10\x05\0\0\xF9\0\x02\0\x12\x05\0\0\xF8\0\x02\0\x12\x05\0\0Q\0\x05\0\x03\0\0\0\x14\x05\0\0\x03\x05\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\x15\x05\0\0\x03\x05\0\0\x01\0\0\0P\0\x07\0\x04\0\0\0\x16\x05\0\0c\x02\0\0\x14\x05\0\0 \0\0\0\x15\x05\0\0=\0\x04\0\x07\0\0\0\x17\x05\0\0\xFD\x04\0\09\0\x06\0\x08\0\0\0\x18\x05\0\0\xE1\x03\0\0\x16\x05\0\0\x17\x05\0\09\0\x08\0\x12\0\0\0\x19\x05\0\0H\x02\0\0\xF4\x04\0\0\xF5\x04\0\0\xF6\x04\0\0\x18\x05\0\0Q\0\x05\0\x03\0\0\0\x1A\x05\0\0\xF4\x04\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\x1B\x05\0\0\xF5\x04\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\x1C\x05\0\0\xF6\x04\0\0\x03\0\0\0P\0\x06\0\x12\0\0\0\x1D\x05\0\0\x1A\x05\0\0\x1B\x05\0\0\x1C\x05\0\0\x94\0\x05\0\x03\0\0\0\x1E\x05\0\0\x19\x05\0\0\x1D\x05\0\0\x0C\0\x06\0\x03\0\0\0\x1F\x05\0\0\x01\0\0\0\x06\0\0\0\x1E\x05\0\0\xB6\0\x05\0\r\0\0\0 \x05\0\0\x1F\x05\0\0}\0\0\0\xF7\0\x03\0!\x05\0\0\0\0\0\0\xFA\0\x04\0 \x05\0\0\"\x05\0\0#\x05\0\0\xF8\0\x02\0\"\x05\0\0\x8E\0\x05\0\x12\0\0\0$\x05\0\0\x19\x05\0\0\x1F\x05\0\0\xBE\0\x05\0\xC6\x01\0\0%\x05\0\0$\x05\0\0\xB0\x01\0\0\x9B\0\x04\0\r\0\0\0&\x05\0\0%\x05\0\0>\0\x03\0\xFF\x04\0\0&\x05\0\0\xF9\0\x02\0!\x05\0\0\xF8\0\x02\0#\x05\0\0>\0\x03\0\xFF\x04\0\0{\x01\0\0\xF9\0\x02\0!\x05\0\0\xF8\0\x02\0!\x05\0\0=\0\x04\0\r\0\0\0'\x05\0\0\xFF\x04\0\0\xF7\0\x03\0(\x05\0\0\0\0\0\0\xFA\0\x04\0'\x05\0\0)\x05\0\0(\x05\0\0\xF8\0\x02\0)\x05\0\0=\0\x04\0\x04\0\0\0*\x05\0\0\xFC\x04\0\09\0\x06\0\x04\0\0\0+\x05\0\0\x92\x03\0\0*\x05\0\0\x18\x05\0\0>\0\x03\0\xFC\x04\0\0+\x05\0\0\xF9\0\x02\0(\x05\0\0\xF8\0\x02\0(\x05\0\0\xF9\0\x02\0\x13\x05\0\0\xF8\0\x02\0\x13\x05\0\0\xF9\0\x02\0\r\x05\0\0\xF8\0\x02\0\r\x05\0\0=\0\x04\0\x07\0\0\0,\x05\0\0\xFD\x04\0\0\x80\0\x05\0\x07\0\0\0-\x05\0\0,\x05\0\0\x91\0\0\0>\0\x03\0\xFD\x04\0\0-\x05\0\0\xF9\0\x02\0\n\x05\0\0\xF8\0\x02\0\x0B\x05\0\0A\0\x05\0\x8B\0\0\0.\x05\0\0\xF8\x04\0\0\x8C\0\0\0=\0\x04\0\x05\0\0\0/\x05\0\0.\x05\0\0A\0\x05\x000\x05\0\x001\x05\0\0\xFC\x04\0\0\x91\0\0\0=\0\x04\0\x03\0\0\x002\x05\0\x001\x05\0\09\0\x06\0\x03\0\0\x003\x05\0\x006\0\0\0/\x05\0\x002\x05\0\0A\0\x05\0\x8B\0\0\x004\x05\0\0\xF8\x04\0\0\x8C\0\0\0=\0\x04\0\x05\0\0\x005\x05\0\x004\x05\0\0A\0\x05\x000\x05\0\x006\x05\0\0\xFC\x04\0\0\xD8\0\0\0=\0\x04\0\x03\0\0\x007\x05\0\x006\x05\0\09\0\x06\0\x03\0\0\08\x05\0\x006\0\0\x005\x05\0\x007\x05\0\0A\0\x05\0\x04\x02\0\09\x05\0\0\xF8\x04\0\0\x05\x02\0\0=\0\x04\0\x08\0\0\0:\x05\0\09\x05\0\0A\0\x05\0\x04\x02\0\0;\x05\0\0\xF8\x04\0\0\x05\x02\0\0=\0\x04\0\x08\0\0\0<\x05\0\0;\x05\0\0P\0\x05\0\x04\0\0\0=\x05\0\0:\x05\0\0<\x05\0\0\x8E\0\x05\0\x04\0\0\0>\x05\0\0=\x05\0\0\x1F\0\0\0A\0\x05\x000\x05\0\0?\x05\0\0\xFC\x04\0\0\x88\0\0\0=\0\x04\0\x03\0\0\0@\x05\0\0?\x05\0\0\x0C\0\x07\0\x03\0\0\0A\x05\0\0\x01\0\0\0%\0\0\x003\x05\0\08\x05\0\0A\0\x05\x000\x05\0\0B\x05\0\0\xFC\x04\0\0\x06\0\0\0=\0\x04\0\x03\0\0\0C\x05\0\0B\x05\0\0\x0C\0\x07\0\x03\0\0\0D\x05\0\0\x01\0\0\0(\0\0\x003\x05\0\08\x05\0\0P\0\x07\0\x04\0\0\0E\x05\0\0@\x05\0\0A\x05\0\0C\x05\0\0D\x05\0\0\x85\0\x05\0\x04\0\0\0F\x05\0\0E\x05\0\0>\x05\0\0\x81\0\x05\0\x04\0\0\0G\x05\0\0F\x05\0\0\xFB\x04\0\0=\0\x04\0\x04\0\0\0H\x05\0\0\xFC\x04\0\0A\0\x05\x000\x05\0\0I\x05\0\0\xFC\x04\0\0\x88\0\0\0=\0\x04\0\x03\0\0\0J\x05\0\0I\x05\0\0A\0\x05\x000\x05\0\0K\x05\0\0\xFC\x04\0\0\x06\0\0\0=\0\x04\0\x03\0\0\0L\x05\0\0K\x05\0\0\xBA\0\x05\0\r\0\0\0M\x05\0\0J\x05\0\0L\x05\0\0P\0\x07\0\xCC\x04\0\0N\x05\0\0M\x05\0\0M\x05\0\0M\x05\0\0M\x05\0\0\xA9\0\x06\0\x04\0\0\0O\x05\0\0N\x05\0\0H\x05\0\0G\x05\0\0\xFE\0\x02\0O\x05\0\08\0\x01\x006\0\x05\0\x04\0\0\0U\x05\0\0\0\0\0\0V\x05\0\x007\0\x03\0\x04\0\0\0Q\x05\0\x007\0\x03\0\x04\0\0\0R\x05\0\x007\0\x03\0\x04\0\0\0S\x05\0\x007\0\x03\0\x07\0\0\0T\x05\0\0\xF8\0\x02\0P\x05\0\0;\0\x05\0}\x01\0\0X\x05\0\0\x07\0\0\0Y\x05\0\0;\0\x05\0}\x01\0\0Z\x05\0\0\x07\0\0\0[\x05\0\0;\0\x05\0}\x01\0\0\\\x05\0\0\x07\0\0\0]\x05\0\0A\0\x05\0\x87\0\0\0W\x05\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0^\x05\0\0\xF8\0\x02\0^\x05\0\09\0\x05\0\r\0\0\0_\x05\0\0x\x01\0\0Q\x05\0\0\xF7\0\x03\0`\x05\0\0\0\0\0\0\xFA\0\x04\0_\x05\0\0a\x05\0\0b\x05\0\0\xF8\0\x02\0a\x05\0\09\0\x05\0\r\0\0\0c\x05\0\0x\x01\0\0R\x05\0\0>\0\x03\0X\x05\0\0c\x05\0\0\xF9\0\x02\0`\x05\0\0\xF8\0\x02\0b\x05\0\0>\0\x03\0X\x05\0\0{\x01\0\0\xF9\0\x02\0`\x05\0\0\xF8\0\x02\0`\x05\0\0=\0\x04\0\r\0\0\0d\x05\0\0X\x05\0\0\xF7\0\x03\0e\x05\0\0\0\0\0\0\xFA\0\x04\0d\x05\0\0f\x05\0\0g\x05\0\0\xF8\0\x02\0f\x05\0\09\0\x05\0\r\0\0\0h\x05\0\0x\x01\0\0S\x05\0\0>\0\x03\0Z\x05\0\0h\x05\0\0\xF9\0\x02\0e\x05\0\0\xF8\0\x02\0g\x05\0\0>\0\x03\0Z\x05\0\0{\x01\0\0\xF9\0\x02\0e\x05\0\0\xF8\0\x02\0e\x05\0\0=\0\x04\0\r\0\0\0i\x05\0\0Z\x05\0\0\xF7\0\x03\0j\x05\0\0\0\0\0\0\xFA\0\x04\0i\x05\0\0k\x05\0\0j\x05\0\0\xF8\0\x02\0k\x05\0\09\0\x08\0\x08\0\0\0l\x05\0\0_\x04\0\0Q\x05\0\0R\x05\0\0S\x05\0\0T\x05\0\09\0\x05\0\x04\0\0\0m\x05\0\0r\x03\0\0l\x05\0\0\xFE\0\x02\0m\x05\0\0\xF8\0\x02\0j\x05\0\09\0\x07\0\x04\0\0\0n\x05\0\0\xF7\x04\0\0Q\x05\0\0R\x05\0\0S\x05\0\0Q\0\x05\0\x03\0\0\0o\x05\0\0n\x05\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0p\x05\0\0n\x05\0\0\x02\0\0\0\xBC\0\x05\0\r\0\0\0q\x05\0\0o\x05\0\0p\x05\0\0\xF7\0\x03\0r\x05\0\0\0\0\0\0\xFA\0\x04\0q\x05\0\0s\x05\0\0t\x05\0\0\xF8\0\x02\0s\x05\0\0Q\0\x05\0\x03\0\0\0u\x05\0\0n\x05\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0v\x05\0\0n\x05\0\0\x03\0\0\0\xBC\0\x05\0\r\0\0\0w\x05\0\0u\x05\0\0v\x05\0\0>\0\x03\0\\\x05\0\0w\x05\0\0\xF9\0\x02\0r\x05\0\0\xF8\0\x02\0t\x05\0\0>\0\x03\0\\\x05\0\0{\x01\0\0\xF9\0\x02\0r\x05\0\0\xF8\0\x02\0r\x05\0\0=\0\x04\0\r\0\0\0x\x05\0\0\\\x05\0\0\xA8\0\x04\0\r\0\0\0y\x05\0\0x\x05\0\0\xF7\0\x03\0z\x05\0\0\0\0\0\0\xFA\0\x04\0y\x05\0\0{\x05\0\0z\x05\0\0\xF8\0\x02\0{\x05\0\0\xFE\0\x02\0!\0\0\0\xF8\0\x02\0z\x05\0\09\0\x06\0\x08\0\0\0|\x05\0\0\xE1\x03\0\0n\x05\0\0T\x05\0\09\0\x05\0\x04\0\0\0}\x05\0\0r\x03\0\0|\x05\0\0\xFE\0\x02\0}\x05\0\08\0\x01\x006\0\x05\0\x02\0\0\0\x90\x05\0\0\0\0\0\0\x91\x05\0\0\xF8\0\x02\0~\x05\0\0;\0\x05\0}\x01\0\0\x97\x05\0\0\x07\0\0\0\x98\x05\0\0;\0\x05\0}\x01\0\0\x99\x05\0\0\x07\0\0\0\x9A\x05\0\0=\0\x04\0\x07\0\0\0\x82\x05\0\0\x80\x05\0\0=\0\x04\0\x04\0\0\0\x85\x05\0\0\x83\x05\0\0=\0\x04\0\x04\0\0\0\x87\x05\0\0\x86\x05\0\0=\0\x04\0\x04\0\0\0\x89\x05\0\0\x88\x05\0\0P\0\x07\0\x0F\0\0\0\x7F\x05\0\0\x82\x05\0\0\x85\x05\0\0\x87\x05\0\0\x89\x05\0\0A\0\x05\0\x87\0\0\0\x92\x05\0\0'\0\0\0\x88\0\0\0A\0\x05\0\xCD\0\0\0\x93\x05\0\0*\0\0\0\x88\0\0\0A\0\x05\0\xCF\0\0\0\x94\x05\0\0-\0\0\0\x88\0\0\0A\0\x05\0\xCF\0\0\0\x95\x05\0\x000\0\0\0\x88\0\0\0\xF9\0\x02\0\x9B\x05\0\0\xF8\0\x02\0\x9B\x05\0\0Q\0\x05\0\x07\0\0\0\x9C\x05\0\0\x7F\x05\0\0\0\0\0\09\0\x05\0\x07\0\0\0\x9D\x05\0\0a\x03\0\0\x9C\x05\0\09\0\x06\0\x04\0\0\0\x9E\x05\0\0B\x01\0\0\x7F\x05\0\0\x9D\x05\0\09\0\x05\0\x04\0\0\0\x9F\x05\0\0e\x01\0\0\x9E\x05\0\0\x80\0\x05\0\x07\0\0\0\xA0\x05\0\0\x9D\x05\0\0\x91\0\0\09\0\x06\0\x04\0\0\0\xA1\x05\0\0B\x01\0\0\x7F\x05\0\0\xA0\x05\0\09\0\x05\0\x04\0\0\0\xA2\x05\0\0e\x01\0\0\xA1\x05\0\0\x80\0\x05\0\x07\0\0\0\xA3\x05\0\0\x9D\x05\0\0\x06\0\0\09\0\x06\0\x04\0\0\0\xA4\x05\0\0B\x01\0\0\x7F\x05\0\0\xA3\x05\0\09\0\x05\0\x04\0\0\0\xA5\x05\0\0e\x01\0\0\xA4\x05\0\09\0\x04\0\r\0\0\0\xA6\x05\0\0\x98\0\0\0\xA8\0\x04\0\r\0\0\0\xA7\x05\0\0\xA6\x05\0\0\xA8\0\x04\0\r\0\0\0\xA8\x05\0\0\xA7\x05\0\0\xF7\0\x03\0\xA9\x05\0\0\0\0\0\0\xFA\0\x04\0\xA8\x05\0\0\xAA\x05\0\0\xAB\x05\0\0\xF8\0\x02\0\xAA\x05\0\09\0\x07\0\x03\0\0\0\xAC\x05\0\0\x11\x02\0\0\x9F\x05\0\0\xA2\x05\0\0\xA5\x05\0\0\xBC\0\x05\0\r\0\0\0\xAD\x05\0\0\xAC\x05\0\0\x96\x05\0\0>\0\x03\0\x97\x05\0\0\xAD\x05\0\0\xF9\0\x02\0\xA9\x05\0\0\xF8\0\x02\0\xAB\x05\0\0>\0\x03\0\x97\x05\0\0\xAF\x01\0\0\xF9\0\x02\0\xA9\x05\0\0\xF8\0\x02\0\xA9\x05\0\0=\0\x04\0\r\0\0\0\xAE\x05\0\0\x97\x05\0\0\xA8\0\x04\0\r\0\0\0\xAF\x05\0\0\xAE\x05\0\0\xF7\0\x03\0\xB0\x05\0\0\0\0\0\0\xFA\0\x04\0\xAF\x05\0\0\xB1\x05\0\0\xB2\x05\0\0\xF8\0\x02\0\xB1\x05\0\09\0\x07\0\r\0\0\0\xB3\x05\0\0\xAC\x01\0\0\x9F\x05\0\0\xA2\x05\0\0\xA5\x05\0\0>\0\x03\0\x99\x05\0\0\xB3\x05\0\0\xF9\0\x02\0\xB0\x05\0\0\xF8\0\x02\0\xB2\x05\0\0>\0\x03\0\x99\x05\0\0\xAF\x01\0\0\xF9\0\x02\0\xB0\x05\0\0\xF8\0\x02\0\xB0\x05\0\0=\0\x04\0\r\0\0\0\xB4\x05\0\0\x99\x05\0\0\xF7\0\x03\0\xB5\x05\0\0\0\0\0\0\xFA\0\x04\0\xB4\x05\0\0\xB6\x05\0\0\xB5\x05\0\0\xF8\0\x02\0\xB6\x05\0\0P\0\x08\0\x15\0\0\0\xB7\x05\0\0!\0\0\0\x9F\x05\0\0\xA2\x05\0\0\xA5\x05\0\0\x06\x04\0\0Q\0\x05\0\x04\0\0\0\xB8\x05\0\0\xB7\x05\0\0\0\0\0\0>\0\x03\0\x8A\x05\0\0\xB8\x05\0\0Q\0\x05\0\x04\0\0\0\xB9\x05\0\0\xB7\x05\0\0\x01\0\0\0>\0\x03\0\x8C\x05\0\0\xB9\x05\0\0Q\0\x05\0\x04\0\0\0\xBA\x05\0\0\xB7\x05\0\0\x02\0\0\0>\0\x03\0\x8D\x05\0\0\xBA\x05\0\0Q\0\x05\0\x04\0\0\0\xBB\x05\0\0\xB7\x05\0\0\x03\0\0\0>\0\x03\0\x8E\x05\0\0\xBB\x05\0\0Q\0\x05\0\x04\0\0\0\xBC\x05\0\0\xB7\x05\0\0\x04\0\0\0>\0\x03\0\x8F\x05\0\0\xBC\x05\0\0\xFD\0\x01\0\xF8\0\x02\0\xB5\x05\0\09\0\x07\0\x13\0\0\0\xBD\x05\0\0L\x03\0\0\x9F\x05\0\0\xA2\x05\0\0\xA5\x05\0\0Q\0\x05\0\x07\0\0\0\xBE\x05\0\0\x7F\x05\0\0\0\0\0\09\0\x05\0\x07\0\0\0\xBF\x05\0\0h\x03\0\0\xBE\x05\0\09\0\x08\0\x04\0\0\0\xC0\x05\0\0U\x05\0\0\x9F\x05\0\0\xA2\x05\0\0\xA5\x05\0\0\xBF\x05\0\0Q\0\x05\0\x04\0\0\0\xC1\x05\0\0\xBD\x05\0\0\x03\0\0\0P\0\x08\0\x15\0\0\0\xC2\x05\0\0\xC0\x05\0\0\x9F\x05\0\0\xA2\x05\0\0\xA5\x05\0\0\xC1\x05\0\0Q\0\x05\0\x04\0\0\0\xC3\x05\0\0\xC2\x05\0\0\0\0\0\0>\0\x03\0\x8A\x05\0\0\xC3\x05\0\0Q\0\x05\0\x04\0\0\0\xC4\x05\0\0\xC2\x05\0\0\x01\0\0\0>\0\x03\0\x8C\x05\0\0\xC4\x05\0\0Q\0\x05\0\x04\0\0\0\xC5\x05\0\0\xC2\x05\0\0\x02\0\0\0>\0\x03\0\x8D\x05\0\0\xC5\x05\0\0Q\0\x05\0\x04\0\0\0\xC6\x05\0\0\xC2\x05\0\0\x03\0\0\0>\0\x03\0\x8E\x05\0\0\xC6\x05\0\0Q\0\x05\0\x04\0\0\0\xC7\x05\0\0\xC2\x05\0\0\x04\0\0\0>\0\x03\0\x8F\x05\0\0\xC7\x05\0\0\xFD\0\x01\08\0\x01\x006\0\x05\0\x02\0\0\0\xD6\x05\0\0\0\0\0\0\x91\x05\0\0\xF8\0\x02\0\xC8\x05\0\0=\0\x04\0\x04\0\0\0\xCB\x05\0\0\xCA\x05\0\0=\0\x04\0\x04\0\0\0\xCD\x05\0\0\xCC\x05\0\0=\0\x04\0\x04\0\0\0\xCF\x05\0\0\xCE\x05\0\0=\0\x04\0\x04\0\0\0\xD1\x05\0\0\xD0\x05\0\0=\0\x04\0\x04\0\0\0\xD3\x05\0\0\xD2\x05\0\0P\0\x08\0\x15\0\0\0\xC9\x05\0\0\xCB\x05\0\0\xCD\x05\0\0\xCF\x05\0\0\xD1\x05\0\0\xD3\x05\0\0A\0\x05\0\x87\0\0\0\xD7\x05\0\0'\0\0\0\x88\0\0\0\xF9\0\x02\0\xD8\x05\0\0\xF8\0\x02\0\xD8\x05\0\0Q\0\x05\0\x04\0\0\0\xD9\x05\0\0\xC9\x05\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\0\xDA\x05\0\0\xC9\x05\0\0\x02\0\0\0Q\0\x05\0\x04\0\0\0\xDB\x05\0\0\xC9\x05\0\0\x03\0\0\0Q\0\x05\0\x04\0\0\0\xDC\x05\0\0\xC9\x05\0\0\x04\0\0\0P\0\x07\0\x13\0\0\0\xDD\x05\0\0\xD9\x05\0\0\xDA\x05\0\0\xDB\x05\0\0\xDC\x05\0\0Q\0\x05\0\x04\0\0\0\xDE\x05\0\0\xC9\x05\0\0\0\0\0\0O\0\x07\0\x08\0\0\0\xDF\x05\0\0\xDE\x05\0\0\xDE\x05\0\0\0\0\0\0\x01\0\0\09\0\x06\0\x04\0\0\0\xE0\x05\0\0^\x02\0\0\xDD\x05\0\0\xDF\x05\0\0Q\0\x05\0\x03\0\0\0\xE1\x05\0\0\xE0\x05\0\0\x03\0\0\0\xB8\0\x05\0\r\0\0\0\xE2\x05\0\0\xE1\x05\0\0}\0\0\0\xF7\0\x03\0\xE3\x05\0\0\0\0\0\0\xFA\0\x04\0\xE2\x05\0\0\xE4\x05\0\0\xE3\x05\0\0\xF8\0\x02\0\xE4\x05\0\0\xFC\0\x01\0\xF8\0\x02\0\xE3\x05\0\0O\0\x08\0\x12\0\0\0\xE5\x05\0\0\xE0\x05\0\0\xE0\x05\0\0\0\0\0\0\x01\0\0\0\x02\0\0\09\0\x06\0\x03\0\0\0\xE6\x05\0\0\xCE\x02\0\0\xDD\x05\0\0\xE5\x05\0\0>\0\x03\0\xD4\x05\0\0\xE6\x05\0\0\xFD\0\x01\08\0\x01\0";
    /// WGSL of the mask shader.
    pub const MASK_WGSL: &str = r#"// SunLog: turns the view's depth into a visibility mask.
// Positions and normals are relative to the eye, in camera axes: x right, y up, looking along -z.
// Sun over an open world without a step: face columns whose rows run with the logarithm of distance, casters that
// span many rows decided pixel by pixel.
// Generated from light case `SunLog`, ed72eb4d5233de5a. Do not edit.

/// Width and height of the map in texels.
const SUN_LOG_MAP_SIZE: vec2<f32> = vec2<f32>(2048.0, 2048.0);
/// Sectors around the eye.
const SUN_LOG_SECTORS: u32 = 4u;
/// Bands of distance in each sector.
const SUN_LOG_BANDS: u32 = 8u;
/// Vectors of four band limits in each sector.
const SUN_LOG_THRESHOLD_VECTORS: u32 = 2u;
/// Texels along the rows that edges of casters may be off.
const SUN_LOG_STRETCH_BOUND: f32 = 0.25;

/// What resolving needs of one facet; all zero where a plan has none.
struct SunLogFacet {
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
    /// How y/w becomes clip y: shifts and scales of a monotone curve.
    remap: array<vec4<f32>, 2>,
}

/// What resolving needs of a plan.
struct SunLogShadow {
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
    facets: array<SunLogFacet, 32>,
}

/// What the mask pass needs of the view.
struct SunLogMask {
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
var<uniform> sun_log_mask: SunLogMask;
/// The engine's depth, reversed-z.
@group(0) @binding(1)
var sun_log_scene_depth: texture_depth_2d;
/// The plan.
@group(1) @binding(0)
var<uniform> sun_log_shadow: SunLogShadow;
/// The shadow map.
@group(1) @binding(1)
var sun_log_map: texture_depth_2d;
/// Takes the nearest texel, clamps to the edge.
@group(1) @binding(2)
var sun_log_map_sampler: sampler;

/// Clip y after division, of one over distance.
fn sun_log_remapped(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].y + remap[1].z * inverse_distance;
    }
    return remap[0].x + remap[0].y * log(inverse_distance * remap[0].z);
}

/// Change of clip y after division per change of one over distance.
fn sun_log_remap_slope(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].z;
    }
    return remap[0].y / inverse_distance;
}

/// Two to the power of -23: the last bit of a float's mantissa.
const SUN_LOG_LAST_BIT: f32 = 1.1920928955078125e-7;

/// The position as facet rows take it: moved along the light to the plane z = 0, z kept.
///
/// What is added may cancel the position nearly, so its products must not be rounded, and a fused multiplication is not
/// to be had everywhere. The leading parts of the shear have twelve bits; so have both halves of z. The lower half is
/// taken as a whole number, from which no compiler finds the way back to one rounded product.
fn sun_log_facet_position(position: vec3<f32>) -> vec3<f32> {
    // Split z.
    let bits = bitcast<u32>(position.z);
    let upper = bitcast<f32>(bits & 0xfffff000u);
    let lower = f32(bits & 0xfffu);
    let step = bitcast<f32>(bits & 0xff800000u) * SUN_LOG_LAST_BIT;

    // Add the largest product first: each sum is exact while it cancels.
    var moved = position.xy + sun_log_shadow.shear.xy * upper;
    moved += (sun_log_shadow.shear.xy * step) * lower;
    moved += sun_log_shadow.shear.zw * position.z;
    return vec3<f32>(moved, position.z);
}

/// The normal as facet rows take it.
fn sun_log_facet_normal(normal: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(normal.xy, normal.z - dot(sun_log_shadow.shear.xy + sun_log_shadow.shear.zw, normal.xy));
}

/// Finds the sector of a receiver: its first border decides the direction, then each border is passed or not.
fn sun_log_sector_index(position: vec3<f32>) -> u32 {
    let point = vec4<f32>(position, 1.0);

    // Walk forwards from the ring's start up to the first border that is not passed, and backwards from its end down to
    // the first that is: both at once, without a branch.
    var is_ahead = 1u;
    var forwards = 0u;
    var backwards = 0u;
    for (var border = 1u; border < SUN_LOG_SECTORS; border += 1u) {
        let is_passed = dot(sun_log_shadow.borders[border], point) >= 0.0;
        is_ahead = select(0u, is_ahead, is_passed);
        forwards += is_ahead;
        backwards = select(backwards, border, is_passed);
    }
    return select(backwards, forwards, dot(sun_log_shadow.borders[0], point) >= 0.0);
}

/// Finds the facet of a receiver: its sector, then the number of that sector's thresholds that its distance has
/// reached.
fn sun_log_facet_index(position: vec3<f32>) -> u32 {
    let sector = sun_log_sector_index(position);
    let distance = dot(sun_log_shadow.distances[sector], vec4<f32>(position, 1.0));
    var reached = vec4<u32>(0u);
    for (var index = 0u; index < SUN_LOG_THRESHOLD_VECTORS; index += 1u) {
        let limits = sun_log_shadow.thresholds[sector * SUN_LOG_THRESHOLD_VECTORS + index];
        reached += select(vec4<u32>(0u), vec4<u32>(1u), vec4<f32>(distance) >= limits);
    }
    return sector * SUN_LOG_BANDS + min(reached.x + reached.y + reached.z + reached.w, SUN_LOG_BANDS - 1u);
}

/// The facet of a receiver.
fn sun_log_own_facet(position: vec3<f32>) -> SunLogFacet {
    return sun_log_shadow.facets[sun_log_facet_index(position)];
}

/// Where a receiver falls in its facet.
struct SunLogPlace {
    /// Clip space of the tile after division: x and y in [-1, 1], z growing away from the light.
    ndc: vec3<f32>,
    /// What was divided by.
    w: f32,
    /// What the remap took to y: one over distance in metres.
    inverse_distance: f32,
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Whether every texel that a filter takes here belongs to the tile.
    covered: bool,
}

/// Applies a facet's matrix, row by row, to a position relative to the eye.
fn sun_log_place_in_facet(facet: SunLogFacet, position: vec3<f32>) -> SunLogPlace {
    let point = vec4<f32>(position, 1.0);
    let w = dot(facet.row_w, point);
    let clip = vec3<f32>(dot(facet.row_x, point), dot(facet.row_y, point), dot(facet.row_z, point));
    let straight = clip / w;
    let ndc = vec3<f32>(straight.x, sun_log_remapped(facet.remap, straight.y), straight.z);
    let texel = ndc.xy * facet.texel_from_ndc.xy + facet.texel_from_ndc.zw;

    // Facets without receivers are all zero, so w refuses them.
    let inside = all(texel >= facet.texel_limits.xy) && all(texel <= facet.texel_limits.zw);
    return SunLogPlace(ndc, w, straight.y, texel, w > 0.0 && inside);
}

/// The nearest signed depth that the map can hold.
fn sun_log_held_depth(depth: f32) -> f32 {
    return clamp(depth, min(sun_log_shadow.depth_sign, 0.0), max(sun_log_shadow.depth_sign, 0.0));
}

/// Share of light that each of four stored depths lets through to its signed reference: all or none.
fn sun_log_lit_by_four(references: vec4<f32>, stored: vec4<f32>) -> vec4<f32> {
    return select(vec4<f32>(0.0), vec4<f32>(1.0), references <= sun_log_shadow.depth_sign * stored);
}

/// A receiver in the map, with its plane.
struct SunLogReceiver {
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Depth of the lowered plane at the receiver itself.
    reference: f32,
    /// Change of the plane's depth per texel along x and y.
    gradient: vec2<f32>,
}

/// Depth of the receiver's plane at an offset in texels, within the depths that the map can hold.
fn sun_log_plane_reference(receiver: SunLogReceiver, offset: vec2<f32>) -> f32 {
    return sun_log_held_depth(receiver.reference + dot(receiver.gradient, offset));
}

/// Gradient of clip y after division, times w.
fn sun_log_up_gradient(facet: SunLogFacet, place: SunLogPlace) -> vec3<f32> {
    let straight = facet.row_y.xyz - place.inverse_distance * facet.row_w.xyz;
    return straight * sun_log_remap_slope(facet.remap, place.inverse_distance);
}

/// Largest change of depth from one texel to the next that a plane is followed to: the map's whole range.
const SUN_LOG_STEEPEST_PLANE: f32 = 1.0;

/// Change of depth per texel along x and y over the plane through a receiver; a normal of any length will do.
fn sun_log_plane_gradient(facet: SunLogFacet, place: SunLogPlace, normal: vec3<f32>) -> vec2<f32> {
    // Take the gradients of the facet's coordinates; their common factor 1/w cancels below.
    let across = facet.row_x.xyz - place.ndc.x * facet.row_w.xyz;
    let up = sun_log_up_gradient(facet, place);
    let away = facet.row_z.xyz - place.ndc.z * facet.row_w.xyz;

    // Solve for the depth that x and y change by while the point stays on the plane.
    let area = dot(normal, cross(across, up));
    let slope = vec2<f32>(dot(away, cross(up, normal)), dot(away, cross(normal, across)));

    // Turn it into depth per texel; a plane that the light only grazes is as steep as the map allows.
    let exact = slope / (area * facet.texel_from_ndc.xy);
    let followed = clamp(exact, vec2<f32>(-SUN_LOG_STEEPEST_PLANE), vec2<f32>(SUN_LOG_STEEPEST_PLANE));
    return select(followed, vec2<f32>(0.0), area == 0.0);
}

/// The receiver with the plane through it; a normal of any length will do.
fn sun_log_biased_receiver(facet: SunLogFacet, place: SunLogPlace, normal: vec3<f32>) -> SunLogReceiver {
    let gradient = sun_log_plane_gradient(facet, place, normal);
    let lowered = facet.receiver_plane_depth + SUN_LOG_STRETCH_BOUND * abs(gradient.y);
    return SunLogReceiver(place.texel, place.ndc.z - lowered, gradient);
}

/// Share of light that reaches the receiver.
fn sun_log_filtered_visibility(receiver: SunLogReceiver) -> f32 {
    // Gather around the corner that the four texels share: rounding cannot reach another four from there.
    let corner = floor(receiver.texel - 0.5) + 1.0;
    let stored = textureGather(sun_log_map, sun_log_map_sampler, corner / SUN_LOG_MAP_SIZE);

    // Follow the plane to each centre; a gather begins at the lower left and runs against the clock.
    let offset = corner - receiver.texel;
    let references = vec4<f32>(
        sun_log_plane_reference(receiver, offset + vec2<f32>(-0.5, 0.5)),
        sun_log_plane_reference(receiver, offset + vec2<f32>(0.5, 0.5)),
        sun_log_plane_reference(receiver, offset + vec2<f32>(0.5, -0.5)),
        sun_log_plane_reference(receiver, offset + vec2<f32>(-0.5, -0.5)),
    );

    // Compare, then blend.
    let lit = sun_log_lit_by_four(references, stored);
    let weight = vec2<f32>(0.5) - offset;
    return mix(mix(lit.w, lit.z, weight.x), mix(lit.x, lit.y, weight.x), weight.y);
}

/// Share of the light that reaches a receiver: 1 in the light and outside the map, 0 in shadow.
///
/// `position` is relative to the eye, in metres; `normal` is the geometric normal there; both are in the case's axes.
/// The function takes no derivatives, so any control flow may call it.
fn sun_log_visibility(position: vec3<f32>, normal: vec3<f32>) -> f32 {
    let point = sun_log_facet_position(position);
    let facet = sun_log_own_facet(point);
    let place = sun_log_place_in_facet(facet, point);
    if !place.covered {
        return 1.0;
    }
    return sun_log_filtered_visibility(sun_log_biased_receiver(facet, place, sun_log_facet_normal(normal)));
}

/// One over the depth in metres at a pixel; 0 where nothing was drawn.
fn sun_log_inverse_depth_at(pixel: vec2<i32>) -> f32 {
    let stored = textureLoad(sun_log_scene_depth, pixel, 0);
    return select(0.0, stored * sun_log_mask.inverse_depth.x + sun_log_mask.inverse_depth.y, stored > 0.0);
}

/// Direction of a pixel, relative to the eye, in the case's axes, with a depth of one metre.
fn sun_log_view_ray(pixel: vec2<f32>) -> vec3<f32> {
    let part = pixel / vec2<f32>(textureDimensions(sun_log_scene_depth));
    return sun_log_mask.ray_corner.xyz + sun_log_mask.ray_across.xyz * part.x + sun_log_mask.ray_down.xyz * part.y;
}

/// Change of one over depth per pixel along one axis of the image.
fn sun_log_inverse_depth_slope(pixel: vec2<i32>, axis: vec2<i32>, centre: f32) -> f32 {
    // Take two neighbours on either side; beyond the image's edge the nearest pixel stands in.
    let last = vec2<i32>(textureDimensions(sun_log_scene_depth)) - 1;
    let behind_near = sun_log_inverse_depth_at(max(pixel - axis, vec2<i32>(0)));
    let behind_far = sun_log_inverse_depth_at(max(pixel - 2 * axis, vec2<i32>(0)));
    let ahead_near = sun_log_inverse_depth_at(min(pixel + axis, last));
    let ahead_far = sun_log_inverse_depth_at(min(pixel + 2 * axis, last));

    // Prefer the side that predicts the centre better, unless the image ends there.
    let behind_error = abs(2.0 * behind_near - behind_far - centre);
    let ahead_error = abs(2.0 * ahead_near - ahead_far - centre);
    let behind_ends = any(pixel - 2 * axis < vec2<i32>(0));
    let ahead_ends = any(pixel + 2 * axis > last);
    let behind_is_better = !behind_ends && (ahead_ends || behind_error <= ahead_error);
    return select(ahead_near - centre, centre - behind_near, behind_is_better);
}

/// Unit normal of the surface behind a pixel, in the case's axes, on the side that faces the eye.
fn sun_log_reconstructed_normal(pixel: vec2<i32>, ray: vec3<f32>, inverse_depth: f32) -> vec3<f32> {
    // Measure how one over depth changes across the whole image and down it.
    let size = vec2<f32>(textureDimensions(sun_log_scene_depth));
    let across_slope = sun_log_inverse_depth_slope(pixel, vec2<i32>(1, 0), inverse_depth) * size.x;
    let down_slope = sun_log_inverse_depth_slope(pixel, vec2<i32>(0, 1), inverse_depth) * size.y;

    // Cross the two tangents of ray / inverse_depth; this sum is free of divisions.
    let across = sun_log_mask.ray_across.xyz;
    let down = sun_log_mask.ray_down.xyz;
    let level = inverse_depth * cross(across, down);
    let normal = level + across_slope * cross(down, ray) + down_slope * cross(ray, across);
    return normalize(select(normal, -normal, dot(normal, ray) > 0.0));
}

/// Covers the image with one triangle: corners (-1, 1), (-1, -3) and (3, 1).
@vertex
fn sun_log_mask_vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    let x = select(-1.0, 3.0, corner == 2u);
    let y = select(1.0, -3.0, corner == 1u);
    return vec4<f32>(x, y, 0.0, 1.0);
}

/// Writes the visibility of the surface behind a pixel to red; sky is lit.
@fragment
fn sun_log_mask_fragment(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
    let inverse_depth = sun_log_inverse_depth_at(vec2<i32>(pixel.xy));
    if inverse_depth <= 0.0 {
        return vec4<f32>(1.0, 0.0, 0.0, 1.0);
    }
    let ray = sun_log_view_ray(pixel.xy);
    let normal = sun_log_reconstructed_normal(vec2<i32>(pixel.xy), ray, inverse_depth);
    let lit = sun_log_visibility(ray / inverse_depth, normal);
    return vec4<f32>(lit, 0.0, 0.0, 1.0);
}
"#;
    /// SPIR-V of the mask shader, little-endian words.
    pub const MASK_SPIRV: &[u8] = b"\x03\x02#\x07\0\x03\x01\0\x1C\0\0\0\xC6\x02\0\0\0\0\0\0\x11\0\x02\0\x01\0\0\0\x11\0\x02\x002\0\0\0\x0B\0\x06\0\x01\0\0\0GLSL.std.450\0\0\0\0\x0E\0\x03\0\0\0\0\0\x01\0\0\0\x0F\0\n\0\0\0\0\0\x9A\x02\0\0sun_log_mask_vertex\0\x95\x02\0\0\x98\x02\0\0\x0F\0\x0B\0\x04\0\0\0\xA9\x02\0\0sun_log_mask_fragment\0\0\0\xA5\x02\0\0\xA8\x02\0\0\x10\0\x03\0\xA9\x02\0\0\x07\0\0\0G\0\x04\0\x07\0\0\0\x06\0\0\0\x10\0\0\0H\0\x05\0\t\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\t\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\t\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\t\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\t\0\0\0\x04\0\0\0#\0\0\0@\0\0\0H\0\x05\0\t\0\0\0\x05\0\0\0#\0\0\0P\0\0\0H\0\x05\0\t\0\0\0\x06\0\0\0#\0\0\0`\0\0\0H\0\x05\0\t\0\0\0\x07\0\0\0#\0\0\0p\0\0\0G\0\x04\0\n\0\0\0\x06\0\0\0\x10\0\0\0G\0\x04\0\x0C\0\0\0\x06\0\0\0\x10\0\0\0G\0\x04\0\x0E\0\0\0\x06\0\0\0\x90\0\0\0H\0\x05\0\x10\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x10\0\0\0\x01\0\0\0#\0\0\0@\0\0\0H\0\x05\0\x10\0\0\0\x02\0\0\0#\0\0\0\x80\0\0\0H\0\x05\0\x10\0\0\0\x03\0\0\0#\0\0\0\0\x01\0\0H\0\x05\0\x10\0\0\0\x04\0\0\0#\0\0\0\x10\x01\0\0H\0\x05\0\x10\0\0\0\x05\0\0\0#\0\0\0 \x01\0\0H\0\x05\0\x11\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x11\0\0\0\x01\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x11\0\0\0\x02\0\0\0#\0\0\0 \0\0\0H\0\x05\0\x11\0\0\0\x03\0\0\0#\0\0\x000\0\0\0H\0\x05\0\x17\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x17\0\0\0\x01\0\0\0#\0\0\0\x0C\0\0\0H\0\x05\0\x17\0\0\0\x02\0\0\0#\0\0\0\x10\0\0\0H\0\x05\0\x17\0\0\0\x03\0\0\0#\0\0\0\x18\0\0\0H\0\x05\0\x17\0\0\0\x04\0\0\0#\0\0\0 \0\0\0H\0\x05\0\x18\0\0\0\0\0\0\0#\0\0\0\0\0\0\0H\0\x05\0\x18\0\0\0\x01\0\0\0#\0\0\0\x08\0\0\0H\0\x05\0\x18\0\0\0\x02\0\0\0#\0\0\0\x10\0\0\0G\0\x04\0 \0\0\0\"\0\0\0\0\0\0\0G\0\x04\0 \0\0\0!\0\0\0\0\0\0\0G\0\x03\0!\0\0\0\x02\0\0\0H\0\x05\0!\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0#\0\0\0\"\0\0\0\0\0\0\0G\0\x04\0#\0\0\0!\0\0\0\x01\0\0\0G\0\x04\0%\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0%\0\0\0!\0\0\0\0\0\0\0G\0\x03\0&\0\0\0\x02\0\0\0H\0\x05\0&\0\0\0\0\0\0\0#\0\0\0\0\0\0\0G\0\x04\0(\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0(\0\0\0!\0\0\0\x01\0\0\0G\0\x04\0)\0\0\0\"\0\0\0\x01\0\0\0G\0\x04\0)\0\0\0!\0\0\0\x02\0\0\0G\0\x04\0\x95\x02\0\0\x0B\0\0\0*\0\0\0G\0\x04\0\x98\x02\0\0\x0B\0\0\0\0\0\0\0G\0\x04\0\xA5\x02\0\0\x0B\0\0\0\x0F\0\0\0G\0\x04\0\xA8\x02\0\0\x1E\0\0\0\0\0\0\0\x13\0\x02\0\x02\0\0\0\x16\0\x03\0\x03\0\0\0 \0\0\0\x17\0\x04\0\x04\0\0\0\x03\0\0\0\x02\0\0\0\x15\0\x04\0\x05\0\0\0 \0\0\0\0\0\0\0\x17\0\x04\0\x06\0\0\0\x03\0\0\0\x04\0\0\0+\0\x04\0\x05\0\0\0\x08\0\0\0\x02\0\0\0\x1C\0\x04\0\x07\0\0\0\x06\0\0\0\x08\0\0\0\x1E\0\n\0\t\0\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0\x03\0\0\0\x07\0\0\0+\0\x04\0\x05\0\0\0\x0B\0\0\0\x04\0\0\0\x1C\0\x04\0\n\0\0\0\x06\0\0\0\x0B\0\0\0+\0\x04\0\x05\0\0\0\r\0\0\0\x08\0\0\0\x1C\0\x04\0\x0C\0\0\0\x06\0\0\0\r\0\0\0+\0\x04\0\x05\0\0\0\x0F\0\0\0 \0\0\0\x1C\0\x04\0\x0E\0\0\0\t\0\0\0\x0F\0\0\0\x1E\0\x08\0\x10\0\0\0\n\0\0\0\n\0\0\0\x0C\0\0\0\x06\0\0\0\x03\0\0\0\x0E\0\0\0\x1E\0\x06\0\x11\0\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0\x04\0\0\0\x19\0\t\0\x12\0\0\0\x03\0\0\0\x01\0\0\0\x01\0\0\0\0\0\0\0\0\0\0\0\x01\0\0\0\0\0\0\0\x1A\0\x02\0\x13\0\0\0\x17\0\x04\0\x14\0\0\0\x03\0\0\0\x03\0\0\0\x14\0\x02\0\x15\0\0\0\x17\0\x04\0\x16\0\0\0\x05\0\0\0\x04\0\0\0\x1E\0\x07\0\x17\0\0\0\x14\0\0\0\x03\0\0\0\x03\0\0\0\x04\0\0\0\x15\0\0\0\x1E\0\x05\0\x18\0\0\0\x04\0\0\0\x03\0\0\0\x04\0\0\0\x15\0\x04\0\x1A\0\0\0 \0\0\0\x01\0\0\0\x17\0\x04\0\x19\0\0\0\x1A\0\0\0\x02\0\0\0+\0\x04\0\x03\0\0\0\x1B\0\0\0\0\0\0E,\0\x05\0\x04\0\0\0\x1C\0\0\0\x1B\0\0\0\x1B\0\0\0+\0\x04\0\x03\0\0\0\x1D\0\0\0\0\0\x80>+\0\x04\0\x03\0\0\0\x1E\0\0\0\0\0\x004+\0\x04\0\x03\0\0\0\x1F\0\0\0\0\0\x80?\x1E\0\x03\0!\0\0\0\x11\0\0\0 \0\x04\0\"\0\0\0\x02\0\0\0!\0\0\0;\0\x04\0\"\0\0\0 \0\0\0\x02\0\0\0 \0\x04\0$\0\0\0\0\0\0\0\x12\0\0\0;\0\x04\0$\0\0\0#\0\0\0\0\0\0\0\x1E\0\x03\0&\0\0\0\x10\0\0\0 \0\x04\0'\0\0\0\x02\0\0\0&\0\0\0;\0\x04\0'\0\0\0%\0\0\0\x02\0\0\0;\0\x04\0$\0\0\0(\0\0\0\0\0\0\0 \0\x04\0*\0\0\0\0\0\0\0\x13\0\0\0;\0\x04\0*\0\0\0)\0\0\0\0\0\0\0!\0\x05\0/\0\0\0\x03\0\0\0\x07\0\0\0\x03\0\0\0!\0\x04\0X\0\0\0\x14\0\0\0\x14\0\0\0 \0\x04\0Y\0\0\0\x02\0\0\0\x10\0\0\0+\0\x04\0\x05\0\0\0Z\0\0\0\0\0\0\0+\0\x04\0\x05\0\0\0\\\0\0\0\0\xF0\xFF\xFF+\0\x04\0\x05\0\0\0]\0\0\0\xFF\x0F\0\0+\0\x04\0\x05\0\0\0^\0\0\0\0\0\x80\xFF \0\x04\0`\0\0\0\x07\0\0\0\x04\0\0\0.\0\x03\0\x04\0\0\0a\0\0\0 \0\x04\0m\0\0\0\x02\0\0\0\x06\0\0\0+\0\x04\0\x05\0\0\0n\0\0\0\x03\0\0\0!\0\x04\0\x9A\0\0\0\x05\0\0\0\x14\0\0\0+\0\x04\0\x05\0\0\0\x9C\0\0\0\x01\0\0\0+\0\x04\0\x03\0\0\0\x9D\0\0\0\0\0\0\0 \0\x04\0\x9F\0\0\0\x07\0\0\0\x05\0\0\0 \0\x04\0\xAF\0\0\0\x02\0\0\0\n\0\0\0,\0\x07\0\x16\0\0\0\xCA\0\0\0Z\0\0\0Z\0\0\0Z\0\0\0Z\0\0\0,\0\x07\0\x16\0\0\0\xCB\0\0\0\x9C\0\0\0\x9C\0\0\0\x9C\0\0\0\x9C\0\0\0+\0\x04\0\x05\0\0\0\xCC\0\0\0\x07\0\0\0 \0\x04\0\xCE\0\0\0\x07\0\0\0\x16\0\0\0 \0\x04\0\xE0\0\0\0\x02\0\0\0\x0C\0\0\0\x17\0\x04\0\xE8\0\0\0\x15\0\0\0\x04\0\0\0!\0\x04\0\xFF\0\0\0\t\0\0\0\x14\0\0\0 \0\x04\0\x02\x01\0\0\x02\0\0\0\x0E\0\0\0 \0\x04\0\x04\x01\0\0\x02\0\0\0\t\0\0\0+\0\x04\0\x05\0\0\0\x05\x01\0\0\x05\0\0\0!\0\x05\0\x0C\x01\0\0\x17\0\0\0\t\0\0\0\x14\0\0\0*\0\x03\0\x15\0\0\0\r\x01\0\0 \0\x04\0\x0F\x01\0\0\x07\0\0\0\x15\0\0\0.\0\x03\0\x15\0\0\0\x10\x01\0\0.\0\x03\0\x15\0\0\0\x12\x01\0\0\x17\0\x04\0/\x01\0\0\x15\0\0\0\x02\0\0\0!\0\x04\0D\x01\0\0\x03\0\0\0\x03\0\0\0 \0\x04\0G\x01\0\0\x02\0\0\0\x03\0\0\0!\0\x05\0S\x01\0\0\x06\0\0\0\x06\0\0\0\x06\0\0\0,\0\x07\0\x06\0\0\0U\x01\0\0\x9D\0\0\0\x9D\0\0\0\x9D\0\0\0\x9D\0\0\0,\0\x07\0\x06\0\0\0V\x01\0\0\x1F\0\0\0\x1F\0\0\0\x1F\0\0\0\x1F\0\0\0!\0\x05\0a\x01\0\0\x03\0\0\0\x18\0\0\0\x04\0\0\0!\0\x05\0m\x01\0\0\x14\0\0\0\t\0\0\0\x17\0\0\0!\0\x06\0\x7F\x01\0\0\x04\0\0\0\t\0\0\0\x17\0\0\0\x14\0\0\0+\0\x04\0\x03\0\0\0\x80\x01\0\0\0\0\x80\xBF,\0\x05\0\x04\0\0\0\x81\x01\0\0\x80\x01\0\0\x80\x01\0\0,\0\x05\0\x04\0\0\0\x82\x01\0\0\x1F\0\0\0\x1F\0\0\0,\0\x05\0\x04\0\0\0\x83\x01\0\0\x9D\0\0\0\x9D\0\0\0!\0\x06\0\xAA\x01\0\0\x18\0\0\0\t\0\0\0\x17\0\0\0\x14\0\0\0!\0\x04\0\xBA\x01\0\0\x03\0\0\0\x18\0\0\0+\0\x04\0\x03\0\0\0\xBE\x01\0\0\0\0\0?,\0\x05\0\x04\0\0\0\xBF\x01\0\0\xBE\x01\0\0\xBE\x01\0\0+\0\x04\0\x03\0\0\0\xC0\x01\0\0\0\0\0\xBF,\0\x05\0\x04\0\0\0\xC1\x01\0\0\xC0\x01\0\0\xBE\x01\0\0,\0\x05\0\x04\0\0\0\xC2\x01\0\0\xBE\x01\0\0\xBE\x01\0\0,\0\x05\0\x04\0\0\0\xC3\x01\0\0\xBE\x01\0\0\xC0\x01\0\0,\0\x05\0\x04\0\0\0\xC4\x01\0\0\xC0\x01\0\0\xC0\x01\0\0\x1B\0\x03\0\xCB\x01\0\0\x12\0\0\0!\0\x05\0\xE9\x01\0\0\x03\0\0\0\x14\0\0\0\x14\0\0\0!\0\x04\0\xFB\x01\0\0\x03\0\0\0\x19\0\0\0 \0\x04\0\xFC\x01\0\0\x02\0\0\0\x11\0\0\0+\0\x04\0\x1A\0\0\0\xFF\x01\0\0\0\0\0\0 \0\x04\0\x03\x02\0\0\x02\0\0\0\x04\0\0\0!\0\x04\0\x0F\x02\0\0\x14\0\0\0\x04\0\0\0\x17\0\x04\0\x13\x02\0\0\x05\0\0\0\x02\0\0\0!\0\x06\0+\x02\0\0\x03\0\0\0\x19\0\0\0\x19\0\0\0\x03\0\0\0+\0\x04\0\x1A\0\0\0.\x02\0\0\x01\0\0\0,\0\x05\0\x19\0\0\0/\x02\0\0.\x02\0\0.\x02\0\0,\0\x05\0\x19\0\0\x000\x02\0\0\xFF\x01\0\0\xFF\x01\0\0+\0\x04\0\x1A\0\0\x001\x02\0\0\x02\0\0\0+\0\x04\0\x03\0\0\x002\x02\0\0\0\0\0@)\0\x03\0\x15\0\0\x003\x02\0\0.\0\x03\0\x15\0\0\x005\x02\0\0.\0\x03\0\x15\0\0\x007\x02\0\0!\0\x06\0q\x02\0\0\x14\0\0\0\x19\0\0\0\x14\0\0\0\x03\0\0\0,\0\x05\0\x19\0\0\0t\x02\0\0.\x02\0\0\xFF\x01\0\0,\0\x05\0\x19\0\0\0u\x02\0\0\xFF\x01\0\0.\x02\0\0\x17\0\x04\0\x91\x02\0\0\x15\0\0\0\x03\0\0\0 \0\x04\0\x96\x02\0\0\x01\0\0\0\x05\0\0\0;\0\x04\0\x96\x02\0\0\x95\x02\0\0\x01\0\0\0 \0\x04\0\x99\x02\0\0\x03\0\0\0\x06\0\0\0;\0\x04\0\x99\x02\0\0\x98\x02\0\0\x03\0\0\0!\0\x03\0\x9B\x02\0\0\x02\0\0\0+\0\x04\0\x03\0\0\0\x9C\x02\0\0\0\0@@+\0\x04\0\x03\0\0\0\x9D\x02\0\0\0\0@\xC0 \0\x04\0\xA6\x02\0\0\x01\0\0\0\x06\0\0\0;\0\x04\0\xA6\x02\0\0\xA5\x02\0\0\x01\0\0\0;\0\x04\0\x99\x02\0\0\xA8\x02\0\0\x03\0\0\0,\0\x07\0\x06\0\0\0\xAF\x02\0\0\x1F\0\0\0\x9D\0\0\0\x9D\0\0\0\x1F\0\0\0+\0\x04\0\x03\0\0\0\xB2\x02\0\0\0\0\0\xCF,\0\x05\0\x04\0\0\0\xB3\x02\0\0\xB2\x02\0\0\xB2\x02\0\0+\0\x04\0\x03\0\0\0\xB4\x02\0\0\xFF\xFF\xFFN,\0\x05\0\x04\0\0\0\xB5\x02\0\0\xB4\x02\0\0\xB4\x02\0\x006\0\x05\0\x03\0\0\0.\0\0\0\0\0\0\0/\0\0\x007\0\x03\0\x07\0\0\0,\0\0\x007\0\x03\0\x03\0\0\0-\0\0\0\xF8\0\x02\0+\0\0\0\xF9\0\x02\x000\0\0\0\xF8\0\x02\x000\0\0\0Q\0\x05\0\x06\0\0\x001\0\0\0,\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\x002\0\0\x001\0\0\0\0\0\0\0\xBC\0\x05\0\x15\0\0\x003\0\0\0-\0\0\x002\0\0\0\xF7\0\x03\x004\0\0\0\0\0\0\0\xFA\0\x04\x003\0\0\x005\0\0\x004\0\0\0\xF8\0\x02\x005\0\0\0Q\0\x05\0\x06\0\0\x006\0\0\0,\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\x007\0\0\x006\0\0\0\x01\0\0\0Q\0\x05\0\x06\0\0\08\0\0\0,\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\09\0\0\08\0\0\0\x02\0\0\0\x85\0\x05\0\x03\0\0\0:\0\0\09\0\0\0-\0\0\0\x81\0\x05\0\x03\0\0\0;\0\0\x007\0\0\0:\0\0\0\xFE\0\x02\0;\0\0\0\xF8\0\x02\x004\0\0\0Q\0\x05\0\x06\0\0\0<\0\0\0,\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0=\0\0\0<\0\0\0\0\0\0\0Q\0\x05\0\x06\0\0\0>\0\0\0,\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0?\0\0\0>\0\0\0\x01\0\0\0Q\0\x05\0\x06\0\0\0@\0\0\0,\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0A\0\0\0@\0\0\0\x02\0\0\0\x85\0\x05\0\x03\0\0\0B\0\0\0-\0\0\0A\0\0\0\x0C\0\x06\0\x03\0\0\0C\0\0\0\x01\0\0\0\x1C\0\0\0B\0\0\0\x85\0\x05\0\x03\0\0\0D\0\0\0?\0\0\0C\0\0\0\x81\0\x05\0\x03\0\0\0E\0\0\0=\0\0\0D\0\0\0\xFE\0\x02\0E\0\0\08\0\x01\x006\0\x05\0\x03\0\0\0I\0\0\0\0\0\0\0/\0\0\x007\0\x03\0\x07\0\0\0G\0\0\x007\0\x03\0\x03\0\0\0H\0\0\0\xF8\0\x02\0F\0\0\0\xF9\0\x02\0J\0\0\0\xF8\0\x02\0J\0\0\0Q\0\x05\0\x06\0\0\0K\0\0\0G\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0L\0\0\0K\0\0\0\0\0\0\0\xBC\0\x05\0\x15\0\0\0M\0\0\0H\0\0\0L\0\0\0\xF7\0\x03\0N\0\0\0\0\0\0\0\xFA\0\x04\0M\0\0\0O\0\0\0N\0\0\0\xF8\0\x02\0O\0\0\0Q\0\x05\0\x06\0\0\0P\0\0\0G\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0Q\0\0\0P\0\0\0\x02\0\0\0\xFE\0\x02\0Q\0\0\0\xF8\0\x02\0N\0\0\0Q\0\x05\0\x06\0\0\0R\0\0\0G\0\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0S\0\0\0R\0\0\0\x01\0\0\0\x88\0\x05\0\x03\0\0\0T\0\0\0S\0\0\0H\0\0\0\xFE\0\x02\0T\0\0\08\0\x01\x006\0\x05\0\x14\0\0\0W\0\0\0\0\0\0\0X\0\0\x007\0\x03\0\x14\0\0\0V\0\0\0\xF8\0\x02\0U\0\0\0;\0\x05\0`\0\0\0_\0\0\0\x07\0\0\0a\0\0\0A\0\x05\0Y\0\0\0[\0\0\0%\0\0\0Z\0\0\0\xF9\0\x02\0b\0\0\0\xF8\0\x02\0b\0\0\0Q\0\x05\0\x03\0\0\0c\0\0\0V\0\0\0\x02\0\0\0|\0\x04\0\x05\0\0\0d\0\0\0c\0\0\0\xC7\0\x05\0\x05\0\0\0e\0\0\0d\0\0\0\\\0\0\0|\0\x04\0\x03\0\0\0f\0\0\0e\0\0\0\xC7\0\x05\0\x05\0\0\0g\0\0\0d\0\0\0]\0\0\0p\0\x04\0\x03\0\0\0h\0\0\0g\0\0\0\xC7\0\x05\0\x05\0\0\0i\0\0\0d\0\0\0^\0\0\0|\0\x04\0\x03\0\0\0j\0\0\0i\0\0\0\x85\0\x05\0\x03\0\0\0k\0\0\0j\0\0\0\x1E\0\0\0O\0\x07\0\x04\0\0\0l\0\0\0V\0\0\0V\0\0\0\0\0\0\0\x01\0\0\0A\0\x05\0m\0\0\0o\0\0\0[\0\0\0n\0\0\0=\0\x04\0\x06\0\0\0p\0\0\0o\0\0\0O\0\x07\0\x04\0\0\0q\0\0\0p\0\0\0p\0\0\0\0\0\0\0\x01\0\0\0\x8E\0\x05\0\x04\0\0\0r\0\0\0q\0\0\0f\0\0\0\x81\0\x05\0\x04\0\0\0s\0\0\0l\0\0\0r\0\0\0>\0\x03\0_\0\0\0s\0\0\0=\0\x04\0\x04\0\0\0t\0\0\0_\0\0\0A\0\x05\0m\0\0\0u\0\0\0[\0\0\0n\0\0\0=\0\x04\0\x06\0\0\0v\0\0\0u\0\0\0O\0\x07\0\x04\0\0\0w\0\0\0v\0\0\0v\0\0\0\0\0\0\0\x01\0\0\0\x8E\0\x05\0\x04\0\0\0x\0\0\0w\0\0\0k\0\0\0\x8E\0\x05\0\x04\0\0\0y\0\0\0x\0\0\0h\0\0\0\x81\0\x05\0\x04\0\0\0z\0\0\0t\0\0\0y\0\0\0>\0\x03\0_\0\0\0z\0\0\0=\0\x04\0\x04\0\0\0{\0\0\0_\0\0\0A\0\x05\0m\0\0\0|\0\0\0[\0\0\0n\0\0\0=\0\x04\0\x06\0\0\0}\0\0\0|\0\0\0O\0\x07\0\x04\0\0\0~\0\0\0}\0\0\0}\0\0\0\x02\0\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\x7F\0\0\0V\0\0\0\x02\0\0\0\x8E\0\x05\0\x04\0\0\0\x80\0\0\0~\0\0\0\x7F\0\0\0\x81\0\x05\0\x04\0\0\0\x81\0\0\0{\0\0\0\x80\0\0\0>\0\x03\0_\0\0\0\x81\0\0\0=\0\x04\0\x04\0\0\0\x82\0\0\0_\0\0\0Q\0\x05\0\x03\0\0\0\x83\0\0\0V\0\0\0\x02\0\0\0P\0\x05\0\x14\0\0\0\x84\0\0\0\x82\0\0\0\x83\0\0\0\xFE\0\x02\0\x84\0\0\08\0\x01\x006\0\x05\0\x14\0\0\0\x87\0\0\0\0\0\0\0X\0\0\x007\0\x03\0\x14\0\0\0\x86\0\0\0\xF8\0\x02\0\x85\0\0\0A\0\x05\0Y\0\0\0\x88\0\0\0%\0\0\0Z\0\0\0\xF9\0\x02\0\x89\0\0\0\xF8\0\x02\0\x89\0\0\0O\0\x07\0\x04\0\0\0\x8A\0\0\0\x86\0\0\0\x86\0\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\x8B\0\0\0\x86\0\0\0\x02\0\0\0A\0\x05\0m\0\0\0\x8C\0\0\0\x88\0\0\0n\0\0\0=\0\x04\0\x06\0\0\0\x8D\0\0\0\x8C\0\0\0O\0\x07\0\x04\0\0\0\x8E\0\0\0\x8D\0\0\0\x8D\0\0\0\0\0\0\0\x01\0\0\0A\0\x05\0m\0\0\0\x8F\0\0\0\x88\0\0\0n\0\0\0=\0\x04\0\x06\0\0\0\x90\0\0\0\x8F\0\0\0O\0\x07\0\x04\0\0\0\x91\0\0\0\x90\0\0\0\x90\0\0\0\x02\0\0\0\x03\0\0\0\x81\0\x05\0\x04\0\0\0\x92\0\0\0\x8E\0\0\0\x91\0\0\0O\0\x07\0\x04\0\0\0\x93\0\0\0\x86\0\0\0\x86\0\0\0\0\0\0\0\x01\0\0\0\x94\0\x05\0\x03\0\0\0\x94\0\0\0\x92\0\0\0\x93\0\0\0\x83\0\x05\0\x03\0\0\0\x95\0\0\0\x8B\0\0\0\x94\0\0\0P\0\x05\0\x14\0\0\0\x96\0\0\0\x8A\0\0\0\x95\0\0\0\xFE\0\x02\0\x96\0\0\08\0\x01\x006\0\x05\0\x05\0\0\0\x99\0\0\0\0\0\0\0\x9A\0\0\x007\0\x03\0\x14\0\0\0\x98\0\0\0\xF8\0\x02\0\x97\0\0\0;\0\x05\0\x9F\0\0\0\xA0\0\0\0\x07\0\0\0Z\0\0\0;\0\x05\0\x9F\0\0\0\xA2\0\0\0\x07\0\0\0\x9C\0\0\0;\0\x05\0\x9F\0\0\0\x9E\0\0\0\x07\0\0\0\x9C\0\0\0;\0\x05\0\x9F\0\0\0\xA1\0\0\0\x07\0\0\0Z\0\0\0A\0\x05\0Y\0\0\0\x9B\0\0\0%\0\0\0Z\0\0\0\xF9\0\x02\0\xA3\0\0\0\xF8\0\x02\0\xA3\0\0\0P\0\x05\0\x06\0\0\0\xA4\0\0\0\x98\0\0\0\x1F\0\0\0\xF9\0\x02\0\xA5\0\0\0\xF8\0\x02\0\xA5\0\0\0\xF6\0\x04\0\xA6\0\0\0\xA8\0\0\0\0\0\0\0\xF9\0\x02\0\xA7\0\0\0\xF8\0\x02\0\xA7\0\0\0=\0\x04\0\x05\0\0\0\xA9\0\0\0\xA2\0\0\0\xB0\0\x05\0\x15\0\0\0\xAA\0\0\0\xA9\0\0\0\x0B\0\0\0\xF7\0\x03\0\xAB\0\0\0\0\0\0\0\xFA\0\x04\0\xAA\0\0\0\xAB\0\0\0\xAC\0\0\0\xF8\0\x02\0\xAC\0\0\0\xF9\0\x02\0\xA6\0\0\0\xF8\0\x02\0\xAB\0\0\0\xF9\0\x02\0\xAD\0\0\0\xF8\0\x02\0\xAD\0\0\0=\0\x04\0\x05\0\0\0\xB0\0\0\0\xA2\0\0\0A\0\x06\0m\0\0\0\xB1\0\0\0\x9B\0\0\0Z\0\0\0\xB0\0\0\0=\0\x04\0\x06\0\0\0\xB2\0\0\0\xB1\0\0\0\x94\0\x05\0\x03\0\0\0\xB3\0\0\0\xB2\0\0\0\xA4\0\0\0\xBE\0\x05\0\x15\0\0\0\xB4\0\0\0\xB3\0\0\0\x9D\0\0\0=\0\x04\0\x05\0\0\0\xB5\0\0\0\x9E\0\0\0\xA9\0\x06\0\x05\0\0\0\xB6\0\0\0\xB4\0\0\0\xB5\0\0\0Z\0\0\0>\0\x03\0\x9E\0\0\0\xB6\0\0\0=\0\x04\0\x05\0\0\0\xB7\0\0\0\xA0\0\0\0=\0\x04\0\x05\0\0\0\xB8\0\0\0\x9E\0\0\0\x80\0\x05\0\x05\0\0\0\xB9\0\0\0\xB7\0\0\0\xB8\0\0\0>\0\x03\0\xA0\0\0\0\xB9\0\0\0=\0\x04\0\x05\0\0\0\xBA\0\0\0\xA1\0\0\0=\0\x04\0\x05\0\0\0\xBB\0\0\0\xA2\0\0\0\xA9\0\x06\0\x05\0\0\0\xBC\0\0\0\xB4\0\0\0\xBB\0\0\0\xBA\0\0\0>\0\x03\0\xA1\0\0\0\xBC\0\0\0\xF9\0\x02\0\xAE\0\0\0\xF8\0\x02\0\xAE\0\0\0\xF9\0\x02\0\xA8\0\0\0\xF8\0\x02\0\xA8\0\0\0=\0\x04\0\x05\0\0\0\xBD\0\0\0\xA2\0\0\0\x80\0\x05\0\x05\0\0\0\xBE\0\0\0\xBD\0\0\0\x9C\0\0\0>\0\x03\0\xA2\0\0\0\xBE\0\0\0\xF9\0\x02\0\xA5\0\0\0\xF8\0\x02\0\xA6\0\0\0=\0\x04\0\x05\0\0\0\xBF\0\0\0\xA1\0\0\0=\0\x04\0\x05\0\0\0\xC0\0\0\0\xA0\0\0\0A\0\x06\0m\0\0\0\xC1\0\0\0\x9B\0\0\0Z\0\0\0Z\0\0\0=\0\x04\0\x06\0\0\0\xC2\0\0\0\xC1\0\0\0\x94\0\x05\0\x03\0\0\0\xC3\0\0\0\xC2\0\0\0\xA4\0\0\0\xBE\0\x05\0\x15\0\0\0\xC4\0\0\0\xC3\0\0\0\x9D\0\0\0\xA9\0\x06\0\x05\0\0\0\xC5\0\0\0\xC4\0\0\0\xC0\0\0\0\xBF\0\0\0\xFE\0\x02\0\xC5\0\0\08\0\x01\x006\0\x05\0\x05\0\0\0\xC8\0\0\0\0\0\0\0\x9A\0\0\x007\0\x03\0\x14\0\0\0\xC7\0\0\0\xF8\0\x02\0\xC6\0\0\0;\0\x05\0\xCE\0\0\0\xCD\0\0\0\x07\0\0\0\xCA\0\0\0;\0\x05\0\x9F\0\0\0\xCF\0\0\0\x07\0\0\0Z\0\0\0A\0\x05\0Y\0\0\0\xC9\0\0\0%\0\0\0Z\0\0\0\xF9\0\x02\0\xD0\0\0\0\xF8\0\x02\0\xD0\0\0\09\0\x05\0\x05\0\0\0\xD1\0\0\0\x99\0\0\0\xC7\0\0\0A\0\x06\0m\0\0\0\xD2\0\0\0\xC9\0\0\0\x9C\0\0\0\xD1\0\0\0=\0\x04\0\x06\0\0\0\xD3\0\0\0\xD2\0\0\0P\0\x05\0\x06\0\0\0\xD4\0\0\0\xC7\0\0\0\x1F\0\0\0\x94\0\x05\0\x03\0\0\0\xD5\0\0\0\xD3\0\0\0\xD4\0\0\0\xF9\0\x02\0\xD6\0\0\0\xF8\0\x02\0\xD6\0\0\0\xF6\0\x04\0\xD7\0\0\0\xD9\0\0\0\0\0\0\0\xF9\0\x02\0\xD8\0\0\0\xF8\0\x02\0\xD8\0\0\0=\0\x04\0\x05\0\0\0\xDA\0\0\0\xCF\0\0\0\xB0\0\x05\0\x15\0\0\0\xDB\0\0\0\xDA\0\0\0\x08\0\0\0\xF7\0\x03\0\xDC\0\0\0\0\0\0\0\xFA\0\x04\0\xDB\0\0\0\xDC\0\0\0\xDD\0\0\0\xF8\0\x02\0\xDD\0\0\0\xF9\0\x02\0\xD7\0\0\0\xF8\0\x02\0\xDC\0\0\0\xF9\0\x02\0\xDE\0\0\0\xF8\0\x02\0\xDE\0\0\0\x84\0\x05\0\x05\0\0\0\xE1\0\0\0\xD1\0\0\0\x08\0\0\0=\0\x04\0\x05\0\0\0\xE2\0\0\0\xCF\0\0\0\x80\0\x05\0\x05\0\0\0\xE3\0\0\0\xE1\0\0\0\xE2\0\0\0A\0\x06\0m\0\0\0\xE4\0\0\0\xC9\0\0\0\x08\0\0\0\xE3\0\0\0=\0\x04\0\x06\0\0\0\xE5\0\0\0\xE4\0\0\0=\0\x04\0\x16\0\0\0\xE6\0\0\0\xCD\0\0\0P\0\x07\0\x06\0\0\0\xE7\0\0\0\xD5\0\0\0\xD5\0\0\0\xD5\0\0\0\xD5\0\0\0\xBE\0\x05\0\xE8\0\0\0\xE9\0\0\0\xE7\0\0\0\xE5\0\0\0\xA9\0\x06\0\x16\0\0\0\xEA\0\0\0\xE9\0\0\0\xCB\0\0\0\xCA\0\0\0\x80\0\x05\0\x16\0\0\0\xEB\0\0\0\xE6\0\0\0\xEA\0\0\0>\0\x03\0\xCD\0\0\0\xEB\0\0\0\xF9\0\x02\0\xDF\0\0\0\xF8\0\x02\0\xDF\0\0\0\xF9\0\x02\0\xD9\0\0\0\xF8\0\x02\0\xD9\0\0\0=\0\x04\0\x05\0\0\0\xEC\0\0\0\xCF\0\0\0\x80\0\x05\0\x05\0\0\0\xED\0\0\0\xEC\0\0\0\x9C\0\0\0>\0\x03\0\xCF\0\0\0\xED\0\0\0\xF9\0\x02\0\xD6\0\0\0\xF8\0\x02\0\xD7\0\0\0\x84\0\x05\0\x05\0\0\0\xEE\0\0\0\xD1\0\0\0\r\0\0\0A\0\x05\0\x9F\0\0\0\xEF\0\0\0\xCD\0\0\0Z\0\0\0=\0\x04\0\x05\0\0\0\xF0\0\0\0\xEF\0\0\0A\0\x05\0\x9F\0\0\0\xF1\0\0\0\xCD\0\0\0\x9C\0\0\0=\0\x04\0\x05\0\0\0\xF2\0\0\0\xF1\0\0\0\x80\0\x05\0\x05\0\0\0\xF3\0\0\0\xF0\0\0\0\xF2\0\0\0A\0\x05\0\x9F\0\0\0\xF4\0\0\0\xCD\0\0\0\x08\0\0\0=\0\x04\0\x05\0\0\0\xF5\0\0\0\xF4\0\0\0\x80\0\x05\0\x05\0\0\0\xF6\0\0\0\xF3\0\0\0\xF5\0\0\0A\0\x05\0\x9F\0\0\0\xF7\0\0\0\xCD\0\0\0n\0\0\0=\0\x04\0\x05\0\0\0\xF8\0\0\0\xF7\0\0\0\x80\0\x05\0\x05\0\0\0\xF9\0\0\0\xF6\0\0\0\xF8\0\0\0\x0C\0\x07\0\x05\0\0\0\xFA\0\0\0\x01\0\0\0&\0\0\0\xF9\0\0\0\xCC\0\0\0\x80\0\x05\0\x05\0\0\0\xFB\0\0\0\xEE\0\0\0\xFA\0\0\0\xFE\0\x02\0\xFB\0\0\08\0\x01\x006\0\x05\0\t\0\0\0\xFE\0\0\0\0\0\0\0\xFF\0\0\x007\0\x03\0\x14\0\0\0\xFD\0\0\0\xF8\0\x02\0\xFC\0\0\0A\0\x05\0Y\0\0\0\0\x01\0\0%\0\0\0Z\0\0\0\xF9\0\x02\0\x01\x01\0\0\xF8\0\x02\0\x01\x01\0\09\0\x05\0\x05\0\0\0\x03\x01\0\0\xC8\0\0\0\xFD\0\0\0A\0\x06\0\x04\x01\0\0\x06\x01\0\0\0\x01\0\0\x05\x01\0\0\x03\x01\0\0=\0\x04\0\t\0\0\0\x07\x01\0\0\x06\x01\0\0\xFE\0\x02\0\x07\x01\0\08\0\x01\x006\0\x05\0\x17\0\0\0\x0B\x01\0\0\0\0\0\0\x0C\x01\0\x007\0\x03\0\t\0\0\0\t\x01\0\x007\0\x03\0\x14\0\0\0\n\x01\0\0\xF8\0\x02\0\x08\x01\0\0;\0\x05\0\x0F\x01\0\0\x0E\x01\0\0\x07\0\0\0\x10\x01\0\0;\0\x05\0\x0F\x01\0\0\x11\x01\0\0\x07\0\0\0\x12\x01\0\0\xF9\0\x02\0\x13\x01\0\0\xF8\0\x02\0\x13\x01\0\0P\0\x05\0\x06\0\0\0\x14\x01\0\0\n\x01\0\0\x1F\0\0\0Q\0\x05\0\x06\0\0\0\x15\x01\0\0\t\x01\0\0\x03\0\0\0\x94\0\x05\0\x03\0\0\0\x16\x01\0\0\x15\x01\0\0\x14\x01\0\0Q\0\x05\0\x06\0\0\0\x17\x01\0\0\t\x01\0\0\0\0\0\0\x94\0\x05\0\x03\0\0\0\x18\x01\0\0\x17\x01\0\0\x14\x01\0\0Q\0\x05\0\x06\0\0\0\x19\x01\0\0\t\x01\0\0\x01\0\0\0\x94\0\x05\0\x03\0\0\0\x1A\x01\0\0\x19\x01\0\0\x14\x01\0\0Q\0\x05\0\x06\0\0\0\x1B\x01\0\0\t\x01\0\0\x02\0\0\0\x94\0\x05\0\x03\0\0\0\x1C\x01\0\0\x1B\x01\0\0\x14\x01\0\0P\0\x06\0\x14\0\0\0\x1D\x01\0\0\x18\x01\0\0\x1A\x01\0\0\x1C\x01\0\0P\0\x06\0\x14\0\0\0\x1E\x01\0\0\x16\x01\0\0\x16\x01\0\0\x16\x01\0\0\x88\0\x05\0\x14\0\0\0\x1F\x01\0\0\x1D\x01\0\0\x1E\x01\0\0Q\0\x05\0\x03\0\0\0 \x01\0\0\x1F\x01\0\0\0\0\0\0Q\0\x05\0\x07\0\0\0!\x01\0\0\t\x01\0\0\x07\0\0\0Q\0\x05\0\x03\0\0\0\"\x01\0\0\x1F\x01\0\0\x01\0\0\09\0\x06\0\x03\0\0\0#\x01\0\0.\0\0\0!\x01\0\0\"\x01\0\0Q\0\x05\0\x03\0\0\0$\x01\0\0\x1F\x01\0\0\x02\0\0\0P\0\x06\0\x14\0\0\0%\x01\0\0 \x01\0\0#\x01\0\0$\x01\0\0O\0\x07\0\x04\0\0\0&\x01\0\0%\x01\0\0%\x01\0\0\0\0\0\0\x01\0\0\0Q\0\x05\0\x06\0\0\0'\x01\0\0\t\x01\0\0\x04\0\0\0O\0\x07\0\x04\0\0\0(\x01\0\0'\x01\0\0'\x01\0\0\0\0\0\0\x01\0\0\0\x85\0\x05\0\x04\0\0\0)\x01\0\0&\x01\0\0(\x01\0\0Q\0\x05\0\x06\0\0\0*\x01\0\0\t\x01\0\0\x04\0\0\0O\0\x07\0\x04\0\0\0+\x01\0\0*\x01\0\0*\x01\0\0\x02\0\0\0\x03\0\0\0\x81\0\x05\0\x04\0\0\0,\x01\0\0)\x01\0\0+\x01\0\0Q\0\x05\0\x06\0\0\0-\x01\0\0\t\x01\0\0\x05\0\0\0O\0\x07\0\x04\0\0\0.\x01\0\0-\x01\0\0-\x01\0\0\0\0\0\0\x01\0\0\0\xBE\0\x05\0/\x01\0\x000\x01\0\0,\x01\0\0.\x01\0\0\x9B\0\x04\0\x15\0\0\x001\x01\0\x000\x01\0\0\xF7\0\x03\x002\x01\0\0\0\0\0\0\xFA\0\x04\x001\x01\0\x003\x01\0\x004\x01\0\0\xF8\0\x02\x003\x01\0\0Q\0\x05\0\x06\0\0\x005\x01\0\0\t\x01\0\0\x05\0\0\0O\0\x07\0\x04\0\0\x006\x01\0\x005\x01\0\x005\x01\0\0\x02\0\0\0\x03\0\0\0\xBC\0\x05\0/\x01\0\x007\x01\0\0,\x01\0\x006\x01\0\0\x9B\0\x04\0\x15\0\0\08\x01\0\x007\x01\0\0>\0\x03\0\x0E\x01\0\08\x01\0\0\xF9\0\x02\x002\x01\0\0\xF8\0\x02\x004\x01\0\0>\0\x03\0\x0E\x01\0\0\r\x01\0\0\xF9\0\x02\x002\x01\0\0\xF8\0\x02\x002\x01\0\0=\0\x04\0\x15\0\0\09\x01\0\0\x0E\x01\0\0Q\0\x05\0\x03\0\0\0:\x01\0\0\x1F\x01\0\0\x01\0\0\0\xBA\0\x05\0\x15\0\0\0;\x01\0\0\x16\x01\0\0\x9D\0\0\0\xF7\0\x03\0<\x01\0\0\0\0\0\0\xFA\0\x04\0;\x01\0\0=\x01\0\0>\x01\0\0\xF8\0\x02\0=\x01\0\0>\0\x03\0\x11\x01\0\09\x01\0\0\xF9\0\x02\0<\x01\0\0\xF8\0\x02\0>\x01\0\0>\0\x03\0\x11\x01\0\0\r\x01\0\0\xF9\0\x02\0<\x01\0\0\xF8\0\x02\0<\x01\0\0=\0\x04\0\x15\0\0\0?\x01\0\0\x11\x01\0\0P\0\x08\0\x17\0\0\0@\x01\0\0%\x01\0\0\x16\x01\0\0:\x01\0\0,\x01\0\0?\x01\0\0\xFE\0\x02\0@\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0C\x01\0\0\0\0\0\0D\x01\0\x007\0\x03\0\x03\0\0\0B\x01\0\0\xF8\0\x02\0A\x01\0\0A\0\x05\0Y\0\0\0E\x01\0\0%\0\0\0Z\0\0\0\xF9\0\x02\0F\x01\0\0\xF8\0\x02\0F\x01\0\0A\0\x05\0G\x01\0\0H\x01\0\0E\x01\0\0\x0B\0\0\0=\0\x04\0\x03\0\0\0I\x01\0\0H\x01\0\0\x0C\0\x07\0\x03\0\0\0J\x01\0\0\x01\0\0\0%\0\0\0I\x01\0\0\x9D\0\0\0A\0\x05\0G\x01\0\0K\x01\0\0E\x01\0\0\x0B\0\0\0=\0\x04\0\x03\0\0\0L\x01\0\0K\x01\0\0\x0C\0\x07\0\x03\0\0\0M\x01\0\0\x01\0\0\0(\0\0\0L\x01\0\0\x9D\0\0\0\x0C\0\x08\0\x03\0\0\0N\x01\0\0\x01\0\0\0+\0\0\0B\x01\0\0J\x01\0\0M\x01\0\0\xFE\0\x02\0N\x01\0\08\0\x01\x006\0\x05\0\x06\0\0\0R\x01\0\0\0\0\0\0S\x01\0\x007\0\x03\0\x06\0\0\0P\x01\0\x007\0\x03\0\x06\0\0\0Q\x01\0\0\xF8\0\x02\0O\x01\0\0A\0\x05\0Y\0\0\0T\x01\0\0%\0\0\0Z\0\0\0\xF9\0\x02\0W\x01\0\0\xF8\0\x02\0W\x01\0\0A\0\x05\0G\x01\0\0X\x01\0\0T\x01\0\0\x0B\0\0\0=\0\x04\0\x03\0\0\0Y\x01\0\0X\x01\0\0\x8E\0\x05\0\x06\0\0\0Z\x01\0\0Q\x01\0\0Y\x01\0\0\xBC\0\x05\0\xE8\0\0\0[\x01\0\0P\x01\0\0Z\x01\0\0\xA9\0\x06\0\x06\0\0\0\\\x01\0\0[\x01\0\0V\x01\0\0U\x01\0\0\xFE\0\x02\0\\\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0`\x01\0\0\0\0\0\0a\x01\0\x007\0\x03\0\x18\0\0\0^\x01\0\x007\0\x03\0\x04\0\0\0_\x01\0\0\xF8\0\x02\0]\x01\0\0A\0\x05\0Y\0\0\0b\x01\0\0%\0\0\0Z\0\0\0\xF9\0\x02\0c\x01\0\0\xF8\0\x02\0c\x01\0\0Q\0\x05\0\x03\0\0\0d\x01\0\0^\x01\0\0\x01\0\0\0Q\0\x05\0\x04\0\0\0e\x01\0\0^\x01\0\0\x02\0\0\0\x94\0\x05\0\x03\0\0\0f\x01\0\0e\x01\0\0_\x01\0\0\x81\0\x05\0\x03\0\0\0g\x01\0\0d\x01\0\0f\x01\0\09\0\x05\0\x03\0\0\0h\x01\0\0C\x01\0\0g\x01\0\0\xFE\0\x02\0h\x01\0\08\0\x01\x006\0\x05\0\x14\0\0\0l\x01\0\0\0\0\0\0m\x01\0\x007\0\x03\0\t\0\0\0j\x01\0\x007\0\x03\0\x17\0\0\0k\x01\0\0\xF8\0\x02\0i\x01\0\0\xF9\0\x02\0n\x01\0\0\xF8\0\x02\0n\x01\0\0Q\0\x05\0\x06\0\0\0o\x01\0\0j\x01\0\0\x01\0\0\0O\0\x08\0\x14\0\0\0p\x01\0\0o\x01\0\0o\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0q\x01\0\0k\x01\0\0\x02\0\0\0Q\0\x05\0\x06\0\0\0r\x01\0\0j\x01\0\0\x03\0\0\0O\0\x08\0\x14\0\0\0s\x01\0\0r\x01\0\0r\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\x8E\0\x05\0\x14\0\0\0t\x01\0\0s\x01\0\0q\x01\0\0\x83\0\x05\0\x14\0\0\0u\x01\0\0p\x01\0\0t\x01\0\0Q\0\x05\0\x07\0\0\0v\x01\0\0j\x01\0\0\x07\0\0\0Q\0\x05\0\x03\0\0\0w\x01\0\0k\x01\0\0\x02\0\0\09\0\x06\0\x03\0\0\0x\x01\0\0I\0\0\0v\x01\0\0w\x01\0\0\x8E\0\x05\0\x14\0\0\0y\x01\0\0u\x01\0\0x\x01\0\0\xFE\0\x02\0y\x01\0\08\0\x01\x006\0\x05\0\x04\0\0\0~\x01\0\0\0\0\0\0\x7F\x01\0\x007\0\x03\0\t\0\0\0{\x01\0\x007\0\x03\0\x17\0\0\0|\x01\0\x007\0\x03\0\x14\0\0\0}\x01\0\0\xF8\0\x02\0z\x01\0\0\xF9\0\x02\0\x84\x01\0\0\xF8\0\x02\0\x84\x01\0\0Q\0\x05\0\x06\0\0\0\x85\x01\0\0{\x01\0\0\0\0\0\0O\0\x08\0\x14\0\0\0\x86\x01\0\0\x85\x01\0\0\x85\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0Q\0\x05\0\x14\0\0\0\x87\x01\0\0|\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\x88\x01\0\0\x87\x01\0\0\0\0\0\0Q\0\x05\0\x06\0\0\0\x89\x01\0\0{\x01\0\0\x03\0\0\0O\0\x08\0\x14\0\0\0\x8A\x01\0\0\x89\x01\0\0\x89\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\x8E\0\x05\0\x14\0\0\0\x8B\x01\0\0\x8A\x01\0\0\x88\x01\0\0\x83\0\x05\0\x14\0\0\0\x8C\x01\0\0\x86\x01\0\0\x8B\x01\0\09\0\x06\0\x14\0\0\0\x8D\x01\0\0l\x01\0\0{\x01\0\0|\x01\0\0Q\0\x05\0\x06\0\0\0\x8E\x01\0\0{\x01\0\0\x02\0\0\0O\0\x08\0\x14\0\0\0\x8F\x01\0\0\x8E\x01\0\0\x8E\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0Q\0\x05\0\x14\0\0\0\x90\x01\0\0|\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\x91\x01\0\0\x90\x01\0\0\x02\0\0\0Q\0\x05\0\x06\0\0\0\x92\x01\0\0{\x01\0\0\x03\0\0\0O\0\x08\0\x14\0\0\0\x93\x01\0\0\x92\x01\0\0\x92\x01\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\x8E\0\x05\0\x14\0\0\0\x94\x01\0\0\x93\x01\0\0\x91\x01\0\0\x83\0\x05\0\x14\0\0\0\x95\x01\0\0\x8F\x01\0\0\x94\x01\0\0\x0C\0\x07\0\x14\0\0\0\x96\x01\0\0\x01\0\0\0D\0\0\0\x8C\x01\0\0\x8D\x01\0\0\x94\0\x05\0\x03\0\0\0\x97\x01\0\0}\x01\0\0\x96\x01\0\0\x0C\0\x07\0\x14\0\0\0\x98\x01\0\0\x01\0\0\0D\0\0\0\x8D\x01\0\0}\x01\0\0\x94\0\x05\0\x03\0\0\0\x99\x01\0\0\x95\x01\0\0\x98\x01\0\0\x0C\0\x07\0\x14\0\0\0\x9A\x01\0\0\x01\0\0\0D\0\0\0}\x01\0\0\x8C\x01\0\0\x94\0\x05\0\x03\0\0\0\x9B\x01\0\0\x95\x01\0\0\x9A\x01\0\0P\0\x05\0\x04\0\0\0\x9C\x01\0\0\x99\x01\0\0\x9B\x01\0\0Q\0\x05\0\x06\0\0\0\x9D\x01\0\0{\x01\0\0\x04\0\0\0O\0\x07\0\x04\0\0\0\x9E\x01\0\0\x9D\x01\0\0\x9D\x01\0\0\0\0\0\0\x01\0\0\0\x8E\0\x05\0\x04\0\0\0\x9F\x01\0\0\x9E\x01\0\0\x97\x01\0\0\x88\0\x05\0\x04\0\0\0\xA0\x01\0\0\x9C\x01\0\0\x9F\x01\0\0\x0C\0\x08\0\x04\0\0\0\xA1\x01\0\0\x01\0\0\0+\0\0\0\xA0\x01\0\0\x81\x01\0\0\x82\x01\0\0\xB4\0\x05\0\x15\0\0\0\xA2\x01\0\0\x97\x01\0\0\x9D\0\0\0P\0\x05\0/\x01\0\0\xA4\x01\0\0\xA2\x01\0\0\xA2\x01\0\0\xA9\0\x06\0\x04\0\0\0\xA3\x01\0\0\xA4\x01\0\0\x83\x01\0\0\xA1\x01\0\0\xFE\0\x02\0\xA3\x01\0\08\0\x01\x006\0\x05\0\x18\0\0\0\xA9\x01\0\0\0\0\0\0\xAA\x01\0\x007\0\x03\0\t\0\0\0\xA6\x01\0\x007\0\x03\0\x17\0\0\0\xA7\x01\0\x007\0\x03\0\x14\0\0\0\xA8\x01\0\0\xF8\0\x02\0\xA5\x01\0\0\xF9\0\x02\0\xAB\x01\0\0\xF8\0\x02\0\xAB\x01\0\09\0\x07\0\x04\0\0\0\xAC\x01\0\0~\x01\0\0\xA6\x01\0\0\xA7\x01\0\0\xA8\x01\0\0Q\0\x05\0\x03\0\0\0\xAD\x01\0\0\xA6\x01\0\0\x06\0\0\0Q\0\x05\0\x03\0\0\0\xAE\x01\0\0\xAC\x01\0\0\x01\0\0\0\x0C\0\x06\0\x03\0\0\0\xAF\x01\0\0\x01\0\0\0\x04\0\0\0\xAE\x01\0\0\x85\0\x05\0\x03\0\0\0\xB0\x01\0\0\x1D\0\0\0\xAF\x01\0\0\x81\0\x05\0\x03\0\0\0\xB1\x01\0\0\xAD\x01\0\0\xB0\x01\0\0Q\0\x05\0\x04\0\0\0\xB2\x01\0\0\xA7\x01\0\0\x03\0\0\0Q\0\x05\0\x14\0\0\0\xB3\x01\0\0\xA7\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xB4\x01\0\0\xB3\x01\0\0\x02\0\0\0\x83\0\x05\0\x03\0\0\0\xB5\x01\0\0\xB4\x01\0\0\xB1\x01\0\0P\0\x06\0\x18\0\0\0\xB6\x01\0\0\xB2\x01\0\0\xB5\x01\0\0\xAC\x01\0\0\xFE\0\x02\0\xB6\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xB9\x01\0\0\0\0\0\0\xBA\x01\0\x007\0\x03\0\x18\0\0\0\xB8\x01\0\0\xF8\0\x02\0\xB7\x01\0\0A\0\x05\0Y\0\0\0\xBB\x01\0\0%\0\0\0Z\0\0\0=\0\x04\0\x12\0\0\0\xBC\x01\0\0(\0\0\0=\0\x04\0\x13\0\0\0\xBD\x01\0\0)\0\0\0\xF9\0\x02\0\xC5\x01\0\0\xF8\0\x02\0\xC5\x01\0\0Q\0\x05\0\x04\0\0\0\xC6\x01\0\0\xB8\x01\0\0\0\0\0\0\x83\0\x05\0\x04\0\0\0\xC7\x01\0\0\xC6\x01\0\0\xBF\x01\0\0\x0C\0\x06\0\x04\0\0\0\xC8\x01\0\0\x01\0\0\0\x08\0\0\0\xC7\x01\0\0\x81\0\x05\0\x04\0\0\0\xC9\x01\0\0\xC8\x01\0\0\x82\x01\0\0\x88\0\x05\0\x04\0\0\0\xCA\x01\0\0\xC9\x01\0\0\x1C\0\0\0V\0\x05\0\xCB\x01\0\0\xCC\x01\0\0\xBC\x01\0\0\xBD\x01\0\0`\0\x06\0\x06\0\0\0\xCD\x01\0\0\xCC\x01\0\0\xCA\x01\0\0Z\0\0\0Q\0\x05\0\x04\0\0\0\xCE\x01\0\0\xB8\x01\0\0\0\0\0\0\x83\0\x05\0\x04\0\0\0\xCF\x01\0\0\xC9\x01\0\0\xCE\x01\0\0\x81\0\x05\0\x04\0\0\0\xD0\x01\0\0\xCF\x01\0\0\xC1\x01\0\09\0\x06\0\x03\0\0\0\xD1\x01\0\0`\x01\0\0\xB8\x01\0\0\xD0\x01\0\0\x81\0\x05\0\x04\0\0\0\xD2\x01\0\0\xCF\x01\0\0\xC2\x01\0\09\0\x06\0\x03\0\0\0\xD3\x01\0\0`\x01\0\0\xB8\x01\0\0\xD2\x01\0\0\x81\0\x05\0\x04\0\0\0\xD4\x01\0\0\xCF\x01\0\0\xC3\x01\0\09\0\x06\0\x03\0\0\0\xD5\x01\0\0`\x01\0\0\xB8\x01\0\0\xD4\x01\0\0\x81\0\x05\0\x04\0\0\0\xD6\x01\0\0\xCF\x01\0\0\xC4\x01\0\09\0\x06\0\x03\0\0\0\xD7\x01\0\0`\x01\0\0\xB8\x01\0\0\xD6\x01\0\0P\0\x07\0\x06\0\0\0\xD8\x01\0\0\xD1\x01\0\0\xD3\x01\0\0\xD5\x01\0\0\xD7\x01\0\09\0\x06\0\x06\0\0\0\xD9\x01\0\0R\x01\0\0\xD8\x01\0\0\xCD\x01\0\0\x83\0\x05\0\x04\0\0\0\xDA\x01\0\0\xBF\x01\0\0\xCF\x01\0\0Q\0\x05\0\x03\0\0\0\xDB\x01\0\0\xD9\x01\0\0\x03\0\0\0Q\0\x05\0\x03\0\0\0\xDC\x01\0\0\xD9\x01\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\xDD\x01\0\0\xDA\x01\0\0\0\0\0\0\x0C\0\x08\0\x03\0\0\0\xDE\x01\0\0\x01\0\0\0.\0\0\0\xDB\x01\0\0\xDC\x01\0\0\xDD\x01\0\0Q\0\x05\0\x03\0\0\0\xDF\x01\0\0\xD9\x01\0\0\0\0\0\0Q\0\x05\0\x03\0\0\0\xE0\x01\0\0\xD9\x01\0\0\x01\0\0\0Q\0\x05\0\x03\0\0\0\xE1\x01\0\0\xDA\x01\0\0\0\0\0\0\x0C\0\x08\0\x03\0\0\0\xE2\x01\0\0\x01\0\0\0.\0\0\0\xDF\x01\0\0\xE0\x01\0\0\xE1\x01\0\0Q\0\x05\0\x03\0\0\0\xE3\x01\0\0\xDA\x01\0\0\x01\0\0\0\x0C\0\x08\0\x03\0\0\0\xE4\x01\0\0\x01\0\0\0.\0\0\0\xDE\x01\0\0\xE2\x01\0\0\xE3\x01\0\0\xFE\0\x02\0\xE4\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xE8\x01\0\0\0\0\0\0\xE9\x01\0\x007\0\x03\0\x14\0\0\0\xE6\x01\0\x007\0\x03\0\x14\0\0\0\xE7\x01\0\0\xF8\0\x02\0\xE5\x01\0\0A\0\x05\0Y\0\0\0\xEA\x01\0\0%\0\0\0Z\0\0\0=\0\x04\0\x12\0\0\0\xEB\x01\0\0(\0\0\0=\0\x04\0\x13\0\0\0\xEC\x01\0\0)\0\0\0\xF9\0\x02\0\xED\x01\0\0\xF8\0\x02\0\xED\x01\0\09\0\x05\0\x14\0\0\0\xEE\x01\0\0W\0\0\0\xE6\x01\0\09\0\x05\0\t\0\0\0\xEF\x01\0\0\xFE\0\0\0\xEE\x01\0\09\0\x06\0\x17\0\0\0\xF0\x01\0\0\x0B\x01\0\0\xEF\x01\0\0\xEE\x01\0\0Q\0\x05\0\x15\0\0\0\xF1\x01\0\0\xF0\x01\0\0\x04\0\0\0\xA8\0\x04\0\x15\0\0\0\xF2\x01\0\0\xF1\x01\0\0\xF7\0\x03\0\xF3\x01\0\0\0\0\0\0\xFA\0\x04\0\xF2\x01\0\0\xF4\x01\0\0\xF3\x01\0\0\xF8\0\x02\0\xF4\x01\0\0\xFE\0\x02\0\x1F\0\0\0\xF8\0\x02\0\xF3\x01\0\09\0\x05\0\x14\0\0\0\xF5\x01\0\0\x87\0\0\0\xE7\x01\0\09\0\x07\0\x18\0\0\0\xF6\x01\0\0\xA9\x01\0\0\xEF\x01\0\0\xF0\x01\0\0\xF5\x01\0\09\0\x05\0\x03\0\0\0\xF7\x01\0\0\xB9\x01\0\0\xF6\x01\0\0\xFE\0\x02\0\xF7\x01\0\08\0\x01\x006\0\x05\0\x03\0\0\0\xFA\x01\0\0\0\0\0\0\xFB\x01\0\x007\0\x03\0\x19\0\0\0\xF9\x01\0\0\xF8\0\x02\0\xF8\x01\0\0A\0\x05\0\xFC\x01\0\0\xFD\x01\0\0 \0\0\0Z\0\0\0=\0\x04\0\x12\0\0\0\xFE\x01\0\0#\0\0\0\xF9\0\x02\0\0\x02\0\0\xF8\0\x02\0\0\x02\0\0_\0\x07\0\x06\0\0\0\x01\x02\0\0\xFE\x01\0\0\xF9\x01\0\0\x02\0\0\0\xFF\x01\0\0Q\0\x05\0\x03\0\0\0\x02\x02\0\0\x01\x02\0\0\0\0\0\0A\0\x06\0G\x01\0\0\x04\x02\0\0\xFD\x01\0\0n\0\0\0Z\0\0\0=\0\x04\0\x03\0\0\0\x05\x02\0\0\x04\x02\0\0\x85\0\x05\0\x03\0\0\0\x06\x02\0\0\x02\x02\0\0\x05\x02\0\0A\0\x06\0G\x01\0\0\x07\x02\0\0\xFD\x01\0\0n\0\0\0\x9C\0\0\0=\0\x04\0\x03\0\0\0\x08\x02\0\0\x07\x02\0\0\x81\0\x05\0\x03\0\0\0\t\x02\0\0\x06\x02\0\0\x08\x02\0\0\xBA\0\x05\0\x15\0\0\0\n\x02\0\0\x02\x02\0\0\x9D\0\0\0\xA9\0\x06\0\x03\0\0\0\x0B\x02\0\0\n\x02\0\0\t\x02\0\0\x9D\0\0\0\xFE\0\x02\0\x0B\x02\0\08\0\x01\x006\0\x05\0\x14\0\0\0\x0E\x02\0\0\0\0\0\0\x0F\x02\0\x007\0\x03\0\x04\0\0\0\r\x02\0\0\xF8\0\x02\0\x0C\x02\0\0A\0\x05\0\xFC\x01\0\0\x10\x02\0\0 \0\0\0Z\0\0\0=\0\x04\0\x12\0\0\0\x11\x02\0\0#\0\0\0\xF9\0\x02\0\x12\x02\0\0\xF8\0\x02\0\x12\x02\0\0g\0\x05\0\x13\x02\0\0\x14\x02\0\0\x11\x02\0\0Z\0\0\0p\0\x04\0\x04\0\0\0\x15\x02\0\0\x14\x02\0\0\x88\0\x05\0\x04\0\0\0\x16\x02\0\0\r\x02\0\0\x15\x02\0\0A\0\x05\0m\0\0\0\x17\x02\0\0\x10\x02\0\0Z\0\0\0=\0\x04\0\x06\0\0\0\x18\x02\0\0\x17\x02\0\0O\0\x08\0\x14\0\0\0\x19\x02\0\0\x18\x02\0\0\x18\x02\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0A\0\x05\0m\0\0\0\x1A\x02\0\0\x10\x02\0\0\x9C\0\0\0=\0\x04\0\x06\0\0\0\x1B\x02\0\0\x1A\x02\0\0O\0\x08\0\x14\0\0\0\x1C\x02\0\0\x1B\x02\0\0\x1B\x02\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0\x1D\x02\0\0\x16\x02\0\0\0\0\0\0\x8E\0\x05\0\x14\0\0\0\x1E\x02\0\0\x1C\x02\0\0\x1D\x02\0\0\x81\0\x05\0\x14\0\0\0\x1F\x02\0\0\x19\x02\0\0\x1E\x02\0\0A\0\x05\0m\0\0\0 \x02\0\0\x10\x02\0\0\x08\0\0\0=\0\x04\0\x06\0\0\0!\x02\0\0 \x02\0\0O\0\x08\0\x14\0\0\0\"\x02\0\0!\x02\0\0!\x02\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0Q\0\x05\0\x03\0\0\0#\x02\0\0\x16\x02\0\0\x01\0\0\0\x8E\0\x05\0\x14\0\0\0$\x02\0\0\"\x02\0\0#\x02\0\0\x81\0\x05\0\x14\0\0\0%\x02\0\0\x1F\x02\0\0$\x02\0\0\xFE\0\x02\0%\x02\0\08\0\x01\x006\0\x05\0\x03\0\0\0*\x02\0\0\0\0\0\0+\x02\0\x007\0\x03\0\x19\0\0\0'\x02\0\x007\0\x03\0\x19\0\0\0(\x02\0\x007\0\x03\0\x03\0\0\0)\x02\0\0\xF8\0\x02\0&\x02\0\0;\0\x05\0\x0F\x01\0\x004\x02\0\0\x07\0\0\x005\x02\0\0;\0\x05\0\x0F\x01\0\x006\x02\0\0\x07\0\0\x007\x02\0\0A\0\x05\0\xFC\x01\0\0,\x02\0\0 \0\0\0Z\0\0\0=\0\x04\0\x12\0\0\0-\x02\0\0#\0\0\0\xF9\0\x02\08\x02\0\0\xF8\0\x02\08\x02\0\0g\0\x05\0\x13\x02\0\09\x02\0\0-\x02\0\0Z\0\0\0|\0\x04\0\x19\0\0\0:\x02\0\09\x02\0\0\x82\0\x05\0\x19\0\0\0;\x02\0\0:\x02\0\0/\x02\0\0\x82\0\x05\0\x19\0\0\0<\x02\0\0'\x02\0\0(\x02\0\0\x0C\0\x07\0\x19\0\0\0=\x02\0\0\x01\0\0\0*\0\0\0<\x02\0\x000\x02\0\09\0\x05\0\x03\0\0\0>\x02\0\0\xFA\x01\0\0=\x02\0\0P\0\x05\0\x19\0\0\0@\x02\0\x001\x02\0\x001\x02\0\0\x84\0\x05\0\x19\0\0\0?\x02\0\0(\x02\0\0@\x02\0\0\x82\0\x05\0\x19\0\0\0A\x02\0\0'\x02\0\0?\x02\0\0\x0C\0\x07\0\x19\0\0\0B\x02\0\0\x01\0\0\0*\0\0\0A\x02\0\x000\x02\0\09\0\x05\0\x03\0\0\0C\x02\0\0\xFA\x01\0\0B\x02\0\0\x80\0\x05\0\x19\0\0\0D\x02\0\0'\x02\0\0(\x02\0\0\x0C\0\x07\0\x19\0\0\0E\x02\0\0\x01\0\0\0'\0\0\0D\x02\0\0;\x02\0\09\0\x05\0\x03\0\0\0F\x02\0\0\xFA\x01\0\0E\x02\0\0P\0\x05\0\x19\0\0\0H\x02\0\x001\x02\0\x001\x02\0\0\x84\0\x05\0\x19\0\0\0G\x02\0\0(\x02\0\0H\x02\0\0\x80\0\x05\0\x19\0\0\0I\x02\0\0'\x02\0\0G\x02\0\0\x0C\0\x07\0\x19\0\0\0J\x02\0\0\x01\0\0\0'\0\0\0I\x02\0\0;\x02\0\09\0\x05\0\x03\0\0\0K\x02\0\0\xFA\x01\0\0J\x02\0\0\x85\0\x05\0\x03\0\0\0L\x02\0\x002\x02\0\0>\x02\0\0\x83\0\x05\0\x03\0\0\0M\x02\0\0L\x02\0\0C\x02\0\0\x83\0\x05\0\x03\0\0\0N\x02\0\0M\x02\0\0)\x02\0\0\x0C\0\x06\0\x03\0\0\0O\x02\0\0\x01\0\0\0\x04\0\0\0N\x02\0\0\x85\0\x05\0\x03\0\0\0P\x02\0\x002\x02\0\0F\x02\0\0\x83\0\x05\0\x03\0\0\0Q\x02\0\0P\x02\0\0K\x02\0\0\x83\0\x05\0\x03\0\0\0R\x02\0\0Q\x02\0\0)\x02\0\0\x0C\0\x06\0\x03\0\0\0S\x02\0\0\x01\0\0\0\x04\0\0\0R\x02\0\0P\0\x05\0\x19\0\0\0U\x02\0\x001\x02\0\x001\x02\0\0\x84\0\x05\0\x19\0\0\0T\x02\0\0(\x02\0\0U\x02\0\0\x82\0\x05\0\x19\0\0\0V\x02\0\0'\x02\0\0T\x02\0\0\xB1\0\x05\0/\x01\0\0W\x02\0\0V\x02\0\x000\x02\0\0\x9A\0\x04\0\x15\0\0\0X\x02\0\0W\x02\0\0P\0\x05\0\x19\0\0\0Z\x02\0\x001\x02\0\x001\x02\0\0\x84\0\x05\0\x19\0\0\0Y\x02\0\0(\x02\0\0Z\x02\0\0\x80\0\x05\0\x19\0\0\0[\x02\0\0'\x02\0\0Y\x02\0\0\xAD\0\x05\0/\x01\0\0\\\x02\0\0[\x02\0\0;\x02\0\0\x9A\0\x04\0\x15\0\0\0]\x02\0\0\\\x02\0\0\xA8\0\x04\0\x15\0\0\0^\x02\0\0X\x02\0\0\xF7\0\x03\0_\x02\0\0\0\0\0\0\xFA\0\x04\0^\x02\0\0`\x02\0\0a\x02\0\0\xF8\0\x02\0`\x02\0\0\xA8\0\x04\0\x15\0\0\0b\x02\0\0]\x02\0\0\xF7\0\x03\0c\x02\0\0\0\0\0\0\xFA\0\x04\0b\x02\0\0d\x02\0\0e\x02\0\0\xF8\0\x02\0d\x02\0\0\xBC\0\x05\0\x15\0\0\0f\x02\0\0O\x02\0\0S\x02\0\0>\0\x03\x006\x02\0\0f\x02\0\0\xF9\0\x02\0c\x02\0\0\xF8\0\x02\0e\x02\0\0>\0\x03\x006\x02\0\x003\x02\0\0\xF9\0\x02\0c\x02\0\0\xF8\0\x02\0c\x02\0\0=\0\x04\0\x15\0\0\0g\x02\0\x006\x02\0\0>\0\x03\x004\x02\0\0g\x02\0\0\xF9\0\x02\0_\x02\0\0\xF8\0\x02\0a\x02\0\0>\0\x03\x004\x02\0\0\r\x01\0\0\xF9\0\x02\0_\x02\0\0\xF8\0\x02\0_\x02\0\0=\0\x04\0\x15\0\0\0h\x02\0\x004\x02\0\0\x83\0\x05\0\x03\0\0\0i\x02\0\0F\x02\0\0)\x02\0\0\x83\0\x05\0\x03\0\0\0j\x02\0\0)\x02\0\0>\x02\0\0\xA9\0\x06\0\x03\0\0\0k\x02\0\0h\x02\0\0j\x02\0\0i\x02\0\0\xFE\0\x02\0k\x02\0\08\0\x01\x006\0\x05\0\x14\0\0\0p\x02\0\0\0\0\0\0q\x02\0\x007\0\x03\0\x19\0\0\0m\x02\0\x007\0\x03\0\x14\0\0\0n\x02\0\x007\0\x03\0\x03\0\0\0o\x02\0\0\xF8\0\x02\0l\x02\0\0A\0\x05\0\xFC\x01\0\0r\x02\0\0 \0\0\0Z\0\0\0=\0\x04\0\x12\0\0\0s\x02\0\0#\0\0\0\xF9\0\x02\0v\x02\0\0\xF8\0\x02\0v\x02\0\0g\0\x05\0\x13\x02\0\0w\x02\0\0s\x02\0\0Z\0\0\0p\0\x04\0\x04\0\0\0x\x02\0\0w\x02\0\09\0\x07\0\x03\0\0\0y\x02\0\0*\x02\0\0m\x02\0\0t\x02\0\0o\x02\0\0Q\0\x05\0\x03\0\0\0z\x02\0\0x\x02\0\0\0\0\0\0\x85\0\x05\0\x03\0\0\0{\x02\0\0y\x02\0\0z\x02\0\09\0\x07\0\x03\0\0\0|\x02\0\0*\x02\0\0m\x02\0\0u\x02\0\0o\x02\0\0Q\0\x05\0\x03\0\0\0}\x02\0\0x\x02\0\0\x01\0\0\0\x85\0\x05\0\x03\0\0\0~\x02\0\0|\x02\0\0}\x02\0\0A\0\x05\0m\0\0\0\x7F\x02\0\0r\x02\0\0\x9C\0\0\0=\0\x04\0\x06\0\0\0\x80\x02\0\0\x7F\x02\0\0O\0\x08\0\x14\0\0\0\x81\x02\0\0\x80\x02\0\0\x80\x02\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0A\0\x05\0m\0\0\0\x82\x02\0\0r\x02\0\0\x08\0\0\0=\0\x04\0\x06\0\0\0\x83\x02\0\0\x82\x02\0\0O\0\x08\0\x14\0\0\0\x84\x02\0\0\x83\x02\0\0\x83\x02\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\x0C\0\x07\0\x14\0\0\0\x85\x02\0\0\x01\0\0\0D\0\0\0\x81\x02\0\0\x84\x02\0\0\x8E\0\x05\0\x14\0\0\0\x86\x02\0\0\x85\x02\0\0o\x02\0\0\x0C\0\x07\0\x14\0\0\0\x87\x02\0\0\x01\0\0\0D\0\0\0\x84\x02\0\0n\x02\0\0\x8E\0\x05\0\x14\0\0\0\x88\x02\0\0\x87\x02\0\0{\x02\0\0\x81\0\x05\0\x14\0\0\0\x89\x02\0\0\x86\x02\0\0\x88\x02\0\0\x0C\0\x07\0\x14\0\0\0\x8A\x02\0\0\x01\0\0\0D\0\0\0n\x02\0\0\x81\x02\0\0\x8E\0\x05\0\x14\0\0\0\x8B\x02\0\0\x8A\x02\0\0~\x02\0\0\x81\0\x05\0\x14\0\0\0\x8C\x02\0\0\x89\x02\0\0\x8B\x02\0\0\x7F\0\x04\0\x14\0\0\0\x8D\x02\0\0\x8C\x02\0\0\x94\0\x05\0\x03\0\0\0\x8E\x02\0\0\x8C\x02\0\0n\x02\0\0\xBA\0\x05\0\x15\0\0\0\x8F\x02\0\0\x8E\x02\0\0\x9D\0\0\0P\0\x06\0\x91\x02\0\0\x92\x02\0\0\x8F\x02\0\0\x8F\x02\0\0\x8F\x02\0\0\xA9\0\x06\0\x14\0\0\0\x90\x02\0\0\x92\x02\0\0\x8D\x02\0\0\x8C\x02\0\0\x0C\0\x06\0\x14\0\0\0\x93\x02\0\0\x01\0\0\0E\0\0\0\x90\x02\0\0\xFE\0\x02\0\x93\x02\0\08\0\x01\x006\0\x05\0\x02\0\0\0\x9A\x02\0\0\0\0\0\0\x9B\x02\0\0\xF8\0\x02\0\x94\x02\0\0=\0\x04\0\x05\0\0\0\x97\x02\0\0\x95\x02\0\0\xF9\0\x02\0\x9E\x02\0\0\xF8\0\x02\0\x9E\x02\0\0\xAA\0\x05\0\x15\0\0\0\x9F\x02\0\0\x97\x02\0\0\x08\0\0\0\xA9\0\x06\0\x03\0\0\0\xA0\x02\0\0\x9F\x02\0\0\x9C\x02\0\0\x80\x01\0\0\xAA\0\x05\0\x15\0\0\0\xA1\x02\0\0\x97\x02\0\0\x9C\0\0\0\xA9\0\x06\0\x03\0\0\0\xA2\x02\0\0\xA1\x02\0\0\x9D\x02\0\0\x1F\0\0\0P\0\x07\0\x06\0\0\0\xA3\x02\0\0\xA0\x02\0\0\xA2\x02\0\0\x9D\0\0\0\x1F\0\0\0>\0\x03\0\x98\x02\0\0\xA3\x02\0\0\xFD\0\x01\08\0\x01\x006\0\x05\0\x02\0\0\0\xA9\x02\0\0\0\0\0\0\x9B\x02\0\0\xF8\0\x02\0\xA4\x02\0\0=\0\x04\0\x06\0\0\0\xA7\x02\0\0\xA5\x02\0\0A\0\x05\0\xFC\x01\0\0\xAA\x02\0\0 \0\0\0Z\0\0\0=\0\x04\0\x12\0\0\0\xAB\x02\0\0#\0\0\0A\0\x05\0Y\0\0\0\xAC\x02\0\0%\0\0\0Z\0\0\0=\0\x04\0\x12\0\0\0\xAD\x02\0\0(\0\0\0=\0\x04\0\x13\0\0\0\xAE\x02\0\0)\0\0\0\xF9\0\x02\0\xB0\x02\0\0\xF8\0\x02\0\xB0\x02\0\0O\0\x07\0\x04\0\0\0\xB1\x02\0\0\xA7\x02\0\0\xA7\x02\0\0\0\0\0\0\x01\0\0\0\x0C\0\x08\0\x04\0\0\0\xB6\x02\0\0\x01\0\0\0+\0\0\0\xB1\x02\0\0\xB3\x02\0\0\xB5\x02\0\0n\0\x04\0\x19\0\0\0\xB7\x02\0\0\xB6\x02\0\09\0\x05\0\x03\0\0\0\xB8\x02\0\0\xFA\x01\0\0\xB7\x02\0\0\xBC\0\x05\0\x15\0\0\0\xB9\x02\0\0\xB8\x02\0\0\x9D\0\0\0\xF7\0\x03\0\xBA\x02\0\0\0\0\0\0\xFA\0\x04\0\xB9\x02\0\0\xBB\x02\0\0\xBA\x02\0\0\xF8\0\x02\0\xBB\x02\0\0>\0\x03\0\xA8\x02\0\0\xAF\x02\0\0\xFD\0\x01\0\xF8\0\x02\0\xBA\x02\0\0O\0\x07\0\x04\0\0\0\xBC\x02\0\0\xA7\x02\0\0\xA7\x02\0\0\0\0\0\0\x01\0\0\09\0\x05\0\x14\0\0\0\xBD\x02\0\0\x0E\x02\0\0\xBC\x02\0\0O\0\x07\0\x04\0\0\0\xBE\x02\0\0\xA7\x02\0\0\xA7\x02\0\0\0\0\0\0\x01\0\0\0\x0C\0\x08\0\x04\0\0\0\xBF\x02\0\0\x01\0\0\0+\0\0\0\xBE\x02\0\0\xB3\x02\0\0\xB5\x02\0\0n\0\x04\0\x19\0\0\0\xC0\x02\0\0\xBF\x02\0\09\0\x07\0\x14\0\0\0\xC1\x02\0\0p\x02\0\0\xC0\x02\0\0\xBD\x02\0\0\xB8\x02\0\0P\0\x06\0\x14\0\0\0\xC2\x02\0\0\xB8\x02\0\0\xB8\x02\0\0\xB8\x02\0\0\x88\0\x05\0\x14\0\0\0\xC3\x02\0\0\xBD\x02\0\0\xC2\x02\0\09\0\x06\0\x03\0\0\0\xC4\x02\0\0\xE8\x01\0\0\xC3\x02\0\0\xC1\x02\0\0P\0\x07\0\x06\0\0\0\xC5\x02\0\0\xC4\x02\0\0\x9D\0\0\0\x9D\0\0\0\x1F\0\0\0>\0\x03\0\xA8\x02\0\0\xC5\x02\0\0\xFD\0\x01\08\0\x01\0";
    /// WGSL of the function shader.
    pub const FUNCTION_WGSL: &str = r#"// SunLog: visibility of a point, for the engine's own materials.
// Positions and normals are relative to the eye, in camera axes: x right, y up, looking along -z.
// Sun over an open world without a step: face columns whose rows run with the logarithm of distance, casters that
// span many rows decided pixel by pixel.
// Generated from light case `SunLog`, ed72eb4d5233de5a. Do not edit.

/// Width and height of the map in texels.
const SUN_LOG_MAP_SIZE: vec2<f32> = vec2<f32>(2048.0, 2048.0);
/// Sectors around the eye.
const SUN_LOG_SECTORS: u32 = 4u;
/// Bands of distance in each sector.
const SUN_LOG_BANDS: u32 = 8u;
/// Vectors of four band limits in each sector.
const SUN_LOG_THRESHOLD_VECTORS: u32 = 2u;
/// Texels along the rows that edges of casters may be off.
const SUN_LOG_STRETCH_BOUND: f32 = 0.25;

/// What resolving needs of one facet; all zero where a plan has none.
struct SunLogFacet {
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
    /// How y/w becomes clip y: shifts and scales of a monotone curve.
    remap: array<vec4<f32>, 2>,
}

/// What resolving needs of a plan.
struct SunLogShadow {
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
    facets: array<SunLogFacet, 32>,
}

/// The plan.
@group(2) @binding(0)
var<uniform> sun_log_shadow: SunLogShadow;
/// The shadow map.
@group(2) @binding(1)
var sun_log_map: texture_depth_2d;
/// Takes the nearest texel, clamps to the edge.
@group(2) @binding(2)
var sun_log_map_sampler: sampler;

/// Clip y after division, of one over distance.
fn sun_log_remapped(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].y + remap[1].z * inverse_distance;
    }
    return remap[0].x + remap[0].y * log(inverse_distance * remap[0].z);
}

/// Change of clip y after division per change of one over distance.
fn sun_log_remap_slope(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].z;
    }
    return remap[0].y / inverse_distance;
}

/// Two to the power of -23: the last bit of a float's mantissa.
const SUN_LOG_LAST_BIT: f32 = 1.1920928955078125e-7;

/// The position as facet rows take it: moved along the light to the plane z = 0, z kept.
///
/// What is added may cancel the position nearly, so its products must not be rounded, and a fused multiplication is not
/// to be had everywhere. The leading parts of the shear have twelve bits; so have both halves of z. The lower half is
/// taken as a whole number, from which no compiler finds the way back to one rounded product.
fn sun_log_facet_position(position: vec3<f32>) -> vec3<f32> {
    // Split z.
    let bits = bitcast<u32>(position.z);
    let upper = bitcast<f32>(bits & 0xfffff000u);
    let lower = f32(bits & 0xfffu);
    let step = bitcast<f32>(bits & 0xff800000u) * SUN_LOG_LAST_BIT;

    // Add the largest product first: each sum is exact while it cancels.
    var moved = position.xy + sun_log_shadow.shear.xy * upper;
    moved += (sun_log_shadow.shear.xy * step) * lower;
    moved += sun_log_shadow.shear.zw * position.z;
    return vec3<f32>(moved, position.z);
}

/// The normal as facet rows take it.
fn sun_log_facet_normal(normal: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(normal.xy, normal.z - dot(sun_log_shadow.shear.xy + sun_log_shadow.shear.zw, normal.xy));
}

/// Finds the sector of a receiver: its first border decides the direction, then each border is passed or not.
fn sun_log_sector_index(position: vec3<f32>) -> u32 {
    let point = vec4<f32>(position, 1.0);

    // Walk forwards from the ring's start up to the first border that is not passed, and backwards from its end down to
    // the first that is: both at once, without a branch.
    var is_ahead = 1u;
    var forwards = 0u;
    var backwards = 0u;
    for (var border = 1u; border < SUN_LOG_SECTORS; border += 1u) {
        let is_passed = dot(sun_log_shadow.borders[border], point) >= 0.0;
        is_ahead = select(0u, is_ahead, is_passed);
        forwards += is_ahead;
        backwards = select(backwards, border, is_passed);
    }
    return select(backwards, forwards, dot(sun_log_shadow.borders[0], point) >= 0.0);
}

/// Finds the facet of a receiver: its sector, then the number of that sector's thresholds that its distance has
/// reached.
fn sun_log_facet_index(position: vec3<f32>) -> u32 {
    let sector = sun_log_sector_index(position);
    let distance = dot(sun_log_shadow.distances[sector], vec4<f32>(position, 1.0));
    var reached = vec4<u32>(0u);
    for (var index = 0u; index < SUN_LOG_THRESHOLD_VECTORS; index += 1u) {
        let limits = sun_log_shadow.thresholds[sector * SUN_LOG_THRESHOLD_VECTORS + index];
        reached += select(vec4<u32>(0u), vec4<u32>(1u), vec4<f32>(distance) >= limits);
    }
    return sector * SUN_LOG_BANDS + min(reached.x + reached.y + reached.z + reached.w, SUN_LOG_BANDS - 1u);
}

/// The facet of a receiver.
fn sun_log_own_facet(position: vec3<f32>) -> SunLogFacet {
    return sun_log_shadow.facets[sun_log_facet_index(position)];
}

/// Where a receiver falls in its facet.
struct SunLogPlace {
    /// Clip space of the tile after division: x and y in [-1, 1], z growing away from the light.
    ndc: vec3<f32>,
    /// What was divided by.
    w: f32,
    /// What the remap took to y: one over distance in metres.
    inverse_distance: f32,
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Whether every texel that a filter takes here belongs to the tile.
    covered: bool,
}

/// Applies a facet's matrix, row by row, to a position relative to the eye.
fn sun_log_place_in_facet(facet: SunLogFacet, position: vec3<f32>) -> SunLogPlace {
    let point = vec4<f32>(position, 1.0);
    let w = dot(facet.row_w, point);
    let clip = vec3<f32>(dot(facet.row_x, point), dot(facet.row_y, point), dot(facet.row_z, point));
    let straight = clip / w;
    let ndc = vec3<f32>(straight.x, sun_log_remapped(facet.remap, straight.y), straight.z);
    let texel = ndc.xy * facet.texel_from_ndc.xy + facet.texel_from_ndc.zw;

    // Facets without receivers are all zero, so w refuses them.
    let inside = all(texel >= facet.texel_limits.xy) && all(texel <= facet.texel_limits.zw);
    return SunLogPlace(ndc, w, straight.y, texel, w > 0.0 && inside);
}

/// The nearest signed depth that the map can hold.
fn sun_log_held_depth(depth: f32) -> f32 {
    return clamp(depth, min(sun_log_shadow.depth_sign, 0.0), max(sun_log_shadow.depth_sign, 0.0));
}

/// Share of light that each of four stored depths lets through to its signed reference: all or none.
fn sun_log_lit_by_four(references: vec4<f32>, stored: vec4<f32>) -> vec4<f32> {
    return select(vec4<f32>(0.0), vec4<f32>(1.0), references <= sun_log_shadow.depth_sign * stored);
}

/// A receiver in the map, with its plane.
struct SunLogReceiver {
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Depth of the lowered plane at the receiver itself.
    reference: f32,
    /// Change of the plane's depth per texel along x and y.
    gradient: vec2<f32>,
}

/// Depth of the receiver's plane at an offset in texels, within the depths that the map can hold.
fn sun_log_plane_reference(receiver: SunLogReceiver, offset: vec2<f32>) -> f32 {
    return sun_log_held_depth(receiver.reference + dot(receiver.gradient, offset));
}

/// Gradient of clip y after division, times w.
fn sun_log_up_gradient(facet: SunLogFacet, place: SunLogPlace) -> vec3<f32> {
    let straight = facet.row_y.xyz - place.inverse_distance * facet.row_w.xyz;
    return straight * sun_log_remap_slope(facet.remap, place.inverse_distance);
}

/// Largest change of depth from one texel to the next that a plane is followed to: the map's whole range.
const SUN_LOG_STEEPEST_PLANE: f32 = 1.0;

/// Change of depth per texel along x and y over the plane through a receiver; a normal of any length will do.
fn sun_log_plane_gradient(facet: SunLogFacet, place: SunLogPlace, normal: vec3<f32>) -> vec2<f32> {
    // Take the gradients of the facet's coordinates; their common factor 1/w cancels below.
    let across = facet.row_x.xyz - place.ndc.x * facet.row_w.xyz;
    let up = sun_log_up_gradient(facet, place);
    let away = facet.row_z.xyz - place.ndc.z * facet.row_w.xyz;

    // Solve for the depth that x and y change by while the point stays on the plane.
    let area = dot(normal, cross(across, up));
    let slope = vec2<f32>(dot(away, cross(up, normal)), dot(away, cross(normal, across)));

    // Turn it into depth per texel; a plane that the light only grazes is as steep as the map allows.
    let exact = slope / (area * facet.texel_from_ndc.xy);
    let followed = clamp(exact, vec2<f32>(-SUN_LOG_STEEPEST_PLANE), vec2<f32>(SUN_LOG_STEEPEST_PLANE));
    return select(followed, vec2<f32>(0.0), area == 0.0);
}

/// The receiver with the plane through it; a normal of any length will do.
fn sun_log_biased_receiver(facet: SunLogFacet, place: SunLogPlace, normal: vec3<f32>) -> SunLogReceiver {
    let gradient = sun_log_plane_gradient(facet, place, normal);
    let lowered = facet.receiver_plane_depth + SUN_LOG_STRETCH_BOUND * abs(gradient.y);
    return SunLogReceiver(place.texel, place.ndc.z - lowered, gradient);
}

/// Share of light that reaches the receiver.
fn sun_log_filtered_visibility(receiver: SunLogReceiver) -> f32 {
    // Gather around the corner that the four texels share: rounding cannot reach another four from there.
    let corner = floor(receiver.texel - 0.5) + 1.0;
    let stored = textureGather(sun_log_map, sun_log_map_sampler, corner / SUN_LOG_MAP_SIZE);

    // Follow the plane to each centre; a gather begins at the lower left and runs against the clock.
    let offset = corner - receiver.texel;
    let references = vec4<f32>(
        sun_log_plane_reference(receiver, offset + vec2<f32>(-0.5, 0.5)),
        sun_log_plane_reference(receiver, offset + vec2<f32>(0.5, 0.5)),
        sun_log_plane_reference(receiver, offset + vec2<f32>(0.5, -0.5)),
        sun_log_plane_reference(receiver, offset + vec2<f32>(-0.5, -0.5)),
    );

    // Compare, then blend.
    let lit = sun_log_lit_by_four(references, stored);
    let weight = vec2<f32>(0.5) - offset;
    return mix(mix(lit.w, lit.z, weight.x), mix(lit.x, lit.y, weight.x), weight.y);
}

/// Share of the light that reaches a receiver: 1 in the light and outside the map, 0 in shadow.
///
/// `position` is relative to the eye, in metres; `normal` is the geometric normal there; both are in the case's axes.
/// The function takes no derivatives, so any control flow may call it.
fn sun_log_visibility(position: vec3<f32>, normal: vec3<f32>) -> f32 {
    let point = sun_log_facet_position(position);
    let facet = sun_log_own_facet(point);
    let place = sun_log_place_in_facet(facet, point);
    if !place.covered {
        return 1.0;
    }
    return sun_log_filtered_visibility(sun_log_biased_receiver(facet, place, sun_log_facet_normal(normal)));
}
"#;
}
