//! Areas that make footprints agree.

use super::strips::{self, Partition, Wish};
use super::{Gram, MapArea, TileDemand};
use crate::facet::Tile;
use crate::plan::PlanError;
use crate::technique::TileRequest;

/// Rounds of area balancing; the change after the last is below a percent.
const ROUNDS: u32 = 6;

pub(super) fn place(demands: &[TileDemand], area: &MapArea) -> Result<Vec<Tile>, PlanError> {
    let gutters = 2.0 * f64::from(area.gutter);
    let total = f64::from(area.width) * f64::from(area.height);
    let fits: Vec<Fit> = demands.iter().map(|demand| Fit::new(demand, total)).collect();

    // Try upright and lying strips and keep the better.
    let orientations = if area.strips.is_some() { &[true][..] } else { &[true, false][..] };
    let mut best: Option<(f64, Vec<Tile>)> = None;
    for upright in orientations {
        let mut areas = wished_areas(&fits, total);
        let along = f64::from(if *upright { area.height } else { area.width });
        let wishes: Vec<Wish> =
            fits.iter().zip(&areas).map(|(fit, area)| fit.wish(*area, *upright)).collect();
        let partition = strips::partition(&wishes, along, area.strips);
        balance(&fits, &partition, &mut areas, along, gutters, *upright);
        let Some(tiles) = strips::tiles(&partition, &areas, area, *upright) else { continue };
        let score = score(demands, &fits, &tiles);
        if best.as_ref().is_none_or(|(least, _)| score < *least) {
            best = Some((score, tiles));
        }
    }
    best.map(|(_, tiles)| tiles).ok_or_else(|| area.too_small(demands.len()))
}

/// What is known of one facet's shape.
struct Fit<'a> {
    samples: &'a [Gram],
    /// Height / width of the best tile.
    aspect: f64,
    /// Area in texels for a footprint of one pixel, or a share of the map.
    weight: f64,
    balanced: bool,
}

impl<'a> Fit<'a> {
    fn new(demand: &'a TileDemand, total: f64) -> Self {
        let samples = &demand.samples[..];
        match demand.request {
            TileRequest::Share(share) => {
                Self { samples, aspect: 1.0, weight: share * total, balanced: false }
            }
            TileRequest::Fixed(width, height) => Self {
                samples,
                aspect: f64::from(height) / f64::from(width),
                weight: f64::from(width) * f64::from(height),
                balanced: false,
            },
            TileRequest::Footprint => {
                let aspect = best_aspect(samples);
                let side = mean_footprint(samples, 1.0, aspect);
                Self { samples, aspect, weight: side * side * aspect, balanced: true }
            }
        }
    }

    fn wish(&self, area: f64, upright: bool) -> Wish {
        let across = if upright { (area / self.aspect).sqrt() } else { (area * self.aspect).sqrt() };
        Wish { area, across }
    }
}

fn wished_areas(fits: &[Fit<'_>], total: f64) -> Vec<f64> {
    let sum: f64 = fits.iter().map(|fit| fit.weight).sum();
    fits.iter().map(|fit| fit.weight / sum * total).collect()
}

/// Moves area from facets with small footprints to those with large ones, strips kept.
fn balance(
    fits: &[Fit<'_>],
    partition: &Partition,
    areas: &mut [f64],
    along: f64,
    gutters: f64,
    upright: bool,
) {
    if !fits.iter().all(|fit| fit.balanced) {
        return;
    }
    let total: f64 = areas.iter().sum();
    for _ in 0..ROUNDS {
        for strip in partition {
            let across: f64 = strip.iter().map(|index| areas[*index]).sum::<f64>() / along;
            for index in strip {
                let length = areas[*index] / across;
                let (width, height) = if upright { (across, length) } else { (length, across) };
                let inner = |side: f64| (side - gutters).max(1.0);
                let footprint = mean_footprint(fits[*index].samples, inner(width), inner(height));
                // Footprint falls with about the square root of the area.
                areas[*index] *= libm::pow(footprint, 1.5);
            }
        }
        let sum: f64 = areas.iter().sum();
        for area in areas.iter_mut() {
            *area *= total / sum;
        }
    }
}

/// Largest mean footprint of the placed tiles; the misfit of aspects where facets ask for shares.
fn score(demands: &[TileDemand], fits: &[Fit<'_>], tiles: &[Tile]) -> f64 {
    let one = |((demand, fit), tile): ((&TileDemand, &Fit<'_>), &Tile)| {
        let inner = |side: u32| f64::from(side - 2 * tile.gutter);
        let (width, height) = (inner(tile.width), inner(tile.height));
        match demand.request {
            TileRequest::Footprint => mean_footprint(fit.samples, width, height),
            _ => libm::fabs(libm::log(height / width / fit.aspect)),
        }
    };
    demands.iter().zip(fits).zip(tiles).map(one).fold(0.0, f64::max)
}

/// Power mean of the texels' major axes in pixels.
fn mean_footprint(samples: &[Gram], width: f64, height: f64) -> f64 {
    power_mean(samples.iter().map(|sample| sample.major_pixels_squared(width, height)))
}

/// Power mean of lengths given squared, exponent 16: it stands for the largest footprints of a facet, is smooth and lies
/// near the 95th percentile. Multiplied out, so that every platform finds the same tiles.
fn power_mean(squares: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = squares.len().max(1) as f64;
    let square = |value: f64| value * value;
    let sum: f64 = squares.map(|length| square(square(square(length)))).sum();
    libm::pow((sum / count).max(f64::MIN_POSITIVE), 1.0 / 16.0)
}

/// Height / width that makes the mean footprint smallest at equal area, by golden section in its logarithm.
fn best_aspect(samples: &[Gram]) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    const STEPS: u32 = 10;
    const REACH: f64 = 1.2;
    let (up, across) = (
        power_mean(samples.iter().map(|sample| sample.yy)),
        power_mean(samples.iter().map(|sample| sample.xx)),
    );
    let start = libm::log(up / across);
    let footprint = |logarithm: f64| {
        let side = libm::exp(0.5 * logarithm);
        mean_footprint(samples, 1.0 / side, side)
    };
    let (mut low, mut high) = (start - REACH, start + REACH);
    let (mut one, mut two) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_one, mut at_two) = (footprint(one), footprint(two));
    for _ in 0..STEPS {
        if at_one < at_two {
            (high, two, at_two) = (two, one, at_one);
            one = high - GOLDEN * (high - low);
            at_one = footprint(one);
        } else {
            (low, one, at_one) = (one, two, at_two);
            two = low + GOLDEN * (high - low);
            at_two = footprint(two);
        }
    }
    libm::exp(0.5 * (low + high))
}
