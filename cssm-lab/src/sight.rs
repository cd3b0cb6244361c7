//! A sight: one view of a scene under one light, traced once, and the judge of every map on it.

use cssm_core::case::Filter;
use cssm_core::{Light, SceneBounds, ShadowPlan, View};

use crate::error::LabError;
use crate::progress::Progress;
use crate::scene::Scene;
use crate::score::footprints::{Assignment, FrameFootprint};
use crate::score::{FineEdges, Judged, Score, Verdict, score};
use crate::truth::{Frame, Tracer};

/// One view of a scene under one light.
pub struct Sight<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The view.
    pub view: View,
    /// The light.
    pub light: Light,
    /// What planning is told of the scene.
    pub bounds: SceneBounds,
    /// The truth.
    pub frame: Frame,
    /// True edges finer than pixels, if they were asked for.
    pub fine: Option<FineEdges>,
}

/// How a stage is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StageOptions {
    /// Traces true edges with four times four samples a pixel, for surfaces thinner than a pixel.
    pub supersample: bool,
    /// Whether progress is shown.
    pub progress: Progress,
}

/// What a case made of a stage.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// Visibility of each pixel.
    pub visibility: Vec<f32>,
    /// Facets, footprints and use of the map.
    pub assignment: Assignment,
    /// Footprints over the visible pixels.
    pub footprint: FrameFootprint,
    /// The score.
    pub score: Score,
    /// What was found at each pixel.
    pub verdicts: Vec<Option<Verdict>>,
}

impl<'a> Sight<'a> {
    /// Traces the view.
    ///
    /// # Errors
    /// When the view has too many pixels for finer edges.
    pub fn trace(
        scene: &'a Scene,
        tracer: &Tracer,
        view: View,
        light: Light,
        options: StageOptions,
    ) -> Result<Self, LabError> {
        let rows = u64::from(view.size_pixels.1);
        let bar = options.progress.bar(rows, "tracing pixels");
        let frame = Frame::trace(tracer, &view, &light, &|rows| bar.inc(rows));
        bar.finish_and_clear();
        let fine = if options.supersample {
            let bar = options.progress.bar(4 * rows, "tracing 4 x 4 samples a pixel");
            let fine = FineEdges::trace(tracer, &view, &light, &|rows| bar.inc(rows))?;
            bar.finish_and_clear();
            Some(fine)
        } else {
            None
        };
        let bounds = SceneBounds::of(scene.bounds_world());
        Ok(Self { scene, view, light, bounds, frame, fine })
    }

    /// Judges the visibility that a plan's map gives the pixels.
    pub fn judge(&self, plan: &ShadowPlan, filter: Filter, visibility: Vec<f32>) -> Outcome {
        let assignment = Assignment::new(plan, &self.view, &self.frame, filter);
        let (score, verdicts) = score(&Judged {
            frame: &self.frame,
            visibility: &visibility,
            footprints: &assignment.footprints,
            facets: &assignment.facets,
            fine: self.fine.as_ref(),
        });
        let footprint = assignment.frame_footprint(&self.frame);
        Outcome { visibility, assignment, footprint, score, verdicts }
    }
}
