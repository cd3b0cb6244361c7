//! Tables of the report.

use maud::{Markup, html};

use crate::measure::evaluate::Figures;
use crate::measure::plot::{costs, on_front};
use crate::measure::results::{Cell, Overall, Results};
use crate::measure::verdict::{Contest, MEASURES, Measure, contests, rival_techniques, subject};

/// The house's case against the best of every other technique: how many times more the other has; red where less.
pub(super) fn verdict(results: &Results) -> Markup {
    let Some(subject) = subject(results) else {
        return html! { p { "The house's own technique takes no part." } };
    };
    let techniques = rival_techniques(results, subject);
    if techniques.is_empty() {
        return html! { p { "No other technique takes part." } };
    }
    html! {
        p {
            "On each path at equal texels: what " b { (subject.label) } " has, and how many times as much the "
            "best variant of each other technique has. Below 1, in red, the other is better."
        }
        @for measure in MEASURES {
            @let contests = contests(results, measure);
            @if !contests.is_empty() {
                h3 { (measure.name()) }
                (tally(&contests, measure, subject.label.as_str()))
                details open[measure == Measure::Mismatch] {
                    summary { "path by path" }
                    div class="wide" { table {
                        tr {
                            th { "path" } th { "side" } th { "filter" } th { (subject.label) }
                            @for technique in &techniques { th { (technique) } }
                        }
                        @for contest in &contests { (contest_row(contest, measure)) }
                    } }
                }
            }
        }
    }
}

