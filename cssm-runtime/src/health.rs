//! Is the device still there?
//!
//! After a loss wgpu goes on as if nothing had happened: error scopes stay empty, submissions and polls succeed,
//! and the only public sign is the one device-lost callback, which belongs to the engine. Mapping a buffer is the
//! exception: it reports to the caller of that very mapping. The probe maps four bytes of its own.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use crate::scope::checked;

/// A buffer whose mapping fails when the device is lost.
#[derive(Debug)]
pub(crate) struct HealthProbe {
    buffer: Mutex<wgpu::Buffer>,
    verdict: Arc<Verdict>,
}

#[derive(Debug, Default)]
struct Verdict {
    /// Number of the running mapping; answers to earlier ones, which were cancelled, do not count.
    running: AtomicU64,
    lost: AtomicBool,
}

impl HealthProbe {
    /// A probe of a device; to be created under an error scope.
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("cssm health probe"),
            size: 4,
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Self { buffer: Mutex::new(buffer), verdict: Arc::default() }
    }

    /// Whether the device is lost. Natively a lost device refuses the mapping before `map_async` returns; in a
    /// browser the refusal arrives later and the next call tells.
    pub(crate) fn device_lost(&self, device: &wgpu::Device) -> bool {
        let verdict = &self.verdict;
        if verdict.lost.load(Ordering::Acquire) {
            return true;
        }

        // Cancel the previous mapping, whose answer no longer counts, and start another one.
        let buffer = self.buffer.lock().unwrap_or_else(PoisonError::into_inner);
        let number = verdict.running.fetch_add(1, Ordering::AcqRel) + 1;
        let answer = Arc::clone(verdict);
        let mapping = checked(device, "a health probe", || {
            if number > 1 {
                buffer.unmap();
            }
            buffer.map_async(wgpu::MapMode::Read, .., move |result| {
                if result.is_err() && answer.running.load(Ordering::Acquire) == number {
                    answer.lost.store(true, Ordering::Release);
                }
            });
        });

        // A device that is there maps; whatever else it says comes from its end.
        if mapping.is_err() {
            verdict.lost.store(true, Ordering::Release);
        }
        verdict.lost.load(Ordering::Acquire)
    }
}
