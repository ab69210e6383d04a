//! The arguments of films and of lookup tables.

use super::SceneArgs;
use super::number::whole_number;
use clap::Args;
use lightfall_core::optics::lut::HDR_PEAKS;
use lightfall_picture::{Codec, frame_rate};
use std::path::PathBuf;

/// Least and most seconds of a loop: a day has more frames than a sequence.
const LOOP_SECONDS: [f64; 2] = [0.1, 86_400.0];

/// How a film is made.
#[derive(Clone, Debug, Default, PartialEq, Eq, Args)]
#[command(next_help_heading = "Film")]
pub struct FilmArgs {
    /// Codec of a film: h264 for every player (.mp4, .mov), hdr10 for HDR screens (.mp4, .mov), av1 for
    /// browsers (.webm, .mp4), prores for cutting (.mov) [default: h264 for .mp4, prores for .mov, av1 for .webm]
    #[arg(long, value_name = "h264|hdr10|av1|prores", value_parser = Codec::WORDS)]
    pub codec: Option<String>,
    /// The program ffmpeg, which encodes films [default: that of the variable LIGHTFALL_FFMPEG, or the first on PATH]
    #[arg(long, value_name = "FILE")]
    pub ffmpeg: Option<PathBuf>,
}

/// The arguments of `lightfall video`.
#[derive(Clone, Debug, Args)]
pub struct VideoArgs {
    /// Pictures of the film: numbered .png or .exr files without a gap, such as flight-####.png, in quotes;
    /// the names are those of `render`. Each .exr is developed as the preset in it says, without bloom
    #[arg(value_name = "PICTURES")]
    pub pictures: PathBuf,
    /// Film to write, a .mp4, .mov or .webm. An existing file is replaced
    #[arg(short, long = "out", value_name = "FILE")]
    pub out: PathBuf,
    /// Frames per second
    #[arg(long, value_name = "N", default_value_t = 30.0, value_parser = frame_rate, allow_negative_numbers = true)]
    pub fps: f64,
    /// How the film is made.
    #[command(flatten)]
    pub film: FilmArgs,
}

/// The arguments of `lightfall lut`.
#[derive(Clone, Debug, Args)]
pub struct LutArgs {
    /// Table to write: .csp for ffmpeg, which has to read the light with -gamma 4; .clf for OpenColorIO, and
    /// so for Nuke, Gaffer and Natron; .cube for DaVinci Resolve. It has the exposure and the tone curve of
    /// the scene, and no bloom
    #[arg(short, long = "out", value_name = "FILE")]
    pub out: PathBuf,
    /// Give the codes of HDR10 for a screen of this peak, in cd/m^2, in place of sRGB
    #[arg(long, value_name = "PEAK", allow_hyphen_values = true,
          value_parser = whole_number::<u32>(HDR_PEAKS[0].into(), HDR_PEAKS[1].into()))]
    pub hdr: Option<u32>,
    /// The scene.
    #[command(flatten)]
    pub scene: SceneArgs,
}

/// Reads the length of a loop, in seconds.
pub(super) fn loop_seconds(text: &str) -> Result<f64, String> {
    let [least, most] = LOOP_SECONDS;
    let seconds = text.parse().ok();
    seconds
        .filter(|seconds: &f64| (least..=most).contains(seconds))
        .ok_or_else(|| format!("it must be a number from {least} to {most}, in seconds"))
}
