//! Scenes, ray-cast truth, scores and pictures for shadow maps.

pub mod scene;
pub mod truth;
