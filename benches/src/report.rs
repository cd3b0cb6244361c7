//! The report: the paper's tables with ours, and what both say as ratios.

mod table;

use cssm_lab::timing::Interval;

use crate::contender::FrameTimes;
use crate::paper;
use crate::run::{MapTimes, Measurement, SituationTimes};
use table::{Table, times, with_interval};

/// Command that writes the report.
const COMMAND: &str = "cargo bench -p cssm-benches --bench speed -- --write";

/// Times of work on the CPU, one for each job, and how many times as long as the first job's it takes.
#[derive(Debug, Clone, PartialEq)]
pub struct CpuTimes {
    /// What is timed.
    pub heading: String,
    /// Name, microseconds and ratio of each job.
    pub jobs: Vec<(String, Interval, Interval)>,
}

/// What a table shows of frames with maps of one size.
type Figure = fn(&MapTimes, &[FrameTimes]) -> Interval;

/// A ratio that the report states.
struct Ratio {
    situation: usize,
    name: &'static str,
    reference: &'static str,
    reach: Option<f64>,
    paper: Option<(&'static str, [f64; 5])>,
}

/// A case in words.
fn words(case: &str) -> &'static str {
    match case {
        "Standard" => "standard",
        "Unstretched" => "one plane, perspective, unstretched",
        "UnstretchedInFragments" => "one plane, perspective, unstretched, depth from a fragment shader",
        "Stretched" => "one plane, perspective, stretched exactly",
        "Logarithmic" => "one plane, logarithmic, stretched exactly",
        "Bands" => "one plane, 8 bands",
        "FourPlane" => "four planes",
        "FaceColumns" => "face columns, 8 bands",
        _ => "a case without words",
    }
}

fn ratios() -> [Ratio; 8] {
    let ratio = |situation, name, reference| Ratio { situation, name, reference, reach: None, paper: None };
    let stretched = ("paper: stretched / standard", paper::STRETCHED.ratio(&paper::STANDARD));
    let dueling = ("paper: dueling / standard of the other view", paper::DUELING.ratio(&paper::STANDARD));
    [
        Ratio { reach: Some(1.5), paper: Some(stretched), ..ratio(0, "Stretched", "Unstretched") },
        ratio(0, "Stretched", "UnstretchedInFragments"),
        Ratio { reach: Some(1.5), ..ratio(0, "Logarithmic", "Unstretched") },
        Ratio { reach: Some(1.15), ..ratio(0, "Bands", "Unstretched") },
        ratio(0, "Unstretched", "Standard"),
        ratio(0, "FaceColumns", "Standard"),
        Ratio { reach: Some(1.1), paper: Some(dueling), ..ratio(1, "FourPlane", "Standard") },
        ratio(1, "FaceColumns", "Standard"),
    ]
}

/// The whole report as Markdown.
pub fn markdown(measured: &Measurement, cpu: &[CpuTimes]) -> String {
    let mut parts = vec![introduction(measured)];
    parts.push(
        "## Ratios at equal texels\n\nEach number divides two contenders of the same turn; *reach* is what a GPU should \
         show.\n\n### Capture and resolve together\n"
            .to_owned(),
    );
    parts.push(ratio_table(measured, FrameTimes::shadows, true));
    parts.push("### Capture alone\n".to_owned());
    parts.push(ratio_table(measured, |times| times.capture, false));
    parts.push(fixed_share(measured));
    parts.push("### Resolve alone\n".to_owned());
    parts.push(ratio_table(measured, |times| times.resolve, false));
    parts.push(format!(
        "## The paper's tables\n\nThe paper's own numbers are in italics ({}); its *standard* is one plane without \
         stretching.\n\n### Table 1: frames per second\n",
        paper::ADAPTER
    ));
    let frames: Figure = |_, frames| rate(frames.iter().map(|times| times.frame).collect());
    parts.push(paper_table(measured, Some(frames), frames, |column| column.frames_per_second));
    parts.push(
        "### Table 2: frames per second of shadows alone\n\nOurs from the times of capture and resolve, the paper's by \
         difference.\n"
            .to_owned(),
    );
    let shadows: Figure = |_, frames| rate(frames.iter().map(FrameTimes::shadows).collect());
    parts.push(paper_table(measured, None, shadows, paper::Column::fictive));
    parts.push("### Table 3: what the light adds to a frame without light, %\n".to_owned());
    let increase: Figure = |map, frames| {
        let shares = frames.iter().zip(&map.without_light);
        Interval::of(shares.map(|(with, without)| 100.0 * with.shadows() / without.frame).collect())
    };
    parts.push(paper_table(measured, None, increase, |column| column.increase().map(|share| 100.0 * share)));
    parts.push("## Milliseconds of capture / resolve, medians\n".to_owned());
    parts.push(milliseconds_table(measured));
    parts.push(
        "## What was drawn\n\nCounts do not depend on the machine; here at the largest map.\n".to_owned(),
    );
    parts.push(count_table(measured));
    for times in cpu {
        parts.push(cpu_table(times));
    }
    parts.join("\n")
}

