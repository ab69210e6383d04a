//! Why a command stops before it is done.

use lightfall_core::gpu::GpuError;
use lightfall_picture::PictureError;
use lightfall_platform::storage::{SourceError, WriteError};
use lightfall_platform::termination::TERMINATED;
use std::error::Error;
use std::fmt::{Display, Formatter};
use std::io::ErrorKind;

/// The exit status where the same command may succeed later or on another machine: the device was lost, or
/// memory or the disk is full for now. It is EX_TEMPFAIL of BSD's sysexits.h, on which schedulers try again.
const TRY_AGAIN: u8 = 75;

/// Why a command stops: an exit status and one sentence, or one in each line for the faults of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stop {
    /// Exit status: 2 for a bad command line, preset, journey or file of rays, 130 for an
    /// interruption, 143 after a request to end, 75 where another attempt may succeed, 1 for any other
    /// failure.
    pub status: u8,
    /// The reason.
    pub sentence: String,
}

impl Stop {
    /// A bad command line, preset, journey or file of rays.
    pub(super) fn refused(reason: impl Display) -> Self {
        Self {
            status: 2,
            sentence: reason.to_string(),
        }
    }

    /// Any other failure.
    pub(super) fn failed(reason: impl Display) -> Self {
        Self {
            status: 1,
            sentence: reason.to_string(),
        }
    }

    /// A failure that may be gone later.
    pub(super) fn try_again(reason: impl Display) -> Self {
        Self {
            status: TRY_AGAIN,
            sentence: reason.to_string(),
        }
    }

    /// There is no graphics device. The command line is at fault if it asks for no single adapter, or
    /// for an interface that does not exist.
    pub(super) fn without_device(error: GpuError) -> Self {
        match error {
            GpuError::UnknownAdapter { .. }
            | GpuError::SeveralAdapters { .. }
            | GpuError::UnknownBackend { .. } => Self::refused(error),
            GpuError::Device(_) | GpuError::OutOfMemory(_) => Self::try_again(error),
            _ => Self::failed(error),
        }
    }
}

impl Display for Stop {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.sentence)
    }
}

impl Error for Stop {}

impl From<SourceError> for Stop {
    fn from(error: SourceError) -> Self {
        Self::refused(error)
    }
}

impl From<PictureError> for Stop {
    fn from(error: PictureError) -> Self {
        let status = match &error {
            PictureError::Extension { .. } => 2,
            PictureError::Interrupted => 130,
            PictureError::Terminated => TERMINATED,
            PictureError::Device(_) => TRY_AGAIN,
            PictureError::Write(error) if is_full(error) => TRY_AGAIN,
            _ => 1,
        };
        let sentence = error.to_string();
        Self { status, sentence }
    }
}

/// Whether a file could not be written for lack of room.
fn is_full(error: &WriteError) -> bool {
    matches!(
        error.source.kind(),
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded
    )
}
