//! What is taken to the extremes: every technique in every variant, each of its configurations and distributions alone,
//! for every kind of light that it serves.

use std::path::Path;

use cssm_core::LightCase;
use cssm_core::case::{DominantPlane, LightKind};
use cssm_core::distribution::{DISTRIBUTIONS, RemapKind};
use cssm_core::technique::{TECHNIQUES, TechniqueSpec};

use crate::case_file::pick_case;
use crate::catalogue::KINDS;
use crate::error::LabError;

/// A case that is taken to the extremes.
#[derive(Debug, Clone)]
pub struct Subject {
    /// The technique's entry in the name table.
    pub technique: &'static TechniqueSpec,
    /// Variant, kind of light, configuration and distribution, in words.
    pub name: String,
    /// Whether it stands for the technique: a declared variant with the technique's own configurations, under a sun.
    pub is_variant: bool,
    /// The case. Situations set its shadow distance, its map's size and its format.
    pub case: LightCase,
}

/// Share of the map for a dominant plane, and how near to it receivers count as on it.
const DOMINANT: DominantPlane = DominantPlane { share: 0.25, thickness_metres: 0.5 };

/// Name of the technique that a declaration without one has: the house's own, of which nothing may break.
///
/// # Errors
/// When an empty declaration is not sound.
pub fn house_technique() -> Result<&'static str, LabError> {
    let case = LightCase::builder("House").build().map_err(|errors| LabError::Catalogue { errors })?;
    Ok(case.technique.name)
}

/// Every subject whose technique's name is asked for; all of them where none is.
///
/// # Errors
/// When a variant that a technique lists is no sound declaration.
pub fn subjects(only: &[String]) -> Result<Vec<Subject>, LabError> {
    let mut subjects = Vec::new();
    let wanted = |spec: &&TechniqueSpec| only.is_empty() || only.iter().any(|name| name == spec.choice.name);
    for spec in TECHNIQUES.iter().filter(wanted) {
        for light in KINDS {
            of_technique(spec, light, &mut subjects)?;
        }
    }
    Ok(subjects)
}

fn of_technique(
    spec: &'static TechniqueSpec,
    light: LightKind,
    subjects: &mut Vec<Subject>,
) -> Result<(), LabError> {
    let kind = light.name();
    let subject = |name: String, fields: &str, is_variant: bool| {
        let text =
            format!("case Extreme {{ light: {kind}, shadow_distance: 1000 m, {fields}, prefix: extreme }}");
        let case = pick_case(Path::new(&name), &text, None)?;
        Ok::<_, LabError>(Subject { technique: spec, name, is_variant, case })
    };
    let suffix = if light == LightKind::Directional { String::new() } else { format!(", {kind}") };

    // Take every variant with the configurations that serve this light together.
    if !(spec.default_configurations)(light).is_empty() {
        for variant in spec.variants {
            let directional = light == LightKind::Directional;
            let declared =
                subject(format!("{variant}{suffix}"), &format!("technique: {variant}"), directional);
            match declared {
                Ok(declared) => subjects.push(declared),
                // A variant may be made for suns alone.
                Err(error) if directional => return Err(error),
                Err(_) => {}
            }
        }
    }

    // Take every configuration alone with every distribution, straight and bent, in the customary variant.
    let Some(customary) = spec.variants.first() else { return Ok(()) };
    let serving: Vec<_> = spec.configurations.iter().filter(|known| known.lights.contains(&light)).collect();
    let alone = serving.len() > 1 || spec.distribution.is_some();
    for configuration in serving.into_iter().filter(|_| alone) {
        let name = configuration.choice.name;
        let fields = format!("technique: {customary}, configurations: [{name}]");
        if !configuration.takes_distribution || spec.distribution.is_none() {
            subjects.extend(subject(format!("{customary}, {name}{suffix}"), &fields, false));
            continue;
        }
        for distribution in DISTRIBUTIONS {
            let rows = distribution.choice.name;
            let mut push = |bent: &str, stretch: &str| {
                let fields = format!("{fields}, distribution: {rows}, stretch: {stretch}");
                let name = format!("{customary}, {name}, {rows}{bent}{suffix}");
                subjects.extend(subject(name, &fields, false));
            };
            if distribution.straight {
                push("", "none");
            }
            if distribution.bent != RemapKind::None {
                push(" bent", "exact");
            }
        }
    }

    // Take a dominant plane along.
    if spec.choice.name == house_technique()? && light == LightKind::Directional {
        let name = format!("{customary}, dominant plane");
        let mut plane = subject(name, &format!("technique: {customary}"), false)?;
        plane.case.dominant_plane = Some(DOMINANT);
        subjects.push(plane);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_variant_of_every_technique_is_taken() {
        let subjects = subjects(&[]).unwrap();
        for spec in TECHNIQUES {
            let variants = subjects.iter().filter(|subject| subject.is_variant);
            let own = variants.filter(|subject| subject.technique.choice.name == spec.choice.name);
            assert_eq!(own.count(), spec.variants.len(), "{}", spec.choice.name);
        }
        let named = |wanted: &str| subjects.iter().any(|subject| subject.name.contains(wanted));
        assert!(
            named("one_plane, logarithmic bent") && named("cube, omni") && named("light_projection, spot")
        );
    }

    #[test]
    fn techniques_can_be_picked() {
        let subjects = subjects(&["standard".to_owned()]).unwrap();
        assert!(subjects.iter().all(|subject| subject.technique.choice.name == "standard"));
        assert_eq!(subjects.len(), 1);
    }
}