fn introduction(measured: &Measurement) -> String {
    let Measurement { adapter, method, runs, triangles, image_pixels: (width, height), .. } = measured;
    let software = if measured.software {
        "\nThis adapter is a program that runs on the CPU. Depth that no fragment shader writes takes a path of its own in it, \
         and what a GPU does in fixed function (coverage, depth, clears) costs it as much as shaders do. Exact stretching \
         decides coverage in a fragment shader: the contender *depth from a fragment shader* draws straight rows without \
         that path too, so that its share can be told apart. The balance between capture, resolve and the view's own \
         passes is not a GPU's either.\n"
    } else {
        ""
    };
    format!(
        "# Speed\n\n\
         Written by\n\n\
         ```sh\n{COMMAND}\n```\n\n\
         The workload is that of the camera space paper: {triangles} triangles of palm, an image of {width} x {height} \
         pixels, one directional light, square depth maps of 32-bit floats. A frame sees the scene (depth, normals, \
         colours), captures a map, resolves it to a mask with a 2 x 2 gather and an exact receiver plane, and shades. The \
         declarations are in `benches/speed.cssm`.\n\n\
         Adapter: {adapter}. Times by {method}. All contenders of a map size run in turns; the median of {runs} turns \
         after warm-up, in brackets what four fifths of them lie in: \
         wide brackets mean that the machine did other work too. Compare ratios, not milliseconds.\n{software}"
    )
}

/// Ratios of every map size.
fn ratio_table(measured: &Measurement, of: fn(&FrameTimes) -> f64, with_paper: bool) -> String {
    let sides = sides(measured);
    let mut table =
        Table::new(["contenders", "reach"].map(str::to_owned).into_iter().chain(headings(&sides)));
    for ratio in ratios() {
        let Some(situation) = measured.situations.get(ratio.situation) else { continue };
        let name = format!("{} / {}", words(ratio.name), words(ratio.reference));
        let sun = if ratio.situation == 0 { "" } else { " (sun in the image)" };
        let reach = ratio.reach.filter(|_| with_paper).map_or(String::new(), |reach| format!("<= {reach}"));
        let cells = situation.maps.iter().map(|map| {
            map.ratio(ratio.name, ratio.reference, of).map_or(String::new(), |ratio| with_interval(&ratio, 2))
        });
        table.row([name + sun, reach].into_iter().chain(cells));
        if let Some((name, values)) = ratio.paper.filter(|_| with_paper) {
            let cells = sides.iter().map(|side| of_paper(*side, &values, 2));
            table.row([format!("*{name}*"), String::new()].into_iter().chain(cells));
        }
    }
    table.markdown()
}

/// How much of the captures of the largest map is spent at the smallest one too: work on triangles, not on texels.
fn fixed_share(measured: &Measurement) -> String {
    let Some(maps) = measured.situations.first().map(|situation| &situation.maps) else {
        return String::new();
    };
    let share = |name| {
        let median = |map: Option<&MapTimes>| {
            let frames = &map?.contender(name)?.frames;
            Some(Interval::of(frames.iter().map(|times| times.capture).collect()).median)
        };
        Some(format!("{:.0} % ({})", 100.0 * median(maps.first())? / median(maps.last())?, words(name)))
    };
    let shares: Vec<String> = ["Standard", "Unstretched", "Bands", "Stretched", "Logarithmic"]
        .into_iter()
        .filter_map(share)
        .collect();
    format!(
        "Of the capture with the largest map the smallest one takes {}: what does not shrink with the map is work on \
         triangles, which for exact stretching is a covering polygon for each of them in a vertex shader.\n",
        shares.join(", ")
    )
}

