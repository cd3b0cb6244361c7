//! Whether a composed module is right: naga validates it, nothing is left to remove, and every name, number and
//! offset of the table is in it.

use cssm_core::table::{CaseTable, Record, ShaderKind};
use naga::compact::{KeepUnused, compact};
use naga::front::wgsl::{Frontend, Options};
use naga::proc::Layouter;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::prelude;

/// A module that naga accepts.
#[derive(Debug)]
pub(crate) struct Judged {
    /// The module.
    pub(crate) module: naga::Module,
    /// What validation found out.
    pub(crate) info: ModuleInfo,
}

/// What is wrong with a module.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum JudgeError {
    /// It is not WGSL.
    #[error("it does not parse:\n{0}")]
    Parse(String),
    /// It is WGSL that makes no sense.
    #[error("it does not validate:\n{0}")]
    Validate(String),
    /// It holds something that nothing uses.
    #[error("it holds {0} that nothing uses")]
    Unused(String),
    /// It disagrees with the table.
    #[error("{0}")]
    Table(String),
    /// It cannot be written as SPIR-V.
    #[error("it has no SPIR-V: {0}")]
    Spirv(String),
}

/// What a shader of a table may need of the device beyond WebGPU's core: clip distances, where the pipeline cuts.
pub(crate) fn capabilities(table: &CaseTable, shader: ShaderKind) -> Capabilities {
    if prelude::uses_clip_distances(table, shader) {
        Capabilities::CLIP_DISTANCES
    } else {
        Capabilities::empty()
    }
}

/// Parses and validates a module with nothing but WebGPU's core and the given capabilities.
pub(crate) fn validate(wgsl: &str, capabilities: Capabilities) -> Result<Judged, JudgeError> {
    let options = Options { parse_doc_comments: false, capabilities };
    let module = Frontend::new_with_options(options)
        .parse(wgsl)
        .map_err(|error| JudgeError::Parse(error.emit_to_string(wgsl)))?;
    let info = Validator::new(ValidationFlags::all(), capabilities)
        .validate(&module)
        .map_err(|error| JudgeError::Validate(error.emit_to_string(wgsl)))?;
    Ok(Judged { module, info })
}

/// Judges a module against the table of its case.
pub(crate) fn judge(wgsl: &str, table: &CaseTable, shader: ShaderKind) -> Result<Judged, JudgeError> {
    let capabilities = capabilities(table, shader);
    let judged = match shader {
        ShaderKind::Function => validate(&with_entry_point(wgsl, table), capabilities)?,
        _ => validate(wgsl, capabilities)?,
    };
    find_unused(&judged.module)?;
    find_entry_points(&judged.module, table, shader)?;
    find_bindings(&judged.module, table, shader)?;
    find_records(&judged.module, table)?;
    Ok(judged)
}

/// A function module with a fragment stage that calls the function, so that validation has a stage to start from.
pub(crate) fn with_entry_point(wgsl: &str, table: &CaseTable) -> String {
    let prefix = &table.prefix;
    let head = format!("fn {prefix}_visibility(");
    let parameters =
        wgsl.split_once(&head).and_then(|(_, rest)| rest.split_once(')')).map_or("", |(head, _)| head);
    let (inputs, arguments) = match parameters.contains("normal") {
        true => ("@location(0) position: vec3<f32>, @location(1) normal: vec3<f32>", "position, normal"),
        false => ("@location(0) position: vec3<f32>", "position"),
    };
    format!(
        "{wgsl}\n@fragment\nfn {prefix}_material({inputs}) -> @location(0) vec4<f32> {{\n    \
         return vec4<f32>({prefix}_visibility({arguments}));\n}}\n"
    )
}

/// Finds what compaction would remove.
pub(crate) fn find_unused(module: &naga::Module) -> Result<(), JudgeError> {
    match unused(module).into_iter().next() {
        Some((what, name)) => Err(JudgeError::Unused(format!("{what} `{name}`"))),
        None => Ok(()),
    }
}

