//! From a case to its table.

use std::borrow::Cow;

use super::filter;
use super::{
    BindGroup, Binding, BindingKind, CaseTable, Constant, ConstantKind, ConstantValue, FieldType,
    GroupContent, Meaning, Pass, Record, RecordField, RecordKind, Reduction, Resource, ShaderKind,
};
use crate::case::{Bias, Casters, Filter, LightCase, MaskDepth, MaskNormal, Resolve, Stretch};
use crate::distribution::RemapKind;
use crate::facet::FacetShape;
use crate::fit;

impl CaseTable {
    /// Records, bindings and passes of a case; shaders are left empty.
    pub fn describe(case: &LightCase) -> Self {
        let shape = case.shape();
        let names = Names { prefix: &case.prefix };
        let mut records = Vec::new();
        let mut groups = Vec::new();
        let mut passes = Vec::new();
        for shader in capture_shaders(case) {
            groups.push(capture_group(&names, *shader));
            if bends_exactly(case) {
                groups.push(caster_mesh_group(&names, *shader));
            }
            if is_tested(*shader) {
                groups.push(caster_mask_group(&names, *shader, if bends_exactly(case) { 2 } else { 1 }));
            }
            passes.push(capture_pass(&names, *shader));
        }

        if case.filter.is_prefiltered() {
            for shader in [ShaderKind::PrefilterRows, ShaderKind::PrefilterColumns] {
                groups.push(filter::prefilter_group(&names, case.filter, shader));
                passes.push(filter::prefilter_pass(&names, case.filter, shader));
            }
        }

        // Resolving shares one record and one group layout between its interfaces.
        records.push(facet_record(&names, case));
        records.push(shadow_record(&names, case, records[0].size_bytes));
        records.push(capture_record(&names, case));
        if case.casters == Casters::AlphaTested {
            records.push(caster_mask_record(&names));
        }
        for interface in &case.resolve {
            match *interface {
                Resolve::Mask { depth, normal } => {
                    records.push(mask_record(&names, depth));
                    groups.push(mask_group(&names, depth, normal));
                    groups.push(shadow_group(&names, case, ShaderKind::Mask, 1));
                    passes.push(mask_pass(&names, case.filter, normal));
                }
                Resolve::Function { group, .. } => {
                    groups.push(shadow_group(&names, case, ShaderKind::Function, group));
                }
            }
        }

        // Depth is measured where the case is fitted to it and says how it is stored.
        let depth = case.resolve.iter().find_map(|interface| match interface {
            Resolve::Mask { depth, .. } => Some(*depth),
            Resolve::Function { .. } => None,
        });
        let reduction = depth.filter(|_| case.fit.measures_depth()).map(|depth| {
            records.push(fit_record(&names, depth));
            groups.push(fit_group(&names, depth));
            Reduction {
                entry: names.value("fit_measure"),
                square_pixels: fit::SQUARE_PIXELS,
                words: fit::WORDS as u32,
            }
        });

        Self {
            case: case.name.clone().into(),
            prefix: case.prefix.clone().into(),
            fingerprint: fingerprint(case),
            map_width: case.map.width,
            map_height: case.map.height,
            map_format: case.map.format,
            halves: shape.halves,
            sectors: shape.sectors,
            bands: shape.bands,
            clips: shape.clips,
            dominant: shape.dominant,
            scales_thresholds: case.scales_thresholds(),
            local_light: case.light.is_local(),
            remap: case.remap(),
            stretch: case.stretch,
            may_reverse_depth: case.may_reverse_depth(),
            axes: case.axes,
            shears: case.shears(),
            fetches_per_pixel: filter::fetches_per_pixel(case.filter),
            constants: constants(&names, case).into(),
            records: records.into(),
            groups: groups.into(),
            passes: passes.into(),
            reduction,
            shaders: Cow::Borrowed(&[]),
        }
    }
}

/// Whether triangles are decided texel by texel where rows are bent.
fn bends_exactly(case: &LightCase) -> bool {
    matches!(case.stretch, Stretch::Exact { .. }) && case.remap() != RemapKind::None
}

