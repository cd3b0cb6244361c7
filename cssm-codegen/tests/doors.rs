//! What the build script's door and the macro's door do with input that makes no sense.

use std::path::PathBuf;

use cssm_codegen::{Build, BuildError, CasterEntry, GenerateError, Options, generate_with, macro_expand};
use cssm_core::LightCase;
use tempfile::TempDir;

/// A folder with declaration files.
fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    folder
}

/// Compiles files of a folder into a folder inside it.
fn compile(folder: &TempDir, names: &[&str]) -> Result<Vec<PathBuf>, BuildError> {
    let build = Build::new().out_dir(folder.path().join("out"));
    names.iter().fold(build, |build, name| build.file(folder.path().join(name))).compile()
}

#[test]
fn one_file_of_several_cases_is_one_file_of_several_modules() {
    let folder = folder(&[("all.cssm", "case One { prefix: one } case Two { prefix: two }")]);
    let written = compile(&folder, &["all.cssm"]).unwrap();
    let text = std::fs::read_to_string(&written[0]).unwrap();
    assert!(text.contains("\nmod one {") && text.contains("\nmod two {"));
    assert!(!text.contains("\npub mod"), "private cases stay private");
}

#[test]
fn a_missing_file_is_named() {
    let error = compile(&folder(&[]), &["nowhere.cssm"]).unwrap_err();
    assert!(matches!(error, BuildError::Read { .. }));
    assert!(error.to_string().contains("nowhere.cssm"));
}

#[test]
fn a_fault_is_a_rendered_report_also_in_debug_form() {
    let folder = folder(&[("bad.cssm", "case Bad { filtr: none }")]);
    let error = compile(&folder, &["bad.cssm"]).unwrap_err();
    assert!(matches!(error, BuildError::Declaration(_)));
    let debug = format!("{error:?}");
    assert!(debug.contains("bad.cssm:1:12") && debug.contains("help:") && debug.contains('^'), "{debug}");
    assert!(!folder.path().join("out").exists(), "nothing is written");
}

#[test]
fn outputs_and_prefixes_may_not_collide() {
    let folder = folder(&[
        ("a/sun.cssm", "case One {}"),
        ("b/sun.cssm", "case Two {}"),
        ("other.cssm", "case Three { prefix: one }"),
    ]);
    assert!(matches!(compile(&folder, &["a/sun.cssm", "b/sun.cssm"]), Err(BuildError::SameOutput { .. })));
    let error = compile(&folder, &["a/sun.cssm", "other.cssm"]).unwrap_err();
    assert!(matches!(error, BuildError::Generate(GenerateError::SharedPrefix { .. })), "{error}");
    assert!(!folder.path().join("out").exists(), "nothing is written");
}

#[test]
fn caster_entries_become_files_of_their_own() {
    let position = "fn caster(@location(0) position: vec3<f32>) -> vec3<f32> { return position; }";
    let folder =
        folder(&[("all.cssm", "pub case Sun {}"), ("caster.wgsl", position), ("bad.wgsl", "fn caster(")]);
    let entry = CasterEntry::new("plain", "caster");
    let build = |case: &str, file: &str| {
        let build = Build::new().out_dir(folder.path().join("out")).file(folder.path().join("all.cssm"));
        build.caster(case, [folder.path().join(file)], entry.clone())
    };
    let error = build("Moon", "caster.wgsl").compile().unwrap_err();
    assert!(
        matches!(error, BuildError::UnknownCase { .. }) && error.to_string().contains("`Sun`"),
        "{error}"
    );
    let error = build("Sun", "bad.wgsl").compile().unwrap_err();
    assert!(
        matches!(error, BuildError::Casters(_)) && format!("{error:?}").contains("bad.wgsl:1"),
        "{error}"
    );
    let twice = build("Sun", "caster.wgsl").caster("Sun", [folder.path().join("caster.wgsl")], entry.clone());
    assert!(matches!(twice.compile(), Err(BuildError::SameOutput { .. })));
    assert!(!folder.path().join("out").exists(), "nothing is written");

    let written = build("Sun", "caster.wgsl").compile().unwrap();
    assert!(written[1].ends_with("sun_plain.rs"));
    let text = std::fs::read_to_string(&written[1]).unwrap();
    assert!(text.contains("pub mod sun_plain {") && text.contains("pub static CASTERS: ::cssm::core"));
    let again = build("Sun", "caster.wgsl").compile().unwrap();
    assert_eq!(std::fs::read_to_string(&again[1]).unwrap(), text);
}

#[test]
fn a_crate_path_must_be_a_path() {
    let case = LightCase::builder("Sun").build().unwrap();
    for path in ["", "a b", "::cssm::<u8>", "1", "super::cssm"] {
        let options = Options { crate_path: path.into() };
        assert!(matches!(generate_with(&case, &options), Err(GenerateError::CratePath { .. })), "{path}");
    }
}

#[test]
fn every_fault_of_a_macro_input_is_a_compile_error() {
    let expand = |text: &str| macro_expand(text.parse().unwrap()).to_string();
    let errors = expand("case Bad { filtr: none, map: { size: 1 x 1 } }");
    assert_eq!(errors.matches("compile_error !").count(), 2, "{errors}");
    assert!(errors.contains("help"));
    assert!(expand("#![crate_path(a b)] case Sun {}").contains("is no path to the cssm crate"));
    let moved = expand("#![crate_path(::engine::cssm)] case Sun {}");
    assert!(moved.contains(":: engine :: cssm :: core") && !moved.contains("compile_error"));
}

#[test]
fn docs_cannot_break_out_of_their_comments() {
    let doc = "One.\u{2028}fn evil() {}\n*/ \"# \\ */ `sun` \u{202e}end";
    let case = LightCase::builder("Sun").doc(doc).build().unwrap();
    let generated = generate_with(&case, &Options::default()).unwrap();
    for shader in generated.table.shaders.iter() {
        assert!(!shader.wgsl.contains(['\u{2028}', '\u{202e}']));
        assert!(shader.wgsl.lines().filter(|line| line.contains("evil")).all(|line| line.starts_with("//")));
    }
    assert!(!generated.rust.contains('\u{202e}'));
}
