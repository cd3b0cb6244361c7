//! `cssm-lab measure`: which technique, at which settings, for a scene and a budget.
//!
//! Every case is judged on the same traced views at equal texels. [`paths`] says where to stand and which light shines,
//! [`variants`] lists what there is to compare, [`mod@bench`] traces the views once, [`evaluate`] judges a case on them;
//! [`results`] keeps everything, [`pareto`] and [`verdict`] say what is best, [`plot`] and [`html`] show it.

pub mod bench;
pub mod cells;
pub mod command;
pub mod counts;
pub mod error;
pub mod evaluate;
pub mod html;
pub mod pareto;
pub mod paths;
pub mod plot;
pub mod results;
pub mod summary;
pub mod variants;
pub mod verdict;

mod tally;
