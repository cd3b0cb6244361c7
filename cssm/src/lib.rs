//! Shadow maps from declared light cases: the crate users add.
