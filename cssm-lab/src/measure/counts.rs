//! Costs that do not depend on the machine.

use cssm_core::table::CaseTable;
use cssm_core::{BoundingBox, LightCase, ShadowPlan};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::bench::TriangleBoxes;

/// Bytes of a SPIR-V word.
const WORD_BYTES: usize = 4;

/// Costs of a case on a path: those of its declaration, and means over the stations.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Counts {
    /// Facets of a plan.
    pub facets: f64,
    /// Draw calls of the capture; absent where no device draws.
    pub draws: Option<f64>,
    /// Triangles that the capture draws, all facets together; absent where no device draws.
    pub triangles_submitted: Option<f64>,
    /// Triangles whose shadow can reach something visible in a facet, all facets together: what culling every triangle by
    /// itself would leave.
    pub triangles_after_culling: f64,
    /// Texels that hold a caster.
    pub texels_written: f64,
    /// Texels read for each pixel that is resolved.
    pub texels_fetched_per_pixel: u32,
    /// Texels of the map.
    pub map_texels: u64,
    /// Bytes of the map.
    pub map_bytes: u64,
    /// Words of SPIR-V, all shaders together.
    pub spirv_words: u64,
    /// Bindings, all shaders together.
    pub bindings: u64,
}

/// What the declaration alone decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct StaticCounts {
    texels_fetched_per_pixel: u32,
    map_texels: u64,
    map_bytes: u64,
    spirv_words: u64,
    bindings: u64,
}

/// Counts of one frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct FrameCounts {
    pub(super) facets: u64,
    pub(super) draws: Option<u64>,
    pub(super) triangles_submitted: Option<u64>,
    pub(super) triangles_after_culling: u64,
    pub(super) texels_written: u64,
}

impl StaticCounts {
    /// Counts of a generated table.
    pub(super) fn of(case: &LightCase, table: &CaseTable) -> Self {
        let taps = case.filter.texels_across() * case.filter.texels_across();
        let map_texels = u64::from(case.map.width) * u64::from(case.map.height);
        let words = table.shaders.iter().map(|shader| shader.spirv.len() / WORD_BYTES);
        Self {
            texels_fetched_per_pixel: taps,
            map_texels,
            map_bytes: map_texels * u64::from(case.map.format.bytes_per_texel()),
            spirv_words: words.sum::<usize>() as u64,
            bindings: table.groups.iter().map(|group| group.bindings.len()).sum::<usize>() as u64,
        }
    }
}

impl FrameCounts {
    /// Facets of a plan and the triangles that reach them; the rest is the device's to say.
    pub(super) fn of(plan: &ShadowPlan, boxes: &TriangleBoxes) -> Self {
        let from_eye = |bounds: &BoundingBox| BoundingBox {
            min: bounds.min - plan.eye_world,
            max: bounds.max - plan.eye_world,
        };
        let reaching = boxes.groups.par_iter().map(|(around, triangles)| {
            let facets = plan.facets.iter().filter(|facet| facet.reached_by(&from_eye(around)));
            let counts = facets.map(|facet| {
                triangles.iter().filter(|triangle| facet.reached_by(&from_eye(triangle))).count() as u64
            });
            counts.sum::<u64>()
        });
        Self { facets: plan.facets.len() as u64, triangles_after_culling: reaching.sum(), ..Self::default() }
    }
}

impl Counts {
    /// Counts of a case, with means over frames.
    pub(super) fn of(constant: StaticCounts, frames: &[FrameCounts]) -> Self {
        let mean = |pick: &dyn Fn(&FrameCounts) -> Option<u64>| -> Option<f64> {
            let total = frames.iter().map(pick).sum::<Option<u64>>()?;
            Some(total as f64 / frames.len().max(1) as f64)
        };
        let StaticCounts { texels_fetched_per_pixel, map_texels, map_bytes, spirv_words, bindings } =
            constant;
        Self {
            facets: mean(&|frame| Some(frame.facets)).unwrap_or_default(),
            draws: mean(&|frame| frame.draws),
            triangles_submitted: mean(&|frame| frame.triangles_submitted),
            triangles_after_culling: mean(&|frame| Some(frame.triangles_after_culling)).unwrap_or_default(),
            texels_written: mean(&|frame| Some(frame.texels_written)).unwrap_or_default(),
            texels_fetched_per_pixel,
            map_texels,
            map_bytes,
            spirv_words,
            bindings,
        }
    }
}
