//! Cases of the figures, from declarations.

use std::path::Path;

use cssm_core::LightCase;
use cssm_core::technique::{TECHNIQUES, TechniqueSpec};

use crate::case_file::pick_case;
use crate::error::LabError;

/// A case of a technique as its declaration spells it, with further fields; the map is square.
///
/// # Errors
/// When the declaration is not sound.
pub fn case(
    technique: &str,
    fields: &str,
    side_texels: u32,
    distance_metres: f64,
) -> Result<LightCase, LabError> {
    let text = format!(
        "case Figure {{ light: directional, shadow_distance: {distance_metres} m, technique: {technique}, {fields} \
         map: {{ size: {side_texels} x {side_texels} }}, prefix: figure }}"
    );
    pick_case(Path::new(technique), &text, None)
}

/// A technique of the name table; the papers' figures name theirs, and are left out where the house does not have it.
pub fn technique(name: &str) -> Option<&'static TechniqueSpec> {
    TECHNIQUES.iter().find(|spec| spec.choice.name == name)
}

/// The first variant of a technique that contains a word; any, for an empty word.
pub fn variant(name: &str, word: &str) -> Option<&'static str> {
    technique(name)?.variants.iter().copied().find(|variant| variant.contains(word))
}

/// A variant with one argument more.
pub fn with_argument(variant: &str, argument: &str) -> String {
    match variant.strip_suffix('}') {
        Some(open) => format!("{}, {argument} }}", open.trim_end()),
        None => format!("{variant} {{ {argument} }}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_are_added_to_what_there_is() {
        assert_eq!(with_argument("one", "focus: 5 m"), "one { focus: 5 m }");
        assert_eq!(with_argument("one { rule: two }", "focus: 5 m"), "one { rule: two, focus: 5 m }");
    }
}
