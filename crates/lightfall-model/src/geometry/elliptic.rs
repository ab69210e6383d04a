//! Carlson's symmetric elliptic integral of the first kind. The twin in WGSL is
//! shaders/elliptic.wgsl.

/// R_F(x, y, z) = (1/2) integral from 0 to infinity of dt / sqrt((t + x)(t + y)(t + z)) for x >= 0,
/// with y, z = mean +- sqrt(h2): two real arguments where `h2` >= 0, and a conjugate pair, whose
/// mean may be negative, where `h2` < 0. NaN where the integral does not exist.
///
/// Carlson's duplication theorem (DLMF 19.26.18) reduces the spread of the arguments, in terms of
/// the pair's mean and product: h2 is divided by 16, and lambda = sqrt(2 x (mean + p)) + p, where p
/// = sqrt(mean^2 - h2). Then the series of DLMF 19.36.1 gives the value. Its first omitted term is
/// of eighth order in the spread, which sets the bound on the spread.
pub fn carlson_rf_pair(x: f64, mean: f64, h2: f64) -> f64 {
    let (mut x, mut mean, mut h2) = (x, mean, h2);
    // Every duplication divides the spread by about four, and five hundred of them cover the whole
    // range of f64.
    for _ in 0..600 {
        let centre = (x + 2.0 * mean) / 3.0;
        // The spread of x is -2 s; those of the pair are s +- sqrt(h2) / centre.
        let s = (centre - mean) / centre;
        let product = s * s - h2 / (centre * centre);
        if s.abs() < 2e-3 && product.abs() < 1e-5 {
            let (e2, e3) = (product - 4.0 * s * s, -2.0 * s * product);
            let series = 1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0
                - 3.0 * e2 * e3 / 44.0
                - 5.0 * e2.powi(3) / 208.0
                + 3.0 * e3 * e3 / 104.0
                + e2 * e2 * e3 / 16.0;
            return series / centre.sqrt();
        }
        let p = (mean * mean - h2).max(0.0).sqrt();
        // mean + p, without cancellation where the mean is negative.
        let sum = if mean < 0.0 {
            -h2 / (p - mean)
        } else {
            mean + p
        };
        let lambda = (2.0 * x * sum).sqrt() + p;
        (x, mean, h2) = (0.25 * (x + lambda), 0.25 * (mean + lambda), h2 / 16.0);
    }
    f64::NAN
}
