//! Everything that can end a bench, with the remedy.

use std::path::PathBuf;

use cssm_core::PlanError;
use cssm_lab::error::LabError;
use cssm_lab::gpu::GpuError;
use cssm_runtime::ServiceError;

/// Why a bench ended without its result.
#[derive(Debug, thiserror::Error)]
pub enum BenchError {
    /// The lab refused a scene, a view or a declaration.
    #[error(transparent)]
    Lab(#[from] LabError),
    /// The device refused.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The service refused.
    #[error(transparent)]
    Service(#[from] ServiceError),
    /// No plan can be made.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// No shaders can be made.
    #[error(transparent)]
    Generate(#[from] cssm_codegen::GenerateError),
    /// The scene lacks what a bench looks at.
    #[error("scene {scene} has no {what}; choose another one")]
    Missing {
        /// The scene.
        scene: String,
        /// What was looked for.
        what: &'static str,
    },
    /// The report cannot be written.
    #[error("cannot write {}: {source}; check the folder", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
}
