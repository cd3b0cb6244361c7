//! The other judges of generated modules: naga with options that the generator does not use, compaction, spirv-val, and
//! Tint, which reads WGSL for Chromium.

use std::path::Path;
use std::process::Command;

use cssm::core::table::{CaseTable, ShaderKind};
use naga::valid::Capabilities;

/// A module with an entry point: the function module is called from a fragment stage.
pub(crate) fn with_stage(wgsl: &str, table: &CaseTable, kind: ShaderKind) -> String {
    if kind != ShaderKind::Function {
        return wgsl.to_owned();
    }
    let prefix = &table.prefix;
    let call = if wgsl.contains("normal: vec3<f32>) -> f32") { "(p, n)" } else { "(p)" };
    format!(
        "{wgsl}\n@fragment fn stage(@location(0) p: vec3<f32>, @location(1) n: vec3<f32>) -> @location(0) \
         vec4<f32> {{ return vec4<f32>({prefix}_visibility{call}); }}"
    )
}

/// What a module may need beyond WebGPU's core: clip distances, where facets share tiles and the pipeline cuts.
pub(crate) fn capabilities(table: &CaseTable, kind: ShaderKind) -> Capabilities {
    match kind {
        ShaderKind::Capture | ShaderKind::CaptureTested if table.clips > 0 => Capabilities::CLIP_DISTANCES,
        _ => Capabilities::empty(),
    }
}

/// Validates a module, checks that compaction removes nothing, and returns its words.
pub(crate) fn judge(wgsl: &str, capabilities: Capabilities) -> Result<Vec<u8>, String> {
    use naga::compact::{KeepUnused, compact};
    use naga::front::wgsl::{Frontend, Options};
    use naga::valid::{ValidationFlags, Validator};
    let mut frontend = Frontend::new_with_options(Options { parse_doc_comments: false, capabilities });
    let module = frontend.parse(wgsl).map_err(|error| error.emit_to_string(wgsl))?;
    let mut validator = Validator::new(ValidationFlags::all(), capabilities);
    let info = validator.validate(&module).map_err(|error| error.emit_to_string(wgsl))?;
    let mut kept = module.clone();
    compact(&mut kept, KeepUnused::No);
    let named_types = |module: &naga::Module| module.types.iter().filter(|(_, ty)| ty.name.is_some()).count();
    let counts = |module: &naga::Module| {
        (module.functions.len(), module.global_variables.len(), module.constants.len(), named_types(module))
    };
    if counts(&module) != counts(&kept) {
        return Err(format!("compact leaves {:?} of {:?}", counts(&kept), counts(&module)));
    }
    let options = naga::back::spv::Options { lang_version: (1, 3), ..Default::default() };
    let words =
        naga::back::spv::write_vec(&module, &info, &options, None).map_err(|error| error.to_string())?;
    Ok(words.iter().flat_map(|word| word.to_le_bytes()).collect())
}

pub(crate) fn spirv_val_is_there() -> bool {
    let there = Command::new("spirv-val").arg("--version").output().is_ok();
    if !there {
        eprintln!("SKIPPED: spirv-val is not installed; install Debian's spirv-tools");
    }
    there
}

/// Runs spirv-val over every module.
pub(crate) fn spirv_val(modules: &[Vec<u8>]) {
    if spirv_val_is_there() {
        for_each(modules, "spv", |module, path| {
            assert!(passes_spirv_val(module, path), "spirv-val refuses a module");
        });
    }
}

/// Calls `judge` with every module and a file for it, on as many threads as there are cores.
fn for_each<M: Sync>(modules: &[M], extension: &str, judge: impl Fn(&M, &Path) + Sync) {
    let folder = tempfile::tempdir().unwrap();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for thread in 0..threads {
            let path = folder.path().join(format!("{thread}.{extension}"));
            let (modules, judge) = (modules.iter().skip(thread).step_by(threads), &judge);
            scope.spawn(move || modules.for_each(|module| judge(module, &path)));
        }
    });
}

pub(crate) fn passes_spirv_val(module: &[u8], path: &Path) -> bool {
    std::fs::write(path, module).unwrap();
    let output = Command::new("spirv-val").args(["--target-env", "vulkan1.1"]).arg(path).output().unwrap();
    if !output.status.success() {
        eprintln!("{}", String::from_utf8_lossy(&output.stdout));
        eprintln!("{}", String::from_utf8_lossy(&output.stderr));
    }
    output.status.success()
}

pub(crate) fn tint_is_there() -> bool {
    let there = Command::new("tint").arg("--help").output().is_ok();
    if !there {
        eprintln!("SKIPPED: tint is not installed; build it from Dawn's sources");
    }
    there
}

/// Runs Tint over the text of every module.
pub(crate) fn tint(modules: &[String]) {
    if tint_is_there() {
        for_each(modules, "wgsl", |module, path| {
            assert!(passes_tint(module, path), "Tint refuses a module\n{module}");
        });
    }
}

pub(crate) fn passes_tint(wgsl: &str, path: &Path) -> bool {
    std::fs::write(path, wgsl).unwrap();
    let output = Command::new("tint")
        .args(["--format", "wgsl", "--output-name"])
        .arg(path.with_extension("out"))
        .arg(path)
        .output()
        .unwrap();
    if !output.status.success() {
        eprintln!("{}", String::from_utf8_lossy(&output.stdout));
        eprintln!("{}", String::from_utf8_lossy(&output.stderr));
    }
    output.status.success()
}
