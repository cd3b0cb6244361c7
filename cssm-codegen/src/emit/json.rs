//! The JSON target: the table for tools and for engines in other languages.
//!
//! Fields stand in the order of these structs, whatever features other crates switch on in serde_json.

use cssm_core::LightCase;
use cssm_core::case::Stretch;
use cssm_core::distribution::RemapKind;
use cssm_core::table::{
    BindGroup, Binding, BindingKind, CaseTable, Constant, ConstantValue, FieldType, GroupContent, Pass,
    Record, RecordField, Reduction, Shader,
};
use serde::Serialize;

use crate::emit::files;
use crate::prelude::binding_type;

/// The table as JSON text; shaders are named by their files.
pub(crate) fn text(case: &LightCase, table: &CaseTable) -> String {
    let json = JsonCase {
        case: &case.name,
        doc: &case.doc,
        prefix: &case.prefix,
        fingerprint: format!("{:016x}", table.fingerprint),
        light: case.light.name(),
        technique: case.technique.name,
        configurations: case.configurations.iter().map(|word| word.name).collect(),
        distribution: case.distribution.as_ref().map(|word| word.name),
        remap: remap_name(table.remap),
        stretch: JsonStretch::of(case, table),
        dominant_plane: case
            .dominant_plane
            .map(|plane| JsonDominantPlane { share: plane.share, thickness_metres: plane.thickness_metres }),
        fit: case.fit.name(),
        stability: case.stability.name(),
        filter: case.filter.name(),
        bias: case.bias.name(),
        casters: case.casters.name(),
        axes: table.axes.name(),
        shears: table.shears,
        may_reverse_depth: table.may_reverse_depth,
        map: JsonMap {
            width: table.map_width,
            height: table.map_height,
            format: table.map_format.name(),
            columns: case.map.columns,
            gutter: case.gutter_texels(),
        },
        facets: JsonFacets {
            halves: table.halves,
            sectors: table.sectors,
            bands: table.bands,
            count: table.cells(),
            clips: table.clips,
            dominant: table.dominant,
            scales_thresholds: table.scales_thresholds,
        },
        fetches_per_pixel: table.fetches_per_pixel,
        constants: table.constants.iter().map(JsonConstant::of).collect(),
        records: table.records.iter().map(|record| JsonRecord::of(record, table)).collect(),
        groups: table.groups.iter().map(|group| JsonGroup::of(group, table)).collect(),
        passes: table.passes.iter().map(JsonPass::of).collect(),
        reduction: table.reduction.as_ref().map(JsonReduction::of),
        shaders: table.shaders.iter().map(|shader| JsonShader::of(shader, table)).collect(),
    };
    // Strings and numbers always serialise.
    serde_json::to_string_pretty(&json).unwrap_or_default() + "\n"
}

#[derive(Serialize)]
struct JsonCase<'a> {
    case: &'a str,
    doc: &'a str,
    prefix: &'a str,
    fingerprint: String,
    light: &'a str,
    technique: &'a str,
    configurations: Vec<&'a str>,
    /// Absent: no configuration takes one.
    #[serde(skip_serializing_if = "Option::is_none")]
    distribution: Option<&'a str>,
    /// Absent: rows are straight.
    #[serde(skip_serializing_if = "Option::is_none")]
    remap: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    stretch: Option<JsonStretch>,
    #[serde(skip_serializing_if = "Option::is_none")]
    dominant_plane: Option<JsonDominantPlane>,
    fit: &'a str,
    stability: &'a str,
    filter: &'a str,
    bias: &'a str,
    casters: &'a str,
    axes: &'a str,
    shears: bool,
    may_reverse_depth: bool,
    map: JsonMap<'a>,
    facets: JsonFacets,
    fetches_per_pixel: u32,
    constants: Vec<JsonConstant<'a>>,
    records: Vec<JsonRecord<'a>>,
    groups: Vec<JsonGroup<'a>>,
    passes: Vec<JsonPass<'a>>,
    /// Absent: depth is not measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    reduction: Option<JsonReduction<'a>>,
    shaders: Vec<JsonShader<'a>>,
}

