//! The library's own rules: every file is valid, is used, and reads well.

mod variants;

use std::collections::BTreeSet;
use std::process::Command;

use cssm_core::table::ShaderKind;

use self::variants::{Variant, tested, variants};
use super::{LIBRARY, LibraryFile, caster_entry, join, pick};
use crate::compose::Prefix;
use crate::{generate, judge, prelude, wgsl};

const SHADERS: [ShaderKind; 11] = [
    ShaderKind::Capture,
    ShaderKind::CaptureClamped,
    ShaderKind::CaptureTested,
    ShaderKind::CaptureTestedClamped,
    ShaderKind::CaptureBent,
    ShaderKind::CaptureBentTested,
    ShaderKind::PrefilterRows,
    ShaderKind::PrefilterColumns,
    ShaderKind::Mask,
    ShaderKind::Function,
    ShaderKind::Fit,
];

/// The shaders of a variant.
fn shaders(variant: &Variant) -> impl Iterator<Item = ShaderKind> {
    let table = &variant.table;
    SHADERS.into_iter().filter(|shader| table.groups.iter().any(|group| group.shader == *shader))
}

/// The picked files of a case as they stand, whole, under the library's own names.
fn whole_files(variant: &Variant, shader: ShaderKind) -> String {
    let Variant { case, table } = variant;
    let prelude = prelude::prelude(table, shader, &Prefix::new(&case.prefix));
    let (files, _) = pick(case, table, shader);
    let files = files.iter().map(|file| &*file.source).collect::<Vec<_>>().join("\n");
    format!("{}{prelude}{files}", prelude::directives(table, shader))
}

/// What naga makes of them.
fn validated(variant: &Variant, shader: ShaderKind) -> Result<judge::Judged, judge::JudgeError> {
    judge::validate(&whole_files(variant, shader), judge::capabilities(&variant.table, shader))
}

#[test]
fn every_file_is_picked_by_some_case() {
    let mut picked = BTreeSet::new();
    for variant in variants() {
        for shader in shaders(&variant) {
            picked.extend(pick(&variant.case, &variant.table, shader).0.into_iter().map(|file| file.name));
        }
        picked.extend(caster_entry(&variant.table, true, false, true).into_iter().map(|file| file.name));
    }
    let missing: Vec<_> = LIBRARY.iter().filter(|file| !picked.contains(file.name)).collect();
    assert!(missing.is_empty(), "no case takes {missing:?}");
}

#[test]
fn every_file_is_on_the_list() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src/shaders");
    let mut found: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap().replace(".wgsl", ""))
        .collect();
    let mut listed: Vec<_> = LIBRARY.iter().map(|file| file.name.to_owned()).collect();
    found.sort();
    listed.sort();
    assert_eq!(found, listed);
}

#[test]
fn the_join_takes_every_form() {
    const FACETS: usize = 2;
    const READ_BY_BIASES: usize = 5;
    const FILTERS: usize = 3;
    assert_eq!(joins().len(), FACETS * READ_BY_BIASES * FILTERS);
}

/// Every text of the function that joins the slots.
fn joins() -> BTreeSet<String> {
    variants().iter().map(|variant| join::visibility(&variant.case, &variant.table)).collect()
}

/// Every text that modules are made of.
fn texts() -> Vec<LibraryFile> {
    let joins = joins().into_iter().map(|text| LibraryFile { name: "visibility", source: text.into() });
    LIBRARY.iter().cloned().chain(joins).collect()
}

#[test]
fn whole_files_are_valid_as_they_stand() {
    for variant in variants() {
        for shader in shaders(&variant) {
            if let Err(error) = validated(&variant, shader) {
                panic!("{}, {}: {error}", shader.name(), variant.case.bias.name());
            }
        }
    }
}

