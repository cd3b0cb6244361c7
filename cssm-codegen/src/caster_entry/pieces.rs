//! The engine's files in pieces: declarations with their places, those that a caster entry reaches, and the lists inside
//! them.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::report::{CasterFinding, CasterPlace};
use crate::wgsl::{self, Declaration, DeclarationKind, TokenKind};

/// A file of the engine's.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct EngineFile {
    pub(super) name: String,
    pub(super) text: String,
}

/// Something that stands at module scope in one of the engine's files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Piece<'a> {
    pub(super) file: usize,
    /// First byte in the file.
    pub(super) start: usize,
    pub(super) text: &'a str,
    /// `None`: an assertion, or something that is no WGSL.
    pub(super) declaration: Option<Declaration<'a>>,
}

impl Piece<'_> {
    /// The place of bytes of the piece.
    pub(super) fn place(&self, bytes: Range<usize>) -> CasterPlace {
        CasterPlace { file: self.file, bytes: self.start + bytes.start..self.start + bytes.end }
    }

    /// The place of the declared name.
    pub(super) fn name_place(&self) -> CasterPlace {
        let name = self.declaration.as_ref().map_or("", |declaration| declaration.name);
        let found = words(self.text).find(|(_, word)| *word == name);
        self.place(found.map_or(0..self.text.len(), |(bytes, _)| bytes))
    }

    pub(super) fn name(&self) -> &str {
        self.declaration.as_ref().map_or("", |declaration| declaration.name)
    }

    fn is_assertion(&self) -> bool {
        words(self.text).next().is_some_and(|(_, word)| word == "const_assert")
    }
}

/// Splits the engine's files, and finds what cannot stand in them: a preprocessor's lines, directives, names declared
/// twice.
pub(super) fn split(files: &[EngineFile]) -> (Vec<Piece<'_>>, Vec<CasterFinding>) {
    let mut pieces: Vec<Piece> = Vec::new();
    let mut findings = Vec::new();
    for (file, EngineFile { text, .. }) in files.iter().enumerate() {
        findings.extend(preprocessor_lines(file, text));
        let mut at = 0;
        for statement in wgsl::statements(text) {
            // Statements stand in order, apart from comments between them.
            let start = at + text[at..].find(statement).unwrap_or(0);
            at = start + statement.len();
            let declaration = wgsl::declaration(statement);
            let piece = Piece { file, start, text: statement, declaration };
            match words(statement).next() {
                Some((bytes, word @ ("enable" | "requires" | "diagnostic"))) => {
                    let message = format!("directive `{word}` stands in a caster's source");
                    let remedy = "leave it out: capture shaders need no more than WebGPU's core";
                    findings.push(CasterFinding::at(piece.place(bytes), message, remedy));
                }
                None if marks(statement).iter().all(|(_, mark)| *mark == ";") => {}
                _ => pieces.push(piece),
            }
        }
    }
    findings.extend(duplicates(&pieces));
    (pieces, findings)
}

/// Lines that a preprocessor would have replaced.
fn preprocessor_lines(file: usize, text: &str) -> Vec<CasterFinding> {
    let mut findings = Vec::new();
    let mut at = 0;
    let mut first_of_line = true;
    for token in wgsl::tokens(text) {
        if token.text == "#" && first_of_line {
            let line = text[at..].lines().next().unwrap_or("").trim_end();
            let word: String = line.chars().skip(1).take_while(|letter| letter.is_alphanumeric()).collect();
            findings.push(CasterFinding::at(
                CasterPlace { file, bytes: at..at + line.len() },
                format!("`#{word}` is a preprocessor's line, not WGSL"),
                "give the text that your preprocessor makes of the file, or add each file by itself",
            ));
        }
        let blank = matches!(token.kind, TokenKind::Space | TokenKind::Comment);
        first_of_line = token.text.contains('\n') || first_of_line && blank;
        at += token.text.len();
    }
    findings
}

fn duplicates(pieces: &[Piece]) -> Vec<CasterFinding> {
    let mut first: BTreeMap<&str, &Piece> = BTreeMap::new();
    let mut findings = Vec::new();
    for piece in pieces.iter().filter(|piece| piece.declaration.is_some()) {
        match first.get(piece.name()) {
            None => {
                first.insert(piece.name(), piece);
            }
            Some(earlier) => findings.push(
                CasterFinding::at(
                    piece.name_place(),
                    format!("`{}` is declared twice", piece.name()),
                    "keep one of them, or give each file once",
                )
                .labelled("declared again here")
                .and(earlier.name_place(), "declared here first"),
            ),
        }
    }
    findings
}

