//! Angles and directions on the celestial sphere.

use glam::{DMat3, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// sin and cos of a polar angle in radians. At the doubles nearest to 0, pi/2 and pi the zero is
/// exact, so that a camera at 90 degrees lies in the disk's plane and not 6e-17 off it.
pub fn polar_sin_cos(theta: f64) -> (f64, f64) {
    if theta == FRAC_PI_2 {
        (1.0, 0.0)
    } else if theta == PI {
        (0.0, -1.0)
    } else {
        theta.sin_cos()
    }
}

/// The unit vector n toward (theta, phi) and the unit tangents theta_hat, phi_hat there, Cartesian
/// in the hole's frame. On the axis the tangents are the limits at constant phi, so phi_hat has the
/// azimuth phi + 90 degrees.
pub fn celestial_frame(theta: f64, phi: f64) -> [DVec3; 3] {
    let (sin, cos) = polar_sin_cos(theta);
    let (sin_phi, cos_phi) = phi.sin_cos();
    [
        DVec3::new(sin * cos_phi, sin * sin_phi, cos),
        DVec3::new(cos * cos_phi, cos * sin_phi, -sin),
        DVec3::new(-sin_phi, cos_phi, 0.0),
    ]
}

/// The vectors of [`celestial_frame`] as columns.
pub fn celestial_axes(theta: f64, phi: f64) -> DMat3 {
    let [n, theta_hat, phi_hat] = celestial_frame(theta, phi);
    DMat3::from_cols(n, theta_hat, phi_hat)
}

/// The same angle in (-pi, pi]; in radians.
pub fn wrap_angle(angle: f64) -> f64 {
    let angle = PI - (PI - angle).rem_euclid(TAU);
    if angle <= -PI { PI } else { angle }
}

/// The angle between two directions in radians, with full relative precision for small angles.
pub fn angle_between(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// The same angle between -180 and 180 degrees.
pub fn wrap_degrees(degrees: f64) -> f64 {
    degrees - 360.0 * (degrees / 360.0).round()
}

/// The same angle in degrees, with as many whole turns as bring it nearest to `other`.
pub fn nearest_turn(degrees: f64, other: f64) -> f64 {
    other + wrap_degrees(degrees - other)
}
