//! The guides as they would be seen if light were not bent: in flat space, with Boyer-Lindquist r,
//! theta, phi as spherical coordinates.

use super::outline::outline;
use super::sky::Sky;
use glam::DVec3;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::scene::Disk;
use std::f64::consts::TAU;

const POINTS: usize = 192;
/// Number of points at which a ray is compared with the ergosphere.
const SAMPLES: u32 = 96;

/// The outline of the sphere of radius `radius` (r_s) about the hole. `None` from within it.
pub(super) fn sphere(sky: &Sky, radius: f64) -> Option<Vec<DVec3>> {
    if sky.r <= radius {
        return None;
    }
    let (sin, cos) = (radius / sky.r).asin().sin_cos();
    let point = |angle: f64| DVec3::new(-cos, sin * angle.sin(), sin * angle.cos());
    Some(sky.curve_seen(angles().map(point)))
}

/// The circle of radius `radius` (r_s) in the disk's plane.
pub(super) fn orbit(sky: &Sky, disk: &Disk, radius: f64) -> Vec<DVec3> {
    let hole_from_disk = disk.hole_from_disk();
    let toward = |angle: f64| {
        let place = hole_from_disk * (radius * DVec3::new(angle.cos(), angle.sin(), 0.0));
        sky.axes.transpose() * (place - sky.r * sky.n)
    };
    sky.curve_seen(angles().map(|angle| toward(angle).normalize_or_zero()))
}

/// The outline of the ergosphere. `None` without spin, and from within it.
pub(super) fn ergosphere(sky: &Sky, kerr: Kerr) -> Option<Vec<DVec3>> {
    if kerr.spin == 0.0 || sky.r <= kerr.static_limit(sky.n.z) {
        return None;
    }
    // No part of the ergosphere is farther from the hole's centre than this.
    let reach = kerr.static_limit(0.0);
    let value = |direction: DVec3| {
        let ray = sky.axes * direction;
        let nearest = -sky.r * direction.x;
        if nearest <= 0.0 {
            return -1.0;
        }
        let depth = |i: u32| {
            let along = reach * (2.0 * f64::from(i) / f64::from(SAMPLES) - 1.0);
            let place = sky.r * sky.n + (nearest + along).max(0.0) * ray;
            let r = place.length();
            if r > 0.0 {
                (kerr.static_limit(place.z / r) / r - 1.0).min(1.0)
            } else {
                1.0
            }
        };
        (0..=SAMPLES).map(depth).fold(-1.0, f64::max)
    };
    outline(value).map(|curve| sky.curve_seen(curve))
}

fn angles() -> impl Iterator<Item = f64> {
    (0..POINTS).map(|i| TAU * i as f64 / POINTS as f64)
}
