//! Pictures in eight bits a channel: pixels, text, PNG files.

mod error;
mod map;
mod shaded;
mod triptych;

pub use error::{error_picture, legend, verdict_picture, worst_verdict};
pub use map::{map_picture, map_picture_of_size};
pub use shaded::shaded_picture;
pub use triptych::{broken, labelled, triptych};

use std::path::Path;

use embedded_graphics::Drawable as _;
use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::mono_font::ascii::FONT_9X15;
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor as _};
use embedded_graphics::text::{Baseline, Text};

/// Font of all labels.
const FONT: &MonoFont<'_> = &FONT_9X15;

/// Height of a line of text with its margins.
pub const LINE_PIXELS: usize = 23;

/// Space around text.
const MARGIN_PIXELS: usize = 4;

/// Background of labels and legends.
pub const LABEL_BACKGROUND: Colour = [24, 26, 30];

/// Colour of text.
pub const INK: Colour = [240, 240, 236];

/// Red, green, blue; sRGB.
pub type Colour = [u8; 3];

/// A picture, row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// Colours.
    pub pixels: Vec<Colour>,
}

/// A picture that cannot be written.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {}: {source}; check that the folder exists and has space", path.display())]
pub struct PictureError {
    /// The file.
    pub path: std::path::PathBuf,
    /// What went wrong.
    pub source: png::EncodingError,
}

impl Picture {
    /// A picture of one colour.
    pub fn filled(width: usize, height: usize, colour: Colour) -> Self {
        Self { width, height, pixels: vec![colour; width * height] }
    }

    /// Sets a pixel; outside the picture nothing happens.
    pub fn set(&mut self, x: usize, y: usize, colour: Colour) {
        if x < self.width && y < self.height {
            self.pixels[y * self.width + x] = colour;
        }
    }

    /// Fills a rectangle, as far as it lies inside.
    pub fn fill(&mut self, x: usize, y: usize, width: usize, height: usize, colour: Colour) {
        for row in y..(y + height).min(self.height) {
            for column in x..(x + width).min(self.width) {
                self.set(column, row, colour);
            }
        }
    }

    /// Outlines a rectangle, one pixel wide, inside its edges.
    pub fn outline(&mut self, x: usize, y: usize, width: usize, height: usize, colour: Colour) {
        let (right, bottom) = (width.saturating_sub(1), height.saturating_sub(1));
        self.fill(x, y, width, 1, colour);
        self.fill(x, y + bottom, width, 1, colour);
        self.fill(x, y, 1, height, colour);
        self.fill(x + right, y, 1, height, colour);
    }

    /// Writes a line of text whose upper left corner is given; characters outside ASCII appear as question marks.
    pub fn text(&mut self, x: usize, y: usize, text: &str, colour: Colour) {
        let style = MonoTextStyle::new(FONT, Rgb888::new(colour[0], colour[1], colour[2]));
        let place = Point::new(x as i32, y as i32);
        // Drawing on a picture cannot fail.
        let _ = Text::with_baseline(text, place, style, Baseline::Top).draw(self);
    }

    /// Writes a line of text on a background strip across the picture's width.
    pub fn label(&mut self, y: usize, text: &str) {
        self.fill(0, y, self.width, LINE_PIXELS, LABEL_BACKGROUND);
        self.text(MARGIN_PIXELS, y + MARGIN_PIXELS, text, INK);
    }

    /// Width of a line of text in pixels.
    pub fn text_width(text: &str) -> usize {
        text.chars().count() * FONT.character_size.width as usize
    }

    /// Lines that a text takes on labels of a width.
    pub fn lines(text: &str, width: usize) -> Vec<String> {
        let letters = width.saturating_sub(2 * MARGIN_PIXELS) / FONT.character_size.width as usize;
        wrapped(text, letters.max(1))
    }

    /// Copies another picture, as far as it fits.
    pub fn paste(&mut self, other: &Self, x: usize, y: usize) {
        for row in 0..other.height {
            for column in 0..other.width {
                self.set(x + column, y + row, other.pixels[row * other.width + column]);
            }
        }
    }

    /// Pictures next to each other, each in a column as wide as itself.
    pub fn beside(pictures: &[Self]) -> Self {
        let width = pictures.iter().map(|picture| picture.width).sum();
        let height = pictures.iter().map(|picture| picture.height).max().unwrap_or(0);
        let mut joined = Self::filled(width, height, LABEL_BACKGROUND);
        let mut x = 0;
        for picture in pictures {
            joined.paste(picture, x, 0);
            x += picture.width;
        }
        joined
    }

    /// Pictures below each other.
    pub fn stacked(pictures: &[Self]) -> Self {
        let width = pictures.iter().map(|picture| picture.width).max().unwrap_or(0);
        let height = pictures.iter().map(|picture| picture.height).sum();
        let mut joined = Self::filled(width, height, LABEL_BACKGROUND);
        let mut y = 0;
        for picture in pictures {
            joined.paste(picture, 0, y);
            y += picture.height;
        }
        joined
    }

