//! Lists that fitting drafts to the map works in.

use super::texels::Texels;
use super::window::Sample;
use crate::layout::{Gram, Layout, Placement, TileDemand};

/// What fitting one draft after the other works in.
#[derive(Debug, Default)]
pub(crate) struct Fitting {
    pub(super) known: Known,
    pub(super) layout: Layout,
    /// What each tile asks for.
    pub(super) demands: Vec<TileDemand>,
    /// The demand of each window.
    pub(super) sharing: Vec<u32>,
    pub(super) placed: Vec<Placement>,
    /// Texels of each window.
    pub(super) texels: Vec<Texels>,
    pub(super) squares: Vec<f64>,
    pub(super) weighted: Vec<(f64, f64)>,
}

/// What samples of the view tell of one window.
#[derive(Debug, Default)]
pub(super) struct Known {
    pub(super) samples: Vec<Sample>,
    pub(super) grams: Vec<Gram>,
    pub(super) values: Vec<f64>,
}
