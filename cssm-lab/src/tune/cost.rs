//! What a frame costs on any machine: the memory that moves for its shadows.
//!
//! Times differ from machine to machine and from run to run; bytes do not. Three streams make up the work of a shadow
//! map and all three are memory: the map is written, the corners of the casters that culling leaves are read once for
//! every facet, and every visible pixel reads texels.

use std::ops::AddAssign;

use cssm_core::case::MapSpec;
use cssm_core::{LightCase, ShadowPlan};

use crate::sight::Sight;
use crate::twin::TwinCasters;

/// Three corners of three 32-bit floats.
const BYTES_PER_TRIANGLE: f64 = 36.0;

/// Mean counts of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Cost {
    /// Bytes of the map.
    pub map_bytes: f64,
    /// Triangles submitted, all facets together, with whole instances culled.
    pub triangles: f64,
    /// Bytes of texels that visible pixels read.
    pub read_bytes: f64,
    /// Facets of the plan.
    pub facets: f64,
}

impl Cost {
    /// Counts of one frame.
    pub fn of_frame(
        case: &LightCase,
        plan: &ShadowPlan,
        casters: &TwinCasters<'_>,
        sight: &Sight<'_>,
    ) -> Self {
        let visible = sight.frame.visible().count() as f64;
        let texels = f64::from(case.filter.texels_across()).powi(2);
        Self {
            map_bytes: map_bytes(&case.map),
            triangles: casters.submitted(plan) as f64,
            read_bytes: visible * texels * f64::from(case.map.format.bytes_per_texel()),
            facets: plan.facets.len() as f64,
        }
    }

    /// All bytes that move.
    pub fn bytes(&self) -> f64 {
        self.map_bytes + BYTES_PER_TRIANGLE * self.triangles + self.read_bytes
    }

    /// The same with a map of another size.
    pub fn with_map(self, map: &MapSpec) -> Self {
        Self { map_bytes: map_bytes(map), ..self }
    }

    /// The mean, of a sum over so many frames.
    pub fn of(self, frames: usize) -> Self {
        let mean = |sum: f64| sum / frames.max(1) as f64;
        Self {
            map_bytes: mean(self.map_bytes),
            triangles: mean(self.triangles),
            read_bytes: mean(self.read_bytes),
            facets: mean(self.facets),
        }
    }
}

impl AddAssign for Cost {
    fn add_assign(&mut self, other: Self) {
        self.map_bytes += other.map_bytes;
        self.triangles += other.triangles;
        self.read_bytes += other.read_bytes;
        self.facets += other.facets;
    }
}

fn map_bytes(map: &MapSpec) -> f64 {
    f64::from(map.width) * f64::from(map.height) * f64::from(map.format.bytes_per_texel())
}

/// Bytes in the unit that suits them.
pub fn bytes_text(bytes: f64) -> String {
    if bytes < 1e6 { format!("{:.1} kB", bytes / 1e3) } else { format!("{:.2} MB", bytes / 1e6) }
}
