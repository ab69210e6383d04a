//! The arguments of `lightfall camera` and `lightfall captions`.

use super::args::SceneArgs;
use super::size::file_size;
use clap::Args;
use glam::UVec2;
use lightfall_picture::{Frames, frame_rate};
use std::path::PathBuf;

/// The arguments of `lightfall camera`.
#[derive(Clone, Debug, Args)]
pub struct CameraArgs {
    /// File to write: .csv is a table, which --journey reads; .usda is a camera in USD, which Blender and
    /// other programs import. An existing file is replaced
    #[arg(short, long = "out", value_name = "FILE")]
    pub out: PathBuf,
    /// Frames, as those of `lightfall render`: frame k is k/N seconds after the journey's start, from
    /// frame A to frame B inclusive
    #[arg(long, value_name = "A..B", allow_hyphen_values = true)]
    pub frames: Frames,
    /// Frames per second
    #[arg(long, value_name = "N", default_value_t = 30.0, value_parser = frame_rate, allow_negative_numbers = true)]
    pub fps: f64,
    /// Size of the pictures that the camera belongs to, in pixels: its shape is that of the camera's film
    /// [default: picture.width by picture.height]
    #[arg(long, value_name = "WxH", value_parser = file_size, allow_hyphen_values = true)]
    pub size: Option<UVec2>,
    /// TOML file of the journey, or CSV file of a camera path, or none: the camera stays [default: the
    /// built-in journey]
    #[arg(long, value_name = "FILE|none")]
    pub journey: Option<PathBuf>,
    /// The scene.
    #[command(flatten)]
    pub scene: SceneArgs,
}

/// The arguments of `lightfall captions`.
#[derive(Clone, Debug, Args)]
pub struct CaptionsArgs {
    /// Journey or lesson: its TOML file, or the name of a built-in lesson or of one of your own [default: the
    /// built-in journey]
    #[arg(value_name = "NAME|PATH")]
    pub journey: Option<PathBuf>,
    /// File to write: .srt for players and video programs, .vtt for browsers. An existing file is replaced
    #[arg(short, long = "out", value_name = "FILE")]
    pub out: PathBuf,
    /// Frames per second of the video: each caption appears and goes with a frame. Without it, at the
    /// millisecond that the journey says
    #[arg(long, value_name = "N", value_parser = frame_rate, allow_negative_numbers = true)]
    pub fps: Option<f64>,
}
