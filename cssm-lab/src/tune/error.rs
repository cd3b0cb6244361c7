//! What only tuning can have wrong.

/// Why no declaration was chosen.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TuneError {
    /// No variant keeps the budget.
    #[error(
        "no variant keeps {wanted}: the best of {tried}, `{best}`, has {value}, {by} too much; raise the budget, allow \
         larger maps with --max-side, or tune fewer view paths"
    )]
    NoVariant {
        /// The budget in words.
        wanted: String,
        /// How many were tried.
        tried: usize,
        /// What came nearest.
        best: String,
        /// What it has.
        value: String,
        /// By how much it misses the budget.
        by: String,
        /// What it has, in the budget's unit.
        best_value: f64,
    },
    /// No variant can be planned on the views.
    #[error("none of {tried} variants can be planned on these views: {reason}; tune other views")]
    NothingPlanned {
        /// How many were tried.
        tried: usize,
        /// What planning said of the last.
        reason: String,
    },
    /// There is no such path.
    #[error("there is no view path `{name}` on this scene; it has {}; or give `builtin` or a .json file", known.join(", "))]
    NoSuchPath {
        /// What was asked for.
        name: String,
        /// What there is.
        known: Vec<String>,
    },
    /// Views under lights of several kinds.
    #[error("the views lie under lights of several kinds ({}); tune each kind by itself", kinds.join(", "))]
    SeveralLights {
        /// The kinds.
        kinds: Vec<&'static str>,
    },
    /// No pixel can be judged.
    #[error("no pixel of view path `{path}` faces the light; give it other views")]
    NothingFaces {
        /// The path.
        path: String,
    },
}
