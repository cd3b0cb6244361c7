//! The name table of techniques: one file each, and nothing outside its file knows how one works.

pub mod camera_space;
pub mod parallel_split;
pub mod standard;

use glam::{DVec2, DVec4};

use crate::case::{CaseError, LightCase};
use crate::facet::{FacetShape, Selection};
use crate::light::LightPosition;
use crate::plan::PlanError;
use crate::receivers::Polytope;
use crate::schema::{Choice, Word};
use crate::view::View;

/// What the house knows about a technique.
#[derive(Debug, Clone, Copy)]
pub struct TechniqueSpec {
    /// Name, summary and parameters as declared.
    pub choice: Choice,
    /// Configurations it can take, default first.
    pub configurations: &'static [ConfigurationSpec],
    /// Default distribution in the declaration grammar; `None`: the technique takes none.
    pub distribution: Option<&'static str>,
    /// Whether it can fit receivers at infinity; if not, the case must bound them.
    pub fits_infinity: bool,
    /// Whether texels follow the eye, so that plans gain from depth stored reversed with the light ahead, and from
    /// positions sheared along the light.
    pub follows_camera: bool,
    /// Contradictions between its parameters and the rest of the case.
    pub check: fn(&LightCase) -> Vec<CaseError>,
}

/// What the house knows about a configuration of a technique.
#[derive(Debug, Clone, Copy)]
pub struct ConfigurationSpec {
    /// Name, summary and parameters as declared.
    pub choice: Choice,
    /// Whether the case's distribution says how its rows are spent.
    pub takes_distribution: bool,
    /// Positions of the light that it is made for; elsewhere it answers as well as it can.
    pub serves: fn(LightPosition) -> bool,
    /// Facet shape of a case that declares it.
    pub shape: fn(&LightCase, &Word) -> FacetShape,
    /// Its facets in a situation, in one form or several to choose from.
    pub draft: fn(&Situation<'_>, &Word) -> Result<Vec<Draft>, PlanError>,
}

/// Every technique: the one place outside its own file that names it.
pub const TECHNIQUES: &[TechniqueSpec] = &[standard::SPEC, parallel_split::SPEC, camera_space::SPEC];

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

impl TechniqueSpec {
    /// Names of the configurations that are made for a position of the light.
    pub fn made_for(&self, position: LightPosition) -> impl Iterator<Item = &'static str> {
        let serving = self.configurations.iter().filter(move |known| (known.serves)(position));
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
    /// The view; only its projection is meaningful here.
    pub view: &'a View,
    /// The light as a homogeneous point: unit direction towards it, w = 0.
    pub light: DVec4,
    /// Everything visible that may be in shadow.
    pub receivers: Polytope,
}

/// What a technique answers: the walk and the facets, before tiles, depth rows and windows are found.
#[derive(Debug)]
pub struct Draft {
    /// Chosen configuration.
    pub configuration: &'static str,
    /// Which of the configuration's forms this is; empty where it has one.
    pub form: &'static str,
    /// The walk from a receiver to its facet.
    pub selection: Selection,
    /// The facets.
    pub facets: Vec<FacetDraft>,
}

/// A facet before its window is fitted.
#[derive(Debug)]
pub struct FacetDraft {
    /// Sector of the selection.
    pub sector: u32,
    /// Band within the sector.
    pub band: u32,
    /// Across; annihilates the light.
    pub x: DVec4,
    /// Up the tile; annihilates the light.
    pub y: DVec4,
    /// Divisor, positive on receivers; annihilates the light.
    pub w: DVec4,
    /// Half-spaces of its own receivers.
    pub select: Vec<DVec4>,
    /// Its own receivers.
    pub receivers: Polytope,
    /// Where it lies in the map.
    pub region: Region,
}

/// Where a facet lies in the map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Region {
    /// A tile of its own; the rows x and y are fitted to it, whatever affine change that takes.
    Tile(TileRequest),
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
    /// A share of the map, as square as can be.
    Share(f64),
    /// Width and height in texels.
    Fixed(u32, u32),
}