/// One of the paper's tables: a row for each contender, the paper's below it.
fn paper_table(
    measured: &Measurement,
    without_light: Option<Figure>,
    with_light: Figure,
    of_column: fn(&paper::Column) -> [f64; 5],
) -> String {
    let sides = sides(measured);
    let mut table = Table::new(std::iter::once(String::new()).chain(headings(&sides)));
    let paper_row = |table: &mut Table, column: &paper::Column, values: [f64; 5]| {
        let cells = sides.iter().map(|side| of_paper(*side, &values, 0));
        table.row(std::iter::once(format!("*paper: {}*", column.name)).chain(cells));
    };
    for (number, situation) in measured.situations.iter().enumerate() {
        table.row(std::iter::once(format!("**{}**", situation.name)));
        if let Some(without_light) = &without_light {
            let cells =
                situation.maps.iter().map(|map| with_interval(&without_light(map, &map.without_light), 1));
            table.row(std::iter::once("no light".to_owned()).chain(cells));
            let column = if number == 0 { &paper::STANDARD } else { &paper::DUELING };
            let cells = sides.iter().map(|side| of_paper(*side, &[column.without_light; 5], 0));
            table.row(std::iter::once("*paper: no light*".to_owned()).chain(cells));
        }
        for name in names(situation) {
            let cells = situation.maps.iter().map(|map| {
                let frames = map.contender(name).map(|contender| with_light(map, &contender.frames));
                frames.map_or(String::new(), |interval| with_interval(&interval, 1))
            });
            table.row(std::iter::once(words(name).to_owned()).chain(cells));
            let column = match name {
                "Unstretched" => &paper::STANDARD,
                "Stretched" => &paper::STRETCHED,
                "FourPlane" => &paper::DUELING,
                _ => continue,
            };
            paper_row(&mut table, column, of_column(column));
        }
    }
    table.markdown()
}

fn milliseconds_table(measured: &Measurement) -> String {
    let sides = sides(measured);
    let mut table = Table::new(std::iter::once(String::new()).chain(headings(&sides)));
    for situation in &measured.situations {
        table.row(std::iter::once(format!("**{}**", situation.name)));
        for name in names(situation) {
            let cells = situation.maps.iter().map(|map| {
                let median = |of: fn(&FrameTimes) -> f64| {
                    let frames = map.contender(name).map(|contender| &contender.frames[..]);
                    Interval::of(frames.unwrap_or_default().iter().map(of).collect()).median
                };
                format!("{:.1} / {:.1}", median(|times| times.capture), median(|times| times.resolve))
            });
            table.row(std::iter::once(words(name).to_owned()).chain(cells));
        }
    }
    table.markdown()
}

fn count_table(measured: &Measurement) -> String {
    let mut table = Table::new(["", "facets", "draws", "triangles submitted"].map(str::to_owned));
    for situation in &measured.situations {
        table.row([format!("**{}**", situation.name)]);
        for contender in situation.maps.last().map_or(&[][..], |map| &map.contenders[..]) {
            let counts = [contender.facets as u64, u64::from(contender.draws), contender.triangles];
            let cells = counts.map(|count| count.to_string());
            table.row(std::iter::once(words(contender.name).to_owned()).chain(cells));
        }
    }
    table.markdown()
}

fn cpu_table(cpu: &CpuTimes) -> String {
    let mut table = Table::new(["", "microseconds", "times the first"].map(str::to_owned));
    for (name, microseconds, ratio) in &cpu.jobs {
        table.row([name.clone(), with_interval(microseconds, 0), with_interval(ratio, 2)]);
    }
    let how = "Fastest of five calls in each turn, in microseconds on this machine's CPU.";
    format!("## {}\n\n{how}\n\n{}", cpu.heading, table.markdown())
}

/// Runs per second from milliseconds.
fn rate(milliseconds: Vec<f64>) -> Interval {
    Interval::of(milliseconds.into_iter().map(|milliseconds| 1e3 / milliseconds).collect())
}

/// The paper's value for a map of a size, if it has one.
fn of_paper(side: u32, values: &[f64; 5], decimals: usize) -> String {
    let index = paper::MAP_SIDES_TEXELS.iter().position(|known| *known == side);
    index.map_or(String::new(), |index| format!("*{}*", times(values[index], decimals)))
}

fn sides(measured: &Measurement) -> Vec<u32> {
    let maps = measured.situations.first().map_or(&[][..], |situation| &situation.maps[..]);
    maps.iter().map(|map| map.side_texels).collect()
}

fn headings(sides: &[u32]) -> impl Iterator<Item = String> {
    sides.iter().map(|side| format!("{side} x {side}"))
}

fn names(situation: &SituationTimes) -> impl Iterator<Item = &'static str> {
    let first = situation.maps.first().map_or(&[][..], |map| &map.contenders[..]);
    first.iter().map(|contender| contender.name)
}
