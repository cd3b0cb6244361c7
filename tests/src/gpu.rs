//! What GPU tests share: one device per process, casters, images and hand-made plans.
//!
//! Tests of one file run as threads of one process. They share one Vulkan device and take turns on it: software
//! drivers use every core for one submission, and error scopes belong to threads.

pub mod casters;
pub mod checkered;
pub mod depth_bracket;
pub mod device;
pub mod dueling;
pub mod extremes;
pub mod ground;
pub mod hand;
pub mod images;
pub mod place_probe;
pub mod resolve;
pub mod score;
pub mod stage;
pub mod yard;

pub use casters::Geometry;
pub use device::{TestDevice, exclusive, new_device};
pub use yard::Yard;