fn tally(contests: &[Contest<'_>], measure: Measure, label: &str) -> Markup {
    let pairs: usize = contests
        .iter()
        .map(|contest| contest.rivals.iter().filter(|rival| rival.best.is_some()).count())
        .sum();
    let lost: usize = contests.iter().map(|contest| contest.losses().count()).sum();
    html! {
        @if lost > 0 {
            p class="loses" {
                (label) " has more " (measure.name()) " than the best of another technique in " (lost) " of "
                (pairs) " comparisons."
            }
        } @else {
            p { (label) " is at least as good in all " (pairs) " comparisons." }
        }
    }
}

fn contest_row(contest: &Contest<'_>, measure: Measure) -> Markup {
    let lead = |(label, value)| (label, value, contest.lead(value));
    html! {
        tr {
            td { (contest.path) } td { (contest.side) } td { (contest.filter) }
            td { (measure.text(contest.subject)) }
            @for rival in &contest.rivals {
                @match rival.best.map(lead) {
                    Some((label, value, lead)) => {
                        td class=[(lead < 1.0).then_some("loses")]
                            title={ (label) ": " (measure.text(value)) } { (times(lead)) }
                    }
                    None => td { "–" },
                }
            }
        }
    }
}

fn times(lead: f64) -> String {
    match lead {
        lead if lead.is_infinite() => "∞".to_owned(),
        lead if lead.is_nan() => "1".to_owned(),
        // Rounding must not turn a loss into a draw.
        lead if lead < 1.0 => format!("{:.3}×", lead.min(0.999)),
        lead if lead >= 100.0 => format!("{lead:.0}×"),
        lead => format!("{lead:.2}×"),
    }
}

/// The fronts' members with their numbers.
pub(super) fn fronts(results: &Results) -> Markup {
    let rows = results.overall();
    html! {
        @for cost in costs(&rows) {
            h3 { "On the front over " (cost.name()) }
            table {
                tr { th { "no." } th { "case" } th { "side" } th { "filter" } th { (cost.name()) } th { "mismatch" } }
                @for (number, index) in on_front(&rows, cost).into_iter().enumerate() {
                    @let row = &rows[index];
                    tr {
                        td { (number + 1) } td style="text-align:left" { (row.case.label) } td { (row.side) }
                        td { (row.filter) } td { (amount(cost.of(row))) } td { (percent(row.mismatch)) }
                    }
                }
            }
        }
    }
}

/// Every case at every size over all paths, best first at each size.
pub(super) fn overall(results: &Results) -> Markup {
    let rows = results.overall();
    let fronts: Vec<Vec<usize>> = costs(&rows).into_iter().map(|cost| on_front(&rows, cost)).collect();
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by(|one, two| {
        let (one, two) = (&rows[*one], &rows[*two]);
        (one.side, one.filter, !one.complete)
            .cmp(&(two.side, two.filter, !two.complete))
            .then(one.mismatch.total_cmp(&two.mismatch))
    });
    html! {
        p { "Shaded: on a front. Bold: the house's. Incomplete cases, with stations that have no map, stand last." }
        @for side in &results.sides {
            details open {
                summary { (side) " x " (side) " texels" }
                div class="wide" { table {
                    tr {
                        th { "case" } th { "filter" } th { "mismatch" } th { "interior" } th { "footprint p95" }
                        th { "flicker" } th { "triangles" } th { "map bytes" } th { "time" } th { "refused" }
                    }
                    @for index in order.iter().filter(|index| rows[**index].side == *side) {
                        @let on = fronts.iter().any(|front| front.contains(index));
                        (overall_row(&rows[*index], on))
                    }
                } }
            }
        }
    }
}

fn overall_row(row: &Overall<'_>, on_front: bool) -> Markup {
    let class = [row.case.house.then_some("house"), on_front.then_some("front")];
    let class = class.into_iter().flatten().collect::<Vec<_>>().join(" ");
    let refused: usize =
        row.cells.iter().flat_map(|cell| &cell.found.refusals).map(|refusal| refusal.stations).sum();
    let judged = row.cells.iter().any(|cell| cell.found.figures.is_some());
    html! {
        tr class=(class) {
            td { (row.case.label) } td { (row.filter) }
            @if judged {
                td { (percent(row.mismatch)) } td { (share(row.interior)) }
                td { (format!("{:.2} px", row.footprint_p95)) }
                td { (row.flicker.map_or_else(dash, percent)) } td { (amount(Some(row.triangles))) }
                td { (amount(Some(row.map_bytes as f64))) }
                td { (row.time.map_or_else(dash, |time| format!("{time:.2}"))) }
            } @else {
                td class="refused" colspan="7" { "no station could be planned" }
            }
            td { @if refused > 0 { (refused) " stations" } }
        }
    }
}

/// Every cell.
pub(super) fn cells(results: &Results) -> Markup {
    html! {
        @for path in &results.paths {
            details {
                summary { (path.name) ": " (path.summary) }
                div class="wide" { table {
                    tr {
                        th { "case" } th { "side" } th { "filter" } th { "drawn by" }
                        th { "configurations" } th { "mismatch" }
                        th { "leak" } th { "acne" } th { "interior" } th { "edges p95" } th { "in footprints" }
                        th { "footprint median" } th { "p95" } th { "p99" } th { "max" } th { "surface p95" }
                        th { "scene use" } th { "beam use" } th { "flicker" } th { "facets" } th { "draws" }
                        th { "triangles" } th { "after culling" } th { "texels written" } th { "fetched" }
                        th { "SPIR-V words" } th { "bindings" } th { "capture" } th { "resolve" }
                    }
                    @for cell in results.cells.iter().filter(|cell| cell.path == path.name) { (cell_row(cell)) }
                } }
            }
        }
    }
}

fn cell_row(cell: &Cell) -> Markup {
    html! {
        tr {
            td { (cell.case) } td { (cell.side) } td { (cell.filter) } td { (cell.found.judge) }
            @match &cell.found.figures {
                Some(figures) => (figure_cells(figures)),
                None => td class="refused" colspan="25" {
                    @for refusal in &cell.found.refusals { (refusal.reason) " " }
                },
            }
        }
    }
}

fn figure_cells(found: &Figures) -> Markup {
    let counts = &found.counts;
    let pixels = |value: f64| format!("{value:.2}");
    let time =
        |pick: fn(&crate::measure::evaluate::Times) -> String| found.times.as_ref().map_or_else(dash, pick);
    html! {
        td { (found.configurations.join(", ")) }
        td { (percent(found.mismatch)) } td { (percent(found.leak)) } td { (percent(found.acne)) }
        td { (share(found.interior)) } td { (pixels(found.edge_pixels_p95)) } td { (pixels(found.edge_footprints_p95)) }
        td { (pixels(found.footprint.median)) } td { (pixels(found.footprint.p95)) }
        td { (pixels(found.footprint.p99)) } td { (pixels(found.footprint.max)) }
        td { (pixels(found.surface_footprint.p95)) }
        td { (percent(found.scene_utilisation)) } td { (percent(found.beam_utilisation)) }
        td { (found.flicker.map_or_else(dash, percent)) }
        td { (amount(Some(counts.facets))) } td { (amount(counts.draws)) }
        td { (amount(counts.triangles_submitted)) } td { (amount(Some(counts.triangles_after_culling))) }
        td { (amount(Some(counts.texels_written))) } td { (counts.texels_fetched_per_pixel) }
        td { (counts.spirv_words) } td { (counts.bindings) }
        td { (time(|times| times.capture.to_string())) } td { (time(|times| times.resolve.to_string())) }
    }
}

/// What has no numbers, in the planner's words.
pub(super) fn refusals(results: &Results) -> Markup {
    let mut reasons: Vec<(&str, &str, usize)> = Vec::new();
    for cell in &results.cells {
        for refusal in &cell.found.refusals {
            let known = reasons
                .iter_mut()
                .find(|(case, reason, _)| (*case, *reason) == (cell.case.as_str(), refusal.reason.as_str()));
            match known {
                Some((.., stations)) => *stations += refusal.stations,
                None => reasons.push((&cell.case, &refusal.reason, refusal.stations)),
            }
        }
    }
    html! {
        @if reasons.is_empty() {
            p { "Every case had a map at every station." }
        } @else {
            table {
                tr { th { "case" } th { "stations, all sizes" } th { "reason" } }
                @for (case, reason, stations) in reasons {
                    tr { td { (case) } td { (stations) } td class="refused" { (reason) } }
                }
            }
        }
    }
}

fn percent(value: f64) -> String {
    format!("{:.3} %", 100.0 * value)
}

fn share(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") }
}

fn amount(value: Option<f64>) -> String {
    match value {
        None => dash(),
        Some(value) if value.fract() == 0.0 || value >= 100.0 => format!("{value:.0}"),
        Some(value) => format!("{value:.1}"),
    }
}

fn dash() -> String {
    "–".to_owned()
}
