//! One case on one scene: figures over the view, the map and the errors.

use crate::error::LabError;
use crate::picture::{
    LABEL_BACKGROUND, LINE_PIXELS, Picture, map_picture_of_size, mean, shaded_picture, verdict_picture,
    worst_verdict,
};
use crate::report::Report;
use crate::stage::{Attempt, Outcome};

/// Width of the view and of the errors.
const VIEW_PIXELS: usize = 320;
/// Largest height of the pictures of a cell.
const HEIGHT_LIMIT_PIXELS: usize = 320;
const GAP_PIXELS: usize = 6;

/// The view, the map and the errors side by side.
pub(super) fn pictures(attempt: &Attempt<'_>, outcome: &Outcome) -> Result<Picture, LabError> {
    // Keep the view's proportions, and the map's at the same height.
    let (stage, frame) = (attempt.stage(), &attempt.stage().frame);
    let height = (VIEW_PIXELS * frame.height / frame.width).clamp(1, HEIGHT_LIMIT_PIXELS);
    let (map_width, map_height) = attempt.plan.map_size_texels;
    let map_pixels = (height * map_width as usize / map_height as usize).clamp(1, 2 * height);
    let view = shaded_picture(stage.scene, frame, &outcome.visibility, &stage.light);
    let verdicts = verdict_picture(frame.width, frame.height, &outcome.verdicts);
    let pictures = [
        view.shrunk(VIEW_PIXELS, height, mean),
        map_picture_of_size(&attempt.plan, &attempt.map()?, (map_pixels, height)),
        verdicts.shrunk(VIEW_PIXELS, height, worst_verdict),
    ];

    let width = pictures.iter().map(|picture| picture.width + GAP_PIXELS).sum();
    let mut joined = Picture::filled(width, height + GAP_PIXELS, LABEL_BACKGROUND);
    let mut x = 0;
    for picture in &pictures {
        joined.paste(picture, x, 0);
        x += picture.width + GAP_PIXELS;
    }
    Ok(joined)
}

/// Lines of text over pictures of a width.
pub(super) fn text(report: &Report, width: usize) -> Vec<String> {
    figures(report).iter().flat_map(|text| Picture::lines(text, width)).collect()
}

/// Pictures under lines of text, with room for so many lines.
pub(super) fn labelled(pictures: &Picture, text: &[String], lines: usize) -> Picture {
    let top = lines.max(text.len()) * LINE_PIXELS;
    let mut cell = Picture::filled(pictures.width, top + pictures.height, LABEL_BACKGROUND);
    for (line, text) in text.iter().enumerate() {
        cell.label(line * LINE_PIXELS, text);
    }
    cell.paste(pictures, 0, top);
    cell
}

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
