//! Weierstrass's elliptic function, from identities.

use crate::random::Random;
use lightfall_core::geometry::elliptic::weierstrass;

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
