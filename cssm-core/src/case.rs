//! The light case: what is declared once, before any frame.
//!
//! A [`LightCase`] says which light, which views, which technique in which configurations, how the map is laid
//! out and filtered, how bias is found and which interfaces the shaders offer. It is plain, checked data: every
//! door (text, macro, build script, builder) ends in [`LightCase::from_arguments`], so equal declarations are
//! equal values and generate equal bytes.

mod arguments;
mod builder;
mod check;
mod fields;
mod filter;
mod names;

pub use builder::LightCaseBuilder;
pub use fields::{FIELDS, MAP_SIDE_LIMIT_TEXELS};
pub use filter::{Filter, Kernel, MOST_GROUND_PLANES, PcfSize, Source};

use crate::distribution::{self, RemapKind};
use crate::facet::FacetShape;
use crate::schema::{Arguments, Word};
use crate::technique::{self, TechniqueSpec};

/// A checked declaration.
#[derive(Debug, Clone, PartialEq)]
pub struct LightCase {
    /// Name in upper camel case; names the generated Rust module's case and the report rows.
    pub name: String,
    /// Doc comment of the declaration, without the leading slashes; may be empty.
    pub doc: String,
    /// Whether the generated Rust items are `pub`.
    pub public: bool,
    /// The light.
    pub light: LightKind,
    /// How far views reach.
    pub far: FarKind,
    /// Farthest receiver depth in metres, if the declaration bounds it.
    pub shadow_distance_metres: Option<f64>,
    /// Whether every plan is promised finite scene bounds; a plan without them is then a typed error.
    pub scene_bounds: bool,
    /// Technique and its parameters; the name is in [`technique::TECHNIQUES`].
    pub technique: Word,
    /// Configurations that may be chosen, best first; names of the technique's own table.
    pub configurations: Vec<Word>,
    /// How map rows are spent over depth; absent where the technique has no such choice.
    pub distribution: Option<Word>,
    /// How casters are drawn where the distribution bends rows.
    pub stretch: Stretch,
    /// Facets of their own for receivers near a plane.
    pub dominant_plane: Option<DominantPlane>,
    /// What facets are fitted to beside the view.
    pub fit: Fit,
    /// How texels are kept where they are while the camera moves.
    pub stability: Stability,
    /// The map.
    pub map: MapSpec,
    /// How the map is filtered.
    pub filter: Filter,
    /// How bias is found.
    pub bias: Bias,
    /// What the engine's casters are.
    pub casters: Casters,
    /// Axes in which the shaders take positions and normals.
    pub axes: Axes,
    /// Interfaces that the shaders offer.
    pub resolve: Vec<Resolve>,
    /// Lower snake case prefix of every emitted shader name; never ends in a digit.
    pub prefix: String,
}

/// Kinds of light.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LightKind {
    /// Parallel rays.
    Directional,
    /// Rays from a point within a cone.
    Spot,
    /// Rays from a point to all sides.
    Omni,
}

impl LightKind {
    /// Name in declarations, tables and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Directional => "directional",
            Self::Spot => "spot",
            Self::Omni => "omni",
        }
    }

    /// Whether rays begin at a point.
    pub const fn is_local(self) -> bool {
        !matches!(self, Self::Directional)
    }
}

/// How casters are drawn where the distribution bends rows (camera space shadow maps, section 4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stretch {
    /// Rows are not bent: every facet is a homography.
    None,
    /// Only triangle corners are bent; edges between them stay straight.
    Vertex,
    /// Triangles whose straight edges would miss the bent ones by more than the bound are decided pixel by pixel.
    Exact {
        /// The bound.
        bound_texels: f64,
    },
}

/// Receivers near a plane get one texel for each of their pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DominantPlane {
    /// Share of the map that is set aside.
    pub share: f64,
    /// Distance from the plane, to either side, within which receivers count as on it.
    pub thickness_metres: f64,
}

/// What facets are fitted to beside the view; each stage takes what the earlier ones take, as far as a plan is given it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fit {
    /// The view and the scene's bounds alone.
    None,
    /// Bounding volumes of what is visible this frame.
    Bounds,
    /// Also the smallest and the largest visible depth.
    DepthMinMax,
    /// Also how many pixels see each depth.
    Histogram,
}

