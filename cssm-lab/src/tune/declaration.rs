//! The declaration that tuning writes, with its promise and its evidence in comments.

use std::fmt::Write;

use cssm_codegen::dsl;
use cssm_core::LightCase;
use cssm_core::table::CaseTable;

use super::budget::{Budget, Metric, Promise};
use super::confirm::{Confirmation, Shown, path_text};
use super::cost::bytes_text;
use super::minimise::{Evidence, Minimal, Without};
use super::search::{Contender, Known};
use super::sites::Path;

/// Everything a declaration file says.
pub struct Declared<'t> {
    /// Name of the scene.
    pub scene: &'t str,
    /// Size of the images, pixels.
    pub pixels: (u32, u32),
    /// The paths that were tuned on.
    pub paths: &'t [Path],
    /// What was asked for.
    pub budget: Budget,
    /// Share of the budget that is kept free.
    pub margin: f64,
    /// What is promised.
    pub promise: &'t Promise,
    /// What was searched: variants, those that cannot be planned, those that were ray cast.
    pub searched: Searched,
    /// The best of each technique.
    pub contenders: &'t [Contender],
    /// The declaration.
    pub minimal: &'t Minimal,
    /// How long it takes, if time was the budget.
    pub time: Option<&'t Time>,
    /// What it has on other views.
    pub unseen: Option<&'t Confirmation>,
    /// What the generated shaders show, if a device was asked.
    pub shown: Option<&'t Shown>,
}

/// Time of capture and resolve.
#[derive(Debug, Clone, PartialEq)]
pub struct Time {
    /// As a multiple of the customary standard map's, measured in turns with it.
    pub ratio: f64,
    /// On which device.
    pub adapter: String,
}

/// How much was searched.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Searched {
    /// Declarations that were planned on every station.
    pub planned: usize,
    /// Declarations that some station's plan refuses.
    pub refused: usize,
    /// Measurements by ray-cast truth.
    pub measured: usize,
}

impl Declared<'_> {
    /// The declaration file.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for line in self.lines() {
            let _ = writeln!(text, "{}", format!("// {line}").trim_end());
        }
        text.push_str(&dsl::print(&self.minimal.case));
        text
    }

    /// What the comments say, line by line.
    fn lines(&self) -> Vec<String> {
        let mut lines = self.promise_lines();
        lines.push(String::new());
        lines.extend(self.choice_lines());
        lines.push(String::new());
        lines.extend(self.evidence_lines());
        lines
    }

    fn promise_lines(&self) -> Vec<String> {
        let Self { promise, minimal, .. } = self;
        let metric = promise.metric;
        let errors = &minimal.errors;
        let views: Vec<String> =
            self.paths.iter().map(|path| format!("{} ({} views)", path.name, path.stations)).collect();
        let (width, height) = self.pixels;
        let mut lines = vec![
            format!("Tuned by `cssm-lab tune` on scene `{}`, {width} x {height} pixels.", self.scene),
            format!("Views: {}.", views.join(", ")),
            format!("Budget: {}.", self.budget_text()),
            format!(
                "Promise: {} at most {} on each path, all its views together.",
                metric.name(),
                metric.text(promise.promised)
            ),
            format!(
                "Tuned so that no single view has more than {}; the worst has {}, {:.1} % below the promise.",
                metric.text(promise.limit),
                metric.text(errors.error),
                100.0 * (1.0 - errors.error / promise.promised)
            ),
        ];
        if promise.mismatch_limit.is_finite() {
            lines.push(format!(
                "  Besides, mismatch of a view at most {}; measured {}.",
                Metric::Mismatch.text(promise.mismatch_limit),
                Metric::Mismatch.text(errors.mismatch)
            ));
        }
        if let Some(Time { ratio, adapter }) = self.time {
            let late = matches!(self.budget, Budget::Time(most) if *ratio > most);
            let verdict = if late { ", NOT KEPT when measured again" } else { "" };
            lines.push(format!(
                "  Time: {ratio:.2} times the customary standard map's on {adapter}{verdict}."
            ));
        }
        for (path, error) in self.paths.iter().zip(&errors.of_paths) {
            lines.push(format!("  {}", path_text(path, error, metric)));
        }
        lines.extend(
            self.unseen.map_or_else(
                || vec!["Not checked on other views.".to_owned()],
                |unseen| unseen.lines(metric),
            ),
        );
        lines.extend(self.shown.map(|shown| shown.lines(metric)).unwrap_or_default());
        lines
    }

    fn budget_text(&self) -> String {
        let metric = self.promise.metric;
        let margin = 100.0 * self.margin;
        match self.budget {
            Budget::Error(limit) => {
                format!("{} at most {}, less a margin of {margin:.0} %", metric.name(), metric.text(limit))
            }
            budget @ (Budget::Time(_) | Budget::Texels(_)) => {
                format!("{budget}; a view's error may be {margin:.0} % above the smallest found")
            }
        }
    }

    /// Why this one.
    fn choice_lines(&self) -> Vec<String> {
        let Searched { planned, refused, measured } = &self.searched;
        let cost = &self.minimal.errors.cost;
        let mut lines = vec![
            format!(
                "Chosen from {} variants: {planned} planned on every view, {refused} refused by plans, {measured} \
                 measurements by ray casting.",
                planned + refused
            ),
            format!(
                "A frame moves {}: the map {}, corners of {:.0} triangles in {:.1} facets, texels read {}.",
                bytes_text(cost.bytes()),
                bytes_text(cost.map_bytes),
                cost.triangles,
                cost.facets,
                bytes_text(cost.read_bytes)
            ),
        ];
        let taken: Vec<String> = self.minimal.errors.configurations.iter().map(taken_text).collect();
        lines.push(format!("Configurations taken: {}.", taken.join(", ")));
        let table = CaseTable::describe(&self.minimal.case);
        let passes: Vec<&str> = table.passes.iter().map(|pass| pass.shader.name()).collect();
        lines.push(format!("Passes generated: {}.", passes.join(", ")));
        lines.push("The best of each technique before anything was left out:".to_owned());
        for contender in self.contenders {
            lines.push(format!("  {}", contender_text(contender, self.promise)));
        }
        lines
    }

    fn evidence_lines(&self) -> Vec<String> {
        let Self { minimal, promise, .. } = self;
        let line = |evidence: &Evidence| format!("  {}", evidence_text(evidence, promise));
        let mut lines = vec!["Left out, because the promise holds without:".to_owned()];
        lines.extend(minimal.left_out.iter().map(line));
        if minimal.left_out.is_empty() {
            lines.push("  nothing: the variant had nothing to spare".to_owned());
        }
        if !minimal.not_added.is_empty() {
            lines.push("Not declared, because the promise holds without:".to_owned());
            lines.extend(minimal.not_added.iter().map(line));
        }
        lines.push("Kept, because the promise breaks without:".to_owned());
        lines.extend(minimal.needed.iter().map(line));
        lines
    }
}

