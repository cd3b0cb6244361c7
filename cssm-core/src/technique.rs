//! The name table of techniques: one file each, and nothing outside its file knows how one works.

pub mod bounding_box;
pub mod camera_space;
mod columns;
mod draft;
pub mod generalized_linear;
pub mod light_space_perspective;
pub mod logarithmic_perspective;
pub mod parallel_split;
pub mod perspective;
mod side_faces;
mod slabs;
pub mod stable_cascades;
pub mod standard;
pub mod trapezoidal;
mod warp;
pub mod warp_family;

pub(crate) use self::draft::NO_FACET;
pub use self::draft::{Draft, Drafts};
pub(crate) use self::standard::light_plane_axes;

use glam::{DVec2, DVec3, DVec4};
use smallvec::{SmallVec, smallvec};

use crate::case::{CaseError, LightCase, LightKind};
use crate::facet::{Cell, FacetShape};
use crate::fit::Sighted;
use crate::light::LightPosition;
use crate::plan::PlanError;
use crate::receivers::{BodyPlace, Polytope, extremes};
use crate::remap::Curve;
use crate::schema::{Choice, Word};
use crate::view::View;

/// What the house knows about a technique.
#[derive(Debug, Clone, Copy)]
pub struct TechniqueSpec {
    /// Name, summary and parameters as declared.
    pub choice: Choice,
    /// Configurations it can take.
    pub configurations: &'static [ConfigurationSpec],
    /// Names of the configurations that a declaration without any stands for, which together serve every position of a
    /// kind of light; empty where it serves none of that kind.
    pub default_configurations: fn(LightKind) -> &'static [&'static str],
    /// Default distribution in the declaration grammar; `None`: the technique takes none.
    pub distribution: Option<&'static str>,
    /// Whether it can fit receivers at infinity; if not, the case must bound them.
    pub fits_infinity: bool,
    /// Whether texels follow the eye, so that plans gain from depth stored reversed with the light ahead, and from
    /// positions sheared along the light.
    pub follows_camera: bool,
    /// Ways to declare it that are worth comparing, in the declaration grammar of the field `technique`; the first is the
    /// customary one.
    pub variants: &'static [&'static str],
    /// Contradictions between its parameters and the rest of the case.
    pub check: fn(&LightCase) -> Vec<CaseError>,
}

/// What the house knows about a configuration of a technique.
#[derive(Debug, Clone, Copy)]
pub struct ConfigurationSpec {
    /// Name, summary and parameters as declared.
    pub choice: Choice,
    /// Kinds of light that it can be declared for.
    pub lights: &'static [LightKind],
    /// Whether the case's distribution says how its rows are spent.
    pub takes_distribution: bool,
    /// Positions of the light that it is made for; elsewhere it answers as well as it can.
    pub serves: fn(LightPosition) -> bool,
    /// Facet shape of a case that declares it.
    pub shape: fn(&LightCase, &Word) -> FacetShape,
    /// Adds its facets in a situation, in one form or several to choose from.
    pub draft: fn(&Situation<'_>, &Word, &mut Drafts) -> Result<(), PlanError>,
}

/// Every technique: the one place outside its own file that names it.
pub const TECHNIQUES: &[TechniqueSpec] = &[
    standard::SPEC,
    bounding_box::SPEC,
    parallel_split::SPEC,
    stable_cascades::SPEC,
    trapezoidal::SPEC,
    light_space_perspective::SPEC,
    perspective::SPEC,
    generalized_linear::SPEC,
    warp_family::SPEC,
    logarithmic_perspective::SPEC,
    camera_space::SPEC,
];

/// Their declared names and parameters.
pub const CHOICES: &[Choice] = &choices();

/// Every configuration that some technique takes.
pub const CONFIGURATIONS: &[Choice] = &configurations();

const fn choices() -> [Choice; TECHNIQUES.len()] {
    let mut choices = [TECHNIQUES[0].choice; TECHNIQUES.len()];
    let mut index = 0;
    while index < choices.len() {
        choices[index] = TECHNIQUES[index].choice;
        index += 1;
    }
    choices
}

const fn configuration_count() -> usize {
    let (mut count, mut index) = (0, 0);
    while index < TECHNIQUES.len() {
        count += TECHNIQUES[index].configurations.len();
        index += 1;
    }
    count
}

const fn configurations() -> [Choice; configuration_count()] {
    let mut all = [TECHNIQUES[0].configurations[0].choice; configuration_count()];
    let (mut next, mut technique) = (0, 0);
    while technique < TECHNIQUES.len() {
        let own = TECHNIQUES[technique].configurations;
        let mut index = 0;
        while index < own.len() {
            all[next] = own[index].choice;
            next += 1;
            index += 1;
        }
        technique += 1;
    }
    all
}

/// The entry of a name that a checked case holds; an unknown name falls to the first entry.
pub fn spec(name: &str) -> &'static TechniqueSpec {
    TECHNIQUES.iter().find(|spec| spec.choice.name == name).unwrap_or(&TECHNIQUES[0])
}

