//! The format of a journey's text: how long it may be, and what a keyframe may name.

use crate::scene::field::Field;
use crate::scene::fields::field;
use crate::scene::range::{Kind, Range};
use crate::scene::value::Value;

/// Maximum number of keyframes of a journey.
pub(super) const MAX_KEYFRAMES: usize = 1000;
/// Maximum duration of a journey, in seconds.
pub(super) const MAX_SECONDS: f64 = 86_400.0;

/// Maximum number of captions of a journey.
pub(super) const MAX_CAPTIONS: usize = 1000;
/// Maximum number of characters of a caption: two lines in large letters.
pub(super) const MAX_CAPTION_CHARS: usize = 160;
/// Maximum number of stops of a journey.
pub(super) const MAX_STOPS: usize = 200;
/// Maximum number of lines and of characters of a stop's caption: what a window of the usual size shows
/// beside the picture.
pub(super) const MAX_STOP_LINES: usize = 10;
pub(super) const MAX_STOP_CHARS: usize = 700;
/// How long a caption stays that does not say so, in seconds.
pub(super) const CAPTION_SECONDS: f64 = 6.0;

/// What a keyframe may have: its name there, and the key of the field that says what it may be.
/// The angles without a key may be of any number of turns here.
pub(super) const NAMES: [(&str, &str); 13] = [
    ("r", "camera.r"),
    ("theta_deg", "camera.theta_deg"),
    ("phi_deg", ""),
    ("yaw_deg", ""),
    ("pitch_deg", ""),
    ("roll_deg", ""),
    ("fov_deg", "camera.fov_deg"),
    ("observer", "observer.kind"),
    ("velocity", "observer.velocity"),
    ("disk_tilt_deg", "disk.tilt_deg"),
    ("disk_node_deg", ""),
    ("disk_rate", "disk.rate"),
    ("disk_time", "disk.time"),
];

/// What the table `rain` of a keyframe may not have: it is the same for every observer.
pub(super) const NOT_IN_RAIN: [&str; 7] = [
    "ease",
    "set",
    "observer",
    "disk_tilt_deg",
    "disk_node_deg",
    "disk_rate",
    "disk_time",
];

/// An angle of any number of turns, as a field that belongs to no scene.
const ANY_ANGLE: Field = Field::new(
    ("", Kind::Float(Range::FINITE), "of degrees", ""),
    |_| Value::Float(0.0),
    |_, _| false,
);

/// The field with this key; any angle for an empty one.
pub(super) fn field_like(key: &str) -> &'static Field {
    field(key).unwrap_or(&ANY_ANGLE)
}
