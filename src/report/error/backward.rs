//! The backward error: by how much a ray must be turned for the reference to give the method's answer, up to an angle no
//! greater than that turn.

use super::edge::Edge;
use super::sample::Ray;
use super::{Eye, angle_between, hits};
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
/// How far the search for other numbers of turns goes: toward the edge, in powers of e of the distance to it, and in all, in
/// tenths of that.
const SCANNED_INWARD: f64 = 6.0;
const SCANNED: u32 = 160;
/// Rings and spokes of the search for another class, and the factor between rings.
const SPOKES: u32 = 8;
const RING_FACTOR: f64 = 3.0;
const NEAREST_RING: f64 = 1e-10;
const FARTHEST_RING: f64 = 0.3;
const BISECTIONS: u32 = 8;

/// Rays around one ray, by two coordinates that are zero there.
///
/// Next to the edge of the shadow the bending goes with the logarithm of the distance to it (Darwin 1959), so there the
/// first coordinate is that logarithm: what is asked for is then nearly linear in both, and Newton's method is at home.
pub(super) struct Chart {
    direction: DVec3,
    kind: Kind,
    /// The unit of both coordinates, in radians.
    scale: f64,
}

enum Kind {
    /// Two directions at right angles to the ray.
    Plane([DVec3; 2]),
    /// An edge, and the ray's position angle at it.
    Edge(Edge, f64, f64),
}

impl Chart {
    /// The chart about a ray that knows of no edge, with a unit in radians.
    pub(super) fn plane(ray: &Ray, scale: f64) -> Self {
        let direction = ray.direction();
        Self { direction, kind: Kind::Plane(direction.any_orthonormal_pair().into()), scale }
    }

    /// The chart about a ray next to an edge.
    pub(super) fn edge(ray: &Ray) -> Option<Self> {
        let direction = ray.direction();
        let edge = ray.edge?;
        let [position_angle, beyond] = edge.place(direction);
        let arc = edge.at(position_angle).sin();
        let kind = Kind::Edge(edge, position_angle, arc);
        (beyond != 0.0 && arc > 0.0).then(|| Self { direction, kind, scale: beyond.abs() })
    }

    /// The direction at two coordinates.
    fn at(&self, place: DVec2) -> DVec3 {
        match &self.kind {
            Kind::Plane([u, v]) => (self.direction + self.scale * (place.x * *u + place.y * *v)).normalize(),
            Kind::Edge(edge, position_angle, arc) => {
                let [_, beyond] = edge.place(self.direction);
                edge.direction(position_angle + place.y * self.scale / arc, beyond * place.x.exp())
            }
        }
    }

    /// How far the coordinates may go in one step of Newton's method: a hundredth of a radian, but no more than a factor e of
    /// the distance to an edge.
    fn reach(&self) -> DVec2 {
        let far = (0.01 / self.scale).max(1.0);
        if matches!(self.kind, Kind::Edge(..)) { DVec2::new(1.0, far) } else { DVec2::splat(far) }
    }

    /// The turn from the ray to the direction at two coordinates, in radians.
    fn turn(&self, place: DVec2) -> f64 {
        angle_between(self.direction, self.at(place))
    }
}

/// The turn that explains an answer of the right class: the largest of those that explain its parts.
pub(super) fn of_answer(eye: &Eye, ray: &Ray, given: &Trace) -> f64 {
    let mut most = 0.0;
    if let Some(sky) = given.sky {
        most = explained(eye, ray, |trace| trace.sky.map(|found| sky_miss(sky, found)));
    }
    for (i, hit) in given.hits.iter().enumerate().filter_map(|(i, hit)| hit.map(|hit| (i, hit))) {
        most = super::greater(most, explained(eye, ray, |trace| trace.hits[i].map(|found| hit_miss(&hit, &found))));
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
fn explained(eye: &Eye, ray: &Ray, miss: impl Fn(&Trace) -> Option<DVec2>) -> f64 {
    let plane = Chart::plane(ray, eye.scale);
    let mut least = newton(&plane, &|place| miss(&eye.trace(plane.at(place))), DVec2::ZERO);
    let Some(chart) = Chart::edge(ray) else { return least };
    let at = |place: DVec2| miss(&eye.trace(chart.at(place)));
    let solve = |start: f64| newton(&chart, &at, along_edge(&at, start));
    if least > NEAR * chart.scale {
        least = least.min(solve(0.0));
    }
    if least < FAR * chart.scale {
        return least;
    }
    // The answer may be one of another number of turns about the hole: those lie in a row toward the edge, and away from it.
    let missed = (0..=SCANNED).map(|i| {
        let x = 0.1 * f64::from(i) - SCANNED_INWARD;
        (x, at(DVec2::new(x, 0.0)).map_or(f64::INFINITY, DVec2::length))
    });
    let missed: Vec<(f64, f64)> = missed.collect();
    let lowest = missed.windows(3).filter(|three| three[1].1 <= three[0].1 && three[1].1 <= three[2].1);
    lowest.map(|three| solve(three[1].0)).fold(least, f64::min)
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
            Some(step) if step.abs() > DIFFERENCE => x += step,
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
    let mut bracket = [-60.0, 5.0];
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
/// within 0.3 rad. Rings of directions, then bisection toward the ray: right to a third or so.
pub(super) fn of_class(eye: &Eye, ray: &Ray, given: &Trace) -> f64 {
    let direction = ray.direction();
    let same = |direction: DVec3| {
        let trace = eye.trace(direction);
        trace.outcome == given.outcome && hits(&trace) == hits(given)
    };
    let (u, v) = direction.any_orthonormal_pair();
    let toward = |spoke: u32, turn: f64| {
        let (sin, cos) = (TAU * f64::from(spoke) / f64::from(SPOKES)).sin_cos();
        turn.cos() * direction + turn.sin() * (cos * u + sin * v)
    };
    let mut ring = NEAREST_RING;
    while ring < FARTHEST_RING {
        if let Some(spoke) = (0..SPOKES).find(|spoke| same(toward(*spoke, ring))) {
            let mut bracket = [ring / RING_FACTOR, ring];
            for _ in 0..BISECTIONS {
                let middle = (bracket[0] * bracket[1]).sqrt();
                bracket[usize::from(same(toward(spoke, middle)))] = middle;
            }
            return bracket[1];
        }
        ring *= RING_FACTOR;
    }
    f64::INFINITY
}
