//! The build script's door.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use cssm_core::LightCase;

use crate::dsl::{self, Report};
use crate::{CasterEntry, CasterError, GenerateError, Options, WriteError, generate_all, write_file};

/// Compiles declarations in a build script.
///
/// ```no_run
/// # fn main() -> Result<(), cssm_codegen::BuildError> {
/// cssm_codegen::Build::new().file("shadows.cssm").compile()?;
/// # Ok(())
/// # }
/// ```
///
/// The crate then includes the modules: `include!(concat!(env!("OUT_DIR"), "/shadows.rs"));`
#[derive(Debug, Clone, Default)]
pub struct Build {
    files: Vec<PathBuf>,
    casters: Vec<CasterFiles>,
    out_dir: Option<PathBuf>,
    options: Options,
}

/// A caster entry of a case, and the files that it is composed of.
#[derive(Debug, Clone)]
struct CasterFiles {
    case: String,
    paths: Vec<PathBuf>,
    entry: CasterEntry,
}

/// Why declarations do not compile. Its debug form is the report itself, because that is what a failing build script
/// prints.
#[derive(thiserror::Error)]
pub enum BuildError {
    /// A declaration file or a shader file cannot be read.
    #[error("cannot read {}: {source}; paths are relative to the package's folder", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A declaration file is at fault.
    #[error("{0}")]
    Declaration(Box<Report>),
    /// The cases do not generate.
    #[error(transparent)]
    Generate(#[from] GenerateError),
    /// Two declaration files would write the same output.
    #[error("{} and another file would both write {output}; rename one of them", path.display())]
    SameOutput {
        /// The file.
        path: PathBuf,
        /// The output's name.
        output: String,
    },
    /// A caster entry names a case that no file declares.
    #[error(
        "caster entry `{entry}` belongs to case `{case}`, which no file declares; add its file, or name one of {known}"
    )]
    UnknownCase {
        /// The entry.
        entry: String,
        /// The case that it names.
        case: String,
        /// The cases that there are.
        known: String,
    },
    /// A caster entry does not compose.
    #[error(transparent)]
    Casters(#[from] CasterError),
    /// There is no folder to write to.
    #[error("OUT_DIR is not set; run this in a build script or call out_dir")]
    NoOutDir,
    /// An output cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

impl fmt::Debug for BuildError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{self}")
    }
}

impl Build {
    /// A build of no files yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a declaration file.
    pub fn file(mut self, path: impl AsRef<Path>) -> Self {
        self.files.push(path.as_ref().to_owned());
        self
    }

    /// Adds a caster entry of a case: capture shaders around the engine's own vertex function, composed of the case and of
    /// WGSL files. It becomes a file `PREFIX_ENTRY.rs` beside the case's, with a module of that name.
    ///
    /// ```no_run
    /// # fn main() -> Result<(), cssm_codegen::BuildError> {
    /// use cssm_codegen::{Build, CasterEntry};
    ///
    /// let skinned = CasterEntry::new("skinned", "skinned_position");
    /// Build::new().file("shadows.cssm").caster("Sun", ["src/skinned.wgsl"], skinned).compile()?;
    /// # Ok(())
    /// # }
    /// ```
    pub fn caster<P: AsRef<Path>>(
        mut self,
        case: &str,
        paths: impl IntoIterator<Item = P>,
        entry: CasterEntry,
    ) -> Self {
        let paths = paths.into_iter().map(|path| path.as_ref().to_owned()).collect();
        self.casters.push(CasterFiles { case: case.to_owned(), paths, entry });
        self
    }

    /// Writes there instead of cargo's `OUT_DIR`.
    pub fn out_dir(mut self, path: impl AsRef<Path>) -> Self {
        self.out_dir = Some(path.as_ref().to_owned());
        self
    }

    /// Path of the façade crate in the generated Rust, for crates that re-export it.
    pub fn crate_path(mut self, path: &str) -> Self {
        self.options.crate_path = path.to_owned();
        self
    }

    /// Writes one Rust file for each declaration file and returns their paths: `shadows.cssm` becomes `shadows.rs`
    /// with one module for each case; files of caster entries follow. Tells cargo to run again when a declaration file changes.
    ///
    /// # Errors
    /// A [`BuildError`]; reports name the file, the line and what to write instead.
    pub fn compile(&self) -> Result<Vec<PathBuf>, BuildError> {
        // Tell cargo first, so that a build that fails here runs again when the file is mended.
        for path in self.files.iter().chain(self.casters.iter().flat_map(|casters| &casters.paths)) {
            println!("cargo:rerun-if-changed={}", path.display());
        }
        let out_dir = self.out_dir.clone().or_else(|| std::env::var_os("OUT_DIR").map(PathBuf::from));
        let out_dir = out_dir.ok_or(BuildError::NoOutDir)?;

        // Read every file before any is written: prefixes must differ across files.
        let mut cases = Vec::new();
        let mut outputs: Vec<(String, usize)> = Vec::new();
        for path in &self.files {
            let read = read_cases(path)?;
            let output = format!("{}.rs", path.file_stem().unwrap_or_default().to_string_lossy());
            if outputs.iter().any(|(earlier, _)| *earlier == output) {
                return Err(BuildError::SameOutput { path: path.clone(), output });
            }
            outputs.push((output, read.len()));
            cases.extend(read);
        }
        let mut generated = generate_all(&cases, &self.options)?.into_iter();
        let mut modules = Vec::new();
        for casters in &self.casters {
            let module = self.caster_module(casters, &cases)?;
            let taken =
                outputs.iter().map(|(output, _)| output).chain(modules.iter().map(|(output, _)| output));
            if let Some(output) = taken.into_iter().find(|output| **output == module.0) {
                let path = casters.paths.first().cloned().unwrap_or_default();
                return Err(BuildError::SameOutput { path, output: output.clone() });
            }
            modules.push(module);
        }

        // Write one file for each declaration file.
        let mut written = Vec::new();
        for (output, count) in outputs {
            let modules: Vec<_> = generated.by_ref().take(count).map(|case| case.rust).collect();
            let path = out_dir.join(output);
            write_file(&path, modules.join("\n").as_bytes())?;
            written.push(path);
        }
        for (output, text) in modules {
            let path = out_dir.join(output);
            write_file(&path, text.as_bytes())?;
            written.push(path);
        }
        Ok(written)
    }

    /// Name and text of the file of a caster entry.
    fn caster_module(
        &self,
        casters: &CasterFiles,
        cases: &[LightCase],
    ) -> Result<(String, String), BuildError> {
        let mut entry = casters.entry.clone();
        for path in &casters.paths {
            entry = entry.source(&path.display().to_string(), &read_text(path)?);
        }
        let case = cases.iter().find(|case| case.name == casters.case);
        let case = case.ok_or_else(|| BuildError::UnknownCase {
            entry: entry.name().to_owned(),
            case: casters.case.clone(),
            known: cases.iter().map(|case| format!("`{}`", case.name)).collect::<Vec<_>>().join(", "),
        })?;
        let module = entry.rust(case, &self.options)?;
        Ok((format!("{}.rs", module.name), module.text))
    }
}

fn read_cases(path: &Path) -> Result<Vec<LightCase>, BuildError> {
    let text = read_text(path)?;
    dsl::parse_file(&path.display().to_string(), &text)
        .map_err(|report| BuildError::Declaration(Box::new(report)))
}

fn read_text(path: &Path) -> Result<String, BuildError> {
    fs::read_to_string(path).map_err(|source| BuildError::Read { path: path.to_owned(), source })
}
