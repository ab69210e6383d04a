//! The source function of a scattering layer between two faces that both radiate.

use lightfall_model::geometry::quadrature::integral;

/// The source function over F/pi, without the scale of [`emission_scale`], where the layer has the
/// optical depth `depth` in all, and `from_face` = t_up t_down/(t_up + t_down) of the depths of the
/// two faces.
///
/// The limb law 0.41344 + 0.1137 sqrt(mu) + 0.7434 mu of the thin disk is the Laplace transform of
/// b + d sqrt(t) + c t with d = 0.1137/Gamma(3/2), so an opaque layer shows this law. `from_face` is
/// the depth in the energy balance of a slab (Hubeny 1990, ApJ 351, 632), and the last term lets a
/// thin layer radiate as much.
pub fn scattering_source(from_face: f64, depth: f64) -> f64 {
    0.41344 + 0.12829 * from_face.max(0.0).sqrt() + 0.7434 * from_face + 0.5 / depth
}

/// The factor by which [`scattering_source`] is multiplied, so that each face of the layer emits
/// the flux F.
pub fn emission_scale(depth: f64) -> f64 {
    // Each face emits the integral of S(t) E_2(t): E_2 is the integral of e^(-t/mu) over mu.
    let face = |t: f64| scattering_source(t * (depth - t) / depth, depth) * exponential_integral(t);
    // Depths as squares take the root out of the source near the first face, and symmetry the one
    // near the second.
    let half = 0.5 * depth;
    let near = |x: f64| 2.0 * x * face(x * x);
    let far = |x: f64| 2.0 * x * face(depth - x * x);
    let flux = 2.0 * (integral(0.0, half.sqrt(), &near) + integral(0.0, half.sqrt(), &far));
    1.0 / flux
}

/// E_2(t), the integral of e^(-t/mu) for mu from 0 to 1: e^(-t) - t E_1(t) (Abramowitz & Stegun 1964,
/// 5.1.14).
fn exponential_integral(t: f64) -> f64 {
    if t <= 0.0 {
        return 1.0;
    }
    if t > 700.0 {
        return 0.0;
    }
    (-t).exp() - t * first_exponential_integral(t)
}

/// E_1(t) for positive t, by its series or continued fraction (the same, 5.1.11 and 5.1.22).
fn first_exponential_integral(t: f64) -> f64 {
    const EULER: f64 = 0.577_215_664_901_532_9;
    const TERMS: i32 = 60;
    if t < 2.0 {
        let (mut term, mut sum) = (1.0, 0.0);
        for k in 1..TERMS {
            term *= -t / f64::from(k);
            sum -= term / f64::from(k);
        }
        return sum - EULER - t.ln();
    }
    let fraction = (1..TERMS).rev().fold(0.0, |rest, k| {
        let k = f64::from(k);
        k / (1.0 + k / (t + rest))
    });
    (-t).exp() / (t + fraction)
}
