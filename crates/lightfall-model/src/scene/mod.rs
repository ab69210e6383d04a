//! The scene: the one description of what is drawn, written by the command line, presets and
//! controls, read by the passes. Plain data: no Bevy, no GPU types, no files.
//!
//! Lengths are in Schwarzschild radii, angles in degrees (suffix `_deg`), temperatures in kelvin.
//! The hole's frame is right-handed with z along the spin axis, which is the normal of a disk that
//! is not tilted; `r`, `theta_deg`, `phi_deg` are Boyer-Lindquist.
//!
//! `tables.rs` declares the fields, each with its meaning, type, default, range and unit.
//! Enumerations declare their words with their variants, and their properties as rows of a table.

mod camera;
pub mod camera_path;
mod changes;
mod cube;
mod disk_frame;
mod disk_motion;
mod edit;
mod error;
mod field;
mod fields;
mod fit;
mod frame;
mod from_toml;
mod hint;
mod idle;
mod idle_rules;
pub mod journey;
mod key_line;
mod light_sources;
mod limits;
mod load;
mod located;
mod matter;
mod method;
pub mod mission;
mod pose;
pub mod presets;
mod projection;
pub mod promises;
mod question;
mod range;
mod relevant;
mod save;
mod step_policy;
mod tables;
mod toml_fault;
mod tone_curve;
mod value;
mod view;

pub use crate::geometry::observer::ObserverKind;
pub use changes::Changes;
pub use cube::{CubeLayout, CubeSide};
pub use error::{Because, Refusal, SceneError, SceneFault};
pub use field::Field;
pub use fields::{FIELDS, field};
pub use fit::{drawn_at_once, fit, resized};
pub use frame::{Frame, Part};
pub use hint::nearest_name;
pub use idle::{Idle, Output};
pub use light_sources::{DiskModel, DiskStructure, HotSpotKind, LimbDarkening, SkyFrame, SkyMode};
pub use limits::MAX_PIXELS_PER_CELL;
pub use load::{Override, load};
pub use matter::THICKNESS_PIVOT;
pub use method::{AccuracySetting, Method, MethodProperties};
pub use projection::Projection;
pub use question::{JudgedAnswer, Question, typed_number};
pub use range::{Kind, MAX_TEXT_CHARS, Range};
pub use step_policy::ArticleQuality;
pub use tables::{
    Camera, Disk, Effects, Hole, HotSpot, Jet, Observer, Picture, Probe, Quality, Scene, Sky,
};
pub use toml_fault::TomlFault;
pub use tone_curve::ToneCurve;
pub use value::Value;
pub use view::{Content, Swatch, View, ViewProperties};

/// The version of the preset format this program reads and writes.
pub const SCHEMA: u32 = 1;

/// Maximum side of a picture, in pixels: WebGPU's default limit, which every device that the passes
/// run on supports.
pub const MAX_PICTURE_SIDE: u32 = 8192;

/// Maximum side of a picture file, in pixels. What is larger than [`MAX_PICTURE_SIDE`] is drawn in parts.
pub const MAX_FILE_SIDE: u32 = 32_768;

/// Maximum number of pixels of a picture file: that of a picture of the whole sky, twice as wide as high.
pub const MAX_FILE_PIXELS: u32 = MAX_FILE_SIDE * (MAX_FILE_SIDE / 2);

/// Maximum radius of a camera, in r_s.
pub const MAX_RADIUS: f64 = 1e7;

/// The article's own bound of a ray's steps: its budget at high quality, and the default.
pub const ARTICLE_MAX_STEPS: u32 = 768;

/// Maximum of `quality.max_steps`. Rays of so many steps in f32 are no more exact than those of
/// fewer (docs/ACCURACY.md), and one dispatch of single rays takes a third of the steps of a full
/// HD picture with [`ARTICLE_MAX_STEPS`].
pub const MAX_STEP_BUDGET: u32 = 16_384;
