//! Every configuration under every kind of light with every distribution: what is generated, as text to read, and valid.
//!
//! Comments are left out here and text that another combination has too is named by it, so that what a combination
//! changes stands out.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use cssm::LightCase;
use cssm::core::case::{LightKind, Stretch};
use cssm::core::schema::Word;
use cssm::core::table::{BindingKind, CaseTable, ConstantValue, FieldType, ShaderKind};
use cssm::core::technique::TECHNIQUES;
use cssm_codegen::generate;

#[path = "support/judge.rs"]
mod judge;

use judge::{capabilities, judge, spirv_val, tint, with_stage};

/// Bound of exact stretching in the locked cases, texels.
const BOUND_TEXELS: f64 = 0.25;

/// Distributions by name, and how rows are stretched.
fn distributions() -> [(&'static str, Word, Stretch); 5] {
    let exact = Stretch::Exact { bound_texels: BOUND_TEXELS };
    [
        ("bands", Word::plain("bands"), Stretch::None),
        ("perspective", Word::plain("perspective"), Stretch::None),
        ("perspective, stretched", Word::plain("perspective"), exact),
        ("logarithmic", Word::plain("logarithmic"), exact),
        ("two_segment", Word::plain("two_segment"), exact),
    ]
}

/// A light under a configuration.
struct Combination {
    /// `omni.face_columns`, `directional.parallel_split.slabs`
    name: String,
    /// The cases, by distribution; one without a name where the configuration takes none.
    cases: Vec<(&'static str, LightCase)>,
}

/// Every configuration of every technique under every light that it serves.
fn combinations() -> Vec<Combination> {
    let mut combinations = Vec::new();
    for light in [LightKind::Directional, LightKind::Omni, LightKind::Spot] {
        for technique in TECHNIQUES {
            for configuration in technique.configurations {
                if !configuration.lights.contains(&light) {
                    continue;
                }
                let name = configuration.choice.name;
                let case = || {
                    let case = LightCase::builder("Light").technique(technique.choice.word()).light(light);
                    case.configurations(&[name]).shadow_distance_metres(1000.0)
                };
                let cases = match configuration.takes_distribution {
                    false => vec![("", case().build().unwrap())],
                    true => distributions()
                        .into_iter()
                        .map(|(name, word, stretch)| {
                            (name, case().distribution(word).stretch(stretch).build().unwrap())
                        })
                        .collect(),
                };
                let own = technique.choice.name == "camera_space";
                let peer = if own { String::new() } else { format!("{}.", technique.choice.name) };
                combinations.push(Combination { name: format!("{}.{peer}{name}", light.name()), cases });
            }
        }
    }
    combinations
}

/// Texts that were printed already, and where.
#[derive(Default)]
struct Printed(BTreeMap<String, String>);

impl Printed {
    /// Prints a text under a title, or who printed it.
    fn print(&mut self, out: &mut String, title: &str, owner: &str, text: String) {
        // Writing to a string cannot fail.
        let _ = match self.0.get(&text) {
            Some(first) => writeln!(out, "--- {title}: that of {first}"),
            None => writeln!(out, "--- {title}\n{text}"),
        };
        self.0.entry(text).or_insert_with(|| owner.to_owned());
    }
}

/// The code of a module without comments and blank lines.
fn code(wgsl: &str) -> String {
    let lines = wgsl.lines().filter(|line| !line.trim_start().starts_with("//") && !line.is_empty());
    lines.collect::<Vec<_>>().join("\n")
}

/// What CPU and GPU agree on, in a few lines.
fn compact(table: &CaseTable) -> String {
    let mut text = String::new();
    let CaseTable { halves, sectors, bands, clips, dominant, scales_thresholds, local_light, .. } = table;
    let CaseTable { remap, stretch, may_reverse_depth, shears, .. } = table;
    let mut line = |line: String| text.push_str(&(line + "\n"));
    line(format!(
        "cells {}: halves {halves}, sectors {sectors}, bands {bands}; dominant {dominant}",
        table.cells()
    ));
    line(format!("clips {clips}, scales_thresholds {scales_thresholds}, local_light {local_light}"));
    line(format!("remap {remap:?}, {stretch:?}, may_reverse_depth {may_reverse_depth}, shears {shears}"));
    for constant in table.constants.iter() {
        line(match constant.value {
            ConstantValue::U32(value) => format!("{} = {value}", constant.name),
            ConstantValue::F32(value) => format!("{} = {value:?}", constant.name),
            ConstantValue::Vec2([x, y]) => format!("{} = {x:?}, {y:?}", constant.name),
        });
    }
    for record in table.records.iter() {
        line(format!("{}, {} bytes", record.name, record.size_bytes));
        for field in record.fields.iter() {
            let ty = match field.ty {
                FieldType::F32 => "f32",
                FieldType::Vec2 => "vec2",
                FieldType::Vec4 => "vec4",
                FieldType::Facet => "facet",
            };
            let elements = match field.elements {
                0 => String::new(),
                elements => format!(" x {elements}, stride {}", field.stride_bytes),
            };
            line(format!("  {:>5} {} {ty}{elements}", field.offset_bytes, field.name));
        }
    }
    for group in table.groups.iter() {
        let binding = |kind: BindingKind| match kind {
            BindingKind::Uniform { record, .. } => record.name().to_owned(),
            kind => format!("{kind:?}"),
        };
        let bindings: Vec<_> = group.bindings.iter().map(|one| binding(one.kind)).collect();
        line(format!("{} group {}: {}", group.shader.name(), group.group, bindings.join(", ")));
    }
    text
}

#[test]
fn every_configuration_and_distribution_reads_as_locked() {
    let mut printed = Printed::default();
    let combinations = combinations();
    for combination in &combinations {
        let mut text = String::new();
        for (distribution, case) in &combination.cases {
            let table = generate(case).unwrap().table;
            let owner = match distribution.is_empty() {
                true => combination.name.clone(),
                false => format!("{}, {distribution}", combination.name),
            };
            let _ = writeln!(text, "=== {owner}");
            printed.print(&mut text, "table", &owner, compact(&table));
            for shader in table.shaders.iter() {
                if matches!(shader.kind, ShaderKind::Function | ShaderKind::Capture) {
                    printed.print(&mut text, shader.kind.name(), &owner, code(&shader.wgsl));
                }
            }
        }
        insta::assert_snapshot!(combination.name.clone(), text);
    }
    assert!(combinations.len() > 15, "only {} combinations", combinations.len());
}

#[test]
fn every_configuration_and_distribution_is_valid() {
    let (mut words, mut texts) = (Vec::new(), BTreeSet::new());
    for combination in combinations() {
        for (distribution, case) in &combination.cases {
            let table = generate(case).unwrap().table;
            for shader in table.shaders.iter() {
                let what = || format!("{}, {distribution}, {}", combination.name, shader.kind.name());
                let text = with_stage(&shader.wgsl, &table, shader.kind);
                let written = judge(&text, capabilities(&table, shader.kind));
                words.push(written.unwrap_or_else(|error| panic!("{}: {error}", what())));
                words.extend((!shader.spirv.is_empty()).then(|| shader.spirv.to_vec()));
                texts.insert(text);
            }
        }
    }
    words.sort();
    words.dedup();
    assert!(words.len() > 60, "only {} different modules", words.len());
    spirv_val(&words);
    tint(&texts.into_iter().collect::<Vec<_>>());
}

#[test]
fn what_a_combination_does_not_need_is_not_there() {
    for combination in combinations() {
        for (distribution, case) in &combination.cases {
            let table = generate(case).unwrap().table;
            let text: String = table.shaders.iter().map(|shader| code(&shader.wgsl)).collect();
            let bent = *distribution != "bands" && *distribution != "perspective" && !distribution.is_empty();
            for (word, needed) in [
                ("remapped", bent),
                ("remap_slope", bent),
                ("STRETCH_BOUND", bent),
                ("shadow.split", table.halves > 1),
                ("shadow.units", table.scales_thresholds),
                ("shadow.light_position", case.light.is_local()),
                ("rounding_depth", case.light.is_local()),
                ("dominant", false),
                ("clips", table.clips > 0),
                ("own_facet", table.cells() > 1),
            ] {
                assert_eq!(text.contains(word), needed, "{} {distribution}: {word}", combination.name);
            }
        }
    }
}
