//! PNG files that are written row by row.

use super::file::PictureError;
use glam::UVec2;
use lightfall_core::words;
use lightfall_platform::storage::{NewFile, PictureRecord, WriteError, set_up_png};
use std::io::{BufWriter, Write};
use std::path::Path;

/// Bytes of a chunk of compressed rows.
const CHUNK_BYTES: usize = 1 << 16;

words! {
    /// The number of bits of a channel of a PNG.
    pub enum PngBits {
        /// What a screen shows.
        Eight = "8",
        /// For further work on the picture; light fills eleven of the bits.
        Sixteen = "16",
    }
}

impl PngBits {
    /// The highest level.
    #[must_use]
    pub fn top(self) -> u16 {
        match self {
            Self::Eight => u8::MAX.into(),
            Self::Sixteen => u16::MAX,
        }
    }

    /// Bytes of a pixel.
    #[must_use]
    pub fn pixel_bytes(self) -> u64 {
        match self {
            Self::Eight => 3,
            Self::Sixteen => 6,
        }
    }

    fn depth(self) -> png::BitDepth {
        match self {
            Self::Eight => png::BitDepth::Eight,
            Self::Sixteen => png::BitDepth::Sixteen,
        }
    }
}

/// Writes a PNG of these levels, of red, green and blue of each pixel; rows from the top. The file
/// appears under its name only when it is complete.
///
/// # Errors
/// There are not as many levels as the size says, or the file cannot be written.
pub fn write_png_levels(
    path: &Path,
    (size, bits): (UVec2, PngBits),
    levels: &[u16],
    record: &PictureRecord,
) -> Result<(), PictureError> {
    write_png_rows(path, (size, bits), record, |take| take(levels))
}

/// What takes the next rows of a picture: red, green and blue of each pixel.
pub(super) type TakeRows<'a> = &'a mut dyn FnMut(&[u16]) -> Result<(), PictureError>;

/// Writes a PNG whose rows `draw` gives from the top. The file appears under its name only when it is
/// complete.
///
/// # Errors
/// Those of `draw`; or there are not as many rows as the size says, or the file cannot be written.
pub(super) fn write_png_rows(
    path: &Path,
    (size, bits): (UVec2, PngBits),
    record: &PictureRecord,
    draw: impl FnOnce(TakeRows) -> Result<(), PictureError>,
) -> Result<(), PictureError> {
    let fault = |error: png::EncodingError| match error {
        png::EncodingError::IoError(error) => WriteError::new(path, error).into(),
        error => PictureError::encode(path, &error),
    };
    let mut file = NewFile::create(path)?;
    let mut encoder = png::Encoder::new(BufWriter::new(file.file()), size.x, size.y);
    set_up_png(&mut encoder, bits.depth(), record).map_err(fault)?;
    let mut writer = encoder.write_header().map_err(fault)?;
    let mut rows = writer.stream_writer_with_size(CHUNK_BYTES).map_err(fault)?;
    draw(&mut |levels| {
        let bytes: Vec<u8> = match bits {
            PngBits::Eight => levels.iter().map(|level| *level as u8).collect(),
            PngBits::Sixteen => levels
                .iter()
                .flat_map(|level| level.to_be_bytes())
                .collect(),
        };
        rows.write_all(&bytes)
            .map_err(|error| WriteError::new(path, error).into())
    })?;
    rows.finish().map_err(fault)?;
    writer.finish().map_err(fault)?;
    Ok(file.finish()?)
}