/// The capture shaders of a case. Casters with an alpha mask have a fragment stage in any case, so that all their triangles
/// are decided texel by texel where some are.
fn capture_shaders(case: &LightCase) -> &'static [ShaderKind] {
    use ShaderKind::{
        Capture, CaptureBent, CaptureBentTested, CaptureClamped, CaptureTested, CaptureTestedClamped,
    };
    match (bends_exactly(case), case.casters) {
        (false, Casters::Opaque) => &[Capture, CaptureClamped],
        (false, Casters::AlphaTested) => &[Capture, CaptureClamped, CaptureTested, CaptureTestedClamped],
        (true, Casters::Opaque) => &[Capture, CaptureClamped, CaptureBent],
        (true, Casters::AlphaTested) => &[Capture, CaptureClamped, CaptureBent, CaptureBentTested],
    }
}

const fn is_tested(shader: ShaderKind) -> bool {
    matches!(
        shader,
        ShaderKind::CaptureTested | ShaderKind::CaptureTestedClamped | ShaderKind::CaptureBentTested
    )
}

/// Emitted names of a case: `sun_mask_vertex`, `SunFacet`.
pub(super) struct Names<'a> {
    prefix: &'a str,
}

impl Names<'_> {
    pub(super) fn value(&self, name: &str) -> Cow<'static, str> {
        format!("{}_{name}", self.prefix).into()
    }

    fn constant(&self, name: &str) -> Cow<'static, str> {
        format!("{}_{name}", self.prefix.to_ascii_uppercase()).into()
    }

    fn ty(&self, name: &str) -> Cow<'static, str> {
        let mut camel = String::new();
        for part in self.prefix.split('_') {
            let mut letters = part.chars();
            camel.extend(letters.next().map(|first| first.to_ascii_uppercase()));
            camel.push_str(letters.as_str());
        }
        format!("{camel}{name}").into()
    }
}

fn constants(names: &Names, case: &LightCase) -> Vec<Constant> {
    let shape = case.shape();
    let mut constants = Vec::new();
    let mut push = |kind: ConstantKind, value: ConstantValue| {
        constants.push(Constant { kind, name: names.constant(kind.name()), value });
    };
    if case.filter != Filter::None {
        let size = [case.map.width as f32, case.map.height as f32];
        push(ConstantKind::MapSize, ConstantValue::Vec2(size));
    }
    filter::constants(case.filter, &mut push);
    if shape.sectors > 1 {
        push(ConstantKind::Sectors, ConstantValue::U32(shape.sectors));
    }
    if shape.bands > 1 {
        push(ConstantKind::Bands, ConstantValue::U32(shape.bands));
        push(ConstantKind::ThresholdVectors, ConstantValue::U32(threshold_vectors(shape)));
    }
    if let Stretch::Exact { bound_texels } = case.stretch
        && bends_exactly(case)
    {
        push(ConstantKind::StretchBound, ConstantValue::F32(bound_texels as f32));
    }
    if shape.dominant {
        push(ConstantKind::Dominant, ConstantValue::U32(shape.cells() - 1));
    }
    match case.bias {
        Bias::None | Bias::ReceiverPlane => {}
        Bias::Constant { along_light_metres } => {
            push(ConstantKind::BiasMetres, ConstantValue::F32(along_light_metres as f32));
        }
        Bias::Slope { texels } => push(ConstantKind::BiasTexels, ConstantValue::F32(texels as f32)),
        Bias::WorldTexel { a_metres, b_texels } => {
            push(ConstantKind::BiasAMetres, ConstantValue::F32(a_metres as f32));
            push(ConstantKind::BiasBTexels, ConstantValue::F32(b_texels as f32));
        }
    }
    constants
}

/// Vectors that tell where a plane lies in a tile.
pub(super) const VECTORS_A_PLANE: u32 = 4;

/// Vectors of four thresholds in each sector.
fn threshold_vectors(shape: FacetShape) -> u32 {
    shape.bands.saturating_sub(1).div_ceil(4)
}

/// Lays fields out by the uniform address space's rules.
struct Layout {
    fields: Vec<RecordField>,
    next: u32,
}

impl Layout {
    fn new() -> Self {
        Self { fields: Vec::new(), next: 0 }
    }

    fn push(&mut self, name: &str, meaning: Meaning, ty: FieldType) {
        let (size, align) = match ty {
            FieldType::F32 => (4, 4),
            FieldType::Vec2 => (8, 8),
            FieldType::Vec4 => (16, 16),
            // Facets stand in arrays alone, whose stride is given.
            FieldType::Facet => (0, 16),
        };
        let offset_bytes = self.next.next_multiple_of(align);
        self.next = offset_bytes + size;
        let name = name.to_owned().into();
        self.fields.push(RecordField { name, meaning, ty, elements: 0, offset_bytes, stride_bytes: 0 });
    }

