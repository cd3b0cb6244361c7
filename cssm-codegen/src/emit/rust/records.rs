//! Records as `#[repr(C)]` structs whose sizes and offsets the compiler checks against the shaders'.

use cssm_core::table::{CaseTable, FieldType, Record, RecordField, RecordKind};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::doc;

/// All structs of a table, each with its asserts.
pub(super) fn structs(table: &CaseTable, crate_path: &syn::Path) -> TokenStream {
    table.records.iter().map(|record| structure(table, record, crate_path)).collect()
}

fn structure(table: &CaseTable, record: &Record, crate_path: &syn::Path) -> TokenStream {
    let docs = doc(record.kind.summary());
    let name = Ident::new(&record.name, Span::call_site());
    let bytemuck = quote!(#crate_path::bytemuck).to_string().replace(' ', "");

    // List fields, with explicit padding wherever the shader's layout leaves a gap.
    let mut fields = Vec::new();
    let mut next = 0;
    let mut paddings = 0_u32;
    let mut pad = |next: u32, to: u32, fields: &mut Vec<TokenStream>| {
        if next < to {
            let docs = doc("Unused; keeps the offsets of the shader.");
            let padding = format_ident!("padding_{}", paddings);
            let floats = count((to - next) / 4);
            fields.push(quote!(#docs pub #padding: [f32; #floats]));
            paddings += 1;
        }
    };
    for field in record.fields.iter() {
        pad(next, field.offset_bytes, &mut fields);
        let docs = doc(field.meaning.summary());
        let field_name = Ident::new(&field.name, Span::call_site());
        let ty = field_type(table, field);
        fields.push(quote!(#docs pub #field_name: #ty));
        next = field.offset_bytes + size(table, field);
    }
    pad(next, record.size_bytes, &mut fields);

    // Assert what the shader takes for granted.
    let size_bytes = count(record.size_bytes);
    let offsets = record.fields.iter().map(|field| {
        let field_name = Ident::new(&field.name, Span::call_site());
        let offset = count(field.offset_bytes);
        quote!(assert!(::core::mem::offset_of!(#name, #field_name) == #offset);)
    });
    quote! {
        #docs
        #[derive(
            Clone, Copy, Debug, PartialEq, #crate_path::bytemuck::Pod, #crate_path::bytemuck::Zeroable
        )]
        #[bytemuck(crate = #bytemuck)]
        #[repr(C)]
        pub struct #name {
            #(#fields),*
        }
        const _: () = {
            let size_bytes = ::core::mem::size_of::<#name>();
            assert!(size_bytes == #size_bytes);
            #(#offsets)*
        };
    }
}

fn field_type(table: &CaseTable, field: &RecordField) -> TokenStream {
    let element = match field.ty {
        FieldType::F32 => quote!(f32),
        FieldType::Vec2 => quote!([f32; 2]),
        FieldType::Vec4 => quote!([f32; 4]),
        FieldType::Facet => {
            let facet = table.record(RecordKind::Facet).map_or("f32", |record| &*record.name);
            let facet = Ident::new(facet, Span::call_site());
            quote!(#facet)
        }
    };
    match field.elements {
        0 => element,
        elements => {
            let elements = count(elements);
            quote!([#element; #elements])
        }
    }
}

/// Bytes that a field's Rust type takes.
fn size(table: &CaseTable, field: &RecordField) -> u32 {
    let element = match field.ty {
        FieldType::F32 => 4,
        FieldType::Vec2 => 8,
        FieldType::Vec4 => 16,
        FieldType::Facet => table.record(RecordKind::Facet).map_or(0, |record| record.size_bytes),
    };
    element * field.elements.max(1)
}

fn count(value: u32) -> TokenStream {
    let literal = Literal::u32_unsuffixed(value);
    quote!(#literal)
}
