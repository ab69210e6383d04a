//! The deflection of light from infinity around a hole without spin, and the turning points of its
//! orbits, in closed form.

use lightfall_core::geometry::elliptic::carlson_rf_pair;
use lightfall_core::geometry::schwarzschild::CRITICAL_IMPACT;
use std::f64::consts::{FRAC_PI_3, PI};

/// The roots u1 < 0 < u2 <= 2/3 <= u3 of the cubic 1/b^2 - u^2 + u^3, of which u2 is the turning
/// point of light from afar; u32 = u3 - u2 and u21 = u2 - u1.
///
/// With eta = (2/3) arcsin(b_c/b) and eps = pi/3 - eta = (2/3) arcsin(sqrt(-D)), the cubic's
/// trigonometric solution gives u3 - u2 = (2/sqrt 3) sin eps, u2 - u1 = (2/sqrt 3) sin eta, and
/// u1,2 = (2/3) sin^2(eta/2) -+ sin(eta)/sqrt 3. The smaller of eta and eps is computed directly, so
/// both limits are accurate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Roots {
    u1: f64,
    pub(crate) u2: f64,
    pub(crate) u32: f64,
    pub(crate) u21: f64,
}

/// Deflection, in radians, of light that comes from infinity with impact parameter `b` (r_s) and
/// returns there. `None` if it is captured.
///
/// It is 4 sqrt(u2) R_F(-u1 u32, u21 u32, u21 u3) - pi. Derived from Darwin 1959 and DLMF 19.29.4.
pub(crate) fn deflection(b: f64) -> Option<f64> {
    let Roots { u1, u2, u32, u21 } = Roots::of(b.abs())?;
    // The first two arguments are the pair: both vanish at the critical impact parameter.
    let (mean, half_gap) = (0.5 * u32 * (u21 - u1), 0.5 * u32 * (u21 + u1));
    let rf = carlson_rf_pair(u21 * (u2 + u32), mean, half_gap * half_gap);
    Some(4.0 * u2.sqrt() * rf - PI)
}

impl Roots {
    /// The roots for the impact parameter `b` > 0; `None` for rays without a turning point.
    pub(crate) fn of(b: f64) -> Option<Self> {
        // D = (b_c - b)(b_c + b) / b^2.
        let d = (CRITICAL_IMPACT - b) * (CRITICAL_IMPACT + b) / (b * b);
        if d.is_nan() || d >= 0.0 {
            return None;
        }
        let (eta, eps) = if d < -0.5 {
            let eta = 2.0 / 3.0 * (CRITICAL_IMPACT / b).asin();
            (eta, FRAC_PI_3 - eta)
        } else {
            let eps = 2.0 / 3.0 * (-d).sqrt().asin();
            (FRAC_PI_3 - eps, eps)
        };
        let third = 1.0 / 3.0_f64.sqrt();
        let even = 2.0 / 3.0 * (eta / 2.0).sin().powi(2);
        let (u1, u2) = (even - third * eta.sin(), even + third * eta.sin());
        let (u32, u21) = (2.0 * third * eps.sin(), 2.0 * third * eta.sin());
        Some(Self { u1, u2, u32, u21 })
    }
}
