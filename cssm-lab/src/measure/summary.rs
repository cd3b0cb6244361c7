//! The results as a table for the terminal.

use super::results::{Overall, Results};
use super::verdict::{MEASURES, contests, subject};

/// Losses that are written out; the report holds all.
const LOSSES: usize = 12;

/// Every case at every size, best first, and where the house's own technique loses.
pub fn text(results: &Results) -> String {
    let mut rows = results.overall();
    rows.sort_by(|one, two| {
        (one.side, one.filter).cmp(&(two.side, two.filter)).then(one.mismatch.total_cmp(&two.mismatch))
    });
    let mut out = format!(
        "{:<52} {:>5} {:<12} {:>9} {:>9} {:>9} {:>9} {:>10}\n",
        "case", "side", "filter", "mismatch", "interior", "p95 px", "flicker", "triangles"
    );
    for row in &rows {
        out += &line(row);
    }
    for measure in MEASURES {
        let contests = contests(results, measure);
        let lost: Vec<String> = contests
            .iter()
            .flat_map(|contest| {
                contest.losses().map(move |(rival, lead)| {
                    let (label, value) = rival.best.unwrap_or_default();
                    format!(
                        "  loses {}: {} at {}, {}: {} against {} of {label} ({lead:.2}x)\n",
                        measure.name(),
                        contest.path,
                        contest.side,
                        contest.filter,
                        measure.text(contest.subject),
                        measure.text(value)
                    )
                })
            })
            .collect();
        let pairs: usize = contests
            .iter()
            .map(|contest| contest.rivals.iter().filter(|rival| rival.best.is_some()).count())
            .sum();
        if let Some(subject) = subject(results).filter(|_| pairs > 0) {
            out += &format!(
                "{}: {} is worse in {} of {pairs} comparisons with the best of another technique\n",
                measure.name(),
                subject.label,
                lost.len()
            );
            lost.iter().take(LOSSES).for_each(|line| out += line);
        }
    }
    out
}

fn line(row: &Overall<'_>) -> String {
    let refused = if row.complete { "" } else { "  some stations refused" };
    if row.cells.iter().all(|cell| cell.found.figures.is_none()) {
        return format!("{:<52} {:>5} {:<12} refused everywhere\n", row.case.label, row.side, row.filter);
    }
    let flicker = row.flicker.map_or_else(|| "-".to_owned(), |flicker| format!("{:.3} %", 100.0 * flicker));
    format!(
        "{:<52} {:>5} {:<12} {:>7.3} % {:>9.1e} {:>9.2} {flicker:>9} {:>10.0}{refused}\n",
        row.case.label,
        row.side,
        row.filter,
        100.0 * row.mismatch,
        row.interior,
        row.footprint_p95,
        row.triangles
    )
}
