//! The scenes' own views are worth judging: enough shadow, enough edges, and a facet corner in sight.

use std::path::Path;

use cssm_core::case::Filter;
use cssm_core::glam::DVec3;
use cssm_core::light::LightPosition;
use cssm_core::{Light, SceneBounds, View, plan};
use cssm_lab::case_file::pick_case;
use cssm_lab::scene::Scene;
use cssm_lab::score::footprints::Assignment;
use cssm_lab::score::{Judged, NO_FACET, TrueEdges, score};
use cssm_lab::truth::{Frame, Tracer};

const SIZE: (u32, u32) = (640, 360);

/// Whether three facets meet around a pixel.
fn shows_facet_corner(facets: &[u32]) -> bool {
    let width = SIZE.0 as usize;
    (0..facets.len() - width - 1).filter(|index| (index + 1) % width > 0).any(|index| {
        let mut around =
            [index, index + 1, index + width, index + width + 1].map(|pixel| facets[pixel]).to_vec();
        around.sort_unstable();
        around.dedup();
        around.len() >= 3 && !around.contains(&NO_FACET)
    })
}

/// Elevation of the light below which shadows are long, in degrees.
const LOW_SUN_DEGREES: f64 = 20.0;

#[test]
fn views_show_shadows_edges_and_a_facet_corner() {
    let text = "pub case Sun { technique: camera_space, distribution: bands(8), prefix: sun }";
    let sun = pick_case(Path::new("sun.cssm"), text, None).unwrap();
    let (mut low, mut dueling) = (0, 0);
    for scene in [Scene::palm(), Scene::city(), Scene::pavilion(), Scene::forest()] {
        let tracer = Tracer::new(&scene);
        let bounds = SceneBounds::of(scene.bounds_world());
        assert_eq!(scene.views.len(), 3);
        let mut corners = 0;
        for (index, spot) in scene.views.iter().enumerate() {
            let (eye, target) = (spot.eye_world, spot.target_world);
            let field = 60_f64.to_radians();
            let view = View::perspective(eye, target, DVec3::Y, field, 0.2, f64::INFINITY, SIZE).unwrap();
            let light = Light::directional_travelling(spot.light_travels).unwrap();
            let frame = Frame::trace(&tracer, &view, &light, &|_| {});
            let plan = plan(&sun, &view, &light, &bounds).unwrap();
            let assignment = Assignment::new(&plan, &view, &frame, Filter::Gather2x2);
            let (score, _) = score(&Judged {
                frame: &frame,
                visibility: &vec![1.0; frame.pixels.len()],
                footprints: &assignment.footprints,
                facets: &assignment.facets,
                true_edges: &TrueEdges::of(&frame, None),
            });
            let name = &scene.name;
            println!("{name} {index}: {:.3} shadowed, {} edges", score.shadowed, score.true_edge_pixels);
            assert!(score.shadowed >= 0.05, "{name} {index}: {} shadowed", score.shadowed);
            assert!(score.true_edge_pixels >= 5000, "{name} {index}: {} edges", score.true_edge_pixels);
            assert!(score.interior_area >= 0.3, "{name} {index}: {} interior", score.interior_area);
            assert_eq!(score.acne.total, 0.0, "a map that lights everything has no acne");
            corners += usize::from(shows_facet_corner(&assignment.facets));
            let elevation = libm::asin(-spot.light_travels.normalize().y).to_degrees();
            low += usize::from(elevation < LOW_SUN_DEGREES);
            dueling += usize::from(plan.choice.position == LightPosition::Dueling);
        }
        assert!(corners > 0, "{} shows no facet corner", scene.name);
    }
    assert!(
        low >= 2 && dueling >= 3,
        "{low} views with a low sun, {dueling} with a light in or opposite the view"
    );
}
