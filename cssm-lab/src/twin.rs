//! The f64 twin on a sight: what a case's shaders would show if they knew no rounding.
//!
//! Facets are captured one by one into tiles of their own, in parallel and with casters culled, and then put together:
//! facets that share a tile are kept apart by their clip rows.

use std::ops::Range;

use cssm_core::facet::{Facet, Tile};
use cssm_core::glam::DVec3;
use cssm_core::plan::DepthOrder;
use cssm_core::twin::{DepthMap, Triangle, capture_tested, resolve};
use cssm_core::{BoundingBox, LightCase, ShadowPlan};
use rayon::prelude::*;

use crate::error::LabError;
use crate::scene::{AlphaMask, Scene};
use crate::sight::{Outcome, Sight};

/// A scene's casters, relative to an eye.
pub struct TwinCasters<'a> {
    triangles: Vec<Triangle>,
    boxes: Vec<BoundingBox>,
    holes: Vec<Option<Hole<'a>>>,
    clusters: Vec<Cluster>,
}

/// Triangles that are culled together, because they belong to one instance.
#[derive(Clone)]
struct Cluster {
    triangles: Range<usize>,
    around: BoundingBox,
}

/// Where a triangle lies in an alpha mask.
#[derive(Clone, Copy)]
struct Hole<'a> {
    mask: &'a AlphaMask,
    corners: [u32; 3],
}

/// What the twin made of a sight.
pub struct TwinOutcome {
    /// The plan.
    pub plan: ShadowPlan,
    /// Depths of the map.
    pub depths: Vec<f32>,
    /// What the map gives the pixels, judged.
    pub outcome: Outcome,
}

/// Plans, captures, resolves and judges a case.
///
/// # Errors
/// What planning says.
pub fn outcome(
    sight: &Sight<'_>,
    casters: &TwinCasters<'_>,
    case: &LightCase,
) -> Result<TwinOutcome, LabError> {
    let plan = sight.plan(case)?;
    Ok(outcome_of_plan(sight, casters, case, plan))
}

/// [`outcome()`] with a plan of the caller's own, such as a deliberately wrong one.
pub fn outcome_of_plan(
    sight: &Sight<'_>,
    casters: &TwinCasters<'_>,
    case: &LightCase,
    plan: ShadowPlan,
) -> TwinOutcome {
    let (map, visibility) = visibility(sight, casters, case, &plan);
    let outcome = sight.judge(&plan, case.filter, visibility);
    let depths = map.depths.into_iter().map(|depth| depth as f32).collect();
    TwinOutcome { plan, depths, outcome }
}

/// Captures the map of a plan and resolves the visibility of each pixel, without judging it.
pub fn visibility(
    sight: &Sight<'_>,
    casters: &TwinCasters<'_>,
    case: &LightCase,
    plan: &ShadowPlan,
) -> (DepthMap, Vec<f32>) {
    let map = casters.capture(plan).stored(case.map.format);
    let shown = |pixel: &crate::truth::Visible| {
        resolve(case, plan, &map, pixel.position, pixel.normal).visibility as f32
    };
    let pixels = sight.frame.pixels.par_iter();
    let visibility = pixels.map(|pixel| pixel.as_ref().map_or(1.0, shown)).collect();
    (map, visibility)
}

impl<'a> TwinCasters<'a> {
    /// The triangles of a scene, relative to an eye.
    pub fn new(scene: &'a Scene, eye_world: DVec3) -> Self {
        let mut casters =
            Self { triangles: Vec::new(), boxes: Vec::new(), holes: Vec::new(), clusters: Vec::new() };
        for instance in &scene.instances {
            let mesh = &scene.meshes[instance.mesh];
            let first = casters.triangles.len();
            for corners in mesh.indices.chunks_exact(3) {
                let corners = [corners[0], corners[1], corners[2]];
                let triangle = corners.map(|corner| {
                    let object = DVec3::from_array(mesh.positions[corner as usize].map(f64::from));
                    instance.world_from_object.transform_point3(object) - eye_world
                });
                let [one, two, three] = triangle;
                casters
                    .boxes
                    .push(BoundingBox { min: one.min(two).min(three), max: one.max(two).max(three) });
                casters.triangles.push(triangle);
                casters.holes.push(mesh.mask.as_ref().map(|mask| Hole { mask, corners }));
            }
            let together = |one: BoundingBox, two: &BoundingBox| BoundingBox {
                min: one.min.min(two.min),
                max: one.max.max(two.max),
            };
            if let Some((one, rest)) = casters.boxes[first..].split_first() {
                let around = rest.iter().fold(*one, together);
                casters.clusters.push(Cluster { triangles: first..casters.triangles.len(), around });
            }
        }
        casters
    }

