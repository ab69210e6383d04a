//! The map from the angle psi about the hole to the angle at which `rain` sees its ray, as a table.
//! One table serves every star, order and orientation of the camera, and every motion.

use lightfall_model::geometry::schwarzschild::rain_sky::RainSky;
use std::f64::consts::PI;

/// Number of intervals of the table.
pub const INTERVALS: usize = 512;

/// Number of orders of images in the table, from zero on.
pub const ORDERS: u32 = 4;

/// Half step of the difference that gives the slope, in y. Its error is h^2/6 times the third
/// derivative, and psi's rounding over h: both some 1e-8 of the slope.
const HALF_STEP: f64 = 3e-4;

/// Maximum number of steps for a node. Three are enough.
const MAX_STEPS: u32 = 30;

/// y = ln(off_edge), where `off_edge` is the angle of a ray from the edge of the shadow in the
/// frame of `rain`, as a function of psi.
///
/// The nodes are equidistant in t, psi = pi + w sinh(t). For a distant camera y bends at psi = pi,
/// straight behind the hole, over the angle w = sqrt(8/r): twice the angular radius of the Einstein
/// ring. So the nodes are densest there.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageTable {
    sky: RainSky,
    width: f64,
    first: f64,
    spacing: f64,
    /// y, and dy/dt times the spacing.
    nodes: Vec<[f64; 2]>,
}

/// A place in the table: the arrival of the ray with a given psi.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// Angle from the edge of the shadow, in radians.
    pub off_edge: f64,
    /// The decrease of that angle per psi.
    pub slope: f64,
}

impl ImageTable {
    /// The table for a camera at radius `r` > 0 (r_s).
    pub fn new(r: f64) -> Self {
        let sky = RainSky::new(r);
        let width = (8.0 / r).sqrt();
        let first = (-PI / width).asinh();
        let last = (f64::from(ORDERS - 1) * PI / width).asinh();
        let spacing = (last - first) / INTERVALS as f64;
        let psi = |y: f64| sky.angle_to_infinity(y.exp());
        // dpsi/dy.
        let rate = |y: f64| (psi(y + HALF_STEP) - psi(y - HALF_STEP)) / (2.0 * HALF_STEP);
        // psi = 0 is the outward direction.
        let mut y = sky.farthest().ln();
        let mut psi_rate = rate(y);
        let mut nodes = vec![[y, spacing * width * first.cosh() / psi_rate]];
        for i in 1..=INTERVALS {
            let t = first + i as f64 * spacing;
            // The cubic through the last two nodes, with their slopes.
            let guess = match nodes[..] {
                [.., [y0, m0], [y1, m1]] => 5.0 * y0 - 4.0 * y1 + 2.0 * m0 + 4.0 * m1,
                _ => y + nodes[0][1],
            };
            y = solve(&psi, PI + width * t.sinh(), guess, psi_rate);
            psi_rate = rate(y);
            nodes.push([y, spacing * width * t.cosh() / psi_rate]);
        }
        Self {
            sky,
            width,
            first,
            spacing,
            nodes,
        }
    }

    /// The arrival of the ray whose angle about the hole is pi + `beyond` (radians), within the
    /// table's orders, by Hermite's cubic.
    pub fn arrival(&self, beyond: f64) -> Arrival {
        let place = ((beyond / self.width).asinh() - self.first) / self.spacing;
        let i = (place.max(0.0) as usize).min(INTERVALS - 1);
        let (x, [y0, m0], [y1, m1]) = (place - i as f64, self.nodes[i], self.nodes[i + 1]);
        let rise = y1 - y0;
        let bend = [m0, 3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise];
        let y = y0 + x * (bend[0] + x * (bend[1] + x * bend[2]));
        let rate = bend[0] + x * (2.0 * bend[1] + x * 3.0 * bend[2]);
        let off_edge = y.exp();
        let per_angle = 1.0 / (self.spacing * self.width.hypot(beyond));
        Arrival {
            off_edge,
            slope: -off_edge * rate * per_angle,
        }
    }

    /// The rays that the table inverts.
    pub fn sky(&self) -> &RainSky {
        &self.sky
    }

    /// w, in radians.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// t at the first node, and its growth from node to node.
    pub fn places(&self) -> [f64; 2] {
        [self.first, self.spacing]
    }

    /// y, and dy/dt times the spacing, at each of the nodes.
    pub fn nodes(&self) -> &[[f64; 2]] {
        &self.nodes
    }
}

/// The root of `f`(y) = `value` by the secant method, from a guess of y and of the slope.
fn solve(f: &impl Fn(f64) -> f64, value: f64, guess: f64, slope: f64) -> f64 {
    let (mut y, mut slope) = (guess, slope);
    let mut missed = f(y) - value;
    for _ in 0..MAX_STEPS {
        let step = -missed / slope;
        // Also ends where rounding has left no slope.
        if !step.is_finite() {
            break;
        }
        y += step;
        if step.abs() <= 1e-13 * y.abs().max(1.0) {
            break;
        }
        let now = f(y) - value;
        slope = (now - missed) / step;
        missed = now;
    }
    y
}
