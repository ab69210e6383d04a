//! The command line: what can be asked for, and which scene is meant.

mod measure;

pub use measure::{BenchArgs, EntryArg, ExtremesArgs};

use std::ffi::{OsStr, OsString};
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use glam::UVec2;
use thiserror::Error;

use crate::gpu::{GpuError, GpuScene};
use crate::report::rays::is_closed_pipe;
use crate::scene::journey::{self, Journey, JourneyError};
use crate::scene::{Field, Override, Scene, SceneError, field, load, presets};

/// Most bytes of a preset file.
const LONGEST_PRESET: u64 = 1 << 20;

const EXAMPLES: &str = "\
Examples:
  lightfall                                      fly, from preset 2
  lightfall --preset einstein-ring               fly, from another place
  lightfall render --preset 2 -o disk.png        one picture
  lightfall render --set camera.r=8 --set camera.theta_deg=60 --set sky.mode=grid -o near.png
  echo 0,0,1 | lightfall trace --rays - --device cpu
  lightfall presets show 2                       every field, with its meaning and range

Lengths are in Schwarzschild radii, angles in degrees. Results go to standard output, everything else to standard
error. Exit status: 0 all done, 2 a bad command line or preset, 1 any other failure.";

// The whole command line, as it is written; `read` makes a `Command` of it. No doc comment: clap would print it.
#[derive(Debug, Parser)]
#[command(name = "lightfall", version, about, after_help = EXAMPLES)]
struct Cli {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    gpu: GpuArgs,
    /// Fly a guided journey at once, from a TOML file of keyframes; assets/journeys/default.toml is a pattern, and what J
    /// flies otherwise
    #[arg(long, value_name = "FILE")]
    journey: Option<PathBuf>,
    #[command(subcommand)]
    command: Option<Command>,
}

/// Which graphics adapter is used, for every command.
#[derive(Clone, Debug, Default, PartialEq, Eq, Args)]
#[command(next_help_heading = "Graphics adapter")]
pub struct GpuArgs {
    /// Use the first adapter whose name contains this; as WGPU_ADAPTER_NAME
    #[arg(long, value_name = "NAME", global = true)]
    pub gpu: Option<String>,
    /// Use this graphics interface; as WGPU_BACKEND
    #[arg(long, value_name = "NAME", global = true, value_parser = ["vulkan", "metal", "dx12", "gl"])]
    pub backend: Option<String>,
    /// List the adapters and do nothing else
    #[arg(long)]
    pub list_gpus: bool,
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
    /// Render one picture into a file, without a window.
    Render(RenderArgs),
    /// Trace rays, CSV in and CSV out.
    #[command(
        after_help = "A ray is a line er,etheta,ephi: the looking direction on the observer's legs, outward, toward \
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
    /// List, show or check presets.
    #[command(subcommand)]
    Presets(PresetsCommand),
}

/// Which scene: a preset and what overrides it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Args)]
#[command(next_help_heading = "Scene")]
pub struct SceneArgs {
    /// Preset to start from: a number or name (see `lightfall presets list`) or a TOML file [default: 2]
    #[arg(long, value_name = "N|NAME|PATH")]
    pub preset: Option<OsString>,
    /// Set one field of the preset, e.g. camera.r=20; may be given many times, the last one wins
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub sets: Vec<String>,
    /// Short for --set hole.spin=CHI, after all --set
    #[arg(long, value_name = "CHI", allow_hyphen_values = true)]
    pub spin: Option<String>,
    /// Short for --set method=METHOD, after all --set
    #[arg(long, help = format!("Short for --set method=METHOD, after all --set; {}",
                               field("method").map(Field::allowed).unwrap_or_default()))]
    pub method: Option<String>,
}

/// What `lightfall` is told without a command.
#[derive(Clone, Debug, Default, PartialEq, Eq, Args)]
pub struct FlyArgs {
    /// Which scene.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// File of the journey to fly at once.
    #[arg(skip)]
    pub journey: Option<PathBuf>,
}

/// What `lightfall render` is told.
#[derive(Debug, Args)]
pub struct RenderArgs {
    /// Picture to write; the ending decides the format. A file of this name is replaced
    #[arg(short, long = "out", value_name = "FILE")]
    pub out: PathBuf,
    /// Size of the output, in pixels, onto which the picture is enlarged as in a window [default: that of the picture].
    /// How finely it is drawn say picture.width and picture.height, and picture.bypass=true takes the cells away
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<UVec2>,
    /// Also say, on standard error, how long the GPU takes for each pass
    #[arg(long)]
    pub timings: bool,
    /// Which scene.
    #[command(flatten)]
    pub scene: SceneArgs,
}

