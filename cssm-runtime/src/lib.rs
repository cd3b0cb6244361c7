//! The shadow service: executes generated tables on wgpu.
