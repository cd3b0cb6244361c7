//! The report for people: what a case will do and what it costs, before anything runs.

use std::fmt::Write;

use cssm_core::LightCase;
use cssm_core::case::{Casters, Filter, Kernel, MaskDepth, MaskNormal, Resolve, Stretch};
use cssm_core::distribution::RemapKind;
use cssm_core::light::LightPosition;
use cssm_core::schema::Word;
use cssm_core::table::{BindingKind, CaseTable, ConstantValue, FieldType, RecordKind, Resource, ShaderKind};

use crate::dsl;
use crate::generate::{CAPTURE_AXES, axes_summary};
use crate::prelude::{binding_summary, binding_type};

/// The report of a case.
pub(crate) fn text(case: &LightCase, table: &CaseTable) -> String {
    let mut out = Out(String::new());
    head(case, table, &mut out);
    conventions(case, table, &mut out);
    tiles(case, table, &mut out);
    rows(case, table, &mut out);
    passes(table, &mut out);
    bindings(table, &mut out);
    records(table, &mut out);
    constants(table, &mut out);
    fetches(case, table, &mut out);
    modules(table, &mut out);
    out.0
}

/// Width of a column of shader names.
const WIDTH: usize = 24;

/// Lines of text.
struct Out(String);

impl Out {
    fn line(&mut self, text: impl AsRef<str>) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.0, "{}", text.as_ref().trim_end());
    }

    fn section(&mut self, title: &str) {
        self.line("");
        self.line(title);
    }
}

fn head(case: &LightCase, table: &CaseTable, out: &mut Out) {
    out.line(format!("{}, {:016x}", case.name, table.fingerprint));
    out.section("declaration");
    for line in dsl::print(case).lines() {
        out.line(format!("  {line}"));
    }
    out.section("configurations");
    out.line(format!("  {}, best first:", case.technique.name));
    for word in &case.configurations {
        let choice = case.technique_spec().configuration(word.name).choice;
        out.line(format!("  {}: {}", choice.name, choice.summary));
    }
    choosing(case, out);
}

/// How a plan picks its configuration, and what happens where the one that is made for the light is not declared.
fn choosing(case: &LightCase, out: &mut Out) {
    let spec = case.technique_spec();
    if case.configurations.len() > 1 {
        out.line("  each plan takes the one with the smallest predicted p95 footprint; a chooser dwells where two agree");
    }
    for position in LightPosition::of_kind(case.light) {
        let is_declared = |name: &&str| case.configurations.iter().any(|word| word.name == *name);
        let (declared, others): (Vec<_>, Vec<_>) =
            spec.made_for(case.light, *position).partition(is_declared);
        let name = position.name();
        out.line(match (declared.is_empty(), others.is_empty()) {
            (false, _) => format!("  light {name}: {}", declared.join(", ")),
            (true, false) => format!("  light {name}: degraded; {} would serve it", others.join(" or ")),
            (true, true) => format!("  light {name}: degraded"),
        });
    }
}

fn conventions(case: &LightCase, table: &CaseTable, out: &mut Out) {
    out.section("conventions");
    out.line("  positions: relative to the eye, in metres");
    out.line(format!("  capture: in {}", CAPTURE_AXES));
    out.line(format!("  resolve: in {}", axes_summary(table.axes)));
    if table.shears {
        out.line("  shear: positions are moved along the light before facets see them, where it stands in or near the view");
    }
    if table.local_light {
        out.line("  light: a point; a metre along the ray is the less deep the farther it lies from there");
    }
    out.line(match table.may_reverse_depth {
        true => {
            "  depth order: 0 or 1 towards the light, chosen by each plan; the shadow record holds the sign"
        }
        false => "  depth order: 0 towards the light",
    });
    out.line(match case.casters {
        Casters::Opaque => "  casters: opaque",
        Casters::AlphaTested => "  casters: opaque, and tested against an alpha mask",
    });
}

/// Bytes of a texel of moments: two 32-bit floats.
const MOMENT_BYTES: u64 = 8;

