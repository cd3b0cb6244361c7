//! The report: one file with everything in it, pictures as data, nothing from the net, no scripts.

mod pictures;
mod tables;

pub use pictures::Pictures;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::error::MeasureError;
use super::plot;
use super::results::Results;
use super::verdict::subject;

const STYLE: &str = "
body { font: 15px/1.45 sans-serif; margin: 2em auto; max-width: 1240px; padding: 0 1em; color: #222; }
h1 { font-size: 1.7em; } h2 { margin-top: 2em; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; font-size: 13px; margin: .7em 0; }
th, td { padding: .18em .6em; text-align: right; border-bottom: 1px solid #e4e4e4; white-space: nowrap; }
th { background: #f3f3f1; text-align: right; }
th:first-child, td:first-child { text-align: left; }
td.loses { color: #c00000; font-weight: bold; }
td.refused { color: #777; white-space: normal; text-align: left; }
tr.house td:first-child { font-weight: bold; }
tr.front td { background: #fdf6dc; }
p.loses { color: #c00000; }
figure { display: inline-block; margin: .4em; vertical-align: top; }
figcaption { font-size: 12px; max-width: 330px; }
details { margin: .6em 0; } summary { cursor: pointer; }
svg { max-width: 100%; height: auto; }
pre { background: #f6f6f4; padding: .6em; overflow-x: auto; font-size: 12px; }
.wide { overflow-x: auto; }
";

/// The whole report.
///
/// # Errors
/// [`MeasureError::Plot`] when the plot cannot be drawn.
pub fn page(results: &Results, pictures: &Pictures) -> Result<String, MeasureError> {
    let plot = plot::svg(results)?;
    let title = format!("Shadow techniques on {}", results.scene);
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { (title) }
                (setting(results))
                h2 { "Where the house's technique stands" }
                (tables::verdict(results))
                h2 { "Error against cost" }
                p {
                    "Every dot is a case at one map size; ringed and numbered: no other case that serves every "
                    "station errs less at the same cost or less. Hollow: some station has no map. The numbers "
                    "behind every dot follow below."
                }
                (PreEscaped(plot))
                (tables::fronts(results))
                h2 { "What the errors look like" }
                (pictures.markup())
                h2 { "Every case over all paths" }
                (tables::overall(results))
                h2 { "Every case on every path" }
                (tables::cells(results))
                h2 { "What was not measured, and why" }
                (tables::refusals(results))
                h2 { "Declarations" }
                (declarations(results))
            }
        }
    };
    Ok(page.into_string())
}

fn setting(results: &Results) -> Markup {
    let stations: usize = results.paths.iter().map(|path| path.stations).sum();
    let twins = results.cells.iter().filter(|cell| cell.found.judge == "twin").count();
    html! {
        p {
            (results.triangles) " triangles; images of " (results.pixels.0) " x " (results.pixels.1)
            " pixels; " (stations) " stations on " (results.paths.len()) " paths. Adapter: "
            (results.adapter) ". Truth is cast in f64; every pixel that faces the light is judged against it."
        }
        @if twins > 0 {
            p {
                (twins) " of " (results.cells.len()) " cells were drawn by the f64 twin instead of the adapter; "
                "the tables of the paths say which."
            }
        }
        @if let Some(subject) = subject(results) {
            p { "The house's customary case is " b { (subject.label) } "." }
        }
        table {
            tr { th { "path" } th { "stations" } th style="text-align:left" { "what it is" } }
            @for path in &results.paths {
                tr {
                    td { (path.name) } td { (path.stations) }
                    td style="text-align:left" { (path.summary) }
                }
            }
        }
    }
}

fn declarations(results: &Results) -> Markup {
    html! {
        details {
            summary { "How each case is declared, at its first size and filter" }
            @for case in results.cases.iter().filter(|case| !case.declaration.is_empty()) {
                pre { (case.declaration) }
            }
        }
    }
}
