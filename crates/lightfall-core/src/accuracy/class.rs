//! The backward error of an answer of the wrong class: one with another outcome or another number
//! of hits.

use super::backward::turn_in_plane;
use super::chart::{Chart, sky_moved};
use super::near_edge::turn_near_edge;
use super::part::Part;
use super::ray::Ray;
use super::reference_camera::ReferenceCamera;
use crate::optics::trace::Trace;
use glam::{DVec2, DVec3};
use std::cell::Cell;
use std::f64::consts::TAU;

/// The directions of the search lie on rings about the ray: their number on each ring, the factor
/// between the radii, and the smallest and largest radius in radians.
const SPOKES: u32 = 8;
const RING_FACTOR: f64 = 3.0;
const MIN_RING_DISTANCE: f64 = 1e-10;
const MAX_RING_DISTANCE: f64 = 0.3;
const BISECTIONS: u32 = 8;
/// The factor between the turns that are tried along the edge.
const ALONG_FACTOR: f64 = 1.2;
/// Change of the sky direction, in radians, in one step along the line toward the edge: small
/// enough to find the narrow image of a thin disk.
const SKY_STEP: f64 = 0.01;

/// The smallest turn found, in radians, after which the reference gives the same outcome and number
/// of hits; infinite if there is none within 0.3 rad.
///
/// The search tries rings of directions and then bisects toward the ray, which is accurate to about
/// a third. If that finds nothing within `precision`, it goes along the line through the shadow's
/// edge, where the images of the disk are, on both sides of the edge, along the edge, and to the places
/// that explain the answer's own numbers.
pub(super) fn class_backward_error(
    camera: &ReferenceCamera,
    ray: &Ray,
    given: &Trace,
    precision: f64,
) -> f64 {
    let same = |trace: &Trace| trace.outcome == given.outcome && hits(trace) == hits(given);
    let nearest = Cell::new(on_rings(camera, ray.direction(), &same));
    let seen = |turn: f64, trace: &Trace| {
        if turn < nearest.get() && same(trace) {
            nearest.set(turn);
        }
    };
    let own = (nearest.get() > precision)
        .then(|| Chart::edge(&camera.with_edge(ray)))
        .flatten();
    let mirrored = own.as_ref().and_then(Chart::mirrored);
    for chart in own.iter().chain(&mirrored) {
        for side in [-1.0, 1.0] {
            for (x, trace) in chart.line(camera, side, nearest.get(), SKY_STEP, sky_moved) {
                seen(chart.turn(DVec2::new(x, 0.0)), &trace);
            }
            along_edge(camera, chart, side, &nearest, &seen);
        }
        for part in Part::all(given) {
            if nearest.get() > precision {
                turn_near_edge(camera, chart, part, [precision, f64::INFINITY], &seen);
            }
        }
    }
    // Far from an edge, or without one.
    for part in Part::all(given) {
        if nearest.get() > precision {
            turn_in_plane(camera, ray, part, camera.scale, &seen);
        }
    }
    nearest.get()
}

/// Tries the rays at the ray's own distance from the edge, along the edge to one side, until one is seen
/// or is farther than the nearest. Next to the edge the images of a ring are arcs that are much narrower
/// than the step between two spokes.
fn along_edge(
    camera: &ReferenceCamera,
    chart: &Chart,
    side: f64,
    nearest: &Cell<f64>,
    seen: &impl Fn(f64, &Trace),
) {
    let mut place = DVec2::new(0.0, side);
    let known = nearest.get();
    while nearest.get() == known {
        let turn = chart.turn(place);
        if turn >= known.min(MAX_RING_DISTANCE) {
            break;
        }
        seen(turn, &camera.trace(chart.at(place)));
        place *= ALONG_FACTOR;
    }
}

/// The same on rings about a direction only.
fn on_rings(camera: &ReferenceCamera, direction: DVec3, same: &impl Fn(&Trace) -> bool) -> f64 {
    let (u, v) = direction.any_orthonormal_pair();
    let same_toward = |spoke: u32, turn: f64| {
        let (sin, cos) = (TAU * f64::from(spoke) / f64::from(SPOKES)).sin_cos();
        same(&camera.trace(turn.cos() * direction + turn.sin() * (cos * u + sin * v)))
    };
    let mut ring = MIN_RING_DISTANCE;
    while ring < MAX_RING_DISTANCE {
        let bisected = |spoke: u32| {
            let mut bracket = [ring / RING_FACTOR, ring];
            for _ in 0..BISECTIONS {
                let middle = (bracket[0] * bracket[1]).sqrt();
                bracket[usize::from(same_toward(spoke, middle))] = middle;
            }
            bracket[1]
        };
        let nearest = (0..SPOKES)
            .filter(|spoke| same_toward(*spoke, ring))
            .map(bisected)
            .fold(f64::INFINITY, f64::min);
        if nearest.is_finite() {
            return nearest;
        }
        ring *= RING_FACTOR;
    }
    f64::INFINITY
}

/// The number of hits of an answer.
pub(super) fn hits(trace: &Trace) -> usize {
    trace.hits.iter().flatten().count()
}
