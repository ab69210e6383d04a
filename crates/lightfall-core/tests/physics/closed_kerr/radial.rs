//! The motion in u = 1/r, in closed form.
//!
//! u'^2 = U(u) = W^2 - K' u^2 D and u'' = u p(u), where p = p_0 + p_1 u + p_2 u^2 is
//! 2 B W - K' (D + u D'/2). So U has critical points at u = 0 and where p vanishes, in closed form.
//! About a critical point c, with v = u - c,
//!
//! U = b_0 + alpha v^2 + beta v^3 + gamma v^4
//!
//! has no linear term, and everything follows from these four numbers: how far the critical curve is
//! (b_0 alone is small next to it), a root e of Weierstrass's cubic, and the turning points.

use super::weierstrass::weierstrass;
use lightfall_core::geometry::elliptic::carlson_rf_pair;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::mino::PhotonConstants;

/// Number of Newton's steps that take the cubic's root to its last digit.
const NEWTON_STEPS: u32 = 80;

/// The constants of the radial motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Radial {
    /// E.
    pub(super) energy: f64,
    /// The coefficients of p.
    pub(super) p: [f64; 3],
    /// r_+ and r_-.
    horizons: [f64; 2],
    /// a, L and K'.
    a: f64,
    angular_momentum: f64,
    k_prime: f64,
    /// The critical point about which the numbers below are.
    pub(super) base: f64,
    b_0: f64,
    alpha: f64,
    beta: f64,
    gamma: f64,
    /// The isolated root of the cubic is -alpha/6 + offset, and the other two are alpha/12 -
    /// offset/2 +- sqrt(h2).
    offset: f64,
    h2: f64,
    /// u of the critical point, if it is outside the horizon and U is negative there: no light with
    /// these constants passes it.
    pub(super) barrier: Option<f64>,
}

/// A turning point, or another point from which a leg of the ray is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Centre {
    /// u there.
    pub(super) u: f64,
    /// 1 where the leg leads to smaller u, -1 where it leads to larger u.
    pub(super) side: f64,
    /// U is the sum of c_k y^k, y the distance from the centre.
    pub(super) c: [f64; 5],
    /// What the two kinds of arguments of R_F are for y -> infinity.
    isolated: f64,
    pair: f64,
}

impl Radial {
    /// The motion of a ray with these constants, which starts with `u` and `du`.
    pub(super) fn new(kerr: Kerr, c: &PhotonConstants, [u_start, du]: [f64; 2]) -> Self {
        let (a, energy, k_prime) = (c.a, c.energy, c.k_prime());
        let drag = a * (a * energy - c.angular_momentum);
        let p = [
            2.0 * drag * energy - k_prime,
            1.5 * k_prime,
            2.0 * (drag * drag - a * a * k_prime),
        ];
        let mut radial = Self {
            energy,
            p,
            horizons: [kerr.horizon(), kerr.inner_horizon()],
            a,
            angular_momentum: c.angular_momentum,
            k_prime,
            base: 0.0,
            b_0: energy * energy,
            alpha: p[0],
            beta: k_prime,
            gamma: 0.5 * p[2],
            offset: 0.0,
            h2: 0.0,
            barrier: None,
        };
        let root2 = p[1] * p[1] - 4.0 * p[0] * p[2];
        let u_horizon = 1.0 / kerr.horizon();
        if p[0] < 0.0 && root2 >= 0.0 {
            let root = root2.sqrt();
            let u = -2.0 * p[0] / (p[1] + root);
            let (alpha, beta) = (u * root, 2.0 / 3.0 * (root + p[2] * u));
            let v = u_start - u;
            // Next to the critical point u'^2 has digits of b_0 that W^2 - K' u^2 D has lost.
            let b_0 = if v.abs() < 0.5 * u {
                du * du - v * v * (alpha + v * (beta + v * radial.gamma))
            } else {
                let w = energy + drag * u * u;
                w * w - k_prime * u * u * radial.denominator(u)
            };
            if u < u_horizon && b_0 < 0.0 {
                radial.barrier = Some(u);
            }
            // Where light is hardly bent the critical point at u = 0 is the better base.
            if b_0 > -energy * energy {
                radial.base = u;
                radial.b_0 = b_0;
                (radial.alpha, radial.beta) = (alpha, beta);
            }
        }
        radial.offset = radial.isolated_offset();
        let e = radial.offset;
        radial.h2 = 0.25 * (radial.gamma * radial.b_0 + e * (radial.alpha - 3.0 * e));
        radial
    }

