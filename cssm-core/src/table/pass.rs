//! Passes that the runtime executes, and what they read and write.

use std::borrow::Cow;

use super::ShaderKind;

/// A pass the runtime can execute.
#[derive(Debug, Clone, PartialEq)]
pub struct Pass {
    /// Shader it runs.
    pub shader: ShaderKind,
    /// Vertex entry point.
    pub vertex: Cow<'static, str>,
    /// Fragment entry point, if there is one.
    pub fragment: Option<Cow<'static, str>>,
    /// What it reads.
    pub reads: Cow<'static, [Resource]>,
    /// What it writes.
    pub writes: Cow<'static, [Resource]>,
}

/// The compute pass that measures the engine's depth: reads [`Resource::SceneDepth`], writes numbers that begin at zero.
/// [`crate::fit::DepthHistogram::of_words`] reads them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reduction {
    /// Entry point of the shader of kind [`ShaderKind::Fit`].
    pub entry: Cow<'static, str>,
    /// Side of the square of pixels that one workgroup measures.
    pub square_pixels: u32,
    /// Numbers of 32 bits that it writes.
    pub words: u32,
}

/// What passes read and write.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Resource {
    /// The engine's caster geometry.
    Casters,
    /// The engine's alpha masks.
    CasterMasks,
    /// The shadow map.
    Map,
    /// Moments blurred along rows.
    MomentRows,
    /// Blurred moments.
    Moments,
    /// Masks of planes, blurred along rows.
    GroundRows,
    /// Blurred masks of planes.
    GroundMasks,
    /// The engine's depth.
    SceneDepth,
    /// The engine's normals.
    SceneNormal,
    /// The visibility mask.
    Mask,
}

impl Resource {
    /// Name in tables and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Casters => "casters",
            Self::CasterMasks => "caster masks",
            Self::Map => "map",
            Self::MomentRows => "moment rows",
            Self::Moments => "moments",
            Self::GroundRows => "ground rows",
            Self::GroundMasks => "ground masks",
            Self::SceneDepth => "scene depth",
            Self::SceneNormal => "scene normal",
            Self::Mask => "mask",
        }
    }
}
