//! How texels become visibility: the filters and the widths of their kernels.

mod fields;

pub(super) use fields::FILTERS;

use super::LightKind;
use crate::schema::{Value, Word};

/// Most planes that have masks of their own: channels of a texel.
pub const MOST_GROUND_PLANES: usize = 4;

/// How texels become visibility.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Filter {
    /// Nearest texel, hard edge.
    None,
    /// Comparison sampler with linear filtering: one reference for four texels.
    Hardware2x2,
    /// Gather of four texels, each compared with its own reference, blended bilinearly.
    Gather2x2,
    /// Every texel that a box around the receiver touches, each compared with its own reference and weighed by its exact
    /// overlap with the box.
    Pcf {
        /// Widest the box may be.
        size: PcfSize,
        /// How wide it is.
        kernel: Kernel,
    },
    /// A box as wide as the edge of the shadow that a light with an extent throws, by the distance between the receiver and
    /// the casters around it (percentage-closer soft shadows, Fernando 2005), all in metres, whatever the facet's warp.
    Pcss {
        /// Extent of the light.
        source: Source,
        /// Half the widest box, for the search of casters and for the edge alike.
        reach_texels: u32,
    },
    /// Mean and mean square of exponentially warped depths, blurred ahead of resolving; what they say of the share of
    /// casters before the receiver is its shadow (exponential variance shadow maps, Lauritzen and McCool 2008, with the
    /// positive exponent alone). The moments bound the share of light from above: a receiver narrower than the kernel,
    /// with far surfaces beside it, such as a leaf before the ground, may be lit where `Pcf` shades it.
    ///
    /// For directional lights alone. Depth from a local light runs with one over the distance from it, and begins close to
    /// it, so that receivers at any distance have one: a metre where receivers are is next to nothing of the whole depth,
    /// and no exponent that f32 can hold tells casters and receivers apart there. To begin farther away would leave
    /// receivers near the light without shadows.
    Evsm2 {
        /// Exponent over a facet's whole depth.
        exponent: f64,
        /// Texels to either side that moments are blurred over, within the tile.
        blur_texels: u32,
        /// Share of light below which a receiver counts as dark: takes away light that leaks from one caster to another.
        bleeding: f64,
    },
    /// For receivers on a few planes that shadow nothing on themselves, such as ground, floor and walls: where something
    /// stands between the light and a plane, blurred severely ahead of resolving and read by one bilinear fetch
    /// (Kozlov, perspective shadow maps: care and feeding, 2004, section 14.3.2). Such receivers compare no depth and
    /// need no bias; all others are filtered as by [`Self::Gather2x2`]. The planes come with the scene bounds of each plan
    /// ([`crate::SceneBounds::ground_planes`]). A plane is endless: where it runs on beneath another surface, as a wall does
    /// beneath the ground, it is covered, and the blur brings some of that shade to its foot.
    ///
    /// Which plane a receiver lies on is told by its distance from them, within what f32 may have moved it
    /// ([`crate::ground::ROUNDING`]): the mask pass knows no more of a pixel than its position, and a material needs to
    /// pass nothing.
    GroundMasks {
        /// Planes, 1 to 4, each with a channel of its own.
        planes: u32,
        /// Standard deviation of the Gaussian in metres on the plane: a straight edge goes from 10 to 90 percent of
        /// light within 2.56 of them. At least half a texel, at most 0.4 of the reach.
        blur_metres: f64,
        /// Texels to either side that the Gaussian is cut off at.
        reach_texels: u32,
    },
}

/// Extent of a light that throws soft shadows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Source {
    /// Angular diameter of a directional light in degrees; the sun's is 0.53.
    Angle(f64),
    /// Radius of a local light in metres.
    Radius(f64),
}

impl Source {
    /// Radius of the light: at a metre's distance for a directional light, in metres for a local one.
    pub fn radius(self) -> f64 {
        match self {
            Self::Angle(degrees) => libm::tan(0.5 * degrees.to_radians()),
            Self::Radius(metres) => metres,
        }
    }
}

/// Widest boxes of [`Filter::Pcf`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PcfSize {
    /// 3 x 3 texels, four gathers.
    Three,
    /// 5 x 5 texels, nine gathers.
    Five,
    /// 7 x 7 texels, sixteen gathers.
    Seven,
}

