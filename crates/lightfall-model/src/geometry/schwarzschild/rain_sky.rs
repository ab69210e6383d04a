//! The sky of the observer `rain`, who falls from rest at infinity, around a hole without spin.
//! This observer's frame is regular at the horizon, so the same formulas hold at every radius.
//!
//! With v = sqrt(u), u = 1/r, a backward ray at the angle alpha from the outward direction has, per
//! unit frequency, E = 1 + v cos(alpha), Sigma p^r / r^2 = -(v + cos(alpha)) and |w| = sin(alpha)
//! (the rows of `rain` in geometry/observer/rows.rs). It reaches the sky if alpha is smaller than
//! the shadow's edge alpha_e. Its angle psi about the hole, from the observer to infinity, grows
//! with alpha and diverges like a logarithm at the edge.

use super::{CRITICAL_IMPACT, shadow_half_angle_rain};
use crate::geometry::elliptic::carlson_rf_pair;
use std::f64::consts::PI;

/// Maximum number of Newton's steps for a root of the orbit's cubic: from above they converge in
/// fewer than ten.
const MAX_STEPS: u32 = 40;

/// The rays from the sky to `rain` at one radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RainSky {
    u: f64,
    /// The observer's speed, sqrt(u).
    speed: f64,
    /// The edge of the shadow, in radians from the inward direction.
    shadow_half_angle: f64,
    /// c = radial/E on the edge of the shadow, as in [`ShadowEdge`](super::ShadowEdge).
    critical_radial: f64,
    /// (1 + c v) / (1 - u), which is regular at the horizon: 1 - c^2 u = (1 - u)(1 + (27/4) u^3).
    margin_slope: f64,
}

impl RainSky {
    /// The rays to the observer at radius `r` > 0 (r_s).
    pub fn new(r: f64) -> Self {
        let u = 1.0 / r;
        let speed = u.sqrt();
        let c = CRITICAL_IMPACT * (2.0 / 3.0 - u) * (u + 1.0 / 3.0).sqrt();
        Self {
            u,
            speed,
            shadow_half_angle: shadow_half_angle_rain(r),
            critical_radial: c,
            margin_slope: (1.0 + 6.75 * u.powi(3)) / (1.0 - c * speed),
        }
    }

    /// The angular radius of the shadow, in radians about the inward direction.
    pub fn shadow_half_angle(&self) -> f64 {
        self.shadow_half_angle
    }

    /// The largest angle from the edge of the shadow, straight outward.
    pub fn farthest(&self) -> f64 {
        PI - self.shadow_half_angle
    }

    /// psi, in radians, of the ray at the angle `off_edge` > 0 from the edge of the shadow. Beyond
    /// [`farthest`](Self::farthest), on the other side of the outward direction, it is negative.
    ///
    /// The discriminant D of the orbit is -(cos(alpha) - cos(alpha_e)) (radial + c E) (1 + c v) /
    /// ((1 - u) sin^2(alpha)), which is accurate however small `off_edge` is
    /// ([`ShadowEdge`](super::ShadowEdge)). Then psi is one R_F for a ray that moves outward, and
    /// two for one that turns (shaders/method/schwarzschild.wgsl has the forms).
    pub fn angle_to_infinity(&self, off_edge: f64) -> f64 {
        let theta = self.shadow_half_angle + off_edge;
        if theta > PI {
            return -self.angle_to_infinity(2.0 * self.farthest() - off_edge);
        }
        let (sin, cos) = (theta.sin(), -theta.cos());
        if sin <= 0.0 {
            return 0.0;
        }
        let (u, c) = (self.u, self.critical_radial);
        let energy = 1.0 + self.speed * cos;
        let radial = -(self.speed + cos);
        let inside_edge =
            2.0 * (self.shadow_half_angle + 0.5 * off_edge).sin() * (0.5 * off_edge).sin();
        let discriminant = -self.margin_slope * inside_edge * (radial + c * energy) / (sin * sin);
        let scale = u / sin;
        let (inverse_b, slope) = (energy * scale, radial * scale);
        let k = orbit_root(inverse_b);
        let t = 2.0 + 3.0 * k;
        // v / (1 + k), where v is the squared difference of the cubic's other two roots.
        let share = -4.0 * discriminant / (t * t);
        let v = share * (1.0 + k);
        let above = u + k;
        if slope > 0.0 {
            let gap = v.max(0.0).sqrt();
            let u2 = 2.0 * k * (1.0 + k) / (1.0 + k + gap);
            let rise = u2 + k;
            let rest = slope * slope / above;
            let d = 2.0 * rest / (gap + (gap * gap + 4.0 * rest).sqrt());
            let h = 0.5 * gap;
            let from_camera =
                d.sqrt() * carlson_rf_pair(rise * (gap + d), h * (rise + above), (h * d).powi(2));
            let to_turn =
                u2.sqrt() * carlson_rf_pair(rise * (u2 + gap), h * (rise + k), (h * u2).powi(2));
            return 2.0 * (from_camera + to_turn);
        }
        let (slope, root) = (-slope, (1.0 + k).sqrt());
        // 2 k - u. Near the critical orbit, k = 1/3, D is more precise; for small k, k is.
        let beyond = if k > 0.25 {
            2.0 / 3.0 - u - 2.0 / 3.0 * share
        } else {
            2.0 * k - u
        };
        let mean = 0.5 * (1.0 + k) * beyond * (2.0 * k + u) + 2.0 * k * root * slope;
        let x = k * (above * root + slope).powi(2) / above;
        2.0 * u * carlson_rf_pair(x, mean, 0.25 * u.powi(4) * v)
    }
}

/// k > 0 with k^2 (1 + k) = 1/b^2, where -k is a root of the orbit's cubic.
fn orbit_root(inverse_b: f64) -> f64 {
    let q = inverse_b * inverse_b;
    // Both are above the root, from where Newton's method descends.
    let mut k = inverse_b.min(q.cbrt());
    for _ in 0..MAX_STEPS {
        let next = (k * k * (2.0 * k + 1.0) + q) / (k * (3.0 * k + 2.0));
        if next >= k {
            break;
        }
        k = next;
    }
    k
}
