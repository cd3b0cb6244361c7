//! From a declared light case to specialised WGSL, SPIR-V and matching tables.
