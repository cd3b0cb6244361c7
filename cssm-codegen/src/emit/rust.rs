//! The Rust target: one module per case, with its declaration, records, constants, shaders and table.
//!
//! The module names nothing but the façade crate, allocates nothing in statics, and holds no type of any graphics
//! interface.

mod case;
pub(crate) mod casters;
mod records;
mod table;

use cssm_core::LightCase;
use cssm_core::table::{CaseTable, ConstantValue, Shader};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use crate::generate::{GenerateError, doc_lines};

/// Path of the façade crate in generated Rust, unless the caller gives another.
pub(crate) const DEFAULT_CRATE_PATH: &str = "::cssm";

/// Reads a crate path as given by a caller.
pub(crate) fn crate_path(path: &str) -> Result<syn::Path, GenerateError> {
    let parsed: Result<syn::Path, _> = syn::parse_str(path);
    // The path stands in nested modules, so it must not start from the current one.
    let fits = |path: &syn::Path| {
        let relative =
            path.segments.first().is_some_and(|first| first.ident == "self" || first.ident == "super");
        !relative && path.segments.iter().all(|segment| segment.arguments.is_empty())
    };
    parsed.ok().filter(fits).ok_or_else(|| GenerateError::CratePath { path: path.to_owned() })
}

/// The module as tokens.
pub(crate) fn module(case: &LightCase, table: &CaseTable, crate_path: &syn::Path) -> TokenStream {
    let name = module_name(&case.prefix);
    let visibility = case.public.then(|| quote!(pub));
    let docs = module_docs(case);
    let declaration = case::function(case, crate_path);
    let records = records::structs(table, crate_path);
    let constants = constants(table);
    let shaders = table.shaders.iter().map(shader_constants);
    let statics = table::statics(table, crate_path);
    quote! {
        #docs
        #[allow(dead_code, unreachable_pub, clippy::all, clippy::pedantic, clippy::nursery)]
        #visibility mod #name {
            #declaration
            #constants
            #records
            #statics
            #(#shaders)*
        }
    }
}

/// The module as text, under a line that says where it comes from.
pub(crate) fn text(
    case: &LightCase,
    table: &CaseTable,
    tokens: TokenStream,
) -> Result<String, GenerateError> {
    let file = syn::parse2(tokens)
        .map_err(|error| GenerateError::Rust { case: case.name.clone(), message: error.to_string() })?;
    let fingerprint = table.fingerprint;
    let head = format!("// Generated from light case `{}`, {fingerprint:016x}. Do not edit.\n\n", case.name);
    Ok(head + &prettyplease::unparse(&file))
}

/// Name of the module of a prefix; a prefix that Rust reserves stands raw, or with a suffix where that is refused.
pub(crate) fn module_name(prefix: &str) -> Ident {
    match prefix {
        "crate" | "self" | "super" => Ident::new(&format!("{prefix}_case"), Span::call_site()),
        _ if syn::parse_str::<Ident>(prefix).is_ok() => Ident::new(prefix, Span::call_site()),
        _ => Ident::new_raw(prefix, Span::call_site()),
    }
}

/// A doc attribute; prettyplease prints it as a doc comment.
fn doc(text: &str) -> TokenStream {
    let text = if text.is_empty() { String::new() } else { format!(" {text}") };
    quote!(#[doc = #text])
}

fn module_docs(case: &LightCase) -> TokenStream {
    let mut lines = doc_lines(&case.doc);
    if !lines.is_empty() {
        lines.push(String::new());
    }
    lines.push(format!("Tables and shaders of light case `{}`.", case.name));
    lines.iter().map(|line| doc(line)).collect()
}

fn constants(table: &CaseTable) -> TokenStream {
    let constants = table.constants.iter().map(|constant| {
        let docs = doc(constant.kind.summary());
        let name = Ident::new(&constant.name, Span::call_site());
        let (ty, value) = match constant.value {
            ConstantValue::U32(value) => (quote!(u32), number(value)),
            ConstantValue::F32(value) => (quote!(f32), float(value)),
            ConstantValue::Vec2([x, y]) => {
                let (x, y) = (float(x), float(y));
                (quote!([f32; 2]), quote!([#x, #y]))
            }
        };
        quote!(#docs pub const #name: #ty = #value;)
    });
    quote!(#(#constants)*)
}

/// The text of a shader as a raw string, its words as one byte string.
fn shader_constants(shader: &Shader) -> TokenStream {
    let kind = shader.kind.name();
    let docs = doc(&format!("WGSL of the {kind} shader."));
    let name = wgsl_name(shader);
    let text = raw_string(&shader.wgsl);
    let wgsl = quote!(#docs pub const #name: &str = #text;);
    if shader.spirv.is_empty() {
        return wgsl;
    }
    let docs = doc(&format!("SPIR-V of the {kind} shader, little-endian words."));
    let name = spirv_name(shader);
    let bytes = Literal::byte_string(&shader.spirv);
    quote!(#wgsl #docs pub const #name: &[u8] = #bytes;)
}

fn wgsl_name(shader: &Shader) -> Ident {
    Ident::new(&format!("{}_WGSL", shader.kind.name().to_ascii_uppercase()), Span::call_site())
}

fn spirv_name(shader: &Shader) -> Ident {
    Ident::new(&format!("{}_SPIRV", shader.kind.name().to_ascii_uppercase()), Span::call_site())
}

/// A raw string literal with as many `#` as the text needs.
fn raw_string(text: &str) -> TokenStream {
    let mut fence = String::from("#");
    while text.contains(&format!("\"{fence}")) {
        fence.push('#');
    }
    // A text with characters that raw strings refuse falls back to an escaped literal.
    let raw: Result<Literal, _> = format!("r{fence}\"{text}\"{fence}").parse();
    let literal = raw.unwrap_or_else(|_| Literal::string(text));
    quote!(#literal)
}

/// A variant without fields, by its derived debug form, which is its name.
fn variant(ty: &str, value: &impl std::fmt::Debug) -> TokenStream {
    let (ty, name) = (format_ident!("{ty}"), format_ident!("{value:?}"));
    quote!(#ty::#name)
}

fn number(value: u32) -> TokenStream {
    let literal = Literal::u32_unsuffixed(value);
    quote!(#literal)
}

fn float(value: f32) -> TokenStream {
    let literal = Literal::f32_unsuffixed(value);
    quote!(#literal)
}
