//! How far a flight moves what the picture shows.

use glam::{DMat3, DQuat};
use lightfall_core::scene::Scene;

/// By how much of its height the picture moves from one scene to the next, about: by the angle
/// through which the camera turns, and by how much the outermost things come nearer. The stars, whose
/// directions are fixed, move by the first, and the hole and its disk by both.
#[must_use]
pub fn picture_motion(before: &Scene, after: &Scene) -> f64 {
    let (from, to) = (&before.camera, &after.camera);
    let turn = DQuat::from_mat3(&(orientation(before).transpose() * orientation(after)));
    // The quaternion of a turn and its negative are the same turn.
    let turned = 2.0 * turn.xyz().length().atan2(turn.w.abs());
    let velocity = |axis: usize| after.observer.velocity[axis] - before.observer.velocity[axis];
    let boost = (0..3)
        .map(|axis| velocity(axis).powi(2))
        .sum::<f64>()
        .sqrt();
    let nearer = (to.r / from.r).ln().abs() + (to.fov_deg / from.fov_deg).ln().abs();
    (turned + boost) / to.fov_deg.to_radians() + 0.5 * nearer
}

/// The camera's axes in the hole's frame, as if space were flat.
fn orientation(scene: &Scene) -> DMat3 {
    scene.camera.tetrad() * scene.camera.tetrad_from_camera()
}
