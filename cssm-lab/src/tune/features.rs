//! What a declaration could do without: every single thing that can be taken from it or made less.

use cssm_core::LightCase;
use cssm_core::case::{Bias, Casters, DepthFormat, Filter, MAP_SIDE_LIMIT_TEXELS, Stretch};
use cssm_core::distribution;
use cssm_core::schema::{Field, Kind, Value, Word};

use super::space::{replaced, with_field};
use crate::gpu::ResolveMethod;

/// One thing less.
#[derive(Debug, Clone)]
pub struct Removal {
    /// What, in words of the declaration.
    pub what: String,
    /// The declaration without it, or why there is none.
    pub without: Result<LightCase, String>,
}

/// Sides of square maps that are tried: powers of two and the quarters between them.
pub fn sides() -> impl Iterator<Item = u32> {
    let quarters = |power: u32| (4..8).map(move |quarters| (1 << power) / 4 * quarters);
    (6..=14).flat_map(quarters).filter(|side| *side <= MAP_SIDE_LIMIT_TEXELS)
}

/// The largest of [`sides`] below a side.
pub fn side_below(side: u32) -> Option<u32> {
    sides().take_while(|step| *step < side).last()
}

/// Everything that can be taken from a case, one at a time; what saves most comes first.
pub fn removals(case: &LightCase, interface: ResolveMethod) -> Vec<Removal> {
    let mut list = Vec::new();
    list.extend(format(case));
    list.extend(side(case));
    list.extend(interfaces(case, interface));
    list.extend(configurations(case));
    list.extend(counts(case));
    list.extend(plain_choices(case));
    list.extend(filters(case));
    list.extend(gutter(case));
    list
}

fn format(case: &LightCase) -> Option<Removal> {
    let mut less = case.clone();
    less.map.format = DepthFormat::Depth16Unorm;
    let what = "map format depth32float, depth16unorm instead".to_owned();
    (case.map.format == DepthFormat::Depth32Float).then_some(Removal { what, without: Ok(less) })
}

fn side(case: &LightCase) -> Option<Removal> {
    let old = case.map.width;
    let new = side_below(old)?;
    let mut less = case.clone();
    (less.map.width, less.map.height) = (new, new);
    let what = format!("map side {old}, {new} instead");
    Some(Removal { what, without: Ok(less) })
}

/// All interfaces but the one that is asked for, then that one.
fn interfaces(case: &LightCase, interface: ResolveMethod) -> Vec<Removal> {
    let arguments = case.to_arguments();
    let words = arguments.words("resolve");
    let wanted = match interface {
        ResolveMethod::Function => "function",
        ResolveMethod::Mask => "mask",
    };
    let mut names: Vec<&'static str> = words.iter().map(|word| word.name).collect();
    names.sort_by_key(|name| *name == wanted);
    let without = |name: &str| {
        let rest: Vec<Word> = words.iter().filter(|word| word.name != name).cloned().collect();
        if rest.is_empty() {
            return Err("nothing would resolve".to_owned());
        }
        with_field(case, "resolve", Value::Words(rest))
    };
    let removal = |name: &'static str| Removal { what: format!("interface {name}"), without: without(name) };
    names.into_iter().map(removal).collect()
}

/// Each configuration, where there are several.
fn configurations(case: &LightCase) -> Vec<Removal> {
    if case.configurations.len() < 2 {
        return Vec::new();
    }
    let without = |index: usize| {
        let mut rest = case.configurations.clone();
        rest.remove(index);
        rebuilt(case, "configurations", Value::Words(rest))
    };
    let removal = |(index, word): (usize, &Word)| Removal {
        what: format!("configuration {}", word.name),
        without: without(index),
    };
    case.configurations.iter().enumerate().map(removal).collect()
}

