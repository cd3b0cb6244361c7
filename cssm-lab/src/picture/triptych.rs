//! One case in one situation: the view, the map and the errors under a few lines of text.

use cssm_core::ShadowPlan;

use super::{
    LABEL_BACKGROUND, LINE_PIXELS, Picture, map_picture_of_size, mean, shaded_picture, verdict_picture,
    worst_verdict,
};
use crate::sight::{Outcome, Sight};

/// Width of the view and of the errors.
const VIEW_PIXELS: usize = 320;
/// Largest height of the pictures.
const HEIGHT_LIMIT_PIXELS: usize = 320;
const GAP_PIXELS: usize = 6;

/// The view, the map and the errors side by side.
pub fn triptych(sight: &Sight<'_>, plan: &ShadowPlan, depths: &[f32], outcome: &Outcome) -> Picture {
    // Keep the view's proportions, and the map's at the same height.
    let frame = &sight.frame;
    let height = (VIEW_PIXELS * frame.height / frame.width).clamp(1, HEIGHT_LIMIT_PIXELS);
    let (map_width, map_height) = plan.map_size_texels;
    let map_pixels = (height * map_width as usize / map_height as usize).clamp(1, 2 * height);
    let view = shaded_picture(sight.scene, frame, &outcome.visibility, &sight.light);
    let verdicts = verdict_picture(frame.width, frame.height, &outcome.verdicts);
    let pictures = [
        view.shrunk(VIEW_PIXELS, height, mean),
        map_picture_of_size(plan, depths, (map_pixels, height)),
        verdicts.shrunk(VIEW_PIXELS, height, worst_verdict),
    ];

    let width = pictures.iter().map(|picture| picture.width + GAP_PIXELS).sum();
    let mut joined = Picture::filled(width, height + GAP_PIXELS, LABEL_BACKGROUND);
    let mut x = 0;
    for picture in &pictures {
        joined.paste(picture, x, 0);
        x += picture.width + GAP_PIXELS;
    }
    joined
}

/// Lines of text, broken to fit pictures of a width.
pub fn broken(lines: &[String], width: usize) -> Vec<String> {
    lines.iter().flat_map(|text| Picture::lines(text, width)).collect()
}

/// Pictures under lines of text, with room for so many lines.
pub fn labelled(pictures: &Picture, text: &[String], lines: usize) -> Picture {
    let top = lines.max(text.len()) * LINE_PIXELS;
    let mut cell = Picture::filled(pictures.width, top + pictures.height, LABEL_BACKGROUND);
    for (line, text) in text.iter().enumerate() {
        cell.label(line * LINE_PIXELS, text);
    }
    cell.paste(pictures, 0, top);
    cell
}
