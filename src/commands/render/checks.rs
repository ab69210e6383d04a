//! What `lightfall render` checks before it draws: files and memory.

use super::cube::{files_of, is_of_side};
use crate::commands::cli::{Cells, RenderArgs};
use crate::commands::stop::Stop;
use glam::UVec2;
use lightfall_core::scene::{Projection, Scene};
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

/// Checks that the projection of the scene's picture goes with its size, its file and the options.
pub(super) fn check_projection(args: &RenderArgs, scene: &Scene) -> Result<(), Stop> {
    let (projection, size) = (scene.camera.projection, scene.picture.size());
    if args.scene.dome && size.x != size.y {
        return Err(Stop::refused(format!(
            "--size: the picture for a dome is a square, such as 2048x2048, and not {}x{}",
            size.x, size.y
        )));
    }
    if let Some(reason) = projection.refused_size(size) {
        let origin = match args.size {
            Some(_) => "--size",
            None => "camera.projection",
        };
        return Err(Stop::refused(format!(
            "{origin}: {reason}; --size gives another"
        )));
    }
    if args.scene.cells == Some(Cells::On) && projection != Projection::Perspective {
        return Err(Stop::refused(format!(
            "--cells on: only perspective pictures are shown in cells, and camera.projection is {:?}",
            projection.word()
        )));
    }
    if !is_of_side(&args.out) {
        return Ok(());
    }
    if projection != Projection::Cube {
        return Err(Stop::refused(
            "-o: {face} stands for the sides of a cube, which --set camera.projection=cube draws",
        ));
    }
    if Format::of(&args.out)? == Format::Apng {
        return Err(Stop::refused(
            "-o: {face} stands for files of pictures: the name must end in .png or .exr",
        ));
    }
    Ok(())
}

/// Checks that every picture can be written, before any work is done for one that could not be, and
/// returns their format.
pub(super) fn check_files(out: &Path, sequence: Option<&Sequence>) -> Result<Format, PictureError> {
    let format = Format::of(out)?;
    match sequence {
        Some(sequence) if format != Format::Apng => {
            let Frames { first, last } = sequence.frames;
            for file in files_of(&sequence.file(first)) {
                picture::check_path(&file)?;
            }
            for file in (first..=last).flat_map(|number| files_of(&sequence.file(number))) {
                storage::check_name(&file)?;
            }
        }
        // One file, which holds the frames of a sequence, too.
        _ => {
            for file in files_of(out) {
                picture::check_path(&file)?;
            }
        }
    }
    Ok(format)
}
