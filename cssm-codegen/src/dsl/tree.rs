//! The value tree: words with arguments, numbers with units, sizes, lists and groups, each with its place.
//!
//! The tree knows no field and no choice. Whoever writes one wrong entry still has the others read: a brace is
//! split at its commas first and every piece is read alone.

use proc_macro2::{Delimiter, Group, Spacing, Span, TokenStream, TokenTree};

use super::diagnostic::Faults;
use super::number::Literal;
use super::scan::NESTING_LIMIT;

/// A value with its place.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) span: Span,
    pub(super) kind: NodeKind,
}

/// What a value can be.
#[derive(Debug)]
pub(super) enum NodeKind {
    /// `name`, `name(..)` or `name { .. }`.
    Word(WordNode),
    /// A number, perhaps with a unit.
    Number(NumberNode),
    /// `width x height`.
    Size(NumberNode, NumberNode),
    /// `[..]`; absent entries could not be read.
    List(Vec<Option<Node>>),
    /// `{ .. }`.
    Group(Vec<Entry>),
}

/// A name with arguments.
#[derive(Debug)]
pub(super) struct WordNode {
    pub(super) name: String,
    pub(super) span: Span,
    pub(super) arguments: Vec<Entry>,
    /// Whether the arguments stand in parentheses, where the first needs no name.
    pub(super) positional: bool,
}

/// A number, perhaps with a unit.
#[derive(Debug)]
pub(super) struct NumberNode {
    /// The number's own text, sign included.
    pub(super) text: String,
    pub(super) value: f64,
    /// The value, if it is written as a whole number of at least 0.
    pub(super) whole: Option<u64>,
    pub(super) unit: Option<(String, Span)>,
    pub(super) span: Span,
}

/// `name: value`, or a value alone.
#[derive(Debug)]
pub(super) struct Entry {
    pub(super) name: Option<(String, Span)>,
    /// The value; absent if it could not be read.
    pub(super) value: Option<Node>,
    pub(super) span: Span,
}

/// The entries of a group in braces or parentheses.
pub(super) fn entries(stream: TokenStream, depth: usize, faults: &mut Faults) -> Vec<Entry> {
    let tokens = flat(stream);
    pieces(&tokens, true, faults).into_iter().map(|piece| entry(piece, depth, faults)).collect()
}

/// The tokens without the invisible groups that macros put around what they insert.
pub(super) fn flat(stream: TokenStream) -> Vec<TokenTree> {
    let mut tokens = Vec::new();
    let mut rest = vec![stream.into_iter()];
    while let Some(top) = rest.last_mut() {
        match top.next() {
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::None => {
                rest.push(group.stream().into_iter());
            }
            Some(token) => tokens.push(token),
            None => drop(rest.pop()),
        }
    }
    tokens
}

/// Splits at commas, and before `name:` where a comma is missing.
fn pieces<'a>(tokens: &'a [TokenTree], named: bool, faults: &mut Faults) -> Vec<&'a [TokenTree]> {
    let mut pieces = Vec::new();
    let mut start = 0;
    for (index, token) in tokens.iter().enumerate() {
        if is_punct(Some(token), ',') || is_punct(Some(token), ';') {
            if is_punct(Some(token), ';') {
                faults.push(token.span(), "entries are not separated by `;`", "write `,`");
            } else if start == index {
                faults.push(token.span(), "nothing stands before the comma", "delete the comma");
            }
            pieces.push(&tokens[start..index]);
            start = index + 1;
        } else if named
            && index > start
            && is_field_name(&tokens[index..])
            && !is_punct(tokens.get(index - 1), ':')
        {
            let message = format!("a comma is missing before `{token}`");
            faults.push(token.span(), message, "write `,` between entries");
            pieces.push(&tokens[start..index]);
            start = index;
        }
    }
    pieces.push(&tokens[start..]);
    pieces.retain(|piece| !piece.is_empty());
    pieces
}

/// Whether the tokens begin with `name:`.
fn is_field_name(tokens: &[TokenTree]) -> bool {
    matches!(tokens, [TokenTree::Ident(_), TokenTree::Punct(colon), ..] if colon.as_char() == ':'
        && colon.spacing() == Spacing::Alone)
}

