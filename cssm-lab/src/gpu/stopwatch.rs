//! Times of passes.

use std::time::Instant;

use cssm_runtime::{ServiceError, read_back};

use super::{Gpu, GpuError};

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

/// Where a pass writes its timestamps.
pub type Writes<'a> = wgpu::RenderPassTimestampWrites<'a>;

/// Records one pass.
pub type RecordPass<'a> =
    dyn FnMut(&mut wgpu::CommandEncoder, Option<Writes<'_>>) -> Result<(), GpuError> + 'a;

/// Milliseconds of one run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassTimes {
    /// Rendering casters into the map.
    pub capture_milliseconds: f64,
    /// From the map to visibility.
    pub resolve_milliseconds: f64,
}

/// Milliseconds of several passes that ran one after another.
#[derive(Debug, Clone, PartialEq)]
pub struct SequenceTimes {
    /// Of each pass.
    pub passes_milliseconds: Vec<f64>,
    /// From the beginning of the first to the end of the last.
    pub whole_milliseconds: f64,
}

impl Stopwatch {
    /// A stopwatch for sequences of at most so many passes on a device.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn new(gpu: &Gpu, passes: u32) -> Result<Self, GpuError> {
        if !gpu.has_timestamps() {
            return Ok(Self { stamps: None });
        }
        let count = 2 * passes.max(1);
        let size = u64::from(count) * u64::from(wgpu::QUERY_SIZE);
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
                    count,
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

    /// Runs passes one after another and times each; there are no more of them than the stopwatch was made for.
    ///
    /// # Errors
    /// What a pass or the device says.
    pub fn time_sequence(
        &self,
        gpu: &Gpu,
        passes: &mut [&mut RecordPass<'_>],
    ) -> Result<SequenceTimes, GpuError> {
        match &self.stamps {
            Some(stamps) => stamps.time(gpu, passes),
            None => wall_times(gpu, passes),
        }
    }

    /// Runs a capture and a resolve pass and times both.
    pub(super) fn time(
        &self,
        gpu: &Gpu,
        capture: &mut RecordPass<'_>,
        resolve: &mut RecordPass<'_>,
    ) -> Result<PassTimes, GpuError> {
        let times = self.time_sequence(gpu, &mut [capture, resolve])?.passes_milliseconds;
        let pass = |index: usize| times.get(index).copied().unwrap_or_default();
        Ok(PassTimes { capture_milliseconds: pass(0), resolve_milliseconds: pass(1) })
    }
}

impl Stamps {
    /// Stamps all passes in one submission.
    fn time(&self, gpu: &Gpu, passes: &mut [&mut RecordPass<'_>]) -> Result<SequenceTimes, GpuError> {
        let mut encoder = encoder(gpu);
        for (pass, first) in passes.iter_mut().zip((0..self.queries.count()).step_by(2)) {
            pass(&mut encoder, Some(self.writes(first)))?;
        }
        let used = (2 * passes.len() as u32).min(self.queries.count());
        gpu.checked("timed passes", || {
            encoder.resolve_query_set(&self.queries, 0..used, &self.resolved, 0);
            encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.readable, 0, self.readable.size());
            gpu.queue.submit([encoder.finish()])
        })?;

        // Read the ticks.
        let bytes = read_back::mapped_bytes(&gpu.device, &self.readable)?;
        let ticks: Vec<u64> = bytes.as_chunks().0.iter().map(|bytes| u64::from_le_bytes(*bytes)).collect();
        let ticks = ticks.get(..used as usize).unwrap_or_default();
        let milliseconds = |from: u64, to: u64| to.saturating_sub(from) as f64 * self.milliseconds_per_tick;
        let whole = ticks.first().zip(ticks.last());
        Ok(SequenceTimes {
            passes_milliseconds: ticks
                .as_chunks()
                .0
                .iter()
                .map(|[from, to]| milliseconds(*from, *to))
                .collect(),
            whole_milliseconds: whole.map_or(0.0, |(from, to)| milliseconds(*from, *to)),
        })
    }

    const fn writes(&self, first: u32) -> Writes<'_> {
        wgpu::RenderPassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(first),
            end_of_pass_write_index: Some(first + 1),
        }
    }
}

/// Submits and waits for every pass by itself.
fn wall_times(gpu: &Gpu, passes: &mut [&mut RecordPass<'_>]) -> Result<SequenceTimes, GpuError> {
    let mut passes_milliseconds = Vec::with_capacity(passes.len());
    for pass in passes {
        let mut encoder = encoder(gpu);
        pass(&mut encoder, None)?;
        let start = Instant::now();
        gpu.checked("timed passes", || gpu.queue.submit([encoder.finish()]))?;
        gpu.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|_| ServiceError::DeviceLost)?;
        passes_milliseconds.push(start.elapsed().as_secs_f64() * 1e3);
    }
    let whole_milliseconds = passes_milliseconds.iter().sum();
    Ok(SequenceTimes { passes_milliseconds, whole_milliseconds })
}

fn encoder(gpu: &Gpu) -> wgpu::CommandEncoder {
    gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default())
}
