//! Reference figures: what an f64 prototype of every technique measured under the same lights, with 2048 x 2048 texels, a
//! field of view of 60 degrees, 1080 lines, near 0.2 m, far 1000 m and a focus of 10 m. Tiles of the prototype
//! are not whole texels and have no gutters.

use super::figures::Figures;
use super::grid::Class;

/// Reference figures of one case; NaN where none was measured.
#[derive(Debug, Clone, Copy)]
pub struct Reference {
    /// Under light from 45 degrees and higher.
    pub general: [f64; 8],
    /// p95 and p95 on the ground under light from just outside the view.
    pub border: [f64; 2],
    /// Median, p95, largest, geometric p95, p95 on the ground, utilisation under light in or opposite the view.
    pub dueling: [f64; 6],
}

const NO: f64 = f64::NAN;

impl Reference {
    /// Nothing was measured.
    pub const NONE: Self = Self { general: [NO; 8], border: [NO; 2], dueling: [NO; 6] };

    /// The figures of a class of lights.
    pub const fn figures(&self, class: Class) -> Figures {
        let ([border_p95, border_ground], [median, p95, max, geometric, ground, used]) =
            (self.border, self.dueling);
        Figures::from_array(match class {
            Class::General => self.general,
            Class::Border => [NO, border_p95, NO, NO, NO, NO, border_ground, NO],
            Class::Dueling => [median, p95, NO, max, geometric, NO, ground, used],
            Class::Side => [NO; 8],
        })
    }
}

/// One uniform map.
pub const STANDARD: Reference = Reference {
    general: [40.2, 1845.0, 2574.0, 2797.0, 1759.0, 99.4, 200.0, 0.64],
    border: [1737.0, 215.0],
    dueling: [37.9, 1737.0, 2632.0, 1707.0, 426.0, 1.0],
};

/// The box of least area.
pub const BOUNDING_BOX: Reference = Reference {
    general: [40.4, 1851.0, 2582.0, 2806.0, 1736.0, 99.4, 200.0, 0.65],
    border: [1737.0, 215.0],
    dueling: [37.9, 1737.0, 2632.0, 1707.0, 426.0, 1.0],
};

/// A trapezoid with up to 80 % of its rows before the focus.
pub const TRAPEZOIDAL: Reference = Reference {
    general: [5.33, 119.0, 185.0, 256.0, 8.96, 1.09, 1.43, 0.53],
    border: [95.1, 5.35],
    dueling: [41.6, 1905.0, 2887.0, 1680.0, 384.0, 0.86],
};

/// Light space perspective; under light in the view the prototype had no fallback.
pub const LIGHT_SPACE_PERSPECTIVE: Reference = Reference {
    general: [5.34, 37.3, 51.7, 56.2, 29.3, 2.97, 5.00, 0.51],
    border: [283.0, 30.1],
    dueling: [NO; 6],
};

/// Generalized linear; under light in the view the prototype had no fallback.
pub const GENERALIZED_LINEAR: Reference = Reference {
    general: [33.8, 1545.0, 2318.0, 3355.0, 32.4, 4.26, 5.16, 0.90],
    border: [635.0, 5.59],
    dueling: [NO; 6],
};

/// Post-projective space without a slide.
pub const PERSPECTIVE: Reference = Reference {
    general: [38.0, 1774.0, 2884.0, 4023.0, 34.6, 4.84, 5.76, 0.97],
    border: [4829.0, 34.5],
    dueling: [116.0, 5320.0, 8065.0, 4756.0, 3902.0, 0.38],
};

/// Post-projective space with the eye slid back for the focus.
pub const PERSPECTIVE_SLID: Reference = Reference {
    general: [5.42, 32.4, 46.5, 64.5, 18.1, 2.04, 3.24, 0.51],
    border: [102.0, 12.6],
    dueling: [41.8, 1907.0, 2891.0, 1694.0, 375.0, 0.81],
};

/// Two logarithmic splits.
pub const SPLIT_2: Reference = Reference {
    general: [6.63, 45.0, 54.0, 56.0, 43.0, 2.82, 42.7, 0.65],
    border: [42.5, 44.0],
    dueling: [6.25, 42.5, 52.7, 41.8, 56.9, 1.0],
};

