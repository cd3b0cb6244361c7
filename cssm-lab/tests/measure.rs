//! Measuring: runs go on where they ended, faults are typed, the report stands alone, nothing is dropped.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use cssm_lab::measure::results::Results;

/// Small enough to be quick: one view of the smallest scene, drawn by the twin.
const QUICK: [&str; 9] =
    ["--scene", "pavilion", "--judge", "twin", "--pixels", "48x27", "--coarse-edges", "--sizes", "128"];

const VIEWS: &str = r#"{ "paths": [
    { "name": "gate <&>", "summary": "an \"odd\" name", "stations": [
        { "eye": [13.6, 3.6, 3.0], "target": [0.0, 2.3, -1.2], "light": "directional:0.15,-0.46,-0.85" } ] },
    { "name": "side", "stations": [
        { "eye": [10.5, 6.5, -8.0], "yaw_degrees": 225, "pitch_degrees": -25, "far": "infinite", "near": 0.1,
          "light": "directional:-0.72,-0.42,0.35" } ] } ] }"#;

fn measure(folder: &Path, more: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cssm-lab"));
    command.current_dir(folder).args(["--quiet", "measure"]).args(QUICK).args(more).output().unwrap()
}

fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    files.iter().for_each(|(name, text)| std::fs::write(folder.path().join(name), text).unwrap());
    folder
}

