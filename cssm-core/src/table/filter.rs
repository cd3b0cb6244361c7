//! What a filter asks of a table: constants, bindings of the resolve stage, passes of its own.

use std::borrow::Cow;

use super::describe::Names;
use super::{
    BindGroup, Binding, BindingKind, ConstantKind, ConstantValue, GroupContent, Pass, RecordKind, Resource,
    ShaderKind,
};
use crate::case::{Filter, Kernel};

/// Constants of a filter beside the map's size.
pub(super) fn constants(filter: Filter, push: &mut impl FnMut(ConstantKind, ConstantValue)) {
    if let Filter::Pcf { size, kernel } = filter {
        if kernel == Kernel::Texels {
            push(ConstantKind::Gathers, ConstantValue::U32(filter.texels_across() / 2));
        }
        push(ConstantKind::WidestKernel, ConstantValue::F32(0.5 * size.texels() as f32));
        match kernel {
            Kernel::Texels => {}
            Kernel::Metres(width) => push(ConstantKind::KernelMetres, ConstantValue::F32(0.5 * width as f32)),
            Kernel::Pixels(width) => push(ConstantKind::KernelPixels, ConstantValue::F32(0.5 * width as f32)),
        }
    }
    if let Filter::Evsm2 { exponent, blur_texels, bleeding } = filter {
        push(ConstantKind::Exponent, ConstantValue::F32(exponent as f32));
        push(ConstantKind::Blur, ConstantValue::U32(blur_texels));
        push(ConstantKind::Bleeding, ConstantValue::F32(bleeding as f32));
    }
    if let Filter::GroundMasks { planes, blur_metres, reach_texels } = filter {
        push(ConstantKind::GroundPlanes, ConstantValue::U32(planes));
        push(ConstantKind::BlurMetres, ConstantValue::F32(blur_metres as f32));
        push(ConstantKind::Blur, ConstantValue::U32(reach_texels));
    }
    if let Filter::Pcss { source, reach_texels } = filter {
        push(ConstantKind::WidestKernel, ConstantValue::F32(reach_texels as f32));
        push(ConstantKind::LightRadius, ConstantValue::F32(source.radius() as f32));
    }
}

/// The map, or what the prefilter made of it, and the sampler that reads it: what stands after the plan.
pub(super) fn bindings(names: &Names, filter: Filter) -> Vec<Binding> {
    const MAP: (&str, BindingKind) = ("map", BindingKind::Map);
    const GATHER: (&str, BindingKind) = ("map_sampler", BindingKind::GatherSampler);
    let bound: &[(&str, BindingKind)] = match filter {
        Filter::None => &[MAP],
        Filter::Evsm2 { .. } => &[("moments", BindingKind::Moments)],
        Filter::Hardware2x2 => &[MAP, ("map_sampler", BindingKind::ComparisonSampler)],
        Filter::Gather2x2 | Filter::Pcf { .. } | Filter::Pcss { .. } => &[MAP, GATHER],
        Filter::GroundMasks { .. } => &[
            MAP,
            GATHER,
            ("ground_masks", BindingKind::GroundMasks),
            ("ground_sampler", BindingKind::GroundSampler),
        ],
    };
    let binding = |(binding, (name, kind)): (u32, &(&str, BindingKind))| {
        let (name, kind) = (names.value(name), *kind);
        Binding { binding, name, kind }
    };
    (1..).zip(bound).map(binding).collect()
}

/// What the mask pass reads of the map.
pub(super) const fn resolved_from(filter: Filter) -> &'static [Resource] {
    match filter {
        Filter::Evsm2 { .. } => &[Resource::Moments],
        Filter::GroundMasks { .. } => &[Resource::Map, Resource::GroundMasks],
        _ => &[Resource::Map],
    }
}

/// Texture fetch instructions of the map for one receiver, at most.
pub(super) const fn fetches_per_pixel(filter: Filter) -> u32 {
    match filter {
        Filter::None | Filter::Hardware2x2 | Filter::Gather2x2 | Filter::GroundMasks { .. } => 1,
        Filter::Pcf { .. } => {
            let gathers = filter.texels_across() / 2;
            gathers * gathers
        }
        Filter::Pcss { .. } => {
            let gathers = filter.texels_across().div_ceil(2);
            2 * gathers * gathers
        }
        Filter::Evsm2 { .. } => 4,
    }
}

/// What a pass of the prefilter reads.
const fn prefilter_source(
    filter: Filter,
    shader: ShaderKind,
) -> (&'static str, BindingKind, &'static [Resource]) {
    match (shader, filter) {
        (ShaderKind::PrefilterColumns, Filter::GroundMasks { .. }) => {
            ("ground_rows", BindingKind::GroundRows, &[Resource::GroundRows])
        }
        (ShaderKind::PrefilterColumns, _) => {
            ("moment_rows", BindingKind::MomentRows, &[Resource::MomentRows])
        }
        _ => ("map", BindingKind::Map, &[Resource::Map]),
    }
}

/// Bindings of a pass of the prefilter.
pub(super) fn prefilter_group(names: &Names, filter: Filter, shader: ShaderKind) -> BindGroup {
    let plan = BindingKind::Uniform { record: RecordKind::Shadow, dynamic_offset: false };
    let (source, kind, _) = prefilter_source(filter, shader);
    let bindings = vec![
        Binding { binding: 0, name: names.value("shadow"), kind: plan },
        Binding { binding: 1, name: names.value(source), kind },
    ];
    BindGroup { shader, content: GroupContent::Prefilter, group: 0, bindings: bindings.into() }
}

/// A pass of the prefilter.
pub(super) fn prefilter_pass(names: &Names, filter: Filter, shader: ShaderKind) -> Pass {
    let (.., reads) = prefilter_source(filter, shader);
    let writes = match (shader, filter) {
        (ShaderKind::PrefilterColumns, Filter::GroundMasks { .. }) => &[Resource::GroundMasks],
        (ShaderKind::PrefilterColumns, _) => &[Resource::Moments],
        (_, Filter::GroundMasks { .. }) => &[Resource::GroundRows],
        _ => &[Resource::MomentRows],
    };
    Pass {
        shader,
        vertex: names.value(&format!("{}_vertex", shader.name())),
        fragment: Some(names.value(&format!("{}_fragment", shader.name()))),
        reads: Cow::Borrowed(reads),
        writes: Cow::Borrowed(writes),
    }
}
