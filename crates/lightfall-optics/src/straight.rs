//! Straight rays, which `effects.lensing = false` shows for comparison. Space is flat, with
//! Boyer-Lindquist r, theta, phi as its spherical coordinates, and the hole is a black ball that
//! ends at the horizon. The twin in WGSL is shaders/method/straight.wgsl.

use crate::disk;
use crate::shift::RestFrame;
use crate::trace::{Hit, Outcome, Trace};
use glam::DVec3;
use lightfall_model::geometry::kerr::{CircularOrbit, Kerr};
use lightfall_model::geometry::observer::Photon;
use std::f64::consts::FRAC_PI_2;

/// Follows the straight backward ray of `photon`, which is one of
/// [`CameraRays`](crate::camera_rays::CameraRays) without lensing, from radius `r` and the
/// place `n` on the celestial sphere. `annulus` holds the disk's inner and outer edge.
pub fn trace(kerr: Kerr, annulus: Option<[f64; 2]>, photon: &Photon, r: f64, n: DVec3) -> Trace {
    let start = r * n;
    let direction = (-photon.radial * n - photon.w).normalize();
    let along = start.dot(direction);
    let moment = start.cross(direction);
    // Half of the chord through the hole; NaN for a ray that misses it.
    let half_chord = (kerr.horizon().powi(2) - moment.length_squared()).sqrt();
    let captured = along < 0.0 && half_chord >= 0.0;
    let to_end = if captured {
        -along - half_chord
    } else {
        f64::INFINITY
    };
    let to_plane = -start.z / direction.z;
    let crossing =
        (to_plane > 0.0 && to_plane < to_end).then(|| (start + to_plane * direction).with_z(0.0));
    let hit = crossing
        .zip(annulus)
        .and_then(|(crossing, [inner, outer])| {
            let r = crossing.length();
            let orbit = (inner < r && r < outer)
                .then(|| kerr.circular_orbit(r))
                .flatten()?;
            let lambda = lambda(kerr, &orbit, r, moment.z);
            let g = disk::redshift(&orbit, photon.energy, photon.energy * lambda);
            Some(Hit {
                r,
                phi: crossing.y.atan2(crossing.x),
                g,
                delay: Some(to_plane),
            })
        });
    Trace {
        outcome: if captured {
            Outcome::Captured
        } else {
            Outcome::Sky
        },
        sky: (!captured).then_some(direction),
        hits: [hit, None],
        steps: 0,
        residual: 0.0,
    }
}

/// The lambda for which 1 - Omega lambda is the Doppler factor of matter on this orbit of radius
/// `r` (r_s), for a straight ray whose moment about the axis, per unit length of its direction, is
/// `moment_z`.
///
/// For the ZAMO the matter's speed is (Omega - omega) W / N, and the cosine of the angle between
/// its velocity and the light is -moment_z / r. Their product is Omega lambda.
pub fn lambda(kerr: Kerr, orbit: &CircularOrbit, r: f64, moment_z: f64) -> f64 {
    let rest = RestFrame::at(kerr, r, FRAC_PI_2);
    let speed = (orbit.angular_velocity - rest.dragging) * rest.width / rest.lapse;
    -moment_z / r * speed / orbit.angular_velocity
}