#[derive(Serialize)]
struct JsonMap<'a> {
    width: u32,
    height: u32,
    format: &'a str,
    /// Absent: found by the plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    columns: Option<u32>,
    gutter: u32,
}

#[derive(Serialize)]
struct JsonFacets {
    halves: u32,
    sectors: u32,
    bands: u32,
    count: u32,
    /// Half-spaces that the capture cuts casters with.
    clips: u32,
    /// Whether the last facet is that of receivers near a dominant plane.
    dominant: bool,
    /// Whether band limits are multiples of a row of each sector's own.
    scales_thresholds: bool,
}

/// Curve that bends rows.
fn remap_name(kind: RemapKind) -> Option<&'static str> {
    match kind {
        RemapKind::None => None,
        RemapKind::Perspective => Some("perspective"),
        RemapKind::Logarithmic => Some("logarithmic"),
    }
}

/// How casters are drawn where rows are bent.
#[derive(Serialize)]
struct JsonStretch {
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    bound_texels: Option<f64>,
}

impl JsonStretch {
    fn of(case: &LightCase, table: &CaseTable) -> Option<Self> {
        let (kind, bound_texels) = match case.stretch {
            _ if table.remap == RemapKind::None => return None,
            Stretch::None => return None,
            Stretch::Vertex => ("vertex", None),
            Stretch::Exact { bound_texels } => ("exact", Some(bound_texels)),
        };
        Some(Self { kind, bound_texels })
    }
}

#[derive(Serialize)]
struct JsonReduction<'a> {
    compute: &'a str,
    square_pixels: u32,
    words: u32,
}

impl<'a> JsonReduction<'a> {
    fn of(reduction: &'a Reduction) -> Self {
        Self { compute: &reduction.entry, square_pixels: reduction.square_pixels, words: reduction.words }
    }
}

#[derive(Serialize)]
struct JsonDominantPlane {
    share: f64,
    thickness_metres: f64,
}

#[derive(Serialize)]
struct JsonConstant<'a> {
    name: &'a str,
    summary: &'a str,
    #[serde(rename = "type")]
    ty: &'a str,
    value: JsonValue,
}

#[derive(Serialize)]
#[serde(untagged)]
enum JsonValue {
    U32(u32),
    F32(f32),
    Vec2([f32; 2]),
}

impl<'a> JsonConstant<'a> {
    fn of(constant: &'a Constant) -> Self {
        let (ty, value) = match constant.value {
            ConstantValue::U32(value) => ("u32", JsonValue::U32(value)),
            ConstantValue::F32(value) => ("f32", JsonValue::F32(value)),
            ConstantValue::Vec2(value) => ("vec2<f32>", JsonValue::Vec2(value)),
        };
        Self { name: &constant.name, summary: constant.kind.summary(), ty, value }
    }
}

#[derive(Serialize)]
struct JsonRecord<'a> {
    name: &'a str,
    summary: &'a str,
    size_bytes: u32,
    fields: Vec<JsonField<'a>>,
}

#[derive(Serialize)]
struct JsonField<'a> {
    name: &'a str,
    summary: &'a str,
    #[serde(rename = "type")]
    ty: &'a str,
    offset_bytes: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    elements: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    stride_bytes: Option<u32>,
}

impl<'a> JsonRecord<'a> {
    fn of(record: &'a Record, table: &'a CaseTable) -> Self {
        let fields = record.fields.iter().map(|field| JsonField::of(field, table)).collect();
        Self { name: &record.name, summary: record.kind.summary(), size_bytes: record.size_bytes, fields }
    }
}

impl<'a> JsonField<'a> {
    fn of(field: &'a RecordField, table: &'a CaseTable) -> Self {
        let facet = table.records.iter().find(|record| record.kind == cssm_core::table::RecordKind::Facet);
        Self {
            name: &field.name,
            summary: field.meaning.summary(),
            ty: match field.ty {
                FieldType::F32 => "f32",
                FieldType::Vec2 => "vec2<f32>",
                FieldType::Vec4 => "vec4<f32>",
                FieldType::Facet => facet.map_or("Facet", |record| &record.name),
            },
            offset_bytes: field.offset_bytes,
            elements: (field.elements > 0).then_some(field.elements),
            stride_bytes: (field.elements > 0).then_some(field.stride_bytes),
        }
    }
}

