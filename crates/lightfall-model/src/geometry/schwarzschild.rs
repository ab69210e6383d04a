//! Closed forms for light around a hole without spin. The twin in WGSL is
//! shaders/method/closed.wgsl.
//!
//! The orbit obeys (du/dphi)^2 = 1/b^2 - u^2 + u^3 with u = 1/r (Darwin 1959; r_s = 1). Its kind
//! depends on D = b_c^2/b^2 - 1, with b_c^2 = 27/4: an orbit with D > 0 plunges into the hole, and
//! one with D < 0 has turning points.

pub mod rain_sky;

use glam::DVec3;

/// b_c = 3 sqrt(3) / 2, the impact parameter of the photon sphere, in r_s.
pub const CRITICAL_IMPACT: f64 = 2.598_076_211_353_316;

/// The edge of the shadow on an observer's sky. The *margin* of a photon, `radial - c E`, is
/// positive in the shadow, negative in the rest of the sky, and zero on the edge.
///
/// By the null condition E^2 = radial^2 + (1 - u)|w|^2, u = 1/r,
///
/// (1 - u)|w|^2 D = radial^2 - C E^2 = (radial - c E)(radial + c E),   C = c^2 = (27/4)(u - 2/3)^2
/// (u + 1/3),
///
/// and c = (3 sqrt(3)/2)(2/3 - u) sqrt(u + 1/3) is negative inside the photon sphere. So on both
/// sides of the photon sphere the first factor is positive for light from the horizon and negative
/// for light from the sky. It is linear in (1, d), d being the looking direction, so the edge is a
/// circle on every observer's sky. Derived.
///
/// The margin is given by its expansion about the center of the shadow or of the rest of the sky,
/// whichever is smaller: margin_at_center + curvature |d - center|^2/2 for unit d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadowEdge {
    /// c = radial/E on the edge.
    pub critical_radial: f64,
    /// The center of the expansion: a unit vector on the observer's axes.
    pub center: DVec3,
    /// The margin at the center.
    pub margin_at_center: f64,
    /// The coefficient of |d - center|^2/2 in the margin.
    pub curvature: f64,
}

impl ShadowEdge {
    /// The edge for the observer at radius `r` (r_s) whose matrix, for a hole without spin, has the
    /// rows `energy` and `radial`.
    ///
    /// Let the margin be a + B.d. Then B^2 - a^2 is the same for all observers at a place, and for
    /// the observer at rest it is (1 - u)(1 - C) = ((1 - u) b_c u)^2. So the sine of the edge's
    /// angular radius is (1 - u) b_c u/|B|, without cancellation however small it is.
    pub fn new(energy: [f64; 4], radial: [f64; 4], r: f64) -> Self {
        let u = 1.0 / r;
        let c = CRITICAL_IMPACT * (2.0 / 3.0 - u) * (u + 1.0 / 3.0).sqrt();
        let [a, slope @ ..]: [f64; 4] = std::array::from_fn(|i| radial[i] - c * energy[i]);
        let slope = DVec3::from_array(slope);
        let (steepness, depth) = (slope.length(), (1.0 - u) * CRITICAL_IMPACT * u);
        // The shadow is smaller than the rest of the sky where a is negative. Then its center is
        // the direction of the largest margin.
        let side = if a < 0.0 { 1.0 } else { -1.0 };
        let margin_at_center = side * depth * depth / (steepness + a.abs());
        Self {
            critical_radial: c,
            center: side * slope.normalize_or_zero(),
            margin_at_center,
            curvature: -side * steepness,
        }
    }
}

/// Angular radius of the shadow, in radians from the inward direction, for an observer at rest at
/// `r` > 1: sin^2 = (27/4)(1 - 1/r)/r^2 (Synge 1966), with cos = (1 - 3/(2r)) sqrt(1 + 3/r) for the
/// quadrant.
pub fn shadow_half_angle_static(r: f64) -> f64 {
    let sine = CRITICAL_IMPACT / r * (1.0 - 1.0 / r).sqrt();
    let cosine = (1.0 - 1.5 / r) * (1.0 + 3.0 / r).sqrt();
    sine.atan2(cosine)
}

/// Angular radius of the shadow, in radians from the inward direction, for an observer in free fall
/// from rest at infinity, at any `r` > 0.
///
/// With beta = 1/sqrt(r), a ray at the angle alpha has b = r sin(alpha) / (1 - beta cos(alpha)).
/// Solving b = b_c gives cos(alpha) = (b_c^2 beta + r (r - 3/2) sqrt(1 + 3/r)) / (r^2 + b_c^2
/// beta^2), where r - 3/2 without its absolute value chooses the right root on both sides of the
/// photon sphere. Derived.
pub fn shadow_half_angle_rain(r: f64) -> f64 {
    let beta = 1.0 / r.sqrt();
    let b2 = CRITICAL_IMPACT * CRITICAL_IMPACT;
    let cosine = (b2 * beta + r * (r - 1.5) * (1.0 + 3.0 / r).sqrt()) / (r * r + b2 * beta * beta);
    let sine = CRITICAL_IMPACT / r * (1.0 - beta * cosine);
    sine.atan2(cosine)
}
