//! Tuning: what is chosen keeps its promise, and holds nothing that the promise does not need.

use std::path::Path;

use clap::Parser;
use cssm_codegen::dsl;
use cssm_core::LightCase;
use cssm_lab::case_file::pick_case;
use cssm_lab::error::LabError;
use cssm_lab::measure::bench::{Bench, BenchOptions, JudgeKind, Receivers};
use cssm_lab::measure::{evaluate, paths};
use cssm_lab::progress::Progress;
use cssm_lab::scene::Scene;
use cssm_lab::truth::Tracer;
use cssm_lab::tune::bench::{Bench as TuneBench, Measured};
use cssm_lab::tune::error::TuneError;
use cssm_lab::tune::features::removals;
use cssm_lab::tune::minimise::Without;
use cssm_lab::tune::sites::Sites;
use cssm_lab::tune::{TuneArguments, Tuned, tune};

/// Fewest variants that tuning compares.
const FEWEST_VARIANTS: usize = 200;

#[derive(Parser)]
struct Line {
    #[command(flatten)]
    tune: TuneArguments,
}

fn arguments(line: &str) -> TuneArguments {
    Line::try_parse_from(std::iter::once("tune").chain(line.split_whitespace())).unwrap().tune
}

fn tuned(line: &str) -> Tuned {
    tune(&arguments(line), Progress::Hidden).unwrap_or_else(|error| panic!("{error}"))
}

/// The declared case, read from the written file.
fn read(tuned: &Tuned) -> LightCase {
    pick_case(Path::new("tuned.cssm"), &tuned.text, None).unwrap_or_else(|error| panic!("{error}"))
}

/// Measures every removal of the written declaration again, from nothing.
fn assert_minimal(line: &str, tuned: &Tuned) {
    let arguments = arguments(line);
    let scene = Scene::load(&arguments.scene).unwrap();
    let tracer = Tracer::new(&scene);
    let mut seen = paths::builtin(&scene, &tracer, arguments.pixels).unwrap();
    let wanted: Vec<&str> = arguments.views.split(',').collect();
    seen.retain(|path| wanted.contains(&path.name.as_str()));
    let seen: Vec<_> = seen.into_iter().map(|path| path.thinned(arguments.stations)).collect();
    let sites = Sites::trace(&scene, &tracer, &seen, Progress::Hidden).unwrap();
    let mut bench = TuneBench::new(&sites, arguments.error);

    let case = read(tuned);
    let whole = bench.measure(&case, None);
    assert!(whole.keeps(&tuned.promise), "the promise does not hold: {whole:?} for {:?}", tuned.promise);
    let Measured::Whole(errors) = &whole else { panic!("{whole:?}") };
    assert_eq!(errors, &tuned.minimal.errors, "the printed numbers are not those of the declaration");

    let removals = removals(&case, arguments.resolve);
    assert!(removals.len() >= 4, "{removals:?}");
    assert_eq!(
        removals.iter().map(|removal| &removal.what).collect::<Vec<_>>(),
        tuned.minimal.needed.iter().map(|evidence| &evidence.what).collect::<Vec<_>>(),
        "the list of what is needed is not that of the declaration"
    );
    for (removal, evidence) in removals.iter().zip(&tuned.minimal.needed) {
        match (&removal.without, &evidence.without) {
            (Err(_), Without::Impossible(_)) => {}
            (Ok(less), without) => {
                let measured = bench.measure(less, None);
                assert!(!measured.keeps(&tuned.promise), "{} is not needed: {measured:?}", removal.what);
                match (&measured, without) {
                    (Measured::Whole(errors), Without::Measured(error, _)) => {
                        assert_eq!(errors.error, *error, "{}", removal.what);
                    }
                    (Measured::Unplannable { .. }, Without::Impossible(_)) => {}
                    other => panic!("{}: {other:?}", removal.what),
                }
            }
            other => panic!("{}: {other:?}", removal.what),
        }
        assert!(tuned.text.contains(&format!("{}: ", removal.what)), "{} is not printed", removal.what);
    }
    for evidence in &tuned.minimal.left_out {
        assert!(evidence.without.keeps(&tuned.promise), "{} was left out, but breaks", evidence.what);
        assert!(tuned.text.contains(&evidence.what), "{} is not printed", evidence.what);
    }
}

/// The printed check on views not seen is what `cssm-lab measure` finds there.
fn assert_confirmed(line: &str, tuned: &Tuned) {
    let arguments = arguments(line);
    let scene = Scene::load(&arguments.scene).unwrap();
    let tracer = Tracer::new(&scene);
    let confirmation = tuned.unseen.as_ref().expect("built-in paths have unseen stations");
    let (name, printed) = {
        let (path, error) = &confirmation.of_paths[0];
        (path.name.clone(), error.together)
    };
    let mut unseen = paths::unseen(&scene, &tracer, arguments.pixels).unwrap();
    unseen.retain(|path| path.name == name);
    let unseen: Vec<_> = unseen.into_iter().map(|path| path.thinned(arguments.stations)).collect();
    let (judge, receivers) = (JudgeKind::Twin, Receivers::None);
    let options =
        BenchOptions { supersample: false, judge, receivers, flicker: false, progress: Progress::Hidden };
    let bench = Bench::new(&scene, &tracer, &unseen, None, options).unwrap();
    // Measuring tells every plan the scene's bounds; a declaration without them is told none here.
    let mut case = read(tuned);
    let bounded = case.scene_bounds;
    case.scene_bounds = true;
    let found = evaluate::evaluate(&bench, &case, &bench.paths[0]).unwrap().figures.unwrap();
    let slack = if bounded { 1e-4 * printed } else { 0.15 * printed };
    assert!((found.mismatch - printed).abs() <= slack, "{} against {printed}", found.mismatch);

    // The report tells the truth about it either way.
    let says_broken = tuned.text.contains("NOT KEPT");
    assert_eq!(!confirmation.holds(), says_broken, "{}", tuned.text);
}