#[derive(Serialize)]
struct JsonGroup<'a> {
    shader: &'a str,
    content: &'a str,
    group: u32,
    bindings: Vec<JsonBinding<'a>>,
}

#[derive(Serialize)]
struct JsonBinding<'a> {
    binding: u32,
    name: &'a str,
    kind: &'a str,
    #[serde(rename = "type")]
    ty: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    dynamic_offset: Option<bool>,
}

impl<'a> JsonGroup<'a> {
    fn of(group: &'a BindGroup, table: &'a CaseTable) -> Self {
        let content = match group.content {
            GroupContent::CaptureFacet => "capture_facet",
            GroupContent::CasterMask => "caster_mask",
            GroupContent::CasterMesh => "caster_mesh",
            GroupContent::Prefilter => "prefilter",
            GroupContent::MaskInput => "mask_input",
            GroupContent::Shadow => "shadow",
            GroupContent::Fit => "fit",
        };
        let bindings = group.bindings.iter().map(|binding| JsonBinding::of(binding, table)).collect();
        Self { shader: group.shader.name(), content, group: group.group, bindings }
    }
}

impl<'a> JsonBinding<'a> {
    fn of(binding: &'a Binding, table: &'a CaseTable) -> Self {
        let mut ty = binding_type(binding.kind);
        let mut offset = None;
        if let BindingKind::Uniform { record, dynamic_offset } = binding.kind {
            ty = table.record(record).map_or(ty, |record| &record.name);
            offset = Some(dynamic_offset);
        }
        let kind = match binding.kind {
            BindingKind::Uniform { .. } => "uniform",
            BindingKind::MeshLayout => "mesh_layout",
            BindingKind::MeshPositions => "mesh_positions",
            BindingKind::MeshIndices => "mesh_indices",
            BindingKind::MeshUvs => "mesh_uvs",
            BindingKind::Map => "map",
            BindingKind::MomentRows => "moment_rows",
            BindingKind::Moments => "moments",
            BindingKind::GroundRows => "ground_rows",
            BindingKind::GroundMasks => "ground_masks",
            BindingKind::GroundSampler => "ground_sampler",
            BindingKind::SceneDepth => "scene_depth",
            BindingKind::SceneLinearDepth => "scene_linear_depth",
            BindingKind::SceneNormal => "scene_normal",
            BindingKind::CasterMask => "caster_mask",
            BindingKind::CasterMaskSampler => "caster_mask_sampler",
            BindingKind::ComparisonSampler => "comparison_sampler",
            BindingKind::GatherSampler => "gather_sampler",
            BindingKind::Measured => "measured",
        };
        Self { binding: binding.binding, name: &binding.name, kind, ty, dynamic_offset: offset }
    }
}

#[derive(Serialize)]
struct JsonPass<'a> {
    shader: &'a str,
    vertex: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    fragment: Option<&'a str>,
    reads: Vec<&'a str>,
    writes: Vec<&'a str>,
}

impl<'a> JsonPass<'a> {
    fn of(pass: &'a Pass) -> Self {
        Self {
            shader: pass.shader.name(),
            vertex: &pass.vertex,
            fragment: pass.fragment.as_deref(),
            reads: pass.reads.iter().map(|resource| resource.name()).collect(),
            writes: pass.writes.iter().map(|resource| resource.name()).collect(),
        }
    }
}

#[derive(Serialize)]
struct JsonShader<'a> {
    kind: &'a str,
    wgsl: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    spirv: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    spirv_words: Option<usize>,
}

impl<'a> JsonShader<'a> {
    fn of(shader: &'a Shader, table: &CaseTable) -> Self {
        let has_words = !shader.spirv.is_empty();
        Self {
            kind: shader.kind.name(),
            wgsl: files::shader_name(table, shader, "wgsl"),
            spirv: has_words.then(|| files::shader_name(table, shader, "spv")),
            spirv_words: has_words.then_some(shader.spirv.len() / 4),
        }
    }
}