impl PcfSize {
    /// Every size.
    pub const ALL: [Self; 3] = [Self::Three, Self::Five, Self::Seven];

    /// Texels along each side.
    pub const fn texels(self) -> u32 {
        match self {
            Self::Three => 3,
            Self::Five => 5,
            Self::Seven => 7,
        }
    }
}

/// How wide a box is, along each axis of the map by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kernel {
    /// As many texels as the filter takes: its shadows are the softer the coarser the map.
    Texels,
    /// A distance across the light: the softness belongs to the scene, whatever facet a receiver has. At least a texel, at
    /// most what the filter takes.
    Metres(f64),
    /// A distance across the light that spans so many screen pixels at the receiver's depth. At least a texel, at most
    /// what the filter takes.
    Pixels(f64),
}

impl Filter {
    /// Name in declarations, tables and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Hardware2x2 => "hardware_2x2",
            Self::Gather2x2 => "gather_2x2",
            Self::Pcf { size: PcfSize::Three, .. } => "pcf_3x3",
            Self::Pcf { size: PcfSize::Five, .. } => "pcf_5x5",
            Self::Pcf { size: PcfSize::Seven, .. } => "pcf_7x7",
            Self::Pcss { .. } => "pcss",
            Self::Evsm2 { .. } => "evsm_2",
            Self::GroundMasks { .. } => "ground_masks",
        }
    }

    /// Distance in texels, rounded up, from a receiver to the farthest point of the map that its visibility depends on:
    /// half the widest kernel.
    pub const fn radius_texels(self) -> u32 {
        match self {
            Self::None => 0,
            Self::Hardware2x2 | Self::Gather2x2 => 1,
            Self::Pcf { size, .. } => size.texels().div_ceil(2),
            Self::Pcss { reach_texels, .. } => reach_texels,
            Self::Evsm2 { blur_texels, .. } => blur_texels + 1,
            Self::GroundMasks { reach_texels, .. } => reach_texels + 1,
        }
    }

    /// Texels along each axis that the visibility of one receiver may depend on.
    pub const fn texels_across(self) -> u32 {
        match self {
            Self::None => 1,
            Self::Hardware2x2 | Self::Gather2x2 => 2,
            Self::Pcf { size, .. } => size.texels() + 1,
            Self::Pcss { reach_texels, .. } => 2 * reach_texels + 1,
            Self::Evsm2 { blur_texels, .. } => 2 * blur_texels + 2,
            Self::GroundMasks { reach_texels, .. } => 2 * reach_texels + 2,
        }
    }

    /// Whether the map is filtered ahead of resolving.
    pub const fn is_prefiltered(self) -> bool {
        matches!(self, Self::Evsm2 { .. } | Self::GroundMasks { .. })
    }

    /// Planes with masks of their own.
    pub const fn ground_planes(self) -> u32 {
        match self {
            Self::GroundMasks { planes, .. } => planes,
            _ => 0,
        }
    }

    /// Whether the filter has a kernel of a width that it finds receiver by receiver.
    pub const fn is_wide(self) -> bool {
        matches!(self, Self::Pcf { .. } | Self::Pcss { .. })
    }

    /// Whether the kernel's width is a distance, so that the filter must know how large texels are.
    pub const fn measures_texels(self) -> bool {
        matches!(self, Self::Pcf { kernel: Kernel::Metres(_) | Kernel::Pixels(_), .. } | Self::Pcss { .. })
    }

    /// Whether the filter must know how deep a metre along the light is.
    pub const fn measures_depth(self) -> bool {
        matches!(self, Self::Pcss { .. })
    }

    /// Whether the kernel's width is a number of screen pixels.
    pub const fn measures_pixels(self) -> bool {
        matches!(self, Self::Pcf { kernel: Kernel::Pixels(_), .. })
    }

    pub(super) fn word(self) -> Word {
        match self {
            Self::Pcf { kernel, .. } => Word::with(self.name(), [("kernel", Value::Word(kernel.word()))]),
            Self::Pcss { source, reach_texels } => {
                let source = match source {
                    Source::Angle(degrees) => ("angle", Value::Number(degrees)),
                    Source::Radius(metres) => ("radius", Value::Number(metres)),
                };
                Word::with(self.name(), [source, ("reach", Value::Count(reach_texels))])
            }
            Self::Evsm2 { exponent, blur_texels, bleeding } => {
                let arguments = [
                    ("exponent", Value::Number(exponent)),
                    ("blur", Value::Count(blur_texels)),
                    ("bleeding", Value::Number(bleeding)),
                ];
                Word::with(self.name(), arguments)
            }
            Self::GroundMasks { planes, blur_metres, reach_texels } => {
                let arguments = [
                    ("planes", Value::Count(planes)),
                    ("blur", Value::Number(blur_metres)),
                    ("reach", Value::Count(reach_texels)),
                ];
                Word::with(self.name(), arguments)
            }
            Self::None | Self::Hardware2x2 | Self::Gather2x2 => Word::plain(self.name()),
        }
    }

    /// Reads a word whose defaults are filled in, for a kind of light.
    pub(super) fn of_word(word: Option<&Word>, light: LightKind) -> Self {
        let Some(word) = word else { return Self::Gather2x2 };
        let pcf = |size| Self::Pcf { size, kernel: Kernel::of_word(word.arguments.word("kernel")) };
        match word.name {
            "none" => Self::None,
            "hardware_2x2" => Self::Hardware2x2,
            "pcf_3x3" => pcf(PcfSize::Three),
            "pcf_5x5" => pcf(PcfSize::Five),
            "pcf_7x7" => pcf(PcfSize::Seven),
            "evsm_2" => Self::Evsm2 {
                exponent: word.arguments.number("exponent").unwrap_or(1.0),
                blur_texels: word.arguments.count("blur").unwrap_or(0),
                bleeding: word.arguments.number("bleeding").unwrap_or(0.0),
            },
            "ground_masks" => Self::GroundMasks {
                planes: word.arguments.count("planes").unwrap_or(1),
                blur_metres: word.arguments.number("blur").unwrap_or(0.0),
                reach_texels: word.arguments.count("reach").unwrap_or(1),
            },
            "pcss" => {
                let number = |name: &str| word.arguments.number(name);
                let source = if light.is_local() {
                    Source::Radius(number("radius").unwrap_or(DEFAULT_RADIUS_METRES))
                } else {
                    Source::Angle(number("angle").unwrap_or(DEFAULT_ANGLE_DEGREES))
                };
                let reach_texels = word.arguments.count("reach").unwrap_or(DEFAULT_REACH_TEXELS);
                Self::Pcss { source, reach_texels }
            }
            _ => Self::Gather2x2,
        }
    }
}

