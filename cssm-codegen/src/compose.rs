//! Puts a module together: whole declarations of the library, picked by reach, renamed by prefix, never reprinted.

use std::collections::{BTreeMap, BTreeSet};

use crate::wgsl::{self, Declaration, DeclarationKind, TokenKind};

/// Module-scope names of one case: `sun_visibility`, `SunFacet`, `SUN_MAP_SIZE`.
#[derive(Debug, Clone)]
pub(crate) struct Prefix {
    value: String,
    ty: String,
    constant: String,
}

impl Prefix {
    /// Names of a lower snake case prefix.
    pub(crate) fn new(prefix: &str) -> Self {
        let mut ty = String::new();
        for part in prefix.split('_') {
            let mut letters = part.chars();
            ty.extend(letters.next().map(|first| first.to_ascii_uppercase()));
            ty.push_str(letters.as_str());
        }
        Self { value: format!("{prefix}_"), ty, constant: format!("{}_", prefix.to_ascii_uppercase()) }
    }

    /// The emitted name of a declaration of the library.
    pub(crate) fn apply(&self, kind: DeclarationKind, name: &str) -> String {
        let prefix = match kind {
            DeclarationKind::Function | DeclarationKind::Variable => &self.value,
            DeclarationKind::Type => &self.ty,
            DeclarationKind::Constant => &self.constant,
        };
        format!("{prefix}{name}")
    }

    /// The library's name of a prefixed variable.
    pub(crate) fn strip<'a>(&self, name: &'a str) -> &'a str {
        name.strip_prefix(&self.value).unwrap_or(name)
    }
}

/// A library that cannot be composed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ComposeError {
    /// Two picked files declare the same name.
    #[error("`{name}` is declared twice")]
    Duplicate {
        /// The name.
        name: String,
    },
    /// No picked file declares a root.
    #[error("`{name}` is not declared")]
    Missing {
        /// The name.
        name: String,
    },
}

/// Composes what `roots` reach in `sources`, in the order of the sources, under a prefix.
pub(crate) fn compose(sources: &[&str], roots: &[&str], prefix: &Prefix) -> Result<String, ComposeError> {
    let declarations: Vec<_> = sources.iter().flat_map(|source| wgsl::declarations(source)).collect();

    // Give every declaration its emitted name.
    let mut names = BTreeMap::new();
    for declaration in &declarations {
        let emitted = prefix.apply(declaration.kind, declaration.name);
        if names.insert(declaration.name, emitted).is_some() {
            return Err(ComposeError::Duplicate { name: declaration.name.to_owned() });
        }
    }

    // Print what is reached, in order; numbers and bindings stand close together.
    let reached = reach(&declarations, roots)?;
    let mut text = String::new();
    let mut above = None;
    for declaration in declarations.iter().filter(|declaration| reached.contains(declaration.name)) {
        let close = matches!(declaration.kind, DeclarationKind::Constant | DeclarationKind::Variable);
        text.push_str(match above {
            None => "",
            Some(kind) if close && kind == declaration.kind => "\n",
            Some(_) => "\n\n",
        });
        rename(declaration.text, &names, &mut text);
        above = Some(declaration.kind);
    }
    text.push('\n');
    Ok(text)
}

/// Names of all declarations that the roots use, directly or through others.
fn reach<'a>(declarations: &[Declaration<'a>], roots: &[&str]) -> Result<BTreeSet<&'a str>, ComposeError> {
    let by_name: BTreeMap<_, _> =
        declarations.iter().map(|declaration| (declaration.name, declaration)).collect();
    let mut reached = BTreeSet::new();
    let mut open = Vec::new();
    for root in roots {
        match by_name.get(root) {
            Some(declaration) => open.push(*declaration),
            None => {
                return Err(ComposeError::Missing { name: (*root).to_owned() });
            }
        }
    }
    while let Some(declaration) = open.pop() {
        if reached.insert(declaration.name) {
            open.extend(wgsl::references(declaration.text).filter_map(|word| by_name.get(word)));
        }
    }
    Ok(reached)
}

/// Appends a text in which every reference to a declaration carries its emitted name, also between the backticks of
/// a comment.
fn rename(text: &str, names: &BTreeMap<&str, String>, out: &mut String) {
    let mut after_dot = false;
    for token in wgsl::tokens(text) {
        match token.kind {
            TokenKind::Comment => rename_in_comment(token.text, names, out),
            TokenKind::Word if !after_dot => {
                out.push_str(names.get(token.text).map_or(token.text, String::as_str));
            }
            _ => out.push_str(token.text),
        }
        if !matches!(token.kind, TokenKind::Space | TokenKind::Comment) {
            after_dot = token.text == ".";
        }
    }
}

fn rename_in_comment(comment: &str, names: &BTreeMap<&str, String>, out: &mut String) {
    for (index, part) in comment.split('`').enumerate() {
        if index > 0 {
            out.push('`');
        }
        let is_code = index % 2 == 1;
        out.push_str(names.get(part).filter(|_| is_code).map_or(part, String::as_str));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_reached_is_printed_and_everything_is_prefixed() {
        let library = "const A: f32 = 1.0;\nconst B: f32 = 2.0;\nstruct S { a: f32 }\n/// Not b.\nfn b() -> f32 { \
            return A; }\n/// Calls `b`, not b.\nfn c(s: S) -> f32 { return b() + s.a; }\nfn d() {}\n";
        let text = compose(&[library], &["c"], &Prefix::new("my_sun")).unwrap();
        assert_eq!(
            text,
            "const MY_SUN_A: f32 = 1.0;\n\nstruct MySunS { a: f32 }\n\n/// Not b.\nfn my_sun_b() -> f32 { return \
            MY_SUN_A; }\n\n/// Calls `my_sun_b`, not b.\nfn my_sun_c(s: MySunS) -> f32 { return my_sun_b() + s.a; }\n"
        );
    }

    #[test]
    fn a_name_that_is_declared_twice_or_nowhere_is_an_error() {
        let prefix = Prefix::new("sun");
        let twice = compose(&["fn a() {}", "const a: f32 = 1.0;"], &["a"], &prefix);
        assert_eq!(twice, Err(ComposeError::Duplicate { name: "a".into() }));
        let nowhere = compose(&["fn a() {}"], &["b"], &prefix);
        assert_eq!(nowhere, Err(ComposeError::Missing { name: "b".into() }));
    }
}
