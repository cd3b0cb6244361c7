//! Convergence against ray casting for every kind of light, configuration and distribution: errors shrink with the map,
//! interiors are right, facet boundaries do not show.
//!
//! The normal run judges one view for each configuration; `CSSM_FULL=1` judges all of them on every scene and writes
//! `reports/convergence-*.md`. The f64 twin captures and resolves; with `CSSM_JUDGE=gpu` the device does.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use cssm_core::case::LightKind;
use cssm_core::plan;
use cssm_lab::catalogue::{Entry, KINDS, Situation, entries, situations};
use cssm_lab::convergence::{Convergence, Level, convergence, twin_convergence};
use cssm_lab::error::LabError;
use cssm_lab::gpu::{Gpu, ResolveMethod};
use cssm_lab::progress::Progress;
use cssm_lab::scene::Scene;
use cssm_lab::sight::{Sight, StageOptions};
use cssm_lab::stage::Stage;
use cssm_lab::truth::Tracer;
use cssm_lab::twin::TwinCasters;

/// Judges a case in one situation.
type Judge<'a> = Box<dyn Fn(&Entry) -> Result<Convergence, LabError> + 'a>;

const SIZE: (u32, u32) = (640, 360);
const NORMAL_SIDES: [u32; 3] = [512, 1024, 2048];
const FULL_SIDES: [u32; 4] = [512, 1024, 2048, 4096];
/// Steepest allowed slope of log mismatch over log map side, solid objects.
const SOLID_SLOPE: f64 = -0.77;
/// The same where surfaces are thinner than a pixel, or texels are spent on what lies before a focus.
const SLOW_SLOPE: f64 = -0.3;
/// Largest share of interior errors, solid objects.
const SOLID_INTERIOR: f64 = 5e-5;
/// The same where surfaces are thinner than a pixel.
const THIN_INTERIOR: f64 = 1e-4;
/// Largest ratio of edge displacement beside facet boundaries to that elsewhere.
const SEAM_RATIO: f64 = 1.2;
/// Fewest edge pixels beside boundaries from which the ratio says anything.
const SEAM_PIXELS: u64 = 10_000;
/// True edges without which a view is no test.
const FEWEST_EDGES: u64 = 1000;

/// What the normal run judges: for each camera space configuration a situation of the palms that it is made for, and some
/// peers.
const NORMAL: [(&str, &[&str]); 6] = [
    (
        "sun-0",
        &[
            "directional one_plane perspective stretched",
            "directional face_columns bands",
            "directional trapezoidal",
            "directional perspective cube_faces",
        ],
    ),
    ("sun-2", &["directional four_plane"]),
    ("omni-in-view", &["omni eight_plane"]),
    ("omni-behind", &["omni four_plane", "omni tetrahedron"]),
    (
        "omni-outside",
        &["omni one_plane two_segment stretched", "omni face_columns logarithmic stretched", "omni cube"],
    ),
    ("spot-dueling", &["spot light_projection"]),
];

/// One case in one situation of one scene.
struct Finding {
    scene: String,
    thin: bool,
    situation: String,
    entry: Entry,
    found: Option<Convergence>,
    note: String,
}

/// Judges the wanted cases in the wanted situations of a scene.
fn judge(
    scene: &Scene,
    thin: bool,
    sides: &[u32],
    wanted: &dyn Fn(&Situation, &Entry) -> bool,
) -> Vec<Finding> {
    let tracer = Tracer::new(scene);
    let on_gpu = std::env::var_os("CSSM_JUDGE").is_some_and(|judge| judge == "gpu");
    let mut findings = Vec::new();
    for situation in situations(scene, SIZE).unwrap() {
        let entries: Vec<Entry> = entries(situation.light.kind()).unwrap();
        let entries: Vec<Entry> = entries.into_iter().filter(|entry| wanted(&situation, entry)).collect();
        if entries.is_empty() {
            continue;
        }
        let options = StageOptions { supersample: true, progress: Progress::Hidden };
        let sight = Sight::trace(scene, &tracer, situation.view, situation.light, options).unwrap();
        let gpu = on_gpu
            .then(|| Gpu::open(&entries.iter().map(|entry| &entry.case).collect::<Vec<_>>(), SIZE).unwrap());
        let casters = TwinCasters::new(scene, situation.view.eye_world);
        let find: Judge<'_> = match &gpu {
            Some(gpu) => {
                let stage = Stage::of(gpu, sight).unwrap();
                Box::new(move |entry| convergence(&stage, &entry.case, ResolveMethod::Function, sides))
            }
            None => Box::new(move |entry| twin_convergence(&sight, &casters, &entry.case, sides)),
        };
        for entry in entries {
            let bounds = cssm_core::SceneBounds::of(scene.bounds_world());
            let choice = plan(&entry.case, &situation.view, &situation.light, &bounds).unwrap().choice;
            let (found, note) = match find(&entry) {
                _ if !choice.complete => (None, "leaves out receivers".to_owned()),
                Ok(found) => (
                    Some(found),
                    if choice.made_for_position.is_empty() { "" } else { "degraded" }.to_owned(),
                ),
                Err(LabError::NothingJudged { .. }) => {
                    (None, "too coarse or too few errors to be judged".to_owned())
                }
                Err(error) => panic!("{} in {} on {}: {error}", entry.name, situation.name, scene.name),
            };
            let (scene, situation) = (scene.name.clone(), situation.name.clone());
            let finding = Finding { scene, thin, situation, entry, found, note };
            println!("{}", finding.line());
            findings.push(finding);
        }
    }
    findings
}