    /// The root, on the side of zero that b_0 asks for, of 4 x^3 - 2 alpha x^2 + (alpha^2/4 - gamma
    /// b_0) x + beta^2 b_0/16: what is left of Weierstrass's cubic at -alpha/6 + x. It is the one
    /// next to zero if there are three on that side.
    fn isolated_offset(&self) -> f64 {
        let side = -self.b_0.signum();
        let curve = self.gamma * self.b_0;
        let (bend, slope) = (side * self.alpha, 0.25 * self.alpha * self.alpha - curve);
        let constant = self.beta * self.beta * self.b_0.abs() / 16.0;
        // The cubic as a function of y = side x, negative at zero.
        let value_at = |y: f64| y * (slope + y * (4.0 * y - 2.0 * bend)) - constant;
        // Newton's method is steady where the cubic does not change its curvature on the way: from
        // zero to a root below its maximum (its inflection, if it has none), else from beyond all
        // roots.
        let top = bend / 6.0 - (bend * bend / 144.0 + curve / 12.0).max(0.0).sqrt();
        let below_top = top > 0.0 && value_at(top) >= 0.0;
        let (mut y, limit) = if below_top {
            (0.0, top)
        } else if bend <= 0.0 && slope > 0.0 {
            (constant / slope, f64::INFINITY)
        } else {
            let far = (0.25 * constant).cbrt() + 0.5 * (-slope).max(0.0).sqrt();
            (far + 0.5 * bend.max(0.0), f64::INFINITY)
        };
        for _ in 0..NEWTON_STEPS {
            let step = value_at(y) / (slope + y * (12.0 * y - 4.0 * bend));
            if !step.is_finite() || step == 0.0 {
                break;
            }
            y = (y - step).min(limit);
        }
        side * y
    }

    /// The outer side of the barrier, where light from outside turns.
    pub(super) fn turning_point(&self) -> Centre {
        let mean = 0.25 * self.alpha - 0.5 * self.offset;
        let product = (mean * mean - self.h2).max(0.0).sqrt();
        // The roots s = 1/v of b_0 s^4 + alpha s^2 + beta s + gamma by Euler's solution.
        let sum = (8.0 / self.b_0.abs() * (mean.abs() + product)).sqrt();
        let third = (-4.0 * self.offset / self.b_0)
            .max(0.0)
            .sqrt()
            .copysign(self.beta);
        // The barrier is below the critical point, and above u = 0.
        let v = if self.base > 0.0 { -2.0 } else { 2.0 } / (sum - third);
        let slope = v * (2.0 * self.alpha + v * (3.0 * self.beta + v * 4.0 * self.gamma));
        let bend = v * (3.0 * self.beta + v * 6.0 * self.gamma);
        Centre {
            u: self.base + v,
            side: 1.0,
            c: [
                0.0,
                -slope,
                self.alpha + bend,
                -(self.beta + 4.0 * self.gamma * v),
                self.gamma,
            ],
            isolated: 0.25 * self.alpha + bend / 12.0 - self.offset,
            pair: bend / 12.0 + 0.5 * self.offset,
        }
    }

    /// The critical point as the centre of a leg that leads to smaller u (`side` 1) or to larger u
    /// (-1).
    pub(super) fn critical_point(&self, side: f64) -> Centre {
        Centre {
            u: self.base,
            side,
            c: [self.b_0, 0.0, self.alpha, -side * self.beta, self.gamma],
            isolated: 0.0,
            pair: 0.0,
        }
    }

