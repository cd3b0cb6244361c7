//! Coverage and depth against rays in space, chord errors and covers against the bent edges themselves.

use glam::{DMat3, DVec2, DVec3, DVec4};

use super::*;
use crate::case::Stretch;
use crate::schema::{Value, Word};
use crate::{Light, LightCase, SceneBounds, View, plan};

/// Distance from an edge, in texels, within which both sides may be right.
const EDGE_TEXELS: f64 = 1e-5;

/// The splitmix64 sequence.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn around(&mut self) -> DVec3 {
        DVec3::new(self.unit() - 0.5, self.unit() - 0.5, self.unit() - 0.5) * 2.0
    }
}

/// Bent facets of every distribution, with and without a horizon.
fn facets() -> Vec<(String, Facet)> {
    let two = |share: f64| Word::with("two_segment", [("share", Value::Number(share))]);
    let words = [Word::plain("perspective"), Word::plain("logarithmic"), two(0.3), two(0.85)];
    let mut facets = Vec::new();
    for word in words {
        for far in [300.0, f64::INFINITY] {
            let case = LightCase::builder("Sun").configurations(&["one_plane"]).distribution(word.clone());
            let case = case.stretch(Stretch::Exact { bound_texels: 0.25 }).map_size_texels(1024, 2048);
            let eye = DVec3::new(3.0, 1.7, -2.0);
            let target = DVec3::new(0.0, 1.2, -20.0);
            let view = View::perspective(eye, target, DVec3::Y, 1.0, 0.2, far, (1280, 720)).unwrap();
            let light = Light::directional_travelling(DVec3::new(0.5, -1.0, 0.2)).unwrap();
            let plan = plan(&case.build().unwrap(), &view, &light, &SceneBounds::default()).unwrap();
            for facet in plan.facets {
                assert!(!facet.rows.remap.is_none());
                facets.push((format!("{} {far}", word.name), facet));
            }
        }
    }
    facets
}

/// A triangle relative to the eye: tiny to huge, some across w = 0, some behind, some nearly degenerate.
fn triangle(random: &mut Random) -> [DVec3; 3] {
    let distance = libm::pow(10.0, 3.0 * random.unit() - 0.7);
    let centre =
        DVec3::new(0.6 * (random.unit() - 0.5), 0.4 * (random.unit() - 0.6), -0.95 + 0.3 * random.unit());
    let size = distance * libm::pow(10.0, 3.2 * random.unit() - 2.5);
    let mut corners = [0; 3].map(|_| centre * distance + random.around() * size);
    if random.unit() < 0.15 {
        let along = corners[0] + (corners[1] - corners[0]) * random.unit();
        corners[2] = along + random.around() * size * 1e-3;
    }
    corners
}

/// Where the ray of a point of the tile meets a triangle: share of the second and third corner, and the point.
fn meets(facet: &Facet, ndc: DVec2, triangle: &[DVec3; 3]) -> Option<(DVec2, DVec3)> {
    // The ray is where two planes through the light meet.
    let rows = &facet.rows;
    let (across, along) = (rows.x - rows.w * ndc.x, rows.y - rows.w * rows.remap.k(ndc.y));
    let (one, two) = (across.truncate(), along.truncate());
    let direction = one.cross(two);
    let planes = DMat3::from_cols(one, two, direction.normalize()).transpose();
    let start = planes.inverse() * DVec3::new(-across.w, -along.w, 0.0);

    let (first, second) = (triangle[1] - triangle[0], triangle[2] - triangle[0]);
    let shares = DMat3::from_cols(first, second, -direction.normalize()).inverse() * (start - triangle[0]);
    let inside = shares.x >= 0.0 && shares.y >= 0.0 && shares.x + shares.y <= 1.0;
    let point = triangle[0] + first * shares.x + second * shares.y;
    (inside && rows.w.dot(point.extend(1.0)) > 0.0).then_some((DVec2::new(shares.x, shares.y), point))
}

