//! The hole's shadow on an observer's sky: where no light from outside can come from.

use crate::geometry::kerr::{Kerr, MASS};
use crate::geometry::observer::{ObserverMatrix, Photon};
use crate::geometry::schwarzschild::shadow_half_angle_rain;
use crate::geometry::sphere::{celestial_frame, polar_sin_cos};
use crate::geometry::tetrad::{four_velocity, in_rain, velocity_in_rain};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Below this spin the shadow's mean radius is that without spin, to a relative 1e-8: it is even in
/// the spin.
const NO_SPIN: f64 = 1e-4;

/// Points on the edge of a spinning hole's shadow, an even number; the radius is right to 1e-6 of
/// itself.
const POINTS: usize = 128;

/// Nearer to the axis than this, in radians, the shadow is that of an observer so far from it.
const AXIS: f64 = 1e-6;

/// The angular radius, in radians, of the hole's shadow for the observer with this matrix at (`r`,
/// `theta`, `phi`) (r_s, radians): without spin of the circle that it is for every observer, with
/// spin of the circle that covers as much of the sky.
#[must_use]
pub fn shadow_radius(kerr: Kerr, matrix: &ObserverMatrix, r: f64, theta: f64, phi: f64) -> f64 {
    let velocity = velocity_in_rain(kerr, r, theta, phi, &four_velocity(matrix));
    if kerr.spin.abs() < NO_SPIN {
        return aberrated(shadow_half_angle_rain(r), velocity);
    }
    // Rain sees less than a hemisphere of it, so the edge's mean direction is inside.
    let edge: Vec<DVec3> = edge_for_rain(kerr, r, theta, phi).collect();
    let middle = seen_moving(edge.iter().sum::<DVec3>().normalize(), velocity);
    let edge: Vec<DVec3> = edge
        .into_iter()
        .map(|direction| seen_moving(direction, velocity))
        .collect();
    let polygon = |stride: usize| -> f64 {
        let corners = || edge.iter().step_by(stride);
        corners()
            .zip(corners().cycle().skip(1))
            .map(|(&here, &next)| solid_angle(middle, here, next))
            .sum()
    };
    // A polygon is too small by the square of its sides: Richardson's extrapolation.
    let area = ((4.0 * polygon(1) - polygon(2)) / 3.0).abs();
    // A cap of the radius alpha covers 4 pi sin^2(alpha/2).
    2.0 * (area / (2.0 * TAU)).min(1.0).sqrt().asin()
}

/// The radius, for an observer who moves with `velocity` in a frame, of what in that frame is a
/// circle of the radius `radius` about the inward direction.
///
/// Rays on the circle have s.(1, d) = 0 with s = (-cos(radius), inward); s is transformed as a
/// covector, and its square, sin^2(radius), stays. Derived. (That circles stay circles: Penrose
/// 1959.)
fn aberrated(radius: f64, velocity: DVec3) -> f64 {
    let (sin, cos) = radius.sin_cos();
    let gamma = 1.0 / (1.0 - velocity.length_squared()).sqrt();
    sin.atan2(gamma * (cos + velocity.dot(DVec3::NEG_X)))
}

/// The edge of the shadow for `rain`, as directions on her axes: light of the spherical photon
/// orbits, which at radius p have, for M = E = 1 (Teo 2003),
///
/// lambda = (p^2 (3 - p) - a^2 (p + 1)) / (a (p - 1)),   Q = p^3 (4 a^2 - p (p - 3)^2) / (a^2 (p -
/// 1)^2),
///
/// and have left them outward or inward: R(r) = (r - p)^2 (r^2 + 2 r p - a^2 Q/p^2), a double root
/// at p.
fn edge_for_rain(kerr: Kerr, r: f64, theta: f64, phi: f64) -> impl Iterator<Item = DVec3> {
    let theta = theta.clamp(AXIS, PI - AXIS);
    let (sin, cos) = polar_sin_cos(theta);
    let [_, theta_hat, phi_hat] = celestial_frame(theta, phi);
    let (a, polar) = (kerr.spin, kerr.photon_orbit_polar() / MASS);
    // Lambda, a^2 Q/p^2 and theta's velocity squared at the observer, in units of M.
    let orbit = move |p: f64| {
        let below = p - 1.0;
        let lambda = (p * p * (3.0 - p) - a * a * (p + 1.0)) / (a * below);
        let q = p.powi(3) * (4.0 * a * a - p * (p - 3.0).powi(2)) / (a * below).powi(2);
        (
            lambda,
            a * a * q / (p * p),
            q + (a * cos).powi(2) - (lambda * cos / sin).powi(2),
        )
    };
    let seen = move |end: f64| last_where(polar, end / MASS, |p| orbit(p).2 > 0.0);
    let (least, most) = (
        seen(kerr.photon_orbit_prograde()),
        seen(kerr.photon_orbit_retrograde()),
    );
    (0..POINTS).map(move |i| {
        // The half-steps keep clear of the two ends, where theta's velocity vanishes.
        let turn = TAU * (i as f64 + 0.5) / POINTS as f64;
        let p = 0.5 * (least + most) - 0.5 * (most - least) * turn.cos();
        let (lambda, rest, theta_velocity_squared) = orbit(p);
        let theta_velocity = theta_velocity_squared.max(0.0).sqrt().copysign(turn.sin());
        let ratio = r / MASS;
        let speed =
            (ratio - p) * (ratio * (ratio + 2.0 * p) - rest).max(0.0).sqrt() / (ratio * ratio);
        let w = (theta_velocity * theta_hat + lambda / sin * phi_hat) / ratio;
        let (frequency, momentum) = in_rain(
            kerr,
            r,
            theta,
            phi,
            &Photon {
                energy: 1.0,
                radial: speed,
                w,
            },
            0.0,
        );
        -momentum / frequency
    })
}

/// The point farthest from `inside` toward `end` where `holds` does, if it does so from `inside`
/// on.
fn last_where(mut inside: f64, mut end: f64, holds: impl Fn(f64) -> bool) -> f64 {
    // To the last bit.
    for _ in 0..64 {
        let middle = 0.5 * (inside + end);
        if holds(middle) {
            inside = middle
        } else {
            end = middle
        }
    }
    inside
}

/// The direction of a ray, which is `direction` in a frame, for who moves there with `velocity`.
/// Einstein 1905, section 7.
fn seen_moving(direction: DVec3, velocity: DVec3) -> DVec3 {
    let gamma = 1.0 / (1.0 - velocity.length_squared()).sqrt();
    let along = velocity.dot(direction);
    (direction + (gamma * gamma / (gamma + 1.0) * along + gamma) * velocity).normalize()
}

/// The oriented solid angle of a triangle of unit vectors, also of a tiny one: Van Oosterom &
/// Strackee 1983.
fn solid_angle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    2.0 * a
        .dot((b - a).cross(c - a))
        .atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}