    /// The Mino time from a turning point to the distance `y` from it.
    pub(super) fn time_from_turn(&self, centre: &Centre, y: f64) -> f64 {
        let pole = centre.c[1] / (4.0 * y);
        carlson_rf_pair(pole + centre.isolated, pole + centre.pair, self.h2)
    }

    /// The Mino time between two places (u, |u'|) without a turn between them: R_F of P less the
    /// roots, where P = (F(x, y) + |x'| |y'|)/(2 (x - y)^2) with the polarised form F of the quartic.
    ///
    /// On the two sides of the critical point that a ray lingers at, P less the mean of the pair is a
    /// small difference. With x and y relative to that point and C = alpha + beta (x + y)/2 + gamma
    /// x y, it follows without one from
    ///
    /// (|x'| |y'|)^2 - (x y C)^2 = b_0 (x'^2 + y'^2 - b_0) + (x y (x - y))^2 (alpha gamma - beta^2/4).
    pub(super) fn time_between(&self, [x, dx]: [f64; 2], [y, dy]: [f64; 2]) -> f64 {
        let (v_x, v_y, width2) = (x - self.base, y - self.base, (x - y) * (x - y));
        let product = v_x * v_y;
        if product < 0.0 {
            let middle = self.alpha + 0.5 * self.beta * (v_x + v_y) + self.gamma * product;
            let above = self.b_0 * (dx * dx + dy * dy - self.b_0)
                + product
                    * product
                    * width2
                    * (self.alpha * self.gamma - 0.25 * self.beta * self.beta);
            let below = dx * dy - product * middle;
            let pair = 0.5 * self.offset + 0.5 * (self.b_0 + above / below) / width2;
            let isolated = pair + 0.25 * self.alpha - 1.5 * self.offset;
            return carlson_rf_pair(isolated, pair, self.h2);
        }
        let polarised = 0.5 * self.p[2] * (x * y).powi(2)
            + 0.5 * self.k_prime * x * y * (x + y)
            + self.p[0] / 6.0 * (x * x + 4.0 * x * y + y * y)
            + self.energy * self.energy;
        let p = (polarised + dx * dy) / (2.0 * width2);
        let e = self.offset - self.alpha / 6.0;
        carlson_rf_pair(p - e, p + 0.5 * e, self.h2)
    }

    /// u at the Mino time `t` after a place with u and u', through turning points: Biermann's and
    /// Weierstrass's solution (Whittaker & Watson 1927 section 20.6).
    pub(super) fn u_after(&self, t: f64, [u, du]: [f64; 2]) -> f64 {
        let v = u - self.base;
        let mean = self.alpha / 12.0 - 0.5 * self.offset;
        let [above, dp] = weierstrass(t, mean, self.h2);
        // Next to the critical curve U''/24 is close to the pair's mean.
        let x = above - 0.5 * self.offset - v * (0.25 * self.beta + 0.5 * self.gamma * v);
        let f = du * du;
        let half_first = v * (self.alpha + v * (1.5 * self.beta + v * 2.0 * self.gamma));
        let quarter_third = 0.25 * self.beta + self.gamma * v;
        u + (half_first * x + f * quarter_third - du * dp) / (2.0 * x * x - 0.5 * f * self.gamma)
    }

    /// The dragging of the azimuth per Mino time: -a u (E - a L u)/D.
    pub(super) fn dragging(&self, u: f64) -> f64 {
        -self.a * u * (self.energy - self.a * self.angular_momentum * u) / self.denominator(u)
    }

    /// D, whose factors keep their digits next to the horizon.
    fn denominator(&self, u: f64) -> f64 {
        let [outer, inner] = self.horizons;
        (1.0 - outer * u) * (1.0 - inner * u)
    }
}

impl Centre {
    /// dtau/dx at u = centre - side x^2.
    pub(super) fn weight(&self, x: f64) -> f64 {
        let y = x * x;
        let [c0, c1, c2, c3, c4] = self.c;
        2.0 / (c0 / y + c1 + y * (c2 + y * (c3 + y * c4))).sqrt()
    }
}
