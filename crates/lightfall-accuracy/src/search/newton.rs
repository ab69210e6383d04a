//! Newton's method on a chart for the ray that explains an answer.
//!
//! `at` is the miss as a function of the place; it is `None` where the ray has no such part.

use super::chart::{Chart, DIFFERENCE};
use glam::{DMat2, DVec2};

const MAX_STEPS: u32 = 24;
/// Newton's method has converged when a step is shorter than this share of the place's distance.
const CONVERGED: f64 = 1e-6;
/// Maximum number of halvings of a step to a place without a miss.
const MAX_HALVINGS: i32 = 8;
/// The minimum damping of a step, as a logarithm. Where rays are focused onto one point, no turn
/// explains the last digits of an answer, and an undamped step leads far astray.
pub(super) const MIN_DAMPING: f64 = -30.0;
/// Logarithm of a negligible damping, for steps along an edge.
pub(super) const NO_DAMPING: f64 = -70.0;

/// The place on the chart's first axis with the smallest miss, searched from a place on it by the
/// Gauss-Newton method.
pub(super) fn along_first_axis(at: &impl Fn(DVec2) -> Option<DVec2>, start: f64) -> DVec2 {
    let mut place = DVec2::new(start, 0.0);
    let Some(mut miss) = at(place) else {
        return place;
    };
    for _ in 0..8 {
        let Some(slope) = [DIFFERENCE, -DIFFERENCE]
            .into_iter()
            .find_map(|h| Some((at(place + h * DVec2::X)? - miss) / h))
        else {
            break;
        };
        let step = -(slope.dot(miss) / slope.length_squared()).clamp(-1.0, 1.0);
        match (step.abs() > DIFFERENCE)
            .then(|| advance(at, place, step * DVec2::X))
            .flatten()
        {
            Some(next) => (place, miss) = next,
            None => break,
        }
    }
    place
}

/// The place one step away and the miss there. The step is halved until the miss exists, because a
/// full step may pass the end of an image of the disk.
fn advance(
    at: &impl Fn(DVec2) -> Option<DVec2>,
    place: DVec2,
    step: DVec2,
) -> Option<(DVec2, DVec2)> {
    (0..MAX_HALVINGS)
        .map(|i| place + step * 0.5_f64.powi(i))
        .find_map(|next| at(next).map(|miss| (next, miss)))
}

/// Newton's method for the nearest ray that explains an answer. Returns the smallest bound of the
/// backward error on the way.
pub(super) fn newton(
    chart: &Chart,
    at: &impl Fn(DVec2) -> Option<DVec2>,
    start: DVec2,
    damping: f64,
) -> f64 {
    let Some(miss) = at(start) else {
        return f64::INFINITY;
    };
    let mut least = f64::max(chart.turn(start), miss.length());
    let (mut place, mut miss) = (start, miss);
    for _ in 1..MAX_STEPS {
        let Some(aim) = jacobian(chart, at, place, miss)
            .and_then(|jacobian| smallest(chart, place, miss, jacobian, damping))
        else {
            break;
        };
        let step = aim - place;
        let before = place;
        let Some(next) = advance(
            at,
            place,
            step / f64::max(1.0, (step / chart.reach()).length()),
        ) else {
            break;
        };
        (place, miss) = next;
        least = least.min(f64::max(chart.turn(place), miss.length()));
        if (place - before).length() <= CONVERGED * place.length() {
            break;
        }
    }
    least
}

/// The place nearest to the ray at which the linearised miss is no greater than the turn.
fn smallest(
    chart: &Chart,
    place: DVec2,
    miss: DVec2,
    jacobian: DMat2,
    damping: f64,
) -> Option<DVec2> {
    let aim = jacobian * place - miss;
    // The columns are scaled to length one first: near an edge, a turn across it changes the answer
    // so much more than a turn along it that the squared ratio exceeds f64's precision. A turn in
    // some direction may even change nothing.
    let lengths =
        DVec2::new(jacobian.x_axis.length(), jacobian.y_axis.length()).max(DVec2::splat(1e-100));
    let unit = jacobian * DMat2::from_diagonal(1.0 / lengths);
    let square = unit.transpose() * unit;
    let largest = lengths.length_squared();
    let solution = |exponent: f64| {
        let damped = square + DMat2::from_diagonal(largest * exponent.exp() / (lengths * lengths));
        damped.inverse() * (unit.transpose() * aim) / lengths
    };
    let allowed = |x: DVec2| chart.scale * x.length();
    let mut bracket = [damping, 5.0];
    for _ in 0..50 {
        let middle = 0.5 * (bracket[0] + bracket[1]);
        let x = solution(middle);
        bracket[usize::from((jacobian * x - aim).length() > allowed(x))] = middle;
    }
    Some(solution(bracket[0])).filter(|x| x.is_finite())
}

/// The derivative of the miss by finite differences: central ones, or one-sided ones where the miss
/// exists on one side only.
fn jacobian(
    chart: &Chart,
    at: &impl Fn(DVec2) -> Option<DVec2>,
    place: DVec2,
    miss: DVec2,
) -> Option<DMat2> {
    let differences = chart.differences();
    let derivative = |axis: DVec2| {
        let sided = |h: f64| at(place + h * axis).map(|there| (there - miss) / h);
        let difference = axis.dot(differences);
        match (sided(difference), sided(-difference)) {
            (Some(a), Some(b)) => Some(0.5 * (a + b)),
            (a, b) => a.or(b),
        }
    };
    Some(DMat2::from_cols(
        derivative(DVec2::X)?,
        derivative(DVec2::Y)?,
    ))
}