fn taken_text((name, count): &(&'static str, usize)) -> String {
    format!("{name} in {count} views")
}

/// One removal with its numbers.
pub fn evidence_text(evidence: &Evidence, promise: &Promise) -> String {
    let both = |error: f64, mismatch: f64| {
        let text = promise.metric.text(error);
        if promise.metric == Metric::Mismatch {
            text
        } else {
            format!("{text} and mismatch {}", Metric::Mismatch.text(mismatch))
        }
    };
    let with = both(evidence.with.0, evidence.with.1);
    match &evidence.without {
        Without::Measured(error, mismatch) => {
            format!("{}: {with} with it, {} without", evidence.what, both(*error, *mismatch))
        }
        Without::Impossible(reason) => {
            format!("{}: {with} with it, impossible without: {reason}", evidence.what)
        }
    }
}

/// A contender in a line.
pub fn contender_text(contender: &Contender, promise: &Promise) -> String {
    let Contender { label, side, bytes, error, known, .. } = contender;
    let metric = promise.metric;
    let verdict = match known {
        Known::Keeps => format!("{} measured", metric.text(*error)),
        Known::Misses if *error <= promise.limit => {
            format!("{} measured, not the smallest", metric.text(*error))
        }
        Known::Misses => format!("{} measured, too much", metric.text(*error)),
        Known::MissesBy => format!("at least {} measured, too much", metric.text(*error)),
        Known::Predicted => format!("{} expected, not measured", metric.text(*error)),
    };
    format!("{label}, {side} x {side}: {} a frame, {verdict}", bytes_text(*bytes))
}

/// The case under a name and a doc comment of its own.
pub fn named(case: &LightCase, scene: &str, paths: &[Path], doc: &str) -> LightCase {
    let letters = |text: &str| -> String {
        let words = text.split(|letter: char| !letter.is_ascii_alphabetic());
        let capital = |word: &str| {
            let mut letters = word.chars();
            let first = letters.next().map(|first| first.to_ascii_uppercase());
            first.into_iter().chain(letters).collect::<String>()
        };
        words.map(capital).collect()
    };
    let stem = std::path::Path::new(scene).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let mut name = format!("Tuned{}", letters(&stem.unwrap_or_default()));
    if paths.len() < 4 {
        name.extend(paths.iter().map(|path| letters(&path.name)));
    }
    let mut arguments = case.to_arguments();
    arguments.0.retain(|(field, _)| *field != "prefix");
    // A name of letters alone has a sound prefix.
    LightCase::from_arguments(&name, doc, true, &arguments).unwrap_or_else(|_| case.clone())
}
