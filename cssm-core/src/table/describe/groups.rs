//! The bind groups of a case.

use super::{Names, filter, is_tested};
use crate::case::{LightCase, MaskDepth, MaskNormal, Resolve};
use crate::table::{BindGroup, Binding, BindingKind, GroupContent, RecordKind, ShaderKind};

pub(super) fn fit_group(names: &Names, depth: MaskDepth) -> BindGroup {
    let view = BindingKind::Uniform { record: RecordKind::Fit, dynamic_offset: false };
    let bindings = vec![
        Binding { binding: 0, name: names.value("fit"), kind: view },
        Binding { binding: 1, name: names.value("scene_depth"), kind: scene_depth(depth) },
        Binding { binding: 2, name: names.value("measured"), kind: BindingKind::Measured },
    ];
    BindGroup { shader: ShaderKind::Fit, content: GroupContent::Fit, group: 0, bindings: bindings.into() }
}

const fn scene_depth(depth: MaskDepth) -> BindingKind {
    match depth {
        MaskDepth::ReversedZ => BindingKind::SceneDepth,
        MaskDepth::Linear => BindingKind::SceneLinearDepth,
    }
}

pub(super) fn capture_group(names: &Names, shader: ShaderKind) -> BindGroup {
    let kind = BindingKind::Uniform { record: RecordKind::Capture, dynamic_offset: true };
    let bindings = vec![Binding { binding: 0, name: names.value("capture"), kind }];
    BindGroup { shader, content: GroupContent::CaptureFacet, group: 0, bindings: bindings.into() }
}

pub(super) fn caster_mesh_group(names: &Names, shader: ShaderKind) -> BindGroup {
    let kinds = [
        ("mesh_layout", BindingKind::MeshLayout),
        ("mesh_positions", BindingKind::MeshPositions),
        ("mesh_indices", BindingKind::MeshIndices),
        ("mesh_uvs", BindingKind::MeshUvs),
    ];
    let bindings: Vec<_> = (0..)
        .zip(kinds)
        .filter(|(_, (_, kind))| *kind != BindingKind::MeshUvs || is_tested(shader))
        .map(|(binding, (name, kind))| Binding { binding, name: names.value(name), kind })
        .collect();
    BindGroup { shader, content: GroupContent::CasterMesh, group: 1, bindings: bindings.into() }
}

pub(super) fn caster_mask_group(names: &Names, shader: ShaderKind, group: u32) -> BindGroup {
    let kind = BindingKind::Uniform { record: RecordKind::CasterMask, dynamic_offset: false };
    let bindings = vec![
        Binding { binding: 0, name: names.value("caster_mask"), kind },
        Binding { binding: 1, name: names.value("caster_mask_texture"), kind: BindingKind::CasterMask },
        Binding {
            binding: 2,
            name: names.value("caster_mask_sampler"),
            kind: BindingKind::CasterMaskSampler,
        },
    ];
    BindGroup { shader, content: GroupContent::CasterMask, group, bindings: bindings.into() }
}

pub(super) fn mask_group(names: &Names, depth: MaskDepth, normal: MaskNormal) -> BindGroup {
    let view = BindingKind::Uniform { record: RecordKind::Mask, dynamic_offset: false };
    let mut bindings = vec![
        Binding { binding: 0, name: names.value("mask"), kind: view },
        Binding { binding: 1, name: names.value("scene_depth"), kind: scene_depth(depth) },
    ];
    if normal == MaskNormal::Texture {
        let name = names.value("scene_normal");
        bindings.push(Binding { binding: 2, name, kind: BindingKind::SceneNormal });
    }
    BindGroup {
        shader: ShaderKind::Mask,
        content: GroupContent::MaskInput,
        group: 0,
        bindings: bindings.into(),
    }
}

pub(super) fn shadow_group(names: &Names, case: &LightCase, shader: ShaderKind, group: u32) -> BindGroup {
    let plan = BindingKind::Uniform { record: RecordKind::Shadow, dynamic_offset: false };
    let mut bindings = vec![Binding { binding: 0, name: names.value("shadow"), kind: plan }];
    bindings.extend(filter::bindings(names, case.filter));

    // Every shader of the case has them at the same numbers, so that they share one layout.
    let first = case.resolve.iter().find_map(|interface| match interface {
        Resolve::Function { first_binding, .. } => Some(*first_binding),
        Resolve::Mask { .. } => None,
    });
    for binding in &mut bindings {
        binding.binding += first.unwrap_or(0);
    }
    BindGroup { shader, content: GroupContent::Shadow, group, bindings: bindings.into() }
}
