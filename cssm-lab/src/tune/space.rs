//! What is searched: every technique in every variant, configuration set, distribution, count, focus, fold and filter.
//!
//! The forms are those that measuring compares; their whole numbers and focus distances are varied by what the schema
//! says of them, so that a new technique or argument is searched without a line here.

use cssm_codegen::dsl;
use cssm_core::LightCase;
use cssm_core::case::{Casters, FarKind, LightKind};
use cssm_core::distribution;
use cssm_core::schema::{Arguments, Choice, Field, Kind, Value, Word};

use crate::measure::error::MeasureError;
use crate::measure::variants::{FILTERS, forms};

/// Strips that tiles are folded into, besides as many as the isotropy rule finds.
const COLUMNS: [u32; 3] = [1, 2, 4];

/// Every variant for a kind of light, with square maps of `side`, each once.
///
/// # Errors
/// When the table of a technique is at fault.
pub fn variants(
    light: LightKind,
    side: u32,
    has_masks: bool,
    finite: bool,
) -> Result<Vec<LightCase>, MeasureError> {
    // Take every form, and once all configurations of a technique together.
    let mut shapes = Vec::new();
    for form in forms(light) {
        let case = form.case(side, FILTERS[0])?;
        if form.rows.is_empty() {
            shapes.extend(with_every_configuration(&case));
        }
        shapes.push(case);
    }

    // Vary counts and focus distances together, folds by themselves.
    let mut varied = Vec::new();
    for shape in &shapes {
        varied.extend(COLUMNS.iter().filter_map(|columns| {
            let mut folded = shape.clone();
            folded.map.columns = Some(*columns);
            // Folds say nothing where there is but one tile.
            (shape.shape().cells() > 1).then_some(folded)
        }));
        varied.extend(knobs(shape));
    }

    // Give each every filter, and what the views and casters need.
    let mut cases: Vec<LightCase> = Vec::new();
    let mut known = std::collections::BTreeSet::new();
    for shape in varied {
        for filter in FILTERS {
            let mut case = shape.clone();
            case.filter = filter;
            case.far = if finite { FarKind::Finite } else { FarKind::Infinite };
            case.casters = if has_masks { Casters::AlphaTested } else { Casters::Opaque };
            if known.insert(key(&case)) {
                cases.push(case);
            }
        }
    }
    Ok(cases)
}

/// What tells one declaration from another, whatever it is called.
pub fn key(case: &LightCase) -> String {
    let (name, doc) = ("Tuned".to_owned(), String::new());
    dsl::print(&LightCase { name, doc, public: true, prefix: "tuned".to_owned(), ..case.clone() })
}

/// The declared value of a top-level field, as text.
pub fn field(case: &LightCase, name: &str) -> Option<String> {
    let text = key(case);
    let lead = format!("    {name}: ");
    let line = text.lines().find_map(|line| line.strip_prefix(&lead));
    line.map(|line| line.trim_end_matches(',').to_owned())
}

/// A case in a few words: what tells variants apart.
pub fn label(case: &LightCase) -> String {
    let mut words = field(case, "technique").unwrap_or_default();
    if case.technique_spec().configurations.len() > 1 {
        words += &format!(" {}", field(case, "configurations").unwrap_or_default());
    }
    if case.distribution.is_some() {
        words += &format!(" {}", field(case, "distribution").unwrap_or_default());
    }
    if case.stretch != cssm_core::case::Stretch::None {
        words += " stretched";
    }
    if let Some(columns) = case.map.columns {
        words += &format!(" in {columns} columns");
    }
    format!("{words}, filter {}", case.filter.name())
}

/// The case with another value of a field; `None` where that contradicts the rest.
pub fn with_field(case: &LightCase, name: &'static str, value: Value) -> Result<LightCase, String> {
    let mut arguments = case.to_arguments();
    arguments.0.retain(|(field, _)| *field != name);
    arguments.0.push((name, value));
    let made = LightCase::from_arguments(&case.name, &case.doc, case.public, &arguments);
    made.map_err(|errors| errors.iter().map(|error| error.message.as_str()).collect::<Vec<_>>().join("; "))
}

/// The case with all configurations of its technique, where there are several and not all are declared.
fn with_every_configuration(case: &LightCase) -> Option<LightCase> {
    let spec = case.technique_spec();
    let words: Vec<Word> =
        spec.serving(case.light).map(|name| spec.configuration(name).choice.word()).collect();
    if words.len() < 2 {
        return None;
    }
    with_field(case, "configurations", Value::Words(words)).ok()
}

