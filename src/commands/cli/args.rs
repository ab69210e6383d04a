//! The arguments of flying, of `lightfall render`, `trace` and `presets`, and of scenes.

use super::farm::FarmArgs;
use super::film::{FilmArgs, loop_seconds};
use super::size::file_size;
use clap::{Args, Subcommand, ValueEnum};
use glam::UVec2;
use lightfall_core::scene::{ArticleQuality, Field, Override, SceneError, SkyMode, field};
use lightfall_picture::{
    CHANNELS, ChannelNames, Channels, ExrCompression, FrameList, MissingValues, PngBits,
    Transparent, frame_rate, shutter_time,
};
use std::ffi::OsString;
use std::path::PathBuf;

/// The choice of the graphics adapter, for every command.
#[derive(Clone, Debug, Default, PartialEq, Eq, Args)]
#[command(next_help_heading = "Graphics adapter")]
pub struct GpuArgs {
    /// Use this adapter: its number in --list-gpus, its PCI bus id, or a part of its name; the same as
    /// WGPU_ADAPTER_NAME
    #[arg(long, value_name = "N|BUS|NAME", global = true)]
    pub gpu: Option<String>,
    /// Use this graphics interface; the same as WGPU_BACKEND
    #[arg(long, value_name = "NAME", global = true, value_parser = ["vulkan", "metal", "dx12"])]
    pub backend: Option<String>,
    /// List the adapters and exit
    #[arg(long)]
    pub list_gpus: bool,
}

/// The choice of the scene: a preset and overrides of its fields.
#[derive(Clone, Debug, Default, PartialEq, Eq, Args)]
#[command(next_help_heading = "Scene")]
pub struct SceneArgs {
    /// Preset to start from: a number or name (see `lightfall presets list`), a TOML file, or a
    /// picture drawn from one; without a command also a mission or a lesson, by its name or file [default: 2]
    #[arg(long, value_name = "N|NAME|PATH")]
    pub preset: Option<OsString>,
    /// Set one field of the preset, such as camera.r=20; may be repeated, and the last value counts
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub sets: Vec<String>,
    /// Short for --set hole.spin=CHI, applied after every --set
    #[arg(long, value_name = "CHI", allow_hyphen_values = true)]
    pub spin: Option<String>,
    /// Short for --set method=METHOD, after all --set
    #[arg(long, help = format!("Short for --set method=METHOD, applied after every --set; {}. reference is for `trace --device cpu` only",
                               field("method").map(Field::allowed).unwrap_or_default()))]
    pub method: Option<String>,
    /// Steps of verlet and kerr-schild as in the article: cheap, balanced or high; short for --set
    /// quality.step_scale=1.55, 0.85 or 0.45 and --set quality.max_steps=128, 256 or 768, applied
    /// after every --set
    #[arg(long, value_name = "cheap|balanced|high", value_parser = ArticleQuality::WORDS)]
    pub quality: Option<String>,
    /// Average N frames, each with its rays at other places in their pixels; short for --set
    /// picture.samples=N, applied after every --set
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub samples: Option<String>,
    /// Show the picture in large cells, or pixel by pixel; short for --set picture.bypass=false or
    /// true, applied after every --set
    #[arg(long, value_name = "on|off", value_enum, hide_possible_values = true)]
    pub cells: Option<Cells>,
    /// Draw for a dome: a fisheye of 180 degrees that looks 60 degrees above the hole, without cells;
    /// short for --set camera.projection=fisheye, camera.fisheye_deg=180, camera.tilt_deg=60 and
    /// picture.bypass=true, applied before every --set. `render` draws a square
    #[arg(long)]
    pub dome: bool,
    /// CSV file of stars in place of the built-in catalogue, a line ra_deg,dec_deg,v_mag,b_v,name for
    /// each: J2000, in degrees; the last two may be missing. A first line of column names may give
    /// them in another order, and those of the HYG database and of Gaia's archive are known
    #[arg(long, value_name = "FILE")]
    pub stars: Option<PathBuf>,
    /// Picture of the whole sky, twice as wide as high, in EXR, HDR, PNG or JPEG: short for --set
    /// sky.mode=picture and sky.picture=FILE, applied after every --set
    #[arg(long, value_name = "FILE")]
    pub sky: Option<String>,
}

/// What `--dome` sets: a dome master whose hole is 30 degrees above the front of the spring line.
const DOME: [(&str, &str); 4] = [
    ("camera.projection", "fisheye"),
    ("camera.fisheye_deg", "180"),
    ("camera.tilt_deg", "60"),
    ("picture.bypass", "true"),
];

/// Whether the picture is shown in cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Cells {
    /// In large cells: the pixel look
    On,
    /// Pixel by pixel
    Off,
}