impl Finding {
    /// A row of the report.
    fn line(&self) -> String {
        let mut line = format!("| {} | {} | {} |", self.scene, self.situation, self.entry.name);
        let Some(found) = &self.found else {
            return format!("{line} - | - | - | - | - | {} |", self.note);
        };
        let each =
            |value: &dyn Fn(&Level) -> String| found.levels.iter().map(value).collect::<Vec<_>>().join(" ");
        let percent = |level: &Level| format!("{:.2}", 100.0 * level.score.mismatch);
        let edges =
            |level: &Level| format!("{:.2}", level.score.edge_displacement.true_to_map.footprints.p95);
        let (wrong, pixels) = found.interior_pooled;
        let seam = pooled_seam(found.levels.iter());
        let seam = seam.map_or("-".to_owned(), |beside| beside.to_string());
        let slope = found.slope.map_or("-".to_owned(), |slope| format!("{slope:.2}"));
        write!(
            line,
            " {} | {slope} | {wrong} of {pixels} | {} | {seam} | {} |",
            each(&percent),
            each(&edges),
            self.note
        )
        .unwrap();
        line
    }

    /// What must hold of it.
    fn check(&self) -> Vec<String> {
        let Some(found) = &self.found else { return Vec::new() };
        let mut faults = Vec::new();
        let mut fault = |text: String| {
            faults.push(format!("{} in {} on {}: {text}", self.entry.name, self.situation, self.scene));
        };
        let peer = self.entry.case.technique.name != "camera_space";
        let slow = peer
            || self.thin
            || self.entry.name.contains("perspective")
            || self.entry.configuration == "four_plane";
        let bar = if slow { SLOW_SLOPE } else { SOLID_SLOPE };
        let judged = found.levels.iter().filter(|level| level.judged).count();
        if judged > 2 && found.slope.is_some_and(|slope| slope > bar) {
            fault(format!("slope {:?}, at most {bar}", found.slope));
        }
        let falls = |pair: &[Level]| pair[1].score.mismatch < pair[0].score.mismatch || !pair[0].judged;
        if !found.levels.windows(2).all(falls) {
            fault("halving the map must raise the mismatch".to_owned());
        }
        faults
    }
}

/// Edge displacement beside facet boundaries.
#[derive(Clone, Copy)]
struct Beside {
    /// Edge pixels there.
    pixels: u64,
    /// Mean displacement over that in the surroundings, where shadows are of the same kind.
    nearby: f64,
    /// Mean displacement over that everywhere else.
    elsewhere: f64,
}

impl std::fmt::Display for Beside {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{:.2} ({:.2}) of {}", self.nearby, self.elsewhere, self.pixels)
    }
}

/// Displacement beside facet boundaries, pooled over judged levels.
fn pooled_seam<'a>(levels: impl Iterator<Item = &'a Level>) -> Option<Beside> {
    let mut sums = [(0, 0.0); 3];
    for seam in levels.filter(|level| level.judged).filter_map(|level| level.score.seam) {
        let parts = [
            (seam.strip_edge_pixels, seam.strip_mean),
            (seam.nearby_edge_pixels, seam.nearby_mean),
            (seam.elsewhere_edge_pixels, seam.elsewhere_mean),
        ];
        for (sum, (pixels, mean)) in sums.iter_mut().zip(parts) {
            *sum = (sum.0 + pixels, sum.1 + mean * pixels as f64);
        }
    }
    let [strip, nearby, elsewhere] = sums.map(|(pixels, sum)| sum / pixels as f64);
    let beside = Beside { pixels: sums[0].0, nearby: strip / nearby, elsewhere: strip / elsewhere };
    (beside.nearby.is_finite() && beside.elsewhere.is_finite()).then_some(beside)
}

