//! All faults of a caster entry, with places in the engine's files and in the generated part.

use std::fmt;
use std::ops::Range;

use codespan_reporting::diagnostic::{Diagnostic, Label};
use codespan_reporting::files::SimpleFiles;
use codespan_reporting::term;

/// All faults of a caster entry, in the order of the files. [`std::fmt::Display`] prints [`CasterReport::render`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CasterReport {
    files: Vec<(String, String)>,
    findings: Vec<CasterFinding>,
}

/// One fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CasterFinding {
    /// What is wrong; lower-case, no full stop.
    pub message: String,
    /// What to write instead.
    pub remedy: String,
    /// Where it is, and what stands there; first the place to mend. Empty where the fault is that something is missing.
    pub places: Vec<(CasterPlace, String)>,
}

/// Bytes of one of a report's files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CasterPlace {
    /// Number of the file: the engine's in the order in which they were given, then generated ones.
    pub file: usize,
    /// Bytes of the file.
    pub bytes: Range<usize>,
}

impl CasterReport {
    /// The faults by place, each once.
    pub(super) fn new(files: Vec<(String, String)>, findings: Vec<CasterFinding>) -> Self {
        let mut report = Self { files, findings: Vec::new() };
        let mut sorted = findings;
        sorted.sort_by_key(|finding| {
            finding.first_place().map(|place| (place.file, place.bytes.start, place.bytes.end))
        });
        for finding in sorted {
            let same = |known: &CasterFinding| {
                known.message == finding.message && known.first_place() == finding.first_place()
            };
            if !report.findings.iter().any(same) {
                report.findings.push(finding);
            }
        }
        report
    }

    /// The faults, in the order of the files.
    pub fn findings(&self) -> &[CasterFinding] {
        &self.findings
    }

    /// Name and text of the file of a place.
    pub fn file(&self, place: &CasterPlace) -> Option<(&str, &str)> {
        self.files.get(place.file).map(|(name, text)| (name.as_str(), text.as_str()))
    }

    /// Line and column where a place begins, counted from 1, columns in characters.
    pub fn line_and_column(&self, place: &CasterPlace) -> Option<(usize, usize)> {
        let (_, text) = self.file(place)?;
        let before = text.get(..place.bytes.start)?;
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Some((before.matches('\n').count() + 1, before[line_start..].chars().count() + 1))
    }

    /// Plain text with the lines at fault, one paragraph for each fault.
    pub fn render(&self) -> String {
        let mut files = SimpleFiles::new();
        let numbers: Vec<_> =
            self.files.iter().map(|(name, text)| files.add(name.as_str(), text.as_str())).collect();
        let config = term::Config::default();
        let paragraphs = self.findings.iter().map(|finding| {
            let labels = finding.places.iter().enumerate().filter_map(|(index, (place, text))| {
                let file = *numbers.get(place.file)?;
                let label = match index {
                    0 => Label::primary(file, place.bytes.clone()),
                    _ => Label::secondary(file, place.bytes.clone()),
                };
                Some(if text.is_empty() { label } else { label.with_message(text) })
            });
            let rendered = Diagnostic::error()
                .with_message(&finding.message)
                .with_labels(labels.collect())
                .with_note(format!("help: {}", finding.remedy));
            // Fall back to one line if the renderer cannot find the place in the text.
            term::emit_into_string(&config, &files, &rendered)
                .unwrap_or_else(|_| format!("error: {}; {}\n", finding.message, finding.remedy))
        });
        paragraphs.collect::<Vec<_>>().join("")
    }
}

impl CasterFinding {
    /// A fault at one place.
    pub(super) fn at(place: CasterPlace, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { message: message.into(), remedy: remedy.into(), places: vec![(place, String::new())] }
    }

    /// A fault that has no place.
    pub(super) fn nowhere(message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { message: message.into(), remedy: remedy.into(), places: Vec::new() }
    }

    /// The fault with a word on its first place.
    pub(super) fn labelled(mut self, label: impl Into<String>) -> Self {
        if let Some((_, text)) = self.places.first_mut() {
            *text = label.into();
        }
        self
    }

    /// The fault with another place that belongs to it.
    pub(super) fn and(mut self, place: CasterPlace, label: impl Into<String>) -> Self {
        self.places.push((place, label.into()));
        self
    }

    /// The fault at another place if it has none.
    pub(super) fn or_at(mut self, place: impl FnOnce() -> Option<CasterPlace>) -> Self {
        if self.places.is_empty() {
            self.places.extend(place().map(|place| (place, String::new())));
        }
        self
    }

    fn first_place(&self) -> Option<&CasterPlace> {
        self.places.first().map(|(place, _)| place)
    }
}

impl fmt::Display for CasterReport {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.render())
    }
}

impl std::error::Error for CasterReport {}
