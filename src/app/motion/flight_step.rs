//! The result of one frame of a journey or free motion.

use lightfall_core::gpu::Drawable;

/// The result of one frame of a journey or of free motion.
#[derive(Clone, Debug, PartialEq)]
pub enum FlightStep {
    /// There is no flight, or something else has moved the camera, which ends the flight.
    Idle,
    /// The flight goes on with this scene.
    Moved(Box<Drawable>),
    /// The flight ends with this scene.
    Ended(Box<Drawable>),
    /// The flight cannot go on, for this reason.
    Refused(String),
}
