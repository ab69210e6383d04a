//! Where something that flies the camera by itself has left it: so it notices whoever takes over.

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

    /// Whether nobody has touched them since. That the observer is of another kind is not the hand
    /// at the camera.
    pub(crate) fn left_alone(&self, scene: &Scene) -> bool {
        self.camera == scene.camera
    }

    /// Whether the camera is where it was, moving as it did, wherever it may look now.
    pub(crate) fn place_left_alone(&self, scene: &Scene) -> bool {
        let place = |camera: &Camera| (camera.r, camera.theta_deg, camera.phi_deg);
        place(&self.camera) == place(&scene.camera) && self.observer == scene.observer
    }
}