impl Fit {
    /// Name in declarations, tables and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Bounds => "bounds",
            Self::DepthMinMax => "depth_min_max",
            Self::Histogram => "histogram",
        }
    }

    /// Whether the engine's depth is measured.
    pub const fn measures_depth(self) -> bool {
        matches!(self, Self::DepthMinMax | Self::Histogram)
    }
}

/// How texels are kept where they are while the camera moves, so that shadows' edges do not flicker. All plans of a case
/// are functions of their request alone: the same view has the same texels whatever was seen before.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Stability {
    /// Every plan fits its view as well as it can.
    #[default]
    None,
    /// Facets that are linear keep texels of one size on a lattice that is fixed in the world: whole texels come and go
    /// at their edges. Facets that bend or converge are fitted as without.
    Snapped,
    /// Plans are made for the nearest of a lattice of views, wide enough for all views near it: between two of them
    /// nothing in the map changes.
    Quantised {
        /// Pitch of the lattice of eyes, metres.
        move_metres: f64,
        /// Pitch of the lattice of orientations, degrees.
        turn_degrees: f64,
    },
}

impl Stability {
    /// Name in declarations, tables and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Snapped => "snapped",
            Self::Quantised { .. } => "quantised",
        }
    }
}

/// How far the views of a case reach.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FarKind {
    /// The far plane may be at infinity.
    Infinite,
    /// Every view has a finite far plane; a view without one is a typed error at plan time.
    Finite,
}

/// Size, folding, format and gutters of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MapSpec {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Number of strips the tiles are folded into; `None`: found by the isotropy rule.
    pub columns: Option<u32>,
    /// Texel format.
    pub format: DepthFormat,
    /// Gutter of every tile in texels; `None`: filter radius + 1.
    pub gutter: Option<u32>,
}

/// Texel formats of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DepthFormat {
    /// 32-bit float.
    Depth32Float,
    /// 16-bit unsigned normalised.
    Depth16Unorm,
}

impl DepthFormat {
    /// Name in declarations, tables and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Depth32Float => "depth32float",
            Self::Depth16Unorm => "depth16unorm",
        }
    }

    /// Bytes of one texel.
    pub const fn bytes_per_texel(self) -> u32 {
        match self {
            Self::Depth32Float => 4,
            Self::Depth16Unorm => 2,
        }
    }

    /// Largest rounding error of a stored depth in [0, 1].
    pub const fn rounding(self) -> f64 {
        match self {
            Self::Depth32Float => 5.960_464_477_539_063e-8,
            Self::Depth16Unorm => 0.5 / 65535.0,
        }
    }
}

/// How the depth reference is kept off the receiver's own texels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bias {
    /// No bias.
    None,
    /// A constant distance along the light.
    Constant {
        /// Metres along the light.
        along_light_metres: f64,
    },
    /// Proportional to the texel and the tangent of the angle between normal and light.
    Slope {
        /// Multiple of the local texel.
        texels: f64,
    },
    /// A world distance plus a multiple of the local texel ("Perspective Shadow Maps: Care and Feeding").
    WorldTexel {
        /// Constant part, metres along the light.
        a_metres: f64,
        /// Part that scales with the local texel, in texels.
        b_texels: f64,
    },
    /// Exact receiver plane of the facet; no knob.
    ReceiverPlane,
}

impl Bias {
    /// Name in declarations, tables and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Constant { .. } => "constant",
            Self::Slope { .. } => "slope",
            Self::WorldTexel { .. } => "world_texel",
            Self::ReceiverPlane => "receiver_plane",
        }
    }
}

/// What the engine's casters are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Casters {
    /// Triangles alone.
    Opaque,
    /// Triangles, some of which are cut out by the alpha channel of a texture.
    AlphaTested,
}

impl Casters {
    /// Name in declarations, tables and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Opaque => "opaque",
            Self::AlphaTested => "alpha_tested",
        }
    }
}

