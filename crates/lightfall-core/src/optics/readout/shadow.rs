//! The hole's shadow on an observer's sky: the directions from which no light of the outside can
//! arrive.

use crate::geometry::kerr::{Kerr, MASS};
use crate::geometry::observer::{ObserverMatrix, Photon};
use crate::geometry::schwarzschild::shadow_half_angle_rain;
use crate::geometry::sphere::{celestial_frame, polar_sin_cos};
use crate::geometry::tetrad::{four_velocity, rain_components, velocity_in_rain};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Below this spin the shadow's mean radius equals the one without spin to a relative 1e-8, since
/// it is an even function of the spin.
const NEGLIGIBLE_SPIN: f64 = 1e-4;

/// Number of points on the edge of a spinning hole's shadow; even. The radius then has a relative
/// error of 1e-6.
const POINTS: usize = 128;

/// An observer nearer to the axis than this, in radians, is treated as one at this angle.
const MIN_AXIS_ANGLE: f64 = 1e-6;

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
    let edge: Vec<DVec3> = edge_for_rain(kerr, r, theta, phi).collect();
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

/// The edge of the shadow for the observer `rain`, as directions on its axes. It is the light that
/// comes from the spherical photon orbits. At radius p these have, for M = E = 1 (Teo 2003),
///
/// lambda = (p^2 (3 - p) - a^2 (p + 1)) / (a (p - 1)),   Q = p^3 (4 a^2 - p (p - 3)^2) / (a^2 (p -
/// 1)^2),
///
/// and the light leaves them outward or inward: R(r) = (r - p)^2 (r^2 + 2 r p - a^2 Q/p^2) has a
/// double root at p.
fn edge_for_rain(kerr: Kerr, r: f64, theta: f64, phi: f64) -> impl Iterator<Item = DVec3> {
    let theta = theta.clamp(MIN_AXIS_ANGLE, PI - MIN_AXIS_ANGLE);
    let (sin, cos) = polar_sin_cos(theta);
    let [_, theta_hat, phi_hat] = celestial_frame(theta, phi);
    let (a, polar) = (kerr.spin, kerr.photon_orbit_polar() / MASS);
    // lambda, a^2 Q/p^2 and Theta = p_theta^2 at the observer, in units of M.
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
    let outermost_visible = move |end: f64| last_where(polar, end / MASS, |p| orbit(p).2 > 0.0);
    let (min_p, max_p) = (
        outermost_visible(kerr.photon_orbit_prograde()),
        outermost_visible(kerr.photon_orbit_retrograde()),
    );
    (0..POINTS).map(move |i| {
        // The half steps avoid the two ends, where Theta vanishes.
        let angle = TAU * (i as f64 + 0.5) / POINTS as f64;
        let p = 0.5 * (min_p + max_p) - 0.5 * (max_p - min_p) * angle.cos();
        let (lambda, rest, theta_potential) = orbit(p);
        let p_theta = theta_potential.max(0.0).sqrt().copysign(angle.sin());
        let ratio = r / MASS;
        let speed =
            (ratio - p) * (ratio * (ratio + 2.0 * p) - rest).max(0.0).sqrt() / (ratio * ratio);
        let w = (p_theta * theta_hat + lambda / sin * phi_hat) / ratio;
        let (frequency, momentum) = rain_components(
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

/// The point farthest from `inside` toward `end` where `holds` is true, given that it is true in
/// one interval that begins at `inside`.
fn last_where(mut inside: f64, mut end: f64, holds: impl Fn(f64) -> bool) -> f64 {
    // 64 bisections reach the last bit.
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
