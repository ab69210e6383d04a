//! Why a picture of the sky cannot be shown.

use super::{MAX_FILE_BYTES, MAX_WIDTH, MIN_WIDTH};
use thiserror::Error;

/// Why a scene has no picture of the sky. Each message is one sentence.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SkyPictureError {
    /// The scene names no file.
    #[error(
        "sky.mode = \"picture\" is refused: sky.picture names no file; --sky FILE shows a picture of the whole sky"
    )]
    NoFile,
    /// The file is refused.
    #[error("sky.picture = {path:?} is refused: {fault}")]
    Refused {
        /// The file, as the scene names it.
        path: String,
        /// What is wrong with it.
        fault: SkyPictureFault,
    },
}

/// What is wrong with the file of a picture of the sky. Each message is a clause.
#[derive(Clone, Debug, Error, PartialEq)]
#[expect(missing_docs, reason = "the messages say what the fields are")]
pub enum SkyPictureFault {
    /// There is no file of this name.
    #[error("there is no such file")]
    Missing,
    /// A folder, a pipe or a device.
    #[error("it is not a regular file")]
    NotAFile,
    /// The system does not let it be read.
    #[error("it cannot be read: {reason}")]
    Unreadable { reason: String },
    /// The file is too long.
    #[error("it has {megabytes} MB, and it may have {} at most", MAX_FILE_BYTES >> 20)]
    TooLong { megabytes: u64 },
    /// The file is in no known format.
    #[error("it is no picture in EXR, HDR, PNG or JPEG")]
    NoPicture,
    /// The file begins as a picture and does not go on as one.
    #[error("it is damaged or incomplete, or of a kind that is not read: {reason}")]
    Broken { reason: String },
    /// The picture is not twice as wide as high.
    #[error(
        "it has {width} x {height} pixels, and a picture of the whole sky is twice as wide as high"
    )]
    Shape { width: u32, height: u32 },
    /// The picture is too large or too small.
    #[error(
        "it has {width} x {height} pixels, and it must have {MIN_WIDTH} x {} to {MAX_WIDTH} x {}",
        MIN_WIDTH / 2, MAX_WIDTH / 2
    )]
    Size { width: u32, height: u32 },
    /// A texel is not light.
    #[error("the light in column {column}, row {row} is {value}, and light is a number from 0 up")]
    NoLight {
        column: usize,
        row: usize,
        value: f32,
    },
    /// The program runs in a browser.
    #[error("a page in a browser reads no files; the downloaded program shows such a sky")]
    InBrowser,
}

#[cfg(not(target_arch = "wasm32"))]
impl SkyPictureFault {
    /// A decoder's complaint, on one line.
    pub(super) fn broken(reason: impl ToString) -> Self {
        let reason = reason.to_string();
        let line = reason.lines().next().unwrap_or_default().trim();
        Self::Broken {
            reason: line.trim_end_matches('.').to_owned(),
        }
    }
}
