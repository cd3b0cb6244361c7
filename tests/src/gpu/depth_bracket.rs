//! What a captured map may hold: the twin's depths, where rasterisers have no reason to disagree.

use cssm_core::ShadowPlan;
use cssm_core::case::DepthFormat;
use cssm_core::plan::DepthOrder;
use cssm_core::twin::{DepthMap, capture};

use super::yard::Yard;

/// Distance from an edge within which drivers may disagree about coverage, texels.
const EDGE_TEXELS: f64 = 1.0 / 64.0;
/// Depth error of an f32 rasteriser.
const DEPTH_TOLERANCE: f64 = 1e-5;
/// Share of texels at which a driver may still leave the bracket: slivers thinner than it samples.
pub const SLIVERS: f64 = 2e-5;

/// Smallest and largest depth that each texel may hold.
#[derive(Debug)]
pub struct DepthBracket {
    low: DepthMap,
    high: DepthMap,
    format: DepthFormat,
}

impl DepthBracket {
    /// The twin's maps with every facet's image shifted by up to 1/64 texel; casters are culled as the service culls.
    pub fn new(yard: &Yard, plan: &ShadowPlan, format: DepthFormat) -> Self {
        let (width, height) = plan.map_size_texels;
        let order = plan.depth_order;
        let mut low = DepthMap::cleared(width, height, order);
        let mut high = low.clone();
        let none = ShadowPlan { facets: Vec::new(), ..plan.clone() };
        for (number, facet) in plan.facets.iter().enumerate() {
            let places = (0..yard.places.len()).filter(|place| yard.reaches(*place, plan, number));
            let triangles = places
                .flat_map(|place| yard.place_from_eye(place, plan.eye_world, &plan.capture_from_world()));
            let triangles: Vec<_> = triangles.collect();

            // A facet at a time, as a map of its own.
            let tile = facet.tile;
            let area = (tile.width * tile.height) as usize;
            let (mut tile_low, mut tile_high) = (vec![1.0_f64; area], vec![0.0_f64; area]);
            for (x, y) in (-1..=1).flat_map(|y| (-1..=1).map(move |x| (x, y))) {
                let step = |side: u32, steps: i32| 2.0 * EDGE_TEXELS / f64::from(side) * f64::from(steps);
                let mut facet = facet.clone();
                facet.rows.x += facet.rows.w * step(tile.width, x);
                if facet.rows.remap.is_none() {
                    match facet.rows.remap.is_none() {
                        true => facet.rows.y += facet.rows.w * step(tile.height, y),
                        false => facet.rows.remap.shift += step(tile.height, y),
                    }
                } else {
                    facet.rows.remap.shift += step(tile.height, y);
                }
                (facet.tile.x, facet.tile.y) = (0, 0);
                let alone = ShadowPlan {
                    facets: vec![facet],
                    map_size_texels: (tile.width, tile.height),
                    ..none.clone()
                };
                let shifted = capture(&alone, &triangles).depths;
                tile_low.iter_mut().zip(&shifted).for_each(|(low, depth)| *low = low.min(*depth));
                tile_high.iter_mut().zip(&shifted).for_each(|(high, depth)| *high = high.max(*depth));
            }

            // Where facets share a tile, what lies nearest to the light stays.
            let nearest = |to: &mut f64, depth: f64| match order {
                DepthOrder::Standard => *to = to.min(depth),
                DepthOrder::Reversed => *to = to.max(depth),
            };
            for row in 0..tile.height {
                let start = ((tile.y + row) * width + tile.x) as usize;
                for column in 0..tile.width as usize {
                    let from = row as usize * tile.width as usize + column;
                    nearest(&mut low.depths[start + column], tile_low[from]);
                    nearest(&mut high.depths[start + column], tile_high[from]);
                }
            }
        }
        Self { low: low.stored(format), high: high.stored(format), format }
    }

    /// Whether a texel's depth is the same, up to the accuracy of drivers, within 1/64 texel.
    pub fn is_sure(&self, texel: usize) -> bool {
        self.high.depths[texel] - self.low.depths[texel] <= DEPTH_TOLERANCE
    }

    /// Number of texels outside.
    pub fn violations(&self, map: &DepthMap) -> usize {
        let tolerance = DEPTH_TOLERANCE + self.format.rounding();
        let limits = self.low.depths.iter().zip(&self.high.depths);
        let outside = |(stored, (low, high)): &(&f64, (&f64, &f64))| {
            **stored < *low - tolerance || **stored > *high + tolerance
        };
        map.depths.iter().zip(limits).filter(outside).count()
    }
}
