//! The light_case! macro: a thin door to cssm-codegen.
