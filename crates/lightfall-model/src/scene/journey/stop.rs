//! A stop of a lesson: a moment at which the journey waits, with what is said, asked and switched
//! there.

use crate::scene::field::Field;
use crate::scene::fields::field;
use crate::scene::{Question, Value};

/// A moment at which a journey waits in the window until somebody goes on. What it switches holds
/// until a later stop switches it again.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    /// When it is, in seconds after the journey's beginning.
    pub time: f64,
    /// The same as its file says it, on the clock of the keyframes.
    pub(super) at: f64,
    /// What is said, in one or more lines. Empty: nothing.
    pub caption: String,
    /// Fields of the scene and their values from here on.
    pub fields: Vec<(&'static str, Value)>,
    /// Whether the guides are shown from here on.
    pub guides: Option<bool>,
    /// Whether and how the scene is shown from here on beside what the stops before this one have led to.
    pub side_by_side: Option<SideBySide>,
    /// What the ray inspector shows from here on.
    pub inspector: Option<InspectorView>,
    /// What is asked.
    pub question: Option<Question>,
}

/// How a stop shows a scene beside another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SideBySide {
    /// Alone.
    Off,
    /// The other scene left of a divider.
    Divided,
    /// Each scene as a whole picture, the other one on the left.
    TwoPictures,
}

/// What the ray inspector shows at a stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InspectorView {
    /// It is closed.
    Closed,
    /// It is open, and shows the ray that it has shown before.
    Open,
    /// The ray at this place, as shares of the picture's width and height from its upper left
    /// corner.
    Place([f64; 2]),
    /// The ray that arrives from this direction on the observer's axes: outward, toward growing
    /// theta, toward growing phi; of any nonzero length.
    Toward([f64; 3]),
}

/// Fields that no stop may switch, although neither the camera nor the observer has them: keyframes
/// lead the disk's tilt and clock, the window sets the picture's size and look, and texts show
/// nothing.
const NOT_SWITCHED: [&str; 12] = [
    "schema",
    "name",
    "title",
    "disk.tilt_deg",
    "disk.node_deg",
    "disk.time",
    "disk.rate",
    "picture.width",
    "picture.height",
    "picture.grid_width",
    "picture.grid_height",
    "picture.bypass",
];

/// Whether stops may switch a field.
pub(super) fn is_switched(field: &Field) -> bool {
    let led = ["camera.", "observer."];
    !NOT_SWITCHED.contains(&field.key) && !led.iter().any(|table| field.key.starts_with(table))
}

/// Writes the value of a field, which was checked when the stop was read.
pub(super) fn write(scene: &mut crate::scene::Scene, (key, value): (&'static str, &Value)) {
    let written = field(key).map(|field| field.set(scene, value.clone()));
    debug_assert!(matches!(written, Some(Ok(()))), "{key} = {value}");
}
