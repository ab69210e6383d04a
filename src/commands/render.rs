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
    check_files, check_memory, check_projection, check_shutter, check_space, check_times_file,
};
use self::cube::{drawn_at_once, files_of, is_of_side};
use self::exr_options::{channels, exr_form, exr_option, show_transparent};
use self::farm::{check_farm, is_run, note_frame, nothing_to_draw, numbers, open_manifest};
pub(super) use self::film::codec_of;
use self::film::{FilmMaker, codec};
use self::large::tiling;
use self::looped::{loop_sequence, note_loop};
pub use self::notes::still_drawing;
use self::notes::{note_cells, note_darkness, note_unseen_stars, note_unused_options};
use self::pictures::{Pictures, drawn_scene, sequence};
use self::resume::left_to_draw;
use self::times::{TIMED_FRAMES, print_times, write_times};
use self::writer::PictureWriter;
use super::camera;
use super::cli::RenderArgs;
use super::output::print;
use super::progress::{LongWork, progress};
use super::scene::{note_missing_stars, on_stage, scene, stars};
use super::stop::Stop;
use glam::UVec2;
use indicatif::ProgressBar;
use lightfall_core::scene::{Projection, Scene, resized};
use lightfall_picture as picture;
use lightfall_picture::{Format, HeadlessOptions, Studio};
use lightfall_platform::log::say;
use lightfall_platform::termination;
use std::time::Instant;

/// Draws and writes a picture, or a sequence of pictures.
pub(super) fn render(args: &RenderArgs) -> Result<(), Stop> {
    let args = &RenderArgs {
        scene: on_stage(&args.scene, args.journey.as_deref())?,
        ..args.clone()
    };
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
    check_projection(args, &scene)?;
    if format.holds_sequence() && sequence.is_none() {
        let what = match format {
            Format::Film => "a film",
            _ => "an .apng",
        };
        return Err(Stop::refused(format!(
            "-o: {what} holds the frames of a sequence, so --frames A..B must name them"
        )));
    }
    if let (false, Some(option)) = (format == Format::Exr, exr_option(args)) {
        return Err(Stop::refused(format!(
            "{option} is for pictures of linear light: the file's name must end in .exr"
        )));
    }
    let codec = codec(args, format, &mut scene)?;
    if let Some(Some(file)) = &args.timings {
        check_times_file(file, &args.out)?;
    }
    show_transparent(args, format, &mut scene)?;
    let tiling = tiling(args, format, &mut scene)?;
    check_shutter(args, &scene, tiling.as_ref())?;
    if args.alpha.is_some() && format == Format::Png && tiling.is_some() {
        return Err(Stop::refused(
            "--alpha: a .png that is drawn in tiles has no transparent parts; an .exr of this size may have them",
        ));
    }
    let mut pictures = Pictures {
        format,
        scene,
        file: args.out.clone(),
        sequence,
        shutter: args.shutter,
        numbers,
    };
    pictures.check()?;
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
    if !args.camera.is_empty() {
        // Of all frames, whichever of them this run draws.
        let numbers = args
            .frames
            .as_ref()
            .map_or_else(Vec::new, |list| list.numbers().to_vec());
        let path = camera::path_of(&numbers, args.fps, &pictures.scene, |n| pictures.get(n).0)?;
        let mut files = args.camera.iter();
        files.try_for_each(|file| camera::write_path(file, &path))?;
    }

    let film = codec.map(|codec| FilmMaker::new(args, codec, &pictures.scene, tiling.as_ref()));

    let size = pictures.scene.picture.size();
    if tiling.is_none()
        && format != Format::Exr
        && args.size.is_some()
        && args.scene.cells.is_none()
    {
        note_cells(&pictures.scene.shown_picture());
    }
    note_unseen_stars(args, &pictures.scene);
    note_darkness(&pictures.scene);
    let suspects = note_unused_options(args, &pictures);
    note_missing_stars(&args.scene, &pictures.scene, stars);
    let options = HeadlessOptions {
        timed: args.timings.is_some(),
        light: format == Format::Exr
            || args.shutter.is_some()
            || args.alpha.is_some()
            || film.as_ref().is_some_and(FilmMaker::is_of_light),
        stars,
        ..HeadlessOptions::default()
    };
    let (first_scene, _) = pictures.get(pictures.first());
    let first_scene = drawn_at_once(&first_scene);
    let mut studio = match &tiling {
        Some(tiling) => {
            let first_scene = picture::exposed(&first_scene)?;
            let options = tiling.options(options);
            // The levels of a file do not come from the image that a window would show.
            Studio::with_options(&first_scene, UVec2::ONE, options)?
        }
        None => {
            let size = first_scene.picture.size();
            Studio::with_options(&drawn_scene(&first_scene, format), size, options)?
        }
    };
    studio.show_layers(channels.drawn_layers(form));
    let mut writer = PictureWriter {
        studio,
        format,
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
    let _patience = (pictures.sequence.is_none() && tiling.is_none())
        .then(|| LongWork::new(still_drawing(size, writer.studio.adapter_kind())));
    let bar = if pictures.sequence.is_some() && tiling.is_none() {
        progress(pictures.numbers().len())
    } else {
        ProgressBar::hidden()
    };
    for number in pictures.numbers() {
        let (scene, file) = pictures.get(number);
        bar.set_message(file.display().to_string());
        writer.moments = pictures.moments(number);
        let began = Instant::now();
        writer.write(&scene, &file)?;
        if let Some(manifest) = &mut manifest {
            let (files, time) = (files_of(&file), began.elapsed());
            note_frame(manifest, (number, &files), time, &writer.studio)?;
        }
        if !format.holds_sequence() {
            let name = || {
                let mut files = files_of(&file).into_iter();
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
        && !format.holds_sequence()
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