#[test]
fn palm_is_tuned_to_a_minimum() {
    let line = "--scene palm --views walk --max-error 2% --pixels 128x72 --stations 2 --max-side 2048";
    let tuned = tuned(line);
    let searched = &tuned.searched;
    assert!(searched.planned >= FEWEST_VARIANTS, "{searched:?}");
    assert!(tuned.minimal.errors.error <= 0.02, "{:?}", tuned.minimal.errors);
    assert_minimal(line, &tuned);
    assert_confirmed(line, &tuned);

    // The text is a declaration that round-trips, and the same every time.
    let case = read(&tuned);
    assert_eq!(dsl::parse_file("again", &dsl::print(&case)).unwrap(), [case]);
}

#[test]
fn pavilion_is_tuned_to_a_minimum_of_texels() {
    let line = "--scene pavilion --views dueling --max-texels 147456 --pixels 128x72 --stations 2";
    let tuned = tuned(line);
    let case = read(&tuned);
    assert!(u64::from(case.map.width) * u64::from(case.map.height) <= 147_456);
    assert!(tuned.searched.planned >= FEWEST_VARIANTS, "{:?}", tuned.searched);
    assert_minimal(line, &tuned);
    assert_confirmed(line, &tuned);
}

#[test]
fn an_impossible_budget_says_what_is_possible() {
    let line = "--scene palm --views walk --max-error 0.000001 --pixels 64x36 --stations 1 --max-side 256";
    let error = tune(&arguments(line), Progress::Hidden).unwrap_err();
    let LabError::Tune(TuneError::NoVariant { best_value, tried, .. }) = &error else { panic!("{error}") };
    assert!(*best_value > 0.000_001 && *best_value < 1.0, "{best_value}");
    assert!(*tried >= FEWEST_VARIANTS);
    let said = error.to_string();
    assert!(said.contains("too much") && said.contains("256 x 256"), "{said}");
}

#[test]
fn a_time_budget_is_kept_on_the_device() {
    let line = "--scene palm --views walk --pixels 64x36 --stations 1 --max-side 256";
    let tuned = tuned(&format!("{line} --max-time 50 --shaders"));
    assert_minimal(&format!("{line} --max-time 50"), &tuned);
    assert!(tuned.text.contains("times the customary standard map's on "), "{}", tuned.text);

    // The shaders show what the twin says: one path on views seen, one on others.
    let shown = tuned.shown.as_ref().expect("the shaders were asked");
    let twin = tuned.minimal.errors.of_paths[0].together;
    let [(_, true, seen), (_, false, _)] = shown.of_paths[..] else { panic!("{shown:?}") };
    assert!((seen - twin).abs() <= 0.02 + 0.1 * twin, "{seen} against {twin}");
}

#[test]
fn tuning_is_the_same_every_time() {
    let line = "--scene palm --views walk --max-error 1 --error footprint_p95 --pixels 48x27 --stations 1 \
                --max-side 1024 --margin 0";
    let arguments = arguments(&line.replace("--max-error 1", "--max-error 6"));
    let texts: Vec<String> =
        (0..2).map(|_| tune(&arguments, Progress::Hidden).unwrap_or_else(|e| panic!("{e}")).text).collect();
    assert!(texts[0] == texts[1], "two runs differ:\n{}\n{}", texts[0], texts[1]);
}

#[test]
fn the_shipped_results_are_declarations_that_kept_their_promise() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/tuned");
    for file in ["first_person.cssm", "racing.cssm", "flight.cssm"] {
        let text = std::fs::read_to_string(folder.join(file)).unwrap();
        let case = pick_case(Path::new(file), &text, None).unwrap_or_else(|error| panic!("{error}"));
        assert!(text.ends_with(&dsl::print(&case)), "{file} is not printed as the grammar prints it");
        cssm_codegen::generate(&case).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert!(text.contains("// On views that tuning did not see the promise is kept:"), "{file}");
        assert!(!text.contains("NOT KEPT"), "{file}");
    }
}

#[test]
fn unknown_paths_are_named() {
    let error =
        tune(&arguments("--scene palm --views stroll --max-texels 65536 --pixels 32x18"), Progress::Hidden);
    let said = error.unwrap_err().to_string();
    assert!(said.contains("`stroll`") && said.contains("walk"), "{said}");
}

#[test]
fn one_budget_is_asked_for() {
    for line in
        ["--scene palm", "--scene palm --max-error 1% --max-texels 65536", "--scene palm --max-error -1"]
    {
        assert!(
            Line::try_parse_from(std::iter::once("tune").chain(line.split_whitespace())).is_err(),
            "{line}"
        );
    }
}
