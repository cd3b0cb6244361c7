//! A frame as an OpenEXR file: single part, 32-bit float channels, sky as NaN.

use std::path::Path;

use cssm_core::glam::DVec3;
use exr::prelude::{
    AnyChannel, AnyChannels, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes, SmallVec,
    WritableImage as _,
};

use crate::score::{NO_FACET, PixelFootprint};
use crate::truth::{Frame, Visible};

/// A frame that cannot be written.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {}: {source}; check that the folder exists and has space", path.display())]
pub struct ExrError {
    /// The file.
    pub path: std::path::PathBuf,
    /// What went wrong.
    pub source: exr::error::Error,
}

/// What a frame's file holds besides the truth.
#[derive(Debug, Clone, Copy)]
pub struct FrameLayers<'a> {
    /// The traced frame.
    pub frame: &'a Frame,
    /// Visibility that the map gives.
    pub visibility: &'a [f32],
    /// Facet of each pixel.
    pub facets: &'a [u32],
    /// Footprints of each pixel.
    pub footprints: &'a [Option<PixelFootprint>],
}

impl FrameLayers<'_> {
    /// Channel names and samples.
    pub fn channels(&self) -> Vec<(&'static str, Vec<f32>)> {
        let surface = |value: &dyn Fn(usize, &Visible) -> f64| -> Vec<f32> {
            let sample = |(index, pixel): (usize, &Option<Visible>)| {
                pixel.as_ref().map_or(f32::NAN, |pixel| value(index, pixel) as f32)
            };
            self.frame.pixels.iter().enumerate().map(sample).collect()
        };
        let axis = |value: fn(&Visible) -> DVec3, axis: usize| surface(&|_, pixel| value(pixel)[axis]);
        let facet = |index: usize| match self.facets[index] {
            NO_FACET => f64::NAN,
            facet => f64::from(facet),
        };
        vec![
            ("position.X", axis(|pixel| pixel.position, 0)),
            ("position.Y", axis(|pixel| pixel.position, 1)),
            ("position.Z", axis(|pixel| pixel.position, 2)),
            ("normal.X", axis(|pixel| pixel.normal, 0)),
            ("normal.Y", axis(|pixel| pixel.normal, 1)),
            ("normal.Z", axis(|pixel| pixel.normal, 2)),
            ("visibility.map", surface(&|index, _| f64::from(self.visibility[index]))),
            ("visibility.truth", surface(&|_, pixel| f64::from(u8::from(pixel.lit)))),
            ("facet", surface(&|index, _| facet(index))),
            ("footprint", surface(&|index, _| self.footprints[index].map_or(f64::NAN, |f| f.volume_pixels))),
        ]
    }

    /// Writes the file.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_exr(&self, path: &Path) -> Result<(), ExrError> {
        let channels: SmallVec<[AnyChannel<FlatSamples>; 4]> = self
            .channels()
            .into_iter()
            .map(|(name, samples)| AnyChannel::new(name, FlatSamples::F32(samples)))
            .collect();
        let encoding = Encoding { compression: Compression::ZIP16, ..Encoding::SMALL_LOSSLESS };
        let layer = Layer::new(
            (self.frame.width, self.frame.height),
            LayerAttributes::default(),
            encoding,
            AnyChannels::sort(channels),
        );
        let fail = |source| ExrError { path: path.to_owned(), source };
        Image::from_layer(layer).write().to_file(path).map_err(fail)
    }
}

#[cfg(test)]
mod tests {
    use exr::prelude::read_first_flat_layer_from_file;

    use super::*;

    #[test]
    fn files_hold_named_float_channels_and_nan_for_sky() {
        let visible = Visible {
            position: DVec3::new(1.5, -2.5, -8.0),
            normal: DVec3::Y,
            cosine: 0.5,
            light_metres: f64::INFINITY,
            depth: 8.0,
            instance: 3,
            triangle: 9,
            reached: true,
            lit: true,
        };
        let footprint = PixelFootprint { volume_pixels: 1.25, geometric_pixels: 1.0, surface_pixels: 2.0 };
        let frame = Frame { width: 2, height: 1, pixels: vec![Some(visible), None] };
        let layers = FrameLayers {
            frame: &frame,
            visibility: &[0.25, 1.0],
            facets: &[5, NO_FACET],
            footprints: &[Some(footprint), None],
        };
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frame.exr");
        layers.write_exr(&path).unwrap();
        let image = read_first_flat_layer_from_file(&path).unwrap();
        let mut names = Vec::new();
        for channel in &image.layer_data.channel_data.list {
            let FlatSamples::F32(samples) = &channel.sample_data else {
                panic!("{} is not 32-bit", channel.name)
            };
            names.push((channel.name.to_string(), samples[0]));
            assert!(samples[1].is_nan(), "{}", channel.name);
        }
        let expected = [
            ("facet", 5.0),
            ("footprint", 1.25),
            ("normal.X", 0.0),
            ("normal.Y", 1.0),
            ("normal.Z", 0.0),
            ("position.X", 1.5),
            ("position.Y", -2.5),
            ("position.Z", -8.0),
            ("visibility.map", 0.25),
            ("visibility.truth", 1.0),
        ];
        assert_eq!(names, expected.map(|(name, value)| (name.to_owned(), value)));
    }
}
