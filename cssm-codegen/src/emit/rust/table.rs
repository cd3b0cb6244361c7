//! The table as statics that borrow from each other, so that `TABLE` costs nothing at run time.

use cssm_core::case::Stretch;
use cssm_core::table::{BindGroup, BindingKind, CaseTable, ConstantValue, Pass, Record, Reduction, Resource};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::{doc, float, number, spirv_name, variant, wgsl_name};

/// `TABLE` and what it borrows from.
pub(super) fn statics(table: &CaseTable, crate_path: &syn::Path) -> TokenStream {
    let CaseTable {
        case,
        prefix,
        fingerprint,
        map_width,
        map_height,
        map_format,
        halves,
        sectors,
        bands,
        clips,
        dominant,
        scales_thresholds,
        local_light,
        remap,
        stretch,
        may_reverse_depth,
        axes,
        shears,
        fetches_per_pixel,
        constants: _,
        records: _,
        groups: _,
        passes: _,
        reduction,
        shaders: _,
    } = table;
    let docs = doc("Everything that the CPU and the GPU agree on.");
    let fingerprint: Literal = hexadecimal(*fingerprint);
    let (map_width, map_height) = (number(*map_width), number(*map_height));
    let map_format = variant("DepthFormat", map_format);
    let (sectors, bands, clips) = (number(*sectors), number(*bands), number(*clips));
    let axes = variant("Axes", axes);
    let halves = number(*halves);
    let remap = variant("RemapKind", remap);
    let stretch = stretch_value(*stretch);
    let fetches_per_pixel = number(*fetches_per_pixel);
    let constants = constants(table);
    let records = records(table);
    let groups = groups(table);
    let passes = passes(table);
    let reduction = reduction_value(reduction.as_ref());
    let shaders = shaders(table);
    quote! {
        #docs
        pub static TABLE: #crate_path::core::table::CaseTable = tables::TABLE;

        mod tables {
            use ::std::borrow::Cow;

            use #crate_path::core::case::{Axes, DepthFormat, Stretch};
            use #crate_path::core::distribution::RemapKind;
            use #crate_path::core::table::*;

            pub(super) const TABLE: CaseTable = CaseTable {
                case: Cow::Borrowed(#case),
                prefix: Cow::Borrowed(#prefix),
                fingerprint: #fingerprint,
                map_width: #map_width,
                map_height: #map_height,
                map_format: #map_format,
                halves: #halves,
                sectors: #sectors,
                bands: #bands,
                clips: #clips,
                dominant: #dominant,
                scales_thresholds: #scales_thresholds,
                local_light: #local_light,
                remap: #remap,
                stretch: #stretch,
                may_reverse_depth: #may_reverse_depth,
                axes: #axes,
                shears: #shears,
                fetches_per_pixel: #fetches_per_pixel,
                constants: Cow::Borrowed(CONSTANTS),
                records: Cow::Borrowed(RECORDS),
                groups: Cow::Borrowed(GROUPS),
                passes: Cow::Borrowed(PASSES),
                reduction: #reduction,
                shaders: Cow::Borrowed(SHADERS),
            };
            #constants
            #records
            #groups
            #passes
            #shaders
        }
    }
}

/// A [`Stretch`] as an expression.
pub(super) fn stretch_value(stretch: Stretch) -> TokenStream {
    match stretch {
        Stretch::None => quote!(Stretch::None),
        Stretch::Vertex => quote!(Stretch::Vertex),
        Stretch::Exact { bound_texels } => {
            let bound_texels = Literal::f64_unsuffixed(bound_texels);
            quote!(Stretch::Exact { bound_texels: #bound_texels })
        }
    }
}

fn reduction_value(reduction: Option<&Reduction>) -> TokenStream {
    let Some(Reduction { entry, square_pixels, words }) = reduction else { return quote!(None) };
    let (square_pixels, words) = (number(*square_pixels), number(*words));
    quote! {
        Some(Reduction { entry: Cow::Borrowed(#entry), square_pixels: #square_pixels, words: #words })
    }
}

fn constants(table: &CaseTable) -> TokenStream {
    let constants = table.constants.iter().map(|constant| {
        let kind = variant("ConstantKind", &constant.kind);
        let name = &constant.name;
        let value = match constant.value {
            ConstantValue::U32(value) => {
                let value = number(value);
                quote!(ConstantValue::U32(#value))
            }
            ConstantValue::F32(value) => {
                let value = float(value);
                quote!(ConstantValue::F32(#value))
            }
            ConstantValue::Vec2([x, y]) => {
                let (x, y) = (float(x), float(y));
                quote!(ConstantValue::Vec2([#x, #y]))
            }
        };
        quote!(Constant { kind: #kind, name: Cow::Borrowed(#name), value: #value })
    });
    quote!(const CONSTANTS: &[Constant] = &[#(#constants),*];)
}

fn records(table: &CaseTable) -> TokenStream {
    let lists = table.records.iter().map(record_fields);
    let records = table.records.iter().map(|record| {
        let kind = variant("RecordKind", &record.kind);
        let name = &record.name;
        let size_bytes = number(record.size_bytes);
        let fields = fields_name(record);
        quote! {
            Record {
                kind: #kind, name: Cow::Borrowed(#name), size_bytes: #size_bytes, fields: Cow::Borrowed(#fields)
            }
        }
    });
    quote! {
        const RECORDS: &[Record] = &[#(#records),*];
        #(#lists)*
    }
}

fn record_fields(record: &Record) -> TokenStream {
    let list = fields_name(record);
    let fields = record.fields.iter().map(|field| {
        let name = &field.name;
        let meaning = variant("Meaning", &field.meaning);
        let ty = variant("FieldType", &field.ty);
        let elements = number(field.elements);
        let offset_bytes = number(field.offset_bytes);
        let stride_bytes = number(field.stride_bytes);
        quote! {
            RecordField {
                name: Cow::Borrowed(#name), meaning: #meaning, ty: #ty, elements: #elements,
                offset_bytes: #offset_bytes, stride_bytes: #stride_bytes
            }
        }
    });
    quote!(const #list: &[RecordField] = &[#(#fields),*];)
}

fn fields_name(record: &Record) -> Ident {
    format_ident!("{}_FIELDS", record.kind.name().to_ascii_uppercase())
}

fn groups(table: &CaseTable) -> TokenStream {
    let lists = table.groups.iter().map(|group| {
        let list = bindings_name(group);
        let bindings = group.bindings.iter().map(|binding| {
            let number = number(binding.binding);
            let name = &binding.name;
            let kind = binding_kind(binding.kind);
            quote!(Binding { binding: #number, name: Cow::Borrowed(#name), kind: #kind })
        });
        quote!(const #list: &[Binding] = &[#(#bindings),*];)
    });
    let groups = table.groups.iter().map(|group| {
        let shader = variant("ShaderKind", &group.shader);
        let content = variant("GroupContent", &group.content);
        let number = number(group.group);
        let bindings = bindings_name(group);
        quote! {
            BindGroup {
                shader: #shader, content: #content, group: #number, bindings: Cow::Borrowed(#bindings)
            }
        }
    });
    quote! {
        const GROUPS: &[BindGroup] = &[#(#groups),*];
        #(#lists)*
    }
}

fn bindings_name(group: &BindGroup) -> Ident {
    format_ident!("{}_GROUP_{}", group.shader.name().to_ascii_uppercase(), group.group)
}

fn passes(table: &CaseTable) -> TokenStream {
    let passes = table.passes.iter().map(|pass| {
        let Pass { shader, vertex, fragment, reads, writes } = pass;
        let shader = variant("ShaderKind", shader);
        let fragment = match fragment {
            Some(fragment) => quote!(Some(Cow::Borrowed(#fragment))),
            None => quote!(None),
        };
        let (reads, writes) = (resources(reads), resources(writes));
        quote! {
            Pass {
                shader: #shader, vertex: Cow::Borrowed(#vertex), fragment: #fragment,
                reads: Cow::Borrowed(&#reads), writes: Cow::Borrowed(&#writes)
            }
        }
    });
    quote!(const PASSES: &[Pass] = &[#(#passes),*];)
}

fn shaders(table: &CaseTable) -> TokenStream {
    let shaders = table.shaders.iter().map(|shader| {
        let kind = variant("ShaderKind", &shader.kind);
        let wgsl = wgsl_name(shader);
        let spirv = if shader.spirv.is_empty() {
            quote!(&[])
        } else {
            let name = spirv_name(shader);
            quote!(super::#name)
        };
        quote!(Shader { kind: #kind, wgsl: Cow::Borrowed(super::#wgsl), spirv: Cow::Borrowed(#spirv) })
    });
    quote!(const SHADERS: &[Shader] = &[#(#shaders),*];)
}

pub(super) fn hexadecimal(value: u64) -> Literal {
    format!("{value:#018x}").parse().unwrap_or_else(|_| Literal::u64_unsuffixed(value))
}

fn resources(resources: &[Resource]) -> TokenStream {
    let names = resources.iter().map(|resource| variant("Resource", resource));
    quote!([#(#names),*])
}

fn binding_kind(kind: BindingKind) -> TokenStream {
    match kind {
        BindingKind::Uniform { record, dynamic_offset } => {
            let record = variant("RecordKind", &record);
            quote!(BindingKind::Uniform { record: #record, dynamic_offset: #dynamic_offset })
        }
        kind => variant("BindingKind", &kind),
    }
}
