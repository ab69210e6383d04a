pub(crate) mod free_fall;
pub(crate) mod journey_player;
pub(crate) mod pilot;

/// Smallest radius that flying reaches from outside, in r_s. A static observer there is still an
/// ordinary place.
pub(crate) const MIN_FLIGHT_RADIUS: f64 = 1.08;

/// Longest time, in seconds, that one frame moves the camera on. A slower frame moves it no
/// farther, so that slow machines stay steerable.
pub(crate) const MAX_FRAME_SECONDS: f64 = 0.25;
