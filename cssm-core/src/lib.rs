//! Light cases, facets and plans: the mathematics of shadow maps, in f64.

pub mod case;
pub mod facet;
pub mod light;
pub mod plan;
pub mod schema;
pub mod table;
pub mod technique;
pub mod view;

pub use case::LightCase;
pub use glam;
pub use light::Light;
pub use plan::{BoundingBox, PlanError, SceneBounds, ShadowPlan, plan};
pub use view::View;
