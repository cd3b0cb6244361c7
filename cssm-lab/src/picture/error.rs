//! Where the map is right and where it is wrong.

use super::{Colour, INK, LABEL_BACKGROUND, LINE_PIXELS, Picture};
use crate::score::{Place, Score, Verdict};

const LIT: Colour = [222, 216, 200];
const SHADOWED: Colour = [92, 99, 112];
const LEAK: Colour = [240, 150, 0];
const ACNE: Colour = [214, 0, 110];
const CREASE: Colour = [0, 170, 215];
const SKY: Colour = [40, 44, 52];

/// Side of a legend's colour patch.
const PATCH_PIXELS: usize = 15;

/// The verdicts in five colours with a legend below: where truth and map agree, lit and shadowed; where they do
/// not, leak and acne, or crease for both beside a crease. Surfaces that do not face the light are not judged and
/// show the truth.
pub fn error_picture(width: usize, height: usize, verdicts: &[Option<Verdict>], score: &Score) -> Picture {
    let percent = |share: f64| format!(" {:.3} %", 100.0 * share);
    let crease = score.leak.crease + score.acne.crease;
    let shares = [
        String::new(),
        String::new(),
        percent(score.leak.total - score.leak.crease),
        percent(score.acne.total - score.acne.crease),
        percent(crease),
    ];
    Picture::stacked(&[verdict_picture(width, height, verdicts), legend(width, &shares)])
}

/// The verdicts alone.
pub fn verdict_picture(width: usize, height: usize, verdicts: &[Option<Verdict>]) -> Picture {
    let pixels = verdicts
        .iter()
        .map(|verdict| match verdict {
            None => SKY,
            Some(verdict) if verdict.facing && verdict.wrong() => match (verdict.place, verdict.map_lit) {
                (Place::Crease, _) => CREASE,
                (_, true) => LEAK,
                (_, false) => ACNE,
            },
            Some(verdict) if verdict.truth_lit => LIT,
            Some(_) => SHADOWED,
        })
        .collect();
    Picture { width, height, pixels }
}

/// Of the verdicts under a smaller pixel, one that is wrong if there is any, else the middle one.
pub fn worst_verdict(colours: &[Colour]) -> Colour {
    let wrong = [LEAK, ACNE, CREASE].into_iter().find(|wrong| colours.contains(wrong));
    wrong.or_else(|| colours.get(colours.len() / 2).copied()).unwrap_or(SKY)
}

/// What the colours of verdicts mean, each followed by a text.
pub fn legend(width: usize, texts: &[String; 5]) -> Picture {
    let names = [(LIT, "lit"), (SHADOWED, "shadowed"), (LEAK, "leak"), (ACNE, "acne"), (CREASE, "crease")];
    let entries: Vec<_> =
        names.iter().zip(texts).map(|((colour, name), text)| (*colour, format!("{name}{text}"))).collect();

    // Break the entries into lines that fit.
    let mut places = Vec::new();
    let (mut x, mut line) = (PATCH_PIXELS / 2, 0);
    for (_, text) in &entries {
        let entry = 2 * PATCH_PIXELS + Picture::text_width(text);
        if x + entry > width && x > PATCH_PIXELS {
            (x, line) = (PATCH_PIXELS / 2, line + 1);
        }
        places.push((x, line * LINE_PIXELS));
        x += entry + PATCH_PIXELS / 2;
    }
    let mut legend = Picture::filled(width, (line + 1) * LINE_PIXELS, LABEL_BACKGROUND);
    for ((colour, text), (x, y)) in entries.iter().zip(places) {
        legend.fill(x, y + 4, PATCH_PIXELS, PATCH_PIXELS, *colour);
        legend.text(x + PATCH_PIXELS + 6, y + 4, text, INK);
    }
    legend
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn five_colours_tell_five_things() {
        let verdict = |place, truth_lit, map_lit, facing| Some(Verdict { place, truth_lit, map_lit, facing });
        let verdicts = [
            verdict(Place::Interior, true, true, true),
            verdict(Place::Interior, false, false, true),
            verdict(Place::Interior, false, true, true),
            verdict(Place::Edge, true, false, true),
            verdict(Place::Crease, true, false, true),
            verdict(Place::Crease, false, true, true),
            verdict(Place::Interior, false, true, false),
            None,
        ];
        let picture = error_picture(8, 1, &verdicts, &Score::default());
        assert_eq!(&picture.pixels[..8], &[LIT, SHADOWED, LEAK, ACNE, CREASE, CREASE, SHADOWED, SKY]);
        assert!(picture.height > LINE_PIXELS);
        assert_eq!(worst_verdict(&[LIT, LIT, CREASE, LIT]), CREASE);
        assert_eq!(worst_verdict(&[CREASE, ACNE]), ACNE);
        assert_eq!(worst_verdict(&[SHADOWED, LIT, LIT]), LIT);
    }
}
