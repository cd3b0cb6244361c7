//! What stands above the library's functions: constants, records and bindings, printed from the table under the
//! library's own names.

use std::fmt::Write;

use cssm_core::table::{
    Binding, BindingKind, CaseTable, ConstantValue, FieldType, Record, RecordField, RecordKind, ShaderKind,
};

use crate::compose::Prefix;

/// The prelude of one shader of a table; composing drops what the shader does not use.
pub(crate) fn prelude(table: &CaseTable, shader: ShaderKind, prefix: &Prefix) -> String {
    let mut text = String::new();
    for constant in table.constants.iter() {
        line(&mut text, format_args!("/// {}", constant.kind.summary()));
        let (ty, value) = match constant.value {
            ConstantValue::U32(value) => ("u32", format!("{value}u")),
            ConstantValue::F32(value) => ("f32", float(value)),
            ConstantValue::Vec2([x, y]) => ("vec2<f32>", format!("vec2<f32>({}, {})", float(x), float(y))),
        };
        line(&mut text, format_args!("const {}: {ty} = {value};\n", constant.kind.name()));
    }
    for record in table.records.iter() {
        print_record(record, &mut text);
    }
    for group in table.groups.iter().filter(|group| group.shader == shader) {
        for binding in group.bindings.iter() {
            print_binding(table, group.group, binding, prefix, &mut text);
        }
    }
    text
}

/// Directives that stand above everything else in one shader of a table.
pub(crate) fn directives(table: &CaseTable, shader: ShaderKind) -> &'static str {
    if uses_clip_distances(table, shader) { "enable clip_distances;\n\n" } else { "" }
}

/// Whether the pipeline itself cuts casters: where facets share tiles and the device has what it takes.
pub(crate) fn uses_clip_distances(table: &CaseTable, shader: ShaderKind) -> bool {
    table.clips > 0 && matches!(shader, ShaderKind::Capture | ShaderKind::CaptureTested)
}

/// WGSL type of a field, under the library's names.
pub(crate) fn field_type(field: &RecordField) -> String {
    let element = match field.ty {
        FieldType::F32 => "f32",
        FieldType::Vec2 => "vec2<f32>",
        FieldType::Vec4 => "vec4<f32>",
        FieldType::Facet => RecordKind::Facet.name(),
    };
    match field.elements {
        0 => element.to_owned(),
        elements => format!("array<{element}, {elements}>"),
    }
}

/// WGSL type of what is bound, under the library's names.
pub(crate) fn binding_type(kind: BindingKind) -> &'static str {
    match kind {
        BindingKind::Uniform { record, .. } => record.name(),
        BindingKind::Map | BindingKind::SceneDepth => "texture_depth_2d",
        BindingKind::MeshLayout => "array<vec4<u32>, 2>",
        BindingKind::MeshPositions | BindingKind::MeshIndices | BindingKind::MeshUvs => "array<u32>",
        BindingKind::Measured => "array<atomic<u32>>",
        BindingKind::SceneLinearDepth
        | BindingKind::SceneNormal
        | BindingKind::CasterMask
        | BindingKind::GroundRows
        | BindingKind::GroundMasks
        | BindingKind::MomentRows
        | BindingKind::Moments => "texture_2d<f32>",
        BindingKind::ComparisonSampler => "sampler_comparison",
        BindingKind::GatherSampler | BindingKind::CasterMaskSampler | BindingKind::GroundSampler => "sampler",
    }
}

/// One sentence on what is bound.
pub(crate) fn binding_summary(table: &CaseTable, kind: BindingKind) -> &'static str {
    match kind {
        BindingKind::Uniform { record: RecordKind::Facet, .. } => "One facet.",
        BindingKind::Uniform { record: RecordKind::Shadow, .. } => "The plan.",
        BindingKind::Uniform { record: RecordKind::Capture, .. } => "The facet that is captured.",
        BindingKind::Uniform { record: RecordKind::CasterMask, .. } => "How the caster's mask is read.",
        BindingKind::Uniform { record: RecordKind::Mask, .. } => "The view.",
        BindingKind::Uniform { record: RecordKind::Fit, .. } => "The view.",
        BindingKind::Measured => "What is measured; zero before the first workgroup.",
        BindingKind::Map => "The shadow map.",
        BindingKind::MomentRows => "Mean and mean square of warped depths, blurred along rows.",
        BindingKind::Moments => "Mean and mean square of warped depths, blurred.",
        BindingKind::GroundRows => "What covers each plane, blurred along rows.",
        BindingKind::GroundMasks => "What covers each plane, blurred.",
        BindingKind::GroundSampler => "Blends linearly, clamps to the edge.",
        BindingKind::MeshLayout => "Where the caster's vertices lie in its buffers.",
        BindingKind::MeshPositions => "Positions of the caster, as words.",
        BindingKind::MeshIndices => "Indices of the caster, as words.",
        BindingKind::MeshUvs => "Texture coordinates of the caster, as words.",
        BindingKind::SceneDepth => "The engine's depth, reversed-z.",
        BindingKind::SceneLinearDepth => "The engine's depth in metres along the view axis.",
        BindingKind::SceneNormal => "The engine's geometric normals, in the case's axes.",
        BindingKind::CasterMask => "The caster's mask; its alpha channel tells holes.",
        BindingKind::CasterMaskSampler => "The engine's sampler for masks.",
        BindingKind::ComparisonSampler if table.may_reverse_depth => {
            "Compares less or equal, or greater or equal where depth is stored reversed; blends linearly, clamps to \
             the edge."
        }
        BindingKind::ComparisonSampler => "Compares less or equal, blends linearly, clamps to the edge.",
        BindingKind::GatherSampler => "Takes the nearest texel, clamps to the edge.",
    }
}

/// A float as a WGSL literal.
fn float(value: f32) -> String {
    format!("{value:?}")
}

fn print_record(record: &Record, text: &mut String) {
    line(text, format_args!("/// {}", record.kind.summary()));
    line(text, format_args!("struct {} {{", record.kind.name()));
    for field in record.fields.iter() {
        line(text, format_args!("    /// {}", field.meaning.summary()));
        let size = padded_size(record, field).map_or(String::new(), |bytes| format!("@size({bytes}) "));
        line(text, format_args!("    {size}{}: {},", field.name, field_type(field)));
    }
    line(text, format_args!("}}\n"));
}

/// Bytes that the only field of a record takes, where the record is larger than the field: uniform buffers come in
/// multiples of 16 bytes, which WGSL gives by itself only to structs that hold a `vec4`.
fn padded_size(record: &Record, field: &RecordField) -> Option<u32> {
    let small = matches!(field.ty, FieldType::F32 | FieldType::Vec2);
    (record.fields.len() == 1 && small && field.elements == 0).then_some(record.size_bytes)
}

fn print_binding(table: &CaseTable, group: u32, binding: &Binding, prefix: &Prefix, text: &mut String) {
    let space = match binding.kind {
        BindingKind::Uniform { .. } | BindingKind::MeshLayout => "var<uniform>",
        BindingKind::MeshPositions | BindingKind::MeshIndices | BindingKind::MeshUvs => "var<storage, read>",
        BindingKind::Measured => "var<storage, read_write>",
        _ => "var",
    };
    let name = prefix.strip(&binding.name);
    let number = binding.binding;
    line(text, format_args!("/// {}", binding_summary(table, binding.kind)));
    line(text, format_args!("@group({group}) @binding({number})"));
    line(text, format_args!("{space} {name}: {};\n", binding_type(binding.kind)));
}

fn line(text: &mut String, arguments: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{arguments}");
}
