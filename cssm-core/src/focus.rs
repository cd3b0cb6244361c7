//! The focus distance: up to where a declared share of the map is reserved.
//!
//! It may be a distance, a multiple of the eye's height above the ground, or one of the ranges that the paper gives for
//! kinds of programs (camera space shadow maps, section 3).

use crate::schema::{Arguments, Choice, Default, Field, Kind, Unit, Value};

/// A declared focus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Focus {
    /// A distance from the eye in metres.
    Metres(f64),
    /// A multiple of the eye's height above the ground.
    Heights(f64),
}

/// Focus where a declaration holds none, metres.
const DEFAULT_METRES: f64 = 10.0;
/// Presets: the middle, or the lower end, of the paper's ranges.
const PRESETS: [(&str, f64); 3] = [("first_person", 15.0), ("racing", 75.0), ("flight", 500.0)];

/// The declared field.
pub(crate) const FIELD: Field = Field {
    name: "focus",
    summary: "the focus distance",
    kind: Kind::NumberOr {
        min: 0.0,
        max: 1e9,
        open: true,
        unit: Unit::Length,
        choices: &[
            Choice {
                name: "height",
                summary: "a multiple of the eye's height above the ground, which every plan is then given",
                arguments: &[Field {
                    name: "times",
                    summary: "the multiple",
                    kind: Kind::Number { min: 0.0, max: 1e6, open: true, unit: Unit::None },
                    default: Default::Value("6"),
                }],
            },
            Choice::plain("first_person", "15 m: 10 to 20 m suit first-person programs"),
            Choice::plain("racing", "75 m: 50 to 100 m suit racing"),
            Choice::plain("flight", "500 m: 500 m and more suit flight"),
        ],
    },
    default: Default::Value("10 m"),
};

impl Focus {
    /// The focus among checked arguments.
    pub fn of(arguments: &Arguments) -> Self {
        match arguments.get(FIELD.name) {
            Some(Value::Number(metres)) => Self::Metres(*metres),
            Some(Value::Count(metres)) => Self::Metres(f64::from(*metres)),
            Some(Value::Word(word)) => {
                let preset = PRESETS.iter().find(|(name, _)| *name == word.name);
                match preset {
                    Some((_, metres)) => Self::Metres(*metres),
                    None => Self::Heights(word.arguments.number("times").unwrap_or(6.0)),
                }
            }
            _ => Self::Metres(DEFAULT_METRES),
        }
    }

    /// Metres, given the eye's height above the ground; without a height, a multiple of it stands for as many metres.
    pub fn metres(self, eye_height_metres: Option<f64>) -> f64 {
        match self {
            Self::Metres(metres) => metres,
            Self::Heights(times) => times * eye_height_metres.unwrap_or(1.0),
        }
    }

    /// Whether it needs the eye's height.
    pub const fn needs_height(self) -> bool {
        matches!(self, Self::Heights(_))
    }
}
