//! Light cases, facets and plans: the mathematics of shadow maps, in f64.

pub mod case;
mod depth;
pub mod facet;
pub mod footprint;
pub mod homography;
pub mod layout;
pub mod light;
pub mod plan;
pub mod polygon;
pub mod receivers;
pub mod samples;
pub mod schema;
pub mod table;
pub mod technique;
pub mod twin;
pub mod view;

pub use case::LightCase;
pub use glam;
pub use light::Light;
pub use plan::{BoundingBox, PlanError, SceneBounds, ShadowPlan, plan};
pub use view::View;
