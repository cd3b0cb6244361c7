//! Scores of synthetic images whose errors are known.

use cssm_core::glam::DVec3;

use super::*;
use crate::truth::Visible;

const WIDTH: usize = 60;
const HEIGHT: usize = 40;

/// A plane seen from straight above, one pixel per metre, whose shadow is given.
fn plane(lit: impl Fn(usize, usize) -> bool) -> Frame {
    let pixels = (0..WIDTH * HEIGHT)
        .map(|index| {
            let (x, y) = (index % WIDTH, index / WIDTH);
            Some(Visible {
                position: DVec3::new(x as f64, -100.0, y as f64),
                normal: DVec3::Y,
                cosine: 0.7,
                light_metres: f64::INFINITY,
                depth: 100.0,
                instance: 0,
                triangle: 0,
                reached: true,
                lit: lit(x, y),
            })
        })
        .collect();
    Frame { width: WIDTH, height: HEIGHT, pixels }
}

struct Map {
    visibility: Vec<f32>,
    footprints: Vec<Option<PixelFootprint>>,
    facets: Vec<u32>,
}

impl Map {
    fn new(lit: impl Fn(usize, usize) -> bool, footprint: f64) -> Self {
        let each = || (0..WIDTH * HEIGHT).map(|index| (index % WIDTH, index / WIDTH));
        let footprint = PixelFootprint {
            volume_pixels: footprint,
            geometric_pixels: footprint,
            surface_pixels: footprint,
        };
        Self {
            visibility: each().map(|(x, y)| if lit(x, y) { 1.0 } else { 0.0 }).collect(),
            footprints: vec![Some(footprint); WIDTH * HEIGHT],
            facets: vec![0; WIDTH * HEIGHT],
        }
    }

    fn score(&self, frame: &Frame) -> Score {
        self.verdicts(frame, None).0
    }

    fn verdicts(&self, frame: &Frame, fine: Option<&FineEdges>) -> (Score, Vec<Option<Verdict>>) {
        score(&Judged {
            frame,
            visibility: &self.visibility,
            footprints: &self.footprints,
            facets: &self.facets,
            true_edges: &TrueEdges::of(frame, fine),
        })
    }
}

const PIXELS: f64 = (WIDTH * HEIGHT) as f64;

#[test]
fn a_perfect_map_has_no_errors() {
    let shadow = |x: usize, _| x >= 30;
    let score = Map::new(shadow, 1.0).score(&plane(shadow));
    assert_eq!((score.mismatch, score.interior_wrong_pixels), (0.0, 0));
    assert_eq!(score.shadowed, 0.5);
    assert_eq!(score.true_edge_pixels, HEIGHT as u64);
    assert_eq!(score.edge_displacement.map_to_true.pixels.max, 0.0);
    assert_eq!(score.edge_displacement.true_to_map.count, HEIGHT as u64);
    assert_eq!(score.seam, None);
}

#[test]
fn an_edge_moved_by_two_pixels_is_a_leak_in_the_edge_band() {
    let score = Map::new(|x, _| x >= 28, 1.0).score(&plane(|x, _| x >= 30));
    assert_eq!(score.leak.edge, 2.0 * HEIGHT as f64 / PIXELS);
    assert_eq!((score.leak.total, score.acne.total), (score.leak.edge, 0.0));
    let displacement = score.edge_displacement;
    assert_eq!((displacement.map_to_true.pixels.median, displacement.true_to_map.pixels.p95), (2.0, 2.0));
    assert_eq!(displacement.true_to_map.footprints.p95, 2.0);
    // The same distance is half a footprint of a map whose texels span four pixels.
    let coarse = Map::new(|x, _| x >= 28, 4.0).score(&plane(|x, _| x >= 30));
    assert_eq!(coarse.edge_displacement.true_to_map.footprints.p95, 0.5);
}

#[test]
fn an_edge_moved_far_reaches_the_interior_unless_texels_are_large() {
    let frame = plane(|x, _| x >= 30);
    let moved = Map::new(|x, _| x >= 20, 1.0).score(&frame);
    assert!(moved.leak.interior > 0.0 && moved.interior_wrong_pixels > 100, "{:?}", moved.leak);
    let coarse = Map::new(|x, _| x >= 20, 5.0).score(&frame);
    assert_eq!(coarse.leak.interior, 0.0);
    assert_eq!(coarse.leak.total, moved.leak.total);
}

