// Elliptic functions for cubics with one known real root and a pair of roots that is real or
// conjugate. A pair is given by its mean and the square of half its difference, which are always
// real, so one function serves both cases.
//
// Gives: LaurentSeries, carlson_rf_pair, laurent_series, weierstrass, weierstrass_of.

// Maximum number of duplications: enough for a relative error of 5e-7 down to |D| = 1e-6. The
// series is as accurate as f32 once its arguments differ by less than an eighth of their mean.
const DUPLICATIONS: u32 = 3u;

// Carlson's R_F(x, y, z) for x > 0, with y, z = mean +- sqrt(h2); the twin in f64 is
// geometry/elliptic.rs. If h2 < 0 the pair is conjugate, and mean may be negative. Each duplication
// (DLMF 19.26.18) takes two square roots:
//
//   p = sqrt(mean^2 - h2),   lambda = sqrt(2 x (mean + p)) + p,
//   x, mean -> (. + lambda) / 4,   h2 -> h2 / 16.
//
// Then follows the series of DLMF 19.36.1. After the first duplication mean is positive, because
// p >= |mean| where h2 < 0.
fn carlson_rf_pair(x0: f32, mean0: f32, h20: f32) -> f32 {
    let p0 = sqrt(max(mean0 * mean0 - h20, 0.0));
    let sum0 = select(mean0 + p0, -h20 / (p0 - mean0), mean0 < 0.0);
    let lambda0 = sqrt(2.0 * x0 * sum0) + p0;
    var x = 0.25 * (x0 + lambda0);
    var mean = 0.25 * (mean0 + lambda0);
    var h2 = 0.0625 * h20;
    for (var i = 1u; i < DUPLICATIONS; i++) {
        if abs(x - mean) < 0.125 * mean && abs(h2) < 0.004 * mean * mean {
            break;
        }
        let p = sqrt(max(mean * mean - h2, 0.0));
        let lambda = sqrt(2.0 * x * (mean + p)) + p;
        x = 0.25 * (x + lambda);
        mean = 0.25 * (mean + lambda);
        h2 *= 0.0625;
    }
    let a = (x + 2.0 * mean) * (1.0 / 3.0);
    let root = inverseSqrt(a);
    let inverse_a = root * root;
    // The spread of x is -2 s; those of the pair are s +- sqrt(h2) / a.
    let s = (a - mean) * inverse_a;
    let product = s * s - h2 * inverse_a * inverse_a;
    let e2 = product - 4.0 * s * s;
    let e3 = -2.0 * s * product;
    let series = 1.0 + e2 * (-0.1 + e2 * ((1.0 / 24.0) - (5.0 / 208.0) * e2) - (3.0 / 44.0) * e3)
        + e3 * ((1.0 / 14.0) + (3.0 / 104.0) * e3);
    return series * root;
}

// Weierstrass's function P(z) = (1 + even) / z^2, and its derivative -2 (1 + odd) / z^3.
struct Weierstrass {
    even: f32,
    odd: f32,
}

// P(z; g2, g3) with g2 = 1/12, the value of every null orbit, for 0 <= z <= pi and orbits that stay
// finite there: Laurent's series (DLMF section 23.9) at z/2, then one duplication (section
// 23.10(ii)), both relative to the poles, so that nothing cancels.
fn weierstrass(z: f32, g3: f32) -> Weierstrass {
    const C2: f32 = 1.0 / 240.0;
    const C4: f32 = 1.0 / 172800.0;
    let c3 = g3 * (1.0 / 28.0);
    let c5 = c3 * (1.0 / 880.0);
    let c6 = (2.0 / (13.0 * 240.0 * 172800.0)) + (1.0 / 13.0) * c3 * c3;
    let c7 = c3 * (1.0 / 950400.0);
    let c8 = (3.0 / 85.0) * (2.0 * C2 * c6 + 2.0 * c3 * c5 + C4 * C4);
    let y = 0.25 * z * z;
    let y2 = y * y;
    let even = y2 * (C2 + y * (c3 + y * (C4 + y * (c5 + y * (c6 + y * (c7 + y * c8))))));
    let odd = -y2
        * (C2 + y * (2.0 * c3 + y * (3.0 * C4 + y * (4.0 * c5 + y * (5.0 * c6 + y * (6.0 * c7 + y * 7.0 * c8))))));
    // -P'' / P' at z/2 is (6 / z) (1 + slope).
    let slope = (even * (2.0 + even) - y2 * (1.0 / 144.0) - odd) / (1.0 + odd);
    let twice = 9.0 * slope * (2.0 + slope) - 8.0 * even;
    return Weierstrass(twice, 9.0 * slope - 8.0 * odd + (1.0 + slope) * (12.0 * even - 3.0 * twice));
}

// Laurent's series of P(z; g2, g3) about its pole, for any invariants.
struct LaurentSeries {
    g2: f32,
    // The coefficients of z^4, z^6, ..., z^16 in z^2 P(z) - 1.
    low: vec4<f32>,
    high: vec3<f32>,
    // 1/z up to which the series is accurate to rounding.
    reach: f32,
}

fn laurent_series(g2: f32, g3: f32) -> LaurentSeries {
    let c2 = g2 * (1.0 / 20.0);
    let c3 = g3 * (1.0 / 28.0);
    let c4 = c2 * c2 * (1.0 / 3.0);
    let c5 = c2 * c3 * (3.0 / 11.0);
    let c6 = (2.0 * c2 * c4 + c3 * c3) * (1.0 / 13.0);
    let c7 = (c2 * c5 + c3 * c4) * 0.1;
    let c8 = (3.0 / 85.0) * (2.0 * c2 * c6 + 2.0 * c3 * c5 + c4 * c4);
    let reach = 1.2 * max(sqrt(sqrt(abs(g2))), exp2(log2(max(abs(g3), 1e-30)) * (1.0 / 6.0)));
    return LaurentSeries(g2, vec4<f32>(c2, c3, c4, c5), vec3<f32>(c6, c7, c8), reach);
}

// P(z; g2, g3): the series at z/2^k, then k duplications.
fn weierstrass_of(series: LaurentSeries, z: f32) -> Weierstrass {
    let doublings = u32(clamp(ceil(log2(max(z * series.reach, 1e-30))), 0.0, 6.0));
    let a = series.low;
    let b = series.high;
    var y = z * z * exp2(-2.0 * f32(doublings));
    let y2 = y * y;
    var even = y2 * (a.x + y * (a.y + y * (a.z + y * (a.w + y * (b.x + y * (b.y + y * b.z))))));
    var odd = -y2
        * (a.x + y * (2.0 * a.y + y * (3.0 * a.z + y * (4.0 * a.w + y * (5.0 * b.x + y * (6.0 * b.y + y * 7.0 * b.z))))));
    for (var i = 0u; i < doublings; i++) {
        let slope = (even * (2.0 + even) - y * y * series.g2 * (1.0 / 12.0) - odd) / (1.0 + odd);
        let twice = 9.0 * slope * (2.0 + slope) - 8.0 * even;
        odd = 9.0 * slope - 8.0 * odd + (1.0 + slope) * (12.0 * even - 3.0 * twice);
        even = twice;
        y *= 4.0;
    }
    return Weierstrass(even, odd);
}
