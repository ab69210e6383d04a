//! The arguments of every command.

mod args;
mod farm;
mod film;
mod measure;
mod number;
mod paths;
mod size;

pub(super) use args::first_given;
pub use args::{
    Cells, Device, FlyArgs, GpuArgs, PresetsCommand, RenderArgs, SceneArgs, TraceArgs, assignments,
};
pub use farm::FarmArgs;
pub use film::{FilmArgs, LutArgs, VideoArgs};
pub use measure::{BenchArgs, DoctorArgs, ExtremesArgs, ReportArgs};
pub use paths::{CameraArgs, CaptionsArgs};

use crate::app::NO_GAMEPAD;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::OsString;

const EXAMPLES: &str = "\
Examples:
  lightfall                                      fly, from preset 2
  lightfall --preset einstein-ring               fly, from another preset
  lightfall --preset graze                       fly a mission
  lightfall --kiosk                              fly journeys in a loop, for visitors
  lightfall render --preset 2 -o disk.png        one picture
  lightfall render --preset 2 --aov all -o disk.exr     linear light, and the data of each pixel's ray
  lightfall render --frames 0..299 -o flight-####.png   ten seconds of the built-in journey
  lightfall render --loop 10 -o disk.mp4         a film that repeats without a seam
  lightfall render --set camera.r=8 --set camera.theta_deg=60 --set sky.mode=grid -o near.png
  echo 0,0,1 | lightfall trace --rays - --device cpu
  lightfall presets show 2                       every field, with its meaning and range

Lengths are in Schwarzschild radii, angles in degrees. Results go to standard output, everything else to standard
error. Exit status: 0 everything was done, 2 a bad command line, preset, journey or file of rays, 130 an
interruption, 143 after SIGTERM, 75 try again later, 1 any other failure.";

/// The text below the help: examples and, in a build without gamepads, a note.
fn after_help() -> String {
    [EXAMPLES]
        .into_iter()
        .chain(NO_GAMEPAD)
        .collect::<Vec<_>>()
        .join("\n\n")
}

// The whole command line as it is written, from which `read` makes a `Command`. This is no doc
// comment because clap would print it.
#[derive(Debug, Parser)]
#[command(name = "lightfall", version, about, after_help = after_help())]
struct Cli {
    #[command(flatten)]
    fly: FlyArgs,
    #[command(flatten)]
    gpu: GpuArgs,
    #[command(subcommand)]
    command: Option<Command>,
}

/// A command with its arguments.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Fly: the command line has no command.
    #[command(skip)]
    Fly(FlyArgs),
    /// List the graphics adapters: the option `--list-gpus`.
    #[command(skip)]
    ListGpus,
    /// Render a picture, or a journey as a sequence of pictures, without a window.
    Render(Box<RenderArgs>),
    /// Write the camera's path along a journey, for other programs, without drawing.
    #[command(
        // They concern pictures alone, and are accepted because they may precede the command.
        mut_arg("samples", |arg| arg.hide(true)),
        mut_arg("cells", |arg| arg.hide(true)),
        mut_arg("stars", |arg| arg.hide(true)),
        mut_arg("sky", |arg| arg.hide(true))
    )]
    Camera(CameraArgs),
    /// Write the captions of a journey or a lesson as subtitles.
    Captions(CaptionsArgs),
    /// Trace rays: CSV in, CSV out.
    #[command(
        // They concern pictures alone, and are accepted because they may precede the command.
        mut_arg("samples", |arg| arg.hide(true)),
        mut_arg("cells", |arg| arg.hide(true)),
        mut_arg("dome", |arg| arg.hide(true)),
        mut_arg("stars", |arg| arg.hide(true)),
        mut_arg("sky", |arg| arg.hide(true)),
        after_help = "A ray is a line er,etheta,ephi: the looking direction on the observer's axes (outward, toward \
                            increasing theta, toward increasing phi), of any nonzero length. A header line is optional.\n\nThe output has one \
                            line per ray: outcome (sky, captured or unfinished); sky_*, the unit vector toward the source at \
                            infinity in the hole's frame, with z along the normal of a disk that is not tilted and the camera at azimuth \
                            camera.phi_deg; hit*_r in r_s, hit*_phi, the azimuth in the disk, in radians, and hit*_g, the observed over the emitted \
                            frequency, of the first two crossings of the disk's annulus along the backward ray; steps; \
                            residual, the largest normalized residual of the null condition; hit*_t, the time between \
                            emission and arrival in r_s/c, outside the horizon. Missing values are \
                            empty. docs/COMMANDS.md explains the columns of --numbers. The CPU always uses the f64 reference, for any method and spin."
    )]
    Trace(TraceArgs),
    /// Measure error and run time, for each scene, method and setting.
    Bench(BenchArgs),
    /// Measure the errors of methods in the hardest places.
    Extremes(ExtremesArgs),
    /// Encode numbered pictures as a film.
    Video(VideoArgs),
    /// Write a lookup table that gives the light of an .exr the look of the program's pictures.
    #[command(
        // They concern rays and places alone, and are accepted because they may precede the command.
        mut_arg("samples", |arg| arg.hide(true)),
        mut_arg("cells", |arg| arg.hide(true)),
        mut_arg("stars", |arg| arg.hide(true)),
    )]
    Lut(LutArgs),
    /// Report what this machine offers and whether the program runs well on it.
    Doctor(DoctorArgs),
    /// List, show or check presets.
    #[command(subcommand)]
    Presets(PresetsCommand),
}

