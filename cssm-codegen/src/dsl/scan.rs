//! Faults that must be found before lexing: the lexer stops at its first one and gives it no place.
//!
//! The scan follows the lexer's idea of comments and quoted text, and looks at everything else letter by letter.

use super::report::Finding;

/// Deepest nesting of brackets; a declaration needs five levels.
pub(super) const NESTING_LIMIT: usize = 16;

/// Most faults that are reported: a text with more of them is no declaration.
const FAULT_LIMIT: usize = 20;

/// The faults of the text's letters and delimiters; none means that the text can be lexed, odd corners aside.
pub(super) fn scan(text: &str) -> Vec<Finding> {
    let mut scan = Scan { text, open: Vec::new(), suspect: None, findings: Vec::new() };
    let mut at = 0;
    while let Some(letter) = text.get(at..).and_then(|rest| rest.chars().next()) {
        at = scan.step(at, letter);
        if scan.findings.len() >= FAULT_LIMIT {
            return scan.findings;
        }
    }
    scan.blame_open();
    scan.findings
}

struct Scan<'a> {
    text: &'a str,
    /// Brackets that are open, outermost first.
    open: Vec<(usize, char)>,
    /// The first bracket whose partner is indented unlike it, and that partner.
    suspect: Option<(usize, usize)>,
    findings: Vec<Finding>,
}

impl Scan<'_> {
    /// Looks at the letter at a byte and returns the byte to go on from.
    fn step(&mut self, at: usize, letter: char) -> usize {
        let next = at + letter.len_utf8();
        let rest = &self.text[at..];
        match letter {
            '/' if rest.starts_with("//") => at + rest.find('\n').unwrap_or(rest.len()),
            '/' if rest.starts_with("/*") => self.block_comment(at),
            '"' => self.quoted(at),
            '\'' | '`' | '\\' => {
                let message = format!("`{letter}` does not belong in a declaration");
                self.findings.push(finding(message, "write names and numbers without quotes", at, 1));
                next
            }
            '(' | '[' | '{' => {
                self.open.push((at, letter));
                if self.open.len() == NESTING_LIMIT + 1 {
                    let message = format!("brackets are nested more than {NESTING_LIMIT} deep");
                    self.findings.push(finding(message, "remove the outer or inner ones", at, 1));
                }
                next
            }
            ')' | ']' | '}' => {
                self.close(at, letter);
                next
            }
            _ if !(letter.is_ascii() || (at == 0 && letter == '\u{feff}')) => {
                let (message, remedy) = foreign(letter);
                self.findings.push(finding(message, remedy, at, letter.len_utf8()));
                next
            }
            _ if letter.is_ascii_control() && !letter.is_ascii_whitespace() => {
                let message =
                    format!("control character U+{:04X} does not belong in a declaration", u32::from(letter));
                self.findings.push(finding(message, "delete it", at, 1));
                next
            }
            _ => next,
        }
    }

    /// Skips a block comment with those it holds.
    fn block_comment(&mut self, start: usize) -> usize {
        let mut depth = 0_usize;
        let mut at = start;
        while let Some(rest) = self.text.get(at..).filter(|rest| !rest.is_empty()) {
            if rest.starts_with("/*") {
                depth += 1;
                at += 2;
            } else if rest.starts_with("*/") {
                depth -= 1;
                at += 2;
                if depth == 0 {
                    return at;
                }
            } else {
                at += rest.chars().next().map_or(1, char::len_utf8);
            }
        }
        self.findings.push(finding("the comment is never closed", "write `*/` where it ends", start, 2));
        // What the comment swallowed is not missing.
        self.open.clear();
        self.text.len()
    }

    /// Skips quoted text; the grammar has no use for it, but the parser says so with the field's name.
    fn quoted(&mut self, start: usize) -> usize {
        let mut escaped = false;
        for (offset, letter) in self.text[start + 1..].char_indices() {
            match letter {
                '"' if !escaped => return start + 1 + offset + 1,
                '\n' => break,
                _ => escaped = letter == '\\' && !escaped,
            }
        }
        let remedy = "write names and numbers without quotes";
        self.findings.push(finding("the quoted text is never closed", remedy, start, 1));
        let rest = &self.text[start..];
        start + rest.find('\n').unwrap_or(rest.len())
    }

    fn close(&mut self, at: usize, letter: char) {
        match self.open.last().copied() {
            Some((open_at, open)) if closing(open) == letter => {
                self.open.pop();
                let (one, two) = (self.line(open_at), self.line(at));
                if one != two && indent(one) != indent(two) {
                    self.suspect.get_or_insert((open_at, at));
                }
            }
            // Take a bracket that closes an outer one as that, and report those in between as never closed.
            Some((open_at, open)) => {
                let mut found = finding(
                    format!("`{letter}` does not close `{open}`"),
                    format!("write `{}`", closing(open)),
                    at,
                    1,
                );
                found.secondary = Some((open_at..open_at + 1, format!("`{open}` is open here")));
                self.findings.push(found);
                match self.open.iter().rposition(|&(_, open)| closing(open) == letter) {
                    Some(outer) => self.open.truncate(outer),
                    None => drop(self.open.pop()),
                }
            }
            None => {
                let message = format!("`{letter}` closes nothing");
                self.findings.push(finding(message, "delete it, or open its partner before", at, 1));
            }
        }
    }

    /// Reports what is open at the end of the text. A bracket whose partner is indented unlike it has most likely
    /// taken the partner of the one that is left over.
    fn blame_open(&mut self) {
        if let (Some((open, close)), [_, ..]) = (self.suspect, self.open.as_slice()) {
            let letter = self.text[open..].chars().next().unwrap_or('{');
            let mut found = never_closed(open, letter);
            let label = format!("this `{}` stands for another one, by its indent", closing(letter));
            found.secondary = Some((close..close + 1, label));
            self.findings.push(found);
            return;
        }
        let open = self.open.iter().take(FAULT_LIMIT);
        self.findings.extend(open.map(|&(open, letter)| never_closed(open, letter)));
    }

    /// The line that holds a byte.
    fn line(&self, at: usize) -> &str {
        let start = self.text[..at].rfind('\n').map_or(0, |newline| newline + 1);
        self.text[start..].lines().next().unwrap_or("")
    }
}

fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

fn never_closed(open: usize, letter: char) -> Finding {
    let message = format!("`{letter}` is never closed");
    finding(message, format!("write `{}` where it ends", closing(letter)), open, 1)
}

fn closing(open: char) -> char {
    match open {
        '(' => ')',
        '[' => ']',
        _ => '}',
    }
}

/// Message and remedy for a letter outside ASCII; those that word processors slip in have their own remedy.
fn foreign(letter: char) -> (String, String) {
    let remedy = match letter {
        '\u{d7}' | '\u{2715}' => "write the letter `x`: `2048 x 2048`",
        '\u{2212}' | '\u{2010}'..='\u{2015}' => "write `-` or `_`",
        '\u{2018}'..='\u{201f}' => "write names and numbers without quotes",
        '\u{a0}' | '\u{2000}'..='\u{200b}' | '\u{202f}' | '\u{3000}' | '\u{feff}' => {
            "write an ordinary space"
        }
        _ => "use ASCII letters; only comments may hold others",
    };
    let shown =
        if letter.is_whitespace() || letter.is_control() || ('\u{200b}'..='\u{200f}').contains(&letter) {
            String::new()
        } else {
            format!("`{letter}` ")
        };
    (format!("{shown}(U+{:04X}) does not belong in a declaration", u32::from(letter)), remedy.into())
}

fn finding(message: impl Into<String>, remedy: impl Into<String>, start: usize, length: usize) -> Finding {
    Finding { message: message.into(), remedy: remedy.into(), bytes: start..start + length, secondary: None }
}