/// Reads a piece that is not empty.
fn entry(piece: &[TokenTree], depth: usize, faults: &mut Faults) -> Entry {
    let span = joined(piece);
    let (name, value) = match piece {
        [TokenTree::Ident(name), TokenTree::Punct(sign), value @ ..]
            if matches!(sign.as_char(), ':' | '=') =>
        {
            if sign.as_char() == '=' {
                faults.push(sign.span(), format!("`{name}` is followed by `=`"), format!("write `{name}:`"));
            }
            (Some((name.to_string(), name.span())), value)
        }
        value => (None, value),
    };
    match (&name, value) {
        (Some((name, span)), []) => {
            faults.push(*span, format!("field `{name}` has no value"), "write one after the colon");
            Entry { name: Some((name.clone(), *span)), value: None, span: *span }
        }
        _ => Entry { value: node(value, depth, faults), name, span },
    }
}

/// Reads one value from tokens that are not empty.
fn node(tokens: &[TokenTree], depth: usize, faults: &mut Faults) -> Option<Node> {
    let (kind, rest) = match tokens {
        [TokenTree::Ident(name), TokenTree::Group(group), rest @ ..]
            if group.delimiter() != Delimiter::Bracket =>
        {
            let arguments = nested(group, depth, faults)?;
            let positional = group.delimiter() == Delimiter::Parenthesis;
            let word = WordNode { name: name.to_string(), span: name.span(), arguments, positional };
            (NodeKind::Word(word), rest)
        }
        [TokenTree::Ident(name), rest @ ..] => {
            let word =
                WordNode { name: name.to_string(), span: name.span(), arguments: vec![], positional: false };
            (NodeKind::Word(word), rest)
        }
        [TokenTree::Group(group), rest @ ..] => match group.delimiter() {
            Delimiter::Bracket => {
                let depth = deeper(group, depth, faults)?;
                let tokens = flat(group.stream());
                let entries = pieces(&tokens, false, faults).into_iter();
                (NodeKind::List(entries.map(|piece| node(piece, depth, faults)).collect()), rest)
            }
            Delimiter::Brace => (NodeKind::Group(nested(group, depth, faults)?), rest),
            _ => {
                let remedy = "write a name before them, or `[..]` for a list";
                faults.push(group.span(), "parentheses stand without a name", remedy);
                return None;
            }
        },
        [TokenTree::Literal(_), ..] => number_or_size(tokens, faults)?,
        [TokenTree::Punct(sign), TokenTree::Literal(_), ..] if sign.as_char() == '-' => {
            number_or_size(tokens, faults)?
        }
        [TokenTree::Punct(dot), TokenTree::Literal(digits), ..] if matches!(dot.as_char(), '.' | '+') => {
            let remedy = match dot.as_char() {
                '.' => format!("write `0.{digits}`"),
                _ => format!("write `{digits}`"),
            };
            faults.push(dot.span(), format!("a number cannot begin with `{}`", dot.as_char()), remedy);
            return None;
        }
        [other, ..] => {
            faults.push(
                other.span(),
                format!("a value cannot begin with `{other}`"),
                "write a name or a number",
            );
            return None;
        }
        [] => return None,
    };
    match rest {
        [] => Some(Node { span: joined(tokens), kind }),
        [first, ..] => {
            leftover(first, rest, &kind, faults);
            None
        }
    }
}

/// Reads `20`, `20 m`, `20m`, `2048 x 2048`, `2048x2048` and what lies between.
fn number_or_size<'a>(tokens: &'a [TokenTree], faults: &mut Faults) -> Option<(NodeKind, &'a [TokenTree])> {
    let (first, suffix, rest) = number(tokens, faults)?;

    // The height may be glued to the width, to the `x`, or stand alone.
    let (glued, behind) = match rest {
        [TokenTree::Ident(next), behind @ ..] if suffix.is_empty() => (next.to_string(), behind),
        _ => (suffix.clone(), rest),
    };
    let Some(height) = glued.strip_prefix('x').filter(|height| !height.starts_with(char::is_alphabetic))
    else {
        let (number, rest) = with_unit(first, suffix, rest);
        return Some((NodeKind::Number(number), rest));
    };
    let before = &tokens[..tokens.len() - behind.len()];
    let (height, suffix, rest) = if height.starts_with(|digit: char| digit.is_ascii_digit()) {
        let span = before.last().map_or(first.span, TokenTree::span);
        let (height, suffix) = literal(height, false, span, faults)?;
        (height, suffix, behind)
    } else if height.is_empty()
        && matches!(behind, [TokenTree::Literal(_), ..] | [TokenTree::Punct(_), TokenTree::Literal(_), ..])
    {
        number(behind, faults)?
    } else {
        faults.push(joined(before), "the size has no height", "write both sides, such as `2048 x 2048`");
        return None;
    };
    let (height, rest) = with_unit(height, suffix, rest);
    Some((NodeKind::Size(first, height), rest))
}

