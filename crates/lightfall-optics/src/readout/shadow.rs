//! The hole's shadow on an observer's sky: the directions from which no light of the outside can
//! arrive.

use crate::critical_curve::{CriticalCurve, NEGLIGIBLE_SPIN};
use glam::DVec3;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::observer::ObserverMatrix;
use lightfall_model::geometry::schwarzschild::shadow_half_angle_rain;
use lightfall_model::geometry::sphere::angle_between;
use lightfall_model::geometry::tetrad::{four_velocity, velocity_in_rain};
use std::f64::consts::TAU;

/// Number of points on the edge of a spinning hole's shadow; even. The radius then has a relative
/// error of 1e-6.
const POINTS: usize = 128;

/// The hole's shadow on an observer's sky.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shadow {
    /// Unit vector toward its middle, on the axes of `rain` carried to the observer by a pure
    /// boost. With spin, the middle of the circle that is nearest to the edge for `rain`.
    pub middle: DVec3,
    /// Angular radius, in radians; see [`shadow_radius`].
    pub radius: f64,
}

/// The angular radius, in radians, of the hole's shadow for the observer with this matrix at (`r`,
/// `theta`, `phi`) (r_s, radians). Without spin the shadow is a circle for every observer; with
/// spin this is the radius of the circle with the same solid angle.
pub fn shadow_radius(kerr: Kerr, matrix: &ObserverMatrix, r: f64, theta: f64, phi: f64) -> f64 {
    shadow(kerr, matrix, r, theta, phi).radius
}

/// The hole's shadow for the observer with this matrix at (`r`, `theta`, `phi`) (r_s, radians).
pub fn shadow(kerr: Kerr, matrix: &ObserverMatrix, r: f64, theta: f64, phi: f64) -> Shadow {
    let velocity = velocity_in_rain(kerr, r, theta, phi, &four_velocity(matrix));
    if kerr.spin.abs() < NEGLIGIBLE_SPIN {
        return aberrated_circle(DVec3::NEG_X, shadow_half_angle_rain(r), velocity);
    }
    let curve = CriticalCurve::new(kerr, r, theta, phi);
    // The half steps avoid the two ends, where Theta vanishes.
    let angle = |i: usize| TAU * (i as f64 + 0.5) / POINTS as f64;
    let edge: Vec<DVec3> = (0..POINTS).map(|i| curve.at(angle(i))).collect();
    // The vector area does not depend on how the points are spread. For rain the shadow is smaller
    // than a hemisphere, so the edge's mean direction is inside and gives the sign.
    let mean = edge.iter().sum::<DVec3>() / edge.len() as f64;
    let sides = edge.iter().zip(edge.iter().cycle().skip(1));
    let vector_area: DVec3 = sides
        .map(|(&here, &next)| (here - mean).cross(next - mean))
        .sum();
    let middle_for_rain = (vector_area * vector_area.dot(mean).signum()).normalize();
    let angles = edge
        .iter()
        .map(|&point| angle_between(middle_for_rain, point));
    let radius_for_rain = angles.sum::<f64>() / edge.len() as f64;
    let middle = aberrated_circle(middle_for_rain, radius_for_rain, velocity).middle;
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
    let radius = 2.0 * (area / (2.0 * TAU)).min(1.0).sqrt().asin();
    Shadow { middle, radius }
}

/// The circle that a circle of radius `radius` about `middle` becomes for an observer moving with
/// `velocity` in the frame.
///
/// Rays on the circle satisfy s.(1, d) = 0 with s = (-cos(radius), middle). The boost transforms s
/// as a covector and leaves its square, sin^2(radius), unchanged; so (cos(radius), middle)
/// transforms as (1, d) does, and the new middle is along its last three components. Derived.
/// (Circles stay circles: Penrose 1959.)
fn aberrated_circle(middle: DVec3, radius: f64, velocity: DVec3) -> Shadow {
    let (sin, cos) = radius.sin_cos();
    let gamma = 1.0 / (1.0 - velocity.length_squared()).sqrt();
    let along = velocity.dot(middle);
    let middle = middle + gamma * (gamma / (gamma + 1.0) * along + cos) * velocity;
    Shadow {
        middle: middle.normalize(),
        radius: sin.atan2(gamma * (cos + along)),
    }
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
