//! From a visible point to its visibility, step by step as the shader does it.

use glam::{DVec2, DVec3};

use super::ground::GroundMask;
use super::moments::Moments;
use super::{DepthMap, kernel};
use crate::case::{Bias, Filter, LightCase, Stretch};
use crate::distribution::RemapKind;
use crate::facet::{Facet, FacetRows};
use crate::ground::{self, PlaneInTile};
use crate::homography::Gradients;
use crate::plan::ShadowPlan;

/// What resolving a visible point found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolved {
    /// Cell that the selection walk ended in.
    pub cell: u32,
    /// Map texel coordinates (centres at .5, y down); NaN when the facet has no receivers.
    pub texel: DVec2,
    /// Stored depth of the point in the facet, before bias.
    pub depth: f64,
    /// 0 in shadow, 1 lit, between where the filter blends.
    pub visibility: f64,
}

/// How far casters' edges may lie off along the rows, in texels.
fn chord_texels(case: &LightCase) -> f64 {
    match (case.remap(), case.stretch) {
        (RemapKind::None, _) | (_, Stretch::None | Stretch::Vertex) => 0.0,
        (_, Stretch::Exact { bound_texels }) => bound_texels,
    }
}

/// Smallest cosine between normal and light that a slope bias reckons with.
const SMALLEST_COSINE: f64 = 0.01;

/// Visibility of a point relative to the eye with a unit geometric normal, world axes.
pub fn resolve(
    case: &LightCase,
    plan: &ShadowPlan,
    map: &DepthMap,
    point_from_eye: DVec3,
    normal: DVec3,
) -> Resolved {
    // Walk to the facet.
    let index = plan.selection.cell(point_from_eye.extend(1.0));
    let lit = |texel, depth| Resolved { cell: index, texel, depth, visibility: 1.0 };
    let Some(facet) = plan.facet(index) else { return lit(DVec2::NAN, f64::NAN) };

    // Find the texel; beyond the facet's own receivers everything is lit.
    // Depth that grows away from the light is compared, whichever way it is stored.
    let sign = plan.depth_order.sign();
    let gradients = Gradients::at(&FacetRows { z: facet.rows.z * sign, ..facet.rows }, point_from_eye);
    if gradients.w <= 0.0 {
        return lit(DVec2::NAN, f64::NAN);
    }
    let (x, y) = facet.tile.texel_from_ndc(gradients.ndc.x, gradients.ndc.y);
    let (texel, depth) = (DVec2::new(x, y), gradients.ndc.z * sign);
    let (low, high) = facet.tile.texel_limits();
    if texel.cmplt(low).any() || texel.cmpgt(high).any() {
        return lit(texel, depth);
    }

    // Compare and filter.
    let light = LightAt::receiver(plan, point_from_eye);
    let reference = Reference::new(case, facet, &gradients, texel, normal, &light);
    let stored = |corner: DVec2| map.depth(corner.x as i64, corner.y as i64);
    let (nearest, farthest) = (sign.min(0.0), sign.max(0.0));
    let lit_at = |reference: f64, corner: DVec2| {
        f64::from(u8::from(reference.clamp(nearest, farthest) <= sign * stored(corner)))
    };
    let visibility = match case.filter {
        Filter::None => {
            let corner = texel.floor();
            lit_at(reference.at(corner + 0.5), corner)
        }
        Filter::GroundMasks { blur_metres, reach_texels, .. }
            if let Some(plane) = ground_plane(case, plan, facet, point_from_eye) =>
        {
            let mask = |plane: PlaneInTile| {
                let mask = GroundMask {
                    tile: &facet.tile,
                    remap: &facet.rows.remap,
                    plane,
                    blur_metres,
                    reach_texels,
                };
                mask.visibility(texel, (nearest, farthest), |corner| sign * stored(corner))
            };
            plane.map_or(1.0, mask)
        }
        Filter::Gather2x2 | Filter::Hardware2x2 | Filter::GroundMasks { .. } => {
            let corner = (texel - 0.5).floor();
            let weight = texel - 0.5 - corner;
            let tap = |dx: f64, dy: f64| {
                let corner = corner + DVec2::new(dx, dy);
                let reference = match case.filter {
                    Filter::Hardware2x2 => reference.lowest(weight),
                    _ => reference.at(corner + 0.5),
                };
                lit_at(reference, corner)
            };
            let upper = tap(0.0, 0.0) * (1.0 - weight.x) + tap(1.0, 0.0) * weight.x;
            let lower = tap(0.0, 1.0) * (1.0 - weight.x) + tap(1.0, 1.0) * weight.x;
            upper * (1.0 - weight.y) + lower * weight.y
        }
        Filter::Pcf { size, kernel } => {
            let per_metre = kernel::texels_per_metre(&facet.tile, &gradients);
            let pixel_metres = plan.pixel_metres.dot(point_from_eye.extend(1.0));
            let widest = 0.5 * f64::from(size.texels());
            let wanted = kernel::half_widths(kernel, widest, per_metre, pixel_metres);
            let half_widths = wanted.min(kernel::room(&facet.tile, texel));
            kernel::lit_in_box(texel, half_widths, |corner| lit_at(reference.at(corner + 0.5), corner))
        }
        Filter::Evsm2 { exponent, blur_texels, bleeding } => {
            let moments = Moments { exponent, blur_texels, bleeding };
            let behind = reference.depth.clamp(nearest, farthest) - nearest;
            moments.visibility(&facet.tile, texel, behind, |corner| sign * stored(corner) - nearest)
        }
        Filter::Pcss { source, reach_texels } => {
            let per_metre = kernel::texels_per_metre(&facet.tile, &gradients);
            let soft = kernel::SoftEdge {
                per_depth: per_metre * (source.radius() * gradients.w / facet.depth_per_metre),
                widest: DVec2::splat(f64::from(reach_texels)).min(kernel::room(&facet.tile, texel)),
            };
            let before =
                |corner: DVec2| reference.at(corner + 0.5).clamp(nearest, farthest) - sign * stored(corner);
            soft.visibility(texel, reference.depth - nearest, before)
        }
    };
    Resolved { cell: index, texel, depth, visibility }
}