/// Numbers of the pieces that functions reach, in order; assertions about them and what is no WGSL go along.
pub(super) fn reach(pieces: &[Piece], roots: &[&str]) -> Vec<usize> {
    let by_name: BTreeMap<&str, usize> = pieces
        .iter()
        .enumerate()
        .filter(|(_, piece)| piece.declaration.is_some())
        .map(|(number, piece)| (piece.name(), number))
        .collect();
    let mut reached = BTreeSet::new();
    let mut open: Vec<usize> = roots.iter().filter_map(|root| by_name.get(root).copied()).collect();
    while let Some(number) = open.pop() {
        if reached.insert(number) {
            open.extend(wgsl::references(pieces[number].text).filter_map(|word| by_name.get(word).copied()));
        }
    }
    for (number, piece) in pieces.iter().enumerate().filter(|(_, piece)| piece.declaration.is_none()) {
        let is_reached = |word: &str| by_name.get(word).is_none_or(|named| reached.contains(named));
        if !piece.is_assertion() || wgsl::references(piece.text).all(is_reached) {
            reached.insert(number);
        }
    }
    reached.into_iter().collect()
}

/// The function of a name.
pub(super) fn function<'p, 'a>(pieces: &'p [Piece<'a>], name: &str) -> Option<&'p Piece<'a>> {
    let is_function =
        |declaration: &Declaration| declaration.kind == DeclarationKind::Function && declaration.name == name;
    pieces.iter().find(|piece| piece.declaration.as_ref().is_some_and(is_function))
}

/// A parameter of a function or a member of a struct, by bytes of its piece.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Item {
    /// From the first attribute to the end of the type.
    pub(super) whole: Range<usize>,
    /// All attributes; empty where there are none.
    pub(super) attributes: Range<usize>,
    pub(super) name: Range<usize>,
}

/// The head of a function, by bytes of its piece.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Head {
    pub(super) parameters: Vec<Item>,
    /// What stands behind the arrow.
    pub(super) result: Option<Range<usize>>,
}

/// Reads the head of a function; `None` where it is none.
pub(super) fn head(text: &str) -> Option<Head> {
    let marks = marks(text);
    let start = marks.iter().position(|(_, word)| *word == "fn")?;
    let (parameters, after) = items(&marks, start + 2);
    let body = marks[after..].iter().position(|(_, word)| *word == "{").map(|found| after + found)?;
    let result = marks.get(after + 2).filter(|_| body > after + 2);
    let result = result.map(|(first, _)| first.start..marks[body - 1].0.end);
    Some(Head { parameters, result })
}

/// Reads the members of a struct.
pub(super) fn members(text: &str) -> Vec<Item> {
    let marks = marks(text);
    let open = marks.iter().position(|(_, word)| *word == "{");
    open.map(|open| items(&marks, open).0).unwrap_or_default()
}

/// Items between the bracket at `open` and the one that closes it, and the position behind that.
fn items(marks: &[(Range<usize>, &str)], open: usize) -> (Vec<Item>, usize) {
    let mut items = Vec::new();
    let mut depth = 0_i32;
    let mut first = open + 1;
    for (at, (_, word)) in marks.iter().enumerate().skip(open) {
        match *word {
            "(" | "[" | "<" | "{" => depth += 1,
            ")" | "]" | ">" | "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 || depth == 1 && *word == "," {
            items.extend(item(&marks[first..at]));
            first = at + 1;
        }
        if depth == 0 {
            return (items, at + 1);
        }
    }
    (items, marks.len())
}

/// Reads `@attribute(..) name: type`.
fn item(marks: &[(Range<usize>, &str)]) -> Option<Item> {
    let (whole_start, whole_end) = (marks.first()?.0.start, marks.last()?.0.end);
    let mut at = 0;
    while marks.get(at).is_some_and(|(_, word)| *word == "@") {
        at += 2;
        if marks.get(at).is_some_and(|(_, word)| *word == "(") {
            at += marks[at..].iter().position(|(_, word)| *word == ")")? + 1;
        }
    }
    let name = marks.get(at)?.0.clone();
    let attributes = whole_start..at.checked_sub(1).map_or(whole_start, |last| marks[last].0.end);
    Some(Item { whole: whole_start..whole_end, attributes, name })
}

/// Tokens that mean something, with their bytes.
fn marks(text: &str) -> Vec<(Range<usize>, &str)> {
    let mut at = 0;
    let mut marks = Vec::new();
    for token in wgsl::tokens(text) {
        let end = at + token.text.len();
        if !matches!(token.kind, TokenKind::Space | TokenKind::Comment) {
            marks.push((at..end, token.text));
        }
        at = end;
    }
    marks
}

/// Words of a text with their bytes, comments apart.
pub(super) fn words(text: &str) -> impl Iterator<Item = (Range<usize>, &str)> {
    let mut at = 0;
    wgsl::tokens(text).filter_map(move |token| {
        let bytes = at..at + token.text.len();
        at = bytes.end;
        (token.kind == TokenKind::Word).then_some((bytes, token.text))
    })
}