#[test]
fn facets_that_share_tiles_are_cut_by_the_pipeline_or_by_the_fragment() {
    let table = generate::table_with_shaders(&tested("four_plane").case).unwrap();
    assert_eq!(table.clips, 2);
    for (shader, pipeline) in [
        (ShaderKind::Capture, true),
        (ShaderKind::CaptureTested, true),
        (ShaderKind::CaptureClamped, false),
        (ShaderKind::CaptureTestedClamped, false),
    ] {
        let shader = table.shader(shader).unwrap();
        let (text, name) = (&shader.wgsl, shader.kind.name());
        assert_eq!(text.lines().any(|line| line == "enable clip_distances;"), pipeline, "{name}");
        assert_eq!(text.contains("@builtin(clip_distances)"), pipeline, "{name}");
        assert_eq!(text.contains("frag_depth"), !pipeline, "{name}");
        assert_eq!(text.contains("sun_is_cut(caster.clips)"), !pipeline, "{name}");
        assert_eq!(has_capability(&shader.spirv, CLIP_DISTANCE), pipeline, "{name}");
    }
    for shader in table.shaders.iter().filter(|shader| !shader.kind.name().starts_with("capture")) {
        assert!(!shader.wgsl.contains("clip_distances") && !shader.wgsl.contains("clips"));
    }
}

/// Number of the capability `ClipDistance` in SPIR-V.
const CLIP_DISTANCE: u32 = 32;

/// Whether a module declares a capability: an instruction of two words, the first of them 0x20011.
fn has_capability(spirv: &[u8], capability: u32) -> bool {
    let words: Vec<_> =
        spirv.chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect();
    let instructions = words[5..].chunks_exact(2).take_while(|pair| pair[0] == 0x0002_0011);
    instructions.into_iter().any(|pair| pair[1] == capability)
}

