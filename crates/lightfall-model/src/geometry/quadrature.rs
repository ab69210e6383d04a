//! Numerical integration.

use std::f64::consts::PI;

/// Non-negative nodes and weights of the Gauss-Legendre rule with seven points on [-1, 1]: the node
/// at zero, and one node of each of the three symmetric pairs.
const NODES: [[f64; 2]; 4] = [
    [0.0, 0.417_959_183_673_469_4],
    [0.405_845_151_377_397_2, 0.381_830_050_505_118_9],
    [0.741_531_185_599_394_4, 0.279_705_391_489_276_7],
    [0.949_107_912_342_758_5, 0.129_484_966_168_869_7],
];

/// Maximum relative difference between an integral and the sum over its halves, and between their
/// first moments: chance may make one of the two agree.
const TOLERANCE: f64 = 1e-12;

/// Number of Newton's steps that take the first guess of a root of Legendre's polynomial to its
/// last digit.
const NEWTON_STEPS: u32 = 8;

/// Maximum number of times that an interval is halved.
const MAX_HALVINGS: u32 = 24;

/// A function's integral over an interval, and that of its product with the distance from the
/// middle in units of half the width.
#[derive(Clone, Copy, Debug)]
struct Panel {
    integral: f64,
    moment: f64,
}

/// The integral of a smooth function from `from` to `to`, with a relative error of about 1e-12: the
/// interval is halved until the two halves agree with the whole.
pub fn integral(from: f64, to: f64, f: &impl Fn(f64) -> f64) -> f64 {
    integral_on_scale(0.0, from, to, f)
}

/// As [`integral`], but the error may also be 1e-12 times `scale`: for functions that change sign,
/// or that are nothing but rounding.
pub fn integral_on_scale(scale: f64, from: f64, to: f64, f: &impl Fn(f64) -> f64) -> f64 {
    let whole = seven_points(from, to, f);
    refined(scale, [from, to], whole, MAX_HALVINGS, f)
}

fn refined(
    scale: f64,
    [from, to]: [f64; 2],
    whole: Panel,
    halvings: u32,
    f: &impl Fn(f64) -> f64,
) -> f64 {
    let middle = 0.5 * (from + to);
    let [low, high] = [seven_points(from, middle, f), seven_points(middle, to, f)];
    let sum = low.integral + high.integral;
    let moment = 0.5 * (low.moment + high.moment + high.integral - low.integral);
    let limit = TOLERANCE * sum.abs().max(scale);
    let differs = (sum - whole.integral).abs() > limit || (moment - whole.moment).abs() > limit;
    // False for NaN, so that the halving ends.
    if halvings == 0 || !differs {
        return sum;
    }
    refined(scale, [from, middle], low, halvings - 1, f)
        + refined(scale, [middle, to], high, halvings - 1, f)
}

fn seven_points(from: f64, to: f64, f: &impl Fn(f64) -> f64) -> Panel {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let (mut integral, mut moment) = (0.0, 0.0);
    for [node, weight] in NODES {
        if node == 0.0 {
            integral += weight * f(middle);
        } else {
            let (low, high) = (f(middle - half * node), f(middle + half * node));
            integral += weight * (low + high);
            moment += weight * node * (high - low);
        }
    }
    Panel {
        integral: half * integral,
        moment: half * moment,
    }
}

/// Nodes and weights of the Gauss-Legendre rule with `count` points on [0, 1], in growing order of
/// the nodes: the roots of Legendre's polynomial by Newton's method (Abramowitz & Stegun 1964
/// 25.4.29).
pub fn gauss_legendre(count: usize) -> Vec<(f64, f64)> {
    let node = |i: usize| {
        let mut x = -(PI * (i as f64 + 0.75) / (count as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..NEWTON_STEPS {
            let (mut before, mut value) = (1.0, x);
            for k in 2..=count {
                let k = k as f64;
                (before, value) = (
                    value,
                    ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k,
                );
            }
            slope = count as f64 * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..count).map(node).collect()
}