#[test]
fn a_hole_in_a_shadow_is_interior_leak() {
    let hole = |x: usize, y: usize| (45..48).contains(&x) && (18..21).contains(&y);
    let (score, verdicts) = Map::new(|x, y| x < 30 || hole(x, y), 1.0).verdicts(&plane(|x, _| x < 30), None);
    assert_eq!(score.leak.interior, 9.0 / PIXELS);
    assert_eq!((score.acne.total, score.interior_wrong_pixels), (0.0, 9));
    assert_eq!(verdicts.iter().flatten().filter(|verdict| verdict.wrong()).count(), 9);
}

#[test]
fn shadow_specks_on_lit_ground_are_acne() {
    let score = Map::new(|x, y| !(x == 12 && y == 12), 1.0).score(&plane(|x, _| x < 30));
    let missed = score.leak.total;
    assert_eq!(score.acne.interior, 1.0 / PIXELS);
    assert_eq!(missed, 30.0 * HEIGHT as f64 / PIXELS);
    // No edge of this map comes near: every true edge is far from the specks.
    assert!(score.edge_displacement.true_to_map.pixels.median > 15.0);
}

#[test]
fn a_missing_shadow_is_as_far_as_the_image_is_large() {
    let score = Map::new(|_, _| true, 1.0).score(&plane(|x, _| x >= 30));
    assert_eq!(score.edge_displacement.map_to_true.count, 0);
    assert!(score.edge_displacement.true_to_map.pixels.median > WIDTH as f64);
}

#[test]
fn errors_beside_a_step_lie_in_the_crease_band() {
    let step = |frame: &mut Frame| {
        for (index, pixel) in frame.pixels.iter_mut().enumerate() {
            if let Some(pixel) = pixel.as_mut().filter(|_| index % WIDTH >= 30) {
                pixel.position.y += 1.0;
                pixel.triangle = 1;
            }
        }
    };
    let mut frame = plane(|_, _| true);
    let map = Map::new(|x, y| !(x == 31 && y == 20), 1.0);
    assert_eq!(map.score(&frame).acne.interior, 1.0 / PIXELS);
    step(&mut frame);
    let score = map.score(&frame);
    assert_eq!((score.acne.crease, score.acne.interior), (1.0 / PIXELS, 0.0));
}

#[test]
fn a_bent_surface_is_a_crease_and_a_flat_one_is_not() {
    let mut frame = plane(|_, _| true);
    let map = Map::new(|x, y| !(x == 31 && y == 20), 1.0);
    for (index, pixel) in frame.pixels.iter_mut().enumerate() {
        if let Some(pixel) = pixel.as_mut().filter(|_| index % WIDTH >= 30) {
            pixel.triangle = 1;
        }
    }
    assert_eq!(map.score(&frame).acne.interior, 1.0 / PIXELS);
    for (index, pixel) in frame.pixels.iter_mut().enumerate() {
        if let Some(pixel) = pixel.as_mut().filter(|_| index % WIDTH >= 30) {
            pixel.normal = DVec3::new(0.1, 1.0, 0.0).normalize();
        }
    }
    assert_eq!(map.score(&frame).acne.crease, 1.0 / PIXELS);
}

#[test]
fn grazing_pixels_are_counted_apart() {
    let mut frame = plane(|_, _| true);
    for (index, pixel) in frame.pixels.iter_mut().enumerate() {
        if let Some(pixel) = pixel {
            pixel.cosine = [0.7, 0.03, -0.5][index % WIDTH / 20];
        }
    }
    let score = Map::new(|_, _| false, 1.0).score(&frame);
    assert_eq!((score.facing_pixels, score.grazing_pixels), (20 * HEIGHT as u64, 40 * HEIGHT as u64));
    assert_eq!((score.acne.total, score.grazing.acne, score.shallow.acne), (1.0, 1.0, 1.0));
    assert_eq!(score.shallow.pixels, 20 * HEIGHT as u64);
}

#[test]
fn pixels_beyond_the_lights_reach_are_counted_apart() {
    let mut frame = plane(|_, _| true);
    for (index, pixel) in frame.pixels.iter_mut().enumerate() {
        if let Some(pixel) = pixel.as_mut().filter(|_| index % WIDTH < 20) {
            (pixel.reached, pixel.lit) = (false, false);
        }
    }
    let score = Map::new(|_, _| true, 1.0).score(&frame);
    assert_eq!((score.facing_pixels, score.unreached_pixels), (40 * HEIGHT as u64, 20 * HEIGHT as u64));
    assert_eq!((score.grazing_pixels, score.mismatch, score.true_edge_pixels), (0, 0.0, 0));
}