/// One less of everything that is counted: bands, folds, splits. Each is a facet, or several.
fn counts(case: &LightCase) -> Vec<Removal> {
    let mut list = Vec::new();
    let technique = case.technique_spec();
    for (word, name, count) in one_less(&case.technique, technique.choice.arguments) {
        let without = with_field(case, "technique", Value::Word(word));
        list.push(Removal { what: format!("one of {count} {name}"), without });
    }
    for (index, configuration) in case.configurations.iter().enumerate() {
        let fields = technique.configuration(configuration.name).choice.arguments;
        for (word, name, count) in one_less(configuration, fields) {
            let mut words = case.configurations.clone();
            words[index] = word;
            let what = format!("one of {count} {name} of {}", configuration.name);
            list.push(Removal { what, without: with_field(case, "configurations", Value::Words(words)) });
        }
    }
    if let Some(distribution) = &case.distribution {
        let fields = distribution::spec(distribution.name).map_or(&[][..], |spec| spec.choice.arguments);
        for (word, name, count) in one_less(distribution, fields) {
            let things = if name == "count" { distribution.name } else { name };
            let without = with_field(case, "distribution", Value::Word(word));
            list.push(Removal { what: format!("one of {count} {things}"), without });
        }
    }
    list
}

fn one_less(word: &Word, fields: &[Field]) -> Vec<(Word, &'static str, u32)> {
    let less = |field: &Field| match (field.kind, word.arguments.get(field.name)?) {
        (Kind::Count { min, .. }, Value::Count(count)) if *count > min => {
            Some((replaced(word, field.name, Value::Count(count - 1)), field.name, *count))
        }
        _ => None,
    };
    fields.iter().filter_map(less).collect()
}

/// What stands in the way of the plainest words: fixed columns, stretching, a dominant plane, alpha test, bounds, bias.
fn plain_choices(case: &LightCase) -> Vec<Removal> {
    let mut list = Vec::new();
    let mut push = |what: String, change: &dyn Fn(&mut LightCase)| {
        let mut less = case.clone();
        change(&mut less);
        list.push(Removal { what, without: checked(&less) });
    };
    if let Some(columns) = case.map.columns {
        push(format!("fixed {columns} columns, auto instead"), &|case| case.map.columns = None);
    }
    if case.stretch != Stretch::None {
        push("stretching".to_owned(), &|case| case.stretch = Stretch::None);
    }
    if case.dominant_plane.is_some() {
        push("the dominant plane's facet".to_owned(), &|case| case.dominant_plane = None);
    }
    if case.casters == Casters::AlphaTested {
        push("alpha test of casters".to_owned(), &|case| case.casters = Casters::Opaque);
    }
    if case.scene_bounds {
        push("bounds of the scene".to_owned(), &|case| case.scene_bounds = false);
    }
    if case.bias != Bias::None {
        let bias = case.bias.name();
        push(format!("bias {bias}, none instead"), &|case| case.bias = Bias::None);
    }
    list
}

/// Filters that read less, or compare less.
fn filters(case: &LightCase) -> Vec<Removal> {
    let less = match case.filter {
        Filter::None => &[][..],
        Filter::Hardware2x2 => &[Filter::None][..],
        Filter::Gather2x2 => &[Filter::None, Filter::Hardware2x2][..],
        Filter::Pcf { .. } | Filter::Pcss { .. } | Filter::Evsm2 { .. } | Filter::GroundMasks { .. } => {
            &[Filter::None, Filter::Hardware2x2, Filter::Gather2x2][..]
        }
    };
    let removal = |filter: &Filter| {
        let what = format!("filter {}, {} instead", case.filter.name(), filter.name());
        let mut less = case.clone();
        less.filter = *filter;
        Removal { what, without: checked(&less) }
    };
    less.iter().map(removal).collect()
}

/// One texel of the gutter that is more than filter taps reach.
fn gutter(case: &LightCase) -> Option<Removal> {
    let gutter = case.gutter_texels();
    let less = gutter.checked_sub(1)?;
    // A single tile has no neighbours to be kept from.
    let what = format!("gutters of {gutter} texels, {less} instead");
    let mut narrower = case.clone();
    narrower.map.gutter = Some(less);
    (case.shape().cells() > 1).then(|| Removal { what, without: checked(&narrower) })
}

