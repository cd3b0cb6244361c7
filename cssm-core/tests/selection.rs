//! Selection: every visible point has exactly one facet, in f64 and in f32, also on borders.

mod support;

use cssm_core::case::LightKind;
use cssm_core::facet::Selection;
use cssm_core::footprint::accepts;
use cssm_core::glam::{DVec3, DVec4};
use cssm_core::{Light, SceneBounds, ShadowPlan, View, plan};
use support::{
    Random, bounds_for, cases, lamps, level_view, local_cases, off_centre_view, peers, shining, sun, toward,
    turned_view,
};

/// Points for each plan; the plans of one run add up to more than a million draws.
const POINTS: usize = 6000;

/// Distance from a lamp below which points are not asked for: f32 positions cannot tell them apart.
const NEAREST_METRES: f64 = 0.02;

/// A random visible point; half of them are moved onto a border or band limit, up to 8 ulp off.
fn visible_point(random: &mut Random, view: &View, plan: &ShadowPlan, far: f64) -> DVec3 {
    let depth = view.near_metres * (far / view.near_metres).powf(random.unit());
    let x = random.unit() * f64::from(view.size_pixels.0);
    let y = random.unit() * f64::from(view.size_pixels.1);
    let mut point = view.ray_world(x, y) * depth;
    if random.unit() < 0.5 {
        let rows = border_rows(&plan.selection);
        if let Some(row) = rows.get((random.bits() % rows.len().max(1) as u64) as usize) {
            // Step along the row's normal onto its plane, then a few ulp off.
            let normal = row.truncate();
            point -= normal * (row.dot(point.extend(1.0)) / normal.length_squared());
            let ulp = random.between(-8.0, 8.0).round() * f64::EPSILON;
            point *= 1.0 + ulp;
        }
    }
    point
}

fn border_rows(selection: &Selection) -> Vec<DVec4> {
    let turned = |row: &DVec4| row.truncate() != DVec3::ZERO;
    let mut rows: Vec<DVec4> = selection.borders.iter().copied().filter(turned).collect();
    rows.extend(selection.split);
    rows.extend(selection.dominant.iter().flatten().flat_map(|row| [*row - DVec4::W, *row + DVec4::W]));
    for (sector, row) in selection.distances.iter().enumerate() {
        let unit = selection.units.get(sector).copied().unwrap_or(DVec4::W);
        let limits = selection.limits(sector).iter().filter(|limit| **limit < 1e12);
        rows.extend(limits.map(|limit| *row - unit * *limit));
    }
    rows.retain(turned);
    rows
}

fn in_view(view: &View, point: DVec3) -> bool {
    let camera = view.camera_from_world * point;
    let (x, y, depth) = (camera.x / -camera.z, camera.y / -camera.z, -camera.z);
    depth >= view.near_metres
        && depth <= view.far_metres
        && (view.left..=view.right).contains(&x)
        && (view.bottom..=view.top).contains(&y)
}

/// The selection with every number rounded to f32 and every operation rounded as a shader would.
fn facet_in_f32(selection: &Selection, point: DVec3) -> u32 {
    let point = [point.x as f32, point.y as f32, point.z as f32];
    let dot = |row: &DVec4| {
        row.x as f32 * point[0] + row.y as f32 * point[1] + row.z as f32 * point[2] + row.w as f32
    };
    if selection.dominant.is_some_and(|[row, front]| dot(&row).abs() <= 1.0 && dot(&front) >= 0.0) {
        return selection.dominant_cell();
    }
    let half = usize::from(selection.split.is_some_and(|split| dot(&split) < 0.0));
    let mut sector = half * selection.sectors as usize;
    if selection.sectors > 1 {
        let ring = &selection.borders[sector..sector + selection.sectors as usize];
        let (first, rest) = (&ring[0], &ring[1..]);
        sector += if dot(first) >= 0.0 {
            rest.iter().take_while(|row| dot(row) >= 0.0).count()
        } else {
            rest.len() - rest.iter().rev().take_while(|row| dot(row) < 0.0).count()
        };
    }
    let band = selection.distances.get(sector).map_or(0, |row| {
        let unit = selection.units.get(sector).map_or(1.0, &dot);
        let reached = |limit: &&f64| dot(row) >= **limit as f32 * unit;
        selection.limits(sector).iter().filter(reached).count()
    });
    sector as u32 * selection.bands + band as u32
}

/// How far outside the tile, gutter included, a point's texel lies in f32 positions; 0: inside.
fn outside_tile(plan: &ShadowPlan, index: u32, point: DVec3) -> f64 {
    let Some(facet) = plan.facet(index) else { return f64::INFINITY };
    let point = point.as_vec3().as_dvec3().extend(1.0);
    let w = facet.rows.w.dot(point);
    let y = facet.rows.remap.y(facet.rows.y.dot(point) / w);
    let (x, y) = facet.tile.texel_from_ndc(facet.rows.x.dot(point) / w, y);
    let tile = &facet.tile;
    let over = |value: f64, start: u32, side: u32| {
        (f64::from(start) - value).max(value - f64::from(start + side)).max(0.0)
    };
    over(x, tile.x, tile.width).max(over(y, tile.y, tile.height))
}

