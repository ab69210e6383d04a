//! Where the camera looks: its axes, in f64.

use super::{Camera, Scene};
use crate::geometry::observer::{ObserverError, ObserverKind, ObserverMatrix, observer_matrix};
use crate::geometry::sphere::celestial_axes;
use glam::{DMat3, DVec3};

impl Camera {
    /// Unit vector from the hole to the camera, toward Boyer-Lindquist theta and phi, in the hole's
    /// frame.
    pub fn direction(&self) -> DVec3 {
        self.tetrad().x_axis
    }

    /// The observer's axes as unit vectors of the hole's frame, one per column: outward, toward
    /// growing theta, toward growing phi. On the hole's axis the last one is the direction of
    /// azimuth `phi_deg` + 90 degrees.
    pub fn tetrad(&self) -> DMat3 {
        let [theta, phi] = self.polar_angles();
        celestial_axes(theta, phi)
    }

    /// The polar angle and the azimuth, in radians.
    pub fn polar_angles(&self) -> [f64; 2] {
        [self.theta_deg, self.phi_deg].map(f64::to_radians)
    }

    /// How far it is turned before the tilt: yaw, pitch and roll, in degrees.
    pub fn angles(&self) -> [f64; 3] {
        [self.yaw_deg, self.pitch_deg, self.roll_deg]
    }

    /// The camera's axes right, up, forward on the observer's axes (outward, theta, phi), one per
    /// column.
    ///
    /// Without turns the camera looks at the hole: forward is inward, up is decreasing theta, right
    /// is growing phi. It is turned about its own axes: to the right, then up, then clockwise as
    /// seen from behind it, and at last up by the tilt.
    pub fn tetrad_from_camera(&self) -> DMat3 {
        let [right, up, forward] = self.heading().to_cols_array_2d().map(DVec3::from_array);
        let (forward, up) = turn(sin_cos_deg(self.tilt_deg), forward, up);
        DMat3::from_cols(right, up, forward)
    }

    /// The axes right, up, forward before the tilt: those of the camera's flight, which the tilt of
    /// its picture leaves as they are.
    pub fn heading(&self) -> DMat3 {
        let [yaw, pitch, roll] = [self.yaw_deg, self.pitch_deg, self.roll_deg].map(sin_cos_deg);
        let [right, up, forward] = [DVec3::Z, -DVec3::Y, -DVec3::X];
        let (forward, right) = turn(yaw, forward, right);
        let (forward, up) = turn(pitch, forward, up);
        let (up, right) = turn(roll, up, right);
        DMat3::from_cols(right, up, forward)
    }
}

/// Two axes, turned from the first toward the second by the angle with this sine and cosine.
fn turn((sin, cos): (f64, f64), first: DVec3, second: DVec3) -> (DVec3, DVec3) {
    (cos * first + sin * second, cos * second - sin * first)
}

impl Scene {
    /// The matrix of an observer at the camera's place, of this kind and with this `velocity`, as
    /// [`observer_matrix`] has it.
    ///
    /// # Errors
    /// There is no such observer.
    pub fn observer_at_camera(
        &self,
        kind: ObserverKind,
        velocity: [f64; 3],
    ) -> Result<ObserverMatrix, ObserverError> {
        let [theta, phi] = self.camera.polar_angles();
        observer_matrix(self.hole.spin, kind, velocity, self.camera.r, theta, phi)
    }
}

/// Sine and cosine of an angle in degrees, exact at multiples of 90, so that a camera without turns
/// looks exactly at the hole's centre.
pub(super) fn sin_cos_deg(degrees: f64) -> (f64, f64) {
    let quarters = (degrees / 90.0).round();
    let (sin, cos) = (degrees - 90.0 * quarters).to_radians().sin_cos();
    match quarters.rem_euclid(4.0) {
        0.0 => (sin, cos),
        1.0 => (cos, -sin),
        2.0 => (-sin, -cos),
        _ => (-cos, sin),
    }
}
