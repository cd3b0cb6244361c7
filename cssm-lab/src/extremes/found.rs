//! What was found at the extremes, added up.

use std::collections::BTreeMap;

use cssm_core::PlanError;
use serde::Serialize;

use super::judge::larger;

/// A largest value and where it was found.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Worst {
    /// The value.
    pub value: f64,
    /// The situation; empty if there is none.
    pub place: String,
}

impl Worst {
    /// Takes a value if it is larger.
    pub fn take(&mut self, value: f64, place: &dyn Fn() -> String) {
        if value > self.value {
            *self = Self { value, place: place() };
        }
    }
}

/// How often something happened, and where first.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Count {
    /// How often.
    pub times: u64,
    /// The first situation; empty if there is none.
    pub place: String,
}

impl Count {
    /// Counts one more.
    pub fn add(&mut self, place: &dyn Fn() -> String) {
        if self.times == 0 {
            self.place = place();
        }
        self.times += 1;
    }

    fn merge(&mut self, other: Self) {
        if self.times == 0 {
            self.place = other.place;
        }
        self.times += other.times;
    }
}

/// A kind of refusal.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Refusal {
    /// How often, and where first.
    pub count: Count,
    /// What the first one said.
    pub message: String,
}

/// What a subject did on an axis.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Found {
    /// Plans that were made.
    pub plans: u64,
    /// Plans for lights that their configuration is not made for.
    pub degraded: u64,
    /// Plans that say themselves that they leave receivers out.
    pub incomplete: Count,
    /// Refusals by their kind.
    pub refusals: BTreeMap<String, Refusal>,
    /// Refusals that name no remedy.
    pub without_remedy: Count,
    /// Panics.
    pub panics: Count,
    /// Plans with numbers that are not finite.
    pub not_finite: Count,
    /// Receivers that were asked for.
    pub receivers: u64,
    /// Receivers without a facet.
    pub missing: Count,
    /// Receivers inside several facets.
    pub multiple: Count,
    /// Receivers behind their own facet.
    pub behind: Count,
    /// Receivers for which f32 chose a facet whose tile does not hold them.
    pub outside: Count,
    /// Largest error across the map, texels.
    pub texels: Worst,
    /// Largest error across the map as it would be if the map's longer side had 2048 texels at most.
    pub relative_texels: Worst,
    /// Largest 99th percentile of the depth error of one plan, texels along the light.
    pub depth: Worst,
    /// Largest 95th percentile of the footprint of one plan, pixels, as if maps had 2048 x 2048 texels.
    pub footprint_worst: Worst,
    /// The smallest.
    pub footprint_best: f64,
}

impl Default for Found {
    fn default() -> Self {
        Self {
            plans: 0,
            degraded: 0,
            incomplete: Count::default(),
            refusals: BTreeMap::new(),
            without_remedy: Count::default(),
            panics: Count::default(),
            not_finite: Count::default(),
            receivers: 0,
            missing: Count::default(),
            multiple: Count::default(),
            behind: Count::default(),
            outside: Count::default(),
            texels: Worst::default(),
            relative_texels: Worst::default(),
            depth: Worst::default(),
            footprint_worst: Worst::default(),
            footprint_best: f64::MAX,
        }
    }
}

/// Error across a map of 2048 texels that is aimed at, texels; coordinates of longer maps hold less.
pub const TEXEL_TARGET: f64 = 5e-3;
/// Error across the map that can be seen, texels: a filter blurs by as much.
pub const TEXEL_LIMIT: f64 = 0.5;
/// Share of receivers on slivers of the image, thinner than rounding, that may have no facet of their own.
pub const SLIVER_SHARE: f64 = 1e-4;

impl Found {
    /// Adds what was found elsewhere.
    pub fn merge(&mut self, other: Self) {
        self.plans += other.plans;
        self.degraded += other.degraded;
        self.incomplete.merge(other.incomplete);
        for (kind, refusal) in other.refusals {
            let own = self.refusals.entry(kind).or_default();
            if own.count.times == 0 {
                own.message = refusal.message;
            }
            own.count.merge(refusal.count);
        }
        self.receivers += other.receivers;
        self.without_remedy.merge(other.without_remedy);
        self.panics.merge(other.panics);
        self.not_finite.merge(other.not_finite);
        self.missing.merge(other.missing);
        self.multiple.merge(other.multiple);
        self.behind.merge(other.behind);
        self.outside.merge(other.outside);
        self.texels = larger(std::mem::take(&mut self.texels), other.texels);
        self.relative_texels = larger(std::mem::take(&mut self.relative_texels), other.relative_texels);
        self.depth = larger(std::mem::take(&mut self.depth), other.depth);
        self.footprint_worst = larger(std::mem::take(&mut self.footprint_worst), other.footprint_worst);
        self.footprint_best = self.footprint_best.min(other.footprint_best);
    }

    /// Notes a refusal.
    pub fn refuse(&mut self, error: &PlanError, place: &dyn Fn() -> String) {
        // A variant's name leads its debug text.
        let debug = format!("{error:?}");
        let kind = debug.split(|letter: char| !letter.is_alphanumeric()).next().unwrap_or_default();
        let message = error.to_string();
        if !message.contains(';') {
            self.without_remedy.add(place);
        }
        let refusal = self.refusals.entry(kind.to_owned()).or_default();
        if refusal.count.times == 0 {
            refusal.message = message;
        }
        refusal.count.add(place);
    }

    /// How many refusals there were.
    pub fn refused(&self) -> u64 {
        self.refusals.values().map(|refusal| refusal.count.times).sum()
    }

    /// How many times coarser the worst plan is than the best.
    pub fn blow_up(&self) -> f64 {
        if self.footprint_worst.value > 0.0 { self.footprint_worst.value / self.footprint_best } else { 1.0 }
    }

    /// What is broken, each with the situation; nothing where all holds.
    pub fn breaks(&self) -> Vec<(String, &str)> {
        let mut breaks = Vec::new();
        let counted =
            |what: &str, count: &'_ Count| (count.times > 0).then(|| format!("{} {what}", count.times));
        let rare = |count: &Count| count.times as f64 <= SLIVER_SHARE * self.receivers as f64;
        let plain = [
            ("panics", &self.panics),
            ("plans not finite", &self.not_finite),
            ("refusals without a remedy", &self.without_remedy),
            ("receivers in several facets", &self.multiple),
            ("receivers behind their facet", &self.behind),
        ];
        for (what, count) in plain {
            breaks.extend(counted(what, count).map(|text| (text, count.place.as_str())));
        }
        let lost =
            [("receivers without a facet", &self.missing), ("receivers outside their tile", &self.outside)];
        for (what, count) in lost.into_iter().filter(|(_, count)| !rare(count)) {
            breaks.extend(counted(what, count).map(|text| (text, count.place.as_str())));
        }
        if self.texels.value > TEXEL_LIMIT {
            breaks.push((format!("{:.1e} texels", self.texels.value), self.texels.place.as_str()));
        }
        breaks
    }
}