    /// The same triangles, none of which has holes.
    pub fn without_holes(&self) -> Self {
        let holes = vec![None; self.holes.len()];
        let (triangles, boxes, clusters) =
            (self.triangles.clone(), self.boxes.clone(), self.clusters.clone());
        Self { triangles, boxes, holes, clusters }
    }

    /// Triangles of the instances that each facet of a plan draws, all facets together: what a service that culls
    /// instances submits.
    pub fn submitted(&self, plan: &ShadowPlan) -> u64 {
        plan.facets.iter().flat_map(|facet| self.reached(facet)).map(|range| range.len() as u64).sum()
    }

    /// Triangles of the instances that a facet draws.
    fn reached(&self, facet: &Facet) -> impl Iterator<Item = Range<usize>> {
        let reached = self.clusters.iter().filter(|cluster| facet.reached_by(&cluster.around));
        reached.map(|cluster| cluster.triangles.clone())
    }

    /// The map of a plan.
    fn capture(&self, plan: &ShadowPlan) -> DepthMap {
        let tiles: Vec<DepthMap> =
            plan.facets.par_iter().map(|facet| self.capture_facet(plan, facet)).collect();
        let (width, height) = plan.map_size_texels;
        let mut map = DepthMap::cleared(width, height, plan.depth_order);
        for (facet, tile) in plan.facets.iter().zip(&tiles) {
            let Tile { x, y, .. } = facet.tile;
            for (row, depths) in tile.depths.chunks_exact(tile.width as usize).enumerate() {
                let start = (y as usize + row) * width as usize + x as usize;
                for (texel, depth) in map.depths[start..].iter_mut().zip(depths) {
                    *texel = match plan.depth_order {
                        DepthOrder::Standard => texel.min(*depth),
                        DepthOrder::Reversed => texel.max(*depth),
                    };
                }
            }
        }
        map
    }

    /// The tile of one facet, at the origin.
    fn capture_facet(&self, plan: &ShadowPlan, facet: &Facet) -> DepthMap {
        let instances = self.reached(facet).flatten();
        let reaching: Vec<usize> = instances.filter(|index| facet.reached_by(&self.boxes[*index])).collect();
        let triangles: Vec<Triangle> = reaching.iter().map(|index| self.triangles[*index]).collect();
        let tile = Tile { x: 0, y: 0, ..facet.tile };
        let alone = ShadowPlan {
            map_size_texels: (tile.width, tile.height),
            facets: vec![Facet { tile, ..facet.clone() }],
            ..plan.clone()
        };
        capture_tested(&alone, &triangles, |index, weights| {
            self.holes[reaching[index]].is_none_or(|hole| hole.is_solid(weights))
        })
    }
}

impl Hole<'_> {
    /// Whether a point, given by the weights of the corners, stops light.
    fn is_solid(&self, weights: DVec3) -> bool {
        let uv = |corner: u32| {
            self.mask.uvs.get(corner as usize).map(|uv| DVec3::new(f64::from(uv[0]), f64::from(uv[1]), 0.0))
        };
        let [one, two, three] = self.corners.map(uv);
        let (Some(one), Some(two), Some(three)) = (one, two, three) else { return true };
        let place = one * weights.x + two * weights.y + three * weights.z;
        !self.mask.is_hole(place.x, place.y)
    }
}
