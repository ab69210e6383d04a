//! The f64 reference, asked in directions of the camera.

use crate::geometry::observer::ObserverError;
use crate::optics::reference::Reference;
use crate::optics::trace::Trace;
use crate::scene::Scene;
use glam::{DMat3, DVec3};

/// The reference of a scene and how its camera is turned. Directions are (right, up, forward).
pub(super) struct CameraTracer {
    reference: Reference,
    pub(super) tetrad_from_camera: DMat3,
}

impl CameraTracer {
    /// The reference of a scene.
    ///
    /// # Errors
    /// If the scene's observer cannot exist.
    pub(super) fn new(scene: &Scene) -> Result<Self, ObserverError> {
        Ok(Self {
            reference: Reference::new(scene)?,
            tetrad_from_camera: scene.camera.tetrad_from_camera(),
        })
    }

    /// The reference's answer to the ray that arrives from a direction of the camera.
    pub(super) fn trace(&self, direction: DVec3) -> Trace {
        self.reference.trace(self.tetrad_from_camera * direction)
    }
}