/// Kind of light and configuration.
type Key = (String, &'static str, bool);

/// Interior errors and seams, pooled over everything that has one configuration.
fn pooled(findings: &[Finding]) -> BTreeMap<Key, ((u64, u64), Option<Beside>)> {
    let mut groups: BTreeMap<Key, Vec<&Convergence>> = BTreeMap::new();
    for finding in findings {
        let kind = finding.entry.case.light.name().to_owned();
        let key = (kind, finding.entry.configuration, finding.thin);
        groups.entry(key).or_default().extend(&finding.found);
    }
    let pool = |found: Vec<&Convergence>| {
        let interior = found
            .iter()
            .fold((0, 0), |sum, found| (sum.0 + found.interior_pooled.0, sum.1 + found.interior_pooled.1));
        (interior, pooled_seam(found.iter().flat_map(|found| &found.levels)))
    };
    groups.into_iter().map(|(key, found)| (key, pool(found))).collect()
}

/// Faults of pooled figures.
fn check_pooled(findings: &[Finding]) -> Vec<String> {
    let mut faults = Vec::new();
    for ((kind, configuration, thin), ((wrong, pixels), seam)) in pooled(findings) {
        let bar = if thin { THIN_INTERIOR } else { SOLID_INTERIOR };
        if wrong as f64 > bar * pixels as f64 {
            faults.push(format!("{kind} {configuration}: {wrong} of {pixels} interior pixels are wrong"));
        }
        if let Some(beside) = seam.filter(|beside| beside.pixels >= SEAM_PIXELS && beside.nearby > SEAM_RATIO)
        {
            faults.push(format!("{kind} {configuration}: seam ratio {beside} edge pixels"));
        }
    }
    faults
}

#[test]
fn every_configuration_converges_where_it_is_made_for() {
    let wanted = |situation: &Situation, entry: &Entry| {
        NORMAL.iter().any(|(name, entries)| *name == situation.name && entries.contains(&entry.name.as_str()))
    };
    let findings = judge(&Scene::palm(), true, &NORMAL_SIDES, &wanted);
    let named: usize = NORMAL.iter().map(|(_, entries)| entries.len()).sum();
    assert_eq!(findings.len(), named, "a case of the list has another name");
    for kind in KINDS.into_iter().filter(|kind| *kind != LightKind::Spot) {
        let own =
            entries(kind).unwrap().into_iter().filter(|entry| entry.case.technique.name == "camera_space");
        for entry in own {
            let judged = |finding: &Finding| {
                finding.entry.configuration == entry.configuration && finding.entry.case.light == kind
            };
            assert!(findings.iter().any(judged), "{} is not in the list", entry.name);
        }
    }
    for finding in &findings {
        let found = finding.found.as_ref().unwrap_or_else(|| panic!("{}", finding.line()));
        assert!(found.levels[0].score.true_edge_pixels >= FEWEST_EDGES, "{}", finding.line());
    }
    let mut faults: Vec<String> = findings.iter().flat_map(Finding::check).collect();
    faults.extend(check_pooled(&findings));
    assert!(faults.is_empty(), "{faults:#?}");
}

/// Judges everything on a scene and writes its report, in a full run.
fn judge_everything(scene: &Scene, thin: bool) {
    if std::env::var_os("CSSM_FULL").is_none() {
        return;
    }
    let findings = judge(scene, thin, &FULL_SIDES, &|_, _| true);
    let mut faults: Vec<String> = findings.iter().flat_map(Finding::check).collect();
    faults.extend(check_pooled(&findings));
    write_report(&scene.name, &findings, &faults);
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn everything_converges_on_the_palms() {
    judge_everything(&Scene::palm(), true);
}

#[test]
fn everything_converges_in_the_pavilion() {
    judge_everything(&Scene::pavilion(), false);
}

#[test]
fn everything_converges_in_the_city() {
    judge_everything(&Scene::city(), false);
}

#[test]
fn everything_converges_in_the_forest() {
    judge_everything(&Scene::forest(), true);
}

/// Writes the committed report of a scene.
fn write_report(scene: &str, findings: &[Finding], faults: &[String]) {
    let mut text = format!("# Convergence against ray casting: {scene}\n\n");
    text.push_str(
        "\
         Views of 640 x 360 pixels, square maps; mismatch in percent of the light-facing pixels and p95 edge displacement in \
         footprints at 512, 1024, 2048 and 4096 texels a side; slope of log mismatch over log side; wrong interior pixels; \
         edge displacement beside facet boundaries over that in their surroundings (elsewhere), of so many edge pixels.\n\n## By configuration\n\n\
         | light | configuration | wrong interior pixels | seam |\n| - | - | - | - |\n",
    );
    for ((kind, configuration, _), ((wrong, pixels), seam)) in pooled(findings) {
        let seam = seam.map_or("-".to_owned(), |beside| beside.to_string());
        writeln!(text, "| {kind} | {configuration} | {wrong} of {pixels} | {seam} |").unwrap();
    }
    text += "\n## Beyond the limits\n\n";
    for fault in faults {
        writeln!(text, "- {fault}").unwrap();
    }
    if faults.is_empty() {
        text += "None.\n";
    }
    text += "\n## Everything\n\n| scene | situation | case | mismatch % | slope | interior | edge p95 | seam | |\n\
             | - | - | - | - | - | - | - | - | - |\n";
    for finding in findings {
        writeln!(text, "{}", finding.line()).unwrap();
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports");
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join(format!("convergence-{scene}.md")), text).unwrap();
}
