//! How many pixels see each depth, and where on the screen.
//!
//! Bins are quarters of octaves of depth from the near plane on: a bin is the exponent and the two leading bits of the
//! mantissa of depth / near as a 32-bit float, so that every processor bins alike.

use crate::view::View;

/// Number of bins: sixteen octaves; what is farther falls into the last.
pub const BINS: usize = 64;
/// Bits of a float below those that name its bin.
const BIN_SHIFT: u32 = 21;
/// Those bits of 1.
const FIRST: u32 = 127 << 2;

/// Numbers that the generated reduction writes: two, and five of each bin.
pub const WORDS: usize = 2 + 5 * BINS;
/// Side of the square of pixels that one of its workgroups measures.
pub const SQUARE_PIXELS: u32 = 64;

/// Depths measured in one frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthHistogram {
    /// The view they were measured in. Bins begin at its near plane.
    pub view: View,
    /// Frames between the measurement and the frame that is planned; 0: they are the same, and nothing is visible that was
    /// not measured.
    pub latency_frames: u32,
    /// Smallest depth of a pixel.
    pub nearest_metres: f64,
    /// Largest depth of a pixel that is not sky.
    pub farthest_metres: f64,
    /// Bins, nearest first; sky is in none.
    pub bins: [DepthBin; BINS],
}

/// Pixels of similar depth.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DepthBin {
    /// How many pixels; a fraction where frames are blended.
    pub pixels: f64,
    /// The rectangle that holds them, in pixels from the upper left corner of the image: left, upper, right and lower edge.
    pub rectangle_pixels: [f64; 4],
}

/// Bin of a depth, by its ratio to the near plane's.
pub fn bin(depth_over_near: f32) -> usize {
    let bits = depth_over_near.max(1.0).to_bits() >> BIN_SHIFT;
    (bits.saturating_sub(FIRST) as usize).min(BINS - 1)
}

/// Depths where a bin begins and ends, given the near plane's.
pub fn bin_range_metres(bin: usize, near_metres: f64) -> (f64, f64) {
    let edge = |bin: usize| near_metres * f64::from(f32::from_bits((FIRST + bin as u32) << BIN_SHIFT));
    (edge(bin), edge(bin + 1))
}

impl DepthHistogram {
    /// No pixel measured yet.
    pub fn empty(view: &View) -> Self {
        Self {
            view: *view,
            latency_frames: 0,
            nearest_metres: f64::INFINITY,
            farthest_metres: 0.0,
            bins: [DepthBin::default(); BINS],
        }
    }

    /// Measures an image of depths in metres along the view axis, row by row from the upper left corner; 0 or less,
    /// infinite and NaN are sky. The processor's way to what the generated reduction does.
    pub fn measure(view: &View, depths_metres: impl IntoIterator<Item = f32>) -> Self {
        let mut histogram = Self::empty(view);
        let width = view.size_pixels.0.max(1) as usize;
        let per_near = (1.0 / view.near_metres) as f32;
        for (index, depth) in depths_metres.into_iter().enumerate() {
            if depth > 0.0 && depth.is_finite() {
                let metres = f64::from(depth);
                histogram.nearest_metres = histogram.nearest_metres.min(metres);
                histogram.farthest_metres = histogram.farthest_metres.max(metres);
                let (x, y) = ((index % width) as f64, (index / width) as f64);
                histogram.bins[bin(depth * per_near)].add([x, y, x + 1.0, y + 1.0]);
            }
        }
        histogram
    }

    /// Reads the numbers that the generated reduction wrote for a view (see `fit.wgsl`): the complement of the smallest
    /// depth's bits and the bits of the largest; then of each bin the pixels, the complements of the left and the upper
    /// edge of their rectangle, its right and its lower edge. Numbers that are missing count as zero.
    pub fn of_words(view: &View, words: &[u32]) -> Self {
        let word = |index: usize| words.get(index).copied().unwrap_or(0);
        let mut histogram = Self::empty(view);
        if word(1) > 0 {
            histogram.nearest_metres = f64::from(f32::from_bits(!word(0)));
            histogram.farthest_metres = f64::from(f32::from_bits(word(1)));
        }
        for (index, bin) in histogram.bins.iter_mut().enumerate() {
            let first = 2 + 5 * index;
            if word(first) > 0 {
                let edges = [!word(first + 1), !word(first + 2), word(first + 3), word(first + 4)];
                *bin = DepthBin { pixels: f64::from(word(first)), rectangle_pixels: edges.map(f64::from) };
            }
        }
        histogram
    }

