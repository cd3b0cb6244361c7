//! The program as a user runs it.

use std::path::Path;
use std::process::{Command, Output};

const SUN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../shaders-gen/cases/sun.cssm");

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_cssm-lab")).arg("--quiet").args(arguments).output().unwrap()
}

fn refusal(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(!output.status.success(), "{arguments:?} must be refused");
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn render_writes_every_result() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new").join("folder");
    let output = run(&[
        "render",
        "--case",
        &format!("{SUN}:Sun"),
        "--scene",
        "palm",
        "--size",
        "160x90",
        "--map",
        "512x512",
        "--light",
        "directional:-0.4,-0.8,0.3",
        "--runs",
        "1",
        "--out",
        out.to_str().unwrap(),
    ]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for file in ["shaded.png", "map.png", "error.png", "frame.exr", "report.json"] {
        let bytes = std::fs::metadata(out.join(file)).unwrap().len();
        assert!(bytes > 500, "{file} has {bytes} bytes");
    }
    let report: serde_json::Value =
        serde_json::from_slice(&std::fs::read(out.join("report.json")).unwrap()).unwrap();
    assert_eq!((report["case"].as_str(), report["technique"].as_str()), (Some("Sun"), Some("camera_space")));
    assert_eq!(report["configuration"], "face_columns");
    assert_eq!(report["map"]["texels"], 512 * 512);
    assert!(report["score"]["facing_pixels"].as_u64().unwrap() > 160 * 90 / 4);
    assert!(report["score"]["mismatch"].as_f64().unwrap() < 0.1);
    assert!(report["footprint"]["p95"].as_f64().unwrap() > report["footprint"]["median"].as_f64().unwrap());
    assert!(report["triangles_submitted"].as_u64().unwrap() > 0);
    assert!(report["time"]["capture"]["median"].as_f64().unwrap() > 0.0);
    assert!(!report["adapter"].as_str().unwrap().is_empty());
}

#[test]
fn contact_sheets_show_every_case_on_every_scene() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("sheet");
    let mut arguments =
        vec!["contact-sheet", "--out", out.to_str().unwrap(), "--size", "96x54", "--map", "256x256"];
    arguments.extend(["--scene", "palm", "--scene", "pavilion"]);
    let one = run(&arguments.iter().copied().chain(["--case", SUN]).collect::<Vec<_>>());
    assert!(one.status.success(), "{}", String::from_utf8_lossy(&one.stderr));
    let size = |file: &Path| {
        let bytes = std::fs::read(file).unwrap();
        let side = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
        (side(16), side(20))
    };
    let picture = out.join("contact_sheet.png");
    let (width, height) = size(&picture);
    assert!(width > 2 * 800 && height > 180, "{width} x {height}");
    let text = String::from_utf8(one.stdout).unwrap();
    assert!(
        text.contains("Sun on palm: camera_space / face_columns") && text.contains("Sun on pavilion"),
        "{text}"
    );

    // Without --case all that ship for a sun are shown, each in a row of its own.
    let all = run(&arguments);
    assert!(all.status.success(), "{}", String::from_utf8_lossy(&all.stderr));
    assert!(size(&picture).1 > 3 * height && size(&picture).0 == width);
    let reports: serde_json::Value =
        serde_json::from_slice(&std::fs::read(out.join("contact_sheet.json")).unwrap()).unwrap();
    let reports = reports.as_array().unwrap();
    let for_suns =
        shaders_gen::shipped::ALL.iter().filter(|text| text.contains("light: directional")).count();
    assert_eq!(reports.len(), 2 * for_suns);
    for report in reports {
        let choice = report["choice"].as_str().unwrap();
        assert!(choice.contains(report["configuration"].as_str().unwrap()), "{choice}");
        assert!(report["score"]["mismatch"].as_f64().unwrap() < 0.3, "{report}");
    }
}

#[test]
fn wrong_arguments_say_what_to_write() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let faulty = folder.path().join("faulty.cssm");
    std::fs::write(&faulty, "pub case Sun { filter: soft, prefix: sun }").unwrap();
    let faulty = faulty.to_str().unwrap();
    let case = |case: &str, rest: &[&str]| {
        let mut arguments = vec!["render", "--scene", "palm", "--out", out, "--case", case];
        arguments.extend(rest);
        refusal(&arguments)
    };
    for (text, expected) in [
        (case("missing.cssm", &[]), "cannot read missing.cssm"),
        (case(&format!("{SUN}:Moon"), &[]), "has no case Moon; it declares Sun"),
        (case(faulty, &[]), "faulty.cssm:1:"),
        (case(SUN, &["--map", "32x32"]), "give sides of 64 to 16384 texels"),
        (case(SUN, &["--fov-y", "180"]), "180 degrees"),
        (case(SUN, &["--near", "5", "--far", "2"]), "must lie at a positive depth before the far plane"),
        (case(SUN, &["--eye", "1,2"]), "write three: x,y,z"),
        (case(SUN, &["--light", "point:1,2,3"]), "directional:X,Y,Z"),
        (case(SUN, &["--size", "big"]), "such as 640x360"),
        (case(SUN, &["--eye", "0,5,0", "--target", "0,0,0"]), "up vector"),
        (
            refusal(&["render", "--scene", "jungle", "--out", out, "--case", SUN]),
            "name palm, city, pavilion, forest",
        ),
        (refusal(&["contact-sheet", "--scene", "jungle", "--out", out]), "name palm, city, pavilion, forest"),
        (refusal(&["contact-sheet", "--case", "missing.cssm", "--out", out]), "cannot read missing.cssm"),
        (refusal(&["contact-sheet", "--map", "32x32", "--out", out]), "give sides of 64 to 16384 texels"),
    ] {
        assert!(text.contains(expected), "expected {expected:?} in {text}");
    }
    assert!(!Path::new(out).join("report.json").exists());
}
