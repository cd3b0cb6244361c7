//! What a plan gives each visible pixel: its facet, its texel footprints, the texels it reads.

use cssm_core::case::Filter;
use cssm_core::facet::Facet;
use cssm_core::glam::DVec3;
use cssm_core::{ShadowPlan, View, footprint};
use rayon::prelude::*;
use serde::Serialize;

use super::NO_FACET;
use super::statistics::Percentiles;
use crate::truth::Frame;

/// Footprints of one map texel at one visible pixel, in screen pixels.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PixelFootprint {
    /// Across the light ray, larger axis.
    pub volume_pixels: f64,
    /// Across the light ray, geometric mean of both axes.
    pub geometric_pixels: f64,
    /// On the visible surface, larger axis.
    pub surface_pixels: f64,
}

/// Largest footprint that is told apart; a surface along the light or the ray has none.
const LARGEST_PIXELS: f64 = 1e6;

/// Footprint figures of a frame: metrics over its visible pixels.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FrameFootprint {
    /// Volume footprint.
    pub volume: Percentiles,
    /// Geometric footprint.
    pub geometric: Percentiles,
    /// Surface footprint of light-facing pixels.
    pub surface: Percentiles,
}

/// What a plan gives to the pixels of a frame.
#[derive(Debug, Clone)]
pub struct Assignment {
    /// Facet of each pixel; [`NO_FACET`] for sky and where the plan lists no facet.
    pub facets: Vec<u32>,
    /// Footprints of each pixel; `None` where there is no facet.
    pub footprints: Vec<Option<PixelFootprint>>,
    /// Share of the map's texels that at least one visible pixel reads.
    pub scene_utilisation: f64,
}

impl Assignment {
    /// Assigns every visible pixel of a frame.
    pub fn new(plan: &ShadowPlan, view: &View, frame: &Frame, filter: Filter) -> Self {
        // Select facets and take footprints, pixel by pixel.
        let found: Vec<_> = frame
            .pixels
            .par_iter()
            .map(|pixel| {
                let pixel = pixel.as_ref()?;
                let facet = plan.facet(plan.selection.cell(pixel.position.extend(1.0)))?;
                let volume = footprint::volume(facet, view, pixel.position);
                let surface = footprint::surface(facet, view, pixel.position, pixel.normal);
                let capped = |pixels: f64| {
                    if pixels < LARGEST_PIXELS { pixels } else { LARGEST_PIXELS }
                };
                let footprint = PixelFootprint {
                    volume_pixels: capped(volume.major_pixels),
                    geometric_pixels: capped(volume.geometric_pixels),
                    surface_pixels: capped(surface),
                };
                Some((facet.first_cell(), footprint))
            })
            .collect();

        // Mark the texels that the filter reads.
        let (width, height) = plan.map_size_texels;
        let mut read = vec![false; width as usize * height as usize];
        for (pixel, found) in frame.pixels.iter().zip(&found) {
            let (Some(pixel), Some((index, _))) = (pixel, found) else {
                continue;
            };
            let Some(facet) = plan.facet(*index) else { continue };
            let Some((x, y)) = map_texel(facet, pixel.position) else {
                continue;
            };
            let across = filter.texels_across();
            let before = 0.5 * f64::from(across - 1);
            let (first_column, first_row) = ((x - before).floor(), (y - before).floor());
            for tap in 0..across * across {
                let column = first_column + f64::from(tap % across);
                let row = first_row + f64::from(tap / across);
                if (0.0..f64::from(width)).contains(&column) && (0.0..f64::from(height)).contains(&row) {
                    read[row as usize * width as usize + column as usize] = true;
                }
            }
        }
        let used = read.iter().filter(|read| **read).count();
        Self {
            facets: found.iter().map(|found| found.map_or(NO_FACET, |(facet, _)| facet)).collect(),
            footprints: found.iter().map(|found| found.map(|(_, footprint)| footprint)).collect(),
            scene_utilisation: super::statistics::share(used as u64, read.len() as u64),
        }
    }

    /// Footprint figures over the visible pixels.
    pub fn frame_footprint(&self, frame: &Frame) -> FrameFootprint {
        let all = |pick: fn(&PixelFootprint) -> f64| {
            Percentiles::of(self.footprints.iter().flatten().map(pick).collect())
        };
        let facing = self.footprints.iter().zip(&frame.pixels).filter_map(|(footprint, pixel)| {
            pixel.as_ref().filter(|pixel| pixel.faces_light())?;
            Some(footprint.as_ref()?.surface_pixels)
        });
        FrameFootprint {
            volume: all(|footprint| footprint.volume_pixels),
            geometric: all(|footprint| footprint.geometric_pixels),
            surface: Percentiles::of(facing.collect()),
        }
    }
}

/// Map texel coordinates of a point; `None` behind the facet and outside its tile.
pub fn map_texel(facet: &Facet, point_from_eye: DVec3) -> Option<(f64, f64)> {
    let point = point_from_eye.extend(1.0);
    let w = facet.rows.w.dot(point);
    let rows = &facet.rows;
    let (x, y) = (rows.x.dot(point) / w, rows.remap.y(rows.y.dot(point) / w));
    (w > 0.0 && x.abs() <= 1.0 && y.abs() <= 1.0).then(|| facet.tile.texel_from_ndc(x, y))
}