    /// Pixels that are not sky.
    pub fn pixels(&self) -> f64 {
        self.bins.iter().map(|bin| bin.pixels).sum()
    }

    /// Whether there is anything in it, and nothing that makes no sense.
    pub fn is_usable(&self) -> bool {
        let sound = |bin: &DepthBin| {
            let [left, upper, right, lower] = bin.rectangle_pixels;
            bin.pixels == 0.0 || (bin.pixels > 0.0 && bin.pixels.is_finite() && left < right && upper < lower)
        };
        let range = self.nearest_metres > 0.0
            && self.nearest_metres <= self.farthest_metres
            && self.farthest_metres.is_finite();
        range && self.bins.iter().all(sound) && self.pixels() > 0.0
    }

    /// The next histogram, of which a share of `rate` is taken and the rest is the previous one's: a filter over frames
    /// that bounds how fast plans change. A function of its inputs alone. After a cut of the camera, start anew instead.
    pub fn blended(&self, next: &Self, rate: f64) -> Self {
        let rate = if rate >= 0.0 { rate.min(1.0) } else { 1.0 };
        if !self.is_usable() || !next.is_usable() || self.view.near_metres != next.view.near_metres {
            return *next;
        }
        let geometric = |one: f64, two: f64| one * libm::pow(two / one, rate);
        let mut blended = *next;
        blended.nearest_metres = geometric(self.nearest_metres, next.nearest_metres);
        blended.farthest_metres = geometric(self.farthest_metres, next.farthest_metres);
        for (bin, before) in blended.bins.iter_mut().zip(&self.bins) {
            *bin = before.blended(bin, rate);
        }
        blended
    }

    /// The same pixels, of which only the smallest and the largest depth is known: as many in every octave between, all
    /// over the image.
    pub(crate) fn range_alone(&self) -> Self {
        let (width, height) = self.view.size_pixels;
        let image = [0.0, 0.0, f64::from(width), f64::from(height)];
        let mut flat = *self;
        for index in 0..BINS {
            let part =
                self.part(index).map_or(0.0, |(low, high)| libm::log(high / low).max(f64::MIN_POSITIVE));
            flat.bins[index] = DepthBin { pixels: part, rectangle_pixels: image };
        }
        flat
    }

    /// Depths that pixels of a bin can have, within the smallest and the largest measured.
    pub(crate) fn part(&self, index: usize) -> Option<(f64, f64)> {
        let (low, high) = bin_range_metres(index, self.view.near_metres);
        let low = if index == 0 { self.nearest_metres } else { low.max(self.nearest_metres) };
        let high = if index + 1 == BINS { self.farthest_metres } else { high.min(self.farthest_metres) };
        (low <= high).then_some((low, high))
    }
}

impl DepthBin {
    fn add(&mut self, pixel: [f64; 4]) {
        let [left, upper, right, lower] = if self.pixels > 0.0 { self.rectangle_pixels } else { pixel };
        self.pixels += 1.0;
        self.rectangle_pixels =
            [left.min(pixel[0]), upper.min(pixel[1]), right.max(pixel[2]), lower.max(pixel[3])];
    }

    fn blended(&self, next: &Self, rate: f64) -> Self {
        let pixels = self.pixels + (next.pixels - self.pixels) * rate;
        let rectangle = match (self.pixels > 0.0, next.pixels > 0.0) {
            (true, true) => std::array::from_fn(|edge| {
                let (one, two) = (self.rectangle_pixels[edge], next.rectangle_pixels[edge]);
                one + (two - one) * rate
            }),
            (true, false) => self.rectangle_pixels,
            _ => next.rectangle_pixels,
        };
        Self { pixels, rectangle_pixels: rectangle }
    }
}
