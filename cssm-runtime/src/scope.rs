//! Error scopes: whatever the device refuses becomes a typed error, on this thread and without any callback.

use std::future::Future;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

use crate::error::ServiceError;

/// Runs `create` under error scopes of its own.
///
/// Natively the scopes answer at once. In a browser they answer later; an error that has not arrived yet is
/// reported by the browser's console and, for good, by the next submission.
pub(crate) fn checked<T>(
    device: &wgpu::Device,
    what: &'static str,
    create: impl FnOnce() -> T,
) -> Result<T, ServiceError> {
    let memory = device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
    let internal = device.push_error_scope(wgpu::ErrorFilter::Internal);
    let validation = device.push_error_scope(wgpu::ErrorFilter::Validation);
    let created = create();

    // Pop every scope, in reverse order, before reporting the first error.
    let errors = [now(validation.pop()), now(internal.pop()), now(memory.pop())];
    match errors.into_iter().flatten().flatten().next() {
        None => Ok(created),
        Some(wgpu::Error::OutOfMemory { .. }) => Err(ServiceError::OutOfMemory { what }),
        Some(error) => Err(ServiceError::Refused { what, reason: flat(&error.to_string()) }),
    }
}

/// The result of a future that is ready, without waiting for one that is not.
fn now<T>(future: impl Future<Output = T>) -> Option<T> {
    match pin!(future).poll(&mut Context::from_waker(Waker::noop())) {
        Poll::Ready(output) => Some(output),
        Poll::Pending => None,
    }
}

/// The lines of a report as one.
fn flat(report: &str) -> String {
    report.split_whitespace().collect::<Vec<_>>().join(" ")
}