/// What compaction would remove, by kind and name.
pub(crate) fn unused(module: &naga::Module) -> Vec<(&'static str, String)> {
    let mut kept = module.clone();
    compact(&mut kept, KeepUnused::No);
    let names = |module: &naga::Module| {
        let functions = module.functions.iter().map(|(_, function)| ("function", function.name.clone()));
        let globals = module.global_variables.iter().map(|(_, global)| ("binding", global.name.clone()));
        let types = module.types.iter().map(|(_, ty)| ("type", ty.name.clone()));
        let constants = module.constants.iter().map(|(_, constant)| ("constant", constant.name.clone()));
        let named = functions.chain(globals).chain(types).chain(constants);
        named.filter_map(|(what, name)| name.map(|name| (what, name))).collect::<Vec<_>>()
    };
    let kept = names(&kept);
    names(module).into_iter().filter(|name| !kept.contains(name)).collect()
}

fn find_entry_points(module: &naga::Module, table: &CaseTable, shader: ShaderKind) -> Result<(), JudgeError> {
    let mut expected = Vec::new();
    match (table.pass(shader), &table.reduction) {
        (Some(pass), _) => {
            expected.push((naga::ShaderStage::Vertex, pass.vertex.as_ref()));
            expected.extend(pass.fragment.as_deref().map(|name| (naga::ShaderStage::Fragment, name)));
        }
        (None, Some(reduction)) if shader == ShaderKind::Fit => {
            expected.push((naga::ShaderStage::Compute, reduction.entry.as_ref()));
        }
        _ => return Ok(()),
    }
    let found: Vec<_> = module.entry_points.iter().map(|entry| (entry.stage, entry.name.as_str())).collect();
    if found == expected {
        return Ok(());
    }
    Err(JudgeError::Table(format!("its entry points are {found:?}, but the table has {expected:?}")))
}

fn find_bindings(module: &naga::Module, table: &CaseTable, shader: ShaderKind) -> Result<(), JudgeError> {
    let mut found: Vec<_> = module
        .global_variables
        .iter()
        .filter_map(|(_, global)| Some((global.binding?, global.name.clone()?)))
        .map(|(binding, name)| (binding.group, binding.binding, name))
        .collect();
    found.sort();
    let groups = table.groups.iter().filter(|group| group.shader == shader);
    let mut expected: Vec<_> = groups
        .flat_map(|group| {
            group.bindings.iter().map(|binding| (group.group, binding.binding, binding.name.to_string()))
        })
        .collect();
    expected.sort();
    if found == expected {
        return Ok(());
    }
    Err(JudgeError::Table(format!("its bindings are {found:?}, but the table has {expected:?}")))
}

/// Compares the records that the module declares with the table's sizes and offsets.
pub(crate) fn find_records(module: &naga::Module, table: &CaseTable) -> Result<(), JudgeError> {
    let mut layouter = Layouter::default();
    layouter.update(module.to_ctx()).map_err(|error| JudgeError::Table(error.to_string()))?;
    for record in table.records.iter() {
        let declared = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(&*record.name));
        let Some((handle, ty)) = declared else { continue };
        let naga::TypeInner::Struct { members, .. } = &ty.inner else {
            continue;
        };
        let found: Vec<_> =
            members.iter().map(|member| (member.name.clone().unwrap_or_default(), member.offset)).collect();
        check_record(record, layouter[handle].size, &found)?;
    }
    Ok(())
}

fn check_record(record: &Record, size_bytes: u32, found: &[(String, u32)]) -> Result<(), JudgeError> {
    let expected: Vec<_> =
        record.fields.iter().map(|field| (field.name.to_string(), field.offset_bytes)).collect();
    if size_bytes == record.size_bytes && found == expected {
        return Ok(());
    }
    Err(JudgeError::Table(format!(
        "record {} has {size_bytes} bytes and fields {found:?}, but the table has {} bytes and {expected:?}",
        record.name, record.size_bytes
    )))
}

#[cfg(test)]
mod tests;