/// The case with every combination of the values that its counts and focus distances may take, itself included.
fn knobs(case: &LightCase) -> Vec<LightCase> {
    let mut cases = vec![case.clone()];
    let technique = case.technique_spec().choice;
    cases = across(cases, |case| {
        let words = alternatives(&case.technique, technique.arguments);
        words.into_iter().map(|word| with_field(case, "technique", Value::Word(word))).collect()
    });
    cases = across(cases, |case| {
        // Only the first configuration is varied: forms declare one, or all with their defaults.
        let [only] = &case.configurations[..] else { return vec![Ok(case.clone())] };
        let choice = case.technique_spec().configuration(only.name).choice;
        let words = alternatives(only, choice.arguments);
        let list = |word| Value::Words(vec![word]);
        words.into_iter().map(|word| with_field(case, "configurations", list(word))).collect()
    });
    across(cases, |case| {
        let Some(word) = &case.distribution else { return vec![Ok(case.clone())] };
        let arguments = distribution::spec(word.name).map_or(&[][..], |spec| spec.choice.arguments);
        let words = alternatives(word, arguments);
        words.into_iter().map(|word| with_field(case, "distribution", Value::Word(word))).collect()
    })
}

fn across(
    cases: Vec<LightCase>,
    vary: impl Fn(&LightCase) -> Vec<Result<LightCase, String>>,
) -> Vec<LightCase> {
    cases.iter().flat_map(|case| vary(case).into_iter().flatten()).collect()
}

/// The word with every combination of other counts and focus presets.
fn alternatives(word: &Word, fields: &'static [Field]) -> Vec<Word> {
    let mut words = vec![word.clone()];
    for field in fields {
        let values = |value: &Value| -> Vec<Value> {
            match (field.kind, value) {
                (Kind::Count { min, max }, Value::Count(count)) => {
                    let mut counts = vec![*count, (count / 2).max(min), (count * 2).min(max)];
                    counts.sort_unstable();
                    counts.dedup();
                    counts.into_iter().map(Value::Count).collect()
                }
                (Kind::NumberOr { choices, .. }, Value::Number(_)) => {
                    let presets = choices.iter().filter(|choice| choice.arguments.is_empty());
                    let presets = presets.map(|choice: &Choice| Value::Word(choice.word()));
                    std::iter::once(value.clone()).chain(presets).collect()
                }
                _ => vec![value.clone()],
            }
        };
        words = words
            .into_iter()
            .flat_map(|word| match word.arguments.get(field.name) {
                None => vec![word],
                Some(value) => {
                    values(value).into_iter().map(|value| replaced(&word, field.name, value)).collect()
                }
            })
            .collect();
    }
    words
}

/// The word with another value of an argument it has.
pub fn replaced(word: &Word, name: &str, value: Value) -> Word {
    let entries = word.arguments.0.iter().map(|(field, old)| {
        let new = if *field == name { value.clone() } else { old.clone() };
        (*field, new)
    });
    Word { name: word.name, arguments: Arguments(entries.collect()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cssm_core::technique::TECHNIQUES;

    #[test]
    fn hundreds_of_variants_are_searched_each_once_and_each_declarable() {
        let cases = variants(LightKind::Directional, 1024, false, false).unwrap();
        assert!(cases.len() >= 200, "{} variants", cases.len());
        let mut keys: Vec<String> = cases.iter().map(key).collect();
        keys.sort();
        keys.dedup();
        assert_eq!(keys.len(), cases.len());
        for case in &cases {
            let read = dsl::parse_file("printed", &dsl::print(case)).expect("a printed case reads");
            assert_eq!(read, std::slice::from_ref(case));
        }
        for spec in TECHNIQUES {
            let name = spec.choice.name;
            let is_there = cases.iter().any(|case| case.technique.name == name);
            let serves = !(spec.default_configurations)(LightKind::Directional).is_empty();
            assert_eq!(is_there, serves, "{name}");
        }
    }

    #[test]
    fn local_lights_have_variants_too() {
        for light in [LightKind::Spot, LightKind::Omni] {
            assert!(variants(light, 512, true, true).unwrap().len() > 50, "{light:?}");
        }
    }
}
