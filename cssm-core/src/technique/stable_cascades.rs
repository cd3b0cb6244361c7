//! Stable cascades: depth slabs along the view whose maps neither turn nor breathe, so that static shadows do not flicker.
//! What engines ship.
//!
//! Each slab is enclosed by a sphere, whose size does not depend on where the camera looks; the map's axes stand still
//! in the world; and the map's middle moves in whole texels. The price is texels: a slab covers a third to a half of the
//! square around its sphere.

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

use super::{
    ConfigurationSpec, Drafts, FacetDraft, Region, Situation, TechniqueSpec, TileRequest, only_directional,
    slabs, standard::light_plane_axes,
};
use crate::case::LightKind;
use crate::facet::{Cell, FacetShape};
use crate::plan::PlanError;
use crate::receivers::DEPTH_ROW;
use crate::schema::{Choice, Word};
use crate::view::View;

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice {
        name: "stable_cascades",
        summary: "depth slabs in spheres, held still in the world by whole texels",
        arguments: &[slabs::SPLITS, slabs::SCHEME, slabs::SIZES],
    },
    configurations: &[ConfigurationSpec {
        choice: Choice::plain("spheres", "one facet per depth slab"),
        lights: &[LightKind::Directional],
        takes_distribution: false,
        serves: |_| true,
        shape: |case, _| FacetShape { bands: slabs::count(case), ..FacetShape::ONE },
        draft,
    }],
    default_configurations: |light| only_directional(light, &["spheres"]),
    distribution: None,
    fits_infinity: false,
    follows_camera: false,
    variants: &["stable_cascades", "stable_cascades { splits: 4, scheme: logarithmic }"],
    check: slabs::check,
};

/// Radii are rounded up to this share of the sphere's own power of two, so that f64 noise does not move texels.
const RADIUS_STEPS: f64 = 1024.0;

fn draft(situation: &Situation<'_>, word: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    if situation.receivers.is_unbounded() {
        return Err(PlanError::Unbounded { technique: SPEC.choice.name });
    }
    let case = situation.case;
    let splits = slabs::count(case);
    let view = situation.view;

    // Slabs of the whole view, wherever receivers are: what moves with the scene is not stable.
    let (near, far) = (view.near_metres, view.far_metres);
    let (near, far) = if far.is_finite() { (near, far) } else { situation.receivers.range(DEPTH_ROW) };
    let limits = slabs::limits_metres(case, near, far);
    let ends: SmallVec<[f64; 10]> = [near].into_iter().chain(limits.iter().copied()).chain([far]).collect();
    let sizes = sizes(situation, splits);
    let to_camera = view.camera_from_world;
    let (right, up) = light_plane_axes((to_camera.transpose() * situation.light.truncate()).extend(0.0));

    let draft = drafts.open(word.name, (1, splits));
    draft.reserve(splits as usize);
    let mut slices = slabs::slices(&limits, &situation.receivers);
    for slab in 0..splits as usize {
        let (width, height) = sizes[slab];
        let (middle, radius) = sphere(view, ends[slab], ends[slab + 1]);
        let middle_world = view.eye_world + to_camera.transpose() * middle;
        let row = |axis: DVec3, side: u32| {
            // One texel more than the sphere needs, because its middle is up to half a texel off.
            let texels = f64::from(side.saturating_sub(2 * case.gutter_texels()).max(2));
            let texel = 2.0 * radius / (texels - 1.0);
            let snapped = libm::round(axis.dot(middle_world) / texel) * texel;
            let from_eye = snapped - axis.dot(view.eye_world);
            ((to_camera * axis).extend(-from_eye)) / (0.5 * texels * texel)
        };
        let select = slabs::select(&limits, slab);
        let rows = [row(right.truncate(), width), row(up.truncate(), height), DVec4::W];
        let region = Region::Whole(TileRequest::Fixed(width, height));
        let limit = limits.get(slab).copied();
        let facet = FacetDraft::straight(Cell::of(0, slab as u32), rows, select, region);
        slabs::push(facet, limit, (slices.as_mut(), &situation.receivers), draft);
    }
    slabs::select_by(&limits, &mut draft.selection);
    Ok(())
}

/// Tile of each slab: as declared, or the largest equal squares that the map holds.
fn sizes(situation: &Situation<'_>, splits: u32) -> SmallVec<[(u32, u32); 8]> {
    if let Some(sizes) = situation.case.technique.arguments.sizes(slabs::SIZES.name) {
        return sizes.iter().map(|size| situation.tile_size(*size)).collect();
    }
    let (width, height) = situation.map_size_texels;
    let side = |columns: u32| (width / columns).min(height / splits.div_ceil(columns));
    let largest = (1..=splits).map(side).max().unwrap_or(0);
    SmallVec::from_elem((largest, largest), splits as usize)
}

/// Middle (camera space) and radius of a sphere around a slab that depend on nothing but the projection.
fn sphere(view: &View, near_metres: f64, far_metres: f64) -> (DVec3, f64) {
    let squares = view.corner_tangents().map(|(x, y)| x * x + y * y);
    let square = squares.into_iter().fold(0.0, f64::max);
    let depth = (0.5 * (near_metres + far_metres) * (1.0 + square)).min(far_metres);
    let reach = |end: f64| ((depth - end) * (depth - end) + square * end * end).sqrt();
    let radius = reach(near_metres).max(reach(far_metres));
    let step = libm::exp2(libm::floor(libm::log2(radius))) / RADIUS_STEPS;
    (DVec3::new(0.0, 0.0, -depth), libm::ceil(radius / step) * step)
}
