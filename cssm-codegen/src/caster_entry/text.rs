//! A text of engine pieces and generated parts that knows where each byte comes from.

use std::ops::Range;

use super::pieces::{Head, Piece, head};
use super::report::CasterPlace;

/// A composed text.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Composed {
    pub(super) text: String,
    /// Bytes of the text that come from the engine, in order, each with its piece's number, file and first byte there.
    engine: Vec<(Range<usize>, usize, usize, usize)>,
}

impl Composed {
    /// Appends generated text.
    pub(super) fn generated(&mut self, text: &str) {
        self.text.push_str(text);
    }

    /// Appends a piece as it was written, but for the attributes of a function's parameters, which only entry points may
    /// have.
    pub(super) fn piece(&mut self, number: usize, piece: &Piece) {
        let mut at = 0;
        for attributes in head(piece.text).iter().flat_map(attributes) {
            self.part(number, piece, at..attributes.start);
            at = attributes.end;
        }
        self.part(number, piece, at..piece.text.len());
    }

    /// Appends a piece as it was written.
    pub(super) fn attributed_piece(&mut self, number: usize, piece: &Piece) {
        self.part(number, piece, 0..piece.text.len());
    }

    fn part(&mut self, number: usize, piece: &Piece, bytes: Range<usize>) {
        let start = self.text.len();
        self.text.push_str(&piece.text[bytes.clone()]);
        self.engine.push((start..self.text.len(), number, piece.file, piece.start + bytes.start));
    }

    /// Where bytes of the text come from; `generated` is the number of the text itself among the report's files.
    pub(super) fn place(&self, bytes: Range<usize>, generated: usize) -> CasterPlace {
        match self.engine_part(bytes.start) {
            None => CasterPlace { file: generated, bytes },
            Some((part, _, file, first)) => {
                let inside = |byte: usize| first + byte.min(part.end) - part.start;
                CasterPlace { file: *file, bytes: inside(bytes.start)..inside(bytes.end.max(bytes.start)) }
            }
        }
    }

    /// Number of the piece that a byte of the text comes from.
    pub(super) fn piece_at(&self, byte: usize) -> Option<usize> {
        self.engine_part(byte).map(|(_, number, _, _)| *number)
    }

    fn engine_part(&self, byte: usize) -> Option<&(Range<usize>, usize, usize, usize)> {
        // A fault behind the end of a part, where nothing else stands, belongs to it.
        let holds = |part: &&(Range<usize>, usize, usize, usize)| part.0.contains(&byte);
        let before = |part: &&(Range<usize>, usize, usize, usize)| {
            let between = self.text.get(part.0.end..byte.min(self.text.len()));
            part.0.end <= byte && between.is_some_and(|between| between.trim().is_empty())
        };
        let parts = &self.engine;
        parts.iter().find(holds).or_else(|| parts.iter().rev().find(before))
    }
}

/// Attributes of a function's parameters, with the space behind them.
fn attributes(head: &Head) -> impl Iterator<Item = Range<usize>> {
    head.parameters
        .iter()
        .filter(|parameter| !parameter.attributes.is_empty())
        .map(|parameter| parameter.attributes.start..parameter.name.start)
}
