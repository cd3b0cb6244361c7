//! SPIR-V of a judged module, with every choice of the writer pinned, so that the words depend on the module alone:
//! not on the build profile, not on the machine.

use naga::back::spv;
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};

use crate::judge::{JudgeError, Judged};

/// SPIR-V 1.3 is Vulkan 1.1's: the oldest version that every driver in use accepts.
const VERSION: (u8, u8) = (1, 3);

/// Words of a module, little-endian.
///
/// Clip space stays as WGSL has it, y up: give Vulkan a viewport of negative height, as wgpu does. Indices carry no
/// bounds checks, because the library keeps every index in range by construction, and there are no debug names.
pub(crate) fn write(judged: &Judged) -> Result<Vec<u8>, JudgeError> {
    write_with(judged, BoundsCheckPolicy::Unchecked)
}

/// The same for modules that hold an engine's own functions: an index out of range reads the nearest element instead.
pub(crate) fn write_checked(judged: &Judged) -> Result<Vec<u8>, JudgeError> {
    write_with(judged, BoundsCheckPolicy::Restrict)
}

fn write_with(judged: &Judged, policy: BoundsCheckPolicy) -> Result<Vec<u8>, JudgeError> {
    let options = spv::Options {
        lang_version: VERSION,
        flags: spv::WriterFlags::empty(),
        // Without a map, bindings keep the group and binding numbers of the source.
        fake_missing_bindings: true,
        binding_map: spv::BindingMap::default(),
        capabilities: None,
        bounds_check_policies: BoundsCheckPolicies {
            index: policy,
            buffer: policy,
            image_load: policy,
            binding_array: policy,
        },
        zero_initialize_workgroup_memory: spv::ZeroInitializeWorkgroupMemoryMode::None,
        force_loop_bounding: false,
        ray_query_initialization_tracking: false,
        trace_ray_argument_validation: false,
        use_storage_input_output_16: false,
        debug_info: None,
        task_dispatch_limits: None,
        mesh_shader_primitive_indices_clamp: false,
        emit_int_div_checks: false,
    };
    let words = spv::write_vec(&judged.module, &judged.info, &options, None)
        .map_err(|error| JudgeError::Spirv(error.to_string()))?;
    Ok(words.iter().flat_map(|word| word.to_le_bytes()).collect())
}
