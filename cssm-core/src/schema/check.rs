//! What a value may be: the checks that every door shares, and their wording.

use std::fmt;

use super::{Choice, Kind, Unit, Value};

/// What is wrong with a value and what to write instead.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// What is wrong; lower-case, no full stop.
    pub message: String,
    /// What to write instead.
    pub remedy: String,
}

impl Kind {
    /// Checks a value against this kind, without looking into words, lists of words or groups.
    ///
    /// # Errors
    /// The fault: a value out of range, an empty list, a repeated name or a value of another kind.
    pub fn check(&self, value: &Value) -> Result<(), Fault> {
        let fault = |message: String| Err(Fault { message, remedy: format!("use {self}") });
        match (self, value) {
            (Self::Count { min, max } | Self::AutoOrCount { min, max }, Value::Count(count)) => {
                if count < min {
                    fault(format!("{count} is below the smallest value, {min}"))
                } else if count > max {
                    fault(format!("{count} is above the largest value, {max}"))
                } else {
                    Ok(())
                }
            }
            (Self::AutoOrCount { .. }, Value::Word(word)) if word.name == "auto" => Ok(()),
            (Self::NumberOr { .. }, Value::Word(_)) => Ok(()),
            (Self::NumberOr { min, max, open, unit, .. }, _) => {
                let number = Self::Number { min: *min, max: *max, open: *open, unit: *unit };
                number.check(value)
            }
            (Self::Number { .. }, Value::Count(count)) => self.check(&Value::Number(f64::from(*count))),
            (Self::Number { min, max, open, unit }, Value::Number(number)) => {
                let inside =
                    if *open { number > min && number < max } else { number >= min && number <= max };
                if inside { Ok(()) } else { fault(format!("{} is out of range", Quantity(*number, *unit))) }
            }
            (Self::Size { min, max }, Value::Size(width, height)) => {
                if width.min(height) < min {
                    fault(format!("{width} x {height} is below the smallest side, {min} texels"))
                } else if width.max(height) > max {
                    fault(format!("{width} x {height} is above the largest side, {max} texels"))
                } else {
                    Ok(())
                }
            }
            (Self::SizeList { min, max }, Value::Sizes(sizes)) => {
                if sizes.is_empty() {
                    return fault("the list is empty".into());
                }
                let side = Self::Size { min: *min, max: *max };
                sizes.iter().try_for_each(|(width, height)| side.check(&Value::Size(*width, *height)))
            }
            (Self::ChoiceList(_), Value::Words(words)) if words.is_empty() => {
                fault("the list is empty".into())
            }
            (Self::ChoiceList(_), Value::Words(words)) => {
                let twice = (1..words.len())
                    .find(|&index| words[..index].iter().any(|earlier| earlier.name == words[index].name));
                match twice {
                    Some(index) => Err(Fault {
                        message: format!("`{}` stands twice in the list", words[index].name),
                        remedy: "name it once".into(),
                    }),
                    None => Ok(()),
                }
            }
            (Self::Choice(_), Value::Word(_))
            | (Self::Group(_), Value::Group(_))
            | (Self::Prefix, Value::Name(_)) => Ok(()),
            _ => fault("the value has the wrong kind".into()),
        }
    }
}

/// What the kind takes, as it follows the word "use" in a remedy.
impl fmt::Display for Kind {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count { min, max } => write!(out, "a whole number from {min} to {max}"),
            Self::AutoOrCount { min, max } => write!(out, "`auto` or a whole number from {min} to {max}"),
            Self::NumberOr { min, max, open, unit, choices } => {
                let number = Self::Number { min: *min, max: *max, open: *open, unit: *unit };
                write!(out, "{number}, or one of ")?;
                write_names(out, choices)
            }
            Self::Number { min, max, open, unit } => {
                let noun = match unit {
                    Unit::None | Unit::Texels | Unit::Pixels => "a number",
                    Unit::Degrees => "an angle",
                    Unit::Length => "a length",
                };
                match (max.is_finite(), open) {
                    (false, true) => write!(out, "{noun} above {}", Quantity(*min, *unit)),
                    (false, false) => write!(out, "{noun} of at least {}", Quantity(*min, *unit)),
                    (true, true) => {
                        write!(out, "{noun} between {} and {}", Quantity(*min, *unit), Quantity(*max, *unit))
                    }
                    (true, false) => {
                        write!(out, "{noun} from {} to {}", Quantity(*min, *unit), Quantity(*max, *unit))
                    }
                }
            }
            Self::Size { min, max } => {
                write!(out, "a size such as `2048 x 2048` with sides of {min} to {max} texels")
            }
            Self::SizeList { min, max } => {
                write!(out, "a list such as `[1024 x 1024, 512 x 512]` with sides of {min} to {max} texels")
            }
            Self::Choice(choices) => {
                out.write_str(if choices.len() > 1 { "one of " } else { "" })?;
                write_names(out, choices)
            }
            Self::ChoiceList(choices) => {
                out.write_str("a list in brackets of ")?;
                write_names(out, choices)
            }
            Self::Group(_) => out.write_str("a group of fields in braces"),
            Self::Prefix => out.write_str("a name in lower snake case, such as `sun`"),
        }
    }
}

/// A number with the base name of its unit, as a declaration spells it.
struct Quantity(f64, Unit);

impl fmt::Display for Quantity {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(number, unit) = self;
        // Powers of ten that fill a line of zeros are easier to read as such.
        if number.abs() >= 1e7 {
            write!(out, "{number:e}")?
        } else {
            write!(out, "{number}")?
        }
        if unit.base_name().is_empty() { Ok(()) } else { write!(out, " {}", unit.base_name()) }
    }
}

fn write_names(out: &mut fmt::Formatter<'_>, choices: &[Choice]) -> fmt::Result {
    for (index, choice) in choices.iter().enumerate() {
        let comma = if index > 0 { ", " } else { "" };
        write!(out, "{comma}`{}`", choice.name)?;
    }
    Ok(())
}
