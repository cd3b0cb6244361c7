//! Structs that uniform buffers hold.

use std::borrow::Cow;

use super::Meaning;

/// A struct in uniform address space.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// What it is.
    pub kind: RecordKind,
    /// Shader type name, prefix included: `SunFacet`.
    pub name: Cow<'static, str>,
    /// Size in bytes, a multiple of 16.
    pub size_bytes: u32,
    /// Fields in order of offset.
    pub fields: Cow<'static, [RecordField]>,
}

/// The records a case can have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecordKind {
    /// What resolving needs of one facet.
    Facet,
    /// What resolving needs of a plan: the selection walk and all facets.
    Shadow,
    /// What capturing needs of one facet.
    Capture,
    /// What capturing needs of an alpha-tested caster.
    CasterMask,
    /// What the mask pass needs of the view.
    Mask,
    /// What measuring depth needs of the view.
    Fit,
}

impl RecordKind {
    /// Type name in the shader library, without a prefix.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Facet => "Facet",
            Self::Shadow => "Shadow",
            Self::Capture => "Capture",
            Self::CasterMask => "CasterMask",
            Self::Mask => "Mask",
            Self::Fit => "Fit",
        }
    }

    /// One sentence for the comments of shaders and tables.
    pub const fn summary(self) -> &'static str {
        match self {
            Self::Facet => "What resolving needs of one facet; all zero where a plan has none.",
            Self::Shadow => "What resolving needs of a plan.",
            Self::Capture => {
                "What capturing needs of one facet, in the capture's axes: its matrix, row by row."
            }
            Self::CasterMask => "What capturing needs of an alpha-tested caster.",
            Self::Mask => "What the mask pass needs of the view.",
            Self::Fit => "What measuring depth needs of the view.",
        }
    }
}

/// A field of a record.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordField {
    /// Name in the shader and in Rust.
    pub name: Cow<'static, str>,
    /// What it holds; uploads are written by meaning.
    pub meaning: Meaning,
    /// Type of one element.
    pub ty: FieldType,
    /// Number of array elements; 0: not an array.
    pub elements: u32,
    /// Offset in bytes from the start of the record.
    pub offset_bytes: u32,
    /// Distance in bytes between array elements; 0: not an array.
    pub stride_bytes: u32,
}

/// Types of record fields.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldType {
    /// `f32`
    F32,
    /// `vec2<f32>`
    Vec2,
    /// `vec4<f32>`
    Vec4,
    /// The record of kind [`RecordKind::Facet`].
    Facet,
}
