//! The report of many lights as Markdown.

use std::fmt::Write;

use super::LightsReport;

/// Tables for people.
pub(super) fn markdown(report: &LightsReport) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let mut line = |arguments: std::fmt::Arguments<'_>| {
        let _ = writeln!(text, "{arguments}");
    };
    line(format_args!("# {} lights in `{}`\n", report.judgements.len(), report.scene));
    line(format_args!(
        "{} x {} pixels, one map of {} x {} texels, {}.\n",
        report.width, report.height, report.map_side, report.map_side, report.adapter
    ));
    line(format_args!("## What a frame costs\n"));
    line(format_args!(
        "Mean over the frames after the first {}; `ms` is the CPU's part of preparing.\n",
        super::WARM_UP_FRAMES
    ));
    line(format_args!(
        "| camera | texels redrawn | share of owned | restored from static casters | triangles | draws | plans | waiting | ms |"
    ));
    line(format_args!("|---|---:|---:|---:|---:|---:|---:|---:|---:|"));
    for cost in &report.costs {
        line(format_args!(
            "| {} | {:.0} | {:.1} % | {:.0} | {:.0} | {:.0} | {:.1} | {:.1} | {:.1} |",
            cost.name,
            cost.redrawn_texels,
            100.0 * cost.redrawn_texels / report.owned_texels.max(1) as f64,
            cost.static_texels,
            cost.triangles,
            cost.draws,
            cost.planned,
            cost.waiting,
            cost.prepare_milliseconds,
        ));
    }
    line(format_args!("\n## Flicker under the sun\n"));
    line(format_args!(
        "Light-facing points of still surfaces whose shadow flips from one frame to the next.\n"
    ));
    line(format_args!("| mode | camera | flipped in a frame | frames in which the sun was drawn |"));
    line(format_args!("|---|---|---:|---:|"));
    for found in &report.flicker {
        let (mode, motion) = (found.mode, found.motion);
        line(format_args!("| {mode} | {motion} | {:.3} % | {} |", 100.0 * found.flipped, found.drawn_frames));
    }
    line(format_args!("\n## Each light in company and alone\n"));
    line(format_args!(
        "Wrong pixels among those that face the light within its reach; alone: a map of its own with as many texels.\n"
    ));
    line(format_args!("| light | side | configuration | judged | wrong | alone | interior | alone |"));
    line(format_args!("|---|---:|---|---:|---:|---:|---:|---:|"));
    for found in &report.judgements {
        line(format_args!(
            "| {} | {} | {} | {} | {} | {} | {} | {} |",
            found.name,
            found.side_texels,
            found.configuration,
            found.judged_pixels,
            found.wrong_in_company,
            found.wrong_alone,
            found.interior_in_company,
            found.interior_alone,
        ));
    }
    let seen: Vec<_> = report.judgements.iter().filter(|found| found.side_texels > 0).collect();
    let total = |pick: fn(&super::Judgement) -> u64| seen.iter().map(|found| pick(found)).sum::<u64>();
    let worst = seen.iter().map(|found| found.excess()).fold(0.0, f64::max);
    line(format_args!(
        "\nAll {} that reach something visible: {} wrong of {} in company, {} alone; the largest excess of one light is {:.4} %.",
        seen.len(),
        total(|found| found.wrong_in_company),
        total(|found| found.judged_pixels),
        total(|found| found.wrong_alone),
        100.0 * worst,
    ));
    text
}
