//! Every way to make a shadow map that is worth comparing, as declarations: techniques in their variants, configurations,
//! distributions, map sides and filters.
//!
//! Nothing here knows a technique by name: the tables of `cssm-core` are enumerated, and every case is built by the text
//! grammar, so that a user can declare what a report shows.

use cssm_core::LightCase;
use cssm_core::case::{Filter, LightKind};
use cssm_core::distribution::{DISTRIBUTIONS, RemapKind};
use cssm_core::technique::{TECHNIQUES, TechniqueSpec};

use super::error::MeasureError;

/// A way to make a shadow map, without its size and filter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Form {
    /// The technique.
    pub technique: &'static str,
    /// Kind of light.
    pub light: &'static str,
    /// The field `technique` as declared.
    pub declared: String,
    /// The fields `configurations`, `distribution` and `stretch`, as declared; empty where all defaults stand.
    pub rows: Vec<String>,
}

/// Filters in declarations.
pub const FILTERS: [Filter; 3] = [Filter::None, Filter::Hardware2x2, Filter::Gather2x2];

/// Prefix of every shader name.
const PREFIX: &str = "measured";

impl Form {
    /// What it is called in reports: the declaration without its keys.
    pub fn label(&self) -> String {
        let mut words = short(&self.declared);
        for row in &self.rows {
            let (_, value) = row.split_once(": ").unwrap_or(("", row));
            words += &format!(" {}", short(value));
        }
        words
    }

    /// The declaration, with a map of so many texels a side.
    pub fn declaration(&self, side: u32, filter: Filter) -> String {
        let mut text = format!(
            "pub case {} {{\n    light: {},\n    bounds: scene,\n    technique: {},\n",
            camel(&self.label()),
            self.light,
            self.declared
        );
        for row in &self.rows {
            text += &format!("    {row},\n");
        }
        text + &format!(
            "    map: {{ size: {side} x {side} }},\n    filter: {},\n    prefix: {PREFIX},\n}}\n",
            filter.name()
        )
    }

    /// The case that the declaration stands for.
    ///
    /// # Errors
    /// [`MeasureError::Variant`] when the declaration has faults, which is a fault of the technique's table.
    pub fn case(&self, side: u32, filter: Filter) -> Result<LightCase, MeasureError> {
        let text = self.declaration(side, filter);
        let cases = cssm_codegen::dsl::parse_file("variant.cssm", &text);
        let fault = |report: String| MeasureError::Variant { label: self.label(), report };
        let mut cases = cases.map_err(|report| fault(report.render()))?;
        cases.pop().ok_or_else(|| fault("it declares nothing".to_owned()))
    }
}

/// Every form for a kind of light: each technique in each variant with its defaults, then each configuration by itself with
/// each distribution, straight and bent.
pub fn forms(light: LightKind) -> Vec<Form> {
    let serving = TECHNIQUES.iter().filter(|spec| !(spec.default_configurations)(light).is_empty());
    serving.flat_map(|spec| forms_of(spec, light)).collect()
}

/// The forms of one technique.
pub fn forms_of(spec: &TechniqueSpec, light: LightKind) -> Vec<Form> {
    let names: Vec<&str> = spec.serving(light).collect();
    let mut forms = Vec::new();
    for variant in spec.variants {
        let form = |rows: Vec<String>| Form {
            technique: spec.choice.name,
            light: light.name(),
            declared: (*variant).to_owned(),
            rows,
        };
        forms.push(form(Vec::new()));
        let one_way =
            names.len() < 2 && names.iter().all(|name| !spec.configuration(name).takes_distribution);
        if one_way {
            continue;
        }
        for name in &names {
            let configurations = format!("configurations: [{name}]");
            if !spec.configuration(name).takes_distribution {
                forms.push(form(vec![configurations]));
                continue;
            }
            for distribution in DISTRIBUTIONS {
                let bends = distribution.bent != RemapKind::None;
                let rows = |stretch: &str| {
                    let distribution = format!("distribution: {}", distribution.choice.name);
                    let stretch = bends.then(|| format!("stretch: {stretch}"));
                    form([configurations.clone(), distribution].into_iter().chain(stretch).collect())
                };
                if distribution.straight {
                    forms.push(rows("none"));
                }
                if bends {
                    forms.push(rows("exact"));
                }
            }
        }
    }
    forms
}

/// A declared value without its keys and braces: `split { n: 4, scheme: log }` becomes `split(4, log)`.
fn short(declared: &str) -> String {
    let mut words = String::new();
    for word in declared.split_whitespace() {
        match word {
            "{" => words.push('('),
            "}" => {
                words.truncate(words.trim_end().len());
                words.push(')');
            }
            key if key.ends_with(':') => {}
            "}," => {
                words.truncate(words.trim_end().len());
                words += "), ";
            }
            value => {
                words += value;
                if value.ends_with(',') {
                    words.push(' ');
                }
            }
        }
    }
    words.trim().trim_start_matches('[').trim_end_matches(']').to_owned()
}

/// Words in upper camel case, everything but letters and digits left out.
fn camel(words: &str) -> String {
    words
        .split(|letter: char| !letter.is_ascii_alphanumeric())
        .flat_map(|word| {
            let mut letters = word.chars();
            letters.next().map(|letter| letter.to_ascii_uppercase()).into_iter().chain(letters)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_form_of_every_light_declares_a_case() {
        for light in [LightKind::Directional, LightKind::Spot, LightKind::Omni] {
            let forms = forms(light);
            assert!(forms.len() > 5, "{light:?}: {forms:?}");
            for form in &forms {
                for filter in FILTERS {
                    let case = form.case(512, filter).unwrap();
                    assert_eq!((case.map.width, case.filter, case.light), (512, filter, light));
                    assert_eq!(case.technique.name, form.technique);
                }
            }
            let mut labels: Vec<String> = forms.iter().map(Form::label).collect();
            labels.sort();
            labels.dedup();
            assert_eq!(labels.len(), forms.len(), "two forms share a label: {labels:?}");
        }
    }

    #[test]
    fn every_technique_for_directional_lights_is_there() {
        let forms = forms(LightKind::Directional);
        for spec in TECHNIQUES {
            for variant in spec.variants {
                assert!(forms.iter().any(|form| form.declared == *variant), "{variant}");
            }
        }
    }

    #[test]
    fn labels_leave_keys_out() {
        assert_eq!(short("split { n: 4, scheme: mixed { lambda: 0.5 } }"), "split(4, mixed(0.5))");
        assert_eq!(short("split { scheme: mixed { lambda: 0.5 }, n: 4 }"), "split(mixed(0.5), 4)");
        assert_eq!(short("[face_columns]"), "face_columns");
        assert_eq!(camel("split(4, mixed(0.5)) none"), "Split4Mixed05None");
    }
}
