//! Everything there is to judge: a case for every kind of light, configuration and distribution, and every situation of a
//! scene.

use cssm_core::case::{CaseError, LightKind, Stretch};
use cssm_core::distribution::{DISTRIBUTIONS, RemapKind};
use cssm_core::schema::Word;
use cssm_core::technique::{TECHNIQUES, TechniqueSpec};
use cssm_core::{Light, LightCase, View};

use crate::error::LabError;
use crate::scene::Scene;

/// A case with one configuration and one distribution.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Kind, peer technique, configuration, distribution and whether rows are bent, in words.
    pub name: String,
    /// The configuration.
    pub configuration: &'static str,
    /// The case.
    pub case: LightCase,
}

/// Rows are bent exactly from this bound on.
const EXACT: Stretch = Stretch::Exact { bound_texels: 0.25 };

/// Kinds of light.
pub const KINDS: [LightKind; 3] = [LightKind::Directional, LightKind::Spot, LightKind::Omni];

/// Technique whose configurations are named without it.
const HOUSE: &str = "camera_space";

/// Every configuration of every technique for a kind of light, with every distribution, straight and bent.
///
/// # Errors
/// What a declaration says, which is a fault of this list.
pub fn entries(light: LightKind) -> Result<Vec<Entry>, Vec<CaseError>> {
    let mut entries = Vec::new();
    for spec in TECHNIQUES {
        for configuration in spec.configurations.iter().filter(|known| known.lights.contains(&light)) {
            let name = configuration.choice.name;
            if !configuration.takes_distribution {
                entries.push(entry(spec, light, name, None)?);
                continue;
            }
            for distribution in DISTRIBUTIONS {
                let word = Word::plain(distribution.choice.name);
                if distribution.straight {
                    entries.push(entry(spec, light, name, Some((word.clone(), Stretch::None)))?);
                }
                if distribution.bent != RemapKind::None {
                    entries.push(entry(spec, light, name, Some((word, EXACT)))?);
                }
            }
        }
    }
    Ok(entries)
}

fn entry(
    spec: &TechniqueSpec,
    light: LightKind,
    configuration: &'static str,
    rows: Option<(Word, Stretch)>,
) -> Result<Entry, Vec<CaseError>> {
    // A technique with one configuration is its configuration.
    let mut name = match (spec.choice.name, spec.configurations.len()) {
        (HOUSE, _) => format!("{} {configuration}", light.name()),
        (technique, 1) => format!("{} {technique}", light.name()),
        (technique, _) => format!("{} {technique} {configuration}", light.name()),
    };
    let bent = rows.as_ref().is_some_and(|(_, stretch)| *stretch != Stretch::None);
    if let Some((word, _)) = &rows {
        name += &format!(" {}{}", word.name, if bent { " stretched" } else { "" });
    }
    let mut builder = LightCase::builder(&camel(&name))
        .light(light)
        .technique(Word::plain(spec.choice.name))
        .configurations(&[configuration])
        .scene_bounds(!spec.fits_infinity);
    if let Some((word, stretch)) = rows {
        builder = builder.distribution(word).stretch(stretch);
    }
    Ok(Entry { name, configuration, case: builder.build()? })
}

/// Words in upper camel case.
fn camel(words: &str) -> String {
    words
        .split([' ', '_'])
        .flat_map(|word| {
            let mut letters = word.chars();
            letters.next().map(|letter| letter.to_ascii_uppercase()).into_iter().chain(letters)
        })
        .collect()
}

/// A view and a light of a scene.
#[derive(Debug, Clone)]
pub struct Situation {
    /// Which view with its sun, or which lamp.
    pub name: String,
    /// The view.
    pub view: View,
    /// The light.
    pub light: Light,
}

/// Every view of a scene under its own sun, and every lamp.
///
/// # Errors
/// When a viewpoint makes no sense.
pub fn situations(scene: &Scene, size_pixels: (u32, u32)) -> Result<Vec<Situation>, LabError> {
    let mut situations = Vec::new();
    for (number, spot) in scene.views.iter().enumerate() {
        let (view, light) = spot.pictured(size_pixels)?;
        situations.push(Situation { name: format!("sun-{number}"), view, light });
    }
    for lamp in &scene.lamps {
        let (view, light) = lamp.pictured(size_pixels)?;
        situations.push(Situation { name: lamp.name.to_owned(), view, light });
    }
    Ok(situations)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_light_has_every_configuration_that_serves_it() {
        let names =
            |kind| -> Vec<String> { entries(kind).unwrap().into_iter().map(|entry| entry.name).collect() };
        let omni = names(LightKind::Omni);
        for wanted in [
            "omni cube",
            "omni eight_plane",
            "omni face_columns bands",
            "omni one_plane logarithmic stretched",
        ] {
            assert!(omni.iter().any(|name| name == wanted), "{wanted} in {omni:?}");
        }
        assert!(names(LightKind::Spot).iter().any(|name| name == "spot light_projection"));
        assert!(names(LightKind::Directional).iter().any(|name| name == "directional trapezoidal"));
        assert!(!names(LightKind::Directional).iter().any(|name| name == "directional cube"));
    }

    #[test]
    fn every_scene_has_suns_and_lamps() {
        for scene in [Scene::palm(), Scene::pavilion()] {
            let situations = situations(&scene, (64, 36)).unwrap();
            assert_eq!(situations.len(), 12);
            assert!(situations.iter().any(|situation| situation.name == "spot-dueling"));
        }
    }
}
