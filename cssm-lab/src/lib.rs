//! Scenes, ray-cast truth, scores and pictures for shadow maps.