#[test]
fn a_million_samples_agree_with_rays_in_space() {
    let mut random = Random(7);
    let (mut samples, mut hits, mut crossing, mut wrong) = (0_u32, 0_u32, 0_u32, 0_u32);
    let mut worst_depth = 0.0_f64;
    let facets = facets();
    let count = facets.len();
    for (name, facet) in facets {
        let texel = DVec2::new(2.0 / f64::from(facet.tile.width), 2.0 / f64::from(facet.tile.height));
        for _ in 0..60_000 / count {
            let corners = triangle(&mut random);
            let Some(bent) = BentTriangle::new(&facet, &corners) else { continue };
            crossing += u32::from(bent.corners.iter().any(|corner| corner.w <= 0.0));
            for _ in 0..20 {
                // Around the triangle, where it is in front of the eye.
                let shares = DVec2::new(random.unit() * 1.6 - 0.3, random.unit() * 1.6 - 0.3);
                let point =
                    corners[0] + (corners[1] - corners[0]) * shares.x + (corners[2] - corners[0]) * shares.y;
                let row = |row: DVec4| row.dot(point.extend(1.0));
                let w = row(facet.rows.w);
                let mut ndc = DVec2::new(row(facet.rows.x) / w, facet.rows.remap.y(row(facet.rows.y) / w));
                if !(w > 0.0 && ndc.abs().max_element() <= 1.0) {
                    ndc = DVec2::new(random.unit(), random.unit()) * 2.0 - 1.0;
                }

                samples += 1;
                let (covered, met) = (bent.at(ndc), meets(&facet, ndc, &corners));
                match (covered, met) {
                    (Some(covered), Some((shares, point))) => {
                        hits += 1;
                        let depth = facet.rows.z.dot(point.extend(1.0)) / facet.rows.w.dot(point.extend(1.0));
                        let step = facet.depth_per_metre / facet.rows.w.dot(point.extend(1.0))
                            * facet.texel_metres_per_w
                            * facet.rows.w.dot(point.extend(1.0));
                        let steep = (covered.shares.y - shares.x).abs() + (covered.shares.z - shares.y).abs();
                        assert!(steep < 1e-4, "{name}: shares {} and {shares}", covered.shares);
                        worst_depth = worst_depth.max((covered.depth - depth).abs() / step);
                    }
                    (None, None) => {}
                    _ => {
                        let near = [DVec2::X, -DVec2::X, DVec2::Y, -DVec2::Y].into_iter().any(|step| {
                            bent.at(ndc + step * texel * EDGE_TEXELS).is_some() != covered.is_some()
                        });
                        wrong += u32::from(!near);
                    }
                }
            }
        }
    }
    println!(
        "{samples} samples, {hits} hits, {crossing} triangles across w = 0, depth off by {worst_depth:e} texel"
    );
    assert_eq!(wrong, 0);
    assert!(samples >= 1_000_000 && hits > 50_000 && crossing > 1000);
    assert!(worst_depth < 1e-3);
}

#[test]
fn chord_errors_are_the_farthest_that_chords_get() {
    let mut random = Random(3);
    for (name, facet) in facets() {
        let remap = facet.rows.remap;
        let (one, two) = (remap.k(-1.0), remap.k(1.0));
        let (low, high) = (one.min(two).max(1e-4), one.max(two));
        for _ in 0..200 {
            let place = |part: f64| low * libm::pow(high / low, part);
            let (one, two) = (place(random.unit()), place(random.unit()));
            let (start, end) = (one.min(two), one.max(two));
            let found = chord_error(&remap, start, end);
            let gap = |part: f64| {
                let chord = remap.y(start) + (remap.y(end) - remap.y(start)) * part;
                (remap.y(start + (end - start) * part) - chord).abs()
            };
            // Steps that are fine near the start, where curves bend most.
            let searched =
                (1..2000).map(|step| gap(libm::pow(f64::from(step) / 2000.0, 3.0))).fold(0.0, f64::max);
            let bound = chord_bound(&remap, start, end);
            assert!(bound >= found - 1e-12, "{name}: {bound} {found}");
            assert!(
                found >= searched - 1e-12 && found <= searched * 1.01 + 1e-9,
                "{name}: {found} {searched}"
            );
        }
    }
}

