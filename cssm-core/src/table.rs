//! The table of a case: everything the CPU and the GPU must agree on, defined once.
//!
//! [`CaseTable::describe`] derives it from a case alone. Code generation prints the shaders' structs and bindings
//! from it and emits it as Rust and JSON; the runtime uploads plans and builds pipelines from it. It names no type
//! of any graphics interface. What a case does not declare has no record field, binding or pass here.

mod caster;
mod constant;
mod describe;
mod filter;
mod ground;
mod write;

pub use caster::{CasterAttribute, CasterBinding, CasterShader, CasterSpace, CasterTable, caster_rows};
pub use constant::{Constant, ConstantKind, ConstantValue};
pub use write::{
    shear_parts, write_capture_record, write_capture_record_to, write_caster_mask_record, write_fit_record,
    write_mask_record, write_mask_record_to, write_shadow_record, write_shadow_record_to,
};

use std::borrow::Cow;

use crate::case::{Axes, DepthFormat, Stretch};
use crate::distribution::RemapKind;

/// Records, bindings, passes and shaders of one case.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseTable {
    /// Name of the case.
    pub case: Cow<'static, str>,
    /// Prefix of every shader name.
    pub prefix: Cow<'static, str>,
    /// Fingerprint of the declaration; equal declarations have equal fingerprints.
    pub fingerprint: u64,
    /// Map width in texels.
    pub map_width: u32,
    /// Map height in texels.
    pub map_height: u32,
    /// Map texel format.
    pub map_format: DepthFormat,
    /// Halves of the selection walk.
    pub halves: u32,
    /// Sectors of each half.
    pub sectors: u32,
    /// Bands in each sector.
    pub bands: u32,
    /// Half-spaces that the capture cuts casters with; 0: every tile is a rectangle of its own.
    pub clips: u32,
    /// Whether receivers near a dominant plane have a cell of their own, after all others.
    pub dominant: bool,
    /// Whether band limits are multiples of a row of each sector's own.
    pub scales_thresholds: bool,
    /// Whether rays begin at a point; the shadow record then holds its position where a bias needs it.
    pub local_light: bool,
    /// How facets bend their rows.
    pub remap: RemapKind,
    /// How casters are drawn where rows are bent.
    pub stretch: Stretch,
    /// Whether plans may store depth reversed; the shadow record then holds its sign.
    pub may_reverse_depth: bool,
    /// Axes of positions and normals in the resolve shaders.
    pub axes: Axes,
    /// Whether the resolve shaders shear positions along the light; the shadow record then holds the shear and its rows
    /// are those of sheared camera axes. Capture records are in sheared camera axes always.
    pub shears: bool,
    /// Texture fetch instructions of the map per resolved pixel, at most.
    pub fetches_per_pixel: u32,
    /// Numbers that the shaders are specialised for.
    pub constants: Cow<'static, [Constant]>,
    /// Uniform records; nested ones before those that hold them.
    pub records: Cow<'static, [Record]>,
    /// Bind groups by shader.
    pub groups: Cow<'static, [BindGroup]>,
    /// Passes in order of execution.
    pub passes: Cow<'static, [Pass]>,
    /// The reduction of the engine's depth, if the case is fitted to it and takes it.
    pub reduction: Option<Reduction>,
    /// Shader modules; empty until code generation has run.
    pub shaders: Cow<'static, [Shader]>,
}

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

/// What a record field holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Meaning {
    /// Facet row: clip x of the tile from (x, y, z, 1) relative to the eye.
    RowX,
    /// Facet row: clip y of the tile, up.
    RowY,
    /// Facet row: clip z.
    RowZ,
    /// Facet row: clip w.
    RowW,
    /// Map texel = ndc * xy + zw.
    TexelFromNdc,
    /// Smallest (xy) and largest (zw) map texel coordinate of a receiver for which no tap leaves the tile.
    TexelLimits,
    /// Depth times w per metre away from the light.
    DepthPerMetre,
    /// Larger texel axis across the ray in metres, per w.
    TexelMetresPerW,
    /// Depth by which an exact receiver plane is lowered for half a texel, and for rounding: their sum; for a local light
    /// the first part alone, times the distance from it.
    ReceiverPlaneDepth,
    /// Depth by which an exact receiver plane is lowered for rounding, for a local light.
    RoundingDepth,
    /// Remap of the rows: for [`RemapKind::Perspective`] (shift, scale, push-back, 0); for [`RemapKind::Logarithmic`]
    /// (shift, change per ln(k reference), reference, 0), then (k of the horizon, shift, change per k beyond it, 0).
    Remap,
    /// Width and height of the facet's tile in texels.
    TileSize,
    /// Smallest and largest k of the tile (xy) and the map texel of its upper left corner (zw), for casters that are decided
    /// texel by texel.
    StretchTile,
    /// Position of a local light relative to the eye, in the case's axes.
    LightPosition,
    /// Plane through the light that parts the halves.
    Split,
    /// Rows of receivers near the dominant plane: the first between -1 and 1, the second not negative.
    Dominant,
    /// Rows that band limits are multiplied with, one per sector.
    Units,
    /// Unit vector towards the light, in the case's axes.
    TowardLight,
    /// What x and y gain per z by the shear along the light: leading parts of twelve bits (xy), then the rest (zw).
    Shear,
    /// Row that gives the metres that a screen pixel spans at a position's depth.
    PixelMetres,
    /// 1 where stored depth grows away from the light, -1 where it falls.
    DepthSign,
    /// Half-spaces that casters are cut with; all of space where a facet has none.
    Clips,
    /// Alpha below which a caster has a hole.
    AlphaCutoff,
    /// Border rows of the selection walk, one per sector.
    Borders,
    /// Distance rows, one per sector.
    Distances,
    /// Band limits: four to a vector, `ceil((bands - 1) / 4)` vectors to a sector; unused entries are the largest
    /// float.
    Thresholds,
    /// Planes with masks of their own, as unit normals and offsets relative to the eye, in the case's axes.
    GroundPlanes,
    /// Where those planes lie in tiles, four vectors to a plane, planes of a cell one after the other: see
    /// [`crate::ground::PlaneInTile`], whose figures stand in xyz; zero where a plane is not lit.
    GroundTiles,
    /// Edges of facets that share their tile, of clip x/w and y/w in xyz; as many to a cell as facets have clip half-spaces.
    GroundEdges,
    /// All facets, by index.
    Facets,
    /// Direction relative to the eye, in the case's axes, depth 1, at the image's upper left corner.
    RayCorner,
    /// Change of that direction across the whole image width.
    RayAcross,
    /// Change of that direction down the whole image height.
    RayDown,
    /// 1 / depth = x * stored + y, for reversed-z depth.
    InverseDepth,
    /// One over the depth of the near plane.
    PerNear,
}

