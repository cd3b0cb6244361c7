//! The `shaders-gen` command; everything it does is in the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    shaders_gen::main(std::env::args_os(), &mut std::io::stdout().lock(), &mut std::io::stderr().lock())
}
