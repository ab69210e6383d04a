//! Animated pictures: the frames of a sequence in one file, an animated PNG.

use super::file::PictureError;
use super::still::Still;
use glam::UVec2;
use lightfall_platform::storage::{PictureRecord, set_up_png, write_atomically};
use std::io::{self, Write};
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// The time that a frame is shown is written as a fraction of a second with this denominator.
const DELAY_PARTS: u16 = 1000;

/// An animated PNG that is being made. It repeats for ever.
pub struct Animation {
    path: PathBuf,
    bytes: Bytes,
    writer: png::Writer<Bytes>,
}

/// The file's bytes so far, which the encoder keeps until it ends.
#[derive(Clone, Default)]
struct Bytes(Arc<Mutex<Vec<u8>>>);

impl Write for Bytes {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let Self(all) = self;
        let mut all = all.lock().unwrap_or_else(PoisonError::into_inner);
        all.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Animation {
    /// Begins an animation of `count` frames that holds the record of the first one.
    ///
    /// # Errors
    /// The encoder refuses the size or the number of frames.
    pub fn new(
        path: &Path,
        size: UVec2,
        (count, fps): (u32, f64),
        record: &PictureRecord,
    ) -> Result<Self, PictureError> {
        let fault = |error: png::EncodingError| PictureError::encode(path, &error);
        let bytes = Bytes::default();
        let mut encoder = png::Encoder::new(bytes.clone(), size.x, size.y);
        set_up_png(&mut encoder, png::BitDepth::Eight, record).map_err(fault)?;
        encoder.set_compression(png::Compression::High);
        encoder.set_animated(count, 0).map_err(fault)?;
        let delay = (f64::from(DELAY_PARTS) / fps).round();
        encoder
            .set_frame_delay(delay.clamp(1.0, f64::from(u16::MAX)) as u16, DELAY_PARTS)
            .map_err(fault)?;
        Ok(Self {
            path: path.into(),
            bytes,
            writer: encoder.write_header().map_err(fault)?,
        })
    }

    /// Adds the next frame.
    ///
    /// # Errors
    /// The frame has another size, or there are more frames than announced.
    pub fn add(&mut self, frame: &Still) -> Result<(), PictureError> {
        self.writer
            .write_image_data(&frame.rgb)
            .map_err(|error| PictureError::encode(&self.path, &error))
    }

    /// Writes the file, which appears under its name only when it is complete.
    ///
    /// # Errors
    /// Frames are missing, or the file cannot be written.
    pub fn finish(self) -> Result<(), PictureError> {
        self.writer
            .finish()
            .map_err(|error| PictureError::encode(&self.path, &error))?;
        let Bytes(all) = self.bytes;
        let bytes = mem::take(&mut *all.lock().unwrap_or_else(PoisonError::into_inner));
        Ok(write_atomically(&self.path, &bytes)?)
    }
}