fn tiles(case: &LightCase, table: &CaseTable, out: &mut Out) {
    out.section("tiles");
    let format = case.map.format;
    let texels = u64::from(table.map_width) * u64::from(table.map_height);
    let mebibytes = (texels * u64::from(format.bytes_per_texel())) as f64 / f64::from(1 << 20);
    let (width, height) = (table.map_width, table.map_height);
    out.line(format!("  map of {width} x {height} texels, {}, {mebibytes:.1} MiB", format.name()));
    let planes = case.filter.ground_planes();
    if planes > 0 {
        let bytes = texels * u64::from(planes).next_power_of_two();
        let mebibytes = bytes as f64 / f64::from(1 << 20);
        out.line(format!(
            "  masks of {planes} planes in as many texels, blurred along rows and then columns, {mebibytes:.1} MiB each"
        ));
    } else if case.filter.is_prefiltered() {
        let mebibytes = (texels * MOMENT_BYTES) as f64 / f64::from(1 << 20);
        out.line(format!(
            "  moments of as many texels, blurred along rows and then columns, {mebibytes:.1} MiB each"
        ));
    }
    let facets = table.cells();
    let CaseTable { halves, sectors, bands, .. } = *table;
    let halves = if halves > 1 { format!("halves {halves} x ") } else { String::new() };
    let dominant = if table.dominant { " + dominant plane 1" } else { "" };
    out.line(format!("  tiles at most: {facets} = {halves}sectors {sectors} x bands {bands}{dominant}"));
    out.line(match table.clips {
        0 => "  clips: none, every tile is a rectangle of one facet".to_owned(),
        clips => format!("  clips: {clips} half-spaces cut the casters of facets that share a tile"),
    });
    out.line(format!("  gutter texels: {}", case.gutter_texels()));
    match case.technique.arguments.sizes("sizes") {
        Some(sizes) => {
            for (index, (width, height)) in sizes.iter().enumerate() {
                out.line(format!("  tile {index}: {width} x {height}, {} texels", width * height));
            }
        }
        None => {
            let share = texels / u64::from(facets.max(1));
            out.line(format!("  texels per tile: {share} of {texels} if all tiles are used alike"));
        }
    }
}

/// What facets have beside plain rows: bent ones, limits that scale, a plane of their own. Absent where there is nothing.
fn rows(case: &LightCase, table: &CaseTable, out: &mut Out) {
    let bent = match table.remap {
        RemapKind::None => None,
        RemapKind::Perspective => Some("the perspective of a pushed back eye"),
        RemapKind::Logarithmic => Some("the logarithm of distance"),
    };
    if bent.is_none() && !table.scales_thresholds && case.dominant_plane.is_none() {
        return;
    }
    out.section("rows");
    if let Some(bent) = bent {
        let takes = |word: &&Word| case.technique_spec().configuration(word.name).takes_distribution;
        let names: Vec<_> = case.configurations.iter().filter(takes).map(|word| word.name).collect();
        let all = names.len() == case.configurations.len() && case.dominant_plane.is_none();
        let others = if all { "" } else { "; straight in all others" };
        out.line(format!("  bent by {bent}: {}{others}", names.join(", ")));
    }
    match (bent, table.stretch) {
        (None, _) | (_, Stretch::None) => {}
        (_, Stretch::Vertex) => {
            out.line("  stretch: corners of casters alone are bent; wrong for triangles that span many rows");
        }
        (_, Stretch::Exact { bound_texels }) => out.line(format!(
            "  stretch: pixel by pixel where straight edges would be off by more than {bound_texels} texels"
        )),
    }
    if table.scales_thresholds {
        out.line("  band limits: times a row of each sector's own, because distance is a quotient under this light");
    }
    if let Some(plane) = case.dominant_plane {
        out.line(format!(
            "  dominant plane: {} % of the map for receivers within {} m of it, which are told first",
            100.0 * plane.share,
            plane.thickness_metres
        ));
    }
}

fn passes(table: &CaseTable, out: &mut Out) {
    out.section("passes");
    for pass in table.passes.iter() {
        let names = |resources: &[Resource]| {
            resources.iter().map(|resource| resource.name()).collect::<Vec<_>>().join(", ")
        };
        let stages =
            pass.fragment.iter().fold(pass.vertex.to_string(), |stages, name| format!("{stages}, {name}"));
        out.line(format!(
            "  {:<WIDTH$}{stages}: reads {}; writes {}",
            pass.shader.name(),
            names(&pass.reads),
            names(&pass.writes)
        ));
    }
    if let Some(reduction) = &table.reduction {
        out.line(format!(
            "  {:<WIDTH$}{}, one workgroup for {side} x {side} pixels: reads {}; writes {} numbers",
            ShaderKind::Fit.name(),
            reduction.entry,
            Resource::SceneDepth.name(),
            reduction.words,
            side = reduction.square_pixels,
        ));
    }
}