/// Axes of positions and normals in the resolve shaders; positions are always relative to the eye, in metres.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axes {
    /// The camera's: x right, y up, looking along -z. Coordinates across the view are small, so f32 holds them best.
    Camera,
    /// The world's.
    World,
}

impl Axes {
    /// Name in declarations, tables and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::World => "world",
        }
    }
}

/// An interface of the resolve stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Resolve {
    /// A screen-space pass that turns the view's depth into a visibility mask.
    Mask {
        /// What the engine's depth holds.
        depth: MaskDepth,
        /// Where the geometric normal comes from.
        normal: MaskNormal,
    },
    /// A WGSL function that the engine calls from its own material.
    Function {
        /// Bind group number of the shadow bindings.
        group: u32,
        /// Number of the first of them, so that they can live in a group of the engine's.
        first_binding: u32,
    },
}

/// What the engine's depth texture holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MaskDepth {
    /// near / depth in a depth texture: 1 at the near plane, 0 at infinity (or the finite-far equivalent).
    ReversedZ,
    /// Depth along the view axis in metres in a single-channel float texture; 0 or less is sky.
    Linear,
}

/// Where the mask pass takes the geometric normal from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MaskNormal {
    /// Reconstructed from neighbouring depths.
    Reconstructed,
    /// Read from a float texture with unit normals in the case's axes.
    Texture,
}

impl LightCase {
    /// Starts a declaration in Rust; every field has the default of the text grammar.
    pub fn builder(name: &str) -> LightCaseBuilder {
        LightCaseBuilder::new(name)
    }

    /// Builds a case from checked arguments of [`FIELDS`].
    ///
    /// # Errors
    /// All contradictions between fields at once, each naming the field it belongs to.
    pub fn from_arguments(
        name: &str,
        doc: &str,
        public: bool,
        arguments: &Arguments,
    ) -> Result<Self, Vec<CaseError>> {
        check::from_arguments(name, doc, public, arguments)
    }

    /// The technique's entry in the name table.
    pub fn technique_spec(&self) -> &'static TechniqueSpec {
        technique::spec(self.technique.name)
    }

    /// How many facets a plan of this case may have, and how a receiver finds its own.
    pub fn shape(&self) -> FacetShape {
        let spec = self.technique_spec();
        let one = |word: &Word| (spec.configuration(word.name).shape)(self, word);
        let dominant = FacetShape { dominant: self.dominant_plane.is_some(), ..FacetShape::ONE };
        self.configurations.iter().fold(dominant, |shape, word| shape.max(one(word)))
    }

    /// The remap that the shaders of this case know.
    pub fn remap(&self) -> RemapKind {
        distribution::remap_kind(self)
    }

    /// Whether plans may store depth falling away from the light; see [`crate::plan::DepthOrder`].
    pub fn may_reverse_depth(&self) -> bool {
        self.technique_spec().follows_camera || self.light.is_local()
    }

    /// Whether band limits are multiples of a row of each sector's own; see [`crate::facet::Selection::units`].
    pub fn scales_thresholds(&self) -> bool {
        let spec = self.technique_spec();
        let spends = |word: &Word| spec.configuration(word.name).takes_distribution;
        let spread = self.configurations.iter().any(spends) && distribution::pieces(self) > 1;
        self.light.is_local() && spread
    }

    /// Whether the resolve shaders shear positions along the light; see [`crate::ShadowPlan::shear`].
    pub fn shears(&self) -> bool {
        self.axes == Axes::Camera && self.technique_spec().follows_camera
    }

    /// Gutter of every tile in texels.
    pub fn gutter_texels(&self) -> u32 {
        self.map.gutter.unwrap_or(self.filter.radius_texels() + 1)
    }
}

impl CaseError {
    /// Other fields that a contradiction at this field involves, as top-level names.
    pub fn related(&self) -> &'static [&'static str] {
        check::related(&self.field)
    }
}

/// A declaration that cannot be honoured.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{field}: {message}; {remedy}")]
pub struct CaseError {
    /// Dotted path of the field at fault, such as `map.size`.
    pub field: String,
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub remedy: String,
}