/// The arguments of `lightfall` without a command.
#[derive(Clone, Debug, Default, PartialEq, Eq, Args)]
pub struct FlyArgs {
    /// The scene.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Fly a guided journey at once, from a TOML file of keyframes, or a camera path in CSV;
    /// assets/journeys/default.toml of the source code is an example, and the journey that J flies by default
    #[arg(long, value_name = "FILE", help_heading = "Scene")]
    pub journey: Option<PathBuf>,
    /// Draw with the WGSL files of a folder, such as shaders of the source code, and read them again whenever one of
    /// them changes, for work on the shaders
    #[arg(long, value_name = "FOLDER")]
    pub shaders: Option<PathBuf>,
    /// Open the window over the whole screen
    #[arg(long)]
    pub fullscreen: bool,
    /// Open the window on this monitor; monitors are counted from 1 from the left
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..))]
    pub monitor: Option<u8>,
    /// Fly journeys in a loop over the whole screen, for visitors, who can fly, but neither close the window
    /// nor write a file. Journeys are names or files; without any, the guided journey and `layers` are flown.
    /// Ctrl+Shift+Q, held for three seconds, ends it
    #[arg(long, value_name = "JOURNEY", num_args = 0.., help_heading = "Exhibition")]
    pub kiosk: Option<Vec<PathBuf>>,
    /// With --kiosk: go back to the start when a visitor has done nothing for so many seconds [default: 60]
    #[arg(long, value_name = "SECONDS", value_parser = clap::value_parser!(u16).range(5..=3600),
          help_heading = "Exhibition")]
    pub idle: Option<u16>,
    /// With --kiosk: the loudness of what a ship's pilot hears, from 0 to 100 [default: 0]
    #[arg(long, value_name = "PERCENT", value_parser = clap::value_parser!(u8).range(0..=100),
          help_heading = "Exhibition")]
    pub volume: Option<u8>,
}

impl FlyArgs {
    /// The first given option that is for a window alone, other than those of the scene and the journey.
    pub(super) fn window_option(&self) -> Option<&'static str> {
        let options = [
            ("--shaders", self.shaders.is_some()),
            ("--fullscreen", self.fullscreen),
            ("--monitor", self.monitor.is_some()),
            ("--kiosk", self.kiosk.is_some()),
            ("--idle", self.idle.is_some()),
            ("--volume", self.volume.is_some()),
        ];
        first_given(options)
    }
}

/// The first of several options that is given.
pub(in crate::commands) fn first_given<T>(
    options: impl IntoIterator<Item = (T, bool)>,
) -> Option<T> {
    let given = options.into_iter().find(|(_, is_given)| *is_given);
    given.map(|(option, _)| option)
}

