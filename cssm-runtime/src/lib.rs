//! The shadow service: executes generated tables on wgpu.
//!
//! A light case is declared once; code generation turns it into a [`CaseTable`](cssm_core::table::CaseTable) with
//! shaders. Each frame, [`cssm_core::plan()`] turns the view and the light into a
//! [`ShadowPlan`](cssm_core::ShadowPlan): a list of facets. [`ShadowService`] executes both:
//!
//! 1. [`features_and_limits`] says what to request a device with;
//! 2. [`ShadowService::new`] builds the map and the pipelines;
//! 3. [`ShadowService::add_mesh`] registers geometry in the engine's own buffers and vertex format;
//! 4. [`ShadowService::prepare`] culls casters for every facet and uploads one view of one frame;
//! 5. [`ShadowService::capture`] records one render pass that draws all facets into the one map;
//! 6. [`ShadowService::mask`] records a screen-space pass that writes visibility, or the engine's own material calls
//!    the generated function with [`PreparedFrame::shadow_bind_group`].
//!
//! ```no_run
//! use cssm_runtime::cssm_core::{Light, SceneBounds, View, case::LightCase, plan, table::CaseTable};
//! use cssm_runtime::{CasterInstance, MaskInputs, Options, ServiceError, ShadowService, wgpu};
//!
//! # fn lookup() -> (wgpu::Device, wgpu::Queue, wgpu::TextureView, wgpu::TextureView) { unimplemented!() }
//! # fn run(case: &LightCase, table: &CaseTable, view: View, light: Light, casters: &[CasterInstance])
//! #     -> Result<(), Box<dyn std::error::Error>> {
//! # let (device, queue, depth, mask) = lookup();
//! let mut service = ShadowService::new(&device, &queue, table, &Options::default())?;
//!
//! // Each frame:
//! let plan = plan(case, &view, &light, &SceneBounds::default())?;
//! let frame = service.prepare(&plan, &view, casters)?;
//! let mut encoder = device.create_command_encoder(&Default::default());
//! service.capture(&mut encoder, &frame, None)?;
//! service.mask(&mut encoder, &frame, &MaskInputs { depth: &depth, normal: None }, &mask, None)?;
//! queue.submit([encoder.finish()]);
//! println!("{} triangles", frame.statistics().triangles);
//!
//! // After a loss:
//! if service.device_lost() {
//!     let (device, queue, ..) = lookup();
//!     service.rebuild(&device, &queue)?;
//! }
//! # Ok(())
//! # }
//! ```
//!
//! # Main choices
//!
//! * **It executes, it does not know.** No line asks which technique made a facet, which filter or bias a case
//!   declares: the table lists records, bindings and passes, and the service follows the list. Tables written by hand
//!   work as well; no generator is linked.
//! * **One pass, one map.** All facets are drawn in one render pass; viewport and scissor confine each to its tile,
//!   a dynamic offset picks its record. Each facet draws only the casters whose shadows can reach something visible
//!   in it, one draw for each mesh. Of a large mesh with [`Cluster`]s it draws the ranges that can.
//! * **The engine's own vertex functions capture too.** [`ShadowService::capture_with`] sets tile and record of every facet
//!   and hands the pass to the engine, whose pipelines run shaders that code generation has composed around its skinning,
//!   instancing or displacement.
//! * **Casters stay where they are.** Meshes are ranges of the engine's buffers in the engine's vertex format, alpha
//!   masks are the engine's own textures. The eye is subtracted from every transform and the axes are turned to the
//!   camera's in f64, so nothing is lost far from the world's origin or in a narrow field of view.
//! * **Culling runs where the engine wants it.** [`Options::culling`] leaves instances and clusters to compute passes, which
//!   compact rows and write indirect draws ([`Culling::Gpu`]); the CPU does the same where a device cannot. Its lists are
//!   built from a [`CasterScene`] that all plans share, without allocating.
//! * **Bent rows are exact where a case asks for it.** Triangles whose straight edges would miss the bent ones by more than
//!   the declared bound are decided texel by texel; the others are rasterised as ever. Which is which takes all three
//!   corners, so shaders fetch vertices from the engine's buffers ([`wgpu::BufferUsages::STORAGE`]), and what a box proves
//!   to be straight enough is not looked at twice ([`Drawing`]).
//! * **Positions and normals come in the case's axes.** The generated function and the mask take them relative to the
//!   eye in camera axes (x right, y up, looking along -z): `camera_from_world * (point_world - eye_world)`. Cases
//!   that declare `axes: world` take them in world axes.
//! * **Depth in front of a facet is flattened, not clipped.** With [`wgpu::Features::DEPTH_CLIP_CONTROL`] the
//!   rasteriser does it, otherwise a fragment shader. Where facets share a tile, [`wgpu::Features::CLIP_DISTANCES`]
//!   or that fragment shader keeps their casters apart. All ways draw the same map.
//! * **Plans choose the order of depth.** Reversed plans run with pipelines, clear value and sampler of their own;
//!   [`PreparedFrame::shadow_bind_group`] holds the right one.
//! * **Frames do not alias.** Each [`PreparedFrame`] has buffers of its own, which return to a pool once the GPU has
//!   finished with every encoder that replayed it. Several views may share a submission.
//! * **Commands are data.** [`FrameCommands`] is a plain list with typed handles, built and tested without a device.
//! * **The device belongs to the engine.** No device-wide callback is ever set: creation runs under error scopes of
//!   its own, and a device loss is told by a private mapping ([`ShadowService::device_lost`]).
//!
//! # What it refuses to do
//!
//! It owns no window, scene or frame graph, records only where it is told to, never waits (except in [`read_back`]),
//! and does not panic: input that makes no sense is a [`ServiceError`] that says what to change, and what was built
//! or prepared before stays usable.

mod alpha_mask;
mod atlas;
mod bindings;
mod capture;
mod casters;
mod clusters;
mod commands;
mod cull;
mod culling;
mod depth_order;
mod error;
mod fit;
mod frame;
mod gpu;
mod health;
mod layout;
pub mod lights;
mod mesh;
mod overlay;
mod prefilter;
pub mod read_back;
mod requirements;
mod resolve;
mod scope;
mod service;
mod upload;

pub use alpha_mask::AlphaMask;
pub use capture::{CasterPipelineDescription, CasterPipelines, EngineFacet};
pub use casters::CasterScene;
pub use clusters::{CLUSTER_TRIANGLES, Cluster, ClusterError, ClusteredTriangles, cluster_triangles};
pub use commands::{
    Command, CommandScratch, Drawing, FacetHandle, FacetStatistics, FrameCommands, FrameStatistics,
    MeshFacts, PipelineHandle,
};
pub use cssm_core;
pub use cull::InstanceRows;
pub use culling::{Culling, culling_requirements};
pub use error::ServiceError;
pub use fit::{DepthReduction, depth_reduction_requirements};
pub use frame::PreparedFrame;
pub use lights::{LightService, PreparedLights};
pub use mesh::{CasterInstance, IndexDescription, MeshDescription, MeshError, MeshHandle};
pub use overlay::{Overlay, OverlayLook, OverlayTile, facet_colour};
pub use requirements::{Requirements, features_and_limits};
pub use resolve::MaskInputs;
pub use service::{Options, ShadowService};
pub use wgpu;
