//! The canonical text of a case.

use cssm_core::LightCase;
use cssm_core::case::FIELDS;
use cssm_core::schema::{Arguments, Field, Kind, Unit, Value, Word};

/// The declaration of a case with every field written out; parsing it gives an equal case.
pub fn print(case: &LightCase) -> String {
    let mut text = String::new();
    let doc = if case.doc.is_empty() { "" } else { case.doc.as_str() };
    for line in doc.split('\n').filter(|_| !doc.is_empty()) {
        text.push_str(format!("/// {line}").trim_end());
        text.push('\n');
    }
    let visibility = if case.public { "pub " } else { "" };
    text.push_str(&format!("{visibility}case {} {{\n", case.name));
    let arguments = case.to_arguments();
    for field in FIELDS {
        if let Some(value) = arguments.get(field.name) {
            text.push_str(&format!("    {}: {},\n", field.name, written(&field.kind, value)));
        }
    }
    text.push_str("}\n");
    text
}

fn written(kind: &Kind, value: &Value) -> String {
    match (kind, value) {
        (_, Value::Count(count)) => count.to_string(),
        (Kind::Number { unit, .. } | Kind::NumberOr { unit, .. }, Value::Number(number)) => {
            quantity(*number, *unit)
        }
        (_, Value::Number(number)) => quantity(*number, Unit::None),
        (_, Value::Size(width, height)) => format!("{width} x {height}"),
        (_, Value::Sizes(sizes)) => {
            let sizes: Vec<_> = sizes.iter().map(|(width, height)| format!("{width} x {height}")).collect();
            format!("[{}]", sizes.join(", "))
        }
        (
            Kind::Choice(choices) | Kind::ChoiceList(choices) | Kind::NumberOr { choices, .. },
            Value::Word(word),
        ) => word_text(
            word,
            choices.iter().find(|choice| choice.name == word.name).map_or(&[], |c| c.arguments),
        ),
        (_, Value::Word(word)) => word.name.into(),
        (Kind::ChoiceList(choices), Value::Words(words)) => {
            let word = |word: &Word| written(&Kind::Choice(choices), &Value::Word(word.clone()));
            format!("[{}]", words.iter().map(word).collect::<Vec<_>>().join(", "))
        }
        (_, Value::Words(words)) => {
            format!("[{}]", words.iter().map(|word| word.name).collect::<Vec<_>>().join(", "))
        }
        (Kind::Group(fields), Value::Group(group)) => braces(fields, group),
        (_, Value::Group(group)) => braces(&[], group),
        (_, Value::Name(name)) => name.clone(),
    }
}

fn word_text(word: &Word, fields: &[Field]) -> String {
    if word.arguments.0.is_empty() {
        word.name.into()
    } else {
        format!("{} {}", word.name, braces(fields, &word.arguments))
    }
}

fn braces(fields: &[Field], arguments: &Arguments) -> String {
    let entries = fields.iter().filter_map(|field| {
        let value = arguments.get(field.name)?;
        Some(format!("{}: {}", field.name, written(&field.kind, value)))
    });
    format!("{{ {} }}", entries.collect::<Vec<_>>().join(", "))
}

/// The shortest text that reads back as the same number, with its base unit.
fn quantity(number: f64, unit: Unit) -> String {
    let digits = format!("{number:?}");
    let digits = digits.strip_suffix(".0").unwrap_or(&digits);
    if unit == Unit::None { digits.into() } else { format!("{digits} {}", unit.base_name()) }
}
