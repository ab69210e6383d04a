//! From a camera's position and axes back to the fields of a preset.

use super::Camera;
use glam::{DMat3, DVec3};

impl Camera {
    /// Puts the camera at `position` (hole's frame, r_s) with the axes right, up, forward in the
    /// columns of `world_from_camera`. The inverse of [`Camera::direction`], [`Camera::tetrad`] and
    /// [`Camera::heading`]. At the poles and looking straight up or down the angles are
    /// not unique, and any angles that give the same axes may result.
    pub fn set_pose(&mut self, position: DVec3, world_from_camera: DMat3) {
        self.r = position.length();
        self.theta_deg = position.truncate().length().atan2(position.z).to_degrees();
        // On the axis every azimuth is the same place: keeping the azimuth keeps the axes.
        if position.x != 0.0 || position.y != 0.0 {
            self.phi_deg = position.y.atan2(position.x).to_degrees();
        }
        self.set_orientation(self.tetrad().transpose() * world_from_camera);
    }

    /// Turns the camera so that its axes right, up, forward before the tilt, on the observer's axes,
    /// are these columns. The inverse of [`Camera::heading`].
    pub fn set_orientation(&mut self, heading: DMat3) {
        // In the axes of a camera that looks at the hole: right is growing phi, up is decreasing
        // theta.
        let level = |axis: DVec3| DVec3::new(axis.z, -axis.y, -axis.x);
        let (forward, up) = (level(heading.z_axis), level(heading.y_axis));
        let level_length = forward.x.hypot(forward.z);
        // Straight up or down the yaw is free: zero leaves the whole turn to the roll.
        let yaw = if level_length > 1e-12 {
            forward.x.atan2(forward.z)
        } else {
            0.0
        };
        let pitch = forward.y.atan2(level_length);
        let unrolled_right = DVec3::new(yaw.cos(), 0.0, -yaw.sin());
        let unrolled_up = DVec3::new(
            -pitch.sin() * yaw.sin(),
            pitch.cos(),
            -pitch.sin() * yaw.cos(),
        );
        let roll = up.dot(unrolled_right).atan2(up.dot(unrolled_up));
        self.yaw_deg = yaw.to_degrees();
        self.pitch_deg = pitch.to_degrees();
        self.roll_deg = roll.to_degrees();
    }
}
