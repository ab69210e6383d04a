//! `lightfall video`: a film of numbered pictures that exist.

use super::cli::VideoArgs;
use super::output::print;
use super::progress::progress;
use super::render::codec_of;
use super::stop::Stop;
use glam::UVec2;
use lightfall_core::optics::lut::Look;
use lightfall_core::scene::{MAX_PICTURE_SIDE, Projection};
use lightfall_picture as picture;
use lightfall_picture::{Codec, Container, Ffmpeg, Film, FilmForm, Format, PngBits};
use lightfall_platform::storage;
use std::path::{Path, PathBuf};

/// Makes a film.
pub(super) fn video(args: &VideoArgs) -> Result<(), Stop> {
    let codec = codec_of(&args.out, &args.film)?;
    let files = picture::numbered_pictures(&args.pictures).map_err(Stop::refused)?;
    let is_light = Format::of(&args.pictures)? == Format::Exr;
    if codec == Codec::Hdr10 && !is_light {
        return Err(Stop::refused(
            "--codec hdr10: the light above the white of a screen is in .exr pictures alone",
        ));
    }
    let (size, bits) = form_of(&files, is_light)?;
    let first = files.first().map_or(&*args.pictures, PathBuf::as_path);
    let form = FilmForm {
        container: Container::of(&args.out).unwrap_or_default(),
        codec,
        size,
        fps: args.fps,
        bits,
        is_of_whole_sky: is_of_whole_sky(first, size),
    };
    storage::check_writable(&args.out).map_err(Stop::failed)?;
    let ffmpeg = Ffmpeg::find(args.film.ffmpeg.as_deref(), codec)?;
    let mut film = Film::begin(&args.out, form, &ffmpeg)?;
    let bar = progress(files.len());
    for file in &files {
        bar.set_message(file.display().to_string());
        let levels = if is_light {
            developed(file, codec)?
        } else {
            let frame = picture::read_png_frame(file);
            frame.map_err(|fault| of_file(file, &fault))?.levels
        };
        // A file may have changed since its size was read.
        if levels.len() as u64 != 3 * u64::from(size.x) * u64::from(size.y) {
            return Err(of_file(file, "has another size than it had before"));
        }
        film.add(&levels)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    film.finish()?;
    print(&format!("{}\n", args.out.display()))
}

/// Size and bits of all pictures, which must be those of the first one.
fn form_of(files: &[PathBuf], is_light: bool) -> Result<(UVec2, PngBits), Stop> {
    let mut first: Option<(UVec2, PngBits)> = None;
    for file in files {
        let form = if is_light {
            picture::exr_size(file).map(|size| (size, PngBits::Sixteen))
        } else {
            picture::png_form(file).map(|frame| (frame.size, frame.bits))
        };
        let (size, bits) = form.map_err(|fault| of_file(file, &fault))?;
        if size.min_element() == 0 || size.max_element() > MAX_PICTURE_SIDE {
            let fault = format!(
                "has {}x{} pixels, and those of a film have at most {MAX_PICTURE_SIDE} to a side",
                size.x, size.y
            );
            return Err(of_file(file, &fault));
        }
        let (first_size, first_bits) = *first.get_or_insert((size, bits));
        if size != first_size {
            let fault = format!(
                "has {}x{} pixels, and the first picture has {}x{}",
                size.x, size.y, first_size.x, first_size.y
            );
            return Err(of_file(file, &fault));
        }
        if bits != first_bits {
            let fault = format!(
                "has {} bits, and the first picture has {}",
                bits.word(),
                first_bits.word()
            );
            return Err(of_file(file, &fault));
        }
    }
    first.ok_or_else(|| Stop::refused("a film has at least one picture"))
}

/// Whether a picture shows the whole sky: the preset in it says so. Other programs' pictures have none.
fn is_of_whole_sky(file: &Path, size: UVec2) -> bool {
    storage::read_scene(file, &[])
        .is_ok_and(|scene| scene.camera.projection == Projection::Equirectangular)
        && (size % 2).element_sum() == 0
}

/// The levels of an .exr as its preset develops it.
fn developed(file: &Path, codec: Codec) -> Result<Vec<u16>, Stop> {
    let scene = storage::read_scene(file, &[])?;
    let look = codec.own_look().unwrap_or_else(|| Look::of(&scene));
    let frame = picture::read_light_frame(file).map_err(|fault| of_file(file, &fault))?;
    Ok(picture::levels_of_light(
        &frame.rgb,
        look,
        scene.picture.exposure_ev,
    ))
}

/// A fault of a picture.
fn of_file(file: &Path, fault: &str) -> Stop {
    Stop::refused(format!("{}: {fault}", file.display()))
}
