//! What the engine's part and the generated part must not share: bindings, names; and what neither may hold.

use cssm_core::table::{CaseTable, CasterBinding, GroupContent, ShaderKind};

use super::pieces::Piece;
use super::report::{CasterFinding, CasterPlace};
use super::signature::first_word;
use crate::judge::{self, JudgeError};
use crate::wgsl::{self, TokenKind};

/// Bindings of the engine's in the facet's group, or where the uniform rows are bound.
pub(super) fn bindings(
    module: &naga::Module,
    pieces: &[Piece],
    facet_group: u32,
    rows: Option<(u32, u32)>,
) -> Vec<CasterFinding> {
    let mut findings = Vec::new();
    let mut known: Vec<(naga::ResourceBinding, &Piece)> = Vec::new();
    for (_, global) in module.global_variables.iter() {
        let (Some(binding), Some(piece)) = (global.binding, piece_of(pieces, global.name.as_deref())) else {
            continue;
        };
        let place = piece.name_place();
        let (name, group, number) = (piece.name(), binding.group, binding.binding);
        if group == facet_group {
            findings.push(
                CasterFinding::at(
                    place,
                    format!("`{name}` is bound in group {group}, which holds the facet that is captured"),
                    format!("bind it in group {} or higher", facet_group + 1),
                )
                .labelled(format!("@group({group}) @binding({number})")),
            );
        } else if rows == Some((group, number)) {
            findings.push(CasterFinding::at(
                place,
                format!(
                    "`{name}` is bound at group {group}, binding {number}, which hold the rows of the world"
                ),
                "give the binding or the rows another number",
            ));
        } else if let Some((_, earlier)) = known.iter().find(|(earlier, _)| *earlier == binding) {
            findings.push(
                CasterFinding::at(
                    place,
                    format!("group {group}, binding {number} is taken twice"),
                    "give one of them another number",
                )
                .and(earlier.name_place(), "taken here first"),
            );
        }
        known.push((binding, piece));
    }
    findings
}

/// Overrides, which SPIR-V could not hold.
pub(super) fn overrides(module: &naga::Module, pieces: &[Piece]) -> Vec<CasterFinding> {
    let names = module.overrides.iter().filter_map(|(_, constant)| constant.name.as_deref());
    let found = names.filter_map(|name| piece_of(pieces, Some(name)));
    found
        .map(|piece| {
            let message =
                format!("`{}` is an override: its value is known when pipelines are made", piece.name());
            CasterFinding::at(
                piece.place(first_word(piece)),
                message,
                "write `const`, or read it from a uniform",
            )
        })
        .collect()
}

/// The bindings that a composed module uses beside the facet's.
pub(super) fn used_bindings(module: &naga::Module, facet_group: u32) -> Vec<CasterBinding> {
    let unused = judge::unused(module);
    let globals = module.global_variables.iter().filter_map(|(_, global)| {
        let binding = global.binding.filter(|binding| binding.group != facet_group)?;
        let name = global.name.clone().filter(|name| !unused.iter().any(|(_, unused)| unused == name))?;
        Some(CasterBinding { group: binding.group, binding: binding.binding, name: name.into() })
    });
    let mut bindings: Vec<_> = globals.collect();
    bindings.sort_by_key(|binding| (binding.group, binding.binding));
    bindings
}

/// Names that the engine and the generated part both declare, and names of WGSL's own that the generated part uses and
/// the engine declares anew. `called` is the generated part before it named the engine's functions; `first` is where it
/// begins in file `generated` of the report.
pub(super) fn names(
    pieces: &[Piece],
    reached: &[usize],
    text: &str,
    called: &str,
    (first, generated): (usize, usize),
) -> Vec<CasterFinding> {
    let declared = wgsl::declarations(text);
    let called = called_words(called);
    let mut findings = Vec::new();
    for piece in reached.iter().map(|number| &pieces[*number]).filter(|piece| piece.declaration.is_some()) {
        let name = piece.name();
        if let Some(same) = declared.iter().find(|declaration| declaration.name == name) {
            let start = first + text.find(same.text).unwrap_or(0);
            let found = super::pieces::words(same.text).find(|(_, word)| *word == name);
            let bytes = found.map_or(0..0, |(bytes, _)| bytes);
            let place = CasterPlace { file: generated, bytes: start + bytes.start..start + bytes.end };
            findings.push(
                CasterFinding::at(
                    piece.name_place(),
                    format!("`{name}` is also a name of the generated part"),
                    "rename it, or give the case another prefix",
                )
                .labelled("declared by the engine")
                .and(place, "declared by the generated part"),
            );
        } else if called.contains(&name) {
            findings.push(CasterFinding::at(
                piece.name_place(),
                format!("`{name}` is a name of WGSL's own that the generated part uses"),
                "rename it",
            ));
        }
    }
    findings
}

/// Judges the generated part: nothing unused, the facet where the table has it, records as the table has them.
pub(super) fn generated_part(
    module: &naga::Module,
    table: &CaseTable,
    shader: ShaderKind,
    engine_names: &[&str],
) -> Result<(), JudgeError> {
    let unused = judge::unused(module);
    if let Some((what, name)) = unused.iter().find(|(_, name)| !engine_names.contains(&name.as_str())) {
        return Err(JudgeError::Unused(format!("{what} `{name}`")));
    }
    judge::find_records(module, table)?;
    let facet = table.group(shader, GroupContent::CaptureFacet);
    for (group, binding) in facet.iter().flat_map(|group| group.bindings.iter().map(move |one| (group, one)))
    {
        let at = naga::ResourceBinding { group: group.group, binding: binding.binding };
        let is_bound = |global: &naga::GlobalVariable| {
            global.binding == Some(at) && global.name.as_deref() == Some(&*binding.name)
        };
        if !module.global_variables.iter().any(|(_, global)| is_bound(global)) {
            return Err(JudgeError::Table(format!("it does not bind {} where the table does", binding.name)));
        }
    }
    Ok(())
}

fn piece_of<'p, 'a>(pieces: &'p [Piece<'a>], name: Option<&str>) -> Option<&'p Piece<'a>> {
    pieces.iter().find(|piece| piece.declaration.is_some() && Some(piece.name()) == name)
}

/// Words that a text calls or takes as types: those right before a bracket.
fn called_words(text: &str) -> Vec<&str> {
    let tokens: Vec<_> = wgsl::tokens(text).collect();
    let pairs = tokens.windows(2).filter(|pair| pair[0].kind == TokenKind::Word);
    let mut called: Vec<_> =
        pairs.filter(|pair| matches!(pair[1].text, "(" | "<")).map(|pair| pair[0].text).collect();
    called.extend(["f32", "i32", "u32", "bool"]);
    called
}
