//! From arguments to a light case: the schema's checks, defaults, contradictions.

use super::arguments::DEFAULT_BOUND;
use super::filter::misplaced_extent;
use super::names::{default_prefix, is_camel_case, is_prefix, upper_camel};
use super::{
    Axes, Bias, CaseError, Casters, DominantPlane, FIELDS, FarKind, Filter, Fit, LightCase, LightKind,
    MapSpec, MaskNormal, Resolve, Stability, Stretch,
};
use crate::distribution::{self, RemapKind};
use crate::schema::{self, Arguments, Choice, Field, Kind, Value, Word};
use crate::technique;

pub(super) fn from_arguments(
    name: &str,
    doc: &str,
    public: bool,
    arguments: &Arguments,
) -> Result<LightCase, Vec<CaseError>> {
    let mut errors = Vec::new();

    // Check every value against the schema: the Rust door does not pass through the text grammar.
    check_fields(FIELDS, arguments, "", &mut errors);
    if !is_camel_case(name) {
        let remedy = format!("use upper camel case, such as `{}`", upper_camel(name));
        errors.push(error("name", format!("`{name}` is not a case name"), remedy));
    }

    // Go on with the fields that hold, and look for contradictions that involve no other field.
    let faulty: Vec<String> = errors.iter().map(|error| top_level(&error.field).to_owned()).collect();
    let sound = arguments.0.iter().filter(|(field, _)| !faulty.iter().any(|faulty| faulty == field));
    let sound = schema::fill(FIELDS, &Arguments(sound.cloned().collect()));
    let (case, contradictions) = read(name, doc, public, &sound);
    errors.extend(contradictions.into_iter().filter(|error| {
        let mut fields = error.related().iter().copied().chain([top_level(&error.field)]);
        !fields.any(|field| faulty.iter().any(|faulty| faulty == field))
    }));
    if errors.is_empty() { Ok(case) } else { Err(errors) }
}

/// Other fields that a contradiction at a field involves.
pub(super) fn related(field: &str) -> &'static [&'static str] {
    match field {
        "light" => &["technique"],
        "configurations" => &["technique", "light"],
        "stretch" => &["distribution"],
        "distribution" => &["technique", "configurations"],
        "technique" => &["view", "shadow_distance", "bounds"],
        "map.gutter" => &["filter"],
        "filter" | "filter.pcss.angle" | "filter.pcss.radius" => &["light"],
        "resolve.mask.normal" => &["bias"],
        "prefix" => &["name"],
        _ => &[],
    }
}

/// The error of a technique that cannot reach infinitely far, if nothing in the case keeps receivers finite.
fn infinite_receivers(case: &LightCase) -> Option<CaseError> {
    let bounded = case.far == FarKind::Finite || case.shadow_distance_metres.is_some() || case.scene_bounds;
    let message = format!("technique `{}` cannot serve receivers at infinity", case.technique.name);
    let remedy = "declare `shadow_distance: 1000 m`, `bounds: scene` or `view: perspective { far: finite }`";
    (!bounded).then(|| error("technique", message, remedy))
}