#[test]
fn sky_is_not_judged() {
    let mut frame = plane(|_, _| true);
    frame.pixels.iter_mut().take(WIDTH * 10).for_each(|pixel| *pixel = None);
    let map = Map::new(|_, y| y >= 10, 1.0);
    let score = map.score(&frame);
    assert_eq!((score.mismatch, score.visible_pixels), (0.0, (WIDTH * (HEIGHT - 10)) as u64));
    assert_eq!(score.edge_displacement.map_to_true.count, 0);
}

#[test]
fn filtered_visibility_is_lit_from_one_half() {
    let mut map = Map::new(|_, _| true, 1.0);
    map.visibility[WIDTH * 20 + 30] = 0.5;
    assert_eq!(map.score(&plane(|_, _| true)).mismatch, 0.0);
    map.visibility[WIDTH * 20 + 30] = 0.49;
    assert_eq!(map.score(&plane(|_, _| true)).mismatch, 1.0 / PIXELS);
}

#[test]
fn a_seam_shows_in_its_strip_only() {
    // The shadow edge runs across the boundary between two facets at x = 30.
    let truth = plane(|_, y| y < 20);
    let with_boundary = |mut map: Map| {
        map.facets = (0..WIDTH * HEIGHT).map(|index| u32::from(index % WIDTH >= 30)).collect();
        map
    };
    let straight = with_boundary(Map::new(|_, y| y < 21, 1.0)).score(&truth);
    let seam = straight.seam.expect("a boundary is visible");
    assert_eq!((seam.mean_ratio, seam.p95_ratio), (Some(1.0), Some(1.0)));
    assert_eq!(seam.strip_edge_pixels, 4);

    let broken =
        with_boundary(Map::new(|x, y| y < 21 || ((25..35).contains(&x) && y < 25), 1.0)).score(&truth);
    let seam = broken.seam.expect("a boundary is visible");
    assert!(seam.mean_ratio.is_some_and(|ratio| ratio > 1.2), "{seam:?}");
    assert!(seam.interior_wrong_pixels > 0);
    let meeting = seam.meeting;
    assert_eq!((meeting.strip_edge_pixels, meeting.nearby_edge_pixels), (4, seam.nearby_edge_pixels));
    assert_eq!((meeting.strip_mean, meeting.nearby_mean), (seam.strip_mean, seam.nearby_mean));
}

#[test]
fn facets_do_not_meet_at_a_silhouette() {
    // A post of another facet stands before the ground; the shadow edge runs across both.
    let mut truth = plane(|_, y| y < 20);
    let is_post = |x: usize| (30..33).contains(&x);
    for (index, pixel) in truth.pixels.iter_mut().enumerate() {
        if let Some(pixel) = pixel.as_mut().filter(|_| is_post(index % WIDTH)) {
            (pixel.position.y, pixel.triangle) = (-50.0, 1);
        }
    }
    let mut map = Map::new(|x, y| y < 21 || is_post(x) && y < 25, 1.0);
    map.facets = (0..WIDTH * HEIGHT).map(|index| u32::from(is_post(index % WIDTH))).collect();
    let seam = map.score(&truth).seam.expect("a boundary is visible");
    assert!(seam.strip_edge_pixels > 0 && seam.strip_mean > seam.nearby_mean, "{seam:?}");
    assert_eq!(seam.meeting, Meeting::default());
}

#[test]
fn fine_edges_excuse_what_is_thinner_than_a_pixel() {
    // A shadow of a quarter pixel, which no pixel centre meets, at x = 30.
    let samples = 4;
    let mut fine = plane(|_, _| true);
    let pixels = (0..WIDTH * HEIGHT * samples * samples)
        .map(|index| {
            let (x, y) = (index % (WIDTH * samples), index / (WIDTH * samples));
            let coarse = fine.pixels[y / samples * WIDTH + x / samples]?;
            Some(Visible { lit: x != 30 * samples, ..coarse })
        })
        .collect();
    fine = Frame { width: WIDTH * samples, height: HEIGHT * samples, pixels };
    let frame = plane(|_, _| true);
    let map = Map::new(|x, _| x != 30, 1.0);
    assert!(map.score(&frame).acne.interior > 0.0);
    let (score, _) = map.verdicts(&frame, Some(&FineEdges::of(&fine, samples)));
    assert_eq!((score.acne.interior, score.acne.edge), (0.0, HEIGHT as f64 / PIXELS));
}
