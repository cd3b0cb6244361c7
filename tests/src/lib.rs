//! Cross-crate tests by intent.

pub mod generated;
pub mod gpu;
pub mod random;
pub mod touch;
