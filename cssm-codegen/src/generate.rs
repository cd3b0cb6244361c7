//! From a case to its table with shaders filled in.

use std::fmt::Write;

use cssm_core::LightCase;
use cssm_core::case::Axes;
use cssm_core::table::{CaseTable, Shader, ShaderKind};

use crate::compose::{self, ComposeError, Prefix};
use crate::judge::{self, JudgeError};
use crate::wgsl::DeclarationKind;
use crate::{library, prelude, spirv};

/// Why a case cannot be generated.
///
/// A checked declaration generates; the first two are faults of the generator itself, reported instead of emitted.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GenerateError {
    /// The library does not compose.
    #[error(
        "the {shader} shader of case `{case}` does not compose: {source}; this is a fault of the shader library, report it with the declaration"
    )]
    Compose {
        /// The case.
        case: String,
        /// The shader.
        shader: &'static str,
        /// What is wrong.
        source: ComposeError,
    },
    /// A composed module is wrong.
    #[error(
        "the {shader} shader of case `{case}` is wrong: {source}; this is a fault of the shader library, report it with the declaration"
    )]
    Judge {
        /// The case.
        case: String,
        /// The shader.
        shader: &'static str,
        /// What is wrong.
        source: JudgeError,
    },
    /// Two cases would write the same files and names.
    #[error(
        "cases `{first}` and `{second}` share the prefix `{prefix}`; give one of them another, such as `prefix: {prefix}_other`"
    )]
    SharedPrefix {
        /// The prefix.
        prefix: String,
        /// The case that has it.
        first: String,
        /// The case that repeats it.
        second: String,
    },
    /// The crate path cannot stand in generated Rust.
    #[error("`{path}` is no path to the cssm crate; write one such as `::cssm` or `crate::shadows::cssm`")]
    CratePath {
        /// The path as given.
        path: String,
    },
    /// The Rust output does not parse.
    #[error(
        "the Rust tables of case `{case}` do not parse: {message}; this is a fault of the generator, report it with the declaration"
    )]
    Rust {
        /// The case.
        case: String,
        /// What is wrong.
        message: String,
    },
}

/// The table of a case with every shader in it.
pub(crate) fn table_with_shaders(case: &LightCase) -> Result<CaseTable, GenerateError> {
    let mut table = CaseTable::describe(case);
    let mut shaders = Vec::new();
    for kind in shader_kinds(&table) {
        shaders.push(shader(case, &table, kind)?);
    }
    table.shaders = shaders.into();
    Ok(table)
}

/// Refuses cases whose names would collide where they stand side by side: in one material, in one folder.
pub(crate) fn check_prefixes(cases: &[LightCase]) -> Result<(), GenerateError> {
    for (index, case) in cases.iter().enumerate() {
        let types = |case: &LightCase| Prefix::new(&case.prefix).apply(DeclarationKind::Type, "");
        if let Some(first) = cases[..index].iter().find(|earlier| types(earlier) == types(case)) {
            return Err(GenerateError::SharedPrefix {
                prefix: case.prefix.clone(),
                first: first.name.clone(),
                second: case.name.clone(),
            });
        }
    }
    Ok(())
}

/// The shaders of a table, each once, in the order of its bind groups.
fn shader_kinds(table: &CaseTable) -> Vec<ShaderKind> {
    let mut kinds: Vec<ShaderKind> = Vec::new();
    for group in table.groups.iter() {
        if !kinds.contains(&group.shader) {
            kinds.push(group.shader);
        }
    }
    kinds
}

fn shader(case: &LightCase, table: &CaseTable, kind: ShaderKind) -> Result<Shader, GenerateError> {
    // Compose the prelude and the picked files.
    let prefix = Prefix::new(&case.prefix);
    let prelude = prelude::prelude(table, kind, &prefix);
    let (files, roots) = library::pick(case, table, kind);
    let sources: Vec<_> =
        std::iter::once(prelude.as_str()).chain(files.iter().map(|file| &*file.source)).collect();
    let body = compose::compose(&sources, roots, &prefix).map_err(|source| GenerateError::Compose {
        case: case.name.clone(),
        shader: kind.name(),
        source,
    })?;
    let wgsl = header(case, table, kind) + prelude::directives(table, kind) + &body;

    // Judge the text that is emitted, and write its words.
    let words = judge::judge(&wgsl, table, kind).and_then(|judged| match kind {
        ShaderKind::Function => Ok(Vec::new()),
        _ => spirv::write(&judged),
    });
    let spirv = words.map_err(|source| GenerateError::Judge {
        case: case.name.clone(),
        shader: kind.name(),
        source,
    })?;
    Ok(Shader { kind, wgsl: wgsl.into(), spirv: spirv.into() })
}

