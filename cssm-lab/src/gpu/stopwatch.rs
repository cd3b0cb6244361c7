//! Times of the capture and the resolve pass.

use std::time::Instant;

use cssm_runtime::{ServiceError, read_back};

use super::{Gpu, GpuError};

/// Beginning and end of two passes.
const STAMPS: u32 = 4;

/// Times passes: by timestamps where the device has them, else by the wall clock around a submit and a wait.
#[derive(Debug)]
pub struct Stopwatch {
    stamps: Option<Stamps>,
}

#[derive(Debug)]
struct Stamps {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    readable: wgpu::Buffer,
    milliseconds_per_tick: f64,
}

/// Milliseconds of one run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassTimes {
    /// Rendering casters into the map.
    pub capture_milliseconds: f64,
    /// From the map to visibility.
    pub resolve_milliseconds: f64,
}

impl Stopwatch {
    /// A stopwatch for a device.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn new(gpu: &Gpu) -> Result<Self, GpuError> {
        if !gpu.has_timestamps() {
            return Ok(Self { stamps: None });
        }
        let size = u64::from(STAMPS) * u64::from(wgpu::QUERY_SIZE);
        let stamps = gpu.checked("timestamps", || {
            let buffer = |usage| {
                gpu.device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("timestamps"),
                    size,
                    usage,
                    mapped_at_creation: false,
                })
            };
            Stamps {
                queries: gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
                    label: Some("timestamps"),
                    ty: wgpu::QueryType::Timestamp,
                    count: STAMPS,
                }),
                resolved: buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC),
                readable: buffer(wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ),
                milliseconds_per_tick: f64::from(gpu.queue.get_timestamp_period()) * 1e-6,
            }
        })?;
        Ok(Self { stamps: Some(stamps) })
    }

    /// What times are taken by, for reports.
    pub const fn method(&self) -> &'static str {
        if self.stamps.is_some() { "device timestamps" } else { "wall clock around submit and wait" }
    }

    /// Runs a capture and a resolve pass and times both.
    pub(super) fn time(
        &self,
        gpu: &Gpu,
        capture: impl FnOnce(&mut wgpu::CommandEncoder, Option<Writes<'_>>) -> Result<(), GpuError>,
        resolve: impl FnOnce(&mut wgpu::CommandEncoder, Option<Writes<'_>>) -> Result<(), GpuError>,
    ) -> Result<PassTimes, GpuError> {
        let encoder = || gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let Some(stamps) = &self.stamps else {
            let mut first = encoder();
            capture(&mut first, None)?;
            let capture_milliseconds = wall_milliseconds(gpu, first)?;
            let mut second = encoder();
            resolve(&mut second, None)?;
            return Ok(PassTimes {
                capture_milliseconds,
                resolve_milliseconds: wall_milliseconds(gpu, second)?,
            });
        };

        // Stamp both passes in one submission.
        let mut both = encoder();
        capture(&mut both, Some(stamps.writes(0)))?;
        resolve(&mut both, Some(stamps.writes(2)))?;
        gpu.checked("timed passes", || {
            both.resolve_query_set(&stamps.queries, 0..STAMPS, &stamps.resolved, 0);
            both.copy_buffer_to_buffer(&stamps.resolved, 0, &stamps.readable, 0, stamps.readable.size());
            gpu.queue.submit([both.finish()])
        })?;
        let bytes = read_back::mapped_bytes(&gpu.device, &stamps.readable)?;
        let ticks: Vec<u64> = bytes.as_chunks().0.iter().map(|bytes| u64::from_le_bytes(*bytes)).collect();
        let between = |start: usize| {
            let ticks = ticks
                .get(start + 1)
                .zip(ticks.get(start))
                .map_or(0, |(end, start)| end.saturating_sub(*start));
            ticks as f64 * stamps.milliseconds_per_tick
        };
        Ok(PassTimes { capture_milliseconds: between(0), resolve_milliseconds: between(2) })
    }
}

/// Where a pass writes its timestamps.
type Writes<'a> = wgpu::RenderPassTimestampWrites<'a>;

impl Stamps {
    const fn writes(&self, first: u32) -> Writes<'_> {
        wgpu::RenderPassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(first),
            end_of_pass_write_index: Some(first + 1),
        }
    }
}

fn wall_milliseconds(gpu: &Gpu, encoder: wgpu::CommandEncoder) -> Result<f64, GpuError> {
    let start = Instant::now();
    gpu.checked("timed passes", || gpu.queue.submit([encoder.finish()]))?;
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|_| ServiceError::DeviceLost)?;
    Ok(start.elapsed().as_secs_f64() * 1e3)
}
