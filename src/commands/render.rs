//! `lightfall render`: a picture, or a sequence of pictures: a journey, or a disk that moves.

mod checks;
mod cube;
mod exr_options;
mod farm;
mod film;
mod large;
mod looped;
mod notes;
mod pictures;
mod resume;
mod times;
mod writer;

use self::checks::{
    check_files, check_format, check_memory, check_projection, check_shutter, check_space,
    check_times_file, check_transparent,
};
use self::cube::{drawn_at_once, files_of, is_of_side};
use self::exr_options::{channels, exr_form, show_transparent};
use self::farm::{check_farm, is_run, note_frame, nothing_to_draw, numbers, open_manifest};
pub(super) use self::film::codec_of;
use self::film::{FilmMaker, codec};
use self::large::{Tiling, tiling};
use self::looped::{loop_sequence, note_loop};
use self::notes::note_all;
pub use self::notes::still_drawing;
use self::pictures::{Pictures, drawn_scene, sequence};
use self::resume::left_to_draw;
use self::times::{TIMED_FRAMES, print_times, write_times};
use self::writer::PictureWriter;
use super::camera;
use super::cli::RenderArgs;
use super::output::print;
use super::progress::{LongWork, progress};
use super::scene::{on_stage, scene, stars};
use super::stop::Stop;
use glam::UVec2;
use indicatif::ProgressBar;
use lightfall_core::scene::{Projection, Scene, resized};
use lightfall_picture as picture;
use lightfall_picture::{Codec, Ffmpeg, Format, HeadlessOptions, Manifest, Studio};
use lightfall_platform::log::say;
use lightfall_platform::termination;
use std::time::Instant;

/// Draws and writes a picture, or a sequence of pictures.
pub(super) fn render(args: &RenderArgs) -> Result<(), Stop> {
    let args = &RenderArgs {
        scene: on_stage(&args.scene, args.journey.as_deref())?,
        ..args.clone()
    };
    let Asked {
        mut pictures,
        tiling,
        codec,
    } = asked(args)?;
    let channels = channels(args, &pictures)?;
    let form = exr_form(args);
    let stars = stars(&args.scene)?;
    let mut manifest = open_manifest(args, &pictures)?;
    termination::watch();
    if args.farm.resume {
        let (form, manifest) = ((&channels, form), manifest.as_mut());
        pictures.numbers = left_to_draw(&pictures, form, tiling.as_ref(), stars, manifest)?;
    }
    if pictures.numbers.is_empty() {
        say(format_args!("lightfall: {}", nothing_to_draw(args)));
        return Ok(());
    }
    check_memory(&pictures, (&channels, form), tiling.as_ref())?;
    if let Some(tiling) = &tiling {
        check_space(&pictures, &channels, tiling)?;
    }
    write_camera_paths(args, &pictures)?;

    let film = codec.map(|codec| FilmMaker::new(args, codec, &pictures.scene, tiling.as_ref()));

    let suspects = note_all(args, &pictures, tiling.as_ref(), stars);
    let options = HeadlessOptions {
        timed: args.timings.is_some(),
        light: pictures.format == Format::Exr
            || args.shutter.is_some()
            || args.alpha.is_some()
            || film.as_ref().is_some_and(FilmMaker::is_of_light),
        stars,
        ..HeadlessOptions::default()
    };
    let mut studio = open_studio(&pictures, tiling.as_ref(), options)?;
    studio.show_layers(channels.drawn_layers(form));
    let mut writer = PictureWriter {
        studio,
        format: pictures.format,
        tiling,
        progress: tiling.map(|tiling| tiling.progress(&pictures)),
        channels,
        form,
        moments: Vec::new(),
        rays: None,
        animation: None,
        film,
        still: None,
        frames: pictures.numbers().len() as u32,
        fps: pictures.sequence.as_ref().map(|_| args.fps),
    };
    let size = pictures.scene.picture.size();
    let _patience = (pictures.sequence.is_none() && tiling.is_none())
        .then(|| LongWork::new(still_drawing(size, writer.studio.adapter_kind())));
    draw_all(&pictures, &mut writer, manifest.as_mut())?;
    complete_sequence(args, &mut writer)?;
    if let Some(file) = &args.timings {
        let times = writer.studio.time(TIMED_FRAMES)?;
        print_times(&times);
        if let Some(file) = file {
            write_times(file, &times, size)?;
        }
    }
    if let Some(still) = writer.still.take() {
        for suspect in suspects {
            if writer
                .studio
                .draws_alike(&still, &pictures.scene, &suspect.without)?
            {
                suspect.say_it_is_unused();
            }
        }
    }
    if let Some(sequence) = &pictures.sequence
        && !pictures.format.holds_sequence()
        && !is_of_side(&args.out)
        && is_run(args)
    {
        say(format_args!(
            "lightfall: a video of them: {}",
            sequence.ffmpeg(size.x, size.y)
        ));
    }
    Ok(())
}

/// What a command line asks for.
struct Asked {
    pictures: Pictures,
    /// How the pictures are drawn in tiles; `None` if they are drawn at once.
    tiling: Option<Tiling>,
    /// The codec of a film, and ffmpeg, which has it.
    codec: Option<(Codec, Ffmpeg)>,
}

