//! The `cssm-lab` program; everything it does is in the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    cssm_lab::command_line::run()
}
