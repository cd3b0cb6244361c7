//! The demo's table.

use crate::report::Report;

const COLUMNS: [&str; 12] = [
    "scene",
    "case (technique)",
    "map texels",
    "footprint p95 (px)",
    "leak (%)",
    "acne (%)",
    "interior wrong (px)",
    "edge displacement p95 (px / footprints)",
    "capture (ms)",
    "resolve (ms)",
    "draws",
    "triangles",
];

/// The runs as a Markdown table with aligned columns, and a line about the adapter.
pub(super) fn markdown(runs: &[Report]) -> String {
    let rows: Vec<[String; 12]> = runs.iter().map(row).collect();
    let widths: Vec<usize> = (0..COLUMNS.len())
        .map(|column| rows.iter().map(|row| row[column].len()).fold(COLUMNS[column].len(), usize::max))
        .collect();
    let line = |cells: &[String]| {
        let cells: Vec<_> =
            cells.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let mut text = line(&COLUMNS.map(str::to_owned));
    text += &line(&widths.iter().map(|width| "-".repeat(*width)).collect::<Vec<_>>());
    for row in &rows {
        text += &line(row);
    }
    if let Some(first) = runs.first() {
        text += &format!("\nTimes: median [10 %, 90 %] of interleaved runs on {}", first.adapter);
        if let Some(time) = first.time {
            text += &format!(", {} runs, {}", time.runs, time.method);
        }
        text += ".\n";
    }
    text
}

fn row(run: &Report) -> [String; 12] {
    let displacement = &run.score.edge_displacement.true_to_map;
    let time = |pick: fn(&crate::timing::Timing) -> crate::timing::Interval| {
        run.time.as_ref().map_or_else(|| "-".to_owned(), |time| pick(time).to_string())
    };
    [
        run.scene.clone(),
        format!("{} ({})", run.case, run.technique),
        format!("{} x {}", run.map.width, run.map.height),
        format!("{:.2}", run.footprint.p95),
        format!("{:.3}", 100.0 * run.score.leak.total),
        format!("{:.3}", 100.0 * run.score.acne.total),
        run.score.interior_wrong_pixels.to_string(),
        format!("{:.2} / {:.2}", displacement.pixels.p95, displacement.footprints.p95),
        time(|time| time.capture),
        time(|time| time.resolve),
        run.draws.to_string(),
        run.triangles_submitted.to_string(),
    ]
}
