//! Light cases, facets and plans: the mathematics of shadow maps, in f64.
//!
//! A [`LightCase`] is declared once. Each frame, [`plan()`] turns it, a [`View`] and a [`Light`] into a [`ShadowPlan`]:
//! a list of [facets](facet) and the walk that leads every visible point to exactly one of them. The
//! [`table`] module rounds a plan into the bytes that generated shaders read.
//!
//! ```
//! use cssm_core::glam::DVec3;
//! use cssm_core::{Light, LightCase, SceneBounds, View, plan};
//!
//! let sun = LightCase::builder("Sun").bands(8, 100_000.0).map_size_texels(2048, 2048).build().unwrap();
//! let (eye, target) = (DVec3::new(0.0, 1.7, 0.0), DVec3::new(0.0, 1.5, -10.0));
//! let view = View::perspective(eye, target, DVec3::Y, 1.0, 0.1, f64::INFINITY, (1920, 1080))?;
//! let light = Light::directional_travelling(DVec3::new(-0.4, -0.8, 0.3))?;
//! let plan = plan(&sun, &view, &light, &SceneBounds::default())?;
//! assert!(plan.facets.iter().all(|facet| facet.tile.width > 0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Main choices
//!
//! * **One idea, the facet.** Techniques differ only in which facets they list; see [`facet`].
//! * **Homogeneous throughout.** A directional light is a point with w = 0, an infinite far plane is four vertices
//!   with w = 0; neither is a special case.
//! * **Relative to the eye, in f64, rounded once.** Absolute world positions appear in [`View::eye_world`] alone.
//! * **Total.** A plan or a typed reason; no input panics.
//! * **The same everywhere.** Transcendental functions come from `libm`, so plans and snapshots agree on any platform.
//! * **Judged.** [`twin`] captures and resolves in f64 what shaders do in f32; [`footprint`] says what a plan is worth.
//!
//! # What it refuses to know
//!
//! Graphics interfaces, shader languages, syntax, files, time and randomness.

pub mod case;
pub mod choose;
mod depth;
pub mod distribution;
pub mod facet;
pub mod fit;
pub mod focus;
pub mod footprint;
pub mod ground;
pub mod homography;
pub mod layout;
pub mod light;
pub mod plan;
pub mod polygon;
pub mod receivers;
pub mod remap;
pub mod samples;
pub mod schema;
pub mod stretch;
pub mod table;
pub mod technique;
pub mod twin;
pub mod view;

pub use case::LightCase;
pub use choose::Chooser;
pub use fit::Seen;
pub use glam;
pub use light::Light;
pub use plan::{
    BoundingBox, MapRegion, PlanError, PlanRequest, Planner, SceneBounds, ShadowPlan, ViewMargin, plan,
};
pub use view::View;
