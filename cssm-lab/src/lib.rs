//! Scenes, ray-cast truth, scores and pictures for shadow maps.

pub mod exr_file;
pub mod gpu;
pub mod picture;
pub mod scene;
pub mod score;
pub mod truth;
