//! The backward error: by how much a ray must be turned for the reference to give the method's answer, up to an angle no
//! greater than that turn.

use super::chart::Chart;
use super::sample::Ray;
use super::{Eye, hits};
use crate::physics::trace::{Hit, Trace};
use glam::{DMat2, DVec2, DVec3};
use std::f64::consts::TAU;

/// Most steps of Newton's method.
const MOST_STEPS: u32 = 24;
/// Share of a chart's unit over which differences are taken: the derivative is then right to this share, and the reference's
/// twelve digits leave enough of the difference.
const DIFFERENCE: f64 = 1e-4;
/// Share of the way at which Newton's method has arrived.
const SETTLED: f64 = 1e-6;
/// Within this share of the distance to the edge the plane is as good a chart as the edge's own; beyond so many of them an
/// explanation may not be the nearest.
const NEAR: f64 = 0.1;
const FAR: f64 = 3.0;
/// A backward error so large, and a forward one so much larger, are worth a search for the edge.
const LEAST_WORTH: f64 = 1e-6;
const AMPLIFIED: f64 = 30.0;
/// So is an answer so far off, whatever a first search found.
const FAR_OFF: f64 = 0.03;
/// Steps of the sky along the line toward the edge, and how many: for a direction on it, for the narrow image of a ring of
/// the disk, and for the narrowest.
const SKY_STEP: (f64, u32) = (0.2, 300);
const FINE_SKY_STEP: (f64, u32) = (0.01, 300);
const FINEST_SKY_STEP: (f64, u32) = (5e-4, 6000);
/// The places on the line toward the edge where an answer is missed least, and which are looked at closer.
const MOST_DIPS: usize = 5;
/// Rings and spokes of the search for another class, and the factor between rings.
const SPOKES: u32 = 8;
const RING_FACTOR: f64 = 3.0;
const NEAREST_RING: f64 = 1e-10;
const FARTHEST_RING: f64 = 0.3;
const BISECTIONS: u32 = 8;

/// The turn that explains an answer of the right class: the largest of those that explain its parts.
///
/// What is off by less than `fine` is not looked at closer: its own size, which bounds the turn, will do.
pub(super) fn of_answer(eye: &Eye, ray: &Ray, truth: &Trace, given: &Trace, fine: f64) -> f64 {
    let mut most = 0.0;
    let mut part = |miss: &dyn Fn(&Trace) -> Option<DVec2>| {
        let forward = miss(truth).map_or(f64::INFINITY, DVec2::length);
        most = super::greater(most, if forward < fine { forward } else { explained(eye, ray, miss) });
    };
    if let Some(sky) = given.sky {
        part(&|trace| trace.sky.map(|found| sky_miss(sky, found)));
    }
    for (i, hit) in given.hits.iter().enumerate().filter_map(|(i, hit)| hit.map(|hit| (i, hit))) {
        part(&|trace| trace.hits[i].map(|found| hit_miss(&hit, &found)));
    }
    most
}

/// By how much a direction misses another, on two axes at right angles to that other.
fn sky_miss(wanted: DVec3, found: DVec3) -> DVec2 {
    let (u, v) = wanted.any_orthonormal_pair();
    let miss = found - wanted;
    DVec2::new(miss.dot(u), miss.dot(v))
}

