//! Files of remaps: how rows of bent tiles are spent over depth.

use cssm_core::distribution::RemapKind;

/// What shaders need of a remap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Remap {
    /// `remapped`: from one over distance to clip y.
    Value,
    /// `remap_slope`: the change of clip y.
    Slope,
    /// `unremapped`: back to one over distance.
    Inverse,
}

/// Files of a remap; none where rows are straight.
pub(super) fn remap(kind: RemapKind, needs: &[Remap]) -> Vec<&'static str> {
    let file = |need: &Remap| match (kind, need) {
        (RemapKind::None, _) => None,
        (RemapKind::Perspective, Remap::Value) => Some("remap_perspective"),
        (RemapKind::Perspective, Remap::Slope) => Some("remap_perspective_slope"),
        (RemapKind::Perspective, Remap::Inverse) => Some("remap_perspective_inverse"),
        (RemapKind::Logarithmic, Remap::Value) => Some("remap_logarithmic"),
        (RemapKind::Logarithmic, Remap::Slope) => Some("remap_logarithmic_slope"),
        (RemapKind::Logarithmic, Remap::Inverse) => Some("remap_logarithmic_inverse"),
    };
    let divisor = (kind == RemapKind::Perspective).then_some("remap_perspective_divisor");
    divisor.into_iter().chain(needs.iter().filter_map(file)).collect()
}
