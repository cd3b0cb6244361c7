//! One case on one scene: its figures.

use crate::report::Report;

/// What the case is, what it did, and why its configuration was chosen.
pub(super) fn figures(report: &Report) -> [String; 3] {
    let score = &report.score;
    let facing = score.facing_pixels as f64;
    [
        format!(
            "{} on {}: {} / {}, {} facets, {} triangles drawn",
            report.case,
            report.scene,
            report.technique,
            report.configuration,
            report.facets,
            report.triangles_submitted
        ),
        format!(
            "wrong {:.2} %, interior {:.4} %, footprint p95 {:.2} px, edge p95 {:.2} px",
            100.0 * score.mismatch,
            100.0 * score.interior_wrong_pixels as f64 / facing.max(1.0),
            report.footprint.p95,
            score.edge_displacement.true_to_map.pixels.p95
        ),
        report.choice.clone(),
    ]
}
