//! How far a flight moves what the picture shows.

use glam::{DMat3, DQuat};
use lightfall_core::scene::{Camera, Observer, Scene};

/// Where a scene is seen from.
#[derive(Clone, Copy, Debug)]
pub struct ViewPoint {
    camera: Camera,
    observer: Observer,
}

impl From<&Scene> for ViewPoint {
    fn from(scene: &Scene) -> Self {
        Self {
            camera: scene.camera,
            observer: scene.observer,
        }
    }
}

/// The height of a picture of the whole sky, in degrees.
const WHOLE_SKY_DEG: f64 = 180.0;

impl ViewPoint {
    /// By how much of its height the picture moves on the way to another point, about: by the angle
    /// through which the camera turns, and by how much the outermost things come nearer. The stars,
    /// whose directions are fixed, move by the first, and the hole and its disk by both.
    #[must_use]
    pub fn picture_motion(&self, to: &Self) -> f64 {
        let turn = DQuat::from_mat3(&(self.orientation().transpose() * to.orientation()));
        // The quaternion of a turn and its negative are the same turn.
        let turned = 2.0 * turn.xyz().length().atan2(turn.w.abs());
        let velocity = |axis: usize| to.observer.velocity[axis] - self.observer.velocity[axis];
        let boost = (0..3)
            .map(|axis| velocity(axis).powi(2))
            .sum::<f64>()
            .sqrt();
        let (before, after) = (&self.camera, &to.camera);
        let [old_field, new_field] =
            [before, after].map(|camera| camera.field_deg().unwrap_or(WHOLE_SKY_DEG));
        let nearer = (after.r / before.r).ln().abs() + (new_field / old_field).ln().abs();
        (turned + boost) / new_field.to_radians() + 0.5 * nearer
    }

    /// The camera's axes in the hole's frame, as if space were flat.
    fn orientation(&self) -> DMat3 {
        self.camera.tetrad() * self.camera.tetrad_from_camera()
    }
}
