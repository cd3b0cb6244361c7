//! The numbers that a case's shaders are specialised for.

use super::records::threshold_vectors;
use super::{Names, bends_exactly, filter};
use crate::case::{Bias, Filter, LightCase, Stretch};
use crate::table::{Constant, ConstantKind, ConstantValue};

/// Constants of a case.
pub(super) fn constants(names: &Names, case: &LightCase) -> Vec<Constant> {
    let shape = case.shape();
    let mut constants = Vec::new();
    let mut push = |kind: ConstantKind, value: ConstantValue| {
        constants.push(Constant { kind, name: names.constant(kind.name()), value });
    };
    if case.filter != Filter::None {
        let size = [case.map.width as f32, case.map.height as f32];
        push(ConstantKind::MapSize, ConstantValue::Vec2(size));
    }
    filter::constants(case.filter, &mut push);
    if shape.sectors > 1 {
        push(ConstantKind::Sectors, ConstantValue::U32(shape.sectors));
    }
    if shape.bands > 1 {
        push(ConstantKind::Bands, ConstantValue::U32(shape.bands));
        push(ConstantKind::ThresholdVectors, ConstantValue::U32(threshold_vectors(shape)));
    }
    if let Stretch::Exact { bound_texels } = case.stretch
        && bends_exactly(case)
    {
        push(ConstantKind::StretchBound, ConstantValue::F32(bound_texels as f32));
    }
    if shape.dominant {
        push(ConstantKind::Dominant, ConstantValue::U32(shape.cells() - 1));
    }
    match case.bias {
        Bias::None | Bias::ReceiverPlane => {}
        Bias::Constant { along_light_metres } => {
            push(ConstantKind::BiasMetres, ConstantValue::F32(along_light_metres as f32));
        }
        Bias::Slope { texels } => push(ConstantKind::BiasTexels, ConstantValue::F32(texels as f32)),
        Bias::WorldTexel { a_metres, b_texels } => {
            push(ConstantKind::BiasAMetres, ConstantValue::F32(a_metres as f32));
            push(ConstantKind::BiasBTexels, ConstantValue::F32(b_texels as f32));
        }
    }
    constants
}
