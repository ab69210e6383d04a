//! The exit statuses that schedulers tell apart.

use lightfall::commands::Stop;
use lightfall_core::gpu::GpuError;
use lightfall_picture::PictureError;
use lightfall_platform::storage::WriteError;
use std::io::ErrorKind;
use std::path::Path;

fn failed(error: GpuError) -> PictureError {
    error.into()
}

fn written(kind: ErrorKind) -> PictureError {
    WriteError::new(Path::new("a.png"), kind.into()).into()
}

#[test]
fn what_may_be_gone_later_is_status_75_and_a_request_to_end_143() {
    for (error, status, words) in [
        (
            failed(GpuError::Device("lost".into())),
            75,
            "may succeed later",
        ),
        (
            failed(GpuError::OutOfMemory("full".into())),
            75,
            "may succeed later",
        ),
        (failed(GpuError::Invalid("no".into())), 1, "refuses"),
        (
            written(ErrorKind::StorageFull),
            75,
            "a.png: cannot be written",
        ),
        (
            written(ErrorKind::QuotaExceeded),
            75,
            "a.png: cannot be written",
        ),
        (
            written(ErrorKind::PermissionDenied),
            1,
            "a.png: cannot be written",
        ),
        (PictureError::Terminated, 143, "asked to end (SIGTERM)"),
        (PictureError::Interrupted, 130, "interrupted"),
    ] {
        let stop = Stop::from(error);
        assert_eq!(stop.status, status, "{stop}");
        assert!(stop.sentence.contains(words), "{stop}");
    }
}
