//! Defaults: what stands in the schema as text, as values.

use super::{Arguments, Choice, Default, Field, Kind, Value, Word};

/// The arguments in the order of the schema, with the default of every field that is left out. Values that do not
/// fit their field's kind are kept as they are: finding fault is not this function's part.
pub fn fill(fields: &'static [Field], arguments: &Arguments) -> Arguments {
    let filled = fields.iter().filter_map(|field| {
        let value = match arguments.get(field.name) {
            Some(value) => Some(complete(&field.kind, value)),
            None => field.default_value(),
        };
        value.map(|value| (field.name, value))
    });
    Arguments(filled.collect())
}

impl Field {
    /// The value that stands when the field is left out.
    pub fn default_value(&self) -> Option<Value> {
        let Default::Value(text) = self.default else {
            return None;
        };
        match self.kind {
            Kind::Count { .. } => text.parse().ok().map(Value::Count),
            Kind::AutoOrCount { .. } if text == "auto" => Some(Value::Word(Word::plain("auto"))),
            Kind::AutoOrCount { .. } => text.parse().ok().map(Value::Count),
            Kind::NumberOr { choices, .. } if default_word(choices, text).is_some() => {
                default_word(choices, text).map(Value::Word)
            }
            Kind::Number { unit, .. } | Kind::NumberOr { unit, .. } => {
                let (number, name) = text.split_once(' ').unwrap_or((text, ""));
                unit.base(number.parse().ok()?, name).map(Value::Number)
            }
            Kind::Size { .. } => {
                let (width, height) = text.split_once(" x ")?;
                Some(Value::Size(width.parse().ok()?, height.parse().ok()?))
            }
            Kind::Choice(choices) => default_word(choices, text).map(Value::Word),
            Kind::ChoiceList(choices) => {
                let words = entries(text).into_iter().filter_map(|entry| default_word(choices, entry));
                Some(Value::Words(words.collect()))
            }
            Kind::Group(fields) => Some(Value::Group(fill(fields, &Arguments::default()))),
            Kind::SizeList { .. } | Kind::Prefix => None,
        }
    }
}

impl Choice {
    /// The choice with the defaults of its arguments.
    pub fn word(&self) -> Word {
        Word { name: self.name, arguments: fill(self.arguments, &Arguments::default()) }
    }
}

/// The value with the defaults of the arguments it leaves out; -0 becomes 0, so that equal values print alike.
fn complete(kind: &Kind, value: &Value) -> Value {
    match (kind, value) {
        (Kind::Choice(choices), Value::Word(word)) => Value::Word(complete_word(choices, word)),
        (Kind::ChoiceList(choices), Value::Words(words)) => {
            Value::Words(words.iter().map(|word| complete_word(choices, word)).collect())
        }
        (Kind::Group(fields), Value::Group(group)) => Value::Group(fill(fields, group)),
        (Kind::NumberOr { choices, .. }, Value::Word(word)) => Value::Word(complete_word(choices, word)),
        (Kind::Number { .. } | Kind::NumberOr { .. }, Value::Number(number)) => Value::Number(number + 0.0),
        (Kind::Number { .. } | Kind::NumberOr { .. }, Value::Count(count)) => {
            Value::Number(f64::from(*count))
        }
        _ => value.clone(),
    }
}

fn complete_word(choices: &'static [Choice], word: &Word) -> Word {
    match Choice::find(choices, word.name) {
        Some(choice) => Word { name: choice.name, arguments: fill(choice.arguments, &word.arguments) },
        None => word.clone(),
    }
}

/// The choice that a default's text begins with; its arguments are the defaults of the choice's own fields.
fn default_word(choices: &'static [Choice], text: &str) -> Option<Word> {
    let name = text.split([' ', '(', '{']).next()?;
    Choice::find(choices, name).map(Choice::word)
}

/// The entries of a list in brackets, split at the commas outside braces.
fn entries(text: &str) -> Vec<&str> {
    let mut depth = 0_u32;
    let split = |letter: char| {
        match letter {
            '{' | '(' => depth += 1,
            '}' | ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        letter == ',' && depth == 0
    };
    text.trim_start_matches('[').trim_end_matches(']').split(split).map(str::trim).collect()
}