/// Default configurations of a technique that serves directional lights with one configuration.
const fn only_directional(light: LightKind, name: &'static [&'static str]) -> &'static [&'static str] {
    match light {
        LightKind::Directional => name,
        LightKind::Spot | LightKind::Omni => &[],
    }
}

impl FacetDraft {
    /// Whether it is the facet of receivers near a dominant plane.
    pub fn is_dominant(&self) -> bool {
        self.cells.is_empty()
    }

    /// A facet of one cell whose rows are not bent; its receivers are told when it is added to a draft.
    pub fn straight(cell: Cell, [x, y, w]: [DVec4; 3], select: Sides, region: Region) -> Self {
        let receivers = BodyPlace::default();
        Self { cells: smallvec![cell], x, y, curve: Curve::Straight, w, select, receivers, region }
    }
}

impl Cell {
    /// The first cell of a walk.
    pub const FIRST: Self = Self { half: 0, sector: 0, band: 0 };

    /// A sector's cell in the first half of a walk.
    pub const fn of(sector: u32, band: u32) -> Self {
        Self { half: 0, sector, band }
    }
}

impl TechniqueSpec {
    /// Names of the configurations that are made for a position of the light.
    pub fn made_for(&self, light: LightKind, position: LightPosition) -> impl Iterator<Item = &'static str> {
        let known = self.configurations.iter().filter(move |known| known.lights.contains(&light));
        known.filter(move |known| (known.serves)(position)).map(|known| known.choice.name)
    }

    /// Names of the configurations for a kind of light.
    pub fn serving(&self, light: LightKind) -> impl Iterator<Item = &'static str> {
        let serving = self.configurations.iter().filter(move |known| known.lights.contains(&light));
        serving.map(|known| known.choice.name)
    }

    /// The entry of a configuration; an unknown name falls to the first entry.
    pub fn configuration(&self, name: &str) -> &'static ConfigurationSpec {
        self.configurations.iter().find(|spec| spec.choice.name == name).unwrap_or(&self.configurations[0])
    }
}

/// What a technique sees of a frame, in camera space (right-handed, x right, y up, looking along -z).
#[derive(Debug)]
pub struct Situation<'a> {
    /// The declaration.
    pub case: &'a LightCase,
    /// The view; its far plane is no farther than shadows reach. Its place and rotation matter only to techniques that
    /// hold texels still in the world.
    pub view: &'a View,
    /// Width and height in texels of the part of the map that the facets share.
    pub map_size_texels: (u32, u32),
    /// The light as a homogeneous point: unit direction towards it, w = 0; position of a local light, w = 1.
    pub light: DVec4,
    /// Axis of a spot light's cone, away from the light.
    pub cone: Option<Cone>,
    /// The eye's height above the ground, where it is known.
    pub eye_height_metres: Option<f64>,
    /// Everything visible that may be in shadow.
    pub receivers: Polytope,
    /// Corners of the receivers' bounding volumes, as far as they are visible; empty where none were given.
    pub seen: Vec<DVec4>,
    /// What is known of what is seen, as far as the case's fit takes it.
    pub sighted: Sighted,
}

