//! Fans beside the draws of casters that bent rows may bend too far, and in their place.

use cssm_core::remap::Curve;

use super::*;

/// A facet that everything reaches, whose rows run with the logarithm of depth from a metre to a kilometre.
fn bent(height: u32) -> Facet {
    let curve = Curve::Logarithmic { reference_metres: 1.0, horizon_metres: f64::INFINITY };
    let remap = Remap::fitted(curve, 1e-3, 1.0).unwrap();
    let rows = FacetRows { x: DVec4::X, y: DVec4::W, z: DVec4::Z, w: -DVec4::Z, remap };
    let tile = Tile { x: 0, y: 0, width: 10, height, gutter: 1 };
    Facet { rows, tile, casters: Vec::new(), ..facet(0, 0.0, 1.0) }
}

/// Boxes of two metres at some depths.
fn casters(depths: &[f64]) -> Vec<CasterInstance> {
    let at = |depth: &f64| CasterInstance {
        mesh: handle(0),
        world_from_object: DAffine3::from_translation(EYE - DVec3::Z * *depth),
    };
    depths.iter().map(at).collect()
}

/// First corner, corners and rows of the draws of a pipeline.
fn draws(frame: &FrameCommands, pipeline: PipelineHandle) -> Vec<(u32, u32, Range<u32>)> {
    let mut bound = None;
    let mut draws = Vec::new();
    for command in &frame.commands {
        match command {
            Command::Pipeline(handle) => bound = Some(*handle),
            Command::Draw { first, count, instances, .. } if bound == Some(pipeline) => {
                draws.push((*first, *count, instances.clone()));
            }
            _ => {}
        }
    }
    draws
}

const FANS: PipelineHandle = PipelineHandle(7);

fn with(drawing: Drawing) -> impl Fn(MeshHandle) -> Option<MeshFacts<'static>> {
    move |mesh| facts(mesh).map(|facts| MeshFacts { indexed: false, drawing, ..facts })
}

#[test]
fn only_what_may_bend_too_far_is_drawn_as_fans_too() {
    let both = with(Drawing::Both { fans: FANS, bound_texels: 0.25 });
    // A box of two metres bends by half a texel of 2000 rows at 19 m and by less than a fifth at 45 m.
    let casters = casters(&[3.0, 19.0, 45.0, 400.0]);
    let (frame, statistics) = FrameCommands::build(&plan(vec![bent(2000)]), &casters, &both).unwrap();
    assert_eq!(draws(&frame, PipelineHandle(0)), [(0, 36, 0..4)]);
    let depth = |row: u32| frame.rows[row as usize].0[2][3];
    let fans = draws(&frame, FANS);
    let mut near: Vec<_> = fans.iter().flat_map(|(.., rows)| rows.clone()).map(depth).collect();
    near.sort_by(f32::total_cmp);
    assert_eq!(near, [-19.0, -3.0]);
    assert!(fans.iter().all(|(first, count, _)| (*first, *count) == (0, 4 * 36)));
    assert_eq!(statistics.draws as usize, 1 + fans.len());
    assert_eq!(statistics.triangles, 4 * 12, "a triangle counts once");

    // Few rows bend nothing too far, straight ones nothing at all; what is behind the eye always might.
    let count = |facet: Facet, depths: &[f64]| {
        let (frame, _) = FrameCommands::build(&plan(vec![facet]), &self::casters(depths), &both).unwrap();
        draws(&frame, FANS).len()
    };
    assert_eq!(count(bent(8), &[19.0, 45.0]), 0);
    assert_eq!(count(facet(0, -1.0, 1.0), &[3.0]), 0);
    assert_eq!(count(bent(8), &[0.5]), 1);
}

#[test]
fn casters_that_are_fans_alone_are_drawn_once() {
    let (frame, statistics) =
        FrameCommands::build(&plan(vec![bent(2000)]), &casters(&[3.0, 400.0]), with(Drawing::Fans)).unwrap();
    assert_eq!(draws(&frame, PipelineHandle(0)), [(0, 4 * 36, 0..2)]);
    assert_eq!((statistics.draws, statistics.triangles), (1, 2 * 12));
}
