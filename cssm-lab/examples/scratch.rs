//! scratch
use cssm_core::glam::DVec3;
use cssm_core::*;
use cssm_lab::*;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let case = case_file::load_case(&a[1]).unwrap();
    let s = scene::Scene::load(&a[2]).unwrap();
    let n: usize = a[3].parse().unwrap();
    let spot = s.views[n];
    let view = View::perspective(
        spot.eye_world,
        spot.target_world,
        DVec3::Y,
        60f64.to_radians(),
        0.2,
        f64::INFINITY,
        (640, 360),
    )
    .unwrap();
    let light = Light::directional_travelling(spot.light_travels).unwrap();
    let gpu = gpu::Gpu::open(&[&case], (640, 360)).unwrap();
    let t = truth::Tracer::new(&s);
    let stage = stage::Stage::new(
        &gpu,
        &s,
        &t,
        view,
        light,
        stage::StageOptions { supersample: a.len() > 4, progress: progress::Progress::Hidden },
    )
    .unwrap();
    for m in [gpu::ResolveMethod::Function, gpu::ResolveMethod::Mask] {
        let at = stage.attempt(&case, m).unwrap();
        let o = at.outcome().unwrap();
        println!(
            "{m:?} shadowed {:.3} edges {} interior area {:.3} leak {:?} acne {:?} interior {}",
            o.score.shadowed,
            o.score.true_edge_pixels,
            o.score.interior_area,
            o.score.leak,
            o.score.acne,
            o.score.interior_wrong_pixels
        );
        println!(
            "disp {:?}\nseam {:?}\n grazing {:?} shallow {:?}",
            o.score.edge_displacement, o.score.seam, o.score.grazing, o.score.shallow
        );
        for (i, v) in o.verdicts.iter().enumerate() {
            if let Some(v) = v
                && v.wrong()
                && v.facing
                && v.place == score::Place::Interior
            {
                let p = stage.frame.pixels[i].unwrap();
                println!(
                    "{},{} truth {} vis {:.3} cos {:.3} depth {:.2} n {:.2} world {:.3} facet {} fp {:?} tri {} inst {}",
                    i % 640,
                    i / 640,
                    v.truth_lit,
                    o.visibility[i],
                    p.cosine,
                    p.depth,
                    p.normal,
                    view.eye_world + p.position,
                    o.assignment.facets[i],
                    o.assignment.footprints[i].unwrap().surface_pixels,
                    p.triangle,
                    p.instance
                );
            }
        }
    }
}