impl Command {
    /// The word of the command line that calls it.
    fn name(&self) -> &'static str {
        match self {
            Self::Fly(_) | Self::ListGpus => "",
            Self::Render(_) => "render",
            Self::Camera(_) => "camera",
            Self::Captions(_) => "captions",
            Self::Trace(_) => "trace",
            Self::Bench(_) => "bench",
            Self::Extremes(_) => "extremes",
            Self::Video(_) => "video",
            Self::Lut(_) => "lut",
            Self::Doctor(_) => "doctor",
            Self::Presets(_) => "presets",
        }
    }
}

/// Reads the command line. Scene options may precede the command's name or follow it.
///
/// # Errors
/// clap's error, with its text and exit status. A request for help or for the version is an error
/// with status 0.
pub fn read<I: IntoIterator<Item: Into<OsString> + Clone>>(
    args: I,
) -> Result<Command, clap::Error> {
    read_all(args).map(|(_, command)| command)
}

/// As [`read`], and returns the options of the graphics adapter as well.
///
/// # Errors
/// As [`read`].
pub fn read_all<I: IntoIterator<Item: Into<OsString> + Clone>>(
    args: I,
) -> Result<(GpuArgs, Command), clap::Error> {
    let Cli { fly, gpu, command } = Cli::try_parse_from(args)?;
    let command = match command {
        _ if gpu.list_gpus => Command::ListGpus,
        Some(command) => with_options(fly, command)?,
        None => Command::Fly(fly),
    };
    Ok((gpu, command))
}

/// The command with the options that precede it.
fn with_options(before: FlyArgs, mut command: Command) -> Result<Command, clap::Error> {
    let name = command.name();
    let conflict = |message: &str| {
        let mut cli = Cli::command();
        cli.build();
        let named = cli.find_subcommand_mut(name);
        named
            .expect("every command has its name")
            .error(ErrorKind::ArgumentConflict, message)
    };
    if let Some(option) = before.window_option() {
        return Err(conflict(&format!(
            "{option} is for flying, without a command"
        )));
    }
    let (scene, journey) = (before.scene, before.journey);
    let own = match &mut command {
        Command::Camera(camera) => camera.journey.take(),
        Command::Render(render) => render.journey.take(),
        _ => None,
    };
    if journey.is_some() && own.is_some() {
        return Err(conflict(
            "--journey may be given once: before the command or after it",
        ));
    }
    let journey = journey.or(own);
    match &mut command {
        Command::Camera(camera) => camera.journey = journey,
        Command::Render(render) if render.frames.is_some() || render.loop_seconds.is_some() => {
            render.journey = journey;
        }
        _ if journey.is_none() => {}
        Command::Render(_) => {
            return Err(conflict(
                "--journey needs --frames A..B, the numbers of the pictures to draw",
            ));
        }
        _ => {
            return Err(conflict(
                "--journey is for flying, without a command, for `render` with --frames, and for `camera`",
            ));
        }
    }
    let follow = |after: &mut SceneArgs| -> Result<(), clap::Error> {
        let message = "--preset, --spin, --method, --cells and --stars may be given once: before the command or after it";
        *after = scene.followed_by(after).ok_or_else(|| conflict(message))?;
        Ok(())
    };
    match &mut command {
        Command::Fly(_) | Command::ListGpus => {}
        Command::Render(args) => follow(&mut args.scene)?,
        Command::Camera(CameraArgs { scene: after, .. })
        | Command::Trace(TraceArgs { scene: after, .. })
        | Command::Lut(LutArgs { scene: after, .. })
        | Command::Doctor(DoctorArgs { scene: after, .. }) => follow(after)?,
        Command::Extremes(ExtremesArgs {
            hunt: None,
            seed: Some(_),
            ..
        }) => {
            return Err(conflict(
                "--seed belongs to --hunt: every other run of `extremes` measures the same scenes",
            ));
        }
        _ if scene == SceneArgs::default() => {}
        Command::Presets(_) => return Err(conflict("`presets` takes no scene options")),
        Command::Captions(_) => return Err(conflict("`captions` takes no scene options")),
        Command::Video(_) => return Err(conflict("`video` takes no scene options")),
        Command::Bench(_) => return Err(conflict("`bench` takes its scenes by --scenes")),
        Command::Extremes(_) => {
            return Err(conflict(
                "`extremes` takes no scene options: its cells are its scenes",
            ));
        }
    }
    Ok(command)
}