    fn push_array(&mut self, name: &str, meaning: Meaning, ty: FieldType, elements: u32, stride_bytes: u32) {
        let offset_bytes = self.next.next_multiple_of(16);
        self.next = offset_bytes + elements * stride_bytes;
        let name = name.to_owned().into();
        self.fields.push(RecordField { name, meaning, ty, elements, offset_bytes, stride_bytes });
    }

    fn record(self, kind: RecordKind, name: Cow<'static, str>) -> Record {
        Record { kind, name, size_bytes: self.next.next_multiple_of(16), fields: self.fields.into() }
    }
}

fn push_rows(layout: &mut Layout) {
    layout.push("row_x", Meaning::RowX, FieldType::Vec4);
    layout.push("row_y", Meaning::RowY, FieldType::Vec4);
    layout.push("row_z", Meaning::RowZ, FieldType::Vec4);
    layout.push("row_w", Meaning::RowW, FieldType::Vec4);
}

fn push_remap(layout: &mut Layout, case: &LightCase) {
    match case.remap() {
        RemapKind::None => {}
        RemapKind::Perspective => layout.push("remap", Meaning::Remap, FieldType::Vec4),
        RemapKind::Logarithmic => layout.push_array("remap", Meaning::Remap, FieldType::Vec4, 2, 16),
    }
}

fn facet_record(names: &Names, case: &LightCase) -> Record {
    let mut layout = Layout::new();
    push_rows(&mut layout);
    layout.push("texel_from_ndc", Meaning::TexelFromNdc, FieldType::Vec4);
    layout.push("texel_limits", Meaning::TexelLimits, FieldType::Vec4);
    let biased_by_metres =
        matches!(case.bias, Bias::Constant { .. } | Bias::Slope { .. } | Bias::WorldTexel { .. });
    if biased_by_metres || case.filter.measures_depth() {
        layout.push("depth_per_metre", Meaning::DepthPerMetre, FieldType::F32);
    }
    match case.bias {
        Bias::None | Bias::Constant { .. } => {}
        Bias::Slope { .. } | Bias::WorldTexel { .. } => {
            layout.push("texel_metres_per_w", Meaning::TexelMetresPerW, FieldType::F32);
        }
        Bias::ReceiverPlane => {
            layout.push("receiver_plane_depth", Meaning::ReceiverPlaneDepth, FieldType::F32);
            if case.light.is_local() {
                layout.push("rounding_depth", Meaning::RoundingDepth, FieldType::F32);
            }
        }
    }
    push_remap(&mut layout, case);
    layout.record(RecordKind::Facet, names.ty(RecordKind::Facet.name()))
}

fn shadow_record(names: &Names, case: &LightCase, facet_bytes: u32) -> Record {
    let shape = case.shape();
    let mut layout = Layout::new();
    let rings = shape.halves * shape.sectors;
    if shape.dominant {
        layout.push_array("dominant", Meaning::Dominant, FieldType::Vec4, 2, 16);
    }
    if shape.halves > 1 {
        layout.push("split", Meaning::Split, FieldType::Vec4);
    }
    if shape.sectors > 1 {
        layout.push_array("borders", Meaning::Borders, FieldType::Vec4, rings, 16);
    }
    if shape.bands > 1 {
        layout.push_array("distances", Meaning::Distances, FieldType::Vec4, rings, 16);
        if case.scales_thresholds() {
            layout.push_array("units", Meaning::Units, FieldType::Vec4, rings, 16);
        }
        let vectors = rings * threshold_vectors(shape);
        layout.push_array("thresholds", Meaning::Thresholds, FieldType::Vec4, vectors, 16);
    }
    if case.light.is_local() && case.bias != Bias::None {
        layout.push("light_position", Meaning::LightPosition, FieldType::Vec4);
    }
    if matches!(case.bias, Bias::Slope { .. }) && !case.light.is_local() {
        layout.push("toward_light", Meaning::TowardLight, FieldType::Vec4);
    }
    if case.shears() {
        layout.push("shear", Meaning::Shear, FieldType::Vec4);
    }
    if case.filter.measures_pixels() {
        layout.push("pixel_metres", Meaning::PixelMetres, FieldType::Vec4);
    }
    if case.may_reverse_depth() {
        layout.push("depth_sign", Meaning::DepthSign, FieldType::F32);
    }
    let (planes, cells) = (case.filter.ground_planes(), shape.cells());
    if planes > 0 {
        layout.push_array("ground_planes", Meaning::GroundPlanes, FieldType::Vec4, planes, 16);
        let vectors = cells * planes * VECTORS_A_PLANE;
        layout.push_array("ground_tiles", Meaning::GroundTiles, FieldType::Vec4, vectors, 16);
    }
    if planes > 0 && shape.clips > 0 {
        let vectors = cells * shape.clips;
        layout.push_array("ground_edges", Meaning::GroundEdges, FieldType::Vec4, vectors, 16);
    }
    layout.push_array("facets", Meaning::Facets, FieldType::Facet, shape.cells(), facet_bytes);
    layout.record(RecordKind::Shadow, names.ty(RecordKind::Shadow.name()))
}

