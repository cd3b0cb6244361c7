//! The `light_case!` macro: a thin door to `cssm-codegen`.
//!
//! It hands its tokens over and returns what is generated; the declaration language, the checks and the generated
//! items are those of `.cssm` files and build scripts. It refuses to do anything of its own, so that all doors give
//! the same bytes. Users reach it as `cssm::light_case!`, behind the feature `macros`.

use proc_macro::TokenStream;

/// Declares light cases and puts their generated shaders and tables where it stands.
///
/// ```text
/// cssm::light_case! {
///     /// Sun over an open world.
///     pub case Sun {
///         technique: camera_space,
///         distribution: bands(8),
///         map: { size: 2048 x 2048 },
///     }
/// }
/// ```
///
/// The input is that of a `.cssm` file, with one or more cases. Every fault is an error at its own place, with the
/// remedy in its text; all faults are reported at once.
#[proc_macro]
pub fn light_case(input: TokenStream) -> TokenStream {
    cssm_codegen::macro_expand(input.into()).into()
}
