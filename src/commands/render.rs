//! `lightfall render`: a picture, or a sequence of pictures: a journey, or a disk that moves.

use super::circumstances::{circumstances, commit};
use super::cli::RenderArgs;
use super::output::print;
use super::progress::{LongWork, progress};
use super::scene::{device, drawable, journey, scene, stars};
use super::stop::Stop;
use glam::UVec2;
use indicatif::ProgressBar;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Picture, Scene, SkyMode};
use lightfall_lab::export::csv;
use lightfall_picture as picture;
use lightfall_picture::{
    Animation, ChannelNames, Channels, Format, Frames, HeadlessOptions, Linear, PassTime,
    PictureError, PixelRays, Sequence, Still, Studio,
};
use lightfall_platform::log::say;
use lightfall_platform::storage;
use lightfall_render::{fit, resized};
use std::ops::Range;
use std::path::{Path, PathBuf, absolute};

/// The word that stands for no journey.
const NO_JOURNEY: &str = "none";

/// Number of frames that `render --timings` takes the median of.
const TIMED_FRAMES: usize = 15;

/// Draws and writes a picture, or a sequence of pictures.
pub(super) fn render(args: &RenderArgs) -> Result<(), Stop> {
    let mut scene = scene(&args.scene)?;
    let sequence = args
        .frames
        .map(|frames| sequence(args, frames, &scene))
        .transpose()?;
    let format = check_files(&args.out, sequence.as_ref()).map_err(stop_writing)?;
    if let Some(size) = args.size {
        resize(&mut scene, size)?;
    }
    if format == Format::Apng && sequence.is_none() {
        return Err(Stop::refused(
            "-o: an .apng holds the frames of a sequence, so --frames A..B must name them",
        ));
    }
    if let (Format::Png | Format::Apng, Some(_)) = (format, &args.aov) {
        return Err(Stop::refused(
            "--aov is for pictures of linear light: the file's name must end in .exr",
        ));
    }
    if let Some(Some(file)) = &args.timings {
        check_times_file(file, &args.out)?;
    }
    let pictures = Pictures {
        format,
        scene,
        file: args.out.clone(),
        sequence,
    };
    pictures.check()?;

    let size = pictures.scene.picture.size();
    if format != Format::Exr && args.size.is_some() && args.scene.cells.is_none() {
        note_cells(&pictures.scene.picture);
    }
    note_unseen_stars(args, &pictures.scene);
    let options = HeadlessOptions {
        timed: args.timings.is_some(),
        light: format == Format::Exr,
        stars: stars(&args.scene)?,
    };
    let (first_scene, _) = pictures.get(pictures.numbers().start);
    let first_scene = drawn_scene(&first_scene, format);
    let mut writer = PictureWriter {
        studio: Studio::with_options(&first_scene, size, options).map_err(stop_drawing)?,
        format,
        channels: args.aov.clone().unwrap_or_default(),
        names: ChannelNames::from_word(&args.aov_names).unwrap_or_default(),
        rays: None,
        animation: None,
        frames: pictures.numbers().len() as u32,
        fps: args.frames.map(|_| args.fps),
    };
    let _patience = pictures.sequence.is_none().then(|| {
        LongWork::new(format!(
            "still drawing {} x {} pixels; without a graphics card a large picture takes minutes",
            size.x, size.y
        ))
    });
    let bar = if pictures.sequence.is_some() {
        progress(pictures.numbers().len())
    } else {
        ProgressBar::hidden()
    };
    for number in pictures.numbers() {
        let (scene, file) = pictures.get(number);
        bar.set_message(file.display().to_string());
        writer.write(&scene, &file)?;
        if format != Format::Apng {
            bar.suspend(|| print(&format!("{}\n", file.display())))?;
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    if let Some(animation) = writer.animation.take() {
        animation.finish().map_err(Stop::failed)?;
        print(&format!("{}\n", args.out.display()))?;
    }
    if let Some(file) = &args.timings {
        let times = writer.studio.time(TIMED_FRAMES).map_err(stop_drawing)?;
        print_times(&times);
        if let Some(file) = file {
            write_times(file, &times, size)?;
        }
    }
    if let Some(sequence) = &pictures.sequence
        && format != Format::Apng
    {
        say(format_args!(
            "lightfall: a video of them: {}",
            sequence.ffmpeg(size.x, size.y)
        ));
    }
    Ok(())
}

/// Warns that `--stars` has no effect here.
fn note_unseen_stars(args: &RenderArgs, scene: &Scene) {
    if let Some(file) = &args.scene.stars
        && scene.sky.mode != SkyMode::Stars
    {
        say(format_args!(
            "lightfall: --stars {} is not seen, because this scene has sky.mode = {}; \
             --set sky.mode=stars shows it",
            file.display(),
            scene.sky.mode.word()
        ));
    }
}

fn sequence(args: &RenderArgs, frames: Frames, scene: &Scene) -> Result<Sequence, Stop> {
    let journey = match args.journey.as_deref() {
        Some(file) if file == Path::new(NO_JOURNEY) => None,
        file => Some(journey(file, scene)?),
    };
    let sequence = Sequence::new(journey, frames, args.fps, &args.out).map_err(Stop::refused)?;
    match sequence.end() {
        Some(end) if f64::from(frames.last) > end && scene.disk_moves() => {
            say(format_args!(
                "lightfall: the journey ends at frame {end}; later frames show the disk from there"
            ));
        }
        Some(end) if f64::from(frames.last) > end => {
            say(format_args!(
                "lightfall: the journey ends at frame {end}; later frames show its end"
            ));
        }
        None if !scene.disk_moves() => {
            say(
                "lightfall: nothing moves in this scene without a journey: all frames are the same",
            );
        }
        _ => {}
    }
    Ok(sequence)
}

/// Checks that the times of the passes can be written, and not to the picture's file.
fn check_times_file(file: &Path, picture: &Path) -> Result<(), Stop> {
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
fn check_files(out: &Path, sequence: Option<&Sequence>) -> Result<Format, PictureError> {
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

/// Gives the scene's picture another size.
fn resize(scene: &mut Scene, size: UVec2) -> Result<(), Stop> {
    scene.picture = resized(&scene.picture, size);
    scene
        .check()
        .map_err(|refusal| Stop::refused(format!("--size: {refusal}")))
}

/// The scene as it is drawn for a file of this format. An EXR has no cells.
fn drawn_scene(scene: &Scene, format: Format) -> Scene {
    match format {
        Format::Png | Format::Apng => picture::filled(scene),
        Format::Exr => scene.clone(),
    }
}

/// Says that a picture whose size was asked for has cells that are larger than a pixel.
fn note_cells(picture: &Picture) {
    let grid = fit(picture, picture.size(), u64::MAX).grid();
    let pixels = picture.height.div_ceil(grid.y.max(1));
    if !picture.bypass && pixels > 1 {
        say(format_args!(
            "lightfall: the picture is shown in {} x {} cells of {pixels} pixels to a side; --cells off shows every pixel",
            grid.x, grid.y
        ));
    }
}

/// The pictures to draw, with their files: one, or the frames of a sequence, by number.
struct Pictures {
    format: Format,
    scene: Scene,
    file: PathBuf,
    sequence: Option<Sequence>,
}

impl Pictures {
    fn numbers(&self) -> Range<u32> {
        self.sequence
            .as_ref()
            .map_or(0..1, |Sequence { frames, .. }| {
                frames.first..frames.last + 1
            })
    }

    fn get(&self, number: u32) -> (Scene, PathBuf) {
        match &self.sequence {
            Some(sequence) => {
                let file = match self.format {
                    Format::Apng => self.file.clone(),
                    Format::Png | Format::Exr => sequence.file(number),
                };
                (sequence.scene(&self.scene, number), file)
            }
            None => (self.scene.clone(), self.file.clone()),
        }
    }

    /// Checks that all pictures can be drawn, so that the last frame of a long sequence does not
    /// come as a surprise.
    fn check(&self) -> Result<(), Stop> {
        drawable(&self.get(self.numbers().start).0)?;
        let Some(sequence) = &self.sequence else {
            return Ok(());
        };
        for number in self.numbers() {
            Drawable::new(sequence.scene(&self.scene, number))
                .map_err(|reason| Stop::refused(format!("frame {number}: {reason}")))?;
        }
        Ok(())
    }
}

/// Draws scenes and writes their pictures.
struct PictureWriter {
    studio: Studio,
    format: Format,
    channels: Channels,
    names: ChannelNames,
    /// Opened for the first picture that needs it.
    rays: Option<PixelRays>,
    /// Begun with the first frame.
    animation: Option<Animation>,
    /// How many pictures there will be.
    frames: u32,
    fps: Option<f64>,
}

impl PictureWriter {
    fn write(&mut self, scene: &Scene, file: &Path) -> Result<(), Stop> {
        let drawn = drawn_scene(scene, self.format);
        self.studio.show(&drawn).map_err(stop_drawing)?;
        self.studio.settle().map_err(stop_drawing)?;
        // The file's preset holds the exposure that was metered.
        let mut scene = scene.clone();
        scene.picture.exposure_ev = self.studio.scene().picture.exposure_ev;
        match self.format {
            Format::Png => {
                let still = self.studio.picture().map_err(stop_drawing)?;
                write_png(file, &still, &scene)
            }
            Format::Apng => {
                let still = self.studio.picture().map_err(stop_drawing)?;
                self.add_frame(&scene, file, &still).map_err(Stop::failed)
            }
            Format::Exr => self.write_exr(&scene, file),
        }
    }

    fn add_frame(&mut self, scene: &Scene, file: &Path, still: &Still) -> Result<(), PictureError> {
        let animation = match &mut self.animation {
            Some(animation) => animation,
            none => {
                let size = [still.width, still.height];
                let pace = (self.frames, self.fps.unwrap_or(1.0));
                none.insert(Animation::new(file, size, pace, &scene.to_preset())?)
            }
        };
        animation.add(still)
    }

    fn write_exr(&mut self, scene: &Scene, file: &Path) -> Result<(), Stop> {
        let light = self.studio.light().map_err(stop_drawing)?;
        let depth = if self.channels.with_depth() {
            self.studio.depth().map_err(stop_drawing)?
        } else {
            Vec::new()
        };
        let samples = if self.channels.list().is_empty() {
            Vec::new()
        } else {
            let rays = match &mut self.rays {
                Some(rays) => rays,
                none => none.insert(PixelRays::open().map_err(Stop::without_device)?),
            };
            rays.sample(scene, &self.channels, &depth)
                .map_err(Stop::failed)?
        };
        let commit = commit();
        let picture = Linear {
            scene,
            light,
            channels: &self.channels,
            samples,
            names: self.names,
            commit: commit.as_deref(),
            fps: self.fps,
        };
        picture::write_exr(file, picture).map_err(Stop::failed)
    }
}

/// A format that does not exist is a fault of the command line. A place where nothing can be
/// written is not.
fn stop_writing(error: PictureError) -> Stop {
    match error {
        PictureError::Extension { .. } => Stop::refused(error),
        _ => Stop::failed(error),
    }
}

/// The status of an interruption is 130, that of every other failure 1.
fn stop_drawing(error: PictureError) -> Stop {
    let status = if matches!(error, PictureError::Interrupted) {
        130
    } else {
        1
    };
    Stop {
        status,
        sentence: error.to_string(),
    }
}

fn write_png(file: &Path, still: &Still, scene: &Scene) -> Result<(), Stop> {
    picture::write_png(
        file,
        still.width,
        still.height,
        &still.rgb,
        &scene.to_preset(),
    )
    .map_err(Stop::failed)
}

/// Writes a finished picture of the scene as PNG and prints the file's name.
pub(super) fn write_still(file: &Path, still: &Still, scene: &Scene) -> Result<(), Stop> {
    write_png(file, still, scene)?;
    print(&format!("{}\n", file.display()))
}

/// Writes the times of a picture of this size as CSV.
fn write_times(file: &Path, times: &[PassTime], size: UVec2) -> Result<(), Stop> {
    let size = format!("{}x{}", size.x, size.y);
    let circumstances = circumstances(&device()?, size, "fragment");
    storage::write_atomically(file, csv(&circumstances, times).as_bytes()).map_err(Stop::failed)
}

fn print_times(times: &[PassTime]) {
    say(format_args!(
        "{:>10}{:>10}  pass (GPU time in ms, median of {TIMED_FRAMES} frames: of frames that draw the scene, and of \
         frames that keep its picture)",
        "drawn", "kept"
    ));
    for PassTime {
        pass,
        median_ms,
        kept_ms,
    } in times
    {
        say(format_args!("{median_ms:>10.3}{kept_ms:>10.3}  {pass}"));
    }
}
