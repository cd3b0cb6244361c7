//! The frame of a case: doc comment, visibility, name, body.

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use syn::parse::Parser;
use syn::{Attribute, Expr, ExprLit, Lit, Meta};

use super::diagnostic::Faults;
use super::tree::{self, Entry};

/// A case as written.
#[derive(Debug)]
pub(super) struct Item {
    pub(super) name: String,
    pub(super) name_span: Span,
    pub(super) doc: String,
    pub(super) public: bool,
    pub(super) entries: Vec<Entry>,
}

const SHAPE: &str = "write `case Name { field: value, .. }`";

/// Reads every case of a stream; what is no case is reported and passed over up to the next body.
pub(super) fn items(stream: TokenStream, faults: &mut Faults) -> Vec<Item> {
    let tokens = tree::flat(stream);
    let mut rest = tokens.as_slice();
    let mut items = Vec::new();
    while !rest.is_empty() {
        let (item, behind) = item(rest, faults);
        rest = behind;
        items.extend(item);
    }
    if items.is_empty() && faults.0.is_empty() {
        faults.push(Span::call_site(), "no case is declared", SHAPE);
    }
    items
}

/// Reads one case from tokens that are not empty, and returns those behind it.
fn item<'a>(tokens: &'a [TokenTree], faults: &mut Faults) -> (Option<Item>, &'a [TokenTree]) {
    // Take the attributes: each is `#` and a bracket, `#!` if it documents the file.
    let mut rest = tokens;
    let mut doc = Vec::new();
    loop {
        match rest {
            [TokenTree::Punct(hash), TokenTree::Punct(bang), TokenTree::Group(group), behind @ ..]
                if hash.as_char() == '#' && bang.as_char() == '!' =>
            {
                if doc_text(&[rest[0].clone(), group.clone().into()]).is_none() {
                    faults.push(group.span(), "a file takes no attribute", "leave it out");
                }
                rest = behind;
            }
            [TokenTree::Punct(hash), TokenTree::Group(group), behind @ ..] if hash.as_char() == '#' => {
                match doc_text(&rest[..2]) {
                    Some(text) => doc.push(text),
                    None => faults.push(
                        group.span(),
                        "a case takes no attribute",
                        "leave it out; only doc comments may stand here",
                    ),
                }
                rest = behind;
            }
            _ => break,
        }
    }
    if rest.is_empty() {
        if let (false, Some(first)) = (doc.is_empty(), tokens.first()) {
            faults.push(
                first.span(),
                "the doc comment documents nothing",
                "put it before a case, or use `//`",
            );
        }
        return (None, rest);
    }

    // Take the visibility.
    let public = matches!(rest, [TokenTree::Ident(word), ..] if *word == "pub");
    if public {
        rest = &rest[1..];
    }
    if let (true, [TokenTree::Group(group), behind @ ..]) = (public, rest)
        && group.delimiter() == Delimiter::Parenthesis
    {
        faults.push(group.span(), "a case is `pub` or private", "write `pub case`, or leave `pub` out");
        rest = behind;
    }

    // Take the word, the name and the body.
    match rest {
        [TokenTree::Ident(word), TokenTree::Ident(name), TokenTree::Group(body), behind @ ..]
            if *word == "case" && body.delimiter() == Delimiter::Brace =>
        {
            let entries = tree::entries(body.stream(), 1, faults);
            let doc = doc.join("\n");
            let item = Item { name: name.to_string(), name_span: name.span(), doc, public, entries };
            (Some(item), behind)
        }
        _ => {
            misshapen(rest, tokens, faults);
            let body = rest.iter().position(is_body).map_or(rest.len(), |index| index + 1);
            (None, &rest[body..])
        }
    }
}

/// Says what is wrong with a case's frame.
fn misshapen(rest: &[TokenTree], tokens: &[TokenTree], faults: &mut Faults) {
    match rest {
        [TokenTree::Ident(word), TokenTree::Group(body), ..] if *word == "case" && is_body_group(body) => {
            faults.push(
                word.span(),
                "the case has no name",
                "write one in upper camel case: `case Sun { .. }`",
            );
        }
        [TokenTree::Ident(word), TokenTree::Ident(name), ..] if *word == "case" => {
            let remedy = format!("write its fields in braces: `case {name} {{ .. }}`");
            faults.push(name.span(), format!("case `{name}` has no body"), remedy);
        }
        [TokenTree::Ident(word), TokenTree::Ident(name), TokenTree::Group(body), ..]
            if is_body_group(body) =>
        {
            faults.push(
                word.span(),
                format!("`{word}` does not start a case"),
                format!("write `case {name} {{ .. }}`"),
            );
        }
        [TokenTree::Ident(name), TokenTree::Group(body), ..] if is_body_group(body) && *name != "case" => {
            faults.push(
                name.span(),
                format!("`{name}` does not start a case"),
                format!("write `case {name} {{ .. }}`"),
            );
        }
        [TokenTree::Ident(word), next, ..] if *word == "case" => {
            faults.push(next.span(), format!("`{}` is no case name", tree::shown(next)), SHAPE);
        }
        [first, ..] => {
            faults.push(first.span(), format!("`{}` does not start a case", tree::shown(first)), SHAPE);
        }
        [] => {
            let last = tokens.last().map_or_else(Span::call_site, TokenTree::span);
            faults.push(last, "a case is missing here", SHAPE);
        }
    }
}

/// The text of a doc comment; `None` for any other attribute.
fn doc_text(attribute: &[TokenTree]) -> Option<String> {
    let stream: TokenStream = attribute.iter().cloned().collect();
    let attributes = Attribute::parse_outer.parse2(stream).ok()?;
    let [Attribute { meta: Meta::NameValue(pair), .. }] = attributes.as_slice() else {
        return None;
    };
    let Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) = &pair.value else {
        return None;
    };
    if !pair.path.is_ident("doc") {
        return None;
    }
    let text = text.value();
    let line = |line: &str| line.strip_prefix(' ').unwrap_or(line).to_owned();
    if !text.contains('\n') {
        return Some(line(&text));
    }

    // A block comment: take the customary stars off.
    let lines = text.lines().map(|text| line(text.trim_start().trim_start_matches('*')));
    Some(lines.collect::<Vec<_>>().join("\n"))
}

fn is_body(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if is_body_group(group))
}

fn is_body_group(group: &proc_macro2::Group) -> bool {
    group.delimiter() == Delimiter::Brace
}
