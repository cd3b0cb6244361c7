//! The declaration language: text or tokens become checked light cases.
//!
//! A declaration is made of Rust tokens, so the same text stands in a `.cssm` file and in `light_case! { .. }`:
//!
//! ```text
//! /// Sun over an open world.
//! pub case Sun {
//!     technique: camera_space,
//!     distribution: bands(8, horizon: 100 km),
//!     map: { size: 2048 x 2048 },
//! }
//! ```
//!
//! Reading goes in four steps, each in its own file. `scan` finds what would stop the lexer (unclosed brackets,
//! letters outside ASCII). `item` takes the frames of the cases, `tree` their values: words with arguments,
//! numbers with units, sizes, lists, groups, all with their places. `check` holds the tree against the one schema
//! table of `cssm_core` and turns it into a [`LightCase`]. Each step goes on after a fault, so a file reports all
//! its faults at once; only what stops the lexer stands alone.
//!
//! No input panics: whatever is written gives cases or faults that say what to write instead.

mod check;
mod diagnostic;
mod item;
mod number;
mod print;
mod reference;
mod report;
mod scan;
mod suggest;
mod tree;

pub use diagnostic::Diagnostic;
pub use print::print;
pub use reference::reference;
pub use report::{Finding, Report};
pub(crate) use suggest::nearest;

use cssm_core::LightCase;
use proc_macro2::{Span, TokenStream};

use diagnostic::Faults;

/// Reads the cases of a file; `name` is the file's name in reports.
///
/// # Errors
/// All faults of the file with their places. Faults that stop the lexer are reported alone.
pub fn parse_file(name: &str, text: &str) -> Result<Vec<LightCase>, Report> {
    let findings = scan::scan(text);
    if !findings.is_empty() {
        return Err(Report::new(name, text, findings));
    }
    let tokens: TokenStream = text.parse().map_err(|error: proc_macro2::LexError| {
        let bytes = error.span().byte_range();
        let remedy = "write names, numbers, commas and brackets only".into();
        let message = "this is no part of a declaration".into();
        Report::new(name, text, vec![Finding { message, remedy, bytes, secondary: None }])
    })?;
    parse_tokens(tokens).map_err(|faults| Report::new(name, text, faults.iter().map(Finding::of).collect()))
}

/// Reads the cases of a token stream, such as a macro's input.
///
/// # Errors
/// All faults with their spans.
pub fn parse_tokens(tokens: TokenStream) -> Result<Vec<LightCase>, Vec<Diagnostic>> {
    let mut faults = Faults::default();
    let items = item::items(tokens, &mut faults);
    let mut cases: Vec<(LightCase, Span)> = Vec::new();
    for (index, item) in items.iter().enumerate() {
        // Names must differ even where the rest of a case is at fault.
        if let Some(first) = items[..index].iter().find(|earlier| earlier.name == item.name) {
            let message = format!("case `{}` is declared twice", item.name);
            let fault = Diagnostic::new(item.name_span, message, "rename one of them");
            faults.0.push(fault.with_secondary(first.name_span, "first declared here"));
        }
        let Some(case) = check::case(item, &mut faults) else {
            continue;
        };
        let collides = |(earlier, _): &&(LightCase, Span)| {
            earlier.name != case.name && type_prefix(&earlier.prefix) == type_prefix(&case.prefix)
        };
        if let Some((first, span)) = cases.iter().find(collides) {
            let message =
                format!("cases `{}` and `{}` share the prefix `{}`", first.name, case.name, case.prefix);
            let fault = Diagnostic::new(item.name_span, message, "give one of them another `prefix`");
            faults.0.push(fault.with_secondary(*span, "first used here"));
        }
        cases.push((case, item.name_span));
    }
    if faults.0.is_empty() { Ok(cases.into_iter().map(|(case, _)| case).collect()) } else { Err(faults.0) }
}

/// The prefix as it begins the names of shader types; prefixes that agree in it collide.
fn type_prefix(prefix: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        let first = letters.next().map(|first| first.to_ascii_uppercase());
        first.into_iter().chain(letters).collect::<String>()
    };
    prefix.split('_').map(capital).collect()
}
