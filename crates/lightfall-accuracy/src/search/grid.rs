//! A grid of the reference's answers to rays on one side of the shadow's edge, and the searches
//! that start from its places.

use super::chart::Chart;
use super::newton::{NO_DAMPING, newton};
use super::part::{Part, bound_of_whole, miss_on_chart};
use super::turns::{Explained, TurnBounds, Turns};
use crate::answer::{greater, is_same_class};
use crate::reference_camera::ReferenceCamera;
use glam::{DVec2, DVec3};
use lightfall_optics::trace::Trace;
use rayon::prelude::*;
use std::cell::Cell;

/// The grid's columns: from `MIN_COLUMN` e-folds of the distance to the edge on, in steps of
/// `COLUMN_STEP`. One e-fold bends the light by about another radian, so Newton's method converges
/// from the nearest column. Toward the ray the step is halved up to `HALVINGS` times.
const MIN_COLUMN: f64 = -12.0;
const COLUMN_STEP: f64 = 0.25;
const HALVINGS: i32 = 6;
/// The rows along the edge: each halves the turn of the previous one, down to `MIN_TURN` times the
/// target. At most `MAX_ROWS` rows on each side of the ray.
const MIN_TURN: f64 = 2e-3;
const MAX_ROWS: usize = 24;
/// The greatest turn of the grid as a share of the shadow's radius, within which the edge's
/// polynomial describes the edge.
const MAX_SHARE: f64 = 0.3;
/// The largest miss from which Newton's method is started, in radians or, for the radius of a hit,
/// relative.
const MAX_MISS: f64 = 1.0;
/// Maximum number of places from which Newton's method is started, the nearest first, and the
/// number of those tried in parallel.
const MAX_STARTS: usize = 1024;
const STARTS_AT_ONCE: usize = 16;

/// The answers on one side of the edge, row by row.
pub(super) struct Grid<'a> {
    camera: &'a ReferenceCamera,
    chart: Chart,
    rows: Vec<Vec<Place>>,
}

/// A place on a chart, the turn to it, and the answer there.
struct Place {
    place: DVec2,
    turn: f64,
    trace: Trace,
}

impl<'a> Grid<'a> {
    /// Traces the rays of the grid, with turns from a small share of the target up to the upper
    /// bound.
    pub(super) fn new(camera: &'a ReferenceCamera, chart: Chart, bounds: TurnBounds) -> Self {
        let rows = places(&chart, bounds);
        let answer = |place: DVec2| Place {
            place,
            turn: chart.turn(place),
            trace: camera.trace(chart.at(place)),
        };
        let row = |row: Vec<DVec2>| row.into_par_iter().map(answer).collect();
        let rows = rows.into_par_iter().map(row).collect();
        Self {
            camera,
            chart,
            rows,
        }
    }

    /// Runs Newton's method from places of the grid until a turn is below `target`.
    pub(super) fn explain(
        &self,
        given: &Trace,
        part: Part,
        target: f64,
        mut least: Explained,
    ) -> Explained {
        let chart = &self.chart;
        let from = |start: &DVec2| {
            let whole = Cell::new(f64::INFINITY);
            let visit = |direction: DVec3, trace: &Trace| {
                let bound = bound_of_whole(given, chart.turn_to(direction), trace);
                whole.set(whole.get().min(bound));
            };
            let at = miss_on_chart(self.camera, chart, part, &visit);
            Explained {
                part: newton(chart, &at, *start, NO_DAMPING),
                whole: whole.get(),
            }
        };
        let starts = self.nearest_starts(part, least.part);
        for starts in starts.chunks(STARTS_AT_ONCE) {
            if least.is_within(target) {
                break;
            }
            let found = starts.par_iter().map(from);
            least = found.reduce(|| least, Explained::min);
        }
        least
    }

