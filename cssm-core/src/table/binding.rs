//! What shaders bind.

use std::borrow::Cow;

use super::{RecordKind, ShaderKind};

/// Bindings of one group of one shader.
#[derive(Debug, Clone, PartialEq)]
pub struct BindGroup {
    /// The shader it belongs to.
    pub shader: ShaderKind,
    /// What the group holds; groups with equal contents have equal layouts and can be shared.
    pub content: GroupContent,
    /// `@group` number.
    pub group: u32,
    /// Bindings in order of number.
    pub bindings: Cow<'static, [Binding]>,
}

/// What a bind group is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GroupContent {
    /// One facet of the capture stage.
    CaptureFacet,
    /// Buffers of a caster whose vertices the shader fetches by itself.
    CasterMesh,
    /// Alpha mask of a caster.
    CasterMask,
    /// The plan's tiles and what a pass of the prefilter reads.
    Prefilter,
    /// The engine's depth (and normals) and the view.
    MaskInput,
    /// The engine's depth, the view, and the numbers that are measured.
    Fit,
    /// The plan, the map and its sampler.
    Shadow,
}

/// One binding.
#[derive(Debug, Clone, PartialEq)]
pub struct Binding {
    /// `@binding` number.
    pub binding: u32,
    /// Variable name in the shader, prefix included.
    pub name: Cow<'static, str>,
    /// What is bound.
    pub kind: BindingKind,
}

/// What is bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BindingKind {
    /// A uniform buffer holding a record.
    Uniform {
        /// The record.
        record: RecordKind,
        /// Whether the offset is given at draw time.
        dynamic_offset: bool,
    },
    /// The shadow map: `texture_depth_2d`.
    Map,
    /// Moments of the map's depths, blurred along rows: `texture_2d<f32>` of two channels, not filtered.
    MomentRows,
    /// Moments of the map's depths, blurred: `texture_2d<f32>` of two channels, not filtered.
    Moments,
    /// Masks of planes, blurred along rows: `texture_2d<f32>` of as many channels as planes, or one more; not filtered.
    GroundRows,
    /// Masks of planes, blurred: `texture_2d<f32>` of as many channels, filtered.
    GroundMasks,
    /// `sampler`, linear.
    GroundSampler,
    /// The engine's depth: `texture_depth_2d`.
    SceneDepth,
    /// The engine's linear depth: `texture_2d<f32>`, not filtered.
    SceneLinearDepth,
    /// The engine's geometric normals: `texture_2d<f32>`, not filtered.
    SceneNormal,
    /// Alpha mask of a caster: `texture_2d<f32>`, filtered.
    CasterMask,
    /// The engine's sampler for alpha masks.
    CasterMaskSampler,
    /// Where a caster's vertices lie in its buffers, `array<vec4<u32>, 2>`: first word of the positions, words between
    /// them, first index, how indices are stored (0: none, 1: 16 bits, 2: 32 bits); then format of the positions, first
    /// word of the texture coordinates, words between them, their format. Formats: 0 floats, 1 half floats, 2 and 3
    /// normalised 16 bits with and without sign, 4 and 5 normalised 8 bits with and without sign, 6 three times 10 bits
    /// without sign.
    MeshLayout,
    /// Positions of a caster in the engine's own buffer, as words.
    MeshPositions,
    /// Indices of a caster in the engine's own buffer, as words.
    MeshIndices,
    /// Texture coordinates of a caster in the engine's own buffer, as words.
    MeshUvs,
    /// `sampler_comparison`, linear; less or equal, or greater or equal where depth is stored reversed.
    ComparisonSampler,
    /// `sampler`, nearest, not filtering.
    GatherSampler,
    /// Measured numbers, `array<atomic<u32>>` in storage.
    Measured,
}
