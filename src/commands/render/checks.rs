//! What `lightfall render` checks before it draws: files and memory.

use crate::commands::stop::Stop;
use glam::UVec2;
use lightfall_picture as picture;
use lightfall_picture::{Channels, Format, Frames, PictureError, Sequence};
use lightfall_platform::memory::free_memory;
use lightfall_platform::storage;
use std::path::{Path, absolute};

/// The memory that a picture takes, in bytes: of the program and its shaders, of each pixel while it is
/// drawn and encoded, and of each pixel's value in a channel. Measured with a software renderer, in which
/// the memory of the graphics device is that of the machine, and rounded up.
pub(super) const PROGRAM_BYTES: u64 = 450 << 20;
pub(super) const PIXEL_BYTES: u64 = 90;
pub(super) const VALUE_BYTES: u64 = 4;

/// Checks that there is memory for a picture, before minutes are spent on it.
pub(super) fn check_memory(
    size: UVec2,
    format: Format,
    channels: Option<&Channels>,
) -> Result<(), Stop> {
    let values = channels
        .filter(|_| format == Format::Exr)
        .map_or(0, |it| it.list().len());
    let pixels = u64::from(size.x) * u64::from(size.y);
    let needed = PROGRAM_BYTES + pixels * (PIXEL_BYTES + VALUE_BYTES * values as u64);
    let (channels, or_fewer) = match values {
        0 => (String::new(), ""),
        _ => (
            format!(" with {values} channels"),
            " or fewer channels with --aov",
        ),
    };
    match free_memory() {
        Some(free) if free < needed => Err(Stop::failed(format!(
            "a picture of {} x {} pixels{channels} needs about {} of memory, and {} are free; give a smaller \
             --size{or_fewer}",
            size.x,
            size.y,
            gigabytes(needed),
            gigabytes(free),
        ))),
        _ => Ok(()),
    }
}

pub(super) fn gigabytes(bytes: u64) -> String {
    format!("{:.1} GB", bytes as f64 / 1e9)
}

/// Checks that the times of the passes can be written, and not to the picture's file.
pub(super) fn check_times_file(file: &Path, picture: &Path) -> Result<(), Stop> {
    if absolute(picture).ok() == absolute(file).ok() {
        return Err(Stop::refused(format!(
            "--timings={}: this is the picture's file; the times need a file of their own",
            file.display()
        )));
    }
    storage::check_writable(file).map_err(Stop::failed)
}

/// Checks that every picture can be written, before any work is done for one that could not be, and
/// returns their format.
pub(super) fn check_files(out: &Path, sequence: Option<&Sequence>) -> Result<Format, PictureError> {
    let format = Format::of(out)?;
    match sequence {
        Some(sequence) if format != Format::Apng => {
            let Frames { first, last } = sequence.frames;
            picture::check_path(&sequence.file(first))?;
            for number in first..=last {
                storage::check_name(&sequence.file(number))?;
            }
        }
        // One file, which holds the frames of a sequence, too.
        _ => {
            picture::check_path(out)?;
        }
    }
    Ok(format)
}
