//! Cross-crate tests by intent.
