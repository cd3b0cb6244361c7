//! Alpha masks of glTF materials: `alphaMode: MASK` with the alpha of the base colour's texture.
//!
//! Coordinates repeat whatever the sampler says, and vertex colours do not count.

use std::io::Cursor;
use std::path::Path;

use gltf::accessor::Dimensions;
use gltf::material::AlphaMode;

use super::AlphaMask;
use super::gltf_file::{SceneFileError, read_uri};
use super::gltf_read::{read, view_bytes};

/// Cutoff of materials that name none, as glTF 2.0 defines it.
const DEFAULT_CUTOFF: f32 = 0.5;

/// A cutoff that no alpha reaches.
const NEVER_REACHED: f32 = 2.0;

/// Largest side of an image in texels.
const IMAGE_SIDE_LIMIT: u32 = 16384;

/// Most bytes that decoding an image may take.
const IMAGE_BYTES_LIMIT: usize = 1 << 30;

const JPEG_START: [u8; 2] = [0xff, 0xd8];

/// The mask of a primitive; `None` where it has no holes.
pub(super) fn read_mask(
    mesh: usize,
    primitive: &gltf::Primitive<'_>,
    vertices: usize,
    buffers: &[Vec<u8>],
    document_path: &Path,
) -> Result<Option<AlphaMask>, SceneFileError> {
    let material = primitive.material();
    if material.alpha_mode() != AlphaMode::Mask {
        return Ok(None);
    }

    // The material's own alpha multiplies the texture's: divide the cutoff by it.
    let surface = material.pbr_metallic_roughness();
    let cutoff = material.alpha_cutoff().unwrap_or(DEFAULT_CUTOFF);
    let factor = surface.base_color_factor()[3];
    let cutoff = match (cutoff > 0.0, factor > 0.0) {
        (false, _) => return Ok(None),
        (true, false) => NEVER_REACHED,
        (true, true) => (cutoff / factor).min(NEVER_REACHED),
    };
    let image = match surface.base_color_texture() {
        None => None,
        Some(info) => {
            let image = info.texture().source();
            decoded(&image, buffers, document_path)?.map(|pixels| (info, pixels))
        }
    };

    // Without a texture's alpha the mask keeps all or nothing.
    let Some((info, Alpha { width, height, alpha })) = image else {
        let uvs = vec![[0.0; 2]; vertices];
        return Ok((cutoff > 1.0).then(|| AlphaMask { uvs, width: 1, height: 1, alpha: vec![255], cutoff }));
    };
    let fail = |why| SceneFileError::Primitive { mesh, primitive: primitive.index(), why };
    let (set, placed) = placement(&info);
    let accessor = primitive
        .get(&gltf::Semantic::TexCoords(set))
        .ok_or_else(|| fail("has an alpha mask but not its texture coordinates"))?;
    let uvs: Vec<[f32; 2]> = read::<2>(&accessor, Dimensions::Vec2, buffers)?
        .into_iter()
        .map(|uv| placed(uv).map(|coordinate| coordinate as f32))
        .collect();
    if uvs.len() != vertices {
        return Err(fail("has another number of texture coordinates than vertices"));
    }
    if uvs.iter().flatten().any(|coordinate| !coordinate.is_finite()) {
        return Err(fail("has a texture coordinate that is not finite"));
    }
    let mask = AlphaMask { uvs, width, height, alpha, cutoff };
    Ok((mask.hole_share() > 0.0).then_some(mask))
}

/// The set of texture coordinates of a texture, and what its transform does to them.
fn placement(info: &gltf::texture::Info<'_>) -> (u32, impl Fn([f64; 2]) -> [f64; 2]) {
    let transform = info.texture_transform();
    let set = transform.as_ref().and_then(|transform| transform.tex_coord()).unwrap_or(info.tex_coord());
    let (offset, rotation, scale) = transform.map_or(([0.0; 2], 0.0, [1.0; 2]), |transform| {
        (transform.offset().map(f64::from), f64::from(transform.rotation()), transform.scale().map(f64::from))
    });
    let (sin, cos) = libm::sincos(rotation);
    let placed = move |[u, v]: [f64; 2]| {
        let (u, v) = (u * scale[0], v * scale[1]);
        [offset[0] + cos * u + sin * v, offset[1] - sin * u + cos * v]
    };
    (set, placed)
}

/// The alpha channel of an image.
struct Alpha {
    width: u32,
    height: u32,
    alpha: Vec<u8>,
}

/// Decodes an image; `None` for kinds of images without alpha.
fn decoded(
    image: &gltf::Image<'_>,
    buffers: &[Vec<u8>],
    document_path: &Path,
) -> Result<Option<Alpha>, SceneFileError> {
    let fail = |why: String| SceneFileError::Image { image: image.index(), why };
    let bytes = match image.source() {
        gltf::image::Source::View { view, .. } => view_bytes(&view, 0, buffers)
            .map(<[u8]>::to_vec)
            .ok_or_else(|| fail("its view leaves the buffer".to_owned()))?,
        gltf::image::Source::Uri { uri, .. } => read_uri(uri, document_path).map_err(fail)?,
    };
    if bytes.starts_with(&JPEG_START) {
        return Ok(None);
    }
    png_alpha(bytes).map(Some).map_err(fail)
}

fn png_alpha(bytes: Vec<u8>) -> Result<Alpha, String> {
    let said = |error: png::DecodingError| format!("it is no PNG or JPEG image ({error})");
    let limits = png::Limits { bytes: IMAGE_BYTES_LIMIT };
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), limits);
    decoder.set_transformations(png::Transformations::normalize_to_color8() | png::Transformations::ALPHA);
    let mut reader = decoder.read_info().map_err(said)?;
    let (width, height) = (reader.info().width, reader.info().height);
    if width.max(height) > IMAGE_SIDE_LIMIT {
        return Err(format!("it has {width} x {height} texels, more than {IMAGE_SIDE_LIMIT} a side"));
    }
    let size = reader.output_buffer_size().filter(|size| *size <= IMAGE_BYTES_LIMIT);
    let mut pixels = vec![0; size.ok_or_else(|| "it is too large".to_owned())?];
    reader.next_frame(&mut pixels).map_err(said)?;

    // Alpha is the last channel of each pixel, after one or three others.
    let channels = reader.output_color_type().0.samples();
    let alpha = pixels.chunks_exact(channels).map(|pixel| pixel[channels - 1]).collect();
    Ok(Alpha { width, height, alpha })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn encoded(color: png::ColorType, data: &[u8]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 2, 1);
        encoder.set_color(color);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.write_header().unwrap().write_image_data(data).unwrap();
        bytes
    }

    #[test]
    fn alpha_is_read_from_every_kind_of_png() {
        let alpha = |color, data: &[u8]| png_alpha(encoded(color, data)).unwrap().alpha;
        assert_eq!(alpha(png::ColorType::Rgba, &[1, 2, 3, 40, 5, 6, 7, 80]), [40, 80]);
        assert_eq!(alpha(png::ColorType::GrayscaleAlpha, &[1, 20, 3, 30]), [20, 30]);
        assert_eq!(alpha(png::ColorType::Rgb, &[1, 2, 3, 4, 5, 6]), [255, 255]);
        assert_eq!(alpha(png::ColorType::Grayscale, &[1, 2]), [255, 255]);
    }

    #[test]
    fn cut_images_are_refused() {
        let whole = encoded(png::ColorType::Rgba, &[1, 2, 3, 40, 5, 6, 7, 80]);
        for length in 0..whole.len() - 12 {
            assert!(png_alpha(whole[..length].to_vec()).is_err(), "cut at {length}");
        }
    }
}
