//! What shadows cost, as ratios inside one run.
//!
//! The workload is that of the camera space paper: 10,624 triangles of palm, an image of 640 x 640 pixels, maps of 320 to
//! 5120 texels a side. A frame is the view's own passes ([`view_passes`]) with a case's capture and mask between them
//! ([`contender`]). All contenders of a map size run in turns ([`run`]), so that whatever disturbs one disturbs all, and every
//! ratio is taken between neighbours of the same turn. [`report`] prints the paper's tables with ours, [`paper`] holds its
//! numbers, [`cpu`] is the work of a frame that needs no device.

pub mod contender;
pub mod cpu;
pub mod error;
pub mod paper;
pub mod report;
pub mod run;
pub mod situation;
pub mod view_passes;
