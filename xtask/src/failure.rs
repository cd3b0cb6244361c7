//! Why a command stops.

use std::fmt;
use std::io;
use std::path::PathBuf;

/// Why a command stops; the text says what to do.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A program cannot be started.
    Start {
        /// The program.
        program: String,
        /// What the system says.
        source: io::Error,
    },
    /// A step's program reports failure.
    Step {
        /// The step.
        title: String,
    },
    /// A file or folder cannot be read or written.
    File {
        /// The path.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The machine lacks something; the text names it and the command that gets it.
    Setup(String),
    /// Snapshots wait for review.
    Snapshots(Vec<PathBuf>),
    /// Generated files differ from what the generator writes now.
    Stale(Vec<String>),
}

impl fmt::Display for Failure {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start { program, source } => {
                write!(out, "cannot start `{program}`: {source}; is it installed?")
            }
            Self::Step { title } => write!(out, "{title} failed; its own messages are above"),
            Self::File { path, source } => write!(out, "{}: {source}", path.display()),
            Self::Setup(text) => out.write_str(text),
            Self::Snapshots(paths) => {
                writeln!(
                    out,
                    "these snapshots wait for review; accept them with `cargo insta review`, or delete them"
                )?;
                paths.iter().try_for_each(|path| writeln!(out, "    {}", path.display()))
            }
            Self::Stale(names) => {
                writeln!(
                    out,
                    "these generated files are not up to date; repair them with `cargo xtask gen`"
                )?;
                names.iter().try_for_each(|name| writeln!(out, "    {name}"))
            }
        }
    }
}

impl std::error::Error for Failure {}

/// Names the path in an input or output error.
pub(crate) fn at(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Failure {
    let path = path.into();
    move |source| Failure::File { path, source }
}