    /// The turns that explain an answer, searched from the ray that explains its sky. Newton's
    /// method finds this ray from `start`.
    pub(super) fn turns_along_sky(&self, given: &Trace, sky: DVec3, start: DVec2) -> Turns {
        let chart = &self.chart;
        let nearest = Cell::new((f64::INFINITY, chart.at(start)));
        let class = Cell::new(f64::INFINITY);
        let look = |direction: DVec3, trace: &Trace| {
            if is_same_class(trace, given) {
                class.set(class.get().min(chart.turn_to(direction)));
            }
        };
        let part = Part::Sky(sky);
        let visit = |direction: DVec3, trace: &Trace| {
            look(direction, trace);
            let miss = part.miss(trace).map_or(f64::INFINITY, DVec2::length);
            if miss < nearest.get().0 {
                nearest.set((miss, direction));
            }
        };
        let at = miss_on_chart(self.camera, chart, part, &visit);
        let sky = newton(chart, &at, start, NO_DAMPING);
        let start = chart.place_of(nearest.get().1).unwrap_or(start);
        let mut hits = 0.0;
        for hit in given.hits.iter().flatten() {
            let at = |place: DVec2| {
                let direction = chart.at(place);
                look(direction, &self.camera.trace(direction));
                Part::miss_of_hit(hit, &self.camera.crossing_near(direction, hit.r)?)
            };
            hits = greater(hits, newton(chart, &at, start, NO_DAMPING));
        }
        let class = class.get();
        Turns { sky, hits, class }
    }

    /// The smallest turn on the grid to an answer of the same class.
    pub(super) fn turn_to_class(&self, given: &Trace) -> f64 {
        let places = self.rows.iter().flatten();
        let same = places.filter(|place| is_same_class(&place.trace, given));
        same.map(|place| place.turn).fold(f64::INFINITY, f64::min)
    }

    /// The places from which Newton's method is started for a part, the nearest first.
    pub(super) fn nearest_starts(&self, part: Part, upper_bound: f64) -> Vec<DVec2> {
        let mut starts = self.starts(part, upper_bound);
        starts.sort_by(|a, b| self.chart.turn(*a).total_cmp(&self.chart.turn(*b)));
        starts.truncate(MAX_STARTS);
        starts
    }

    /// The places at which the miss of a part is locally least along its row, with turns below the
    /// upper bound.
    fn starts(&self, part: Part, upper_bound: f64) -> Vec<DVec2> {
        let miss = |place: &Place| {
            let miss = (place.turn < upper_bound)
                .then(|| part.miss(&place.trace))
                .flatten();
            (place.place, miss.map_or(f64::INFINITY, DVec2::length))
        };
        let is_least =
            |[before, here, after]: [f64; 3]| here < MAX_MISS && here <= before && here <= after;
        let least_of_row = |row: &Vec<Place>| {
            let row: Vec<(DVec2, f64)> = row.iter().map(miss).collect();
            row.array_windows()
                .filter(|[before, here, after]| is_least([before.1, here.1, after.1]))
                .map(|[_, here, _]| here.0)
                .collect::<Vec<_>>()
        };
        self.rows.iter().flat_map(least_of_row).collect()
    }
}

/// The places of the grid on a chart, row by row.
fn places(
    chart: &Chart,
    TurnBounds {
        target,
        upper_bound,
    }: TurnBounds,
) -> Vec<Vec<DVec2>> {
    let reach = upper_bound.min(MAX_SHARE * chart.radius());
    let columns = columns((reach / chart.scale).ln_1p());
    let halved = std::iter::successors(Some(reach), |turn| Some(0.5 * turn));
    let turns = halved
        .take_while(|turn| *turn > MIN_TURN * target)
        .take(MAX_ROWS);
    let row = |turn: f64| {
        let place = |x: &f64| DVec2::new(*x, turn / chart.scale);
        columns.iter().map(place).collect()
    };
    let both = turns.flat_map(|turn| [turn, -turn]);
    both.chain([0.0]).map(row).collect()
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
