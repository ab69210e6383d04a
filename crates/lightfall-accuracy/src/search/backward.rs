//! The backward error: the smallest turn t of a ray for which the reference's answer differs from
//! the method's by at most t.

use super::chart::Chart;
use super::near_edge::turn_near_edge;
use super::newton::{MIN_DAMPING, newton};
use super::part::{Part, miss_on_chart};
use crate::answer::greater;
use crate::ray::Ray;
use crate::reference_camera::ReferenceCamera;
use glam::{DVec2, DVec3};
use lightfall_optics::trace::Trace;

/// The search goes on at the edge of the shadow if the backward error found so far is larger than
/// `MIN_WORTH` and, in addition, larger than `LARGE` or smaller than the forward error by the
/// factor `AMPLIFIED`. `MIN_WORTH` and `LARGE` are in radians.
const MIN_WORTH: f64 = 1e-6;
const AMPLIFIED: f64 = 30.0;
const LARGE: f64 = 0.01;
/// Scales of the search in the tangent plane, as shares of the camera's own. For a camera next to
/// the disk's plane, hits move by their radius within millionths of a radian, so a search that
/// finds no small turn is repeated on finer scales.
pub(super) const PLANE_SCALES: [f64; 3] = [1.0, 1e-2, 1e-4];

/// The backward error, in radians, of an answer of the right class: the largest of the turns that
/// explain its parts.
///
/// A forward error below `precision` bounds a part's turn without a search.
pub(crate) fn backward_error(
    camera: &ReferenceCamera,
    ray: &Ray,
    truth: &Trace,
    given: &Trace,
    precision: f64,
) -> f64 {
    Part::all(given).fold(0.0, |most, part| {
        let forward = part.miss(truth).map_or(f64::INFINITY, DVec2::length);
        greater(
            most,
            if forward < precision {
                forward
            } else {
                explaining_turn(camera, ray, (part, forward), precision)
            },
        )
    })
}

/// The smallest angle found such that turning the ray by at most this angle leaves a miss of at
/// most this angle. Infinite if no ray nearby has this part at all.
///
/// This is the mixed forward-backward error (Higham 2002, section 1.5): nearly the right answer to
/// nearly the right question. Behind the hole whole rings of rays are focused onto points, and near
/// these no turn explains the last digit of an answer. Elsewhere the angle is within a factor of
/// two of the turn that explains the answer. Every ray that is tried gives an upper bound, so a
/// failing search can only overstate the error. A bound below `precision` ends the search.
/// `forward` is the part's miss by the true answer.
pub(super) fn explaining_turn(
    camera: &ReferenceCamera,
    ray: &Ray,
    (part, forward): (Part, f64),
    precision: f64,
) -> f64 {
    let in_plane = |share: f64| {
        let scale = share * camera.scale;
        turn_in_plane(camera, ray, part, (scale, ray.direction()), &|_, _| {})
    };
    let mut least = f64::INFINITY;
    for share in PLANE_SCALES {
        if least > precision.max(MIN_WORTH) {
            least = least.min(in_plane(share));
        }
    }
    // Finding the edge is expensive, and helps only where a small turn changes the answer much.
    let amplified = least > MIN_WORTH && (forward > AMPLIFIED * least || least > LARGE);
    let ray = if amplified && least > precision {
        camera.with_edge(ray)
    } else {
        *ray
    };
    match Chart::edge(&ray) {
        Some(chart) if least > precision => {
            turn_near_edge(camera, &chart, part, [precision, least], &|_, _| {})
        }
        _ => least,
    }
}

/// The bound that Newton's method finds in the tangent plane, starting at the direction `from`,
/// with finite differences on a scale in radians. `visit` is called with each direction and its
/// answer.
pub(super) fn turn_in_plane(
    camera: &ReferenceCamera,
    ray: &Ray,
    part: Part,
    (scale, from): (f64, DVec3),
    visit: &dyn Fn(DVec3, &Trace),
) -> f64 {
    let plane = Chart::plane(ray, scale);
    let at = miss_on_chart(camera, &plane, part, visit);
    let start = plane.place_of(from).unwrap_or_default();
    newton(&plane, &at, start, MIN_DAMPING)
}
