//! The thorough search for the turn that explains an answer near the edge of the shadow. It follows
//! thousands of rays, so it is for the few rays whose error is still too large after the usual
//! search.

use super::chart::Chart;
use super::class::hits;
use super::finite::greater;
use super::newton::{NO_DAMPING, newton};
use super::part::{Part, miss_on_chart};
use super::ray::Ray;
use super::reference_camera::ReferenceCamera;
use crate::optics::trace::Trace;
use glam::DVec2;
use std::cell::Cell;

/// The grid's columns: from `MIN_COLUMN` e-folds of the distance to the edge on, in steps of
/// `COLUMN_STEP`. One e-fold bends the light by about a radian more, so Newton's method converges
/// from the nearest column. On either side of the ray the step is halved `HALVINGS` times.
const MIN_COLUMN: f64 = -12.0;
const COLUMN_STEP: f64 = 0.25;
const HALVINGS: i32 = 6;
/// The grid's rows along the edge on either side of the ray: at turns from `MIN_TURN` of the
/// greatest turn on, evenly in the logarithm.
const ROWS: u32 = 12;
const MIN_TURN: f64 = 1e-3;
/// The greatest turn of the grid as a share of the shadow's radius: the edge's polynomial describes
/// the edge this far.
const MAX_SHARE: f64 = 0.3;
/// Misses from which Newton's method is started, in radians or, for the radius of a hit, relative.
const MAX_MISS: f64 = 1.0;

/// The backward error, in radians, as `backward_error` and `class_backward_error` define it, but no
/// more than the bound `known` and searched on a grid over both sides of the shadow's edge. A bound
/// below `precision` ends the search.
pub(super) fn thorough_backward_error(
    camera: &ReferenceCamera,
    ray: &Ray,
    truth: &Trace,
    given: &Trace,
    [precision, known]: [f64; 2],
) -> f64 {
    let own = Chart::edge(&camera.with_edge(ray));
    let mirrored = own.as_ref().and_then(Chart::mirrored);
    let same = |trace: &Trace| trace.outcome == given.outcome && hits(trace) == hits(given);
    let nearest = Cell::new(known);
    let seen = |turn: f64, trace: &Trace| {
        if turn < nearest.get() && same(trace) {
            nearest.set(turn);
        }
    };
    let is_misclassified = !same(truth);
    let mut most = 0.0;
    for part in Part::all(given) {
        let least = Cell::new(known);
        // A misclassified answer is explained by a ray of its class, wherever its parts are.
        let bound = if is_misclassified { &nearest } else { &least };
        for chart in own.iter().chain(&mirrored) {
            let at = miss_on_chart(camera, chart, part, &seen);
            for start in starts(chart, &at, bound.get()) {
                if bound.get() <= precision {
                    break;
                }
                least.set(least.get().min(newton(chart, &at, start, NO_DAMPING)));
            }
        }
        most = greater(most, least.get());
    }
    if is_misclassified {
        nearest.get()
    } else {
        most
    }
}

/// The places of a grid on a chart at which the miss is locally least along its row, the smallest
/// turn first. `known` is the greatest turn that is of interest.
fn starts(chart: &Chart, at: &impl Fn(DVec2) -> Option<DVec2>, known: f64) -> Vec<DVec2> {
    let reach = known.min(MAX_SHARE * chart.radius());
    let columns = columns((reach / chart.scale).ln_1p());
    let miss = |place: DVec2| {
        let miss = (chart.turn(place) < known).then(|| at(place)).flatten();
        miss.map_or(f64::INFINITY, DVec2::length)
    };
    let least_of_row = |turn: f64| {
        let row: Vec<(DVec2, f64)> = columns
            .iter()
            .map(|x| DVec2::new(*x, turn / chart.scale))
            .map(|place| (place, miss(place)))
            .collect();
        let is_least =
            |[before, here, after]: [f64; 3]| here < MAX_MISS && here <= before && here <= after;
        row.array_windows()
            .filter(|[before, here, after]| is_least([before.1, here.1, after.1]))
            .map(|[_, here, _]| here.0)
            .collect::<Vec<_>>()
    };
    let turns = (0..ROWS).flat_map(|i| {
        let turn = reach * MIN_TURN.powf(f64::from(i) / f64::from(ROWS - 1));
        [turn, -turn]
    });
    let mut places: Vec<DVec2> = turns.chain([0.0]).flat_map(least_of_row).collect();
    places.sort_by(|a, b| chart.turn(*a).total_cmp(&chart.turn(*b)));
    places
}

/// The first coordinates of a grid up to `greatest`, in ascending order.
fn columns(greatest: f64) -> Vec<f64> {
    let finest = COLUMN_STEP * 0.5_f64.powi(HALVINGS);
    let mut columns = vec![MIN_COLUMN];
    let mut last = MIN_COLUMN;
    while last < greatest {
        last += (0.5 * last.abs()).clamp(finest, COLUMN_STEP);
        columns.push(last);
    }
    columns
}
