//! Perspective: one piece, seen from an eye that is pushed back until a share of the rows lies before a focus distance
//! (camera space shadow maps, section 3; any share).
//!
//! Straight, the whole map is seen from there, which also narrows it towards the eye. Bent, only the rows are (section
//! 4: stretching): what lies across keeps the view's own width, and no texel is wasted.

use super::{DistanceRange, DistributionSpec, Piece, Pieces, RemapKind, folds};
use crate::focus;
use crate::remap::Curve;
use crate::schema::{Arguments, Choice, Default, Field, Kind, Unit};

pub(super) const SPEC: DistributionSpec = DistributionSpec {
    choice: Choice {
        name: "perspective",
        summary: "one perspective whose eye is pushed back until a share of the rows lies before the focus",
        arguments: &[focus::FIELD, SHARE, folds::field(1, "1")],
    },
    pieces: folds::count,
    bent: RemapKind::Perspective,
    straight: true,
    split,
};

/// Share of the rows before the focus.
pub(super) const SHARE: Field = Field {
    name: "share",
    summary: "share of the rows before the focus",
    kind: Kind::Number { min: 0.0, max: 1.0, open: true, unit: Unit::None },
    default: Default::Value("0.5"),
};
/// Push-back of bent rows in farthest distances at most: what is uniform to f32.
const FARTHEST_PUSH_BACK: f64 = 10.0;

fn split(arguments: &Arguments, range: &DistanceRange) -> Pieces {
    let focus = range.focus_metres(arguments);
    let whole = perspective_piece(focus, share(arguments), range);
    let count = folds::count(arguments);
    // Folded pieces lie on either side of the focus: each is as fine as it can be.
    let focus_metres = if count > 1 { f64::INFINITY } else { whole.focus_metres };
    folds::folded(Piece { focus_metres, ..whole }, whole.curve, whole.push_back_metres, count)
}

/// The declared share.
pub(super) fn share(arguments: &Arguments) -> f64 {
    arguments.number(SHARE.name).unwrap_or(0.5)
}

/// A whole column with `share` of its rows before `focus_metres`.
///
/// Where the light does not reach the eye, receivers begin at n' beyond the near plane. The paper then moves the focus to
/// (1 - n'/far) F + n' (section 6.2), which for n' >= F asks for an eye before its own place. Here the push-back of
/// the whole view is kept, so that a receiver's rows do not depend on where the light ends.
pub fn perspective_piece(focus_metres: f64, share: f64, range: &DistanceRange) -> Piece {
    let core = range.core_metres;
    let near = range.unlit_near_metres.unwrap_or(range.nearest_metres + core);
    let far = range.farthest_metres + core;
    let push_back = push_back_metres(focus_metres, share, near, far);
    let farthest = if far.is_finite() { FARTHEST_PUSH_BACK * far } else { f64::INFINITY };
    let (own, curve) = match range.bends {
        true => (0.0, Curve::Perspective { push_back_metres: push_back.min(farthest) }),
        false => (push_back, Curve::Straight),
    };
    Piece {
        nearest_metres: range.nearest_metres,
        farthest_metres: range.farthest_metres,
        push_back_metres: core + own,
        curve,
        weight: 1.0,
        focus_metres,
    }
}

/// How far to push the eye back so that `share` of the rows lies between `near` and `focus`; infinite where even
/// uniform rows spend less there, 0 where the view's own perspective spends less.
pub(crate) fn push_back_metres(focus: f64, share: f64, near: f64, far: f64) -> f64 {
    // Solve (1/(n+o) - 1/(F+o)) / (1/(n+o) - 1/(f+o)) = q for o.
    let before = focus - near;
    let push_back = if far.is_finite() {
        let excess = share * (far - near) - before;
        if excess <= 0.0 {
            return f64::INFINITY;
        }
        (before * far - share * focus * (far - near)) / excess
    } else {
        focus * (1.0 - share) / share - near / share
    };
    push_back.max(0.0)
}

#[cfg(test)]
mod tests {
    use super::push_back_metres;

    fn share_before(focus: f64, near: f64, far: f64, push_back: f64) -> f64 {
        let row = |distance: f64| 1.0 / (near + push_back) - 1.0 / (distance + push_back);
        row(focus) / row(far)
    }

    #[test]
    fn the_share_of_rows_before_the_focus_is_the_declared_one() {
        for (focus, share, near, far) in [
            (10.0, 0.5, 0.2, 1000.0),
            (10.0, 0.8, 0.2, 1e6),
            (50.0, 0.25, 0.1, f64::INFINITY),
            (2.0, 0.6, 0.1, 30.0),
        ] {
            let push_back = push_back_metres(focus, share, near, far);
            let found = share_before(focus, near, far, push_back);
            assert!((found - share).abs() < 1e-9, "{focus} {share} {near} {far}: {found}");
        }
    }

    #[test]
    fn focuses_out_of_range_stay_at_the_ends() {
        assert_eq!(push_back_metres(600.0, 0.5, 0.2, 1000.0), f64::INFINITY);
        assert_eq!(push_back_metres(0.3, 0.5, 0.2, 1000.0), 0.0);
    }
}