fn capture_record(names: &Names, case: &LightCase) -> Record {
    let shape = case.shape();
    let mut layout = Layout::new();
    push_rows(&mut layout);
    push_remap(&mut layout, case);
    if case.remap() != RemapKind::None {
        layout.push("tile_size", Meaning::TileSize, FieldType::Vec2);
    }
    if bends_exactly(case) {
        layout.push("stretch_tile", Meaning::StretchTile, FieldType::Vec4);
    }
    if shape.clips > 0 {
        layout.push_array("clips", Meaning::Clips, FieldType::Vec4, shape.clips, 16);
    }
    layout.record(RecordKind::Capture, names.ty(RecordKind::Capture.name()))
}

fn caster_mask_record(names: &Names) -> Record {
    let mut layout = Layout::new();
    layout.push("alpha_cutoff", Meaning::AlphaCutoff, FieldType::F32);
    layout.record(RecordKind::CasterMask, names.ty(RecordKind::CasterMask.name()))
}

fn mask_record(names: &Names, depth: MaskDepth) -> Record {
    let mut layout = Layout::new();
    layout.push("ray_corner", Meaning::RayCorner, FieldType::Vec4);
    layout.push("ray_across", Meaning::RayAcross, FieldType::Vec4);
    layout.push("ray_down", Meaning::RayDown, FieldType::Vec4);
    if depth == MaskDepth::ReversedZ {
        layout.push("inverse_depth", Meaning::InverseDepth, FieldType::Vec2);
    }
    layout.record(RecordKind::Mask, names.ty(RecordKind::Mask.name()))
}

fn fit_record(names: &Names, depth: MaskDepth) -> Record {
    let mut layout = Layout::new();
    if depth == MaskDepth::ReversedZ {
        layout.push("inverse_depth", Meaning::InverseDepth, FieldType::Vec2);
    }
    layout.push("per_near", Meaning::PerNear, FieldType::F32);
    layout.record(RecordKind::Fit, names.ty(RecordKind::Fit.name()))
}

fn fit_group(names: &Names, depth: MaskDepth) -> BindGroup {
    let view = BindingKind::Uniform { record: RecordKind::Fit, dynamic_offset: false };
    let bindings = vec![
        Binding { binding: 0, name: names.value("fit"), kind: view },
        Binding { binding: 1, name: names.value("scene_depth"), kind: scene_depth(depth) },
        Binding { binding: 2, name: names.value("measured"), kind: BindingKind::Measured },
    ];
    BindGroup { shader: ShaderKind::Fit, content: GroupContent::Fit, group: 0, bindings: bindings.into() }
}

const fn scene_depth(depth: MaskDepth) -> BindingKind {
    match depth {
        MaskDepth::ReversedZ => BindingKind::SceneDepth,
        MaskDepth::Linear => BindingKind::SceneLinearDepth,
    }
}

fn capture_group(names: &Names, shader: ShaderKind) -> BindGroup {
    let kind = BindingKind::Uniform { record: RecordKind::Capture, dynamic_offset: true };
    let bindings = vec![Binding { binding: 0, name: names.value("capture"), kind }];
    BindGroup { shader, content: GroupContent::CaptureFacet, group: 0, bindings: bindings.into() }
}

