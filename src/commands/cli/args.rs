//! What each command is told.

use super::size::size;
use crate::picture::{CHANNELS, Channels, Frames, frame_rate};
use clap::{Args, Subcommand, ValueEnum};
use glam::UVec2;
use lightfall_core::scene::{Field, Override, SceneError, field};
use std::ffi::OsString;
use std::path::PathBuf;

/// Which graphics adapter is used, for every command.
#[derive(Clone, Debug, Default, PartialEq, Eq, Args)]
#[command(next_help_heading = "Graphics adapter")]
pub struct GpuArgs {
    /// Use the first adapter whose name contains this; as WGPU_ADAPTER_NAME
    #[arg(long, value_name = "NAME", global = true)]
    pub gpu: Option<String>,
    /// Use this graphics interface; as WGPU_BACKEND
    #[arg(long, value_name = "NAME", global = true, value_parser = ["vulkan", "metal", "dx12"])]
    pub backend: Option<String>,
    /// List the adapters and do nothing else
    #[arg(long)]
    pub list_gpus: bool,
}

/// Which scene: a preset and what overrides it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Args)]
#[command(next_help_heading = "Scene")]
pub struct SceneArgs {
    /// Preset to start from: a number or name (see `lightfall presets list`), a TOML file, or a
    /// picture drawn from one [default: 2]
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
#[command(after_help = about_pictures())]
pub struct RenderArgs {
    /// Picture to write; the ending decides the format: .png is what a window would show, .exr
    /// linear light and what rays tell. A file of this name is replaced
    #[arg(short, long = "out", value_name = "FILE")]
    pub out: PathBuf,
    /// Size of the output, in pixels, up to 8192 a side, onto which a .png is enlarged as in a
    /// window; how finely it is drawn say picture.width and picture.height, and picture.bypass=true
    /// takes the cells away. Of an .exr, which has no cells, it is the size that is drawn [default:
    /// that of the picture]
    #[arg(long, value_name = "WxH", value_parser = size, allow_hyphen_values = true)]
    pub size: Option<UVec2>,
    /// Channels that an .exr has besides R, G, B and A, separated by commas: `all`, groups, or
    /// single ones, see below
    #[arg(long, value_name = "LIST")]
    pub aov: Option<Channels>,
    /// Draw a journey as numbered pictures: frame k is what there is to see k/N seconds after its
    /// start. A and B are both included. Frames after the end show the end
    #[arg(long, value_name = "A..B", allow_hyphen_values = true)]
    pub frames: Option<Frames>,
    /// Frames a second
    #[arg(long, value_name = "N", default_value_t = 30.0, value_parser = frame_rate, requires = "frames",
          allow_negative_numbers = true)]
    pub fps: f64,
    /// TOML file of the journey that --frames draws [default: the built-in one]
    #[arg(long, value_name = "FILE")]
    pub journey: Option<PathBuf>,
    /// Also say, on standard error, how long the GPU takes for each pass
    #[arg(long, conflicts_with = "frames")]
    pub timings: bool,
    /// Which scene.
    #[command(flatten)]
    pub scene: SceneArgs,
}

/// What stands under the help of `lightfall render`.
fn about_pictures() -> String {
    let channels = CHANNELS
        .map(|channel| format!("  {:9} {}\n", channel.name, channel.about))
        .concat();
    format!(
        "Channels (--aov), of the ray through each pixel's middle, whatever is in front of it; NaN where there is none. Groups \
         are sky, hit1 and hit2:\n{channels}\n\
         Names of a sequence: the last run of # stands for the number, with as many digits, as in fall-####.png; fall.png gives \
         fall-0001.png and so on. The exposure is the scene's in all frames. The line that makes a video of them is printed at \
         the end.\n\n\
         Pictures hold the preset that drew them: `--preset picture.png` or `--preset picture.exr` takes it."
    )
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
        /// Number, name, TOML file, or a picture that holds its preset
        #[arg(value_name = "NAME")]
        preset: OsString,
        /// Show instead what drawing it compiles in, leaves out and runs
        #[arg(long)]
        needs: bool,
    },
    /// Check a preset file
    Check {
        /// TOML file, or a picture that holds its preset
        file: PathBuf,
    },
}

impl SceneArgs {
    /// These options and then those, or none where both say the same thing once for all.
    pub(super) fn followed_by(&self, after: &Self) -> Option<Self> {
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

    /// The overrides of these options, in the order in which they apply.
    ///
    /// # Errors
    /// A `--set` that is not of the form KEY=VALUE.
    pub fn overrides(&self) -> Result<Vec<Override>, SceneError> {
        let mut overrides = self
            .sets
            .iter()
            .map(|set| Override::assignment(set))
            .collect::<Result<Vec<_>, _>>()?;
        overrides.extend(
            self.spin
                .as_ref()
                .map(|spin| Override::new("--spin", "hole.spin", spin)),
        );
        overrides.extend(
            self.method
                .as_ref()
                .map(|method| Override::new("--method", "method", method)),
        );
        Ok(overrides)
    }
}