/// By how much a hit misses another, as a share of its 1/r, which unlike r is smooth to infinity, and along the azimuth.
fn hit_miss(wanted: &Hit, found: &Hit) -> DVec2 {
    let azimuth = (found.phi - wanted.phi + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
    DVec2::new(1.0 - wanted.r / found.r, azimuth)
}

/// The smallest angle found for which a turn of the ray by no more leaves a `miss` of no more; infinite where the miss has no
/// meaning anywhere near.
///
/// That is the mixed forward-backward error (Higham 2002, section 1.5): nearly the right answer to nearly the right
/// question. Behind the hole there are points onto which whole rings of rays are focused, and next to them no turn
/// explains an answer's last digit; elsewhere it is the turn that explains the answer, but for a factor of two at most.
/// Every place that is tried bounds it from above, so a search that fails can but overstate it.
fn explained(eye: &Eye, ray: &Ray, miss: &dyn Fn(&Trace) -> Option<DVec2>) -> f64 {
    let plane = Chart::plane(ray, eye.scale);
    let mut least = newton(&plane, &|place| miss(&eye.trace(plane.at(place))), DVec2::ZERO);
    // Edges are dear to find: only for answers far off to which a small turn leads, as next to an edge.
    let forward = miss(&eye.trace(ray.direction())).map_or(f64::INFINITY, DVec2::length);
    let amplified = least > LEAST_WORTH && (forward > AMPLIFIED * least || forward > FAR_OFF);
    let ray = if amplified { eye.with_edge(ray) } else { *ray };
    let Some(chart) = Chart::edge(&ray) else { return least };
    let at = |place: DVec2| miss(&eye.trace(chart.at(place)));
    if least > NEAR * chart.scale {
        least = least.min(newton(&chart, &at, along_edge(&at, 0.0)));
    }
    if least < FAR * chart.scale {
        return least;
    }
    // The answer may be one of another number of turns about the hole: those lie in a row toward the edge, and away from it.
    let [inward, outward] = [-1.0, 1.0].map(|side| {
        let line = chart.line(eye, side, least, SKY_STEP.0, SKY_STEP.1);
        line.into_iter().map(|(x, trace)| (x, miss(&trace))).collect::<Vec<_>>()
    });
    // Next to a fast hole a whole orbit is a small part of that row, so a look over all of it is as coarse as it has to be.
    let whole = chart.line(eye, -1.0, least, f64::INFINITY, SKY_STEP.1);
    let whole: Vec<_> = whole.into_iter().map(|(x, trace)| (x, miss(&trace))).collect();
    if winds_around(&inward) || winds_around(&whole) {
        least = least.min(chart.scale);
    }
    // The steps are too coarse to say which of them comes nearest.
    let starts = dips(&inward).into_iter().chain(dips(&outward)).map(|x| along_edge(&at, x));
    let miss_at = |start: DVec2| at(start).map_or(f64::INFINITY, DVec2::length);
    let mut starts: Vec<(DVec2, f64)> =
        starts.map(|start| (start, f64::max(chart.turn(start), miss_at(start)))).collect();
    starts.sort_by(|a, b| a.1.total_cmp(&b.1));
    starts.into_iter().take(MOST_DIPS).map(|start| newton(&chart, &at, start.0)).fold(least, f64::min)
}

/// Whether rays toward the edge miss an answer on all of its sides. Each e-fold of the distance to the edge adds as much of an
/// orbit as the one before, without end: rays that pass an answer on all sides do so again and again, as close as one likes
/// in the end, and so the distance to the edge bounds its error.
fn winds_around(inward: &[(f64, Option<DVec2>)]) -> bool {
    let misses = || inward.iter().filter_map(|(_, miss)| *miss);
    let on_both_sides = |component: fn(DVec2) -> f64| {
        misses().any(|miss| component(miss) > 0.0) && misses().any(|miss| component(miss) < 0.0)
    };
    on_both_sides(|miss| miss.x) && on_both_sides(|miss| miss.y)
}

/// The places of a line where an answer is missed less than before and after.
fn dips(line: &[(f64, Option<DVec2>)]) -> Vec<f64> {
    let lengths: Vec<(f64, f64)> =
        line.iter().map(|(x, miss)| (*x, miss.map_or(f64::INFINITY, DVec2::length))).collect();
    let low = lengths.windows(3).filter(|three| three[1].1 <= three[0].1 && three[1].1 <= three[2].1);
    low.map(|three| three[1]).filter(|dip| dip.1.is_finite()).map(|dip| dip.0).collect()
}

/// The place nearest to explaining an answer on the line toward the edge, from a place there (Gauss and Newton).
fn along_edge(at: &impl Fn(DVec2) -> Option<DVec2>, start: f64) -> DVec2 {
    let mut x = start;
    for _ in 0..8 {
        let step = at(DVec2::new(x, 0.0)).zip(at(DVec2::new(x + DIFFERENCE, 0.0))).map(|(left, beside)| {
            let slope = (beside - left) / DIFFERENCE;
            -(slope.dot(left) / slope.length_squared()).clamp(-1.0, 1.0)
        });
        match step {
            Some(step) if step.abs() > SETTLED => x += step,
            _ => break,
        }
    }
    DVec2::new(x, 0.0)
}

/// Newton's method for the smallest place that explains an answer: the least bound met on the way.
fn newton(chart: &Chart, at: &impl Fn(DVec2) -> Option<DVec2>, start: DVec2) -> f64 {
    let mut least = f64::INFINITY;
    let mut place = start;
    for _ in 0..MOST_STEPS {
        let Some(left) = at(place) else { break };
        least = least.min(f64::max(chart.turn(place), left.length()));
        let Some(step) = jacobian(at, place, left).and_then(|jacobian| smallest(chart, place, left, jacobian)) else {
            break;
        };
        let step = step - place;
        place += step / f64::max(1.0, (step / chart.reach()).length());
        if step.length() <= SETTLED * place.length() {
            break;
        }
    }
    least
}

/// The nearest place to the ray from which a miss that is linear in the place is no greater than the turn to there.
fn smallest(chart: &Chart, place: DVec2, left: DVec2, jacobian: DMat2) -> Option<DVec2> {
    let aim = jacobian * place - left;
    let square = jacobian.transpose() * jacobian;
    let largest = square.x_axis.x + square.y_axis.y;
    let solution = |exponent: f64| {
        let damped = square + DMat2::from_diagonal(DVec2::splat(largest * exponent.exp()));
        damped.inverse() * (jacobian.transpose() * aim)
    };
    let allowed = |x: DVec2| chart.scale * x.length();
    let mut bracket = [-30.0, 5.0];
    for _ in 0..40 {
        let middle = 0.5 * (bracket[0] + bracket[1]);
        let x = solution(middle);
        bracket[usize::from((jacobian * x - aim).length() > allowed(x))] = middle;
    }
    Some(solution(bracket[0])).filter(|x| x.is_finite())
}

/// The derivative of the miss, by differences, on whichever side there is something.
fn jacobian(at: &impl Fn(DVec2) -> Option<DVec2>, place: DVec2, left: DVec2) -> Option<DMat2> {
    let derivative = |axis: DVec2| {
        let sided = |h: f64| at(place + h * axis).map(|miss| (miss - left) / h);
        match (sided(DIFFERENCE), sided(-DIFFERENCE)) {
            (Some(a), Some(b)) => Some(0.5 * (a + b)),
            (a, b) => a.or(b),
        }
    };
    Some(DMat2::from_cols(derivative(DVec2::X)?, derivative(DVec2::Y)?))
}

/// The smallest turn found after which the reference gives the same outcome and number of hits; infinite where there is none
/// within 0.3 rad. Along the line toward the edge, where images of the disk crowd; and on rings of directions, then by
/// bisection toward the ray: right to a third or so.
pub(super) fn of_class(eye: &Eye, ray: &Ray, given: &Trace) -> f64 {
    let same = |trace: &Trace| trace.outcome == given.outcome && hits(trace) == hits(given);
    let ray = &eye.with_edge(ray);
    let lines = |(sky_step, most): (f64, u32)| {
        let chart = Chart::edge(ray);
        let nearest = |chart: &Chart, side: f64| {
            let mut line = chart.line(eye, side, FARTHEST_RING, sky_step, most).into_iter();
            line.find(|(_, trace)| same(trace)).map_or(f64::INFINITY, |(x, _)| chart.turn(DVec2::new(x, 0.0)))
        };
        chart.map_or(f64::INFINITY, |chart| f64::min(nearest(&chart, -1.0), nearest(&chart, 1.0)))
    };
    let on_lines = lines(FINE_SKY_STEP);
    let direction = ray.direction();
    let (u, v) = direction.any_orthonormal_pair();
    let toward = |spoke: u32, turn: f64| {
        let (sin, cos) = (TAU * f64::from(spoke) / f64::from(SPOKES)).sin_cos();
        turn.cos() * direction + turn.sin() * (cos * u + sin * v)
    };
    let same_toward = |spoke: u32, turn: f64| same(&eye.trace(toward(spoke, turn)));
    let mut ring = NEAREST_RING;
    while ring < f64::min(FARTHEST_RING, on_lines) {
        let bisected = |spoke: u32| {
            let mut bracket = [ring / RING_FACTOR, ring];
            for _ in 0..BISECTIONS {
                let middle = (bracket[0] * bracket[1]).sqrt();
                bracket[usize::from(same_toward(spoke, middle))] = middle;
            }
            bracket[1]
        };
        let nearest = (0..SPOKES).filter(|spoke| same_toward(*spoke, ring)).map(bisected).fold(f64::INFINITY, f64::min);
        if nearest.is_finite() {
            return nearest.min(on_lines);
        }
        ring *= RING_FACTOR;
    }
    if on_lines.is_finite() { on_lines } else { lines(FINEST_SKY_STEP) }
}
