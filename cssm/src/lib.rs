//! Shadow maps from declared light cases: the crate that users add.
//!
//! A light case is declared once, in a `.cssm` file, in `light_case!` or with [`LightCase::builder`]. Code generation
//! turns it into WGSL, SPIR-V and a matching table. Each frame [`plan()`] turns a view and a light into facets, and the
//! runtime executes both:
//!
//! ```text
//! declaration ──► generated shaders and table ─┐
//! view, light ──► plan ────────────────────────┴──► runtime: capture, resolve ──► visibility
//! ```
//!
//! This crate holds nothing of its own. It exists so that generated code has one name to build on: a generated module
//! names only `::cssm::core` and `::cssm::bytemuck`, whatever else the crate that includes it depends on.
//!
//! # Features
//!
//! * `macros`: `light_case!`, declarations in Rust source.
//! * `build`: `cssm::build`, declarations compiled by a build script.
//! * `runtime`: `cssm::runtime`, the shadow service on wgpu.
//!
//! Without features it is the mathematics and the tables alone: an engine with a renderer of its own needs no more,
//! and ships no generator.

pub use bytemuck;
pub use cssm_core as core;
pub use cssm_core::{
    BoundingBox, Chooser, Light, LightCase, PlanError, SceneBounds, ShadowPlan, View, case, facet, light,
    plan, table, view,
};

#[cfg(feature = "build")]
pub use cssm_codegen as build;
#[cfg(feature = "macros")]
pub use cssm_macros::light_case;
#[cfg(feature = "runtime")]
pub use cssm_runtime as runtime;
