//! What a run found, as JSON.

use cssm_core::{Light, footprint};
use serde::Serialize;

use crate::gpu::ResolveMethod;
pub use crate::report_files::{create_folder, write_json};
use crate::score::Score;
use crate::score::statistics::Percentiles;
use crate::stage::{Attempt, Outcome};
use crate::timing::Timing;

/// One case on one view.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Report {
    /// Name of the case.
    pub case: String,
    /// Its technique.
    pub technique: &'static str,
    /// The configuration that the plan chose.
    pub configuration: &'static str,
    /// Why it was chosen.
    pub choice: String,
    /// The scene.
    pub scene: String,
    /// Triangles of the scene, instances counted.
    pub scene_triangles: u64,
    /// The view.
    pub view: ViewReport,
    /// The interface that resolved.
    pub resolve: &'static str,
    /// Facets of the plan.
    pub facets: u64,
    /// The map.
    pub map: MapReport,
    /// Texel footprint across the light over the visible pixels, in pixels.
    pub footprint: Percentiles,
    /// Geometric mean of its axes.
    pub geometric_footprint: Percentiles,
    /// Texel footprint on the light-facing visible surfaces, in pixels.
    pub surface_footprint: Percentiles,
    /// How much of the map is used.
    pub utilisation: Utilisation,
    /// Leak, acne, edges, seams.
    pub score: Score,
    /// Draw calls of the capture.
    pub draws: u64,
    /// Instances drawn by the capture, all facets together.
    pub instances_submitted: u64,
    /// Triangles drawn by the capture, all facets together.
    pub triangles_submitted: u64,
    /// The same for each facet.
    pub facet_statistics: Vec<FacetReport>,
    /// Median time of planning, microseconds.
    pub plan_microseconds: f64,
    /// Time of generating shaders and tables, milliseconds.
    pub generate_milliseconds: f64,
    /// Times of the passes.
    pub time: Option<Timing>,
    /// The adapter.
    pub adapter: String,
}

/// The view and the light of a report.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ViewReport {
    /// Eye in world space, metres.
    pub eye: [f64; 3],
    /// Direction of the view, world axes.
    pub direction: [f64; 3],
    /// Vertical field of view in degrees.
    pub fov_y_degrees: f64,
    /// Near plane, metres.
    pub near: f64,
    /// Far plane, metres; absent at infinity.
    pub far: Option<f64>,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// The light.
    pub light: LightReport,
}

/// The light of a report, world axes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LightReport {
    /// Its kind.
    pub kind: &'static str,
    /// Direction in which it travels; absent for an omni light.
    pub travels: Option<[f64; 3]>,
    /// Where it stands, metres; absent for a directional light.
    pub position: Option<[f64; 3]>,
    /// Angle between axis and edge of a spot light's cone.
    pub half_angle_degrees: Option<f64>,
    /// Distance to which it reaches, metres; absent without a limit.
    pub range: Option<f64>,
}

impl LightReport {
    /// What a report says of a light.
    pub fn of(light: &Light) -> Self {
        let kind = light.kind().name();
        let none = Self { kind, travels: None, position: None, half_angle_degrees: None, range: None };
        let finite = |range: f64| Some(range).filter(|range| range.is_finite());
        match *light {
            Light::Directional { toward_light_world } => {
                Self { travels: Some((-toward_light_world).to_array()), ..none }
            }
            Light::Omni { position_world, range_metres } => {
                Self { position: Some(position_world.to_array()), range: finite(range_metres), ..none }
            }
            Light::Spot { position_world, direction_world, half_angle_radians, range_metres } => Self {
                travels: Some(direction_world.to_array()),
                position: Some(position_world.to_array()),
                half_angle_degrees: Some(half_angle_radians.to_degrees()),
                range: finite(range_metres),
                ..none
            },
        }
    }
}

/// The map of a report.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MapReport {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Number of texels.
    pub texels: u64,
    /// Bytes.
    pub bytes: u64,
}

/// Shares of the map's texels.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Utilisation {
    /// Read by at least one visible pixel.
    pub scene: f64,
    /// Their beam meets the visible volume.
    pub beam: f64,
}

/// Counts of one facet.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FacetReport {
    /// Its index.
    pub facet: u32,
    /// Draw calls.
    pub draws: u64,
    /// Instances.
    pub instances: u64,
    /// Triangles.
    pub triangles: u64,
}

impl Report {
    /// Gathers what an attempt found.
    pub fn new(attempt: &Attempt<'_>, outcome: &Outcome, time: Option<Timing>) -> Self {
        let (stage, plan, statistics) = (attempt.stage(), &attempt.plan, attempt.statistics());
        let view = &stage.view;
        let texels = u64::from(plan.map_size_texels.0) * u64::from(plan.map_size_texels.1);
        let field = 2.0 * libm::atan(0.5 * (view.top - view.bottom));
        Self {
            case: attempt.case.name.clone(),
            technique: attempt.case.technique.name,
            configuration: plan.configuration,
            choice: plan.choice.to_string(),
            scene: stage.scene.name.clone(),
            scene_triangles: stage.scene.triangles() as u64,
            view: ViewReport {
                eye: view.eye_world.to_array(),
                direction: (-view.camera_from_world.row(2)).to_array(),
                fov_y_degrees: field.to_degrees(),
                near: view.near_metres,
                far: Some(view.far_metres).filter(|far| far.is_finite()),
                size: view.size_pixels,
                light: LightReport::of(&stage.light),
            },
            resolve: match attempt.method {
                ResolveMethod::Function => "function",
                ResolveMethod::Mask => "mask",
            },
            facets: plan.facets.len() as u64,
            map: MapReport {
                width: plan.map_size_texels.0,
                height: plan.map_size_texels.1,
                texels,
                bytes: texels * u64::from(attempt.case.map.format.bytes_per_texel()),
            },
            footprint: outcome.footprint.volume,
            geometric_footprint: outcome.footprint.geometric,
            surface_footprint: outcome.footprint.surface,
            utilisation: Utilisation {
                scene: outcome.assignment.scene_utilisation,
                beam: footprint::beam_utilisation(plan),
            },
            score: outcome.score.clone(),
            draws: u64::from(statistics.draws),
            instances_submitted: statistics.instances,
            triangles_submitted: statistics.triangles,
            facet_statistics: statistics
                .facets
                .iter()
                .map(|facet| FacetReport {
                    facet: facet.facet,
                    draws: u64::from(facet.draws),
                    instances: facet.instances,
                    triangles: facet.triangles,
                })
                .collect(),
            plan_microseconds: attempt.plan_microseconds,
            generate_milliseconds: attempt.generate_milliseconds,
            time,
            adapter: stage.gpu().adapter(),
        }
    }
}