/// The case of sound arguments whose defaults are filled in, and its contradictions.
fn read(name: &str, doc: &str, public: bool, arguments: &Arguments) -> (LightCase, Vec<CaseError>) {
    let mut errors = Vec::new();
    let prefix = match arguments.get("prefix") {
        Some(Value::Name(prefix)) => prefix.clone(),
        _ => default_prefix(name),
    };
    if !is_prefix(&prefix) {
        let remedy = "use lower snake case that starts and ends in a letter, such as `sun`";
        errors.push(error("prefix", format!("`{prefix}` cannot prefix shader names"), remedy));
    }

    // Read the technique and what belongs to it.
    let technique = arguments.word("technique").cloned().unwrap_or_else(|| Word::plain("camera_space"));
    let spec = technique::spec(technique.name);
    let mut configurations = arguments.words("configurations").to_vec();
    for word in &configurations {
        if spec.configurations.iter().all(|known| known.choice.name != word.name) {
            let names: Vec<_> =
                spec.configurations.iter().map(|known| format!("`{}`", known.choice.name)).collect();
            errors.push(error(
                "configurations",
                format!("technique `{}` has no configuration `{}`", technique.name, word.name),
                format!("use {}", names.join(", ")),
            ));
        }
    }
    let light = LightKind::of_word(arguments.word("light"));
    for word in &configurations {
        let known = spec.configurations.iter().find(|known| known.choice.name == word.name);
        if known.is_some_and(|known| !known.lights.contains(&light)) {
            let serving: Vec<_> = spec.serving(light).map(|name| format!("`{name}`")).collect();
            errors.push(error(
                "configurations",
                format!("configuration `{}` is not made for a light of kind `{}`", word.name, light.name()),
                match serving.is_empty() {
                    true => format!(
                        "declare another light; technique `{}` serves none of this kind",
                        technique.name
                    ),
                    false => format!("use {}", serving.join(", ")),
                },
            ));
        }
    }
    if configurations.is_empty() {
        let defaults = (spec.default_configurations)(light);
        configurations.extend(defaults.iter().map(|name| spec.configuration(name).choice.word()));
    }
    if configurations.is_empty() {
        let message = format!("technique `{}` serves no light of kind `{}`", technique.name, light.name());
        errors.push(error("light", message, "use technique `camera_space`, or declare another light"));
        configurations.extend(spec.configurations.first().map(|first| first.choice.word()));
    }
    let takes_distribution = |word: &Word| spec.configuration(word.name).takes_distribution;
    let default = spec.distribution.filter(|_| configurations.iter().any(takes_distribution));
    let distribution = match (arguments.word("distribution"), default) {
        (Some(word), None) => {
            let declared: Vec<_> = configurations.iter().map(|word| format!("`{}`", word.name)).collect();
            let message =
                format!("`{}` is declared, but {} takes no distribution", word.name, declared.join(", "));
            errors.push(error("distribution", message, "leave `distribution` out"));
            None
        }
        (Some(word), Some(_)) => Some(word.clone()),
        (None, default) => default.and_then(default_distribution),
    };

    let stretch = stretch(arguments.word("stretch"), distribution.as_ref(), &mut errors);

    // Read the rest.
    let case = LightCase {
        name: name.into(),
        doc: tidy(doc),
        public,
        light,
        far: FarKind::of_view(arguments.word("view")),
        shadow_distance_metres: arguments.number("shadow_distance"),
        scene_bounds: arguments.word("bounds").is_some_and(|word| word.name == "scene"),
        technique,
        configurations,
        distribution,
        stretch,
        dominant_plane: DominantPlane::of_word(arguments.word("dominant_plane")),
        fit: Fit::of_word(arguments.word("fit")),
        stability: Stability::of_word(arguments.word("stability")),
        map: MapSpec::of_group(arguments.group("map")),
        filter: Filter::of_word(arguments.word("filter"), light),
        bias: Bias::of_word(arguments.word("bias")),
        casters: Casters::of_word(arguments.word("casters")),
        axes: Axes::of_word(arguments.word("axes")),
        resolve: arguments.words("resolve").iter().map(Resolve::of_word).collect(),
        prefix,
    };

    // Find what contradicts itself.
    errors.extend((spec.check)(&case));
    if !spec.fits_infinity {
        errors.extend(infinite_receivers(&case));
    }
    if let Some((misplaced, instead)) = misplaced_extent(arguments.word("filter"), light) {
        errors.push(error(
            &format!("filter.pcss.{misplaced}"),
            format!("`{misplaced}` is declared, but the light is of kind `{}`", light.name()),
            format!("give `{instead}`, or leave it out"),
        ));
    }
    if matches!(case.filter, Filter::Evsm2 { .. }) && light.is_local() {
        errors.push(error(
            "filter",
            format!("filter `{}` is not made for a light of kind `{}`", case.filter.name(), light.name()),
            "use `pcss` or `pcf_5x5`, or declare a directional light",
        ));
    }
    let reach = case.filter.radius_texels();
    if let Some(gutter) = case.map.gutter.filter(|gutter| *gutter < reach) {
        let filter = case.filter.name();
        let plural = if reach == 1 { "" } else { "s" };
        errors.push(error(
            "map.gutter",
            format!(
                "a gutter of {gutter} texels is narrower than the reach of filter `{filter}`, {reach} texel{plural}"
            ),
            format!("use `auto` or at least {reach}"),
        ));
    }
    let reads_texture =
        |interface: &Resolve| matches!(interface, Resolve::Mask { normal: MaskNormal::Texture, .. });
    if case.resolve.iter().any(reads_texture) && !case.bias.reads_normal() {
        errors.push(error(
            "resolve.mask.normal",
            format!(
                "the mask is given a texture of normals, but bias `{}` reads no normal",
                case.bias.name()
            ),
            "leave `normal` out, or use bias `receiver_plane` or `slope`",
        ));
    }
    (case, errors)
}

