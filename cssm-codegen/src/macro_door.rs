//! The macro's door: tokens in, modules out, errors at the tokens they belong to.

use cssm_core::LightCase;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;

use crate::dsl::{self, Diagnostic};
use crate::emit::rust;
use crate::generate::{self, GenerateError};

/// Expands `light_case! { .. }`: one module for each case, or one `compile_error!` for each fault.
///
/// Crates that re-export the façade begin the input with `#![crate_path(::engine::cssm)]`.
pub fn macro_expand(input: TokenStream) -> TokenStream {
    let (crate_path, declarations) = split_crate_path(input);
    let cases = match dsl::parse_tokens(declarations) {
        Ok(cases) => cases,
        Err(faults) => return faults.iter().map(Diagnostic::to_compile_error).collect(),
    };
    modules(&crate_path, &cases).unwrap_or_else(|error| {
        let text = error.to_string();
        quote! { ::core::compile_error! { #text } }
    })
}

fn modules(crate_path: &str, cases: &[LightCase]) -> Result<TokenStream, GenerateError> {
    let crate_path = rust::crate_path(crate_path)?;
    generate::check_prefixes(cases)?;
    let module = |case| Ok(rust::module(case, &generate::table_with_shaders(case)?, &crate_path));
    cases.iter().map(module).collect()
}

/// Takes a leading `#![crate_path(..)]` off the input.
fn split_crate_path(input: TokenStream) -> (String, TokenStream) {
    let tokens: Vec<_> = input.clone().into_iter().collect();
    if let [TokenTree::Punct(hash), TokenTree::Punct(bang), TokenTree::Group(attribute), rest @ ..] = &*tokens
        && (hash.as_char(), bang.as_char(), attribute.delimiter()) == ('#', '!', Delimiter::Bracket)
        && let [TokenTree::Ident(name), TokenTree::Group(path)] =
            &*attribute.stream().into_iter().collect::<Vec<_>>()
        && *name == "crate_path"
    {
        return (path.stream().to_string(), rest.iter().cloned().collect());
    }
    (rust::DEFAULT_CRATE_PATH.to_owned(), input)
}
