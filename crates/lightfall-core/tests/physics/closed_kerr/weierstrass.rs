//! Weierstrass's elliptic function, less the mean of two of its roots.

use crate::random::Random;

/// Arguments below this, in units of the invariants' own scale, are left to the series. Each
/// duplication costs digits.
const SERIES_REACH: f64 = 0.8;
/// Terms of Laurent's series.
const TERMS: usize = 20;

/// P(z) - m and P'(z) for z > 0, where the cubic's roots are -2 m and m +- sqrt(h2).
///
/// Laurent's series (DLMF 23.9.2 to 23.9.5) at z/2^k, then k duplications. If the pair is close, P
/// approaches m with growing z. So the duplication has x = P - m in place of P: with a = x^2 - h2
/// and g = x + 3 m, P'^2 = 4 a g and
///
/// x(2 z) = a/(4 g) + h2 g/a,   P'(2 z) = (1/2) P'(z) (2 x g - a) (1/(4 g^2) - h2/a^2).
///
/// This is P(2 z) - e = ((P - e)^2 - (e - e') (e - e''))^2/P'^2 for a root e of the pair. Derived.
pub(super) fn weierstrass(z: f64, m: f64, h2: f64) -> [f64; 2] {
    let (g2, g3) = (12.0 * m * m + 4.0 * h2, -8.0 * m * (m * m - h2));
    let scale = g2.abs().sqrt().sqrt().max(g3.abs().cbrt().sqrt());
    let doublings = (z * scale / SERIES_REACH).log2().ceil().max(0.0) as i32;
    let z = z / 2.0_f64.powi(doublings);
    let mut c = [0.0; TERMS];
    (c[2], c[3]) = (g2 / 20.0, g3 / 28.0);
    for k in 4..TERMS {
        let sum: f64 = (2..=k - 2).map(|j| c[j] * c[k - j]).sum();
        let order = k as f64;
        c[k] = 3.0 * sum / ((2.0 * order + 1.0) * (order - 3.0));
    }
    let z2 = z * z;
    let (mut x, mut slope) = (1.0 / z2 - m, -2.0 / (z2 * z));
    for (k, c) in c.iter().enumerate().skip(2) {
        let power = z2.powi(k as i32 - 1);
        x += c * power;
        slope += (2.0 * k as f64 - 2.0) * c * power / z;
    }
    for _ in 0..doublings {
        let (a, g) = (x * x - h2, x + 3.0 * m);
        slope *= 0.5 * (2.0 * x * g - a) * (0.25 / (g * g) - h2 / (a * a));
        x = 0.25 * a / g + h2 * g / a;
    }
    [x, slope]
}

/// P'^2 = 4 P^3 - g2 P - g3, and the homogeneity of P: two independent identities.
#[test]
fn weierstrass_function_of_random_numbers_obeys_its_equation_and_scales() {
    let mut random = Random::new();
    for _ in 0..1000 {
        let (z, m, h2) = (
            random.between(0.01, 2.0),
            random.between(-0.3, 0.3),
            random.between(-0.3, 0.3),
        );
        let [x, dp] = weierstrass(z, m, h2);
        let (p, g2, g3) = (x + m, 12.0 * m * m + 4.0 * h2, -8.0 * m * (m * m - h2));
        let right = 4.0 * p.powi(3) - g2 * p - g3;
        let scale = 4.0 * p.abs().powi(3) + (g2 * p).abs() + g3.abs();
        assert!(
            (dp * dp - right).abs() < 1e-10 * scale,
            "{z} {m} {h2}: {p} {dp}"
        );
        let t = random.between(0.5, 2.0);
        let [y, dq] = weierstrass(t * z, m / (t * t), h2 / t.powi(4));
        assert!(
            (y * t * t - x).abs() < 1e-9 * p.abs().max(1.0),
            "{z} {m} {h2}"
        );
        assert!(
            (dq * t.powi(3) - dp).abs() < 1e-8 * dp.abs().max(1.0),
            "{z} {m} {h2}"
        );
    }
}

/// Where the pair is one root, P - m = 3 m/sinh^2(sqrt(3 m) z). It keeps its digits for long times.
#[test]
fn weierstrass_function_of_random_numbers_keeps_its_digits_next_to_a_double_root() {
    let mut random = Random::new();
    for _ in 0..1000 {
        let (m, phase) = (random.log_between(1e-3, 10.0), random.between(0.1, 20.0));
        let root = (3.0 * m).sqrt();
        let [x, dp] = weierstrass(phase / root, m, 0.0);
        let truth = 3.0 * m / phase.sinh().powi(2);
        let slope = -2.0 * root * truth / phase.tanh();
        assert!((x / truth - 1.0).abs() < 1e-12, "{m} {phase}: {x} {truth}");
        assert!(
            (dp / slope - 1.0).abs() < 1e-12,
            "{m} {phase}: {dp} {slope}"
        );
    }
}
