//! Cross-crate tests by intent.

pub mod gpu;
