//! The f64 reference for rays given by directions of the camera.

use glam::{DMat3, DVec3};
use lightfall_model::geometry::mino::PhotonConstants;
use lightfall_model::geometry::observer::{ObserverError, Photon};
use lightfall_model::geometry::sphere::angle_between;
use lightfall_model::scene::Scene;
use lightfall_optics::reference::Reference;
use lightfall_optics::trace::Trace;

/// The reference of a scene, with the camera's rotation. Directions are (right, up, forward).
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

    /// The reference's answer to the ray from a direction, with its photon changed by `change`, and
    /// the angle in radians between this ray and the one that has the changed photon. The radial
    /// momentum follows from the other constants, so that the photon remains null; `None` if it
    /// cannot be.
    pub(super) fn trace_changed(
        &self,
        direction: DVec3,
        change: impl Fn(&mut Photon),
    ) -> Option<(Trace, f64)> {
        let direction = self.tetrad_from_camera * direction;
        let mut photon = self.reference.photon(direction);
        change(&mut photon);
        let (r, n) = self.reference.camera();
        let kerr = self.reference.hole_and_disk().kerr;
        let (constants, start) = PhotonConstants::of_photon(kerr, &photon, r, n);
        let radial2 = constants.potential(start.u);
        if radial2.is_nan() || radial2 < 0.0 {
            return None;
        }
        photon.radial = radial2.sqrt().copysign(photon.radial);
        let turn = angle_between(direction, self.reference.direction_of(&photon)?);
        Some((self.reference.trace_photon(&photon), turn))
    }
}