    /// The picture in a smaller size, each pixel by a rule from those it covers.
    pub fn shrunk(&self, width: usize, height: usize, rule: impl Fn(&[Colour]) -> Colour) -> Self {
        let mut shrunk = Self::filled(width, height, LABEL_BACKGROUND);
        let span = |index: usize, count: usize, of: usize| {
            let first = index * of / count;
            first..((index + 1) * of / count).max(first + 1).min(of)
        };
        let mut covered = Vec::new();
        for y in 0..height {
            for x in 0..width {
                covered.clear();
                for row in span(y, height, self.height) {
                    let columns = span(x, width, self.width);
                    covered.extend(columns.map(|column| self.pixels[row * self.width + column]));
                }
                shrunk.set(x, y, rule(&covered));
            }
        }
        shrunk
    }

    /// The picture under a line of text, as many lines as the text needs.
    pub fn titled(&self, text: &str) -> Self {
        let lines = Self::lines(text, self.width);
        let mut titled = Self::filled(self.width, self.height + lines.len() * LINE_PIXELS, LABEL_BACKGROUND);
        for (index, line) in lines.iter().enumerate() {
            titled.label(index * LINE_PIXELS, line);
        }
        titled.paste(self, 0, lines.len() * LINE_PIXELS);
        titled
    }

    /// Writes a PNG file.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_png(&self, path: &Path) -> Result<(), PictureError> {
        let fail = |source| PictureError { path: path.to_owned(), source };
        let file = std::fs::File::create(path).map_err(|error| fail(error.into()))?;
        self.encode(std::io::BufWriter::new(file)).map_err(fail)
    }

    /// The bytes of a PNG file.
    ///
    /// # Errors
    /// When the picture has no pixels.
    pub fn png_bytes(&self) -> Result<Vec<u8>, PictureError> {
        let mut bytes = Vec::new();
        let encoded = self.encode(&mut bytes);
        encoded.map_err(|source| PictureError { path: "a picture in memory".into(), source })?;
        Ok(bytes)
    }

    fn encode(&self, out: impl std::io::Write) -> Result<(), png::EncodingError> {
        let mut encoder = png::Encoder::new(out, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        writer.finish()
    }
}

/// Breaks text at spaces into lines of at most so many letters.
fn wrapped(text: &str, letters: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let last = lines.len() - 1;
        if lines[last].is_empty() {
            lines[last].push_str(word);
        } else if lines[last].len() + 1 + word.len() <= letters {
            lines[last].push(' ');
            lines[last].push_str(word);
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}

/// The mean of some colours.
pub fn mean(colours: &[Colour]) -> Colour {
    let count = colours.len().max(1);
    [0, 1, 2].map(|c| (colours.iter().map(|colour| usize::from(colour[c])).sum::<usize>() / count) as u8)
}

/// sRGB byte of a linear channel.
pub(crate) fn srgb_byte(linear: f64) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let encoded =
        if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055 };
    (encoded * 255.0).round() as u8
}

impl OriginDimensions for Picture {
    fn size(&self) -> Size {
        Size::new(self.width as u32, self.height as u32)
    }
}

impl DrawTarget for Picture {
    type Color = Rgb888;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(place, colour) in pixels {
            if let (Ok(x), Ok(y)) = (usize::try_from(place.x), usize::try_from(place.y)) {
                self.set(x, y, [colour.r(), colour.g(), colour.b()]);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_leaves_ink_inside_its_box() {
        let mut picture = Picture::filled(100, 40, [0; 3]);
        picture.text(5, 5, "Sun", [255; 3]);
        let inked: Vec<_> = (0..4000).filter(|index| picture.pixels[*index] != [0; 3]).collect();
        assert!(inked.len() > 30);
        assert!(inked.iter().all(|index| (5..5 + Picture::text_width("Sun")).contains(&(index % 100))));
        picture.text(95, 35, "cut off", [255; 3]);
    }

    #[test]
    fn files_hold_what_was_drawn() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("picture.png");
        let picture = Picture::filled(7, 5, [1, 2, 3]).titled("a b");
        picture.write_png(&path).unwrap();
        let mut reader = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(path).unwrap()))
            .read_info()
            .unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut bytes).unwrap();
        assert_eq!(bytes, picture.pixels.as_flattened());
        assert_eq!(picture.height, 5 + 2 * LINE_PIXELS, "narrow pictures wrap their title");
    }

    #[test]
    fn shrinking_follows_its_rule() {
        let mut picture = Picture::filled(4, 2, [10; 3]);
        picture.set(1, 1, [50; 3]);
        let shrunk = picture.shrunk(2, 1, mean);
        assert_eq!(shrunk.pixels, [[20; 3], [10; 3]]);
        let last = |colours: &[Colour]| colours[colours.len() - 1];
        assert_eq!(picture.shrunk(2, 1, last).pixels, [[50; 3], [10; 3]]);
        assert_eq!(picture.shrunk(8, 4, mean).pixels.len(), 32, "a larger size repeats pixels");
    }

    #[test]
    fn joined_pictures_keep_their_pixels() {
        let (one, two) = (Picture::filled(3, 2, [9; 3]), Picture::filled(4, 5, [7; 3]));
        let beside = Picture::beside(&[one.clone(), two.clone()]);
        assert_eq!((beside.width, beside.height, beside.pixels[3], beside.pixels[0]), (7, 5, [7; 3], [9; 3]));
        assert_eq!(Picture::stacked(&[one, two]).height, 7);
    }

    #[test]
    fn unwritable_files_are_typed_errors() {
        let error = Picture::filled(1, 1, [0; 3]).write_png(Path::new("/nowhere/picture.png")).unwrap_err();
        assert!(error.to_string().starts_with("cannot write /nowhere/picture.png"), "{error}");
    }
}
