//! What each command is told.

use super::size;
use crate::scene::{Field, Override, SceneError, field};
use clap::{Args, Subcommand, ValueEnum};
use glam::UVec2;
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
    /// Size of the output, in pixels, up to 8192 a side, onto which the picture is enlarged as in a window [default: that of
    /// the picture]. How finely it is drawn say picture.width and picture.height, and picture.bypass=true takes the cells away
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

    /// What these options override, in the order in which it counts.
    pub(super) fn overrides(&self) -> Result<Vec<Override>, SceneError> {
        let mut overrides = self.sets.iter().map(|set| Override::assignment(set)).collect::<Result<Vec<_>, _>>()?;
        overrides.extend(self.spin.as_ref().map(|spin| Override::new("--spin", "hole.spin", spin)));
        overrides.extend(self.method.as_ref().map(|method| Override::new("--method", "method", method)));
        Ok(overrides)
    }
}