/// The arguments of `lightfall render`.
#[derive(Clone, Debug, Args)]
#[command(after_help = about_pictures())]
pub struct RenderArgs {
    /// Picture to write. Its extension decides the format: .png is what a window would show, .apng
    /// the same with all frames of a sequence, .mp4, .mov and .webm are films of them, .exr holds linear
    /// light and the data of rays. An existing file is replaced
    #[arg(short, long = "out", value_name = "FILE")]
    pub out: PathBuf,
    /// Size of the picture in pixels, up to 32768 a side and 32768x16384 in all: short for --set
    /// picture.width and picture.height. A .png of up to 8192 a side keeps its large cells, about picture.grid_height rows
    /// of them; --cells off shows every pixel [default: picture.width by picture.height]
    #[arg(long, value_name = "WxH", value_parser = file_size, allow_hyphen_values = true)]
    pub size: Option<UVec2>,
    /// Bits of each channel of a .png. Sixteen are for further work on the picture, and show every pixel,
    /// without cells [default: 8]
    #[arg(long, value_name = "8|16", value_parser = PngBits::WORDS)]
    pub bits: Option<String>,
    /// Channels of an .exr in addition to R, G, B and A, separated by commas: `all`, groups, or
    /// single channels, see below
    #[arg(long, value_name = "LIST")]
    pub aov: Option<Channels>,
    /// Names of the channels in the file: layers, or those of version 0.1, such as hit1.r
    #[arg(long, value_name = "layers|0.1", requires = "aov", default_value = ChannelNames::Layers.word(),
          value_parser = ChannelNames::WORDS)]
    pub aov_names: String,
    /// What stands in these channels where a ray has no number: keep writes NaN, zero writes 0
    #[arg(long, value_name = "keep|zero", requires = "aov", value_parser = MissingValues::WORDS)]
    pub nan: Option<String>,
    /// Add the layers of the light to an .exr, see below: each is drawn as a picture of its own
    #[arg(long)]
    pub layers: bool,
    /// Make the sky or the hole transparent, for a background of your own. In an .exr A is then the share
    /// of the rest, and R, G and B are its light; a .png shows every pixel, without cells
    #[arg(long, value_name = "sky|hole", value_parser = Transparent::WORDS)]
    pub alpha: Option<String>,
    /// Compression of an .exr: zip has 16 rows in a block and zips has one; piz suits noisy light, rle is
    /// quick, none is none. All of them keep every bit [default: zip]
    #[arg(long, value_name = "zip|zips|piz|rle|none", value_parser = ExrCompression::WORDS)]
    pub exr: Option<String>,
    /// Draw a journey as numbered pictures: frame k shows it k/N seconds after its start, from
    /// frame A to frame B inclusive; an .apng holds all of them. Frames after the end show the end.
    /// The clock of a disk that moves runs by disk.rate a second, from disk.time in frame 0. A list
    /// has commas, and A..B:S takes every S-th frame, as in 0..9,20,30..300:10
    #[arg(
        long,
        value_name = "A..B",
        allow_hyphen_values = true,
        group = "moments"
    )]
    pub frames: Option<FrameList>,
    /// Draw a sequence of this length whose end goes on at its beginning, with a camera that stays. The
    /// structure of the disk repeats after this time; where nothing moves, the camera goes once around
    #[arg(long = "loop", value_name = "SECONDS", value_parser = loop_seconds, allow_negative_numbers = true,
          group = "moments")]
    pub loop_seconds: Option<f64>,
    /// Frames per second
    #[arg(long, value_name = "N", default_value_t = 30.0, value_parser = frame_rate, requires = "moments",
          allow_negative_numbers = true)]
    pub fps: f64,
    /// Blur what moves: the mean of the light while a shutter is open, from the moment of the frame on,
    /// for this share of the time to the next one (0.5 is a film camera's 180 degrees), at --samples
    /// moments, or at 16
    #[arg(long, value_name = "SHARE", value_parser = shutter_time, requires = "moments",
          allow_negative_numbers = true)]
    pub shutter: Option<f64>,
    /// TOML file of the journey that --frames draws, or CSV file of a camera path, or none: the camera
    /// stays, and only the disk moves [default: the built-in journey]
    #[arg(long, value_name = "FILE|none")]
    pub journey: Option<PathBuf>,
    /// Also write the camera's path to this file, .csv or .usda; may be repeated. `lightfall camera` writes
    /// it without drawing
    #[arg(long, value_name = "FILE", requires = "frames")]
    pub camera: Vec<PathBuf>,
    /// Also print the GPU time of each pass to standard error, and with =FILE write them to this CSV
    /// file
    #[arg(long, value_name = "FILE", conflicts_with = "moments", num_args = 0..=1, require_equals = true)]
    pub timings: Option<Option<PathBuf>>,
    /// The part of a sequence that this process draws.
    #[command(flatten)]
    pub farm: FarmArgs,
    /// The film, if the file is one.
    #[command(flatten)]
    pub film: FilmArgs,
    /// The scene.
    #[command(flatten)]
    pub scene: SceneArgs,
}

/// The text below the help of `lightfall render`.
fn about_pictures() -> String {
    let channels = CHANNELS
        .map(|channel| {
            format!(
                "  {:21} {:14} {}\n",
                channel.name, channel.old_name, channel.about
            )
        })
        .concat();
    format!(
        "Channels (--aov) of the ray through each pixel's centre, regardless of the foreground. Missing values are NaN, or 0 with --nan zero. Groups \
         are sky, hit1, hit2 and medium; all means those of medium where the scene has matter with depth. The second name is that of version 0.1, and means the same channel:\n{channels}\n\
         Layers (--layers), each with R, G, B and its share of the pixel as A: light_sky, light_stars, light_hit1 and light_hit2 (the \
         crossings of the disk), light_volume (matter with depth) and light_probe, as far as the scene has them. Their light adds up to that \
         of the picture. cover_hole.Y is the share of the hole, and all shares add up to 1.\n\n\
         Names of a sequence: the last run of # is replaced by the frame's number with at least as many digits, as in fall-####.png; fall.png \
         gives fall-0000.png, fall-0001.png and so on. Frames have the scene's exposure; where that is automatic, each frame is \
         metered. At the end, a command line that makes a video is printed.\n\n\
         Every picture holds the preset that drew it: `--preset picture.png` and `--preset picture.exr` read it."
    )
}

