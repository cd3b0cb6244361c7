//! Distributions: how the rows of a column of the map are spent over depth. One file each; a distribution knows
//! nothing of the configuration that uses it.

mod bands;
mod folds;
mod logarithmic;
mod perspective;
mod two_segment;

pub use perspective::perspective_piece;
pub(crate) use perspective::push_back_metres;

use smallvec::SmallVec;

use crate::case::{LightCase, Stretch};
use crate::fit::Profile;
use crate::focus::Focus;
use crate::remap::Curve;
use crate::schema::{Arguments, Choice};

/// What the house knows about a distribution.
#[derive(Debug, Clone, Copy)]
pub struct DistributionSpec {
    /// Name, summary and parameters as declared.
    pub choice: Choice,
    /// Number of pieces that every column has.
    pub pieces: fn(&Arguments) -> u32,
    /// The remap that its rows need when they are bent; [`RemapKind::None`]: rows are never bent.
    pub bent: RemapKind,
    /// Whether its rows can do without bending.
    pub straight: bool,
    /// The pieces of one column, nearest first.
    pub split: fn(&Arguments, &DistanceRange) -> Pieces,
}

/// Families of remaps; the shaders of a case know one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RemapKind {
    /// Every facet is a homography.
    None,
    /// [`Curve::Perspective`] and [`Curve::Straight`].
    Perspective,
    /// [`Curve::Logarithmic`] and [`Curve::Straight`].
    Logarithmic,
}

/// Every distribution: the one place outside its own file that names it.
pub const DISTRIBUTIONS: &[DistributionSpec] =
    &[bands::SPEC, perspective::SPEC, logarithmic::SPEC, two_segment::SPEC];

/// Their declared names and parameters.
pub const CHOICES: &[Choice] = &choices();

const fn choices() -> [Choice; DISTRIBUTIONS.len()] {
    let mut choices = [DISTRIBUTIONS[0].choice; DISTRIBUTIONS.len()];
    let mut index = 0;
    while index < choices.len() {
        choices[index] = DISTRIBUTIONS[index].choice;
        index += 1;
    }
    choices
}

/// The distances that a column holds: values of a row that annihilates the light, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DistanceRange {
    /// Smallest distance of a receiver.
    pub nearest_metres: f64,
    /// Largest; may be infinite.
    pub farthest_metres: f64,
    /// How much nearer than the near plane the distance falls although receivers do not: distance + core is what
    /// screen size goes with.
    pub core_metres: f64,
    /// Near plane of the view where receivers begin beyond it because the light does not reach the eye; the density of
    /// rows over distance then stays what it would be without the gap.
    pub unlit_near_metres: Option<f64>,
    /// The eye's height above the ground, where it is known.
    pub eye_height_metres: Option<f64>,
    /// How often each distance + core is seen, where that is known.
    pub seen: Option<Profile>,
    /// Whether rows are bent by a remap where the distribution is continuous.
    pub bends: bool,
}

impl DistanceRange {
    /// The focus: where a declared share of what is seen lies before, or the declared distance where nothing is known.
    fn focus_metres(&self, arguments: &Arguments) -> f64 {
        let declared = Focus::of(arguments).metres(self.eye_height_metres);
        self.seen.map_or(declared, |seen| seen.quantile(perspective::share(arguments), declared))
    }
}

/// A part of a column. Straight ones are affine in 1 / (distance + push-back); bent ones go through a curve of
/// 1 / (distance + push-back).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Where it begins.
    pub nearest_metres: f64,
    /// Where it ends; may be infinite.
    pub farthest_metres: f64,
    /// Added to the distance for the divisor; infinite: rows are uniform.
    pub push_back_metres: f64,
    /// What 1 / (distance + push-back) goes through.
    pub curve: Curve,
    /// How much finer its texels are to be than those of weight 1.
    pub weight: f64,
    /// Distance beyond which its texels may grow with distance, because rows are spent before it; infinite: nowhere.
    pub focus_metres: f64,
}

/// The pieces of one column.
pub type Pieces = SmallVec<[Piece; 16]>;

/// Number of pieces in every column of a case.
pub fn pieces(case: &LightCase) -> u32 {
    let (spec, arguments) = of(case);
    (spec.pieces)(arguments)
}

/// The remap that the rows of a case need.
pub fn remap_kind(case: &LightCase) -> RemapKind {
    let (spec, _) = of(case);
    let bends = case.distribution.is_some() && case.stretch != Stretch::None;
    if bends { spec.bent } else { RemapKind::None }
}

/// Whether plans of a case need the eye's height.
pub fn needs_eye_height(case: &LightCase) -> bool {
    let words = case.distribution.iter().chain(&case.configurations);
    words.into_iter().any(|word| Focus::of(&word.arguments).needs_height())
}

/// The entry of a distribution's name.
pub fn spec(name: &str) -> Option<&'static DistributionSpec> {
    DISTRIBUTIONS.iter().find(|spec| spec.choice.name == name)
}

/// The pieces of one column of a case.
pub fn split(case: &LightCase, range: &DistanceRange) -> Pieces {
    let (spec, arguments) = of(case);
    (spec.split)(arguments, range)
}

/// The entry of a case's distribution; the first where it has none.
fn of(case: &LightCase) -> (&'static DistributionSpec, &Arguments) {
    static NONE: Arguments = Arguments(Vec::new());
    let word = case.distribution.as_ref();
    let spec = word.and_then(|word| spec(word.name));
    (spec.unwrap_or(&DISTRIBUTIONS[0]), word.map_or(&NONE, |word| &word.arguments))
}
