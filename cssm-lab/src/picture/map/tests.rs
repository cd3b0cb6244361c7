use std::path::Path;

use cssm_core::glam::DVec3;
use cssm_core::plan::DepthOrder;
use cssm_core::{Light, SceneBounds, View, plan};
use shaders_gen::shipped;

use super::*;
use crate::case_file::{pick_case, with_map_size};
use crate::score::footprints::map_texel;

/// Four planes with the light behind the view.
fn four_planes() -> (ShadowPlan, View) {
    let case = pick_case(Path::new("four_plane.cssm"), shipped::FOUR_PLANE, None).unwrap();
    let case = with_map_size(case, (512, 512)).unwrap();
    let view =
        View::perspective(DVec3::ZERO, -DVec3::Z, DVec3::Y, 1.0, 0.2, f64::INFINITY, (64, 48)).unwrap();
    let light = Light::directional_travelling(DVec3::new(0.1, -0.15, -1.0)).unwrap();
    (plan(&case, &view, &light, &SceneBounds::default()).unwrap(), view)
}

#[test]
fn texels_of_a_shared_tile_go_to_the_facet_that_clips_them_out() {
    let (plan, view) = four_planes();
    assert!(plan.facets.len() > 1 && plan.facets.iter().all(|facet| facet.tile == plan.facets[0].tile));
    let parts: Vec<_> = plan.facets.iter().map(Part::of).collect();
    let gutter = f64::from(plan.facets[0].tile.gutter) * 2.0 / f64::from(plan.facets[0].tile.width);
    let (mut judged, mut first) = (0, 0);
    for index in 0..4000 {
        let (x, y) = (f64::from(index % 64) + 0.5, f64::from(index / 64 % 48) + 0.5);
        let point = view.ray_world(x, y) * (1.0 + f64::from(index % 97));
        let facet = plan.facet(plan.selection.cell(point.extend(1.0))).unwrap();
        let Some((x, y)) = map_texel(facet, point) else { continue };
        let own = plan.facets.iter().position(|other| other.first_cell() == facet.first_cell()).unwrap();
        // Points beside an inner edge lie in the gutters of both facets.
        if parts[own].depth(x, y) > 2.0 * gutter {
            assert_eq!(owner(&parts, x, y), own, "texel {x:.1}, {y:.1}");
            judged += 1;
            first += usize::from(own == 0);
        }
    }
    assert!(judged > 1000 && first < judged * 3 / 4, "{first} of {judged} in the first facet");
}

#[test]
fn triangles_of_a_tile_are_outlined_and_numbered() {
    let (mut plan, _) = four_planes();
    let depths = vec![plan.depth_order.cleared() as f32; 512 * 512];
    let count = |picture: &Picture, colour| picture.pixels.iter().filter(|pixel| **pixel == colour).count();
    let shared = map_picture_of_size(&plan, &depths, (256, 256));
    plan.facets.truncate(1);
    let single = map_picture_of_size(&plan, &depths, (256, 256));
    assert!(count(&shared, OUTLINE) > count(&single, OUTLINE) + 250, "{}", count(&shared, OUTLINE));
    assert!(count(&shared, NUMBER) > 2 * count(&single, NUMBER));
    assert_eq!(count(&shared, UNUSED), 0);
}

#[test]
fn nearer_depths_are_lighter_in_either_order() {
    let (mut plan, _) = four_planes();
    plan.facets.truncate(1);
    for (order, near, far) in [(DepthOrder::Standard, 0.2, 0.6), (DepthOrder::Reversed, 0.6, 0.2)] {
        plan.depth_order = order;
        let mut depths = vec![order.cleared() as f32; 512 * 512];
        (depths[100 * 512 + 200], depths[100 * 512 + 300]) = (near, far);
        let picture = map_picture(&plan, &depths);
        let at = |x: usize| picture.pixels[100 * 512 + x];
        assert_eq!((at(200), at(300), at(400)), ([250; 3], [50; 3], EMPTY), "{order:?}");
    }
}
