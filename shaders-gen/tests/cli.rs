//! The command as a process: files, exit codes, reports, and the same bytes from two processes.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_shaders-gen")).args(arguments).current_dir(cases()).output().unwrap()
}

fn cases() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("cases")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// Emits every shipped case in a process of its own and returns the files.
fn emit_all(arguments: &[&str]) -> BTreeMap<String, Vec<u8>> {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new").display().to_string();
    let mut all =
        vec!["emit", "sun.cssm", "standard.cssm", "pssm4_log.cssm", "pssm4_practical.cssm", "--out", &out];
    all.extend(arguments);
    let output = run(&all);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let entries = std::fs::read_dir(&out).unwrap().map(|entry| entry.unwrap());
    entries
        .map(|entry| (entry.file_name().into_string().unwrap(), std::fs::read(entry.path()).unwrap()))
        .collect()
}

#[test]
fn two_processes_write_the_same_bytes() {
    assert!(emit_all(&[]) == emit_all(&[]));
}

#[test]
fn the_default_is_all_targets_and_targets_can_be_chosen() {
    let all = emit_all(&[]);
    for name in
        ["sun.capture.wgsl", "sun.mask.wgsl", "sun.function.wgsl", "sun.mask.spv", "sun.rs", "sun.json"]
    {
        assert!(all.contains_key(name), "{name} is missing of {:?}", all.keys());
    }
    assert!(!all.keys().any(|name| name.ends_with(".tmp")));
    assert!(
        all.keys().all(|name| !name.ends_with("function.spv")),
        "a module without entry points has no words"
    );
    let magic = 0x0723_0203_u32.to_le_bytes();
    assert!(
        all.iter().filter(|(name, _)| name.ends_with(".spv")).all(|(_, bytes)| bytes.starts_with(&magic))
    );

    let some = emit_all(&["--target", "wgsl,json"]);
    let expected = all.keys().filter(|name| name.ends_with(".wgsl") || name.ends_with(".json"));
    assert!(some.keys().eq(expected));
}

#[test]
fn a_second_run_leaves_the_files_alone() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().display().to_string();
    let first = text(&run(&["emit", "sun.cssm", "--out", &out]).stdout);
    let second = text(&run(&["emit", "sun.cssm", "--out", &out]).stdout);
    assert!(first.contains("wrote ") && !first.contains("kept "), "{first}");
    assert!(second.contains("kept ") && !second.contains("wrote "), "{second}");
}

#[test]
fn the_crate_path_stands_in_generated_rust() {
    let moved = emit_all(&["--target", "rust", "--crate-path", "crate::engine::cssm"]);
    let sun = text(&moved["sun.rs"]);
    assert!(
        sun.contains("crate::engine::cssm::core::LightCase")
            && !sun.contains("::cssm::core::LightCase {\n        use ::cssm")
    );

    let output = run(&["emit", "sun.cssm", "--crate-path", "not a path", "--out", "/nowhere"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("`not a path` is no path to the cssm crate"));
}

#[test]
fn check_and_explain_print_and_write_nothing() {
    let before = std::fs::read_dir(cases()).unwrap().count();
    let check = run(&["check", "sun.cssm", "standard.cssm"]);
    assert!(check.status.success());
    assert_eq!(text(&check.stdout), "sun.cssm: ok, Sun\nstandard.cssm: ok, Standard\n");
    let explain = run(&["explain", "sun.cssm"]);
    assert!(explain.status.success());
    for part in [
        "configurations",
        "passes",
        "bindings",
        "records",
        "texels per tile",
        "texture fetches per pixel",
        "SPIR-V words",
    ] {
        assert!(text(&explain.stdout).contains(part), "{part}");
    }
    assert_eq!(std::fs::read_dir(cases()).unwrap().count(), before);
}

#[test]
fn json_is_json() {
    for arguments in [["check", "sun.cssm"], ["explain", "sun.cssm"]] {
        let output = run(&[arguments[0], arguments[1], "--format", "json"]);
        let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(value.is_object() || value.is_array());
    }
}

#[test]
fn every_file_at_fault_is_reported_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let bad = folder.path().join("bad.cssm");
    std::fs::write(&bad, "pub case Bad {\n    filtr: none,\n    map: { size: 1 x 1 },\n}\n").unwrap();
    let (bad, out) = (bad.display().to_string(), folder.path().join("out"));
    let out = out.display().to_string();
    let output = run(&["emit", "sun.cssm", &bad, "missing.cssm", "--out", &out]);
    assert_eq!(output.status.code(), Some(1));
    let report = text(&output.stderr);
    assert!(report.contains("filtr") && report.contains("map.size") || report.contains("1 x 1"), "{report}");
    assert!(report.contains("bad.cssm:2") && report.contains("cannot read missing.cssm"), "{report}");
    assert!(!Path::new(&out).exists());

    let output = run(&["check", &bad, "missing.cssm", "--format", "json"]);
    assert_eq!(output.status.code(), Some(1));
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let reports = value["reports"].as_array().unwrap();
    assert_eq!(reports.len(), 2);
    assert_eq!(reports[0]["errors"][0]["line"], 2);
}

#[test]
fn cases_of_two_files_may_not_share_a_prefix() {
    let folder = tempfile::tempdir().unwrap();
    let other = folder.path().join("other.cssm");
    std::fs::write(&other, "case Other { prefix: sun }").unwrap();
    let output = run(&["check", "sun.cssm", &other.display().to_string()]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("cases `Sun` and `Other` share the prefix `sun`"));
}

#[test]
fn wrong_arguments_exit_with_two_and_help_with_zero() {
    assert_eq!(run(&["emit"]).status.code(), Some(2));
    assert_eq!(run(&["emit", "sun.cssm", "--target", "hlsl"]).status.code(), Some(2));
    assert_eq!(run(&["--help"]).status.code(), Some(0));
    assert!(text(&run(&["reference"]).stdout).contains("receiver_plane"));
}
