//! Picture files.

use super::{Container, Still};
use glam::UVec2;
use lightfall_core::gpu::GpuError;
use lightfall_core::scene::MAX_PICTURE_SIDE;
use lightfall_platform::storage::{
    PictureRecord, WriteError, check_writable, encoded_png, write_atomically,
};
use std::fmt::Display;
use std::path::{Path, PathBuf};

/// Why a picture could not be drawn or written. Each message is one sentence.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// The extension of the file's name is not that of a format that the program writes.
    #[error("{path}: {}; allowed are .png, .apng, .exr, .mp4, .mov and .webm", extension_fault(.extension))]
    Extension {
        /// The file.
        path: PathBuf,
        /// Its extension, without the dot.
        extension: String,
    },
    /// The folder or file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// The picture could not be encoded.
    #[error("{path}: the picture could not be encoded: {reason}")]
    Encode {
        /// The file.
        path: PathBuf,
        /// The encoder's message.
        reason: String,
    },
    /// The device cannot draw a picture this large.
    #[error(
        "{field} = {}x{}: this device draws pictures of 1 to {} pixels a side",
        .size.x, .size.y, MAX_PICTURE_SIDE
    )]
    Size {
        /// Name of the size in the message.
        field: &'static str,
        /// The requested width and height, in pixels.
        size: UVec2,
    },
    /// A film could not be made.
    #[error("{0}")]
    Film(String),
    /// The chain of passes failed.
    #[error("the picture could not be drawn: {0}")]
    Draw(String),
    /// The graphics device was lost, or has too little free memory for now.
    #[error("{0}; the same command may succeed later, or on another machine")]
    Device(String),
    /// The user interrupted the program.
    #[error("interrupted; every picture that was written is complete")]
    Interrupted,
    /// The system or a scheduler asked the program to end.
    #[error("asked to end (SIGTERM); every picture that was written is complete")]
    Terminated,
}

impl From<GpuError> for PictureError {
    fn from(error: GpuError) -> Self {
        match error {
            GpuError::Device(_) | GpuError::OutOfMemory(_) => Self::Device(error.to_string()),
            _ => Self::Draw(error.to_string()),
        }
    }
}

impl PictureError {
    /// The picture of this file could not be encoded.
    pub(super) fn encode(path: &Path, reason: &impl Display) -> Self {
        Self::Encode {
            path: path.into(),
            reason: reason.to_string(),
        }
    }
}

/// What is wrong with the extension of a file's name.
fn extension_fault(extension: &str) -> String {
    if extension.is_empty() {
        return "the name has no extension that says which picture format to write".into();
    }
    format!("unknown picture format {extension:?}")
}

/// The format of a picture file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// What a window would show, in 8 bits per channel.
    Png,
    /// The same, with all frames of a sequence in one file.
    Apng,
    /// Linear light, and the data of rays.
    Exr,
    /// What a window would show, with all frames of a sequence in one film.
    Film,
}

impl Format {
    /// The format of the file at `path`, which its extension decides.
    ///
    /// # Errors
    /// The extension is unknown.
    pub fn of(path: &Path) -> Result<Self, PictureError> {
        let extension = path
            .extension()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        if Container::of(path).is_some() {
            return Ok(Self::Film);
        }
        match extension.to_ascii_lowercase().as_str() {
            "png" => Ok(Self::Png),
            "apng" => Ok(Self::Apng),
            "exr" => Ok(Self::Exr),
            _ => Err(PictureError::Extension {
                path: path.into(),
                extension,
            }),
        }
    }

    /// Whether a file of this format holds all frames of a sequence.
    #[must_use]
    pub fn holds_sequence(self) -> bool {
        matches!(self, Self::Apng | Self::Film)
    }

    /// A file of this format, in a sentence.
    #[must_use]
    pub fn noun(self) -> &'static str {
        match self {
            Self::Png => "a .png",
            Self::Apng => "an .apng",
            Self::Exr => "an .exr",
            Self::Film => "a film",
        }
    }
}

/// Checks that a picture can be written to `path`, before any work is done for it, and returns its
/// format.
///
/// # Errors
/// The extension is unknown, the file is a folder, or its folder does not exist or cannot be
/// written.
pub fn check_path(path: &Path) -> Result<Format, PictureError> {
    let format = Format::of(path)?;
    check_writable(path)?;
    Ok(format)
}

/// Writes a picture as a PNG that holds its record. The file appears under its name only when it
/// is complete.
///
/// # Errors
/// The encoding failed, or the file cannot be written.
pub fn write_png(path: &Path, still: &Still, record: &PictureRecord) -> Result<(), PictureError> {
    let Still { size, rgb } = still;
    let bytes = encoded_png(size.x, size.y, rgb, record)
        .map_err(|error| PictureError::encode(path, &error))?;
    Ok(write_atomically(path, &bytes)?)
}
