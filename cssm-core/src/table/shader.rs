//! Shader modules.

use std::borrow::Cow;

/// A generated shader module.
#[derive(Debug, Clone, PartialEq)]
pub struct Shader {
    /// What it is.
    pub kind: ShaderKind,
    /// WGSL source.
    pub wgsl: Cow<'static, str>,
    /// SPIR-V, little-endian words; empty for [`ShaderKind::Function`], which has no entry point.
    pub spirv: Cow<'static, [u8]>,
}

/// The shader modules a case can have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShaderKind {
    /// Renders casters; needs unclipped depth, and clip distances where facets share tiles.
    Capture,
    /// Renders casters on every device: clamps depth and cuts casters per fragment.
    CaptureClamped,
    /// As [`Self::Capture`], for casters with an alpha mask.
    CaptureTested,
    /// As [`Self::CaptureClamped`], for casters with an alpha mask.
    CaptureTestedClamped,
    /// Decides texel by texel the triangles that bent rows bend too far for straight edges.
    CaptureBent,
    /// Decides every triangle of casters with an alpha mask texel by texel.
    CaptureBentTested,
    /// Takes moments of the map's depths, or what covers planes, and blurs them along rows, tile by tile.
    PrefilterRows,
    /// Blurs them along columns, tile by tile.
    PrefilterColumns,
    /// Screen-space visibility.
    Mask,
    /// The function for the engine's materials; no entry point.
    Function,
    /// Measures the engine's depth, in a compute pass.
    Fit,
}

impl ShaderKind {
    /// Name in file names, tables and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Capture => "capture",
            Self::CaptureClamped => "capture_clamped",
            Self::CaptureTested => "capture_tested",
            Self::CaptureTestedClamped => "capture_tested_clamped",
            Self::CaptureBent => "capture_bent",
            Self::CaptureBentTested => "capture_bent_tested",
            Self::PrefilterRows => "prefilter_rows",
            Self::PrefilterColumns => "prefilter_columns",
            Self::Mask => "mask",
            Self::Function => "function",
            Self::Fit => "fit",
        }
    }
}