fn bindings(table: &CaseTable, out: &mut Out) {
    out.section("bindings");
    for group in table.groups.iter() {
        for binding in group.bindings.iter() {
            let mut ty = binding_type(binding.kind).to_owned();
            if let BindingKind::Uniform { record, dynamic_offset } = binding.kind {
                let name = table.record(record).map_or("", |record| &record.name);
                ty = format!("uniform {name}{}", if dynamic_offset { ", dynamic offset" } else { "" });
            }
            out.line(format!(
                "  {:<WIDTH$}group {} binding {}  {}: {ty}. {}",
                group.shader.name(),
                group.group,
                binding.binding,
                binding.name,
                binding_summary(table, binding.kind)
            ));
        }
    }
}

fn records(table: &CaseTable, out: &mut Out) {
    out.section("records");
    for record in table.records.iter() {
        out.line(format!("  {}, {} bytes", record.name, record.size_bytes));
        for field in record.fields.iter() {
            let element = match field.ty {
                FieldType::F32 => "f32",
                FieldType::Vec2 => "vec2<f32>",
                FieldType::Vec4 => "vec4<f32>",
                FieldType::Facet => table.record(RecordKind::Facet).map_or("", |record| &record.name),
            };
            let ty = match field.elements {
                0 => element.to_owned(),
                elements => format!("{element} x {elements}, stride {}", field.stride_bytes),
            };
            out.line(format!("  {:>6}  {}: {ty}", field.offset_bytes, field.name));
        }
    }
}

fn constants(table: &CaseTable, out: &mut Out) {
    if table.constants.is_empty() {
        return;
    }
    out.section("constants");
    for constant in table.constants.iter() {
        let value = match constant.value {
            ConstantValue::U32(value) => value.to_string(),
            ConstantValue::F32(value) => format!("{value:?}"),
            ConstantValue::Vec2([x, y]) => format!("{x:?}, {y:?}"),
        };
        out.line(format!("  {} = {value}", constant.name));
    }
}

fn fetches(case: &LightCase, table: &CaseTable, out: &mut Out) {
    out.section("texture fetches per pixel");
    let how = match case.filter {
        Filter::None => "load of 1 texel",
        Filter::Hardware2x2 => "comparison of 4 texels",
        Filter::Gather2x2 => "gather of 4 texels",
        Filter::Pcf { kernel: Kernel::Texels, .. } => "gathers of 4 texels",
        Filter::Pcf { .. } => "gathers of 4 texels, at most",
        Filter::GroundMasks { .. } => "sample of blurred masks, or gather of 4 texels",
        Filter::Evsm2 { .. } => "loads of 1 texel of blurred moments",
        Filter::Pcss { .. } => "gathers of 4 texels to find casters and to blend, at most",
    };
    let map = format!("map {} ({how})", table.fetches_per_pixel);
    for interface in &case.resolve {
        match *interface {
            Resolve::Function { .. } => out.line(format!("  {:<WIDTH$}{map}", ShaderKind::Function.name())),
            Resolve::Mask { depth, normal } => {
                let depth_name = match depth {
                    MaskDepth::ReversedZ => "reversed-z depth",
                    MaskDepth::Linear => "linear depth",
                };
                let (depths, normals) = match (case.bias.reads_normal(), normal) {
                    (false, _) => (1, 0),
                    (true, MaskNormal::Reconstructed) => (1 + RECONSTRUCTION_FETCHES, 0),
                    (true, MaskNormal::Texture) => (1, 1),
                };
                let normals = if normals > 0 { format!(", normal {normals}") } else { String::new() };
                out.line(format!(
                    "  {:<WIDTH$}{map}, {depth_name} {depths}{normals}",
                    ShaderKind::Mask.name()
                ));
            }
        }
    }
}

/// Depths that the reconstruction of a normal reads: two on each side of each axis.
const RECONSTRUCTION_FETCHES: u32 = 8;

fn modules(table: &CaseTable, out: &mut Out) {
    out.section("modules");
    for shader in table.shaders.iter() {
        let words = match shader.spirv.len() / 4 {
            0 => "no entry point, no SPIR-V".to_owned(),
            words => format!("{words} SPIR-V words"),
        };
        out.line(format!(
            "  {:<WIDTH$}{} WGSL lines, {words}",
            shader.kind.name(),
            shader.wgsl.lines().count()
        ));
    }
}
