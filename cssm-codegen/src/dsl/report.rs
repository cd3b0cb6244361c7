//! All faults of one file, for people and for tools.

use std::fmt;
use std::ops::Range;

use codespan_reporting::diagnostic::{Diagnostic as Rendered, Label};
use codespan_reporting::files::SimpleFile;
use codespan_reporting::term;
use serde::Serialize;

use super::Diagnostic;

/// All faults of one file, in the order of the text. [`std::fmt::Display`] prints [`Report::render`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Report {
    file: String,
    text: String,
    findings: Vec<Finding>,
}

/// One fault, by bytes of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// What is wrong; lower-case, no full stop.
    pub message: String,
    /// What to write instead.
    pub remedy: String,
    /// Bytes of the file where it is.
    pub bytes: Range<usize>,
    /// Other bytes that belong to the fault, and what stands there.
    pub secondary: Option<(Range<usize>, String)>,
}

impl Report {
    pub(super) fn new(file: &str, text: &str, mut findings: Vec<Finding>) -> Self {
        findings.sort_by_key(|finding| (finding.bytes.start, finding.bytes.end));
        Self { file: file.into(), text: text.into(), findings }
    }

    /// The faults, in the order of the text.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// Plain text with the lines at fault, one paragraph per fault.
    pub fn render(&self) -> String {
        let file = SimpleFile::new(&self.file, &self.text);
        let config = term::Config::default();
        let paragraphs = self.findings.iter().map(|finding| {
            let mut labels = vec![Label::primary((), finding.bytes.clone())];
            if let Some((bytes, label)) = &finding.secondary {
                labels.push(Label::secondary((), bytes.clone()).with_message(label));
            }
            let rendered = Rendered::error()
                .with_message(&finding.message)
                .with_labels(labels)
                .with_note(format!("help: {}", finding.remedy));
            // Fall back to one line if the renderer cannot find the place in the text.
            term::emit_into_string(&config, &file, &rendered)
                .unwrap_or_else(|_| format!("error: {}; {}\n", finding.message, finding.remedy))
        });
        paragraphs.collect::<Vec<_>>().join("")
    }

    /// The faults as JSON: `{"file", "errors": [{"message", "remedy", "start", "end", "line", "column",
    /// "secondary"}]}`; `start` and `end` are bytes, lines and columns count from 1, columns in characters.
    pub fn to_json(&self) -> String {
        let place = |bytes: &Range<usize>| {
            let before = self.text.get(..bytes.start).unwrap_or(&self.text);
            let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
            JsonPlace {
                start: bytes.start,
                end: bytes.end,
                line: before.matches('\n').count() + 1,
                column: before.get(line_start..).unwrap_or("").chars().count() + 1,
            }
        };
        let errors = self.findings.iter().map(|finding| JsonFinding {
            message: &finding.message,
            remedy: &finding.remedy,
            place: place(&finding.bytes),
            secondary: finding
                .secondary
                .as_ref()
                .map(|(bytes, label)| JsonLabel { label, place: place(bytes) }),
        });
        let report = JsonReport { file: &self.file, errors: errors.collect() };
        // Strings and numbers always have a JSON form.
        serde_json::to_string_pretty(&report).unwrap_or_default()
    }
}

impl fmt::Display for Report {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.render())
    }
}

impl std::error::Error for Report {}

impl Finding {
    /// The fault by bytes; only spans of a parsed text know theirs.
    pub(super) fn of(diagnostic: &Diagnostic) -> Self {
        Self {
            message: diagnostic.message.clone(),
            remedy: diagnostic.remedy.clone(),
            bytes: diagnostic.span.byte_range(),
            secondary: diagnostic.secondary.as_ref().map(|(span, label)| (span.byte_range(), label.clone())),
        }
    }
}

#[derive(Serialize)]
struct JsonReport<'a> {
    file: &'a str,
    errors: Vec<JsonFinding<'a>>,
}

#[derive(Serialize)]
struct JsonFinding<'a> {
    message: &'a str,
    remedy: &'a str,
    #[serde(flatten)]
    place: JsonPlace,
    #[serde(skip_serializing_if = "Option::is_none")]
    secondary: Option<JsonLabel<'a>>,
}

#[derive(Serialize)]
struct JsonLabel<'a> {
    label: &'a str,
    #[serde(flatten)]
    place: JsonPlace,
}

#[derive(Serialize)]
struct JsonPlace {
    start: usize,
    end: usize,
    line: usize,
    column: usize,
}
