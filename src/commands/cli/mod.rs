//! The arguments of every command.

mod args;
mod measure;
mod size;

pub use args::{Device, FlyArgs, GpuArgs, PresetsCommand, RenderArgs, SceneArgs, TraceArgs};
pub use measure::{BenchArgs, DoctorArgs, EntryArg, ExtremesArgs};

use crate::app::NO_GAMEPAD;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::OsString;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  lightfall                                      fly, from preset 2
  lightfall --preset einstein-ring               fly, from another place
  lightfall render --preset 2 -o disk.png        one picture
  lightfall render --preset 2 --aov all -o disk.exr     linear light, and what each pixel's ray tells
  lightfall render --frames 0..299 -o flight-####.png   ten seconds of the built-in journey
  lightfall render --set camera.r=8 --set camera.theta_deg=60 --set sky.mode=grid -o near.png
  echo 0,0,1 | lightfall trace --rays - --device cpu
  lightfall presets show 2                       every field, with its meaning and range

Lengths are in Schwarzschild radii, angles in degrees. Results go to standard output, everything else to standard
error. Exit status: 0 all done, 2 a bad command line, preset, journey or file of rays, 1 any other failure.";

/// The text below the help: examples and, in a build without gamepads, a note.
fn after_help() -> String {
    [EXAMPLES]
        .into_iter()
        .chain(NO_GAMEPAD)
        .collect::<Vec<_>>()
        .join("\n\n")
}

// The whole command line, as it is written; `read` makes a `Command` of it. No doc comment: clap
// would print it.
#[derive(Debug, Parser)]
#[command(name = "lightfall", version, about, after_help = after_help())]
struct Cli {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    gpu: GpuArgs,
    /// Fly a guided journey at once, from a TOML file of keyframes; assets/journeys/default.toml is
    /// a pattern, and what J flies otherwise
    #[arg(long, value_name = "FILE", help_heading = "Scene")]
    journey: Option<PathBuf>,
    #[command(subcommand)]
    command: Option<Command>,
}

/// What is asked for.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Fly: what happens without a command.
    #[command(skip)]
    Fly(FlyArgs),
    /// List graphics adapters: what `--list-gpus` asks for.
    #[command(skip)]
    ListGpus,
    /// Render a picture, or a journey as a sequence of them, without a window.
    Render(RenderArgs),
    /// Trace rays, CSV in and CSV out.
    #[command(
        after_help = "A ray is a line er,etheta,ephi: the looking direction on the observer's axes, outward, toward \
                            growing theta, toward growing phi, of any length but zero. A header line is optional.\n\nOne line a \
                            ray: outcome (sky, captured, unfinished); sky_*, the unit vector toward the source at \
                            infinity in the hole's frame, z along the disk normal, the camera at azimuth \
                            camera.phi_deg; hit*_r in r_s, hit*_phi in radians and hit*_g, observed over emitted \
                            frequency, of the first two crossings of the disk's annulus along the backward ray; steps; \
                            residual, the largest normalized residual of the null condition. What there is not is \
                            empty. The CPU always answers by the f64 reference, for any method and spin."
    )]
    Trace(TraceArgs),
    /// Measure error against run time, for each scene, method and setting.
    Bench(BenchArgs),
    /// Measure where methods break, in the hardest places.
    Extremes(ExtremesArgs),
    /// Say what this machine is and whether the program runs well on it.
    Doctor(DoctorArgs),
    /// List, show or check presets.
    #[command(subcommand)]
    Presets(PresetsCommand),
}

/// Reads the command line. Scene options may stand before the command's name or after it.
///
/// # Errors
/// Clap's, with its own text and exit status; a request for help or the version is one of them,
/// with status 0.
pub fn read<I: IntoIterator<Item: Into<OsString> + Clone>>(
    args: I,
) -> Result<Command, clap::Error> {
    read_all(args).map(|(_, command)| command)
}

/// As [`read`], with the graphics adapter that is meant.
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
        command,
    } = Cli::try_parse_from(args)?;
    let command = if gpu.list_gpus {
        Command::ListGpus
    } else {
        asked(scene, journey, command)?
    };
    Ok((gpu, command))
}

/// The command, with the scene options that stand before it.
fn asked(
    before: SceneArgs,
    journey: Option<PathBuf>,
    command: Option<Command>,
) -> Result<Command, clap::Error> {
    let Some(mut command) = command else {
        return Ok(Command::Fly(FlyArgs {
            scene: before,
            journey,
        }));
    };
    let conflict = |message: &str| Cli::command().error(ErrorKind::ArgumentConflict, message);
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
        | Command::Trace(TraceArgs { scene: after, .. }) => {
            let message =
                "--preset, --spin and --method may be given once: before the command or after it";
            *after = before.followed_by(after).ok_or_else(|| conflict(message))?;
        }
        Command::ListGpus => {}
        Command::Presets(_) if before == SceneArgs::default() => {}
        Command::Bench(_) | Command::Extremes(_) | Command::Doctor(_)
            if before == SceneArgs::default() => {}
        Command::Presets(_) => return Err(conflict("`presets` takes no scene options")),
        Command::Bench(_) => return Err(conflict("`bench` takes its scenes by --scenes")),
        Command::Extremes(_) => {
            return Err(conflict(
                "`extremes` takes no scene options: its cells are its scenes",
            ));
        }
        Command::Doctor(_) => return Err(conflict("`doctor` takes no scene options")),
    }
    Ok(command)
}
