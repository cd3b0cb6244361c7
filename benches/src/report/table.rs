//! Markdown tables of numbers.

use cssm_lab::timing::Interval;

/// A table in the making.
#[derive(Debug)]
pub(super) struct Table {
    columns: usize,
    lines: Vec<String>,
}

impl Table {
    /// A table with headings.
    pub(super) fn new(headings: impl IntoIterator<Item = String>) -> Self {
        let headings: Vec<_> = headings.into_iter().collect();
        let rule = vec!["---"; headings.len()].join("|");
        let lines = vec![format!("| {} |", headings.join(" | ")), format!("|{rule}|")];
        Self { columns: headings.len(), lines }
    }

    /// Adds a row; cells that are left out stay empty.
    pub(super) fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        let mut cells: Vec<_> = cells.into_iter().collect();
        cells.resize(self.columns, String::new());
        self.lines.push(format!("| {} |", cells.join(" | ")));
    }

    /// The table as text.
    pub(super) fn markdown(self) -> String {
        self.lines.join("\n") + "\n"
    }
}

/// A median with its interval.
pub(super) fn with_interval(interval: &Interval, decimals: usize) -> String {
    let Interval { median, low, high } = *interval;
    format!("{} [{}, {}]", times(median, decimals), times(low, decimals), times(high, decimals))
}

/// A number with so many decimals, none where it is large.
pub(super) fn times(value: f64, decimals: usize) -> String {
    let decimals = if value.abs() >= 100.0 { 0 } else { decimals };
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_filled_up() {
        let mut table = Table::new(["a", "b"].map(str::to_owned));
        table.row(["x".to_owned()]);
        assert_eq!(table.markdown(), "| a | b |\n|---|---|\n| x |  |\n");
    }

    #[test]
    fn large_numbers_have_no_decimals() {
        let interval = Interval { median: 1.234, low: 0.5, high: 123.456 };
        assert_eq!(with_interval(&interval, 2), "1.23 [0.50, 123]");
    }
}
