//! Weierstrass's elliptic function.

/// Arguments below this, in units of the invariants' own scale, are left to the series. Each
/// duplication costs digits.
const SERIES_REACH: f64 = 0.8;
/// Terms of Laurent's series.
const TERMS: usize = 20;

/// P(z; g2, g3) and P'(z; g2, g3) for z > 0: Laurent's series (DLMF 23.9.2 to 23.9.5) at z/2^k,
/// then k duplications (DLMF 23.10.7; the tangent's third point has -P' of the double).
#[must_use]
pub fn weierstrass(z: f64, g2: f64, g3: f64) -> [f64; 2] {
    let scale = g2.abs().sqrt().sqrt().max(g3.abs().cbrt().sqrt());
    let doublings = (z * scale / SERIES_REACH).log2().ceil().max(0.0) as i32;
    let z = z / 2.0_f64.powi(doublings);
    let mut c = [0.0; TERMS];
    (c[2], c[3]) = (g2 / 20.0, g3 / 28.0);
    for k in 4..TERMS {
        let sum: f64 = (2..=k - 2).map(|m| c[m] * c[k - m]).sum();
        let order = k as f64;
        c[k] = 3.0 * sum / ((2.0 * order + 1.0) * (order - 3.0));
    }
    let z2 = z * z;
    let (mut p, mut dp) = (1.0 / z2, -2.0 / (z2 * z));
    for (k, c) in c.iter().enumerate().skip(2) {
        let power = z2.powi(k as i32 - 1);
        p += c * power;
        dp += (2.0 * k as f64 - 2.0) * c * power / z;
    }
    for _ in 0..doublings {
        let slope = (6.0 * p * p - 0.5 * g2) / dp;
        let double = 0.25 * slope * slope - 2.0 * p;
        dp = -(dp + slope * (double - p));
        p = double;
    }
    [p, dp]
}