fn results(folder: &Path, name: &str) -> Results {
    Results::read(&folder.join(name)).unwrap().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

#[test]
fn a_later_run_takes_over_what_agrees_and_nothing_else() {
    let folder = folder(&[("views.json", VIEWS)]);
    let run = |cases: &str, more: &[&str]| {
        let common = ["--views", "views.json", "--cases", cases, "--json", "out.json"];
        let output = measure(folder.path(), &[&common, more].concat());
        assert!(output.status.success(), "{}", said(&output));
        (said(&output), results(folder.path(), "out.json"))
    };
    let (text, first) = run("standard", &[]);
    assert!(text.contains("2 measured, 0 taken over"), "{text}");
    assert_eq!(first.cells.len(), 2);

    // The same again: nothing is measured, nothing changes.
    let (text, again) = run("standard", &[]);
    assert!(text.contains("0 measured, 2 taken over"), "{text}");
    assert_eq!(first, again);

    // A run that was cut short after its first cell ends with the same numbers.
    let cut = Results { cells: first.cells[..1].to_vec(), ..first.clone() };
    cut.write(&folder.path().join("out.json")).unwrap();
    let (text, whole) = run("standard", &[]);
    assert!(text.contains("1 measured, 1 taken over"), "{text}");
    assert_eq!(first, whole);

    // Another size is measured, the old one is kept.
    let (text, larger) = run("standard", &["--sizes", "256"]);
    assert!(text.contains("2 measured, 2 taken over"), "{text}");
    assert!(first.cells.iter().all(|cell| larger.cells.contains(cell)));

    // A cell whose path has moved on is measured anew.
    let moved = VIEWS.replace("13.6", "13.5");
    std::fs::write(folder.path().join("views.json"), moved).unwrap();
    let (text, other) = run("standard", &[]);
    assert!(text.contains("1 measured, 1 taken over"), "{text}");
    assert_ne!(first.cells[0].found, other.cells[0].found);
    assert_eq!(first.cells[1], other.cells[1]);
}

#[test]
fn broken_view_files_say_what_to_write() {
    let station = |rest: &str| {
        format!(r#"{{ "paths": [ {{ "name": "gate", "stations": [ {{ "eye": [1, 2, 3], {rest} }} ] }} ] }}"#)
    };
    let sun = r#""light": "directional:0,-1,0""#;
    let cases = [
        ("{ paths }".to_owned(), "holds no view paths"),
        (r#"{ "paths": [] }"#.to_owned(), "give every path at least one"),
        (station(sun), "station 0 of path `gate`: say where it looks"),
        (station(r#""target": [0, 0, 0], "light": "sun""#), "`sun` is no light; write directional:X,Y,Z"),
        (station(&format!(r#""target": [1, 2, 3], {sun}"#)), "do not span a plane"),
        (station(&format!(r#""target": [0, 0, 0], "near": -1, {sun}"#)), "must lie at a positive depth"),
        (station(&format!(r#""target": [0, 0, 0], "far": "away", {sun}"#)), "line 1"),
        (station(&format!(r#""target": [0, 0, 0], "fovy": 60, {sun}"#)), "unknown field `fovy`"),
    ];
    for (text, expected) in cases {
        let folder = folder(&[("views.json", &text)]);
        let output =
            measure(folder.path(), &["--views", "views.json", "--cases", "standard", "--json", "out.json"]);
        let text = said(&output);
        assert!(!output.status.success() && text.contains(expected), "{text}\nlacks: {expected}");
        assert!(!folder.path().join("out.json").exists());
    }
}

#[test]
fn other_faults_are_typed() {
    let folder = folder(&[("views.json", VIEWS), ("old.json", "{}")]);
    let fails = |more: &[&str], expected: &str| {
        let output = measure(folder.path(), &[&["--views", "views.json"], more].concat());
        let text = said(&output);
        assert!(!output.status.success() && text.contains(expected), "{text}\nlacks: {expected}");
    };
    fails(
        &["--json", "out.json", "--cases", "magic"],
        "there is no technique `magic`; give `all`, `variants`",
    );
    fails(&["--json", "old.json"], "is no result of an earlier measurement");
    fails(&["--json", "out.json", "--filters", "blurred"], "there is no such filter; give any of none");
    fails(&["--json", "out.json", "--cases", "nowhere.cssm"], "cannot read nowhere.cssm");
    fails(&["--json", "nowhere/out.json", "--cases", "standard"], "cannot write nowhere/out.json");
}

#[test]
fn a_refused_case_is_reported_not_dropped() {
    // A finite case refuses an infinite view.
    let cases = "pub case Finite { view: perspective { far: finite }, prefix: finite }
                 pub case Sun { bounds: scene, prefix: sun }";
    let folder = folder(&[("views.json", VIEWS), ("cases.cssm", cases)]);
    let common = ["--views", "views.json", "--cases", "cases.cssm", "--json", "out.json"];
    let output = measure(folder.path(), &[&common[..], &["--html", "out.html"]].concat());
    assert!(output.status.success(), "{}", said(&output));
    let results = results(folder.path(), "out.json");
    let of = |name: &str| results.cells.iter().filter(|cell| cell.case == name).collect::<Vec<_>>();
    assert_eq!((of("Finite").len(), of("Sun").len()), (2, 2));
    for cell in of("Finite") {
        assert!(cell.found.figures.is_none());
        assert!(cell.found.refusals[0].reason.contains("far plane is at infinity"), "{cell:?}");
    }
    assert!(of("Sun").iter().all(|cell| cell.found.figures.is_some() && cell.found.refusals.is_empty()));
    assert!(said(&output).contains("refused everywhere"));
    let page = std::fs::read_to_string(folder.path().join("out.html")).unwrap();
    assert!(page.contains("far plane is at infinity"));
}

#[test]
fn the_report_stands_alone() {
    let folder = folder(&[("views.json", VIEWS)]);
    let files = ["--json", "out.json", "--plot", "out.svg", "--html", "out.html"];
    let cases = ["--views", "views.json", "--cases", "standard,parallel_split,camera_space"];
    let output = measure(folder.path(), &[&cases[..], &files[..]].concat());
    assert!(output.status.success(), "{}", said(&output));
    let read = |name: &str| std::fs::read_to_string(PathBuf::from(folder.path()).join(name)).unwrap();
    let (page, plot) = (read("out.html"), read("out.svg"));

    // No address but the namespace of the plot, no script, no style sheet or picture from elsewhere.
    let namespace = "http://www.w3.org/2000/svg";
    for text in [&page, &plot] {
        let rest = text.replace(namespace, "");
        assert!(!rest.contains("http:") && !rest.contains("https:") && !rest.contains("//cdn"), "an address");
        assert!(!rest.contains("<script") && !rest.contains("<link") && !rest.contains("@import"));
    }
    let sources: Vec<&str> = page.split("src=\"").skip(1).map(|rest| &rest[..11]).collect();
    assert!(sources.len() > 3 && sources.iter().all(|source| *source == "data:image/"), "{sources:?}");

    // What the user wrote is text, not markup; every case is there.
    assert!(page.contains("gate &lt;&amp;&gt;") && !page.contains("gate <&>"));
    for case in &results(folder.path(), "out.json").cases {
        assert!(page.contains(&case.label), "{}", case.label);
    }
    assert!(plot.starts_with("<svg") && plot.contains("on the front"));
}
