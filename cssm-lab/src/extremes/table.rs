//! The tables as Markdown.

use std::fmt::Write as _;

use super::found::{Found, TEXEL_LIMIT, TEXEL_TARGET, Worst};
use super::situations::{AXES, Axis};
use super::{Extent, Extremes, Row};

/// The tables for people.
pub fn markdown(extremes: &Extremes, extent: Extent) -> String {
    let mut text = String::from("# Where each technique breaks\n\n");
    text += "Each cell: the largest error in texels that f32 makes of a receiver's place in the map, against f64, then how \
             many times coarser the 95th percentile of the footprint is in the axis's worst situation than in its best. \
             **Bold** cells break: a receiver without a facet or with several, a number that is not finite, an error that \
             can be seen (half a texel). `r` counts typed refusals, `d` plans by a configuration for a light that another one is made for, \
             `i` plans that say themselves that they leave receivers out; these three are answers, and are not judged. \
             Local lights around special directions light three thousand times their distance from the eye.\n\n";
    let share = if extent.every == 1 {
        "every situation".into()
    } else {
        format!("one situation in {}", extent.every)
    };
    let _ = writeln!(
        text,
        "Written by `cargo xtask extremes`; {share}, {} receivers for each plan, {} plans.\n",
        extent.receivers,
        extremes.rows.iter().flat_map(|row| &row.axes).map(|found| found.plans).sum::<u64>(),
    );
    text += "| axis | from, to |\n|---|---|\n";
    for axis in AXES {
        let _ = writeln!(text, "| {} | {} |", axis.name(), axis.range());
    }

    // One table for the techniques, one for configurations and distributions.
    let _ = write!(text, "\n## Techniques\n\n{}", head());
    extremes.rows.iter().filter(|row| row.is_variant).for_each(|row| text += &line(row));
    if extremes.rows.iter().any(|row| !row.is_variant) {
        let _ = write!(text, "\n## Configurations, distributions and local lights\n\n{}", head());
        extremes.rows.iter().filter(|row| !row.is_variant).for_each(|row| text += &line(row));
    }
    text += &breaks(extremes);
    text += &above_target(extremes);
    text += &coarsest(extremes);
    text += &refusals(extremes);
    text += "\n## Known faults\n\nWhat the measure has to see.\n\n| fault | texels | without it |\n|---|---|---|\n";
    for control in &extremes.controls {
        let _ =
            writeln!(text, "| {} | {:.2e} | {:.1e} |", control.what, control.texels, control.sound_texels);
    }
    text
}

fn head() -> String {
    let names: Vec<_> = AXES.iter().map(|axis| axis.name()).collect();
    format!("| | {} | casters |\n|---|{}---|\n", names.join(" | "), "---|".repeat(names.len()))
}

fn line(row: &Row) -> String {
    let cells: Vec<_> = row.axes.iter().map(cell).collect();
    let casters = match row.casters.breaks().first() {
        Some((what, _)) => format!("**{what}**"),
        None => format!("{} maps", row.casters.maps),
    };
    format!("| {} | {} | {casters} |\n", row.name, cells.join(" | "))
}

/// One cell in words.
pub fn cell(found: &Found) -> String {
    let mut parts = Vec::new();
    if found.receivers > 0 {
        parts.push(format!("{:.0e}", found.texels.value));
        parts.push(format!("×{}", short(found.blow_up())));
    }
    let counts = [("r", found.refused()), ("d", found.degraded), ("i", found.incomplete.times)];
    parts.extend(
        counts.iter().filter(|(_, count)| *count > 0).map(|(letter, count)| format!("{count}{letter}")),
    );
    let text = if parts.is_empty() { "–".to_owned() } else { parts.join(" ") };
    if found.breaks().is_empty() { text } else { format!("**{text}**") }
}

/// A factor with two digits.
pub fn short(factor: f64) -> String {
    if factor < 100.0 { format!("{factor:.1}") } else { format!("{factor:.0e}") }
}

/// Every break, with the first situation.
fn breaks(extremes: &Extremes) -> String {
    let mut lines = String::new();
    for row in &extremes.rows {
        for (axis, found) in AXES.iter().zip(&row.axes) {
            for (what, place) in found.breaks() {
                let _ = writeln!(lines, "| {} | {} | {what} | {place} |", row.name, axis.name());
            }
        }
        for (what, place) in row.casters.breaks() {
            let _ = writeln!(lines, "| {} | casters | {what} | {place} |", row.name);
        }
    }
    if lines.is_empty() {
        return "\n## Breaks\n\nNone.\n".to_owned();
    }
    format!("\n## Breaks\n\n| | axis | what | where |\n|---|---|---|---|\n{lines}")
}

/// Errors that nobody could see, but that are larger than aimed at.
fn above_target(extremes: &Extremes) -> String {
    let mut lines = String::new();
    for row in &extremes.rows {
        let over = AXES.iter().zip(&row.axes).filter(|(_, found)| found.relative_texels.value > TEXEL_TARGET);
        for (axis, found) in over.filter(|(_, found)| found.texels.value <= TEXEL_LIMIT) {
            let Worst { value, place } = &found.relative_texels;
            let _ = writeln!(lines, "| {} | {} | {value:.1e} | {place} |", row.name, axis.name());
        }
    }
    format!(
        "\n## Above the target\n\nErrors between {TEXEL_TARGET} texels of a map with 2048 on its longer side (longer maps in \
         proportion) and {TEXEL_LIMIT} texels, where they could be seen.\n\n| | axis | texels | where |\n|---|---|---|---|\n{lines}"
    )
}

/// The coarsest plan of each technique on each axis that coarsens it much.
fn coarsest(extremes: &Extremes) -> String {
    const MUCH: f64 = 30.0;
    let mut lines = String::new();
    for row in extremes.rows.iter().filter(|row| row.is_variant) {
        let axes = AXES.iter().zip(&row.axes).filter(|(axis, _)| **axis != Axis::Together);
        for (axis, found) in axes.filter(|(_, found)| found.blow_up() > MUCH) {
            let (worst, best) = (&found.footprint_worst, found.footprint_best);
            let _ = writeln!(
                lines,
                "| {} | {} | {:.3e} px | {best:.3e} px | {} |",
                row.name,
                axis.name(),
                worst.value,
                worst.place
            );
        }
    }
    format!(
        "\n## Where footprints blow up\n\nMore than {MUCH} times the axis's best.\n\n\
         | | axis | worst p95 | best p95 | worst where |\n|---|---|---|---|---|\n{lines}"
    )
}

/// Every kind of refusal once, with what it says.
fn refusals(extremes: &Extremes) -> String {
    let mut kinds = std::collections::BTreeMap::new();
    for found in extremes.rows.iter().flat_map(|row| &row.axes) {
        for (kind, refusal) in &found.refusals {
            let entry = kinds
                .entry(kind)
                .or_insert_with(|| (0, refusal.message.as_str(), refusal.count.place.as_str()));
            entry.0 += refusal.count.times;
        }
    }
    let mut lines = String::new();
    for (kind, (times, message, place)) in kinds {
        let _ = writeln!(lines, "| {kind} | {times} | {message} | {place} |");
    }
    format!("\n## Refusals\n\n| kind | times | what the first one said | where |\n|---|---|---|---|\n{lines}")
}