impl Situation<'_> {
    /// Points whose convex hull holds everything that is seen: corners of the receivers' bounding volumes, or else of
    /// the visible polytope.
    pub fn seen(&self) -> &[DVec4] {
        if self.seen.is_empty() { &self.receivers.vertices } else { &self.seen }
    }

    /// A tile of a declared size, which is meant for the whole map, in the part of it that the facets share.
    fn tile_size(&self, (width, height): (u32, u32)) -> (u32, u32) {
        let map = self.case.map;
        let scaled = |side: u32, part: u32, whole: u32| {
            u32::try_from(u64::from(side) * u64::from(part) / u64::from(whole.max(1))).unwrap_or(side)
        };
        let (part_width, part_height) = self.map_size_texels;
        (scaled(width, part_width, map.width), scaled(height, part_height, map.height))
    }
}

/// Half-spaces that hold some points in a facet's x/w and y/w; each contains the light.
fn enclosing(rows: &[DVec4; 3], points: &[DVec4]) -> Sides {
    let [x, y, w] = *rows;
    let limits = |row: DVec4| {
        let ratios = points.iter().filter_map(|point| {
            let scale = w.dot(*point);
            (scale > 0.0).then(|| row.dot(*point) / scale)
        });
        let (low, high) = extremes(ratios);
        [row - w * low, w * high - row]
    };
    let sides: Sides = [x, y].into_iter().flat_map(limits).collect();
    if sides.iter().all(|side| side.is_finite()) { sides } else { Sides::new() }
}

/// Cone of a spot light, in camera space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Unit vector along its axis, away from the light.
    pub direction: DVec3,
    /// Angle between axis and edge, radians.
    pub half_angle_radians: f64,
}

/// How far a technique gives way near a situation that it has no answer for; it does so continuously, so that nothing pops.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fallback {
    /// What it gives way to.
    pub to: &'static str,
    /// What it has no answer for.
    pub why: &'static str,
    /// 0: not at all; 1: altogether.
    pub share: f64,
}

impl Fallback {
    /// A fallback, if there is anything of it.
    pub(crate) fn of(to: &'static str, why: &'static str, share: f64) -> Option<Self> {
        (share > 0.0).then_some(Self { to, why, share })
    }
}

/// Half-spaces, few.
pub type Sides = SmallVec<[DVec4; 6]>;

/// A facet before its window is fitted.
#[derive(Debug, Clone)]
pub struct FacetDraft {
    /// Cells of the selection whose receivers are its own; none: those near the dominant plane.
    pub cells: SmallVec<[Cell; 4]>,
    /// Across; annihilates the light.
    pub x: DVec4,
    /// Up the tile; annihilates the light. Where rows are bent, y/w is 1 / distance.
    pub y: DVec4,
    /// What y/w goes through; [`Curve::Straight`] where rows are not bent.
    pub curve: Curve,
    /// Divisor, positive on receivers; annihilates the light.
    pub w: DVec4,
    /// Half-spaces of its own receivers.
    pub select: Sides,
    /// Its own receivers, in the draft that it belongs to.
    pub receivers: BodyPlace,
    /// Where it lies in the map.
    pub region: Region,
}

/// Where a facet lies in the map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Region {
    /// A tile of its own; the rows x and y are fitted to it, whatever affine change that takes.
    Tile(TileRequest),
    /// A tile of its own that shows the clip space of its rows from -1 to 1, whatever of it holds receivers.
    Whole(TileRequest),
    /// A triangle of a tile that it shares with every facet that names the same square.
    Triangle {
        /// Number of the square in the draft.
        square: u32,
        /// How much of the map the square asks for; equal for all its facets.
        request: TileRequest,
        /// The triangle in the square's clip space, counter-clockwise; the rows take receivers into it. The edge
        /// from the second to the third corner lies on the square's border, the others are shared.
        corners: [DVec2; 3],
    },
}

/// How much of the map a facet asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TileRequest {
    /// As many texels as make its footprint equal to the others'.
    Footprint,
    /// The same with a footprint so many times the others', which may grow with depth beyond a focus.
    Coarser {
        /// How many times.
        times: f64,
        /// Depth of the focus; infinite: there is none.
        focus_metres: f64,
    },
    /// A share of the map, as square as can be.
    Share(f64),
    /// Width and height in texels.
    Fixed(u32, u32),
}
