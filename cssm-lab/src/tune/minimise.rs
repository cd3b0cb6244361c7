//! The third stage: everything goes that the views can do without.
//!
//! Features are taken away one at a time; what breaks no promise stays away. It ends only when every single removal that
//! is left has been measured on the final declaration and breaks the promise: those measurements are the evidence.

use cssm_core::LightCase;

use super::bench::{Bench, Errors, Measured};
use super::budget::Promise;
use super::features::{additions, removals};
use super::search::Found;
use crate::gpu::ResolveMethod;
use crate::progress::Progress;

/// A declaration with nothing to spare, and the evidence.
#[derive(Debug, Clone, PartialEq)]
pub struct Minimal {
    /// The declaration.
    pub case: LightCase,
    /// What it has.
    pub errors: Errors,
    /// What was taken away, in order.
    pub left_out: Vec<Evidence>,
    /// What could not be taken away; each was measured on the final declaration.
    pub needed: Vec<Evidence>,
    /// Configurations that it never declared: with them, the error would be so much.
    pub not_added: Vec<Evidence>,
}

/// What one removal does.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// What is removed.
    pub what: String,
    /// Error and mismatch with it.
    pub with: (f64, f64),
    /// What is without it.
    pub without: Without,
}

/// What is left when a feature is taken away.
#[derive(Debug, Clone, PartialEq)]
pub enum Without {
    /// Error and mismatch.
    Measured(f64, f64),
    /// Nothing that can be declared, or planned on every view.
    Impossible(String),
}

impl Without {
    /// Whether a promise is kept.
    pub fn keeps(&self, promise: &Promise) -> bool {
        match self {
            Self::Measured(error, mismatch) => *error <= promise.limit && *mismatch <= promise.mismatch_limit,
            Self::Impossible(_) => false,
        }
    }
}

/// Takes away from what was found.
pub fn minimise(
    bench: &mut Bench<'_, '_>,
    found: &Found,
    interface: ResolveMethod,
    progress: Progress,
) -> Minimal {
    let Found { case, errors, promise, .. } = found;
    let (mut case, mut errors) = (case.clone(), errors.clone());
    let mut left_out = Vec::new();
    let spinner = progress.spinner("leaving out what is not needed");

    // Go through the list until nothing more can go; what went from a list may come again, one less.
    'again: loop {
        for removal in removals(&case, interface) {
            let Ok(less) = removal.without else { continue };
            let Measured::Whole(found) = bench.measure(&less, Some(promise)) else { continue };
            if Measured::Whole(found.clone()).keeps(promise) {
                let with = (errors.error, errors.mismatch);
                let without = Without::Measured(found.error, found.mismatch);
                left_out.push(Evidence { what: removal.what, with, without });
                (case, errors) = (less, found);
                continue 'again;
            }
        }
        break;
    }

    // Measure in full what each of the others would break.
    let with = (errors.error, errors.mismatch);
    let needed = removals(&case, interface).into_iter().map(|removal| {
        let without = without(bench, removal.without);
        Evidence { what: removal.what, with, without }
    });
    let needed = needed.collect();
    let not_added = additions(&case).into_iter().map(|(name, more)| {
        let with = match without(bench, more) {
            Without::Measured(error, mismatch) => (error, mismatch),
            Without::Impossible(_) => (f64::NAN, f64::NAN),
        };
        let what = format!("configuration {name}");
        Evidence { what, with, without: Without::Measured(errors.error, errors.mismatch) }
    });
    let not_added = not_added.filter(|evidence| !evidence.with.0.is_nan()).collect();
    spinner.finish_and_clear();
    Minimal { case, errors, left_out, needed, not_added }
}

/// What a removal leaves, measured in full.
pub fn without(bench: &mut Bench<'_, '_>, case: Result<LightCase, String>) -> Without {
    match case {
        Err(reason) => Without::Impossible(reason),
        Ok(case) => match bench.measure(&case, None) {
            Measured::Whole(errors) => Without::Measured(errors.error, errors.mismatch),
            Measured::Unplannable { reason } => Without::Impossible(reason),
            Measured::Broken { at_least } => Without::Measured(at_least, f64::NAN),
        },
    }
}
