//! Charts on pictures: what the plotting library draws, with the lab's own letters.

use std::convert::Infallible;

use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontTransform,
};

use crate::picture::{Colour, Picture};

/// Background of charts.
pub const PAPER: Colour = [252, 252, 250];
/// Text and axes of charts.
pub const PEN: Colour = [30, 32, 38];

/// Height of letters in pixels.
const LETTER_PIXELS: usize = 15;

/// A picture that charts are drawn on.
pub struct Canvas<'a>(pub &'a mut Picture);

impl DrawingBackend for Canvas<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        (self.0.width as u32, self.0.height as u32)
    }

    fn ensure_prepared(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn present(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn draw_pixel(
        &mut self,
        (x, y): BackendCoord,
        colour: BackendColor,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        if let (Ok(x), Ok(y)) = (usize::try_from(x), usize::try_from(y))
            && x < self.0.width
            && y < self.0.height
        {
            let below = self.0.pixels[y * self.0.width + x];
            let own = <[u8; 3]>::from(colour.rgb);
            let mix = |c: usize| {
                let (own, below) = (f64::from(own[c]), f64::from(below[c]));
                (below + (own - below) * colour.alpha).round() as u8
            };
            self.0.set(x, y, [mix(0), mix(1), mix(2)]);
        }
        Ok(())
    }

    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        text: &str,
        _: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        Ok((Picture::text_width(text) as u32, LETTER_PIXELS as u32))
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        place: BackendCoord,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        // Write the text on a strip of its own, turn that, and copy its ink.
        let (width, height) = (Picture::text_width(text), LETTER_PIXELS);
        let ink = <[u8; 3]>::from(style.color().rgb);
        let blank = ink.map(|channel| !channel);
        let mut strip = Picture::filled(width, height, blank);
        strip.text(0, 0, text, ink);
        let across = match style.anchor().h_pos {
            HPos::Left => 0,
            HPos::Center => width as i32 / 2,
            HPos::Right => width as i32,
        };
        let down = match style.anchor().v_pos {
            VPos::Top => 0,
            VPos::Center => height as i32 / 2,
            VPos::Bottom => height as i32,
        };
        for (index, colour) in strip.pixels.iter().enumerate().filter(|(_, colour)| **colour == ink) {
            let (x, y) = ((index % width) as i32 - across, (index / width) as i32 - down);
            let (x, y) = match style.transform() {
                FontTransform::None => (x, y),
                FontTransform::Rotate90 => (-y, x),
                FontTransform::Rotate180 => (-x, -y),
                FontTransform::Rotate270 => (y, -x),
            };
            if let (Ok(x), Ok(y)) = (usize::try_from(place.0 + x), usize::try_from(place.1 + y)) {
                self.0.set(x, y, *colour);
            }
        }
        Ok(())
    }
}

/// Lines, one colour each, told apart by people who see few colours too.
pub const LINES: [Colour; 8] = [
    [0, 92, 170],
    [214, 84, 0],
    [0, 128, 96],
    [150, 40, 130],
    [120, 120, 120],
    [196, 160, 0],
    [90, 170, 220],
    [110, 60, 20],
];

/// A colour for the plotting library.
pub const fn paint(colour: Colour) -> plotters::style::RGBColor {
    plotters::style::RGBColor(colour[0], colour[1], colour[2])
}

/// Perceptually even colours from dark to light (Smith and van der Walt's "viridis", by its key colours).
pub fn heat(share: f64) -> Colour {
    const KEYS: [[f64; 3]; 6] = [
        [68.0, 1.0, 84.0],
        [65.0, 68.0, 135.0],
        [42.0, 120.0, 142.0],
        [34.0, 168.0, 132.0],
        [122.0, 209.0, 81.0],
        [253.0, 231.0, 37.0],
    ];
    let place = share.clamp(0.0, 1.0) * (KEYS.len() - 1) as f64;
    let below = (place.floor() as usize).min(KEYS.len() - 2);
    let along = place - below as f64;
    [0, 1, 2].map(|c| (KEYS[below][c] + (KEYS[below + 1][c] - KEYS[below][c]) * along).round() as u8)
}
