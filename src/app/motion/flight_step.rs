//! The result of one frame of a journey or free motion.

use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Scene;

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

impl FlightStep {
    /// The step to this scene, where the flight ends or goes on.
    pub(super) fn to(scene: Scene, ends: bool) -> Self {
        match Drawable::new(scene) {
            Ok(scene) if ends => Self::Ended(Box::new(scene)),
            Ok(scene) => Self::Moved(Box::new(scene)),
            Err(reason) => Self::Refused(reason.to_string()),
        }
    }
}
