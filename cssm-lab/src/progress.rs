//! Progress of long work, on a terminal only.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// Bars with fewer steps per second than the eye sees are redrawn this often.
const REDRAW: Duration = Duration::from_millis(120);

/// Shows what is being done and how far it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// Draws bars on the terminal's error stream, if it is a terminal.
    Shown,
    /// Draws nothing.
    Hidden,
}

impl Progress {
    /// A bar over a number of steps.
    pub fn bar(self, steps: u64, doing: &str) -> ProgressBar {
        let style = ProgressStyle::with_template("{msg:32} {bar:40} {percent:>3} %  {elapsed}");
        self.with_style(ProgressBar::new(steps), style, doing)
    }

    /// A sign of life for work without steps.
    pub fn spinner(self, doing: &str) -> ProgressBar {
        self.with_style(
            ProgressBar::new_spinner(),
            ProgressStyle::with_template("{msg:32} {spinner}  {elapsed}"),
            doing,
        )
    }

    fn with_style(
        self,
        bar: ProgressBar,
        style: Result<ProgressStyle, indicatif::style::TemplateError>,
        doing: &str,
    ) -> ProgressBar {
        if self == Self::Hidden {
            return ProgressBar::hidden();
        }
        // A template that does not parse leaves the plain style.
        let bar = match style {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        };
        bar.set_message(doing.to_owned());
        bar.enable_steady_tick(REDRAW);
        bar
    }
}
