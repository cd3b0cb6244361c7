//! Textures and buffers back to the CPU, for tests, tools and screenshots. Everything here blocks until the GPU is done.

use crate::error::ServiceError;
use crate::scope::checked;

/// The bytes of a texture's first layer and level, rows packed tightly.
///
/// Submits a copy, then waits; callbacks of the engine that are due run inside. Not for browsers, which cannot wait.
///
/// # Errors
/// [`ServiceError::Refused`] for textures without `COPY_SRC` usage, [`ServiceError::DeviceLost`],
/// [`ServiceError::ReadBack`] for formats without a copyable aspect.
pub fn texture_bytes(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    texture: &wgpu::Texture,
) -> Result<Vec<u8>, ServiceError> {
    let aspect = if texture.format().has_depth_aspect() {
        wgpu::TextureAspect::DepthOnly
    } else {
        wgpu::TextureAspect::All
    };
    let texel = texture
        .format()
        .block_copy_size(Some(aspect))
        .filter(|_| texture.format().block_dimensions() == (1, 1));
    let texel = texel.ok_or(ServiceError::ReadBack { why: "its format has no texels to copy" })?;
    let (width, height) = (texture.width(), texture.height());
    let packed = width * texel;
    let padded = packed.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);

    // Copy into rows of the alignment that copies demand.
    let buffer = checked(device, "a copy of a texture", || {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("cssm read-back"),
            size: u64::from(padded) * u64::from(height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_texture_to_buffer(
            wgpu::TexelCopyTextureInfo { texture, mip_level: 0, origin: wgpu::Origin3d::ZERO, aspect },
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(padded),
                    rows_per_image: None,
                },
            },
            wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        );
        queue.submit([encoder.finish()]);
        buffer
    })?;

    // Wait for it and drop the padding.
    let bytes = mapped_bytes(device, &buffer)?;
    let rows = bytes.chunks_exact(padded as usize).flat_map(|row| &row[..packed as usize]);
    Ok(rows.copied().collect())
}

/// The bytes of a buffer with `COPY_SRC` usage, after all submitted work.
///
/// # Errors
/// As [`texture_bytes`].
pub fn buffer_bytes(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    source: &wgpu::Buffer,
) -> Result<Vec<u8>, ServiceError> {
    let copy = checked(device, "a copy of a buffer", || {
        let copy = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("cssm read-back"),
            size: source.size(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(source, 0, &copy, 0, source.size());
        queue.submit([encoder.finish()]);
        copy
    })?;
    mapped_bytes(device, &copy)
}

/// The bytes of a buffer with `MAP_READ` usage, after all submitted work.
///
/// # Errors
/// [`ServiceError::DeviceLost`] when the mapping fails, [`ServiceError::Refused`] for buffers without the usage.
pub fn mapped_bytes(device: &wgpu::Device, buffer: &wgpu::Buffer) -> Result<Vec<u8>, ServiceError> {
    let (sender, receiver) = std::sync::mpsc::channel();
    checked(device, "a mapped buffer", || {
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // The receiver outlives the wait below; a vanished one means nobody asks any more.
            let _ = sender.send(result);
        });
    })?;
    device.poll(wgpu::PollType::wait_indefinitely()).map_err(|_| ServiceError::DeviceLost)?;
    match receiver.try_recv() {
        Ok(Ok(())) => {}
        _ => return Err(ServiceError::DeviceLost),
    }
    let bytes = buffer.get_mapped_range(..).map(|view| view.to_vec());
    buffer.unmap();
    bytes.map_err(|_| ServiceError::ReadBack { why: "its copy could not be mapped" })
}
