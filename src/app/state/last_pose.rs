//! Where a flight that steers itself has left the camera. A camera found elsewhere was moved by
//! something else.

use lightfall_core::scene::{Camera, Observer, Scene};

/// The camera and the observer as they were left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LastPose {
    camera: Camera,
    observer: Observer,
}

impl LastPose {
    pub(crate) fn new(scene: &Scene) -> Self {
        Self {
            camera: scene.camera,
            observer: scene.observer,
        }
    }

    /// Whether the camera is as it was left. Another kind of observer does not count as moving it.
    pub(crate) fn has_camera_of(&self, scene: &Scene) -> bool {
        self.camera == scene.camera
    }

    /// Whether the camera is at the place where it was left and moves as it did, wherever it looks.
    pub(crate) fn has_place_of(&self, scene: &Scene) -> bool {
        let place = |camera: &Camera| (camera.r, camera.theta_deg, camera.phi_deg);
        place(&self.camera) == place(&scene.camera) && self.observer == scene.observer
    }
}
