//! The backward error of an answer of the wrong class: of another outcome, or with another number
//! of hits.

use super::backward::{Part, beside_edge, in_plane};
use super::chart::{Chart, sky_moved};
use super::ray::Ray;
use super::reference_camera::ReferenceCamera;
use crate::optics::trace::Trace;
use glam::{DVec2, DVec3};
use std::cell::Cell;
use std::f64::consts::TAU;

/// Rings and spokes of the search, and the factor between rings.
const SPOKES: u32 = 8;
const RING_FACTOR: f64 = 3.0;
const MIN_RING_DISTANCE: f64 = 1e-10;
const MAX_RING_DISTANCE: f64 = 0.3;
const BISECTIONS: u32 = 8;
/// Steps of the sky along the line toward the edge, for the narrow image of a ring of the disk.
const SKY_STEP: f64 = 0.01;

/// The smallest turn found after which the reference gives the same outcome and number of hits;
/// infinite where there is none within 0.3 rad. On rings of directions, then by bisection toward
/// the ray: right to a third or so. Where that finds none within `fine`, along the line through the
/// edge, on both its sides, where images of the disk crowd, and where the answer's own numbers lead
/// to.
pub(super) fn of_class(camera: &ReferenceCamera, ray: &Ray, given: &Trace, fine: f64) -> f64 {
    let same = |trace: &Trace| trace.outcome == given.outcome && hits(trace) == hits(given);
    let nearest = Cell::new(on_rings(camera, ray.direction(), &same));
    let seen = |turn: f64, trace: &Trace| {
        if turn < nearest.get() && same(trace) {
            nearest.set(turn);
        }
    };
    let own = (nearest.get() > fine)
        .then(|| Chart::edge(&camera.with_edge(ray)))
        .flatten();
    let mirrored = own.as_ref().and_then(Chart::mirrored);
    for chart in own.iter().chain(&mirrored) {
        for side in [-1.0, 1.0] {
            for (x, trace) in chart.line(camera, side, nearest.get(), SKY_STEP, sky_moved) {
                seen(chart.turn(DVec2::new(x, 0.0)), &trace);
            }
        }
        for part in Part::all(given) {
            if nearest.get() > fine {
                beside_edge(camera, chart, part, [fine, f64::INFINITY], &seen);
            }
        }
    }
    // Far from any edge, or where none was found.
    for part in Part::all(given) {
        if nearest.get() > fine {
            in_plane(camera, ray, part, &seen);
        }
    }
    nearest.get()
}

/// The same on rings about a direction.
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

/// How many hits an answer has.
pub(super) fn hits(trace: &Trace) -> usize {
    trace.hits.iter().flatten().count()
}
