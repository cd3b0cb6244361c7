//! Point-sampled rasterisation of casters into every facet's tile.

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

use super::DepthMap;
use crate::facet::Facet;
use crate::plan::{DepthOrder, ShadowPlan};

/// A caster triangle, corners relative to the eye in world axes, metres.
pub type Triangle = [DVec3; 3];

/// Renders casters into the map of a plan: every texel centre keeps the depth nearest to the light,
/// clamped to [0, 1].
pub fn capture(plan: &ShadowPlan, triangles: &[Triangle]) -> DepthMap {
    capture_tested(plan, triangles, |_, _| true)
}

/// Renders casters with holes: `is_solid` is asked for every covered texel centre, with the triangle's index and the
/// weights of its corners there, perspective-correct.
pub fn capture_tested(
    plan: &ShadowPlan,
    triangles: &[Triangle],
    is_solid: impl Fn(usize, DVec3) -> bool,
) -> DepthMap {
    let mut map = DepthMap::cleared(plan.map_size_texels.0, plan.map_size_texels.1, plan.depth_order);
    for facet in &plan.facets {
        for (index, triangle) in triangles.iter().enumerate() {
            draw(&mut map, facet, triangle, plan.depth_order, |weights| is_solid(index, weights));
        }
    }
    map
}

/// Determinant, relative to its factors, below which a triangle is edge-on to the light.
const EDGE_ON: f64 = 1e-14;

fn draw(
    map: &mut DepthMap,
    facet: &Facet,
    triangle: &Triangle,
    order: DepthOrder,
    is_solid: impl Fn(DVec3) -> bool,
) {
    let rows = &facet.rows;
    let placed = |corner: DVec3| {
        let point = corner.extend(1.0);
        DVec4::new(rows.x.dot(point), rows.y.dot(point), rows.z.dot(point), rows.w.dot(point))
    };
    let corners = [placed(triangle[0]), placed(triangle[1]), placed(triangle[2])];

    // Bent rows are straight in k = y/w: all is decided there, and only the rows of texel centres are bent.
    let remap = &rows.remap;
    let (one, two) = (remap.k(-1.0), remap.k(1.0));
    let Some((low, high)) = tile_bounds(&corners, one.min(two), one.max(two)) else { return };
    let (bottom, top) = (remap.y(low.1), remap.y(high.1));
    let (bottom, top) = (bottom.min(top), bottom.max(top));

    // Invert the triangle in homogeneous clip space: a covered point is a positive combination of the corners, also
    // when some lie behind w = 0 (Olano and Greer, triangle scan conversion using 2D homogeneous coordinates).
    let plane = corners.map(|corner| DVec3::new(corner.x, corner.y, corner.w));
    let determinant = plane[0].dot(plane[1].cross(plane[2]));
    if determinant.abs() <= EDGE_ON * plane.iter().map(|corner| corner.length()).product::<f64>() {
        return;
    }
    let edges = [plane[1].cross(plane[2]), plane[2].cross(plane[0]), plane[0].cross(plane[1])]
        .map(|edge| edge / determinant);
    let depth_row = edges[0] * corners[0].z + edges[1] * corners[1].z + edges[2] * corners[2].z;

    // A value that is linear over the triangle in space is linear over its image once divided by w: so are clip rows.
    let clip_edges = facet.clip.iter().map(|clip| {
        let values = triangle.map(|corner| clip.dot(corner.extend(1.0)));
        edges[0] * values[0] + edges[1] * values[1] + edges[2] * values[2]
    });
    let limits: SmallVec<[DVec3; 8]> = edges.into_iter().chain(clip_edges).collect();

    // Walk the rows of texel centres; along a row every edge is a linear inequality.
    let tile = &facet.tile;
    let (width, height) = (f64::from(tile.width), f64::from(tile.height));
    let first_row = ((0.5 - 0.5 * top) * height - 0.5).ceil().max(0.0) as u32;
    let last_row = ((0.5 - 0.5 * bottom) * height - 0.5).floor().min(height - 1.0);
    if last_row < 0.0 {
        return;
    }
    for row in first_row..=last_row as u32 {
        let y = remap.k(1.0 - 2.0 * (f64::from(row) + 0.5) / height);
        let (mut from, mut to) = (low.0, high.0);
        for edge in &limits {
            let constant = edge.y * y + edge.z;
            if edge.x > 0.0 {
                from = from.max(-constant / edge.x);
            } else if edge.x < 0.0 {
                to = to.min(-constant / edge.x);
            } else if constant < 0.0 {
                to = f64::NEG_INFINITY;
            }
        }
        if from > to {
            continue;
        }
        let first = ((0.5 + 0.5 * from) * width - 0.5).ceil().max(0.0);
        let last = ((0.5 + 0.5 * to) * width - 0.5).floor().min(width - 1.0);
        let start = (tile.y + row) as usize * map.width as usize + tile.x as usize;
        let mut column = first;
        while column <= last {
            let x = 2.0 * (column + 0.5) / width - 1.0;
            let centre = DVec3::new(x, y, 1.0);
            let weights = DVec3::new(edges[0].dot(centre), edges[1].dot(centre), edges[2].dot(centre));
            if !is_solid(weights / weights.element_sum()) {
                column += 1.0;
                continue;
            }
            let depth = depth_row.dot(centre).clamp(0.0, 1.0);
            let texel = &mut map.depths[start + column as usize];
            *texel = match order {
                DepthOrder::Standard => texel.min(depth),
                DepthOrder::Reversed => texel.max(depth),
            };
            column += 1.0;
        }
    }
}

/// A triangle cut by the four edges of a tile.
type Polygon = SmallVec<[DVec4; 8]>;

/// Smallest rectangle in x/w and y/w around the visible part of a triangle, in a tile that spans `from` to `to` in y/w.
fn tile_bounds(corners: &[DVec4; 3], from: f64, to: f64) -> Option<((f64, f64), (f64, f64))> {
    let edges = [
        DVec4::new(1.0, 0.0, 0.0, 1.0),
        DVec4::new(-1.0, 0.0, 0.0, 1.0),
        DVec4::new(0.0, 1.0, 0.0, -from),
        DVec4::new(0.0, -1.0, 0.0, to),
    ];
    // Most triangles lie outside one edge; most others inside all.
    let outside = |edge: &DVec4| corners.iter().all(|corner| edge.dot(*corner) < 0.0);
    if edges.iter().any(outside) {
        return None;
    }
    let mut polygon: Polygon = corners.iter().copied().collect();
    for edge in edges {
        if polygon.iter().all(|corner| edge.dot(*corner) >= 0.0) {
            continue;
        }
        let mut kept = Polygon::new();
        for (one, two) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
            let (a, b) = (edge.dot(*one), edge.dot(*two));
            if a >= 0.0 {
                kept.push(*one);
            }
            if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
                kept.push((*one * b - *two * a) / (b - a));
            }
        }
        polygon = kept;
    }
    let mut bounds = ((f64::INFINITY, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY));
    for corner in polygon.iter().filter(|corner| corner.w > 0.0) {
        let (x, y) = (corner.x / corner.w, corner.y / corner.w);
        bounds.0 = (bounds.0.0.min(x), bounds.0.1.min(y));
        bounds.1 = (bounds.1.0.max(x), bounds.1.1.max(y));
    }
    (bounds.0.0 <= bounds.1.0).then_some(bounds)
}
