//! What `lightfall render` checks before it draws: files and memory.

use super::cube::{drawn_at_once, files_of, is_of_side};
use super::exr_options::exr_option;
use super::large::Tiling;
use super::pictures::Pictures;
use crate::commands::cli::{Cells, RenderArgs};
use crate::commands::stop::Stop;
use lightfall_core::scene::{Projection, Scene};
use lightfall_picture as picture;
use lightfall_picture::{Channels, ExrForm, Format, PictureError, Sequence};
use lightfall_platform::memory::free_memory;
use lightfall_platform::storage;
use std::path::{Path, absolute};

/// The memory that a picture takes, in bytes: of the program and its shaders, of each pixel while it is
/// drawn and encoded, and of each pixel's value in a channel. Measured with a software renderer, in which
/// the memory of the graphics device is that of the machine, and rounded up.
const PROGRAM_BYTES: u64 = 450 << 20;
const PIXEL_BYTES: u64 = 90;
const VALUE_BYTES: u64 = 4;

/// The memory of a tile on the device and in the program, and that of each pixel of a strip of tiles, in
/// bytes.
const TILES_BYTES: u64 = 400 << 20;
const STRIP_PIXEL_BYTES: u64 = 24;
const STRIP_ROWS: u64 = 512;

/// The numbers of layers exist as those of a strip and as those that wait to be written, which grow by
/// doubling.
const COPIES_IN_STRIP: u64 = 3;

/// The rows that are encoded at once exist as the numbers of rays, as channels, as blocks and as compressed
/// blocks: so many copies of their values, measured and rounded up.
const COPIES_OF_VALUES: u64 = 6;

/// The sides of a cube exist as themselves, joined and encoded.
const COPIES_OF_SIDES: u64 = 3;

/// Checks that there is memory for a picture, before minutes are spent on it.
pub(super) fn check_memory(
    pictures: &Pictures,
    (channels, form): (&Channels, ExrForm),
    tiling: Option<&Tiling>,
) -> Result<(), Stop> {
    let Pictures { scene, format, .. } = pictures;
    let drawn = drawn_at_once(scene).picture.size();
    let values = match format {
        Format::Exr => channels.list().len(),
        Format::Png | Format::Apng | Format::Film => 0,
    };
    let per_pixel = VALUE_BYTES * values as u64;
    let of_layers = VALUE_BYTES * channels.of_layers().len() as u64;
    let columns = u64::from(drawn.x);
    let needed = if tiling.is_some_and(|tiling| tiling.tiles.count() > 1) {
        let rows = u64::from(picture::rows_at_once(form.compression));
        let encoded = COPIES_OF_VALUES * columns * rows * per_pixel;
        let of_strip = STRIP_PIXEL_BYTES + COPIES_IN_STRIP * of_layers;
        PROGRAM_BYTES + TILES_BYTES + columns * STRIP_ROWS * of_strip + encoded
    } else {
        PROGRAM_BYTES + columns * u64::from(drawn.y) * (PIXEL_BYTES + per_pixel)
    };
    // The sides of a cube in one file are kept until all of them are drawn.
    let size = scene.picture.size();
    let is_joined = scene.camera.projection == Projection::Cube && !is_of_side(&pictures.file);
    let kept = if is_joined {
        let pixels = u64::from(size.x) * u64::from(size.y);
        COPIES_OF_SIDES * pixels * (picture::LIGHT_BYTES as u64 + per_pixel)
    } else {
        0
    };
    let needed = needed + kept;
    let (channels, or_fewer) = match values {
        0 => (String::new(), ""),
        _ => (
            format!(" with {values} channels"),
            " or fewer channels with --aov and --layers",
        ),
    };
    match free_memory() {
        Some(free) if free < needed => Err(Stop::try_again(format!(
            "a picture of {} x {} pixels{channels} needs about {} of memory, and {} are free; give a smaller \
             --size{or_fewer}",
            size.x,
            size.y,
            amount(needed),
            amount(free),
        ))),
        _ => Ok(()),
    }
}

