//! Pictures of the report: the truth, and what each technique's customary case makes of it.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use maud::{Markup, html};

use crate::error::LabError;
use crate::measure::bench::{Bench, TracedPath};
use crate::measure::cells::Item;
use crate::measure::evaluate::Candidate;
use crate::measure::results::Results;
use crate::picture::{Picture, legend, shaded_picture, verdict_picture};
use crate::progress::Progress;

/// Paths that are pictured at most.
const PATHS: usize = 2;
/// Width of the legend's picture.
const LEGEND_PIXELS: usize = 500;

/// Pictures, ready to be set into a page.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pictures {
    legend: String,
    paths: Vec<Pictured>,
}

#[derive(Debug, Clone, PartialEq)]
struct Pictured {
    heading: String,
    truth: String,
    cases: Vec<(String, String)>,
}

impl Pictures {
    /// Draws the first station of the first path and of the path with the largest errors, with each technique's customary
    /// case at the smallest size.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn draw(
        bench: &Bench<'_>,
        results: &Results,
        items: &[Item],
        progress: Progress,
    ) -> Result<Self, LabError> {
        let shown = paths(bench, results);
        let side = results.sides.first().copied().unwrap_or_default();
        let customary = |item: &&Item| item.case.map.width == side && results.cases[item.entry].customary;
        let mut seen = Vec::new();
        let first_filter = |item: &&Item| {
            let new = !seen.contains(&item.entry);
            seen.push(item.entry);
            new
        };
        let items: Vec<&Item> = items.iter().filter(customary).filter(first_filter).collect();
        let mut paths = Vec::with_capacity(shown.len());
        for path in &shown {
            let Some(station) = path.stations.first() else { continue };
            let sight = &station.sight;
            let lit: Vec<f32> = sight.frame.pixels.iter().map(lit).collect();
            let truth = shaded_picture(bench.scene, &sight.frame, &lit, &sight.light);
            paths.push(Pictured {
                heading: format!("{}, {side} x {side} texels: {}", path.name, path.summary),
                truth: data_uri(&truth)?,
                cases: Vec::new(),
            });
        }
        let bar = progress.bar(items.len() as u64, "drawing pictures");
        for item in items {
            let mut candidate = Candidate::new(bench, &item.case)?;
            for (path, pictured) in shown.iter().zip(&mut paths) {
                let Some(station) = path.stations.first().filter(|_| candidate.is_for(path)) else {
                    continue;
                };
                let label = &results.cases[item.entry].label;
                let shown = candidate.pictured(station)?;
                let (picture, said) = match shown {
                    Ok(outcome) => {
                        let frame = &station.sight.frame;
                        let picture = verdict_picture(frame.width, frame.height, &outcome.verdicts);
                        (Some(picture), format!("{:.3} % wrong", 100.0 * outcome.score.mismatch))
                    }
                    Err(reason) => (None, reason),
                };
                let uri = picture.as_ref().map(data_uri).transpose()?.unwrap_or_default();
                pictured.cases.push((uri, format!("{label}: {said}")));
            }
            bar.inc(1);
        }
        bar.finish_and_clear();
        let names = [const { String::new() }; 5];
        Ok(Self { legend: data_uri(&legend(LEGEND_PIXELS, &names))?, paths })
    }

    /// The pictures as a part of a page.
    pub(super) fn markup(&self) -> Markup {
        html! {
            @if !self.legend.is_empty() { p { img src=(self.legend) alt="lit, shadowed, leak, acne, crease"; } }
            @for path in &self.paths {
                h3 { (path.heading) }
                figure { img src=(path.truth) alt="truth"; figcaption { "ray-cast truth" } }
                @for (uri, said) in &path.cases {
                    figure {
                        @if !uri.is_empty() { img src=(uri) alt=(said); }
                        figcaption { (said) }
                    }
                }
            }
        }
    }
}

fn lit(pixel: &Option<crate::truth::Visible>) -> f32 {
    pixel.as_ref().map_or(1.0, |pixel| f32::from(u8::from(pixel.lit)))
}

/// The first path, and the one on which the most pixels are wrong.
fn paths<'b, 'a>(bench: &'b Bench<'a>, results: &Results) -> Vec<&'b TracedPath<'a>> {
    let wrong = |name: &str| {
        let cells = results.cells.iter().filter(|cell| cell.path == name);
        cells.filter_map(|cell| Some(cell.found.figures.as_ref()?.mismatch)).sum::<f64>()
    };
    let rest = bench.paths.iter().skip(1);
    let worst = rest.max_by(|one, two| wrong(&one.name).total_cmp(&wrong(&two.name)));
    bench.paths.first().into_iter().chain(worst).take(PATHS).collect()
}

fn data_uri(picture: &Picture) -> Result<String, LabError> {
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(picture.png_bytes()?)))
}
