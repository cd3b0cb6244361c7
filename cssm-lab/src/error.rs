//! Everything that can end a command, with the remedy.

use std::path::PathBuf;

use cssm_core::PlanError;
use cssm_core::light::LightError;
use cssm_core::view::ViewError;

use crate::exr_file::ExrError;
use crate::footprint_command::FootprintError;
use crate::gpu::GpuError;
use crate::measure::error::MeasureError;
use crate::measure::paths::PathFileError;
use crate::picture::PictureError;
use crate::scene::SceneFileError;
use crate::tune::error::TuneError;

/// Why a command ended without its result.
#[derive(Debug, thiserror::Error)]
pub enum LabError {
    /// A declaration file cannot be read.
    #[error("cannot read {}: {source}; check the path", path.display())]
    ReadCase {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A declaration file has faults; the text is the whole report.
    #[error("the declarations have faults\n{report}")]
    Declaration {
        /// The rendered report.
        report: String,
    },
    /// A declaration file has no case of a name.
    #[error("{} has no case {name}; it declares {}", path.display(), declared.join(", "))]
    NoSuchCase {
        /// The file.
        path: PathBuf,
        /// What was asked for.
        name: String,
        /// What there is.
        declared: Vec<String>,
    },
    /// A declaration file holds several cases and none was named.
    #[error("{} declares {}; name one: {}:{}", path.display(), declared.join(", "), path.display(), declared[0])]
    SeveralCases {
        /// The file.
        path: PathBuf,
        /// What there is.
        declared: Vec<String>,
    },
    /// A declaration file holds no case.
    #[error("{} declares no case; write one, such as `pub case Sun {{ prefix: sun }}`", path.display())]
    NoCases {
        /// The file.
        path: PathBuf,
    },
    /// The map size is out of range.
    #[error("--map {width}x{height} is out of range; give sides of 64 to {limit} texels")]
    MapSize {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
        /// Largest side.
        limit: u32,
    },
    /// The scene suggests no view.
    #[error("the scene suggests no view; give --eye, --target and --light")]
    NoView,
    /// The scene has too few lamp posts.
    #[error("the scene has {found} lamp posts, but {needed} local lights want one; use the city")]
    NoLamps {
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// The scene has no lamp of that name.
    #[error("scene {scene} has no lamp {name}; it has {}; or give --light", if known.is_empty() { "none".to_owned() } else { known.join(", ") })]
    NoSuchLamp {
        /// The scene.
        scene: String,
        /// What was asked for.
        name: String,
        /// What there is.
        known: Vec<&'static str>,
    },
    /// A built-in declaration is wrong.
    #[error("a built-in declaration is wrong: {errors:?}; report it")]
    Catalogue {
        /// What is wrong.
        errors: Vec<cssm_core::case::CaseError>,
    },
    /// A result file or folder cannot be written.
    #[error("cannot write {}: {source}; check that the folder exists and has space", path.display())]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A chart cannot be drawn.
    #[error("a chart cannot be drawn: {message}; report it")]
    Chart {
        /// What the plotting library said.
        message: String,
    },
    /// No map size could be judged.
    #[error(
        "no map size left at least {wrong_pixels} wrong pixels and {interior_percent} % interior; take another view or a larger image"
    )]
    NothingJudged {
        /// Fewest wrong pixels that are judged.
        wrong_pixels: u64,
        /// Smallest interior that is judged.
        interior_percent: f64,
    },
    /// The scene cannot be read.
    #[error(transparent)]
    Scene(#[from] SceneFileError),
    /// The view makes no sense.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The light makes no sense.
    #[error(transparent)]
    Light(#[from] LightError),
    /// No plan can be made.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The generator is at fault.
    #[error(transparent)]
    Generate(#[from] cssm_codegen::GenerateError),
    /// The device refuses.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// A picture cannot be written.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// A frame cannot be written.
    #[error(transparent)]
    Exr(#[from] ExrError),
    /// Footprints cannot be scored.
    #[error(transparent)]
    Footprint(#[from] FootprintError),
    /// Techniques cannot be measured.
    #[error(transparent)]
    Measure(#[from] MeasureError),
    /// View paths cannot be read.
    #[error(transparent)]
    Paths(#[from] PathFileError),
    /// No declaration was chosen.
    #[error(transparent)]
    Tune(#[from] TuneError),
}
