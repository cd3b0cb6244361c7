//! The lie of the land: where a camera can stand, and what it sees from there.

use cssm_core::glam::DVec3;
use cssm_core::{BoundingBox, Light, View};

use super::Station;
use crate::error::LabError;
use crate::scene::Scene;
use crate::truth::{Frame, Tracer};

/// Image in which a place is looked over.
const PREVIEW_PIXELS: (u32, u32) = (32, 18);
/// Nothing may stand nearer to the eye, metres.
const CLEARANCE_METRES: f64 = 0.4;
/// Least share of a worthwhile image that sees a surface.
const LEAST_VISIBLE: f64 = 0.2;
/// Least share of its light-facing pixels that lie in shadow, and least that are lit.
const LEAST_OF_EACH: f64 = 0.03;
/// How far above a walker's last place the ground may rise, metres.
const RISE_METRES: f64 = 2.0;

/// A scene as one who walks it knows it.
pub(super) struct Land<'a> {
    tracer: &'a Tracer,
    /// Box around everything.
    pub(super) bounds: BoundingBox,
    /// Pixels of the stations' images.
    pub(super) size_pixels: (u32, u32),
}

impl<'a> Land<'a> {
    /// Surveys a scene.
    pub(super) fn of(scene: &Scene, tracer: &'a Tracer, size_pixels: (u32, u32)) -> Result<Self, LabError> {
        let bounds = scene.bounds_world().ok_or(LabError::NoView)?;
        Ok(Self { tracer, bounds, size_pixels })
    }

    /// The place a height above the ground under a point; the point itself where nothing lies below.
    pub(super) fn above_ground(&self, point: DVec3, height_metres: f64) -> DVec3 {
        let from = point + DVec3::Y * RISE_METRES;
        let reach = from.y - self.bounds.min.y + 1.0;
        match self.distance(from, DVec3::NEG_Y, reach) {
            Some(depth) => from + DVec3::Y * (height_metres - depth),
            None => point,
        }
    }

    /// Distance from a point to the first surface in a direction.
    pub(super) fn distance(&self, from: DVec3, direction: DVec3, reach_metres: f64) -> Option<f64> {
        let hit = self.tracer.nearest(from, direction, 0.0, reach_metres, &mut Vec::new())?;
        Some(hit.distance)
    }

    /// Whether a station stands free and sees both light and shadow.
    pub(super) fn is_worthwhile(&self, station: &Station) -> bool {
        let frame = self.preview(&station.view, &station.light);
        let visible = frame.visible().count();
        let nearest = frame.visible().map(|(_, pixel)| pixel.depth).fold(f64::INFINITY, f64::min);
        let facing = frame.visible().filter(|(_, pixel)| pixel.faces_light());
        let (facing, shadowed) =
            facing.fold((0, 0), |(all, dark), (_, pixel)| (all + 1, dark + usize::from(!pixel.lit)));
        let least = LEAST_OF_EACH * f64::from(facing);
        visible as f64 >= LEAST_VISIBLE * frame.pixels.len() as f64
            && nearest >= CLEARANCE_METRES
            && facing > 0
            && shadowed as f64 >= least
            && f64::from(facing) - shadowed as f64 >= least
    }

    fn preview(&self, view: &View, light: &Light) -> Frame {
        let small = View { size_pixels: PREVIEW_PIXELS, ..*view };
        Frame::trace(self.tracer, &small, light, &|_| {})
    }
}