/// The arguments of `lightfall trace`.
#[derive(Debug, Args)]
pub struct TraceArgs {
    /// File of the rays to trace, or - for standard input; a wrong line stops the command before any
    /// ray is traced
    #[arg(long, value_name = "FILE|-")]
    pub rays: PathBuf,
    /// Device that traces the rays
    #[arg(long, value_enum, default_value_t = Device::Gpu)]
    pub device: Device,
    /// Add columns with numbers of each ray by the f64 reference: impact parameter, lambda and eta (in
    /// r_s), deflection (radians), half-turns about the hole, closest r, and g of the sky's light
    #[arg(long)]
    pub numbers: bool,
    /// The scene.
    #[command(flatten)]
    pub scene: SceneArgs,
}

/// The device that traces rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Device {
    /// The shaders that draw the pictures
    Gpu,
    /// The f64 reference
    Cpu,
}

/// The commands of `lightfall presets`.
#[derive(Debug, Subcommand)]
pub enum PresetsCommand {
    /// List the built-in presets and the user's own
    List,
    /// Show every field of a preset, with its meaning and range, as a preset file
    Show {
        /// Number, name, TOML file, or a picture that Lightfall drew
        #[arg(value_name = "NAME")]
        preset: OsString,
        /// Set one field of the preset, such as camera.r=20; may be repeated, and the last value counts
        #[arg(long = "set", value_name = "KEY=VALUE")]
        sets: Vec<String>,
        /// Show instead which shader parts and passes it needs, and which it leaves out
        #[arg(long)]
        needs: bool,
    },
    /// Check a preset, a mission, or a journey or lesson
    Check {
        /// Number or name of a preset, name of a mission or of a lesson, a TOML file of one of them, or a picture that
        /// Lightfall drew
        #[arg(value_name = "N|NAME|PATH")]
        preset: OsString,
    },
}

/// The overrides of `--set` options.
///
/// # Errors
/// One that is not of the form KEY=VALUE.
pub fn assignments(sets: &[String]) -> Result<Vec<Override>, SceneError> {
    sets.iter().map(|set| Override::assignment(set)).collect()
}

impl SceneArgs {
    /// These options followed by others. `None` if both give an option that may be given once.
    pub(super) fn followed_by(&self, after: &Self) -> Option<Self> {
        fn one<T: Clone>(a: &Option<T>, b: &Option<T>) -> Option<Option<T>> {
            (a.is_none() || b.is_none()).then(|| a.clone().or_else(|| b.clone()))
        }
        Some(Self {
            preset: one(&self.preset, &after.preset)?,
            sets: [&self.sets[..], &after.sets[..]].concat(),
            spin: one(&self.spin, &after.spin)?,
            method: one(&self.method, &after.method)?,
            quality: one(&self.quality, &after.quality)?,
            samples: one(&self.samples, &after.samples)?,
            cells: one(&self.cells, &after.cells)?,
            dome: self.dome || after.dome,
            stars: one(&self.stars, &after.stars)?,
            sky: one(&self.sky, &after.sky)?,
        })
    }

    /// The overrides of these options, in the order in which they apply.
    ///
    /// # Errors
    /// A `--set` that is not of the form KEY=VALUE.
    pub fn overrides(&self) -> Result<Vec<Override>, SceneError> {
        let dome = DOME.iter().filter(|_| self.dome);
        let dome = dome.map(|(key, value)| Override::new("--dome", key, value));
        let mut overrides: Vec<_> = dome.collect();
        overrides.extend(assignments(&self.sets)?);
        let quality = self.quality.as_deref().and_then(ArticleQuality::from_word);
        let bypass = self.cells.map(|cells| cells == Cells::Off);
        let short = [
            ("--spin", "hole.spin", self.spin.clone()),
            ("--method", "method", self.method.clone()),
            (
                "--quality",
                "quality.step_scale",
                quality.map(|named| named.step_scale().to_string()),
            ),
            (
                "--quality",
                "quality.max_steps",
                quality.map(|named| named.max_steps().to_string()),
            ),
            ("--samples", "picture.samples", self.samples.clone()),
            ("--cells", "picture.bypass", bypass.map(|on| on.to_string())),
            (
                "--sky",
                "sky.mode",
                self.sky.as_ref().map(|_| SkyMode::Picture.word().into()),
            ),
            ("--sky", "sky.picture", self.sky.clone()),
        ];
        let given = short
            .iter()
            .filter_map(|(option, key, value)| Some(Override::new(option, key, value.as_ref()?)));
        overrides.extend(given);
        Ok(overrides)
    }

    /// Whether these options set the field with this key.
    ///
    /// # Errors
    /// As [`overrides`](Self::overrides).
    pub fn sets(&self, key: &str) -> Result<bool, SceneError> {
        Ok(self.overrides()?.iter().any(|set| set.key == key))
    }
}