#[test]
fn every_visible_point_has_exactly_one_facet_and_a_texel_in_its_tile() {
    let mut random = Random::new(7);
    let (mut draws, mut on_borders, mut incomplete) = (0, 0, 0);
    for view in [level_view(0.2, 1000.0), turned_view(0.1, f64::INFINITY), off_centre_view(0.5, 5000.0)] {
        let reach = view.far_metres.min(2e4);
        let suns: Vec<_> = lights(&mut random).into_iter().map(sun).collect();
        let lamps = lamps(&view, &mut random);
        let spots = lamps.iter().map(|lamp| shining(&view, *lamp, &mut random)).collect();
        let by_kind = |kind| match kind {
            LightKind::Directional => &suns,
            LightKind::Omni => &lamps,
            LightKind::Spot => &spots,
        };
        let kinds = [LightKind::Directional, LightKind::Spot, LightKind::Omni];
        let peers = kinds.into_iter().flat_map(|kind| peers(1024, reach, kind));
        for case in cases(1024, reach).into_iter().chain(local_cases(1024)).chain(peers) {
            for light in by_kind(case.light) {
                let light: &Light = light;
                let plan = plan(&case, &view, light, &bounds_for(&case, &view)).unwrap();
                if !plan.choice.complete {
                    let by_default = case.light.is_local() && case.configurations.len() > 1;
                    assert!(!by_default, "{} {light:?}: {}", case.name, plan.choice);
                    incomplete += 1;
                    continue;
                }
                for _ in 0..POINTS {
                    let point = visible_point(&mut random, &view, &plan, reach * 0.999);
                    let world = view.eye_world + point;
                    if !in_view(&view, point)
                        || view.depth_metres(point) > reach * 0.999
                        || !light.reaches(world)
                        || light.distance_metres(world) < NEAREST_METRES
                    {
                        continue;
                    }
                    draws += 1;
                    let homogeneous = point.extend(1.0);
                    let index = plan.selection.cell(homogeneous);
                    let accepting: Vec<u32> = plan
                        .facets
                        .iter()
                        .filter(|facet| accepts(facet, point))
                        .filter(|facet| !facet.cells.contains(&plan.selection.dominant_cell()))
                        .map(|facet| facet.first_cell())
                        .collect();
                    let own = plan.facet(index).map(|facet| facet.first_cell());
                    let place = || format!("{} {light:?} {point}, {}", case.name, plan.choice);
                    let on_plane = index == plan.selection.dominant_cell();
                    match accepting[..] {
                        [] => on_borders += 1,
                        [one] => assert!(on_plane || Some(one) == own, "{}: {one} {own:?}", place()),
                        _ => panic!("{} facets accept {}", accepting.len(), place()),
                    }
                    let outside = outside_tile(&plan, facet_in_f32(&plan.selection, point), point);
                    assert!(outside == 0.0, "{}: {outside} texels outside", place());
                }
            }
        }
    }
    println!("{draws} draws, {on_borders} on borders, {incomplete} plans leave receivers out");
    assert!(draws > 1_000_000 && on_borders > 1000);
}

/// Lights of every kind: general, dueling, along edges and corners of the view, near its axis.
fn lights(random: &mut Random) -> Vec<DVec3> {
    let mut lights = vec![
        toward(60.0, 150.0),
        toward(35.0, 0.0),
        toward(30.0, 180.0),
        toward(5.0, 180.0),
        toward(0.0, 90.0),
        toward(90.0, 0.0),
        DVec3::new(1e-9, 0.0, -1.0).normalize(),
        DVec3::NEG_Z,
        DVec3::new(30_f64.to_radians().tan(), 30_f64.to_radians().tan(), 1.0).normalize(),
    ];
    lights.extend((0..4).map(|_| random.direction()));
    lights
}

#[test]
fn swapping_two_facets_is_seen() {
    let view = level_view(0.2, 1000.0);
    let case = &cases(1024, 1000.0)[3];
    let mut plan = plan(case, &view, &sun(toward(50.0, 120.0)), &SceneBounds::default()).unwrap();
    let (one, two) = (plan.facets[0].cells.clone(), plan.facets[1].cells.clone());
    (plan.facets[0].cells, plan.facets[1].cells) = (two, one);
    let mut random = Random::new(3);
    let wrong = (0..2000).filter(|_| {
        let point = visible_point(&mut random, &view, &plan, 999.0);
        outside_tile(&plan, plan.selection.cell(point.extend(1.0)), point) > 0.0
    });
    assert!(wrong.count() > 100);
}
