//! The shader library: one file for each alternative of each slot, and which of them a case takes.

mod capture;
mod filter;
mod join;
mod list;
mod remap;
mod resolve;

use std::borrow::Cow;

use cssm_core::case::{LightCase, MaskDepth, Resolve};
use cssm_core::table::{CaseTable, ShaderKind};

pub(crate) use capture::caster_entry;
pub(crate) use list::LIBRARY;

/// The files that a shader of a case is made of, leaves first, and the declarations that it is for.
pub(crate) fn pick(
    case: &LightCase,
    table: &CaseTable,
    shader: ShaderKind,
) -> (Vec<LibraryFile>, &'static [&'static str]) {
    let (names, roots): (_, &[_]) = match shader {
        ShaderKind::Capture => (capture::files(table, shader), &["capture_vertex"]),
        ShaderKind::CaptureClamped => {
            (capture::files(table, shader), &["capture_clamped_vertex", "capture_clamped_fragment"])
        }
        ShaderKind::CaptureTested => {
            (capture::files(table, shader), &["capture_tested_vertex", "capture_tested_fragment"])
        }
        ShaderKind::CaptureTestedClamped => (
            capture::files(table, shader),
            &["capture_tested_clamped_vertex", "capture_tested_clamped_fragment"],
        ),
        ShaderKind::CaptureBent => {
            (capture::files(table, shader), &["capture_bent_vertex", "capture_bent_fragment"])
        }
        ShaderKind::CaptureBentTested => {
            (capture::files(table, shader), &["capture_bent_tested_vertex", "capture_bent_tested_fragment"])
        }
        ShaderKind::PrefilterRows => {
            (filter::prefilter(case, table, shader), &["prefilter_rows_vertex", "prefilter_rows_fragment"])
        }
        ShaderKind::PrefilterColumns => (
            filter::prefilter(case, table, shader),
            &["prefilter_columns_vertex", "prefilter_columns_fragment"],
        ),
        ShaderKind::Mask => {
            let mut files = visibility(case, table);
            files.extend(in_order(&resolve::mask(case)));
            return (files, &["mask_vertex", "mask_fragment"]);
        }
        ShaderKind::Function => return (visibility(case, table), &["visibility"]),
        ShaderKind::Fit => (fit(case), &["fit_measure"]),
    };
    (in_order(&names), roots)
}

/// A file of the library, or the text that joins what was picked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct LibraryFile {
    /// File name without folder and extension.
    pub(crate) name: &'static str,
    /// Its text.
    pub(crate) source: Cow<'static, str>,
}

/// Files by their names, in the order of the library.
fn in_order(names: &[&str]) -> Vec<LibraryFile> {
    LIBRARY.iter().filter(|file| names.contains(&file.name)).cloned().collect()
}

/// The visibility function of a case, behind the files that it calls.
fn visibility(case: &LightCase, table: &CaseTable) -> Vec<LibraryFile> {
    let mut files = in_order(&resolve::files(case, table));
    files.push(LibraryFile { name: "visibility", source: join::visibility(case, table).into() });
    files
}

/// The file that tells which way depths compare.
fn order(table: &CaseTable) -> &'static str {
    if table.may_reverse_depth { "order_chosen" } else { "order_fixed" }
}

/// Files of the reduction of depth.
fn fit(case: &LightCase) -> Vec<&'static str> {
    let linear = case
        .resolve
        .iter()
        .any(|interface| matches!(interface, Resolve::Mask { depth: MaskDepth::Linear, .. }));
    vec![if linear { "fit_linear" } else { "fit_reversed_z" }, "fit_bin", "fit"]
}

#[cfg(test)]
mod tests;
