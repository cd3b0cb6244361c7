//! The one table behind every declared field: kinds, units, ranges, defaults and choices.
//!
//! A [`Field`] says what a declaration may hold and what stands there when it is left out. The text grammar,
//! the reference page and the checks of the Rust builder all read the same fields, so they cannot drift apart.
//! A [`Value`] is what a declaration holds once it is checked: names are resolved, units converted, defaults
//! filled in.

mod check;
mod defaults;

pub use check::Fault;
pub use defaults::fill;

/// A declared field or argument: its name, what it may hold and what it means when it is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Field {
    /// Name as written in a declaration.
    pub name: &'static str,
    /// One sentence for the reference page and for error reports.
    pub summary: &'static str,
    /// What the field may hold.
    pub kind: Kind,
    /// What stands when the field is left out.
    pub default: Default,
}

/// What stands when a field is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Default {
    /// A value, in the declaration grammar.
    Value(&'static str),
    /// Nothing; the text says what that means.
    Absent(&'static str),
    /// The field must be written.
    Required,
}

/// What a field may hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A whole number in `min..=max`.
    Count {
        /// Smallest allowed value.
        min: u32,
        /// Largest allowed value.
        max: u32,
    },
    /// A real number in a range, with or without a unit.
    Number {
        /// Lower end of the range.
        min: f64,
        /// Upper end of the range; may be infinite.
        max: f64,
        /// Whether the ends themselves are refused.
        open: bool,
        /// The unit that must be written after the number.
        unit: Unit,
    },
    /// A real number as [`Self::Number`], or one of several names, each with arguments of its own.
    NumberOr {
        /// Lower end of the range.
        min: f64,
        /// Upper end of the range; may be infinite.
        max: f64,
        /// Whether the ends themselves are refused.
        open: bool,
        /// The unit that must be written after the number.
        unit: Unit,
        /// What may stand instead.
        choices: &'static [Choice],
    },
    /// The word `auto`, or a whole number in `min..=max`.
    AutoOrCount {
        /// Smallest allowed value.
        min: u32,
        /// Largest allowed value.
        max: u32,
    },
    /// Width x height in texels.
    Size {
        /// Smallest side.
        min: u32,
        /// Largest side.
        max: u32,
    },
    /// One of several names, each with arguments of its own.
    Choice(&'static [Choice]),
    /// `[a, b, ..]` of one or more entries, each one of several names; no name twice.
    ChoiceList(&'static [Choice]),
    /// `[a x b, ..]`: sizes in texels.
    SizeList {
        /// Smallest side.
        min: u32,
        /// Largest side.
        max: u32,
    },
    /// A nested group in braces.
    Group(&'static [Field]),
    /// An identifier in lower snake case that does not end in a digit.
    Prefix,
}

/// A unit that a number must carry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// A pure number; writing a unit is an error.
    None,
    /// A length: `mm`, `cm`, `m` or `km`; stored in metres.
    Length,
    /// Map texels: `texel` or `texels`.
    Texels,
    /// Screen pixels: `px`, `pixel` or `pixels`.
    Pixels,
    /// An angle: `deg`, `degree` or `degrees`.
    Degrees,
}

impl Unit {
    /// Unit names that may be written.
    pub const fn names(self) -> &'static [&'static str] {
        match self {
            Self::None => &[],
            Self::Length => &["mm", "cm", "m", "km"],
            Self::Texels => &["texel", "texels"],
            Self::Pixels => &["px", "pixel", "pixels"],
            Self::Degrees => &["deg", "degree", "degrees"],
        }
    }

    /// A number written with one of [`Unit::names`], in base units (metres, texels, pixels, degrees);
    /// `None` for any other unit.
    /// The empty name is the missing unit of a pure number.
    pub fn base(self, number: f64, name: &str) -> Option<f64> {
        // Divide by whole powers of ten: they are exact, so equal lengths in different units round to equal metres.
        match (self, name) {
            (Self::None, "") | (Self::Length, "m") => Some(number),
            (Self::Texels, "texel" | "texels") | (Self::Pixels, "px" | "pixel" | "pixels") => Some(number),
            (Self::Degrees, "deg" | "degree" | "degrees") => Some(number),
            (Self::Length, "mm") => Some(number / 1e3),
            (Self::Length, "cm") => Some(number / 1e2),
            (Self::Length, "km") => Some(number * 1e3),
            _ => None,
        }
    }

    /// Name of the base unit; empty for pure numbers.
    pub const fn base_name(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Length => "m",
            Self::Texels => "texels",
            Self::Pixels => "px",
            Self::Degrees => "degrees",
        }
    }
}