impl Meaning {
    /// One sentence for the comments of shaders and tables.
    pub const fn summary(self) -> &'static str {
        match self {
            Self::RowX => "Clip x of the tile, to the right.",
            Self::RowY => "Clip y of the tile, upwards.",
            Self::RowZ => "Clip z: depth along the light times w.",
            Self::RowW => "Clip w, positive on receivers.",
            Self::TexelFromNdc => "Map texel coordinates = clip space after division * xy + zw.",
            Self::TexelLimits => {
                "Smallest (xy) and largest (zw) map texel coordinates of the facet's receivers."
            }
            Self::DepthPerMetre => "Depth times w per metre away from the light.",
            Self::TexelMetresPerW => "Larger side of a texel across the light in metres, per w.",
            Self::ReceiverPlaneDepth => "Depth by which an exact receiver plane is lowered.",
            Self::TowardLight => "Unit vector towards the light, in the case's axes.",
            Self::Shear => {
                "What x and y gain per z by the shear along the light: twelve leading bits, then the rest."
            }
            Self::PixelMetres => "Metres that a screen pixel spans at a position's depth.",
            Self::DepthSign => "1 where stored depth grows away from the light, -1 where it falls.",
            Self::Clips => "Half-spaces that casters are cut with.",
            Self::AlphaCutoff => "Alpha below which the caster has a hole.",
            Self::Borders => "Border rows of the sectors, in walking order; the first closes the ring.",
            Self::Distances => "Distance row of each sector.",
            Self::Thresholds => {
                "Ascending band limits of each sector, four to a vector; unused ones are out of reach."
            }
            Self::GroundPlanes => "Planes with masks, as normals and offsets, in the case's axes.",
            Self::GroundTiles => {
                "Planes in tiles, four vectors each: depth, one over w, squared densities of texels along x and y."
            }
            Self::GroundEdges => "Edges of facets in tiles that they share, positive inside.",
            Self::Facets => "The facets: cell = (half * sectors + sector) * bands + band.",
            Self::RoundingDepth => "Depth by which an exact receiver plane is lowered for rounding.",
            Self::Remap => "How y/w becomes clip y: shifts and scales of a monotone curve.",
            Self::TileSize => "Width and height of the tile in texels.",
            Self::StretchTile => {
                "Smallest and largest k of the tile (xy), map texel of its upper left corner (zw)."
            }
            Self::LightPosition => "The light's position relative to the eye, in the case's axes.",
            Self::Split => "Plane through the light: receivers on its positive side walk the first half.",
            Self::Dominant => "Receivers near the dominant plane: first row in [-1, 1], second not negative.",
            Self::Units => "Rows that the limits of each sector are multiplied with.",
            Self::RayCorner => {
                "Direction through the image's upper left corner, depth 1, in the case's axes."
            }
            Self::RayAcross => "Change of that direction across the whole image.",
            Self::RayDown => "Change of that direction down the whole image.",
            Self::PerNear => "One over the near plane's depth in metres.",
            Self::InverseDepth => "One over the depth in metres = stored depth * x + y.",
        }
    }
}

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

impl CaseTable {
    /// The constant of a kind, if the case has one.
    pub fn constant(&self, kind: ConstantKind) -> Option<&Constant> {
        self.constants.iter().find(|constant| constant.kind == kind)
    }

    /// The record of a kind, if the case has one.
    pub fn record(&self, kind: RecordKind) -> Option<&Record> {
        self.records.iter().find(|record| record.kind == kind)
    }

    /// The bind group of a shader with a content, if the case has one.
    pub fn group(&self, shader: ShaderKind, content: GroupContent) -> Option<&BindGroup> {
        self.groups.iter().find(|group| group.shader == shader && group.content == content)
    }

    /// The pass that runs a shader, if the case has one.
    pub fn pass(&self, shader: ShaderKind) -> Option<&Pass> {
        self.passes.iter().find(|pass| pass.shader == shader)
    }

    /// The generated module of a kind, if there is one.
    pub fn shader(&self, kind: ShaderKind) -> Option<&Shader> {
        self.shaders.iter().find(|shader| shader.kind == kind)
    }

    /// Cells of the selection walk; the shadow record holds a facet for each.
    pub fn cells(&self) -> u32 {
        self.halves * self.sectors * self.bands + u32::from(self.dominant)
    }
}
