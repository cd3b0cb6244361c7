//! Just enough of WGSL's lexical structure to take text apart and put it together unchanged.
//!
//! A source is split into its module-scope declarations: each ends at `;` or `}` at depth zero and owns the comments
//! and attributes right above it. A comment block that a blank line separates from what follows belongs to the file
//! and is left behind.

/// What a run of characters is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TokenKind {
    /// Identifier or keyword.
    Word,
    /// Number, suffix included.
    Number,
    /// Line or block comment.
    Comment,
    /// White space.
    Space,
    /// A single other character.
    Mark,
}

/// A run of characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Token<'a> {
    /// What it is.
    pub(crate) kind: TokenKind,
    /// Its characters.
    pub(crate) text: &'a str,
}

/// Kinds of module-scope declarations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum DeclarationKind {
    /// `fn`
    Function,
    /// `struct` or `alias`
    Type,
    /// `const` or `override`
    Constant,
    /// `var`
    Variable,
}

/// A module-scope declaration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Declaration<'a> {
    /// What it declares.
    pub(crate) kind: DeclarationKind,
    /// Declared name.
    pub(crate) name: &'a str,
    /// Its text, comments and attributes included, from the first character to the last.
    pub(crate) text: &'a str,
}

/// Splits text into tokens; together they are the text.
pub(crate) fn tokens(text: &str) -> impl Iterator<Item = Token<'_>> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let run = |accept: fn(char) -> bool| rest.find(|letter| !accept(letter)).unwrap_or(rest.len());
        let (kind, length) = if first.is_whitespace() {
            (TokenKind::Space, run(char::is_whitespace))
        } else if first.is_alphabetic() || first == '_' {
            (TokenKind::Word, run(|letter| letter.is_alphanumeric() || letter == '_'))
        } else if first.is_ascii_digit() {
            (TokenKind::Number, run(|letter| letter.is_ascii_alphanumeric() || letter == '.'))
        } else if rest.starts_with("//") {
            (TokenKind::Comment, rest.find('\n').unwrap_or(rest.len()))
        } else if rest.starts_with("/*") {
            (TokenKind::Comment, block_comment(rest))
        } else {
            (TokenKind::Mark, first.len_utf8())
        };
        let (text, after) = rest.split_at(length);
        rest = after;
        Some(Token { kind, text })
    })
}

/// Bytes of the block comment that a text begins with; block comments nest.
fn block_comment(text: &str) -> usize {
    let mut depth = 0_u32;
    let mut at = 0;
    while let Some(mark) = text[at..].find(['/', '*']).map(|found| at + found) {
        at = mark + 1;
        if text[mark..].starts_with("/*") {
            depth += 1;
            at += 1;
        } else if text[mark..].starts_with("*/") {
            depth -= 1;
            at += 1;
        }
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

/// Splits a source into its module-scope declarations, in order.
pub(crate) fn declarations(source: &str) -> Vec<Declaration<'_>> {
    statements(source).into_iter().filter_map(declaration).collect()
}

/// Splits a source into what stands at module scope, in order: declarations, directives, assertions, lone semicolons,
/// and at the end whatever is not finished.
pub(crate) fn statements(source: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut depth = 0_i32;
    let mut start = 0;
    let mut at = 0;
    let mut only_comments = true;
    for token in tokens(source) {
        let end = at + token.text.len();
        match (token.kind, token.text) {
            // A blank line cuts comments off from what follows.
            (TokenKind::Space, space) => {
                if only_comments && (start == at || space.matches('\n').count() > 1) {
                    start = end;
                }
            }
            (TokenKind::Comment, _) => {}
            (_, text) => {
                only_comments = false;
                match text {
                    "{" | "(" | "[" => depth += 1,
                    "}" | ")" | "]" => depth -= 1,
                    _ => {}
                }
                if depth == 0 && matches!(text, ";" | "}") {
                    found.push(&source[start..end]);
                    start = end;
                    only_comments = true;
                }
            }
        }
        at = end;
    }
    if !only_comments {
        found.push(&source[start..]);
    }
    found
}

/// Words of a text that may name declarations: not members, not within comments.
pub(crate) fn references(text: &str) -> impl Iterator<Item = &str> {
    let mut after_dot = false;
    tokens(text).filter_map(move |token| {
        let is_member = after_dot;
        if !matches!(token.kind, TokenKind::Space | TokenKind::Comment) {
            after_dot = token.text == ".";
        }
        (token.kind == TokenKind::Word && !is_member).then_some(token.text)
    })
}

/// Reads what a declaration declares; a lone `;` declares nothing.
pub(crate) fn declaration(text: &str) -> Option<Declaration<'_>> {
    let mut depth = 0_i32;
    let mut kind = None;
    for token in tokens(text) {
        match (token.kind, token.text) {
            // Attributes and address spaces have arguments of their own.
            (TokenKind::Mark, "(" | "<") => depth += 1,
            (TokenKind::Mark, ")" | ">") => depth -= 1,
            (TokenKind::Word, word) if depth == 0 => match (kind, word) {
                (Some(kind), name) => return Some(Declaration { kind, name, text }),
                (None, "fn") => kind = Some(DeclarationKind::Function),
                (None, "struct" | "alias") => kind = Some(DeclarationKind::Type),
                (None, "const" | "override") => kind = Some(DeclarationKind::Constant),
                (None, "var") => kind = Some(DeclarationKind::Variable),
                (None, _) => {}
            },
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "// About the file.\n\n/// Doc.\nconst A: f32 = 1.0;\n\nstruct B { a: f32 }\n\
        @group(0) @binding(1)\nvar<uniform> c: B;\n\n/// Two\n/// lines.\n@vertex\nfn d(e: vec4<f32>) -> f32 {\n    \
        // A comment with } and ;\n    return c.a + A;\n}\n";

    #[test]
    fn tokens_are_the_text() {
        let joined: String = tokens(SOURCE).map(|token| token.text).collect();
        assert_eq!(joined, SOURCE);
    }

    #[test]
    fn declarations_own_their_comments_and_attributes() {
        let found = declarations(SOURCE);
        let names: Vec<_> = found.iter().map(|found| (found.kind, found.name)).collect();
        use DeclarationKind::{Constant, Function, Type, Variable};
        assert_eq!(names, [(Constant, "A"), (Type, "B"), (Variable, "c"), (Function, "d")]);
        assert_eq!(found[0].text, "/// Doc.\nconst A: f32 = 1.0;");
        assert!(found[2].text.starts_with("@group(0)"));
        assert!(found[3].text.starts_with("/// Two\n/// lines.\n@vertex") && found[3].text.ends_with('}'));
    }

    #[test]
    fn block_comments_nest_and_names_may_hold_any_letter() {
        let found = declarations("/* a /* b */ fn no() {} */ fn gr\u{f6}\u{df}e() {} fn unfinished() { /* ");
        let names: Vec<_> = found.iter().map(|found| found.name).collect();
        assert_eq!(names, ["gr\u{f6}\u{df}e", "unfinished"]);
    }

    #[test]
    fn members_and_comments_are_no_references() {
        let words: Vec<_> = references("a.b + c /* d */ . e // f").collect();
        assert_eq!(words, ["a", "c"]);
    }
}