/// One of the names a [`Kind::Choice`] allows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choice {
    /// Name as written.
    pub name: &'static str,
    /// One sentence for the reference page.
    pub summary: &'static str,
    /// Arguments. Fields may be given by name in braces or parentheses; the first may be given by position.
    pub arguments: &'static [Field],
}

impl Field {
    /// The field of a name.
    pub fn find<'a>(fields: &'a [Self], name: &str) -> Option<&'a Self> {
        fields.iter().find(|field| field.name == name)
    }
}

impl Kind {
    /// The number that may stand where a number or a name may.
    pub const fn number(&self) -> Option<Self> {
        match *self {
            Self::NumberOr { min, max, open, unit, .. } | Self::Number { min, max, open, unit } => {
                Some(Self::Number { min, max, open, unit })
            }
            _ => None,
        }
    }
}

impl Choice {
    /// The choice of a name.
    pub fn find<'a>(choices: &'a [Self], name: &str) -> Option<&'a Self> {
        choices.iter().find(|choice| choice.name == name)
    }

    /// A choice without arguments.
    pub const fn plain(name: &'static str, summary: &'static str) -> Self {
        Self { name, summary, arguments: &[] }
    }
}

/// A checked value; `auto` of a [`Kind::AutoOrCount`] is the plain word `auto`.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A whole number.
    Count(u32),
    /// A real number in base units (metres, texels, pixels, degrees).
    Number(f64),
    /// Width, height in texels.
    Size(u32, u32),
    /// A chosen name with its arguments.
    Word(Word),
    /// Several chosen names.
    Words(Vec<Word>),
    /// Several sizes in texels.
    Sizes(Vec<(u32, u32)>),
    /// A nested group.
    Group(Arguments),
    /// An identifier.
    Name(String),
}

/// A chosen name with its arguments, defaults filled in.
#[derive(Debug, Clone, PartialEq)]
pub struct Word {
    /// The chosen name.
    pub name: &'static str,
    /// Its arguments, in the order of the schema.
    pub arguments: Arguments,
}

impl Word {
    /// A word without arguments.
    pub const fn plain(name: &'static str) -> Self {
        Self { name, arguments: Arguments(Vec::new()) }
    }

    /// A word with arguments.
    pub fn with(name: &'static str, arguments: impl IntoIterator<Item = (&'static str, Value)>) -> Self {
        Self { name, arguments: Arguments(arguments.into_iter().collect()) }
    }
}

/// Named values in the order of the schema; an optional field that was left out and has no default is absent.
#[derive(Debug, Clone, PartialEq, std::default::Default)]
pub struct Arguments(pub Vec<(&'static str, Value)>);

impl Arguments {
    /// The value of a field, if it is there.
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.0.iter().find(|(field, _)| *field == name).map(|(_, value)| value)
    }

    /// A whole number, if the field is there and holds one.
    pub fn count(&self, name: &str) -> Option<u32> {
        match self.get(name)? {
            Value::Count(count) => Some(*count),
            _ => None,
        }
    }

    /// A real number in base units, if the field is there and holds one.
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.get(name)? {
            Value::Number(number) => Some(*number),
            Value::Count(count) => Some(f64::from(*count)),
            _ => None,
        }
    }

    /// A chosen name, if the field is there and holds one.
    pub fn word(&self, name: &str) -> Option<&Word> {
        match self.get(name)? {
            Value::Word(word) => Some(word),
            _ => None,
        }
    }

    /// A nested group, if the field is there and holds one.
    pub fn group(&self, name: &str) -> Option<&Self> {
        match self.get(name)? {
            Value::Group(group) => Some(group),
            _ => None,
        }
    }

    /// Chosen names, if the field is there and holds a list of them; else none.
    pub fn words(&self, name: &str) -> &[Word] {
        match self.get(name) {
            Some(Value::Words(words)) => words,
            _ => &[],
        }
    }

    /// Sizes in texels, if the field is there and holds them.
    pub fn sizes(&self, name: &str) -> Option<&[(u32, u32)]> {
        match self.get(name)? {
            Value::Sizes(sizes) => Some(sizes),
            _ => None,
        }
    }
}
