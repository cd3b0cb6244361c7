//! One file for each target that a case is emitted as.

pub(crate) mod explain;
pub(crate) mod files;
pub(crate) mod json;
pub(crate) mod rust;
