//! Where the camera is and how it moves, by which a motion notices that something else moves the camera.

use lightfall_core::scene::{Observer, Scene};

/// Where the camera is and how it moves, wherever it looks; and the hole's spin.
pub(super) type Pose = ([f64; 3], Observer, f64);

/// The pose of the scene's camera.
pub(super) fn pose_of(scene: &Scene) -> Pose {
    let camera = &scene.camera;
    let place = [camera.r, camera.theta_deg, camera.phi_deg];
    (place, scene.observer, scene.hole.spin)
}
