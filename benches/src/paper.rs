//! What the camera space paper measured: its table 1, from which its tables 2 and 3 follow.

/// Sides of the paper's maps in texels.
pub const MAP_SIDES_TEXELS: [u32; 5] = [320, 640, 1280, 2560, 5120];

/// The paper's graphics card.
pub const ADAPTER: &str = "ATI Radeon HD 5770";

/// A column of the paper's table 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// Its heading.
    pub name: &'static str,
    /// Frames per second without light.
    pub without_light: f64,
    /// Frames per second with maps of [`MAP_SIDES_TEXELS`].
    pub frames_per_second: [f64; 5],
}

/// One plane without stretching, general view.
pub const STANDARD: Column =
    Column { name: "standard", without_light: 746.0, frames_per_second: [572.0, 541.0, 406.0, 210.0, 70.0] };

/// One plane with exact stretching, general view.
pub const STRETCHED: Column =
    Column { name: "stretched", without_light: 746.0, frames_per_second: [514.0, 398.0, 225.0, 86.0, 28.0] };

/// Four planes, another view that draws more of the palm.
pub const DUELING: Column =
    Column { name: "dueling", without_light: 529.0, frames_per_second: [388.0, 373.0, 316.0, 187.0, 70.0] };

impl Column {
    /// Table 2: frames per second of shadows alone.
    pub fn fictive(&self) -> [f64; 5] {
        self.frames_per_second.map(|frames| 1.0 / (1.0 / frames - 1.0 / self.without_light))
    }

    /// Table 3: what the light adds to a frame without light, as a share of it.
    pub fn increase(&self) -> [f64; 5] {
        self.frames_per_second.map(|frames| self.without_light / frames - 1.0)
    }

    /// How many times as long as another column's shadows its own take.
    pub fn ratio(&self, reference: &Self) -> [f64; 5] {
        let (ours, theirs) = (self.fictive(), reference.fictive());
        std::array::from_fn(|index| theirs[index] / ours[index])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_printed(computed: [f64; 5], printed: [f64; 5], places: f64) {
        for (computed, printed) in computed.into_iter().zip(printed) {
            let rounded = (computed * places).round() / places;
            assert!((rounded - printed).abs() < 1.01 / places, "{computed} is not {printed}");
        }
    }

    #[test]
    fn tables_2_and_3_follow_from_table_1() {
        assert_printed(STANDARD.fictive(), [2452.0, 1969.0, 891.0, 292.0, 77.0], 1.0);
        assert_printed(STRETCHED.fictive(), [1653.0, 853.0, 322.0, 97.0, 29.0], 1.0);
        assert_printed(DUELING.fictive(), [1456.0, 1265.0, 785.0, 289.0, 81.0], 1.0);
        let percent = |column: Column| column.increase().map(|share| 100.0 * share);
        assert_printed(percent(STANDARD), [30.42, 37.89, 83.74, 255.24, 965.71], 100.0);
        assert_printed(percent(STRETCHED), [45.14, 87.44, 231.56, 767.44, 2564.29], 100.0);
        assert_printed(percent(DUELING), [36.34, 41.82, 67.41, 182.89, 655.71], 100.0);
    }

    #[test]
    fn stretching_costs_three_times_as_much_on_large_maps() {
        let [.., at_2560, _] = STRETCHED.ratio(&STANDARD);
        assert!((at_2560 - 3.0).abs() < 0.05, "{at_2560}");
    }
}
