//! Command line of the shader generator: emit, check, explain.
