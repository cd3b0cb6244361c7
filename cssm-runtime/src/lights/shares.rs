//! Gives every light that the view sees its square of the map.

use super::description::LightDescription;
use super::shadow::Shadow;
use super::share::{Claim, sides, steps_between};
use super::{LightEntry, LightService};

/// Share of the map's texels that squares may take at first: guillotine cuts waste some.
const FIRST_SHARE: f64 = 0.97;
/// What is left of the share after squares of it did not fit.
const SHARE_STEP: f64 = 0.94;
/// Smallest share that is tried.
const LAST_SHARE: f64 = 0.05;

/// Steps of size that are not worth a new plan and a redraw.
const NEARLY_RIGHT_STEPS: usize = 2;

/// How squares follow what is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Rule {
    KeepNearlyRight,
    ShrinkOnly,
    PackAnew,
}

impl Rule {
    /// The side for a shadow that has one and wants another; 0 for none.
    fn side(self, has: u32, wants: u32) -> u32 {
        match self {
            _ if has == 0 || wants == 0 => wants,
            Self::KeepNearlyRight if steps_between(has, wants) <= NEARLY_RIGHT_STEPS => has,
            Self::KeepNearlyRight | Self::PackAnew => wants,
            Self::ShrinkOnly => has.min(wants),
        }
    }
}

/// A shadow that asks for texels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Claimant {
    light: usize,
    shadow: usize,
    /// Side of the square it has, 0 for none.
    side: u32,
}

impl LightService {
    /// Resizes squares by what their shadows ask for. Returns how many had to move although their size stayed.
    pub(super) fn share_map(&mut self) -> u32 {
        let scratch = &mut self.scratch;
        scratch.claims.clear();
        scratch.claimants.clear();
        for (light, entry) in self.lights.iter_mut().enumerate() {
            let Some(served) = &mut entry.light else { continue };
            for (index, shadow) in served.shadows.iter_mut().enumerate() {
                match shadow.pixels_times_side {
                    Some(pixels_times_side) => {
                        scratch.claims.push(claim(&served.description, pixels_times_side));
                        let side = shadow.region().map_or(0, |region| region.width);
                        scratch.claimants.push(Claimant { light, shadow: index, side });
                    }
                    None => shadow.place.take().into_iter().for_each(|place| self.places.give_back(place)),
                }
            }
        }

        // Keep sizes that are nearly right; else let those shrink that have too much; else pack anew, with less and less.
        let map_texels = u64::from(self.layers.main.width()) * u64::from(self.layers.main.height());
        let mut share = FIRST_SHARE;
        let mut moved = 0;
        while share > LAST_SHARE {
            let budget_texels = (map_texels as f64 * share) as u64;
            sides(&scratch.claims, budget_texels, &mut scratch.sides, &mut scratch.queue);
            for rule in [Rule::KeepNearlyRight, Rule::ShrinkOnly, Rule::PackAnew] {
                let sizes = scratch
                    .sides
                    .iter()
                    .zip(&scratch.claimants)
                    .map(|(side, one)| rule.side(one.side, *side));
                scratch.ruled.clear();
                scratch.ruled.extend(sizes);
                let texels: u64 = scratch.ruled.iter().map(|side| u64::from(*side).pow(2)).sum();
                if texels > budget_texels {
                    continue;
                }
                let anew = rule == Rule::PackAnew;
                if anew {
                    moved = scratch.claimants.iter().filter(|claimant| claimant.side > 0).count() as u32;
                }
                if place(&mut self.lights, &mut self.places, &scratch.claimants, &scratch.ruled, anew) {
                    return moved;
                }
            }
            share *= SHARE_STEP;
        }
        moved
    }
}

fn claim(description: &LightDescription, pixels_times_side: f64) -> Claim {
    Claim {
        pixels_times_side,
        priority: description.priority,
        enough_pixels: description.enough_pixels,
        min_side: description.min_side_texels,
        max_side: description.max_side_texels,
    }
}

/// Gives every claimant a square of its side, those that have it keeping theirs unless all are packed anew, large ones
/// first. Returns whether all fit.
fn place(
    lights: &mut [LightEntry],
    places: &mut super::tiles::Places,
    claimants: &[Claimant],
    sides: &[u32],
    anew: bool,
) -> bool {
    fn shadow<'l>(lights: &'l mut [LightEntry], claimant: &Claimant) -> Option<&'l mut Shadow> {
        lights.get_mut(claimant.light)?.light.as_mut()?.shadows.get_mut(claimant.shadow)
    }
    if anew {
        places.clear();
    }
    for (claimant, side) in claimants.iter().zip(sides) {
        let Some(shadow) = shadow(lights, claimant) else { continue };
        if anew {
            shadow.place = None;
        } else if shadow.region().is_some_and(|region| region.width != *side) {
            shadow.place.take().into_iter().for_each(|place| places.give_back(place));
        }
    }
    let mut largest = u32::MAX;
    let mut fits = true;
    while let Some(next) = sides.iter().copied().filter(|side| *side > 0 && *side < largest).max() {
        for (claimant, _) in claimants.iter().zip(sides).filter(|(_, side)| **side == next) {
            let Some(shadow) = shadow(lights, claimant) else { continue };
            if shadow.place.is_none() {
                shadow.place = places.take(next);
                fits &= shadow.place.is_some();
            }
        }
        largest = next;
    }
    fits
}
