//! The function that materials and the mask pass call. It is the same chain for every case; what depends on the case is
//! which lines it has and which arguments the picked files take. Its text is put together here, a part for each property,
//! where files would need one for each combination.

use cssm_core::case::{Bias, LightCase};
use cssm_core::table::CaseTable;

/// The function, under the library's own names. It calls what [`super::resolve::files`] names, and takes nothing that no
/// called function reads.
pub(super) fn visibility(case: &LightCase, table: &CaseTable) -> String {
    let receiver = receiver(case, table);
    let head = if case.bias.reads_normal() { WITH_NORMAL } else { WITHOUT_NORMAL };
    let own = if table.cells() > 1 { OWN_OF_MANY } else { OWN_OF_ONE };
    let masked = if case.filter.ground_planes() > 0 { MASKED } else { "" };
    let compared = match case.filter.is_wide() {
        false => format!("    return filtered_visibility({receiver});\n"),
        true => format!("    let receiver = {receiver};\n{WIDE}"),
    };
    format!("{SUMMARY}{head}{own}{COVERED}{masked}{compared}}}\n")
}

/// Whether the bias reads where a light stands.
pub(super) fn reads_light(case: &LightCase, table: &CaseTable) -> bool {
    table.local_light && case.bias != Bias::None
}

/// What it returns.
const SUMMARY: &str = "\
/// Share of the light that reaches a receiver: 1 in the light and outside the map, 0 in shadow.
///
";

/// What it takes where the bias reads no normal.
const WITHOUT_NORMAL: &str = "\
/// `position` is relative to the eye, in the case's axes and metres. The function takes no derivatives, so any control
/// flow may call it.
fn visibility(position: vec3<f32>) -> f32 {
";

/// What it takes where the bias reads the normal.
const WITH_NORMAL: &str = "\
/// `position` is relative to the eye, in metres; `normal` is the geometric normal there; both are in the case's axes.
/// The function takes no derivatives, so any control flow may call it.
fn visibility(position: vec3<f32>, normal: vec3<f32>) -> f32 {
";

/// The receiver's place in the only facet.
const OWN_OF_ONE: &str = "    let facet = shadow.facets[0];
    let place = place_in_facet(facet, facet_position(position));
";

/// The receiver's place in the facet that the walk ends at.
const OWN_OF_MANY: &str = "    let point = facet_position(position);
    let facet = own_facet(point);
    let place = place_in_facet(facet, point);
";

/// Receivers outside their tile are lit.
const COVERED: &str = "    if !place.covered {
        return 1.0;
    }
";

/// Receivers on a plane with a mask read that alone.
const MASKED: &str = "    let plane = masked_plane(position);
    if plane < GROUND_PLANES {
        return masked_visibility(place, plane);
    }
";

/// A filter that finds how wide its kernel is.
const WIDE: &str = "    return filtered_visibility(receiver, kernel_at(facet, place));
";

/// The call of the bias with what it reads: its place, its facet, where the light stands, the normal. Where a light
/// stands, position and normal are the caller's, and the bias turns the normal by itself.
fn receiver(case: &LightCase, table: &CaseTable) -> String {
    let mut arguments = Vec::new();
    arguments.extend((case.bias != Bias::None).then_some("facet"));
    arguments.push("place");
    let local = reads_light(case, table);
    arguments.extend(local.then_some("position"));
    if case.bias.reads_normal() {
        arguments.push(if local { "normal" } else { "facet_normal(normal)" });
    }
    format!("biased_receiver({})", arguments.join(", "))
}
