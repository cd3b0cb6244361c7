//! The shadow service.
mod atlas;
mod capture;
mod commands;
mod cull;
mod error;
mod frame;
mod health;
mod layout;
mod mesh;
pub mod read_back;
mod requirements;
mod resolve;
mod scope;
mod service;
mod upload;

pub use commands::{
    Command, FacetHandle, FacetStatistics, FrameCommands, FrameStatistics, MeshFacts, PipelineHandle,
};
pub use cssm_core;
pub use cull::InstanceRows;
pub use error::ServiceError;
pub use frame::PreparedFrame;
pub use mesh::{CasterInstance, IndexDescription, MeshDescription, MeshError, MeshHandle};
pub use requirements::{Requirements, features_and_limits};
pub use resolve::MaskInputs;
pub use service::{Options, ShadowService};
pub use wgpu;