/// The plane with a mask that a receiver lies on, as the facet's tile shows it, if the light meets it. `None`: it lies on none.
fn ground_plane(
    case: &LightCase,
    plan: &ShadowPlan,
    facet: &Facet,
    point_from_eye: DVec3,
) -> Option<Option<PlaneInTile>> {
    let index = ground::plane_of(plan.ground_planes(), point_from_eye)?;
    let plane = plan.ground_planes().nth(index)?;
    Some(PlaneInTile::of(plane, facet, plan.light, plan.depth_order.sign(), chord_texels(case)))
}

/// The light as a receiver sees it.
struct LightAt {
    /// Unit vector towards it.
    toward: DVec3,
    /// One over its distance in metres; 1 for a directional light, whose depths do not depend on it.
    per_distance: f64,
}

impl LightAt {
    fn receiver(plan: &ShadowPlan, point_from_eye: DVec3) -> Self {
        if plan.light.w == 0.0 {
            return Self { toward: plan.light.truncate(), per_distance: 1.0 };
        }
        let toward = plan.light.truncate() - point_from_eye;
        let per_distance = 1.0 / toward.length();
        Self { toward: toward * per_distance, per_distance }
    }
}

/// The depth that texels around a receiver are compared with: a plane over the map.
struct Reference {
    texel: DVec2,
    depth: f64,
    per_texel: DVec2,
}

impl Reference {
    fn new(
        case: &LightCase,
        facet: &Facet,
        gradients: &Gradients,
        texel: DVec2,
        normal: DVec3,
        light: &LightAt,
    ) -> Self {
        let depth = gradients.ndc.z;
        let depth_per_metre = facet.depth_per_metre * light.per_distance;
        let flat = |bias: f64| Self { texel, depth: depth - bias, per_texel: DVec2::ZERO };
        match case.bias {
            Bias::None => flat(0.0),
            Bias::Constant { along_light_metres } => flat(along_light_metres * depth_per_metre / gradients.w),
            Bias::WorldTexel { a_metres, b_texels } => {
                flat(depth_per_metre * (a_metres / gradients.w + b_texels * facet.texel_metres_per_w))
            }
            Bias::Slope { texels } => {
                let cosine = normal.dot(light.toward).clamp(SMALLEST_COSINE, 1.0);
                let tangent = (1.0 - cosine * cosine).sqrt() / cosine;
                flat(texels * facet.texel_metres_per_w * depth_per_metre * tangent)
            }
            Bias::ReceiverPlane => {
                let (across, up) = gradients.depth_along_surface(normal);
                let per_texel = DVec2::new(
                    across * 2.0 / f64::from(facet.tile.width),
                    -up * 2.0 / f64::from(facet.tile.height),
                );
                // A plane that contains the light has no slope; it is held at one depth range a texel.
                let per_texel = if per_texel.is_nan() {
                    DVec2::ZERO
                } else {
                    per_texel.clamp(DVec2::NEG_ONE, DVec2::ONE)
                };
                // Casters drawn by their corners may be off by the bound along the rows.
                let lowered = facet.receiver_plane_depth * light.per_distance
                    + facet.rounding_depth
                    + chord_texels(case) * per_texel.y.abs();
                Self { texel, depth: depth - lowered, per_texel }
            }
        }
    }

    /// Depth at a texel centre.
    fn at(&self, centre: DVec2) -> f64 {
        self.depth + self.per_texel.dot(centre - self.texel)
    }

    /// Lowest depth at the four texel centres around the receiver, which lies `weight` past the first.
    fn lowest(&self, weight: DVec2) -> f64 {
        let one = self.per_texel * -weight;
        let two = self.per_texel * (DVec2::ONE - weight);
        self.depth + one.min(two).element_sum()
    }
}