/// What the first lines of a module say: the case, its doc comment, what the module is, where it comes from.
fn header(case: &LightCase, table: &CaseTable, kind: ShaderKind) -> String {
    let what = what_it_is(kind, table.clips > 0);
    let mut text = format!("// {}: {what}\n", case.name);
    let positions = match kind {
        ShaderKind::Mask | ShaderKind::Function => Some(("Positions and normals", axes_summary(table.axes))),
        ShaderKind::PrefilterRows | ShaderKind::PrefilterColumns | ShaderKind::Fit => None,
        _ => Some(("Positions", CAPTURE_AXES)),
    };
    if let Some((of_what, axes)) = positions {
        let _ = writeln!(text, "// {of_what} are relative to the eye, in {axes}.");
    }
    for doc in doc_lines(&case.doc) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", format!("// {doc}").trim_end());
    }
    let _ = writeln!(
        text,
        "// Generated from light case `{}`, {:016x}. Do not edit.\n",
        case.name, table.fingerprint
    );
    text
}

/// What a shader does, in one sentence; `clipped`: facets share tiles.
pub(crate) fn what_it_is(kind: ShaderKind, clipped: bool) -> &'static str {
    match (kind, clipped) {
        (ShaderKind::Capture, false) => {
            "renders casters into one tile of the shadow map; needs unclipped depth."
        }
        (ShaderKind::Capture, true) => {
            "renders casters into one facet of the shadow map; needs unclipped depth and clip distances."
        }
        (ShaderKind::CaptureClamped, false) => {
            "renders casters into one tile of the shadow map; clamps depth by itself."
        }
        (ShaderKind::CaptureClamped, true) => {
            "renders casters into one facet of the shadow map; clamps depth and cuts by itself."
        }
        (ShaderKind::CaptureTested, false) => {
            "renders casters with an alpha mask into one tile of the shadow map; needs unclipped depth."
        }
        (ShaderKind::CaptureTested, true) => {
            "renders casters with an alpha mask into one facet of the shadow map; needs unclipped depth and clip \
             distances."
        }
        (ShaderKind::CaptureTestedClamped, false) => {
            "renders casters with an alpha mask into one tile of the shadow map; clamps depth by itself."
        }
        (ShaderKind::CaptureTestedClamped, true) => {
            "renders casters with an alpha mask into one facet of the shadow map; clamps depth and cuts by itself."
        }
        (ShaderKind::CaptureBent, _) => {
            "decides texel by texel the casters that bent rows bend too far for straight edges."
        }
        (ShaderKind::CaptureBentTested, _) => "decides casters with an alpha mask texel by texel.",
        (ShaderKind::PrefilterRows, _) => {
            "takes from the map's depths what resolving reads, and blurs it along rows."
        }
        (ShaderKind::PrefilterColumns, _) => "blurs along columns what was blurred along rows.",
        (ShaderKind::Mask, _) => "turns the view's depth into a visibility mask.",
        (ShaderKind::Fit, _) => "measures the engine's depth: how many pixels see each, and where.",
        (ShaderKind::Function, _) => "visibility of a point, for the engine's own materials.",
    }
}

/// Axes of a capture in words.
pub(crate) const CAPTURE_AXES: &str =
    "the capture's axes: the camera's (x right, y up, looking along -z), sheared as the plan says";

/// Axes in words.
pub(crate) fn axes_summary(axes: Axes) -> &'static str {
    match axes {
        Axes::Camera => "camera axes: x right, y up, looking along -z",
        Axes::World => "world axes",
    }
}

/// Lines of a doc comment without characters that end a line or change the reading direction.
pub(crate) fn doc_lines(doc: &str) -> Vec<String> {
    let harmless = |letter: char| match letter {
        '\u{2028}' | '\u{2029}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => ' ',
        letter if letter.is_control() => ' ',
        letter => letter,
    };
    doc.lines().map(|line| line.trim().chars().map(harmless).collect()).collect()
}