/// Reads a sign and a literal; the suffix stays aside.
fn number<'a>(tokens: &'a [TokenTree], faults: &mut Faults) -> Option<(NumberNode, String, &'a [TokenTree])> {
    let (negative, token, rest) = match tokens {
        [TokenTree::Punct(sign), TokenTree::Literal(token), rest @ ..] if sign.as_char() == '-' => {
            (true, token, rest)
        }
        [TokenTree::Literal(token), rest @ ..] => (false, token, rest),
        [other, ..] => {
            faults.push(other.span(), format!("`{other}` does not belong here"), "write a number");
            return None;
        }
        [] => return None,
    };
    let span = joined(&tokens[..tokens.len() - rest.len()]);
    let (number, suffix) = literal(&token.to_string(), negative, span, faults)?;
    Some((number, suffix, rest))
}

fn literal(text: &str, negative: bool, span: Span, faults: &mut Faults) -> Option<(NumberNode, String)> {
    match Literal::split(text) {
        Ok(Literal { digits, value, whole, suffix }) => {
            let number = NumberNode {
                text: if negative { format!("-{digits}") } else { digits },
                value: if negative { -value } else { value },
                whole: whole.filter(|_| !negative),
                unit: None,
                span,
            };
            Some((number, suffix))
        }
        Err((message, remedy)) => {
            faults.push(span, message, remedy);
            None
        }
    }
}

/// Takes the unit that is glued to a number or follows it.
fn with_unit(mut number: NumberNode, suffix: String, rest: &[TokenTree]) -> (NumberNode, &[TokenTree]) {
    match rest {
        _ if !suffix.is_empty() => {
            number.unit = Some((suffix, number.span));
            (number, rest)
        }
        [TokenTree::Ident(unit), rest @ ..] => {
            number.unit = Some((unit.to_string(), unit.span()));
            number.span = number.span.join(unit.span()).unwrap_or(number.span);
            (number, rest)
        }
        _ => (number, rest),
    }
}

/// Reports what follows a complete value.
fn leftover(first: &TokenTree, rest: &[TokenTree], kind: &NodeKind, faults: &mut Faults) {
    let message = format!("`{}` does not belong here", shown(first));
    let remedy = match (kind, rest) {
        (NodeKind::Word(word), [TokenTree::Punct(dash), TokenTree::Ident(next), ..])
            if dash.as_char() == '-' =>
        {
            format!("join the parts of a name by `_`: `{}_{next}`", word.name)
        }
        (NodeKind::Number(width), [TokenTree::Punct(star), TokenTree::Literal(height), ..])
            if star.as_char() == '*' =>
        {
            format!("write a size as `{} x {height}`", width.text)
        }
        (_, [TokenTree::Punct(_), ..]) => "leave it out".into(),
        _ => "write `,` before it, or leave it out".into(),
    };
    faults.push(first.span(), message, remedy);
}

fn nested(group: &Group, depth: usize, faults: &mut Faults) -> Option<Vec<Entry>> {
    let depth = deeper(group, depth, faults)?;
    Some(entries(group.stream(), depth, faults))
}

fn deeper(group: &Group, depth: usize, faults: &mut Faults) -> Option<usize> {
    if depth >= NESTING_LIMIT {
        let message = format!("brackets are nested more than {NESTING_LIMIT} deep");
        faults.push(group.span_open(), message, "remove the outer or inner ones");
        return None;
    }
    Some(depth + 1)
}

fn is_punct(token: Option<&TokenTree>, letter: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == letter)
}

/// A token as a report names it; groups by their opening bracket only.
pub(super) fn shown(token: &TokenTree) -> String {
    match token {
        TokenTree::Group(group) => match group.delimiter() {
            Delimiter::Parenthesis => "(".into(),
            Delimiter::Bracket => "[".into(),
            _ => "{".into(),
        },
        other => other.to_string(),
    }
}

/// The place from the first to the last token.
pub(super) fn joined(tokens: &[TokenTree]) -> Span {
    match tokens {
        [] => Span::call_site(),
        [only] => only.span(),
        [first, .., last] => first.span().join(last.span()).unwrap_or_else(|| first.span()),
    }
}
