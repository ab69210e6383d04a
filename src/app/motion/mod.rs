//! What moves the camera: the hand, the guided journey, and the observer's own motion.

pub(crate) mod flight_step;
pub(crate) mod free_fall;
pub(crate) mod journey_player;
pub(crate) mod pilot;
pub(crate) mod steering;

/// Longest time, in seconds, that one frame moves the camera on. A slower frame moves it no
/// farther, so that slow machines stay steerable.
pub(crate) const MAX_FRAME_SECONDS: f64 = 0.25;
