//! Equal focus: trapezoidal maps against camera space with the same share of rows for the same focus region, view beside
//! map (camera space shadow maps, figures 6 and 8).

use cssm_core::{LightCase, SceneBounds};

use super::cases::{case, variant, with_argument};
use super::{Figure, FigureOptions};
use crate::error::LabError;
use crate::picture::{LABEL_BACKGROUND, Picture, labelled, map_picture_of_size, mean, shaded_picture};
use crate::progress::Progress;
use crate::scene::{Scene, Viewpoint};
use crate::sight::{Sight, StageOptions};
use crate::truth::Tracer;
use crate::twin::{TwinCasters, outcome};

/// Side of images and maps, as in the paper.
const SIDE: u32 = 640;
const QUICK_SIDE: u32 = 160;
/// Side of the pictures that are kept.
const SHOWN: usize = 480;
const GAP: usize = 8;
const FOCUS: f64 = 10.0;
const SHARE: f64 = 0.8;
const DISTANCE: f64 = 200.0;
/// Scenes, and how far the eye of their first view goes towards what it looks at: near shadows show the focus.
const SCENES: [(&str, f64, &str); 2] =
    [("pavilion", 0.5, "equal-focus-pavilion.png"), ("palm", 0.5, "equal-focus-palm.png")];

fn cases() -> Result<Vec<(String, LightCase)>, LabError> {
    let mut declared = Vec::new();
    for (word, name) in [("", "trapezoidal, original"), ("focused", "trapezoidal, focused")] {
        if let Some(variant) = variant("trapezoidal", word) {
            declared.push((name, with_argument(variant, &format!("focus: {FOCUS} m")), String::new()));
        }
    }
    for (stretch, name) in [("none", "one plane"), ("exact", "one plane, stretched")] {
        let rows =
            format!("distribution: perspective {{ focus: {FOCUS} m, share: {SHARE} }}, stretch: {stretch},");
        declared.push((name, "camera_space".into(), format!("configurations: [one_plane], {rows}")));
    }
    let build = |(name, technique, fields): (&str, String, String)| {
        Ok((name.to_owned(), case(&technique, &format!("{fields} filter: none,"), SIDE, DISTANCE)?))
    };
    declared.into_iter().map(build).collect()
}

/// Draws the plates of both scenes.
///
/// # Errors
/// When a scene, a view or a declaration makes no sense.
pub fn figures(options: &FigureOptions) -> Result<Vec<Figure>, LabError> {
    let side = if options.quick { QUICK_SIDE } else { SIDE };
    let mut figures = Vec::new();
    for (name, approach, file) in SCENES {
        let scene = Scene::load(name)?;
        let first = *scene.views.first().ok_or(LabError::NoView)?;
        let eye_world = first.eye_world.lerp(first.target_world, approach);
        let (view, light) = Viewpoint { eye_world, ..first }.pictured((side, side))?;
        let tracer = Tracer::new(&scene);
        let stage = StageOptions { supersample: false, progress: Progress::Hidden };
        // As in the paper: nothing is known of the scene.
        let traced = Sight::trace(&scene, &tracer, view, light, stage)?;
        let sight = Sight { bounds: SceneBounds::default(), ..traced };
        let casters = TwinCasters::new(&scene, view.eye_world);
        let (mut plates, mut texts) = (Vec::new(), Vec::new());
        for (name, case) in cases()? {
            let found = outcome(&sight, &casters, &case)?;
            let view = shaded_picture(&scene, &sight.frame, &found.outcome.visibility, &light);
            let map = map_picture_of_size(&found.plan, &found.depths, (SHOWN, SHOWN));
            let mut plate = Picture::filled(SHOWN, 2 * SHOWN + GAP, LABEL_BACKGROUND);
            plate.paste(&view.shrunk(SHOWN, SHOWN, mean), 0, 0);
            plate.paste(&map, 0, SHOWN + GAP);
            let footprint = &found.outcome.footprint;
            let text = format!(
                "{name}: footprint median {:.2}, p95 {:.1} px; on surfaces {:.2}, {:.1} px; {:.0} % of the map read",
                footprint.volume.median,
                footprint.volume.p95,
                footprint.surface.median,
                footprint.surface.p95,
                100.0 * found.outcome.assignment.scene_utilisation
            );
            texts.push(Picture::lines(&text, SHOWN));
            plates.push(plate);
        }
        let lines = texts.iter().map(Vec::len).max().unwrap_or(0);
        let plates: Vec<Picture> =
            plates.iter().zip(&texts).map(|(plate, text)| labelled(plate, text, lines)).collect();
        let title = format!(
            "{name}, {SIDE} x {SIDE} image and map, {:.0} % of the rows for the first {FOCUS} m, no filter; below: the map",
            100.0 * SHARE
        );
        figures.push(Figure {
            file,
            picture: Picture::beside(&plates).titled(&title),
            shows: "Camera space paper, figures 6 and 8: trapezoidal maps and one plane at equal focus, view above map",
            data: None,
        });
    }
    Ok(figures)
}