/// What `lightfall trace` is told.
#[derive(Debug, Args)]
pub struct TraceArgs {
    /// Rays to trace, or - for standard input
    #[arg(long, value_name = "FILE|-")]
    pub rays: PathBuf,
    /// Who traces
    #[arg(long, value_enum, default_value_t = Device::Gpu)]
    pub device: Device,
    /// Which scene.
    #[command(flatten)]
    pub scene: SceneArgs,
}

/// Who traces rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Device {
    /// The shaders that draw the pictures
    Gpu,
    /// The f64 reference
    Cpu,
}

/// What `lightfall presets` does.
#[derive(Debug, Subcommand)]
pub enum PresetsCommand {
    /// List the built-in presets
    List,
    /// Show every field of a preset, with its meaning and range, as a preset file
    Show {
        /// Number, name or TOML file
        #[arg(value_name = "NAME")]
        preset: OsString,
        /// Show instead what drawing it compiles in, leaves out and runs
        #[arg(long)]
        needs: bool,
    },
    /// Check a preset file
    Check {
        /// TOML file
        file: PathBuf,
    },
}

/// Why the command line does not give a scene, or what was asked could not be written.
#[derive(Debug, Error)]
pub enum CliError {
    /// The preset or what overrides it is wrong.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The journey is wrong.
    #[error(transparent)]
    Journey(#[from] JourneyError),
    /// No built-in preset and no file has this name.
    #[error("--preset {given}: there is no such file, and the presets are {}", all_presets())]
    UnknownPreset {
        /// What was given.
        given: String,
    },
    /// A preset file cannot be read.
    #[error("{}: cannot be read: {error}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// A preset file is longer than any preset.
    #[error("{}: is longer than {LONGEST_PRESET} bytes; presets and journeys are short TOML texts", path.display())]
    TooLong {
        /// The file.
        path: PathBuf,
    },
    /// A preset file is not text.
    #[error("{}: is not UTF-8 text; presets and journeys are short TOML texts", path.display())]
    NotText {
        /// The file.
        path: PathBuf,
    },
    /// A preset whose fields do not go together.
    #[error("{}: {reason}", path.display())]
    Undrawable {
        /// The file.
        path: PathBuf,
        /// What does not.
        reason: String,
    },
    /// The answer cannot be written.
    #[error("standard output: {0}")]
    Output(io::Error),
}

impl CliError {
    /// Exit status: 2 for a bad command line or preset, 1 for any other failure.
    pub fn exit_code(&self) -> u8 {
        if matches!(self, Self::Output(_)) { 1 } else { 2 }
    }
}

/// Reads the command line. Scene options may stand before the command's name or after it.
///
/// # Errors
/// Clap's, with its own text and exit status; a request for help or the version is one of them, with status 0.
pub fn read<I: IntoIterator<Item: Into<OsString> + Clone>>(args: I) -> Result<Command, clap::Error> {
    read_all(args).map(|(_, command)| command)
}

/// As [`read`], with the graphics adapter that is meant.
///
/// # Errors
/// As [`read`].
pub fn read_all<I: IntoIterator<Item: Into<OsString> + Clone>>(args: I) -> Result<(GpuArgs, Command), clap::Error> {
    let Cli { scene, gpu, journey, command } = Cli::try_parse_from(args)?;
    let command = if gpu.list_gpus { Command::ListGpus } else { asked(scene, journey, command)? };
    Ok((gpu, command))
}

/// The command, with the scene options that stand before it.
fn asked(before: SceneArgs, journey: Option<PathBuf>, command: Option<Command>) -> Result<Command, clap::Error> {
    let Some(mut command) = command else { return Ok(Command::Fly(FlyArgs { scene: before, journey })) };
    let conflict = |message: &str| Cli::command().error(ErrorKind::ArgumentConflict, message);
    if journey.is_some() {
        return Err(conflict("--journey is for flying, without a command"));
    }
    match &mut command {
        Command::Fly(fly) => fly.scene = before,
        Command::Render(RenderArgs { scene: after, .. }) | Command::Trace(TraceArgs { scene: after, .. }) => {
            let message = "--preset, --spin and --method may be given once: before the command or after it";
            *after = before.followed_by(after).ok_or_else(|| conflict(message))?;
        }
        Command::ListGpus => {}
        Command::Presets(_) if before == SceneArgs::default() => {}
        Command::Bench(_) | Command::Extremes(_) if before == SceneArgs::default() => {}
        Command::Presets(_) => return Err(conflict("`presets` takes no scene options")),
        Command::Bench(_) => return Err(conflict("`bench` takes its scenes by --scenes")),
        Command::Extremes(_) => return Err(conflict("`extremes` takes no scene options: its cells are its scenes")),
    }
    Ok(command)
}

impl SceneArgs {
    /// These options and then those, or none where both say the same thing once for all.
    fn followed_by(&self, after: &Self) -> Option<Self> {
        fn one<T: Clone>(a: &Option<T>, b: &Option<T>) -> Option<Option<T>> {
            (a.is_none() || b.is_none()).then(|| a.clone().or_else(|| b.clone()))
        }
        Some(Self {
            preset: one(&self.preset, &after.preset)?,
            sets: [&self.sets[..], &after.sets[..]].concat(),
            spin: one(&self.spin, &after.spin)?,
            method: one(&self.method, &after.method)?,
        })
    }

