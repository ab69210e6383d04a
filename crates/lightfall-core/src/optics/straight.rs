//! Rays that nothing bends: what `effects.lensing = false` shows, for comparison. Space is flat,
//! with Boyer-Lindquist r, theta, phi as its spherical coordinates; the hole is the black ball
//! within the horizon.

use crate::geometry::kerr::Kerr;
use crate::geometry::observer::Photon;
use crate::optics::disk;
use crate::optics::shift::RestFrame;
use crate::optics::trace::{Hit, Outcome, Trace};
use glam::DVec3;

/// Follows the straight backward ray of `photon`, as [`CameraRays`](crate::optics::camera_rays::CameraRays) has it without
/// lensing, from the radius `r` in the direction `n`. `annulus` is the disk's inner and outer edge.
#[must_use]
pub fn trace(kerr: Kerr, annulus: Option<[f64; 2]>, photon: &Photon, r: f64, n: DVec3) -> Trace {
    let start = r * n;
    let direction = (-photon.radial * n - photon.w).normalize();
    let along = start.dot(direction);
    let moment = start.cross(direction);
    // Half of the chord through the hole; not a number for a ray that misses it.
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
            // The matter's speed for the observer at rest there is (Omega - omega) W / N, and the
            // light's direction along it is -moment_z / r: the lambda that makes 1 - Omega lambda
            // of it.
            let rest = RestFrame::at(kerr, r, 0.0);
            let speed = (orbit.angular_velocity - rest.dragging) * rest.width / rest.lapse;
            let lambda = -moment.z / r * speed / orbit.angular_velocity;
            let g = disk::redshift(&orbit, photon.energy, photon.energy * lambda);
            Some(Hit {
                r,
                phi: crossing.y.atan2(crossing.x),
                g,
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
