//! Closed curves around the hole on a camera's sky, found one direction at a time.

use glam::DVec3;
use std::f64::consts::TAU;

/// Number of evenly spread directions of a new curve; points are added between neighbours that lie
/// far apart.
const FIRST_POINTS: usize = 64;
/// Neighbours are at most this far apart, as a share of the curve's angular radius. A chord then
/// misses the curve by less than a thousandth of that radius.
const MAX_GAP: f64 = 0.08;
/// Maximum number of halvings of the interval between two of the first points.
const MAX_HALVINGS: u32 = 7;
/// Range of the logarithm of tan(rho/2), rho being the angle from the middle. It leaves out less
/// than a nanoradian around the inward and the outward direction.
const LOGS: [f64; 2] = [-22.0, 22.0];
/// The first bracket extends this far from the neighbour's logarithm on both sides.
const FIRST_REACH: f64 = 0.02;
/// The logarithm is found to this error.
const TOLERANCE: f64 = 1e-9;
/// Maximum number of evaluations to find one point. Halving the whole range takes 36.
const MAX_EVALUATIONS: u32 = 160;

/// The direction at the angle `turn` about the inward direction, at the distance from it whose
/// half has a tangent with the logarithm `log`. On the axes outward, toward growing theta, toward
/// growing phi; at turn 0 it is toward growing phi.
fn direction(turn: f64, log: f64) -> DVec3 {
    let tan = log.exp();
    let (sin, cos) = turn.sin_cos();
    let square = tan * tan;
    DVec3::new(square - 1.0, -2.0 * tan * sin, 2.0 * tan * cos) / (1.0 + square)
}

/// The closed curve on which `value` changes its sign. It is positive inside, at the inward
/// direction, and negative outside, and changes its sign once on every great circle from the inward
/// to the outward direction. `None` if there is no such curve.
pub(super) fn outline(value: impl Fn(DVec3) -> f64) -> Option<Vec<DVec3>> {
    let along = |turn: f64, near: Option<f64>| root(|log| value(direction(turn, log)), near);
    let mut logs = Vec::with_capacity(FIRST_POINTS);
    let mut near = None;
    for i in 0..FIRST_POINTS {
        let turn = TAU * i as f64 / FIRST_POINTS as f64;
        near = Some(along(turn, near)?);
        logs.extend(near);
    }
    let farthest = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let max_gap = MAX_GAP * 2.0 * farthest.exp().atan();
    let mut curve = Vec::new();
    for (i, log) in logs.iter().enumerate() {
        let [start, end] = [i, i + 1].map(|i| TAU * i as f64 / FIRST_POINTS as f64);
        let next = logs[(i + 1) % FIRST_POINTS];
        curve.push(direction(start, *log));
        refine(
            &along,
            [start, end],
            [*log, next],
            max_gap,
            MAX_HALVINGS,
            &mut curve,
        );
    }
    Some(curve)
}

/// Adds points between two neighbours, without these, until no two are farther apart than
/// `max_gap`.
fn refine(
    along: &impl Fn(f64, Option<f64>) -> Option<f64>,
    turns: [f64; 2],
    logs: [f64; 2],
    max_gap: f64,
    halvings: u32,
    curve: &mut Vec<DVec3>,
) {
    let gap = direction(turns[0], logs[0]).distance(direction(turns[1], logs[1]));
    if halvings == 0 || gap <= max_gap {
        return;
    }
    let turn = 0.5 * (turns[0] + turns[1]);
    let Some(log) = along(turn, Some(0.5 * (logs[0] + logs[1]))) else {
        return;
    };
    refine(
        along,
        [turns[0], turn],
        [logs[0], log],
        max_gap,
        halvings - 1,
        curve,
    );
    curve.push(direction(turn, log));
    refine(
        along,
        [turn, turns[1]],
        [log, logs[1]],
        max_gap,
        halvings - 1,
        curve,
    );
}

/// The root of a decreasing function of the logarithm, by the regula falsi with the Illinois rule
/// (Dowell & Jarratt 1971) and occasional halvings, because the function may jump.
fn root(value: impl Fn(f64) -> f64, near: Option<f64>) -> Option<f64> {
    let [mut low, mut high] = bracket(&value, near)?;
    let mut last_side = None;
    for evaluation in 0..MAX_EVALUATIONS {
        if high.at - low.at <= TOLERANCE {
            break;
        }
        let share = if evaluation % 4 == 3 {
            0.5
        } else {
            low.value / (low.value - high.value)
        };
        let at = (low.at + share * (high.at - low.at))
            .clamp(low.at + 0.5 * TOLERANCE, high.at - 0.5 * TOLERANCE);
        let found = Sample {
            at,
            value: value(at),
        };
        let inside = found.value > 0.0;
        let (replaced, kept) = if inside {
            (&mut low, &mut high)
        } else {
            (&mut high, &mut low)
        };
        *replaced = found;
        if last_side == Some(inside) {
            kept.value *= 0.5;
        }
        last_side = Some(inside);
    }
    Some(0.5 * (low.at + high.at))
}

/// A function's value at a place.
#[derive(Clone, Copy)]
struct Sample {
    at: f64,
    value: f64,
}

/// Two places between which the function changes from positive to negative, close to `near`.
fn bracket(value: &impl Fn(f64) -> f64, near: Option<f64>) -> Option<[Sample; 2]> {
    let sample = |at: f64| Sample {
        at,
        value: value(at),
    };
    let [mut low, mut high] = [None, None];
    if let Some(near) = near {
        let mut reach = FIRST_REACH;
        // Down to a positive value, and up to a negative one unless there is one already.
        for upward in [false, true] {
            while (if upward { high } else { low }).is_none() {
                let at = if upward { near + reach } else { near - reach };
                if !(LOGS[0] < at && at < LOGS[1]) {
                    break;
                }
                let found = sample(at);
                if found.value > 0.0 {
                    low = Some(found);
                } else {
                    high = Some(found);
                }
                reach *= 4.0;
            }
        }
    }
    let low = low.unwrap_or_else(|| sample(LOGS[0]));
    let high = high.unwrap_or_else(|| sample(LOGS[1]));
    (low.value > 0.0 && high.value <= 0.0).then_some([low, high])
}