/// Checks that there is room for what pictures in tiles write: the files, and for a PNG with bloom the
/// light of the picture in a temporary file beside it, of which there is one at a time. The files may be
/// smaller than what is asked for, because they are compressed.
pub(super) fn check_space(
    pictures: &Pictures,
    channels: &Channels,
    tiling: &Tiling,
) -> Result<(), Stop> {
    let size = pictures.scene.picture.size();
    let of_pixel = match pictures.format {
        Format::Exr => picture::exr_pixel_bytes(channels),
        Format::Png | Format::Apng => tiling.bits.pixel_bytes(),
        // A film is far smaller than its pictures.
        Format::Film => 0,
    };
    let number = pictures.numbers.len() as u64;
    let keeps_light = tiling.sweeps(pictures).any(|sweeps| sweeps > 1);
    let light = if keeps_light {
        picture::LIGHT_BYTES as u64
    } else {
        0
    };
    let pixels = u64::from(size.x) * u64::from(size.y);
    let needed = pixels.saturating_mul(of_pixel.saturating_mul(number).saturating_add(light));
    let what = match number {
        1 => "a picture".to_owned(),
        _ => format!("a sequence of {number} pictures"),
    };
    let file = pictures.file_of(pictures.first());
    match storage::free_space(&file) {
        Some(free) if free < needed => Err(Stop::try_again(format!(
            "{}: {what} of {} x {} pixels needs up to {} on the disk while it is written, and {} are free; \
             give a smaller --size, or another folder",
            file.display(),
            size.x,
            size.y,
            amount(needed),
            amount(free),
        ))),
        _ => Ok(()),
    }
}

/// An amount of bytes in words, such as `1.2 GB`.
fn amount(bytes: u64) -> String {
    if bytes < 1_000_000_000 {
        format!("{:.0} MB", bytes as f64 / 1e6)
    } else {
        format!("{:.1} GB", bytes as f64 / 1e9)
    }
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
pub(super) fn check_projection(
    args: &RenderArgs,
    format: Format,
    scene: &Scene,
) -> Result<(), Stop> {
    let (projection, size) = (scene.camera.projection, scene.picture.size());
    if args.scene.dome && projection == Projection::Fisheye && size.x != size.y {
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
    if args.timings.is_some() && projection == Projection::Cube {
        return Err(Stop::refused(
            "--timings: the six sides of a cube are drawn one after another, which is not timed",
        ));
    }
    if !is_of_side(&args.out) {
        return Ok(());
    }
    if projection != Projection::Cube {
        return Err(Stop::refused(
            "-o: {face} stands for the sides of a cube, which --set camera.projection=cube draws",
        ));
    }
    if format.holds_sequence() {
        return Err(Stop::refused(
            "-o: {face} stands for files of pictures: the name must end in .png or .exr",
        ));
    }
    Ok(())
}

/// Checks that there are frames for a file that holds a sequence, and that no option is for another format.
pub(super) fn check_format(
    args: &RenderArgs,
    format: Format,
    sequence: Option<&Sequence>,
) -> Result<(), Stop> {
    if format.holds_sequence() && sequence.is_none() {
        return Err(Stop::refused(format!(
            "-o: {} holds the frames of a sequence, so --frames A..B must name them",
            format.noun()
        )));
    }
    match exr_option(args) {
        Some(option) if format != Format::Exr => Err(Stop::refused(format!(
            "{option} is for pictures of linear light: the file's name must end in .exr"
        ))),
        _ => Ok(()),
    }
}

/// Checks that a .png with transparent parts is drawn at once: one in tiles has none.
pub(super) fn check_transparent(
    args: &RenderArgs,
    format: Format,
    tiling: Option<&Tiling>,
) -> Result<(), Stop> {
    if args.alpha.is_some() && format == Format::Png && tiling.is_some() {
        return Err(Stop::refused(
            "--alpha: a .png that is drawn in tiles has no transparent parts; an .exr of this size may have them",
        ));
    }
    Ok(())
}

/// Checks that pictures with a shutter show light and are drawn at once: tiles are not blurred.
pub(super) fn check_shutter(
    args: &RenderArgs,
    scene: &Scene,
    tiling: Option<&Tiling>,
) -> Result<(), Stop> {
    if args.shutter.is_none() {
        return Ok(());
    }
    if tiling.is_some() {
        return Err(Stop::refused(
            "--shutter: pictures with 16 bits, those of cubes and those that are drawn in tiles are not blurred",
        ));
    }
    if !scene.view.shows_light() {
        return Err(Stop::refused(format!(
            "--shutter: the colours of the view {:?} have meanings, and a mean of them has none",
            scene.view.word()
        )));
    }
    Ok(())
}

/// Checks that every picture can be written, before any work is done for one that could not be, and
/// returns their format. `numbers` are those of the sequence's frames that are drawn.
pub(super) fn check_files(
    out: &Path,
    sequence: Option<&Sequence>,
    numbers: &[u32],
) -> Result<Format, PictureError> {
    let format = Format::of(out)?;
    match sequence {
        Some(sequence) if !format.holds_sequence() => {
            let files = |number: &u32| files_of(&sequence.file(*number));
            for file in numbers.first().into_iter().flat_map(files) {
                picture::check_path(&file)?;
            }
            for file in numbers.iter().flat_map(files) {
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