/// How rows are bent: as declared, or as the distribution needs.
fn stretch(declared: Option<&Word>, distribution: Option<&Word>, errors: &mut Vec<CaseError>) -> Stretch {
    let spec = distribution.and_then(|word| distribution::spec(word.name));
    let bends = spec.is_some_and(|spec| spec.bent != RemapKind::None);
    let needs = spec.is_some_and(|spec| !spec.straight);
    let name = distribution.map_or("none", |word| word.name);
    match declared.map(Stretch::of_word) {
        None if needs => Stretch::Exact { bound_texels: DEFAULT_BOUND },
        None => Stretch::None,
        Some(Stretch::None) if needs => {
            let message = format!("distribution `{name}` bends rows, but `stretch: none` is declared");
            errors.push(error("stretch", message, "use `exact` or `vertex`, or distribution `bands`"));
            Stretch::None
        }
        Some(stretch) if stretch != Stretch::None && !bends => {
            let message = format!("distribution `{name}` bends no rows, so there is nothing to stretch");
            errors.push(error("stretch", message, "leave `stretch` out, or use distribution `perspective`"));
            Stretch::None
        }
        Some(stretch) => stretch,
    }
}

/// The default distribution of a technique, such as `bands(8)`, with the schema's arguments.
fn default_distribution(text: &'static str) -> Option<Word> {
    let field = Field::find(FIELDS, "distribution")?;
    let default = schema::Default::Value(text);
    match (Field { default, ..*field }).default_value() {
        Some(Value::Word(word)) => Some(word),
        _ => None,
    }
}

/// The doc text without trailing spaces, blank lines around it, and characters that no comment may hold.
fn tidy(doc: &str) -> String {
    let turns_text = |letter: &char| matches!(letter, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let keep = |letter: &char| (!letter.is_control() || *letter == '\t') && !turns_text(letter);
    let line = |line: &str| -> String {
        let kept: String = line.chars().filter(keep).collect();
        kept.trim_end().into()
    };
    let lines: Vec<String> = doc.lines().map(line).collect();
    lines.join("\n").trim_matches('\n').into()
}

fn check_fields(fields: &'static [Field], arguments: &Arguments, path: &str, errors: &mut Vec<CaseError>) {
    for (index, (name, value)) in arguments.0.iter().enumerate() {
        let path = join(path, name);
        if arguments.0[..index].iter().any(|(earlier, _)| earlier == name) {
            errors.push(error(&path, format!("field `{name}` stands twice"), "keep one of them"));
        }
        match Field::find(fields, name) {
            Some(field) => check_value(&field.kind, value, &path, errors),
            None => errors.push(error(&path, format!("there is no field `{name}`"), "leave it out")),
        }
    }
}

fn check_value(kind: &Kind, value: &Value, path: &str, errors: &mut Vec<CaseError>) {
    if let Err(fault) = kind.check(value) {
        errors.push(error(path, fault.message, fault.remedy));
    }
    match (kind, value) {
        (Kind::Choice(choices) | Kind::NumberOr { choices, .. }, Value::Word(word)) => {
            check_word(kind, choices, word, path, errors)
        }
        (Kind::ChoiceList(choices), Value::Words(words)) => {
            for word in words {
                check_word(kind, choices, word, &join(path, word.name), errors);
            }
        }
        (Kind::Group(fields), Value::Group(arguments)) => check_fields(fields, arguments, path, errors),
        _ => {}
    }
}

fn check_word(kind: &Kind, choices: &'static [Choice], word: &Word, path: &str, errors: &mut Vec<CaseError>) {
    match Choice::find(choices, word.name) {
        Some(choice) => check_fields(choice.arguments, &word.arguments, path, errors),
        None => {
            errors.push(error(path, format!("there is no `{}` here", word.name), format!("use {kind}")));
        }
    }
}

fn error(field: &str, message: String, remedy: impl Into<String>) -> CaseError {
    CaseError { field: field.into(), message, remedy: remedy.into() }
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.into() } else { format!("{path}.{name}") }
}

fn top_level(path: &str) -> &str {
    path.split('.').next().unwrap_or(path)
}
