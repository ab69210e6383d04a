//! The arguments of every command.

mod args;
mod measure;
mod number;
mod size;

pub use args::{
    Device, FlyArgs, GpuArgs, PresetsCommand, RenderArgs, SceneArgs, TraceArgs, assignments,
};
pub use measure::{BenchArgs, DoctorArgs, ExtremesArgs, ReportArgs};

use crate::app::NO_GAMEPAD;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::OsString;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  lightfall                                      fly, from preset 2
  lightfall --preset einstein-ring               fly, from another preset
  lightfall render --preset 2 -o disk.png        one picture
  lightfall render --preset 2 --aov all -o disk.exr     linear light, and the data of each pixel's ray
  lightfall render --frames 0..299 -o flight-####.png   ten seconds of the built-in journey
  lightfall render --set camera.r=8 --set camera.theta_deg=60 --set sky.mode=grid -o near.png
  echo 0,0,1 | lightfall trace --rays - --device cpu
  lightfall presets show 2                       every field, with its meaning and range

Lengths are in Schwarzschild radii, angles in degrees. Results go to standard output, everything else to standard
error. Exit status: 0 everything was done, 2 a bad command line, preset, journey or file of rays, 130 an
interruption, 1 any other failure.";

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
    scene: SceneArgs,
    #[command(flatten)]
    gpu: GpuArgs,
    /// Fly a guided journey at once, from a TOML file of keyframes; assets/journeys/default.toml of
    /// the source code is an example, and the journey that J flies by default
    #[arg(long, value_name = "FILE", help_heading = "Scene")]
    journey: Option<PathBuf>,
    /// Draw with the WGSL files of a folder, such as shaders of the source code, and read them again whenever one of
    /// them changes, for work on the shaders
    #[arg(long, value_name = "FOLDER")]
    shaders: Option<PathBuf>,
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
    Render(RenderArgs),
    /// Trace rays: CSV in, CSV out.
    #[command(
        after_help = "A ray is a line er,etheta,ephi: the looking direction on the observer's axes (outward, toward \
                            increasing theta, toward increasing phi), of any nonzero length. A header line is optional.\n\nThe output has one \
                            line per ray: outcome (sky, captured or unfinished); sky_*, the unit vector toward the source at \
                            infinity in the hole's frame, with z along the normal of a disk that is not tilted and the camera at azimuth \
                            camera.phi_deg; hit*_r in r_s, hit*_phi, the azimuth in the disk, in radians, and hit*_g, the observed over the emitted \
                            frequency, of the first two crossings of the disk's annulus along the backward ray; steps; \
                            residual, the largest normalized residual of the null condition; hit*_t, the time between \
                            emission and arrival in r_s/c, outside the horizon. Missing values are \
                            empty. The CPU always uses the f64 reference, for any method and spin."
    )]
    Trace(TraceArgs),
    /// Measure error and run time, for each scene, method and setting.
    Bench(BenchArgs),
    /// Measure the errors of methods in the hardest places.
    Extremes(ExtremesArgs),
    /// Report what this machine offers and whether the program runs well on it.
    Doctor(DoctorArgs),
    /// List, show or check presets.
    #[command(subcommand)]
    Presets(PresetsCommand),
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
    let Cli {
        scene,
        gpu,
        journey,
        shaders,
        command,
    } = Cli::try_parse_from(args)?;
    let command = if gpu.list_gpus {
        Command::ListGpus
    } else {
        with_options(scene, journey, shaders, command)?
    };
    Ok((gpu, command))
}

/// The command with the options that precede it.
fn with_options(
    before: SceneArgs,
    journey: Option<PathBuf>,
    shaders: Option<PathBuf>,
    command: Option<Command>,
) -> Result<Command, clap::Error> {
    let Some(mut command) = command else {
        return Ok(Command::Fly(FlyArgs {
            scene: before,
            journey,
            shaders,
        }));
    };
    let conflict = |message: &str| Cli::command().error(ErrorKind::ArgumentConflict, message);
    if shaders.is_some() {
        return Err(conflict("--shaders is for flying, without a command"));
    }
    let mut journey = journey;
    if let Command::Render(render) = &mut command {
        if journey.is_some() && render.journey.is_some() {
            return Err(conflict(
                "--journey may be given once: before the command or after it",
            ));
        }
        journey = journey.or(render.journey.take());
        if render.frames.is_some() {
            render.journey = journey.take();
        }
    }
    if journey.is_some() {
        return Err(conflict(
            "--journey is for flying, without a command, and for `render` with --frames",
        ));
    }
    match &mut command {
        Command::Fly(fly) => fly.scene = before,
        Command::Render(RenderArgs { scene: after, .. })
        | Command::Trace(TraceArgs { scene: after, .. })
        | Command::Doctor(DoctorArgs { scene: after, .. }) => {
            let message = "--preset, --spin, --method, --cells and --stars may be given once: before the command or after it";
            *after = before.followed_by(after).ok_or_else(|| conflict(message))?;
        }
        Command::ListGpus => {}
        Command::Extremes(ExtremesArgs {
            hunt: None,
            seed: Some(_),
            ..
        }) => {
            return Err(conflict(
                "--seed belongs to --hunt: every other run of `extremes` measures the same scenes",
            ));
        }
        Command::Presets(_) if before == SceneArgs::default() => {}
        Command::Bench(_) | Command::Extremes(_) if before == SceneArgs::default() => {}
        Command::Presets(_) => return Err(conflict("`presets` takes no scene options")),
        Command::Bench(_) => return Err(conflict("`bench` takes its scenes by --scenes")),
        Command::Extremes(_) => {
            return Err(conflict(
                "`extremes` takes no scene options: its cells are its scenes",
            ));
        }
    }
    Ok(command)
}
