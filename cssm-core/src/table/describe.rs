//! From a case to its table.

mod constants;
mod groups;
mod layout;
mod names;
mod passes;
mod records;

use std::borrow::Cow;

use self::constants::constants;
use self::groups::{
    capture_group, caster_mask_group, caster_mesh_group, fit_group, mask_group, shadow_group,
};
use self::passes::{capture_pass, mask_pass};
use self::records::{
    capture_record, caster_mask_record, facet_record, fit_record, mask_record, shadow_record,
};
use super::{CaseTable, Reduction, ShaderKind, filter};
use crate::case::{Casters, LightCase, Resolve, Stretch};
use crate::distribution::RemapKind;
use crate::fit;

pub(super) use self::names::Names;
pub(super) use self::records::VECTORS_A_PLANE;

impl CaseTable {
    /// Records, bindings and passes of a case; shaders are left empty.
    pub fn describe(case: &LightCase) -> Self {
        let shape = case.shape();
        let names = Names::of(case);
        let mut records = Vec::new();
        let mut groups = Vec::new();
        let mut passes = Vec::new();
        for shader in capture_shaders(case) {
            groups.push(capture_group(&names, *shader));
            if bends_exactly(case) {
                groups.push(caster_mesh_group(&names, *shader));
            }
            if is_tested(*shader) {
                groups.push(caster_mask_group(&names, *shader, if bends_exactly(case) { 2 } else { 1 }));
            }
            passes.push(capture_pass(&names, *shader));
        }

        if case.filter.is_prefiltered() {
            for shader in [ShaderKind::PrefilterRows, ShaderKind::PrefilterColumns] {
                groups.push(filter::prefilter_group(&names, case.filter, shader));
                passes.push(filter::prefilter_pass(&names, case.filter, shader));
            }
        }

        // Resolving shares one record and one group layout between its interfaces.
        records.push(facet_record(&names, case));
        records.push(shadow_record(&names, case, records[0].size_bytes));
        records.push(capture_record(&names, case));
        if case.casters == Casters::AlphaTested {
            records.push(caster_mask_record(&names));
        }
        for interface in &case.resolve {
            match *interface {
                Resolve::Mask { depth, normal } => {
                    records.push(mask_record(&names, depth));
                    groups.push(mask_group(&names, depth, normal));
                    groups.push(shadow_group(&names, case, ShaderKind::Mask, 1));
                    passes.push(mask_pass(&names, case.filter, normal));
                }
                Resolve::Function { group, .. } => {
                    groups.push(shadow_group(&names, case, ShaderKind::Function, group));
                }
            }
        }

        // Depth is measured where the case is fitted to it and says how it is stored.
        let depth = case.resolve.iter().find_map(|interface| match interface {
            Resolve::Mask { depth, .. } => Some(*depth),
            Resolve::Function { .. } => None,
        });
        let reduction = depth.filter(|_| case.fit.measures_depth()).map(|depth| {
            records.push(fit_record(&names, depth));
            groups.push(fit_group(&names, depth));
            Reduction {
                entry: names.value("fit_measure"),
                square_pixels: fit::SQUARE_PIXELS,
                words: fit::WORDS as u32,
            }
        });

        Self {
            case: case.name.clone().into(),
            prefix: case.prefix.clone().into(),
            fingerprint: fingerprint(case),
            map_width: case.map.width,
            map_height: case.map.height,
            map_format: case.map.format,
            halves: shape.halves,
            sectors: shape.sectors,
            bands: shape.bands,
            clips: shape.clips,
            dominant: shape.dominant,
            scales_thresholds: case.scales_thresholds(),
            local_light: case.light.is_local(),
            remap: case.remap(),
            stretch: case.stretch,
            may_reverse_depth: case.may_reverse_depth(),
            axes: case.axes,
            shears: case.shears(),
            fetches_per_pixel: filter::fetches_per_pixel(case.filter),
            constants: constants(&names, case).into(),
            records: records.into(),
            groups: groups.into(),
            passes: passes.into(),
            reduction,
            shaders: Cow::Borrowed(&[]),
        }
    }
}

/// Whether triangles are decided texel by texel where rows are bent.
fn bends_exactly(case: &LightCase) -> bool {
    matches!(case.stretch, Stretch::Exact { .. }) && case.remap() != RemapKind::None
}

/// The capture shaders of a case. Casters with an alpha mask have a fragment stage in any case, so that all their triangles
/// are decided texel by texel where some are.
fn capture_shaders(case: &LightCase) -> &'static [ShaderKind] {
    use ShaderKind::{
        Capture, CaptureBent, CaptureBentTested, CaptureClamped, CaptureTested, CaptureTestedClamped,
    };
    match (bends_exactly(case), case.casters) {
        (false, Casters::Opaque) => &[Capture, CaptureClamped],
        (false, Casters::AlphaTested) => &[Capture, CaptureClamped, CaptureTested, CaptureTestedClamped],
        (true, Casters::Opaque) => &[Capture, CaptureClamped, CaptureBent],
        (true, Casters::AlphaTested) => &[Capture, CaptureClamped, CaptureBent, CaptureBentTested],
    }
}

const fn is_tested(shader: ShaderKind) -> bool {
    matches!(
        shader,
        ShaderKind::CaptureTested | ShaderKind::CaptureTestedClamped | ShaderKind::CaptureBentTested
    )
}

/// 64-bit FNV-1a over the debug form of the declaration, which spells every field and exact float.
fn fingerprint(case: &LightCase) -> u64 {
    const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    format!("{case:?}").bytes().fold(OFFSET, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME))
}
