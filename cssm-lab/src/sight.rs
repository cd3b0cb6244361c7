//! A sight: one view of a scene under one light, traced once, and the judge of every map on it.

use std::sync::OnceLock;

use cssm_core::case::Filter;
use cssm_core::fit::DepthHistogram;
use cssm_core::plan::plan_seen;
use cssm_core::{BoundingBox, Light, LightCase, PlanError, SceneBounds, Seen, ShadowPlan, View};

use crate::error::LabError;
use crate::progress::Progress;
use crate::scene::Scene;
use crate::score::footprints::{Assignment, FrameFootprint};
use crate::score::{FineEdges, Judged, Score, TrueEdges, Verdict, score};
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
    /// Boxes around blocks of visible pixels, for techniques that fit their map to what is visible.
    pub visible_world: Vec<BoundingBox>,
    /// Measured depth, told as an engine knows it that reads it back without waiting: as of an earlier frame.
    pub depth: DepthHistogram,
    /// The truth.
    pub frame: Frame,
    /// True edges finer than pixels, if they were asked for.
    pub fine: Option<FineEdges>,
    /// Edges of the frame, found when the first map is judged.
    pub(crate) true_edges: OnceLock<TrueEdges>,
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
        Ok(Self { fine, ..Self::of_frame(scene, view, light, frame) })
    }

    /// The sight of a frame that is known already, without finer edges.
    pub fn of_frame(scene: &'a Scene, view: View, light: Light, frame: Frame) -> Self {
        let bounds = SceneBounds::of(scene.bounds_world());
        let visible_world = visible_world(&view, &frame);
        let depth = DepthHistogram { latency_frames: 1, ..measured(&view, &frame) };
        Self {
            scene,
            view,
            light,
            bounds,
            visible_world,
            depth,
            frame,
            fine: None,
            true_edges: OnceLock::new(),
        }
    }

    /// The plan of a case, told everything that is known of the sight.
    ///
    /// # Errors
    /// What planning says.
    pub fn plan(&self, case: &LightCase) -> Result<ShadowPlan, PlanError> {
        let seen = Seen { depth: Some(&self.depth), ..Seen::volumes(&self.visible_world) };
        plan_seen(case, &self.view, &self.light, &self.bounds, &seen)
    }

    /// Judges the visibility that a plan's map gives the pixels.
    pub fn judge(&self, plan: &ShadowPlan, filter: Filter, visibility: Vec<f32>) -> Outcome {
        let assignment = Assignment::new(plan, &self.view, &self.frame, filter);
        let (score, verdicts) = score(&Judged {
            frame: &self.frame,
            visibility: &visibility,
            footprints: &assignment.footprints,
            facets: &assignment.facets,
            true_edges: self.true_edges.get_or_init(|| TrueEdges::of(&self.frame, self.fine.as_ref())),
        });
        let footprint = assignment.frame_footprint(&self.frame);
        Outcome { visibility, assignment, footprint, score, verdicts }
    }
}

/// The depths of a frame's pixels.
pub fn measured(view: &View, frame: &Frame) -> DepthHistogram {
    let depth = |pixel: &Option<crate::truth::Visible>| {
        pixel.as_ref().map_or(0.0, |pixel| view.depth_metres(pixel.position) as f32)
    };
    DepthHistogram::measure(view, frame.pixels.iter().map(depth))
}

/// Side of a block of pixels.
const BLOCK_PIXELS: usize = 32;

/// World-space boxes around what blocks of pixels see.
fn visible_world(view: &View, frame: &Frame) -> Vec<BoundingBox> {
    let (width, height) = (view.size_pixels.0 as usize, view.size_pixels.1 as usize);
    let (across, down) = (width.div_ceil(BLOCK_PIXELS), height.div_ceil(BLOCK_PIXELS));
    let mut boxes: Vec<Option<BoundingBox>> = vec![None; across * down];
    for (index, pixel) in frame.pixels.iter().enumerate() {
        let Some(pixel) = pixel else { continue };
        let place = view.eye_world + pixel.position;
        let block = (index / width / BLOCK_PIXELS) * across + (index % width) / BLOCK_PIXELS;
        let around = boxes[block].get_or_insert(BoundingBox { min: place, max: place });
        *around = BoundingBox { min: around.min.min(place), max: around.max.max(place) };
    }
    boxes.into_iter().flatten().collect()
}