    fn overrides(&self) -> Result<Vec<Override>, SceneError> {
        let mut overrides = self.sets.iter().map(|set| Override::assignment(set)).collect::<Result<Vec<_>, _>>()?;
        overrides.extend(self.spin.as_ref().map(|spin| Override::new("--spin", "hole.spin", spin)));
        overrides.extend(self.method.as_ref().map(|method| Override::new("--method", "method", method)));
        Ok(overrides)
    }
}

/// The scene that is meant; reads the preset's file where it is one.
///
/// # Errors
/// One sentence that names the file or option and what is wrong with it.
pub fn scene(args: &SceneArgs) -> Result<Scene, CliError> {
    let overrides = args.overrides()?;
    match &args.preset {
        None => Ok(presets::PRESETS[presets::DEFAULT - 1].scene(&overrides)?),
        Some(preset) => named(preset, &overrides),
    }
}

/// Does what `lightfall presets` is asked for, and answers into `out`.
///
/// # Errors
/// A preset that does not exist, cannot be read or is wrong; or `out` cannot be written. That nobody reads any more is
/// no error.
pub fn presets(command: &PresetsCommand, out: &mut impl Write) -> Result<(), CliError> {
    let answer = match command {
        PresetsCommand::List => {
            let mut list = String::new();
            for preset in presets::PRESETS {
                list += &format!("{}  {:14} {}\n", preset.number, preset.name, preset.scene(&[])?.title);
            }
            list
        }
        PresetsCommand::Show { preset, needs } => {
            let scene = named(preset, &[])?;
            if *needs { crate::render::needs(&scene) } else { scene.to_preset() }
        }
        PresetsCommand::Check { file } => {
            let scene = from_file(file, &[])?;
            match GpuScene::for_rays(&scene) {
                // The reference traces on the CPU, and that is a use of a preset.
                Ok(_) | Err(GpuError::MethodOfCpu) => {}
                Err(error) => return Err(CliError::Undrawable { path: file.clone(), reason: error.to_string() }),
            }
            format!("{}: ok\n", file.display())
        }
    };
    match out.write_all(answer.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if !is_closed_pipe(&error) => Err(CliError::Output(error)),
        _ => Ok(()),
    }
}

/// The scene of a built-in preset's number or name, else of a file.
fn named(preset: &OsStr, overrides: &[Override]) -> Result<Scene, CliError> {
    if let Some(preset) = preset.to_str().and_then(presets::find) {
        return Ok(preset.scene(overrides)?);
    }
    let path = Path::new(preset);
    let looks_like_a_path = path.components().count() > 1 || path.extension().is_some();
    if !looks_like_a_path && !path.exists() {
        return Err(CliError::UnknownPreset { given: preset.display().to_string() });
    }
    from_file(path, overrides)
}

/// The journey of a file, or the built-in one.
///
/// # Errors
/// One sentence that names the file and what is wrong with it.
pub fn journey(file: Option<&Path>) -> Result<Journey, CliError> {
    Ok(match file {
        None => journey::load("the built-in journey", journey::DEFAULT)?,
        Some(path) => journey::load(&path.display().to_string(), &read_text(path)?)?,
    })
}

/// The scene of a preset file.
fn from_file(path: &Path, overrides: &[Override]) -> Result<Scene, CliError> {
    Ok(load(&path.display().to_string(), &read_text(path)?, overrides)?)
}

/// The text of a file that is meant to be a short one.
fn read_text(path: &Path) -> Result<String, CliError> {
    let mut bytes = Vec::new();
    // Bounded, for there are files without an end.
    let read = File::open(path).and_then(|file| file.take(LONGEST_PRESET + 1).read_to_end(&mut bytes));
    read.map_err(|error| CliError::Unreadable { path: path.into(), error })?;
    if bytes.len() as u64 > LONGEST_PRESET {
        return Err(CliError::TooLong { path: path.into() });
    }
    String::from_utf8(bytes).map_err(|_| CliError::NotText { path: path.into() })
}

/// Reads a size such as `960x540`.
fn size(text: &str) -> Result<UVec2, String> {
    const MOST: u32 = 16384;
    let side = |side: &str| side.parse().ok().filter(|side| (1..=MOST).contains(side));
    let (width, height) = text.split_once(['x', 'X']).unwrap_or_default();
    side(width)
        .zip(side(height))
        .map(UVec2::from)
        .ok_or(format!("a size is WxH, such as 960x540, each from 1 to {MOST}"))
}

fn all_presets() -> String {
    presets::PRESETS.map(|preset| format!("{} {}", preset.number, preset.name)).join(", ")
}
