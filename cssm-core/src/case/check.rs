//! From checked arguments to a light case: defaults, ranges of the Rust door, contradictions.

use super::{
    Bias, CaseError, DepthFormat, FarKind, Filter, LightCase, LightKind, MapSpec, MaskDepth, MaskNormal, Resolve,
};
use crate::case::fields::FIELDS;
use crate::schema::{Arguments, Choice, Default, Field, Kind, Value, Word};
use crate::technique;

pub(super) fn from_arguments(
    name: &str,
    doc: &str,
    public: bool,
    arguments: &Arguments,
) -> Result<LightCase, Vec<CaseError>> {
    let mut errors = Vec::new();
    let mut at = |field: &str, message: String, remedy: &str| {
        errors.push(CaseError { field: field.into(), message, remedy: remedy.into() });
    };

    // Check every value against the schema: the Rust door does not pass through the text grammar.
    check_fields(FIELDS, arguments, "", &mut at);
    if !is_camel_case(name) {
        at("name", format!("`{name}` is not a case name"), "use upper camel case, such as `Sun`");
    }
    let prefix = match arguments.get("prefix") {
        Some(Value::Name(prefix)) => prefix.clone(),
        _ => default_prefix(name),
    };
    if !is_prefix(&prefix) {
        at(
            "prefix",
            format!("`{prefix}` cannot prefix shader names"),
            "use lower snake case that starts with a letter and ends in a letter, such as `sun`",
        );
    }

    // Read the technique and what belongs to it.
    let technique =
        arguments.word("technique").cloned().unwrap_or_else(|| Word::plain("camera_space"));
    let spec = technique::spec(technique.name);
    let technique = with_defaults(&technique, spec.choice.arguments);
    let own = spec.configurations;
    let configurations = match arguments.get("configurations") {
        Some(Value::Words(words)) => words.clone(),
        _ => vec![Word::plain(own[0].name)],
    };
    for word in &configurations {
        if !own.iter().any(|choice| choice.name == word.name) {
            let names: Vec<_> = own.iter().map(|choice| format!("`{}`", choice.name)).collect();
            at(
                "configurations",
                format!("technique `{}` has no configuration `{}`", technique.name, word.name),
                &format!("use {}", names.join(", ")),
            );
        }
    }
    let distribution = match (arguments.word("distribution"), spec.distribution) {
        (Some(word), None) => {
            at(
                "distribution",
                format!("technique `{}` has no distribution, but `{}` is declared", technique.name, word.name),
                "leave distribution out",
            );
            None
        }
        (word, Some(_)) => {
            let word = word.cloned().unwrap_or_else(|| Word::plain("bands"));
            Some(with_defaults(&word, bands_arguments()))
        }
        (None, None) => None,
    };

    // Read the rest.
    let far = arguments.word("view").and_then(|view| view.arguments.word("far"));
    let far = match far.map(|word| word.name) {
        Some("finite") => FarKind::Finite,
        _ => FarKind::Infinite,
    };
    let case = LightCase {
        name: name.into(),
        doc: doc.into(),
        public,
        light: LightKind::Directional,
        far,
        shadow_distance_metres: arguments.number("shadow_distance"),
        technique,
        configurations,
        distribution,
        map: map_spec(arguments),
        filter: match arguments.word("filter").map(|word| word.name) {
            Some("none") => Filter::None,
            Some("hardware_2x2") => Filter::Hardware2x2,
            _ => Filter::Gather2x2,
        },
        bias: bias(arguments.word("bias")),
        resolve: resolve(arguments.get("resolve")),
        prefix,
    };
    for error in (spec.check)(&case) {
        at(&error.field, error.message, &error.remedy);
    }
    if let Some(gutter) = case.map.gutter
        && gutter < case.filter.radius_texels()
    {
        at(
            "map.gutter",
            format!(
                "a gutter of {gutter} texels is narrower than the reach of filter `{}`, {} texel",
                case.filter.name(),
                case.filter.radius_texels()
            ),
            "write `gutter: auto` or a gutter of at least the filter's reach",
        );
    }
    if errors.is_empty() { Ok(case) } else { Err(errors) }
}

