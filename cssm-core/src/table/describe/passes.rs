//! The passes of a case beside the prefilter's.

use std::borrow::Cow;

use super::{Names, filter, is_tested};
use crate::case::{Filter, MaskNormal};
use crate::table::{Pass, Resource, ShaderKind};

pub(super) fn capture_pass(names: &Names, shader: ShaderKind) -> Pass {
    let reads = if is_tested(shader) {
        &[Resource::Casters, Resource::CasterMasks][..]
    } else {
        &[Resource::Casters]
    };
    let fragment = shader != ShaderKind::Capture;
    Pass {
        shader,
        vertex: names.value(&format!("{}_vertex", shader.name())),
        fragment: fragment.then(|| names.value(&format!("{}_fragment", shader.name()))),
        reads: Cow::Borrowed(reads),
        writes: Cow::Borrowed(&[Resource::Map]),
    }
}

pub(super) fn mask_pass(names: &Names, filter: Filter, normal: MaskNormal) -> Pass {
    let mut reads = filter::resolved_from(filter).to_vec();
    reads.push(Resource::SceneDepth);
    reads.extend((normal == MaskNormal::Texture).then_some(Resource::SceneNormal));
    Pass {
        shader: ShaderKind::Mask,
        vertex: names.value("mask_vertex"),
        fragment: Some(names.value("mask_fragment")),
        reads: reads.into(),
        writes: Cow::Borrowed(&[Resource::Mask]),
    }
}
