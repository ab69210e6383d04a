//! The hole's shadow on an observer's sky: the directions from which no light of the outside can
//! arrive.

use crate::geometry::kerr::Kerr;
use crate::geometry::observer::ObserverMatrix;
use crate::geometry::schwarzschild::shadow_half_angle_rain;
use crate::geometry::tetrad::{four_velocity, velocity_in_rain};
use crate::optics::critical_curve::{CriticalCurve, NEGLIGIBLE_SPIN};
use glam::DVec3;
use std::f64::consts::TAU;

/// Number of points on the edge of a spinning hole's shadow; even. The radius then has a relative
/// error of 1e-6.
const POINTS: usize = 128;

/// The angular radius, in radians, of the hole's shadow for the observer with this matrix at (`r`,
/// `theta`, `phi`) (r_s, radians). Without spin the shadow is a circle for every observer; with
/// spin this is the radius of the circle with the same solid angle.
#[must_use]
pub fn shadow_radius(kerr: Kerr, matrix: &ObserverMatrix, r: f64, theta: f64, phi: f64) -> f64 {
    let velocity = velocity_in_rain(kerr, r, theta, phi, &four_velocity(matrix));
    if kerr.spin.abs() < NEGLIGIBLE_SPIN {
        return aberrated_radius(shadow_half_angle_rain(r), velocity);
    }
    // For rain the shadow is smaller than a hemisphere, so the edge's mean direction is inside.
    let curve = CriticalCurve::new(kerr, r, theta, phi);
    // The half steps avoid the two ends, where Theta vanishes.
    let angle = |i: usize| TAU * (i as f64 + 0.5) / POINTS as f64;
    let edge: Vec<DVec3> = (0..POINTS).map(|i| curve.at(angle(i))).collect();
    let middle = aberrated_direction(edge.iter().sum::<DVec3>().normalize(), velocity);
    let edge: Vec<DVec3> = edge
        .into_iter()
        .map(|direction| aberrated_direction(direction, velocity))
        .collect();
    let polygon = |stride: usize| -> f64 {
        let corners = || edge.iter().step_by(stride);
        corners()
            .zip(corners().cycle().skip(1))
            .map(|(&here, &next)| solid_angle(middle, here, next))
            .sum()
    };
    // The polygon's area is too small by a term quadratic in its sides, which Richardson's
    // extrapolation removes.
    let area = ((4.0 * polygon(1) - polygon(2)) / 3.0).abs();
    // A cap of the angular radius alpha covers the solid angle 4 pi sin^2(alpha/2).
    2.0 * (area / (2.0 * TAU)).min(1.0).sqrt().asin()
}

/// The angular radius that a circle of radius `radius` about the inward direction has for an
/// observer moving with `velocity` in the frame.
///
/// Rays on the circle satisfy s.(1, d) = 0 with s = (-cos(radius), inward). The boost transforms s
/// as a covector and leaves its square, sin^2(radius), unchanged. Derived. (Circles stay circles:
/// Penrose 1959.)
fn aberrated_radius(radius: f64, velocity: DVec3) -> f64 {
    let (sin, cos) = radius.sin_cos();
    let gamma = 1.0 / (1.0 - velocity.length_squared()).sqrt();
    sin.atan2(gamma * (cos + velocity.dot(DVec3::NEG_X)))
}

/// Aberration: the direction that a ray with `direction` in a frame has for an observer moving
/// there with `velocity`. Einstein 1905, section 7.
fn aberrated_direction(direction: DVec3, velocity: DVec3) -> DVec3 {
    let gamma = 1.0 / (1.0 - velocity.length_squared()).sqrt();
    let along = velocity.dot(direction);
    (direction + (gamma * gamma / (gamma + 1.0) * along + gamma) * velocity).normalize()
}

/// The oriented solid angle of a triangle of unit vectors, accurate also for a tiny one. Van
/// Oosterom & Strackee 1983.
fn solid_angle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    2.0 * a
        .dot((b - a).cross(c - a))
        .atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}