/// Three logarithmic splits.
pub const SPLIT_3: Reference = Reference {
    general: [4.13, 14.5, 16.0, 16.5, 13.7, 7.75, 16.8, 0.66],
    border: [13.7, 17.9],
    dueling: [3.91, 13.7, 15.6, 13.5, 33.7, 1.0],
};

/// Four logarithmic splits.
pub const SPLIT_4: Reference = Reference {
    general: [3.27, 8.28, 9.07, 9.3, 7.74, 3.60, 7.57, 0.68],
    border: [7.90, 7.8],
    dueling: [3.12, 7.90, 8.9, 7.77, 13.0, 1.0],
};

/// Four practical splits with equal weights.
pub const SPLIT_4_PRACTICAL: Reference = Reference {
    general: [10.1, 465.0, 648.0, 704.0, 443.0, 25.0, 50.3, 0.69],
    border: [437.0, 54.0],
    dueling: [9.54, 437.0, 663.0, 430.0, 107.0, 1.0],
};

/// One plane, not stretched.
pub const ONE_PLANE: Reference = Reference {
    general: [5.38, 33.9, 44.2, 53.8, 21.6, 2.37, 3.82, 0.51],
    border: [166.0, 18.7],
    dueling: [NO; 6],
};

/// One plane, stretched.
pub const ONE_PLANE_STRETCHED: Reference = Reference {
    general: [4.74, 26.3, 38.2, 52.9, 4.69, 0.88, 1.59, 0.98],
    border: [20.3, 4.3],
    dueling: [NO; 6],
};

/// One plane, stretched, in a map four times as high as wide.
pub const ONE_PLANE_STRETCHED_LONG: Reference = Reference {
    general: [2.45, 13.1, 19.1, 26.5, 4.69, 1.53, 1.68, 0.98],
    border: [14.3, 8.6],
    dueling: [NO; 6],
};

/// One plane with logarithmic rows.
pub const ONE_PLANE_LOGARITHMIC: Reference = Reference {
    general: [4.03, 5.03, 5.61, 6.2, 2.06, 1.23, 2.38, 0.95],
    border: [6.93, 4.4],
    dueling: [NO; 6],
};

/// One plane with logarithmic rows in a map four times as high as wide.
pub const ONE_PLANE_LOGARITHMIC_LONG: Reference = Reference {
    general: [2.10, 2.61, 2.88, 3.2, 2.06, 1.55, 1.75, 0.95],
    border: [13.4, 8.6],
    dueling: [NO; 6],
};

/// Four planes that meet at the near plane.
pub const FOUR_PLANE_NEAR: Reference =
    Reference { dueling: [16.4, 1008.0, 3682.0, 18.9, 21.8, 1.0], ..Reference::NONE };

/// Four planes that meet at the focus.
pub const FOUR_PLANE: Reference =
    Reference { border: [24.6, NO], dueling: [3.69, 24.4, 73.4, 17.5, 6.8, 1.0], ..Reference::NONE };

/// Face columns with logarithmic rows.
pub const FACES_LOGARITHMIC: Reference = Reference {
    general: [1.82, 2.39, 2.67, 3.1, 1.79, 1.61, 1.86, 1.0],
    border: [3.90, 2.5],
    dueling: [2.11, 3.87, 8.2, 2.29, 6.6, 1.0],
};

/// Face columns with eight bands; p95 with tiles that know of the bands' loss.
pub const FACES_8: Reference = Reference {
    general: [1.92, 2.86, 4.05, 5.0, 2.25, 1.61, 1.92, 0.99],
    border: [3.85, 2.6],
    dueling: [2.18, 3.84, 9.5, 2.79, 8.1, 0.94],
};

/// Face columns with sixteen bands.
pub const FACES_16: Reference = Reference {
    general: [1.85, 2.66, 3.33, 4.1, 1.97, 1.61, 1.86, 0.99],
    border: [4.22, 2.5],
    dueling: [2.13, 4.28, 11.7, 2.41, 6.7, 0.97],
};

/// Of one figure alone: p95 under light from 45 degrees and higher.
pub const fn general_p95(p95: f64) -> Reference {
    Reference { general: [NO, p95, NO, NO, NO, NO, NO, NO], ..Reference::NONE }
}