/// Configurations of the technique that a case leaves out, each with the case that declares it too.
pub fn additions(case: &LightCase) -> Vec<(&'static str, Result<LightCase, String>)> {
    let spec = case.technique_spec();
    let serving: Vec<&'static str> = spec.serving(case.light).collect();
    let absent = |name: &&'static str| case.configurations.iter().all(|word| word.name != *name);
    let with = |name: &'static str| {
        let mut words = case.configurations.clone();
        words.push(spec.configuration(name).choice.word());
        (name, rebuilt(case, "configurations", Value::Words(words)))
    };
    serving.into_iter().filter(absent).map(with).collect()
}

/// The case with other configurations; a distribution that none of them takes goes too.
fn rebuilt(case: &LightCase, name: &'static str, value: Value) -> Result<LightCase, String> {
    with_field(case, name, value.clone()).or_else(|_| {
        let plain = LightCase { distribution: None, stretch: Stretch::None, ..case.clone() };
        with_field(&plain, name, value)
    })
}

/// The case if it can be declared.
fn checked(case: &LightCase) -> Result<LightCase, String> {
    let arguments = case.to_arguments();
    let made = LightCase::from_arguments(&case.name, &case.doc, case.public, &arguments);
    made.map_err(|errors| errors.iter().map(|error| error.message.as_str()).collect::<Vec<_>>().join("; "))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case() -> LightCase {
        let text = "pub case Sun { technique: camera_space, configurations: [face_columns, four_plane], \
                    bounds: scene, distribution: bands(4), map: { size: 1024 x 1024, columns: 2 }, prefix: sun }";
        cssm_codegen::dsl::parse_file("sun", text).unwrap().remove(0)
    }

    #[test]
    fn everything_can_be_taken_away_once() {
        let list = removals(&case(), ResolveMethod::Function);
        let words: Vec<&str> = list.iter().map(|removal| removal.what.as_str()).collect();
        for wanted in [
            "map format depth32float, depth16unorm instead",
            "map side 1024, 896 instead",
            "interface mask",
            "interface function",
            "configuration face_columns",
            "configuration four_plane",
            "one of 4 bands",
            "fixed 2 columns, auto instead",
            "bounds of the scene",
            "bias receiver_plane, none instead",
            "filter gather_2x2, none instead",
            "gutters of 2 texels, 1 instead",
        ] {
            assert!(words.contains(&wanted), "{wanted} in {words:?}");
        }
        let whole = list.iter().filter_map(|removal| removal.without.as_ref().ok());
        assert!(whole.clone().all(|less| *less != case()));
        let no_columns = list.iter().find(|removal| removal.what == "configuration face_columns").unwrap();
        assert_eq!(no_columns.without.as_ref().unwrap().distribution, None);
    }

    #[test]
    fn the_least_case_has_little_to_give() {
        let text = "pub case Sun { technique: standard, bounds: scene, bias: none, filter: none, resolve: [mask], \
                    map: { size: 64 x 64, format: depth16unorm }, prefix: sun }";
        let case = cssm_codegen::dsl::parse_file("sun", text).unwrap().remove(0);
        let list = removals(&case, ResolveMethod::Mask);
        let words: Vec<&str> = list.iter().map(|removal| removal.what.as_str()).collect();
        assert_eq!(words, ["interface mask", "bounds of the scene"]);
        assert!(list.iter().all(|removal| removal.without.is_err()), "{list:?}");
    }

    #[test]
    fn sides_are_powers_of_two_and_their_quarters() {
        assert_eq!(side_below(1024), Some(896));
        assert_eq!(side_below(896), Some(768));
        assert_eq!(side_below(1000), Some(896));
        assert_eq!(side_below(64), None);
        assert_eq!(sides().last(), Some(MAP_SIDE_LIMIT_TEXELS));
    }
}