/// Reads what the options ask for, and checks before the first picture that all of them can be drawn and
/// written.
fn asked(args: &RenderArgs) -> Result<Asked, Stop> {
    let mut scene = scene(&args.scene)?;
    let sequence = match (args.loop_seconds, &args.frames) {
        (Some(seconds), _) => Some(loop_sequence(args, seconds, &mut scene)?),
        (None, Some(frames)) => Some(sequence(args, frames.ends(), &scene)?),
        (None, None) => None,
    };
    let numbers = numbers(args, sequence.as_ref());
    let format = check_files(&args.out, sequence.as_ref(), &numbers)?;
    check_farm(args, format)?;
    args.camera
        .iter()
        .try_for_each(|file| camera::check_file(file))?;
    let mut scene = with_size(args, scene);
    scene
        .check()
        .map_err(|refusal| Stop::refused(format!("--size: {refusal}")))?;
    check_projection(args, format, &scene)?;
    check_format(args, format, sequence.as_ref())?;
    let codec = codec(args, format, &mut scene)?;
    if let Some(Some(file)) = &args.timings {
        check_times_file(file, &args.out)?;
    }
    show_transparent(args, format, &mut scene)?;
    let of_film = codec.as_ref().map(|(codec, _)| *codec);
    let tiling = tiling(args, (format, of_film), &mut scene)?;
    check_shutter(args, &scene, tiling.as_ref())?;
    check_transparent(args, format, tiling.as_ref())?;
    let pictures = Pictures {
        format,
        scene,
        file: args.out.clone(),
        sequence,
        shutter: args.shutter,
        numbers,
    };
    pictures.check()?;
    Ok(Asked {
        pictures,
        tiling,
        codec,
    })
}

/// Writes the camera's path to the files that are named: that of all frames, whichever of them this run draws.
fn write_camera_paths(args: &RenderArgs, pictures: &Pictures) -> Result<(), Stop> {
    let Some(frames) = args.frames.as_ref().filter(|_| !args.camera.is_empty()) else {
        return Ok(());
    };
    let scene_of = |number| pictures.scene_of(number);
    let path = camera::path_of(frames.numbers(), args.fps, &pictures.scene, scene_of)?;
    let mut files = args.camera.iter();
    files.try_for_each(|file| camera::write_path(file, &path))
}

/// Opens what draws the pictures, with the first one of them.
fn open_studio(
    pictures: &Pictures,
    tiling: Option<&Tiling>,
    options: HeadlessOptions,
) -> Result<Studio, Stop> {
    let first = pictures.scene_of(pictures.first());
    let Some(tiling) = tiling else {
        let drawn = drawn_scene(&first, pictures.format);
        return Ok(Studio::with_options(&drawn, first.picture.size(), options)?);
    };
    // The sides of a cube have the exposure of all of them.
    let drawn = drawn_at_once(&picture::exposed(&first)?);
    // The levels of a file do not come from the image that a window would show.
    let options = tiling.options(options);
    Ok(Studio::with_options(&drawn, UVec2::ONE, options)?)
}

/// Draws and writes every picture, and says which files are written.
fn draw_all(
    pictures: &Pictures,
    writer: &mut PictureWriter,
    mut manifest: Option<&mut Manifest>,
) -> Result<(), Stop> {
    let bar = if pictures.sequence.is_some() && writer.tiling.is_none() {
        progress(pictures.numbers().len())
    } else {
        ProgressBar::hidden()
    };
    for number in pictures.numbers() {
        let (scene, file) = (pictures.scene_of(number), pictures.file_of(number));
        bar.set_message(file.display().to_string());
        writer.moments = pictures.moments(number);
        let began = Instant::now();
        writer.write(&scene, &file)?;
        let files = files_of(&file);
        if let Some(manifest) = &mut manifest {
            note_frame(manifest, (number, &files), began.elapsed(), &writer.studio)?;
        }
        if !pictures.format.holds_sequence() {
            let name = || {
                let mut files = files.iter();
                files.try_for_each(|file| print(&format!("{}\n", file.display())))
            };
            match &writer.progress {
                Some(progress) => progress.without_bar(name)?,
                None => bar.suspend(name)?,
            }
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    if let Some(progress) = writer.progress.take() {
        progress.finish();
    }
    Ok(())
}

/// Completes the file that holds all frames of a sequence, if there is one.
fn complete_sequence(args: &RenderArgs, writer: &mut PictureWriter) -> Result<(), Stop> {
    if let Some(animation) = writer.animation.take() {
        animation.finish()?;
        print(&format!("{}\n", args.out.display()))?;
    }
    if let Some(film) = writer.film.take() {
        film.finish()?;
        print(&format!("{}\n", args.out.display()))?;
        if args.loop_seconds.is_some() {
            note_loop(&args.out);
        }
    }
    Ok(())
}

/// The size of a picture for a dome, unless another is asked for.
const DOME_SIZE: UVec2 = UVec2::splat(2048);

/// A scene with the size that was asked for.
fn with_size(args: &RenderArgs, mut scene: Scene) -> Scene {
    let is_dome = args.scene.dome && scene.camera.projection == Projection::Fisheye;
    let of_dome = is_dome.then_some(DOME_SIZE);
    if let Some(size) = args.size.or(of_dome) {
        scene.picture = resized(&scene.picture, size);
    }
    scene
}
