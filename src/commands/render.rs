//! `lightfall render`.

use super::{commit, print, progress};
use crate::commands::cli;
use crate::commands::cli::RenderArgs;
use crate::commands::run::{Stop, drawable, failed, refused, scene, without_device};
use crate::picture;
use crate::picture::{
    Channels, Format, Frames, HeadlessOptions, Linear, PassTime, PictureError, PixelRays, Sequence,
    Still, Studio,
};
use glam::UVec2;
use indicatif::ProgressBar;
use lightfall_core::scene::Scene;
use std::path::{Path, PathBuf};

/// Frames that `render --timings` takes the median of.
const TIMED_FRAMES: usize = 15;

/// Draws and writes a picture, or a sequence of them.
pub fn render(args: &RenderArgs) -> Result<(), Stop> {
    let mut scene = scene(&args.scene)?;
    // The file first: a picture that cannot be kept is not worth the work.
    let sequence = args
        .frames
        .map(|frames| sequence(args, frames, &scene))
        .transpose()?;
    let first = sequence.as_ref().map_or_else(
        || args.out.clone(),
        |sequence| sequence.file(sequence.frames.first),
    );
    let format = picture::check_path(&first).map_err(refused)?;
    if let (Format::Exr, Some(size)) = (format, args.size) {
        resize(&mut scene, size)?;
    }
    if let (Format::Png, Some(_)) = (format, &args.aov) {
        return Err(Stop(
            2,
            "--aov is for pictures of linear light: the file's name must end in .exr".into(),
        ));
    }
    let shots = Shots {
        scene,
        file: args.out.clone(),
        sequence,
    };
    shots.check()?;

    let picture = UVec2::new(shots.scene.picture.width, shots.scene.picture.height);
    let size = if format == Format::Exr {
        picture
    } else {
        args.size.unwrap_or(picture)
    };
    let equipment = HeadlessOptions {
        timed: args.timings,
        light: format == Format::Exr,
    };
    let (begin, _) = shots.get(shots.numbers().start);
    let mut camera = Camera {
        studio: Studio::equipped(&begin, size, equipment).map_err(stopped)?,
        format,
        channels: args.aov.clone().unwrap_or_default(),
        rays: None,
        fps: args.frames.map(|_| args.fps),
    };
    let bar = if shots.sequence.is_some() {
        progress(shots.numbers().len())
    } else {
        ProgressBar::hidden()
    };
    for number in shots.numbers() {
        let (scene, file) = shots.get(number);
        bar.set_message(file.display().to_string());
        camera.take(&scene, &file)?;
        bar.suspend(|| print(&format!("{}\n", file.display())))?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    if args.timings {
        say_times(&camera.studio.time(TIMED_FRAMES).map_err(stopped)?);
    }
    if let Some(sequence) = &shots.sequence {
        eprintln!(
            "lightfall: a video of them: {}",
            sequence.ffmpeg(size.x, size.y)
        );
    }
    Ok(())
}

fn sequence(args: &RenderArgs, frames: Frames, scene: &Scene) -> Result<Sequence, Stop> {
    let of_file = args.journey.as_deref();
    let journey =
        cli::journey(of_file, scene).map_err(|error| Stop(error.exit_code(), error.to_string()))?;
    let sequence = Sequence::new(journey, frames, args.fps, &args.out)
        .map_err(|sentence| Stop(2, sentence))?;
    let end = sequence.end();
    if f64::from(frames.last) > end {
        eprintln!("lightfall: the journey ends at frame {end}; those after it show its end");
    }
    Ok(sequence)
}

/// Draws the scene at another size. No cell is finer than a pixel.
fn resize(scene: &mut Scene, size: UVec2) -> Result<(), Stop> {
    let picture = &mut scene.picture;
    (picture.width, picture.height) = (size.x, size.y);
    (picture.grid_width, picture.grid_height) = (
        picture.grid_width.min(size.x),
        picture.grid_height.min(size.y),
    );
    scene
        .check()
        .map_err(|refusal| Stop(2, format!("--size: {refusal}")))
}

/// What is drawn, and where it is written: one picture or the frames of a sequence, by number.
struct Shots {
    scene: Scene,
    file: PathBuf,
    sequence: Option<Sequence>,
}

impl Shots {
    fn numbers(&self) -> std::ops::Range<u32> {
        self.sequence
            .as_ref()
            .map_or(0..1, |Sequence { frames, .. }| {
                frames.first..frames.last + 1
            })
    }

    fn get(&self, number: u32) -> (Scene, PathBuf) {
        match &self.sequence {
            Some(sequence) => (sequence.scene(&self.scene, number), sequence.file(number)),
            None => (self.scene.clone(), self.file.clone()),
        }
    }

    /// Whether all of them can be drawn: nobody wants to learn at the last frame that it cannot.
    fn check(&self) -> Result<(), Stop> {
        drawable(&self.get(self.numbers().start).0)?;
        let Some(sequence) = &self.sequence else {
            return Ok(());
        };
        for number in self.numbers() {
            let refused = |reason| Stop(2, format!("frame {number}: {reason}"));
            lightfall_core::gpu::Drawable::new(sequence.scene(&self.scene, number))
                .map_err(refused)?;
        }
        Ok(())
    }
}

/// What takes the pictures.
struct Camera {
    studio: Studio,
    format: Format,
    channels: Channels,
    /// Opened when they are needed first.
    rays: Option<PixelRays>,
    fps: Option<f64>,
}

impl Camera {
    /// Draws the scene and writes its picture.
    fn take(&mut self, scene: &Scene, file: &Path) -> Result<(), Stop> {
        self.studio.show(scene).map_err(stopped)?;
        self.studio.settle().map_err(stopped)?;
        if self.format == Format::Png {
            let still = self.studio.picture().map_err(stopped)?;
            return write_png(file, &still, scene);
        }
        let light = self.studio.light().map_err(stopped)?;
        let depth = if self.channels.with_depth() {
            self.studio.depth().map_err(stopped)?
        } else {
            Vec::new()
        };
        let samples = if self.channels.list().is_empty() {
            Vec::new()
        } else {
            let rays = match &mut self.rays {
                Some(rays) => rays,
                none => none.insert(PixelRays::open().map_err(without_device)?),
            };
            rays.sample(scene, &self.channels, &depth).map_err(failed)?
        };
        let commit = commit();
        let picture = Linear {
            scene,
            light,
            channels: &self.channels,
            samples,
            commit: commit.as_deref(),
            fps: self.fps,
        };
        picture::write_exr(file, picture).map_err(failed)
    }
}

/// Whoever interrupts knows why it stops.
fn stopped(error: PictureError) -> Stop {
    let status = if matches!(error, PictureError::Interrupted) {
        130
    } else {
        1
    };
    Stop(status, error.to_string())
}

fn write_png(file: &Path, still: &Still, scene: &Scene) -> Result<(), Stop> {
    picture::write_png(
        file,
        still.width,
        still.height,
        &still.rgb,
        &scene.to_preset(),
    )
    .map_err(failed)
}

/// Writes a finished picture of the scene and prints the file's name.
pub fn write_still(file: &Path, still: &Still, scene: &Scene) -> Result<(), Stop> {
    write_png(file, still, scene)?;
    print(&format!("{}\n", file.display()))
}

fn say_times(times: &[PassTime]) {
    eprintln!(
        "{:>10}{:>10}  pass (GPU time in ms, median of {TIMED_FRAMES} frames)",
        "drawn", "kept"
    );
    for PassTime {
        pass,
        median_ms,
        kept_ms,
    } in times
    {
        eprintln!("{median_ms:>10.3}{kept_ms:>10.3}  {pass}");
    }
}