#[test]
fn covers_hold_all_that_is_covered_and_little_more() {
    let mut random = Random(5);
    let (mut ratios, mut boxes, mut corners_most) = (Vec::new(), Vec::new(), 0);
    for (name, facet) in facets() {
        for _ in 0..400 {
            let Some(bent) = BentTriangle::new(&facet, &triangle(&mut random)) else { continue };
            let cover = bent.cover();
            corners_most = corners_most.max(cover.len());
            let half = 0.5 * bent.size();

            // Points inside the triangle lie inside the cover, if the tile holds them.
            for _ in 0..40 {
                let (one, two) = (random.unit(), random.unit());
                let (one, two) = if one + two > 1.0 { (1.0 - one, 1.0 - two) } else { (one, two) };
                let [a, b, c] = bent.corners;
                let point = a + (b - a) * one + (c - a) * two;
                let place = bent.bent(DVec2::new(point.x, point.y) / point.w);
                if point.w > 0.0 && place.abs().cmple(half).all() {
                    assert!(holds(&cover, place), "{name}: {place} is outside {cover:?}");
                }
            }

            // Compare areas where the whole triangle has a place.
            if bent.chord_error_texels().is_finite() && bent.chord_error_texels() > 0.25 {
                let edge = outline(&bent);
                let true_area = area(&edge).abs();
                let longest = (0..3).map(|corner| edge[64 * corner].distance(edge[64 * (corner + 1) % 192]));
                let longest = longest.fold(0.0, f64::max);
                if true_area > 1.0 && true_area > SLENDER * longest * longest {
                    let (low, high) =
                        edge.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), point| {
                            (low.min(*point), high.max(*point))
                        });
                    ratios.push(area(&cover).abs() / true_area);
                    boxes.push((high - low).element_product() / true_area);
                }
            }
        }
    }
    let quantile = |values: &mut Vec<f64>, share: f64| {
        values.sort_by(f64::total_cmp);
        values[(share * (values.len() - 1) as f64) as usize]
    };
    let (median, high) = (quantile(&mut ratios, 0.5), quantile(&mut ratios, 0.95));
    let (box_median, box_high) = (quantile(&mut boxes, 0.5), quantile(&mut boxes, 0.95));
    println!("{} covers: {median:.2} {high:.2}; boxes: {box_median:.2} {box_high:.2}", ratios.len());
    assert!(corners_most <= 6 && ratios.len() > 300);
    assert!(median < 1.3 && high < 5.0 && median < box_median && high < box_high);
}

/// Area, in squares of the longest edge, below which a triangle's box is no measure of it.
const SLENDER: f64 = 0.02;

/// The bent outline of a triangle whose corners have a place, in texels.
fn outline(bent: &BentTriangle) -> Vec<DVec2> {
    let places = bent.corners.map(|corner| DVec2::new(corner.x, corner.y) / corner.w);
    let steps = (0..3).flat_map(|corner| (0..64).map(move |step| (corner, f64::from(step) / 64.0)));
    steps.map(|(corner, part)| bent.bent(places[corner].lerp(places[(corner + 1) % 3], part))).collect()
}

fn area(polygon: &[DVec2]) -> f64 {
    let pairs = polygon.iter().zip(polygon.iter().cycle().skip(1));
    0.5 * pairs.map(|(one, two)| one.perp_dot(*two)).sum::<f64>()
}

/// Whether a fan from the first corner holds a point, up to rounding.
fn holds(polygon: &[DVec2], point: DVec2) -> bool {
    let Some((first, others)) = polygon.split_first() else { return false };
    others.windows(2).any(|pair| {
        let turns = [(*first, pair[0]), (pair[0], pair[1]), (pair[1], *first)]
            .map(|(one, two)| (two - one).perp_dot(point - one) / (two - one).length().max(1e-9));
        turns.iter().all(|turn| *turn >= -1e-6) || turns.iter().all(|turn| *turn <= 1e-6)
    })
}

#[test]
fn a_wrong_tangent_is_seen() {
    // Without its bulges a cover loses part of the triangle.
    let (_, facet) = facets().swap_remove(0);
    let corners = [DVec3::new(-1.0, -1.0, -4.0), DVec3::new(2.0, -0.5, -60.0), DVec3::new(1.5, -1.0, -4.5)];
    let bent = BentTriangle::new(&facet, &corners).unwrap();
    let straight: Vec<_> =
        bent.corners.iter().map(|corner| bent.bent(DVec2::new(corner.x, corner.y) / corner.w)).collect();
    let outline = outline(&bent);
    let lost = |polygon: &[DVec2]| outline.iter().filter(|point| !holds(polygon, **point)).count();
    assert!(bent.chord_error_texels() > 10.0 && bent.chord_error_texels().is_finite());
    assert_eq!(lost(&bent.cover()), 0);
    assert!(lost(&straight) > 20);
}
