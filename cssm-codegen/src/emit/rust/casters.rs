//! The Rust module of a caster entry: its shaders and its table.

use cssm_core::LightCase;
use cssm_core::table::{CasterShader, CasterSpace, CasterTable, Shader};
use proc_macro2::TokenStream;
use quote::quote;

use super::{crate_path, doc, module_name, number, shader_constants, spirv_name, variant, wgsl_name};
use crate::generate::GenerateError;

/// Name of the module, and of its file.
pub(crate) fn name(case: &LightCase, casters: &CasterTable) -> String {
    format!("{}_{}", case.prefix, casters.name)
}

/// The module as text, under a line that says where it comes from.
pub(crate) fn text(case: &LightCase, casters: &CasterTable, path: &str) -> Result<String, GenerateError> {
    let file = syn::parse2(module(case, casters, &crate_path(path)?))
        .map_err(|error| GenerateError::Rust { case: case.name.clone(), message: error.to_string() })?;
    let head = format!(
        "// Generated from light case `{}`, {:016x}, and caster entry `{}`. Do not edit.\n\n",
        case.name, casters.fingerprint, casters.name
    );
    Ok(head + &prettyplease::unparse(&file))
}

fn module(case: &LightCase, casters: &CasterTable, crate_path: &syn::Path) -> TokenStream {
    let module = module_name(&name(case, casters));
    let visibility = case.public.then(|| quote!(pub));
    let docs = doc(&format!(
        "Capture shaders of light case `{}` around the engine's casters `{}`.",
        case.name, casters.name
    ));
    let constants = casters.shaders.iter().map(|shader| shader_constants(&plain(shader)));
    let table_docs = doc("The shaders, what they take and what they bind.");
    let CasterTable { name, case: case_name, fingerprint, space, attributes, bindings, shaders } = casters;
    let fingerprint = super::table::hexadecimal(*fingerprint);
    let space = space_value(*space);
    let attributes = attributes.iter().map(|attribute| {
        let (location, name, ty) = (number(attribute.location), &attribute.name, &attribute.ty);
        quote!(CasterAttribute { location: #location, name: Cow::Borrowed(#name), ty: Cow::Borrowed(#ty) })
    });
    let bindings = bindings.iter().map(|binding| {
        let (group, number, name) = (number(binding.group), number(binding.binding), &binding.name);
        quote!(CasterBinding { group: #group, binding: #number, name: Cow::Borrowed(#name) })
    });
    let shaders = shaders.iter().map(|shader| {
        let (wgsl, spirv) = (wgsl_name(&plain(shader)), spirv_name(&plain(shader)));
        let (kind, vertex) = (variant("ShaderKind", &shader.kind), &shader.vertex);
        let fragment = match &shader.fragment {
            Some(fragment) => quote!(Some(Cow::Borrowed(#fragment))),
            None => quote!(None),
        };
        quote! {
            CasterShader {
                kind: #kind, wgsl: Cow::Borrowed(super::#wgsl), spirv: Cow::Borrowed(super::#spirv),
                vertex: Cow::Borrowed(#vertex), fragment: #fragment
            }
        }
    });
    quote! {
        #docs
        #[allow(dead_code, unreachable_pub, clippy::all, clippy::pedantic, clippy::nursery)]
        #visibility mod #module {
            #table_docs
            pub static CASTERS: #crate_path::core::table::CasterTable = tables::CASTERS;

            mod tables {
                use ::std::borrow::Cow;

                use #crate_path::core::table::*;

                pub(super) const CASTERS: CasterTable = CasterTable {
                    name: Cow::Borrowed(#name),
                    case: Cow::Borrowed(#case_name),
                    fingerprint: #fingerprint,
                    space: #space,
                    attributes: Cow::Borrowed(&[#(#attributes),*]),
                    bindings: Cow::Borrowed(&[#(#bindings),*]),
                    shaders: Cow::Borrowed(&[#(#shaders),*]),
                };
            }
            #(#constants)*
        }
    }
}

/// A composed shader as one of a case's, for what both are printed by.
fn plain(shader: &CasterShader) -> Shader {
    Shader { kind: shader.kind, wgsl: shader.wgsl.clone(), spirv: shader.spirv.clone() }
}

fn space_value(space: CasterSpace) -> TokenStream {
    match space {
        CasterSpace::Object { first_location } => {
            let first_location = number(first_location);
            quote!(CasterSpace::Object { first_location: #first_location })
        }
        CasterSpace::World { group, binding } => {
            let (group, binding) = (number(group), number(binding));
            quote!(CasterSpace::World { group: #group, binding: #binding })
        }
        CasterSpace::Capture => quote!(CasterSpace::Capture),
    }
}
