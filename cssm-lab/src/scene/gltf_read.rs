//! Reads accessors of a glTF document without trusting any number in it.

use gltf::accessor::{DataType, Dimensions};

use super::gltf_file::SceneFileError;

/// Elements of an accessor, `N` components each, converted to f64; normalised integers become [-1, 1] or [0, 1].
pub(super) fn read<const N: usize>(
    accessor: &gltf::Accessor<'_>,
    dimensions: Dimensions,
    buffers: &[Vec<u8>],
) -> Result<Vec<[f64; N]>, SceneFileError> {
    let fail = |why: &str| SceneFileError::Accessor { accessor: accessor.index(), why: why.to_owned() };
    if accessor.dimensions() != dimensions {
        return Err(fail(&format!("it holds {:?} where {dimensions:?} is needed", accessor.dimensions())));
    }
    let data_type = accessor.data_type();
    let normalized = accessor.normalized();
    let element = |bytes: &[u8]| -> Option<[f64; N]> {
        let mut values = [0.0; N];
        for (index, value) in values.iter_mut().enumerate() {
            *value = component(bytes.get(index * data_type.size()..)?, data_type, normalized)?;
        }
        Some(values)
    };

    // Read the dense part; without a view it is zero.
    let element_bytes = N * data_type.size();
    let mut elements = match accessor.view() {
        Some(view) => {
            let stride = view.stride().unwrap_or(element_bytes);
            let bytes = view_bytes(&view, accessor.offset(), buffers)
                .ok_or_else(|| fail("its view leaves the buffer"))?;
            strided(bytes, stride, element_bytes, accessor.count())
                .and_then(|slices| slices.map(element).collect::<Option<Vec<_>>>())
                .ok_or_else(|| fail("it reads past the end of its view"))?
        }
        None if accessor.sparse().is_some() => {
            if accessor.count() > SPARSE_LIMIT {
                return Err(fail("it is sparse and too long"));
            }
            vec![[0.0; N]; accessor.count()]
        }
        None => return Err(fail("it has neither a buffer view nor sparse values")),
    };

    // Replace the sparse part.
    if let Some(sparse) = accessor.sparse() {
        let (indices, values) = (sparse.indices(), sparse.values());
        let index_type = match indices.index_type() {
            gltf::accessor::sparse::IndexType::U8 => DataType::U8,
            gltf::accessor::sparse::IndexType::U16 => DataType::U16,
            gltf::accessor::sparse::IndexType::U32 => DataType::U32,
        };
        let past_end = || fail("its sparse part reads past the end of its view");
        let index_bytes = view_bytes(&indices.view(), indices.offset(), buffers).ok_or_else(past_end)?;
        let value_bytes = view_bytes(&values.view(), values.offset(), buffers).ok_or_else(past_end)?;
        let targets = strided(index_bytes, index_type.size(), index_type.size(), sparse.count())
            .ok_or_else(past_end)?;
        let values =
            strided(value_bytes, element_bytes, element_bytes, sparse.count()).ok_or_else(past_end)?;
        for (target, value) in targets.zip(values) {
            let target = component(target, index_type, false).ok_or_else(past_end)? as usize;
            let slot = elements.get_mut(target).ok_or_else(|| fail("a sparse index lies outside it"))?;
            *slot = element(value).ok_or_else(past_end)?;
        }
    }
    Ok(elements)
}

/// Largest number of elements that need no bytes in the file.
const SPARSE_LIMIT: usize = 1 << 24;

/// Bytes of a buffer view from an offset on; `None` when it leaves its buffer.
pub(super) fn view_bytes<'a>(
    view: &gltf::buffer::View<'_>,
    offset: usize,
    buffers: &'a [Vec<u8>],
) -> Option<&'a [u8]> {
    let end = view.offset().checked_add(view.length())?;
    buffers.get(view.buffer().index())?.get(view.offset()..end)?.get(offset..)
}

/// `count` slices of `length` bytes, `stride` apart; `None` when the bytes do not hold them all.
fn strided(
    bytes: &[u8],
    stride: usize,
    length: usize,
    count: usize,
) -> Option<impl Iterator<Item = &[u8]> + '_> {
    if count > 0 {
        let last = stride.checked_mul(count - 1)?.checked_add(length)?;
        if last > bytes.len() || stride == 0 {
            return None;
        }
    }
    Some((0..count).map(move |index| &bytes[index * stride..index * stride + length]))
}

fn component(bytes: &[u8], data_type: DataType, normalized: bool) -> Option<f64> {
    let (value, largest) = match data_type {
        DataType::I8 => (f64::from(i8::from_le_bytes(*bytes.first_chunk()?)), 127.0),
        DataType::U8 => (f64::from(*bytes.first()?), 255.0),
        DataType::I16 => (f64::from(i16::from_le_bytes(*bytes.first_chunk()?)), 32767.0),
        DataType::U16 => (f64::from(u16::from_le_bytes(*bytes.first_chunk()?)), 65535.0),
        DataType::U32 => (f64::from(u32::from_le_bytes(*bytes.first_chunk()?)), f64::from(u32::MAX)),
        DataType::F32 => return Some(f64::from(f32::from_le_bytes(*bytes.first_chunk()?))),
    };
    Some(if normalized { f64::max(value / largest, -1.0) } else { value })
}