fn map_spec(arguments: &Arguments) -> MapSpec {
    let empty = Arguments::default();
    let map = match arguments.get("map") {
        Some(Value::Group(map)) => map,
        _ => &empty,
    };
    let (width, height) = match map.get("size") {
        Some(Value::Size(width, height)) => (*width, *height),
        _ => (2048, 2048),
    };
    let format = match map.word("format").map(|word| word.name) {
        Some("depth16unorm") => DepthFormat::Depth16Unorm,
        _ => DepthFormat::Depth32Float,
    };
    MapSpec { width, height, columns: map.count("columns"), format, gutter: map.count("gutter") }
}

fn bias(word: Option<&Word>) -> Bias {
    let Some(word) = word else { return Bias::ReceiverPlane };
    let number = |name: &str, default: f64| word.arguments.number(name).unwrap_or(default);
    match word.name {
        "none" => Bias::None,
        "constant" => Bias::Constant { along_light_metres: number("along_light", 0.05) },
        "slope" => Bias::Slope { texels: number("scale", 1.5) },
        "world_texel" => Bias::WorldTexel { a_metres: number("a", 0.01), b_texels: number("b", 1.5) },
        _ => Bias::ReceiverPlane,
    }
}

fn resolve(value: Option<&Value>) -> Vec<Resolve> {
    let default = [Word::plain("mask"), Word::plain("function")];
    let words = match value {
        Some(Value::Words(words)) => words.as_slice(),
        _ => &default,
    };
    let read = |word: &Word| {
        if word.name == "function" {
            return Resolve::Function { group: word.arguments.count("group").unwrap_or(2) };
        }
        let name = |field: &str| word.arguments.word(field).map(|word| word.name);
        Resolve::Mask {
            depth: if name("depth") == Some("linear") { MaskDepth::Linear } else { MaskDepth::ReversedZ },
            normal: if name("normal") == Some("texture") {
                MaskNormal::Texture
            } else {
                MaskNormal::Reconstructed
            },
        }
    };
    words.iter().map(read).collect()
}

fn bands_arguments() -> &'static [Field] {
    let field = FIELDS.iter().find(|field| field.name == "distribution");
    match field.map(|field| field.kind) {
        Some(Kind::Choice(choices)) => choices[0].arguments,
        _ => &[],
    }
}

/// The word with the schema's defaults for numbers and plain words it leaves out.
fn with_defaults(word: &Word, fields: &'static [Field]) -> Word {
    let arguments = fields.iter().filter_map(|field| {
        let value = word.arguments.get(field.name).cloned();
        value.or_else(|| default_value(field)).map(|value| (field.name, value))
    });
    Word::with(word.name, arguments)
}

/// The default of a count, a number or a choice, read from the schema's text.
fn default_value(field: &Field) -> Option<Value> {
    let Default::Value(text) = field.default else { return None };
    match field.kind {
        Kind::Count { .. } => text.parse().ok().map(Value::Count),
        Kind::Number { .. } => {
            let (number, unit) = text.split_once(' ').unwrap_or((text, ""));
            let scale = crate::schema::unit_scale(unit).unwrap_or(1.0);
            number.parse::<f64>().ok().map(|number| Value::Number(number * scale))
        }
        Kind::Choice(choices) => {
            let name = text.split([' ', '(', '{']).next().unwrap_or(text);
            let choice = choices.iter().find(|choice| choice.name == name)?;
            Some(Value::Word(with_defaults(&Word::plain(choice.name), choice.arguments)))
        }
        _ => None,
    }
}

