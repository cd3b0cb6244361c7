//! What naga says about the engine's pieces, alone and with the generated part, with its places traced back.

use std::collections::BTreeSet;
use std::error::Error;
use std::ops::Range;

use naga::front::wgsl::{Frontend, Options};
use naga::valid::{Capabilities, ValidationFlags, Validator};

use super::pieces::{EngineFile, Piece};
use super::report::{CasterFinding, CasterPlace};
use super::stages;
use super::text::Composed;
use crate::judge::Judged;

/// A fault in a text, by its bytes.
struct Fault {
    message: String,
    notes: Vec<String>,
    labels: Vec<(Range<usize>, String)>,
}

fn parse(text: &str, capabilities: Capabilities) -> Result<naga::Module, Fault> {
    let options = Options { parse_doc_comments: false, capabilities };
    Frontend::new_with_options(options).parse(text).map_err(|error| Fault {
        message: error.message().to_owned(),
        notes: error.notes().map(str::to_owned).collect(),
        labels: error
            .labels()
            .filter_map(|(span, label)| Some((span.to_range()?, label.to_owned())))
            .collect(),
    })
}

/// Parses and validates a text.
fn check(text: &str, capabilities: Capabilities) -> Result<Judged, Fault> {
    let module = parse(text, capabilities)?;
    let validated = Validator::new(ValidationFlags::all(), capabilities).validate(&module);
    let info = validated.map_err(|error| {
        // The innermost cause says what is wrong, the first span is the narrowest.
        let mut chain = vec![error.as_inner().to_string()];
        let mut cause = error.as_inner().source();
        while let Some(next) = cause {
            chain.push(next.to_string());
            cause = next.source();
        }
        Fault {
            message: chain.join(": "),
            notes: Vec::new(),
            labels: error
                .spans()
                .filter_map(|(span, label)| Some((span.to_range()?, label.clone())))
                .collect(),
        }
    })?;
    Ok(Judged { module, info })
}

/// Validates the reached pieces by themselves, and returns them as a module with all attributes, with what its functions
/// use that their stages lack: `roots` are the position function and, if there is one, the hole function. A piece at fault
/// is left out and the others are looked at again, so that every file's faults are found at once; what only misses a piece
/// that was left out is no fault of its own.
pub(super) fn alone(
    files: &[EngineFile],
    pieces: &[Piece],
    reached: &[usize],
    roots: &[&str],
) -> Result<(naga::Module, Vec<CasterFinding>), Vec<CasterFinding>> {
    let mut left_out: BTreeSet<usize> = BTreeSet::new();
    let mut findings = Vec::new();
    let stages = loop {
        let left: Vec<_> = reached.iter().copied().filter(|number| !left_out.contains(number)).collect();
        let plain = joined(pieces, &left, Composed::piece);
        let fault = match check(&plain.text, Capabilities::empty()) {
            Ok(judged) if findings.is_empty() => break stages::faults(&judged, &plain, pieces, roots),
            Ok(_) => return Err(findings),
            Err(fault) => fault,
        };
        let first = fault.labels.first().map(|(bytes, _)| bytes.clone());
        let missing = first.clone().and_then(|bytes| plain.text.get(bytes)).unwrap_or("");
        let follows = left_out.iter().any(|number| pieces[*number].name() == missing && !missing.is_empty());
        if !follows {
            findings.push(finding(&fault, &plain, files.len()));
        }
        let piece = first.and_then(|bytes| plain.piece_at(bytes.start));
        if !piece.is_some_and(|piece| left_out.insert(piece)) {
            return Err(findings);
        }
    };

    // Attributes of parameters are the generated part's to read: no other function than an entry point may have them.
    let attributed = joined(pieces, reached, Composed::attributed_piece);
    let module = parse(&attributed.text, Capabilities::empty());
    let module = module.map_err(|fault| vec![finding(&fault, &attributed, files.len())])?;
    Ok((module, stages))
}

/// Pieces one after another.
fn joined(pieces: &[Piece], numbers: &[usize], append: fn(&mut Composed, usize, &Piece)) -> Composed {
    let mut composed = Composed::default();
    for number in numbers {
        append(&mut composed, *number, &pieces[*number]);
        composed.generated("\n");
    }
    composed
}

/// Validates a composed module.
pub(super) fn together(
    composed: &Composed,
    capabilities: Capabilities,
    generated: usize,
) -> Result<Judged, CasterFinding> {
    check(&composed.text, capabilities).map_err(|fault| finding(&fault, composed, generated))
}

/// A fault with its places traced back.
fn finding(fault: &Fault, composed: &Composed, generated: usize) -> CasterFinding {
    let message = tidy(&fault.message);
    let remedy = match fault.notes.is_empty() {
        true => remedy(&message),
        false => fault.notes.iter().map(|note| tidy(note)).collect::<Vec<_>>().join("; "),
    };
    let mut places: Vec<_> = Vec::new();
    for (bytes, label) in &fault.labels {
        let place = composed.place(bytes.clone(), generated);
        // Spans of whole functions add nothing to a narrower one.
        let wider = |(known, _): &(CasterPlace, String)| {
            known.file == place.file
                && known.bytes.start >= place.bytes.start
                && known.bytes.end <= place.bytes.end
        };
        if !places.iter().any(wider) {
            places.push((place, label_text(label)));
        }
    }
    CasterFinding { message, remedy, places }
}

/// What to do about a fault for which naga has no advice.
fn remedy(message: &str) -> String {
    let known = [
        (
            "no definition in scope",
            "declare it in one of the files of the caster entry, or mend its spelling",
        ),
        ("unknown type", "declare it in one of the files of the caster entry, or mend its spelling"),
        ("cyclic", "WGSL has no recursion: break the ring"),
        ("expected", "mend the line: the files are plain WGSL"),
        ("conflicting", "give every binding of the engine's a number of its own"),
    ];
    let found = known.iter().find(|(part, _)| message.contains(part)).map(|(_, remedy)| *remedy);
    found.unwrap_or("mend the line so that any WebGPU device accepts it in this stage").to_owned()
}

/// A message without what names the insides of the validator, on one line.
fn tidy(message: &str) -> String {
    let line = message.split_whitespace().collect::<Vec<_>>().join(" ");
    let line = line.replace("found \"\"", "found the end of the file");
    line.trim_end_matches('.').to_owned()
}

/// A label without handles.
fn label_text(label: &str) -> String {
    let handle = label.find("[").filter(|_| label.starts_with("naga::"));
    if handle.is_some() { String::new() } else { tidy(label) }
}