fn caster_mesh_group(names: &Names, shader: ShaderKind) -> BindGroup {
    let kinds = [
        ("mesh_layout", BindingKind::MeshLayout),
        ("mesh_positions", BindingKind::MeshPositions),
        ("mesh_indices", BindingKind::MeshIndices),
        ("mesh_uvs", BindingKind::MeshUvs),
    ];
    let bindings: Vec<_> = (0..)
        .zip(kinds)
        .filter(|(_, (_, kind))| *kind != BindingKind::MeshUvs || is_tested(shader))
        .map(|(binding, (name, kind))| Binding { binding, name: names.value(name), kind })
        .collect();
    BindGroup { shader, content: GroupContent::CasterMesh, group: 1, bindings: bindings.into() }
}

fn caster_mask_group(names: &Names, shader: ShaderKind, group: u32) -> BindGroup {
    let kind = BindingKind::Uniform { record: RecordKind::CasterMask, dynamic_offset: false };
    let bindings = vec![
        Binding { binding: 0, name: names.value("caster_mask"), kind },
        Binding { binding: 1, name: names.value("caster_mask_texture"), kind: BindingKind::CasterMask },
        Binding {
            binding: 2,
            name: names.value("caster_mask_sampler"),
            kind: BindingKind::CasterMaskSampler,
        },
    ];
    BindGroup { shader, content: GroupContent::CasterMask, group, bindings: bindings.into() }
}

fn mask_group(names: &Names, depth: MaskDepth, normal: MaskNormal) -> BindGroup {
    let view = BindingKind::Uniform { record: RecordKind::Mask, dynamic_offset: false };
    let mut bindings = vec![
        Binding { binding: 0, name: names.value("mask"), kind: view },
        Binding { binding: 1, name: names.value("scene_depth"), kind: scene_depth(depth) },
    ];
    if normal == MaskNormal::Texture {
        let name = names.value("scene_normal");
        bindings.push(Binding { binding: 2, name, kind: BindingKind::SceneNormal });
    }
    BindGroup {
        shader: ShaderKind::Mask,
        content: GroupContent::MaskInput,
        group: 0,
        bindings: bindings.into(),
    }
}

fn shadow_group(names: &Names, case: &LightCase, shader: ShaderKind, group: u32) -> BindGroup {
    let plan = BindingKind::Uniform { record: RecordKind::Shadow, dynamic_offset: false };
    let mut bindings = vec![Binding { binding: 0, name: names.value("shadow"), kind: plan }];
    bindings.extend(filter::bindings(names, case.filter));

    // Every shader of the case has them at the same numbers, so that they share one layout.
    let first = case.resolve.iter().find_map(|interface| match interface {
        Resolve::Function { first_binding, .. } => Some(*first_binding),
        Resolve::Mask { .. } => None,
    });
    for binding in &mut bindings {
        binding.binding += first.unwrap_or(0);
    }
    BindGroup { shader, content: GroupContent::Shadow, group, bindings: bindings.into() }
}

fn capture_pass(names: &Names, shader: ShaderKind) -> Pass {
    let reads = if is_tested(shader) {
        &[Resource::Casters, Resource::CasterMasks][..]
    } else {
        &[Resource::Casters]
    };
    let fragment = shader != ShaderKind::Capture;
    Pass {
        shader,
        vertex: names.value(&format!("{}_vertex", shader.name())),
        fragment: fragment.then(|| names.value(&format!("{}_fragment", shader.name()))),
        reads: Cow::Borrowed(reads),
        writes: Cow::Borrowed(&[Resource::Map]),
    }
}

fn mask_pass(names: &Names, filter: Filter, normal: MaskNormal) -> Pass {
    let mut reads = filter::resolved_from(filter).to_vec();
    reads.push(Resource::SceneDepth);
    reads.extend((normal == MaskNormal::Texture).then_some(Resource::SceneNormal));
    Pass {
        shader: ShaderKind::Mask,
        vertex: names.value("mask_vertex"),
        fragment: Some(names.value("mask_fragment")),
        reads: reads.into(),
        writes: Cow::Borrowed(&[Resource::Mask]),
    }
}

/// 64-bit FNV-1a over the debug form of the declaration, which spells every field and exact float.
fn fingerprint(case: &LightCase) -> u64 {
    const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    format!("{case:?}").bytes().fold(OFFSET, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME))
}