fn check_fields(
    fields: &'static [Field],
    arguments: &Arguments,
    path: &str,
    at: &mut impl FnMut(&str, String, &str),
) {
    for (name, value) in &arguments.0 {
        let path = if path.is_empty() { (*name).to_string() } else { format!("{path}.{name}") };
        match fields.iter().find(|field| field.name == *name) {
            Some(field) => check_value(&field.kind, value, &path, at),
            None => at(&path, format!("there is no field `{name}`"), "leave it out"),
        }
    }
}

fn check_value(kind: &Kind, value: &Value, path: &str, at: &mut impl FnMut(&str, String, &str)) {
    let out_of = |value: &dyn std::fmt::Display| format!("{value} is out of range");
    match (kind, value) {
        (Kind::Count { min, max } | Kind::AutoOrCount { min, max }, Value::Count(count)) => {
            if count < min || count > max {
                at(path, out_of(count), &format!("use {min} to {max}"));
            }
        }
        (Kind::AutoOrCount { .. }, Value::Word(_)) => {}
        (Kind::Number { min, max, open, .. }, Value::Number(number)) => {
            let inside = if *open { number > min && number < max } else { number >= min && number <= max };
            if !inside {
                let word = if *open { "between" } else { "from" };
                at(path, out_of(number), &format!("use a number {word} {min} and {max}"));
            }
        }
        (Kind::Size { min, max }, Value::Size(width, height)) => {
            if width.min(height) < min || width.max(height) > max {
                at(path, format!("{width} x {height} is out of range"), &format!("use sides of {min} to {max} texels"));
            }
        }
        (Kind::SizeList { min, max }, Value::Sizes(sizes)) => {
            for (width, height) in sizes {
                check_value(&Kind::Size { min: *min, max: *max }, &Value::Size(*width, *height), path, at);
            }
        }
        (Kind::Choice(choices), Value::Word(word)) => check_word(choices, word, path, at),
        (Kind::ChoiceList(choices), Value::Words(words)) => {
            if words.is_empty() {
                at(path, "the list is empty".into(), "name at least one entry or leave the field out");
            }
            for (index, word) in words.iter().enumerate() {
                check_word(choices, word, path, at);
                if words[..index].iter().any(|earlier| earlier.name == word.name) {
                    at(path, format!("`{}` stands twice", word.name), "name it once");
                }
            }
        }
        (Kind::Group(fields), Value::Group(arguments)) => check_fields(fields, arguments, path, at),
        (Kind::Prefix, Value::Name(_)) => {}
        _ => at(path, "the value has the wrong kind".into(), "see the field reference"),
    }
}

fn check_word(choices: &'static [Choice], word: &Word, path: &str, at: &mut impl FnMut(&str, String, &str)) {
    match choices.iter().find(|choice| choice.name == word.name) {
        Some(choice) => check_fields(choice.arguments, &word.arguments, path, at),
        None => {
            let names: Vec<_> = choices.iter().map(|choice| format!("`{}`", choice.name)).collect();
            at(path, format!("there is no `{}` here", word.name), &format!("use {}", names.join(", ")));
        }
    }
}

fn is_camel_case(name: &str) -> bool {
    name.starts_with(|first: char| first.is_ascii_uppercase())
        && name.chars().all(|letter| letter.is_ascii_alphanumeric())
}

fn is_prefix(prefix: &str) -> bool {
    prefix.starts_with(|first: char| first.is_ascii_lowercase())
        && prefix.ends_with(|last: char| last.is_ascii_lowercase())
        && !prefix.contains("__")
        && prefix.chars().all(|letter| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_')
}

/// Snake case of an upper camel case name; a trailing digit is followed by `_case`.
fn default_prefix(name: &str) -> String {
    let mut prefix = String::new();
    for (index, letter) in name.chars().enumerate() {
        if letter.is_ascii_uppercase() && index > 0 {
            prefix.push('_');
        }
        prefix.push(letter.to_ascii_lowercase());
    }
    if prefix.ends_with(|last: char| last.is_ascii_digit()) {
        prefix.push_str("_case");
    }
    prefix
}