/// The extent of a light that a declared word gives although the light is of another kind: name, and what to write.
pub(super) fn misplaced_extent(
    word: Option<&Word>,
    light: LightKind,
) -> Option<(&'static str, &'static str)> {
    let arguments = &word.filter(|word| word.name == "pcss")?.arguments;
    let (misplaced, instead) = if light.is_local() { ("angle", "radius") } else { ("radius", "angle") };
    arguments.get(misplaced).map(|_| (misplaced, instead))
}

/// Angular diameter where a declaration holds none: the sun's.
const DEFAULT_ANGLE_DEGREES: f64 = 0.53;
/// Radius where a declaration holds none.
const DEFAULT_RADIUS_METRES: f64 = 0.05;
/// Reach where a declaration holds none.
const DEFAULT_REACH_TEXELS: u32 = 5;

impl Kernel {
    fn word(self) -> Word {
        match self {
            Self::Texels => Word::plain("texels"),
            Self::Metres(width) => Word::with("metres", [("width", Value::Number(width))]),
            Self::Pixels(width) => Word::with("pixels", [("width", Value::Number(width))]),
        }
    }

    fn of_word(word: Option<&Word>) -> Self {
        let width = |word: &Word| word.arguments.number("width").unwrap_or(0.0);
        match word {
            Some(word) if word.name == "metres" => Self::Metres(width(word)),
            Some(word) if word.name == "pixels" => Self::Pixels(width(word)),
            _ => Self::Texels,
        }
    }
}
