//! Scenes, ray-cast truth, scores and pictures: how to see what a shadow map does, and how to prove it.
//!
//! The flow: a [`scene::Scene`] is traced in f64 from a view under a light ([`truth::Frame`]); the same pixels are
//! uploaded, so that truth and map speak of exactly the same points ([`stage::Stage`]); a case is planned,
//! generated, captured and resolved there ([`stage::Attempt`]); [`score::score`] judges every pixel; pictures, an
//! OpenEXR frame and a JSON report show it. [`convergence::convergence`] repeats that over map sizes.
//!
//! Choices:
//! * Truth is cast by a bounding volume hierarchy that others keep (the `bvh` crate) and a two-sided triangle test
//!   without epsilon, so thin sheets cast from both sides and nothing is hidden by a tolerance.
//! * Cases run through the very tables, shaders and service that an engine uses; nothing is simulated.
//! * Every score has a test in which a known error is found.
//!
//! The lab knows no technique by name. It refuses to judge what it cannot see: pixels that do not face the light
//! and pixels beside creases are counted, but apart.

pub mod arguments;
pub mod bias;
pub mod case_file;
pub mod catalogue;
pub mod catalogue_sheet;
pub mod command_line;
pub mod contact_sheet;
pub mod convergence;
pub mod creep;
pub mod demo;
pub mod error;
pub mod exr_file;
pub mod extremes;
pub mod figures;
pub mod footprint_command;
pub mod gpu;
pub mod lights;
pub mod measure;
pub mod picture;
pub mod progress;
pub mod render;
pub mod report;
pub mod report_files;
pub mod scene;
pub mod score;
pub mod sight;
pub mod stability;
pub mod stage;
pub mod timing;
pub mod truth;
pub mod tune;
pub mod twin;
