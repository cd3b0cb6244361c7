//! Remedies for names that do not exist.

use cssm_core::case::FIELDS;
use cssm_core::schema::{Choice, Field, Kind};

/// Least likeness (Jaro-Winkler, 0 to 1) at which a name is suggested.
const LIKENESS: f64 = 0.8;

/// The remedy for a field name that none of `fields` has; `place` is the dotted path they stand at.
pub(super) fn for_field(name: &str, fields: &[Field], place: &str) -> String {
    let names: Vec<_> = fields.iter().map(|field| field.name).collect();
    if let Some(nearest) = nearest(name, &names) {
        return format!("did you mean `{nearest}`?");
    }
    if let Some(home) = home_of_field(name).filter(|home| home != place) {
        return if home.is_empty() {
            format!("`{name}` stands directly in the case")
        } else {
            format!("`{name}` belongs to `{home}`: write `{}`", written(&home, name))
        };
    }
    format!("the fields here are {}", listed(&names))
}

/// The remedy for a choice that none of `choices` is; `field` is the field that was given it.
pub(super) fn for_choice(name: &str, choices: &[Choice], field: &str) -> String {
    let names: Vec<_> = choices.iter().map(|choice| choice.name).collect();
    let use_names = format!("use {}{}", if names.len() > 1 { "one of " } else { "" }, listed(&names));
    if let Some(nearest) = nearest(name, &names) {
        return format!("did you mean `{nearest}`?");
    }
    match FIELDS
        .iter()
        .find(|other| other.name != field && choices_of(&other.kind).iter().any(|c| c.name == name))
    {
        Some(other) => format!("`{name}` is a value of `{}`; here {use_names}", other.name),
        None => use_names,
    }
}

/// Names in backticks with commas between.
pub(super) fn listed(names: &[&str]) -> String {
    let quoted: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}

/// The name most like a wrong one, if any is like it at all.
pub(crate) fn nearest<'a>(wrong: &str, names: &[&'a str]) -> Option<&'a str> {
    let wrong = wrong.to_ascii_lowercase().replace('-', "_");
    let likeness = |name: &str| strsim::jaro_winkler(&wrong, name);
    let best = names.iter().copied().max_by(|one, two| likeness(one).total_cmp(&likeness(two)))?;
    (likeness(best) >= LIKENESS).then_some(best)
}

/// Dotted path of the place where a field of this name lives; empty: directly in the case.
fn home_of_field(name: &str) -> Option<String> {
    fn search(fields: &[Field], name: &str, path: &str) -> Option<String> {
        if fields.iter().any(|field| field.name == name) {
            return Some(path.into());
        }
        let join = |part: &str| {
            if path.is_empty() { part.into() } else { format!("{path}.{part}") }
        };
        fields.iter().find_map(|field| match field.kind {
            Kind::Group(fields) => search(fields, name, &join(field.name)),
            kind => choices_of(&kind).iter().find_map(|choice| {
                search(choice.arguments, name, &join(&format!("{}.{}", field.name, choice.name)))
            }),
        })
    }
    search(FIELDS, name, "")
}

/// `map { size: .. }` or `distribution: bands { count: .. }`.
fn written(home: &str, name: &str) -> String {
    match home.split_once('.') {
        Some((field, rest)) => {
            format!("{field}: {} {{ {name}: .. }}", rest.rsplit('.').next().unwrap_or(rest))
        }
        None => format!("{home}: {{ {name}: .. }}"),
    }
}

fn choices_of(kind: &Kind) -> &'static [Choice] {
    match kind {
        Kind::Choice(choices) | Kind::ChoiceList(choices) | Kind::NumberOr { choices, .. } => choices,
        _ => &[],
    }
}
