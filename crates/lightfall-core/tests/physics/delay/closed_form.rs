//! The travel time of light around a hole without spin. The twin in WGSL is
//! shaders/delay/closed.wgsl.
//!
//! The Hamilton-Jacobi action is constant along a null ray, so E dt = L dphi + p_r dr. With s(u) =
//! sqrt(1 - b^2 u^2 (1 - u)) = b |du/dphi| and the tortoise coordinate r*(u) = 1/u + ln|1/u - 1|,
//! the time is b phi plus, for each leg on which r does not turn,
//!
//! |r*(u_a) - r*(u_b)| - b^2 J(u_a, u_b),   J(u_a, u_b) = integral of du/(1 + s(u)),   u_a < u_b.
//!
//! The integrand of J lies between 1/2 and 1. Derived.

use crate::light_without_spin::Roots;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::quadrature::integral;
use lightfall_core::geometry::schwarzschild::CRITICAL_IMPACT;

/// u of the photon sphere, where s(u) of rays next to the critical curve has a kink.
const PHOTON_SPHERE: f64 = 2.0 / 3.0;

/// The radial direction of a backward ray from the camera to a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// Inward.
    In,
    /// Inward, and outward again after the turning point.
    InAndOut,
    /// Outward.
    Out,
}

/// The camera's time less the Boyer-Lindquist time, in r_s/c, at which light with the impact
/// parameter `b` (r_s) left the place `u` = 1/r. Its backward ray comes there from `camera_u` on
/// this `way` and sweeps the angle `phi` (radians). The camera's time is Boyer-Lindquist's outside
/// the horizon, and Kerr's ingoing one at and inside it. Rays with a turning point lie outside it.
pub(super) fn lag(b: f64, phi: f64, camera_u: f64, u: f64, way: Way) -> f64 {
    let tortoise = |u: f64| Kerr { spin: 0.0 }.ingoing_time_lead(1.0 / u);
    let lead = if camera_u < 1.0 {
        tortoise(camera_u)
    } else {
        0.0
    };
    let (ends, length) = match way {
        Way::In => (lead - tortoise(u), leg(b, camera_u, u)),
        Way::Out => (tortoise(u) - lead, leg(b, u, camera_u)),
        Way::InAndOut => {
            let turn = Roots::of(b)
                .expect("a ray that turns has a turning point")
                .u2;
            (
                lead + tortoise(u) - 2.0 * tortoise(turn),
                leg(b, camera_u, turn) + leg(b, u, turn),
            )
        }
    };
    b * phi + ends - b * b * length
}

fn leg(b: f64, from: f64, to: f64) -> f64 {
    if let Some(roots) = Roots::of(b) {
        return turning_leg(b, roots, from, to);
    }
    // s^2, without the small difference next to the critical curve.
    let depth = (CRITICAL_IMPACT - b) * (CRITICAL_IMPACT + b) / CRITICAL_IMPACT.powi(2);
    let f = |u: f64| {
        let bend = (b * (u - PHOTON_SPHERE)).powi(2) * (u + 1.0 / 3.0);
        1.0 / (1.0 + (depth + bend).max(0.0).sqrt())
    };
    let middle = PHOTON_SPHERE.clamp(from, to);
    integral(from, middle, &f) + integral(middle, to, &f)
}

/// J(from, to) outside the turning point. u = u2 - span x^2 removes the root of s.
fn turning_leg(b: f64, Roots { u2, u32, u21, .. }: Roots, from: f64, to: f64) -> f64 {
    let span = u2 - from;
    let f = |x: f64| {
        let depth = span * x * x;
        let s = b * x * (span * (u32 + depth) * (u21 - depth)).max(0.0).sqrt();
        x / (1.0 + s)
    };
    let start = ((u2 - to) / span).clamp(0.0, 1.0).sqrt();
    2.0 * span * integral(start, 1.0, &f)
}