#[test]
fn spirv_val_accepts_every_capture() {
    if Command::new("spirv-val").arg("--version").output().is_err() {
        eprintln!("SKIPPED: spirv-val is not installed; install Debian's spirv-tools");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for configuration in ["face_columns", "four_plane"] {
        let table = generate::table_with_shaders(&tested(configuration).case).unwrap();
        for shader in table.shaders.iter().filter(|shader| !shader.spirv.is_empty()) {
            let path = folder.path().join("module.spv");
            std::fs::write(&path, &shader.spirv).unwrap();
            let output = Command::new("spirv-val").args(["--target-env", "vulkan1.1"]).arg(&path).output();
            let output = output.unwrap();
            let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(output.status.success(), "{}: {complaint}", shader.kind.name());
        }
    }
}

#[test]
fn no_name_ends_in_a_digit_and_no_local_name_hides_a_declaration() {
    for variant in variants() {
        for shader in shaders(&variant) {
            let judged = validated(&variant, shader).unwrap();
            let (declared, local) = names(&judged.module);
            for name in declared.union(&local) {
                assert!(!name.ends_with(|last: char| last.is_ascii_digit()), "`{name}` ends in a digit");
            }
            let hidden: Vec<_> = declared.intersection(&local).collect();
            assert!(hidden.is_empty(), "{hidden:?} would be prefixed where they are local");
        }
    }
}

/// Names at module scope, and names of members, parameters and locals.
fn names(module: &naga::Module) -> (BTreeSet<String>, BTreeSet<String>) {
    let mut declared = BTreeSet::new();
    let mut local = BTreeSet::new();
    declared.extend(module.constants.iter().filter_map(|(_, constant)| constant.name.clone()));
    declared.extend(module.global_variables.iter().filter_map(|(_, global)| global.name.clone()));
    for (_, ty) in module.types.iter() {
        declared.extend(ty.name.clone());
        if let naga::TypeInner::Struct { members, .. } = &ty.inner {
            local.extend(members.iter().filter_map(|member| member.name.clone()));
        }
    }
    let functions = module.functions.iter().map(|(_, function)| function);
    for function in functions.chain(module.entry_points.iter().map(|entry| &entry.function)) {
        declared.extend(function.name.clone());
        local.extend(function.arguments.iter().filter_map(|argument| argument.name.clone()));
        local.extend(function.local_variables.iter().filter_map(|(_, variable)| variable.name.clone()));
        local.extend(function.named_expressions.values().cloned());
    }
    (declared, local)
}

#[test]
fn no_branch_depends_on_constants_alone() {
    for variant in variants() {
        for shader in shaders(&variant) {
            let judged = validated(&variant, shader).unwrap();
            let functions = judged.module.functions.iter().map(|(_, function)| function);
            for function in functions.chain(judged.module.entry_points.iter().map(|entry| &entry.function)) {
                assert!(!branches_on_constant(&function.body, function), "{:?}", function.name);
            }
        }
    }
}

#[test]
fn the_branch_lint_finds_a_branch_on_a_constant() {
    let text = "const ON: bool = true;\nfn f(x: f32) -> f32 { if ON { return x; } return 2.0 * x; }";
    let judged = judge::validate(text, naga::valid::Capabilities::empty()).unwrap();
    let (_, function) = judged.module.functions.iter().next().unwrap();
    assert!(branches_on_constant(&function.body, function));
}

fn branches_on_constant(block: &naga::Block, function: &naga::Function) -> bool {
    use naga::{Expression, Statement};
    let is_constant = |condition: &naga::Handle<Expression>| {
        matches!(function.expressions[*condition], Expression::Literal(_) | Expression::Constant(_))
    };
    block.iter().any(|statement| match statement {
        Statement::If { condition, accept, reject } => {
            is_constant(condition)
                || branches_on_constant(accept, function)
                || branches_on_constant(reject, function)
        }
        Statement::Block(inner) => branches_on_constant(inner, function),
        Statement::Loop { body, continuing, .. } => {
            branches_on_constant(body, function) || branches_on_constant(continuing, function)
        }
        Statement::Switch { selector, cases } => {
            is_constant(selector) || cases.iter().any(|case| branches_on_constant(&case.body, function))
        }
        _ => false,
    })
}

#[test]
fn every_parameter_and_local_is_read() {
    for file in texts() {
        for declaration in wgsl::declarations(&file.source) {
            let words: Vec<_> = wgsl::references(declaration.text).collect();
            let Some(parameters) = parameters(declaration.text) else { continue };
            let locals = words.windows(2).filter(|pair| matches!(pair[0], "let" | "var")).map(|pair| pair[1]);
            for name in parameters.into_iter().chain(locals) {
                let uses = words.iter().filter(|word| **word == name).count();
                assert!(uses > 1, "`{name}` of `{}` in {} is never read", declaration.name, file.name);
            }
        }
    }
}

#[test]
fn parameters_are_told_from_their_types() {
    let head = "@vertex\nfn f(@location(0) a: vec2<f32>, b: f32,\n    c: Facet,\n) -> f32 {\n}";
    assert_eq!(parameters(head), Some(vec!["a", "b", "c"]));
    assert_eq!(parameters("struct S { a: f32 }"), None);
}

/// Names of a function's parameters: the word before each colon of its head.
fn parameters(function: &str) -> Option<Vec<&str>> {
    let (_, rest) = function.split_once("fn ")?;
    let (_, rest) = rest.split_once('(')?;
    let (list, _) = rest.split_once('{')?;
    let parts = list.split(':').map(|part| part.split([' ', ',', '(', ')', '\n']));
    let names = parts.filter_map(|mut words| words.rfind(|word| !word.is_empty()));
    Some(names.take(list.matches(": ").count()).collect())
}

#[test]
fn every_declaration_is_documented_and_lines_are_short() {
    const WIDTH: usize = 120;
    for file in LIBRARY {
        assert!(file.source.starts_with("// "), "{} does not say what it is", file.name);
    }
    for file in texts() {
        for line in file.source.lines() {
            assert!(line.chars().count() <= WIDTH && line == line.trim_end(), "{}: {line}", file.name);
        }
        for declaration in wgsl::declarations(&file.source) {
            assert!(
                declaration.text.starts_with("///"),
                "`{}` in {} has no comment",
                declaration.name,
                file.name
            );
        }
    }
}
