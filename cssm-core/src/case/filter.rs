//! How texels become visibility: the filters and the widths of their kernels.

use crate::schema::{Choice, Default, Field, Kind, Unit, Value, Word};

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
        }
    }

    /// Distance in texels, rounded up, from a receiver to the farthest point of the map that its visibility depends on:
    /// half the widest kernel.
    pub const fn radius_texels(self) -> u32 {
        match self {
            Self::None => 0,
            Self::Hardware2x2 | Self::Gather2x2 => 1,
            Self::Pcf { size, .. } => size.texels().div_ceil(2),
        }
    }

    /// Texels along each axis that the visibility of one receiver may depend on.
    pub const fn texels_across(self) -> u32 {
        match self {
            Self::None => 1,
            Self::Hardware2x2 | Self::Gather2x2 => 2,
            Self::Pcf { size, .. } => size.texels() + 1,
        }
    }

    /// Whether the filter has a kernel of a width that it finds receiver by receiver.
    pub const fn is_wide(self) -> bool {
        matches!(self, Self::Pcf { .. })
    }

    /// Whether the kernel's width is a distance, so that the filter must know how large texels are.
    pub const fn measures_texels(self) -> bool {
        matches!(self, Self::Pcf { kernel: Kernel::Metres(_) | Kernel::Pixels(_), .. })
    }

    /// Whether the kernel's width is a number of screen pixels.
    pub const fn measures_pixels(self) -> bool {
        matches!(self, Self::Pcf { kernel: Kernel::Pixels(_), .. })
    }

    pub(super) fn word(self) -> Word {
        match self {
            Self::Pcf { kernel, .. } => Word::with(self.name(), [("kernel", Value::Word(kernel.word()))]),
            Self::None | Self::Hardware2x2 | Self::Gather2x2 => Word::plain(self.name()),
        }
    }

    /// Reads a word whose defaults are filled in.
    pub(super) fn of_word(word: Option<&Word>) -> Self {
        let Some(word) = word else { return Self::Gather2x2 };
        let pcf = |size| Self::Pcf { size, kernel: Kernel::of_word(word.arguments.word("kernel")) };
        match word.name {
            "none" => Self::None,
            "hardware_2x2" => Self::Hardware2x2,
            "pcf_3x3" => pcf(PcfSize::Three),
            "pcf_5x5" => pcf(PcfSize::Five),
            "pcf_7x7" => pcf(PcfSize::Seven),
            _ => Self::Gather2x2,
        }
    }
}

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

const PCF: &[Field] = &[Field {
    name: "kernel",
    summary: "width of the box, along each axis of the map by itself",
    kind: Kind::Choice(&[
        Choice::plain("texels", "as many texels as the filter takes"),
        Choice {
            name: "metres",
            summary: "a distance across the light, between one texel and what the filter takes",
            arguments: &[Field {
                name: "width",
                summary: "the distance",
                kind: Kind::Number { min: 0.0, max: 1e3, open: true, unit: Unit::Length },
                default: Default::Value("5 cm"),
            }],
        },
        Choice {
            name: "pixels",
            summary: "a distance across the light that spans so many screen pixels at the receiver's depth, between \
                      one texel and what the filter takes",
            arguments: &[Field {
                name: "width",
                summary: "the pixels",
                kind: Kind::Number { min: 0.0, max: 1e3, open: true, unit: Unit::Pixels },
                default: Default::Value("3 px"),
            }],
        },
    ]),
    default: Default::Value("texels"),
}];

/// Filters in declarations.
pub(super) const FILTERS: &[Choice] = &[
    Choice::plain("none", "nearest texel, hard edge"),
    Choice::plain("hardware_2x2", "comparison sampler: one reference for four texels"),
    Choice::plain("gather_2x2", "four texels, each compared with its own reference"),
    Choice {
        name: "pcf_3x3",
        summary: "a box of up to 3 x 3 texels, each with its own reference",
        arguments: PCF,
    },
    Choice {
        name: "pcf_5x5",
        summary: "a box of up to 5 x 5 texels, each with its own reference",
        arguments: PCF,
    },
    Choice {
        name: "pcf_7x7",
        summary: "a box of up to 7 x 7 texels, each with its own reference",
        arguments: PCF,
    },
];
