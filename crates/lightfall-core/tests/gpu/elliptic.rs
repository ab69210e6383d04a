//! Elliptic functions of the shaders against f64.

use crate::functions::value_of_functions;
use glam::Vec4;

/// Carlson's integral as the shader finds it, against its `truth` for (x, mean, h2).
///
/// Measured 2.5e-7 on the software adapter: rounding, and truncation after three duplications. Other
/// adapters' division and roots may be a few units in the last place off.
fn assert_symmetric_integral(given: &[Vec4], truth: impl Fn(f64, f64, f64) -> f64) {
    let integral = "vec4<f32>(carlson_rf_pair(given.x, given.y, given.z))";
    for (given, found) in given.iter().zip(value_of_functions(integral, given)) {
        let [x, mean, h2, _] = given.as_dvec4().to_array();
        let truth = truth(x, mean, h2);
        assert!(
            (f64::from(found.x) / truth - 1.0).abs() < 8e-7,
            "{given}: {} against {truth}",
            found.x
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_symmetric_integral_agrees_with_the_one_in_f64_for_a_real_pair() {
    // Pairs within a factor of four of each other, as those of orbits are, from as large as x to a
    // thousandth of it.
    let given: Vec<Vec4> = (0..4096_u32)
        .map(|i| {
            let x = 10.0_f64.powf(f64::from(i % 16) - 8.0);
            let mean = x * 10.0_f64.powf(-3.0 * f64::from(i / 16 % 16) / 15.0);
            let half_difference = 0.6 * mean * f64::from(i / 256) / 15.0;
            Vec4::new(
                x as f32,
                mean as f32,
                (half_difference * half_difference) as f32,
                0.0,
            )
        })
        .collect();
    assert_symmetric_integral(&given, |x, mean, h2| {
        ellip::elliprf(x, mean + h2.sqrt(), mean - h2.sqrt()).unwrap()
    });
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_symmetric_integral_agrees_with_a_quadrature_for_a_conjugate_pair() {
    let pairs = [
        (1.0, -0.3),
        (0.5, -0.01),
        (0.02, -0.2),
        (-0.05, -0.09),
        (-0.3, -0.5),
        (3.0, -40.0),
    ];
    let given = pairs.map(|(mean, h2)| Vec4::new(1.0, mean, h2, 0.0));
    assert_symmetric_integral(&given, |x, mean, h2| {
        // (1/2) integral over t > 0 of dt / sqrt((t + x) ((t + mean)^2 - h2)), with t = exp(s): the
        // trapezoidal rule converges exponentially on an integrand that dies out at both ends.
        let step = 0.01;
        let sum: f64 = (-6000..6000)
            .map(|i| (f64::from(i) * step).exp())
            .map(|t| t / ((t + x) * ((t + mean).powi(2) - h2)).sqrt())
            .sum();
        0.5 * step * sum
    });
}

/// (z^2 P - 1, -z^3 P' / 2 - 1) by 64 terms of Laurent's series, which converges as (z / 2 pi)^2 or
/// faster here.
fn weierstrass(z: f64, g3: f64) -> [f64; 2] {
    let mut c = [0.0; 64];
    (c[2], c[3]) = (1.0 / 240.0, g3 / 28.0);
    for k in 4..64 {
        let sum: f64 = (2..=k - 2).map(|m| c[m] * c[k - m]).sum();
        c[k] = 3.0 * sum / ((2 * k + 1) as f64 * (k as f64 - 3.0));
    }
    let term = |k: usize| c[k] * z.powi(2 * k as i32);
    [
        (2..64).map(term).sum(),
        (2..64).map(|k| -((k - 1) as f64) * term(k)).sum(),
    ]
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_weierstrass_function_agrees_with_its_whole_series_up_to_pi() {
    let function = "weierstrass(given.x, given.y)";
    let function = format!("vec4<f32>({function}.even, {function}.odd, 0.0, 0.0)");
    // g3 = 1/216 - 1/(16 b^2), from b infinite to b = 0.5.
    let given: Vec<Vec4> = (0..4096_u32)
        .map(|i| {
            let z = std::f64::consts::PI * f64::from(i % 64 + 1) / 64.0;
            let q = 4.0 * (f64::from(i / 64) / 63.0).powi(4);
            Vec4::new(z as f32, (1.0 / 216.0 - q / 16.0) as f32, 0.0, 0.0)
        })
        // For small b the lattice is small, too: the next pole stays at one and a half times the
        // distance.
        .filter(|v| v.x < 1.2 || v.y > -0.005)
        .collect();
    for (given, found) in given.iter().zip(value_of_functions(&function, &given)) {
        let [even, odd] = weierstrass(f64::from(given.x), f64::from(given.y));
        // Relative to the whole functions, in which the pole is the term 1: rounding, amplified by
        // the duplication. Measured: 4.5e-7.
        let errors = [
            (f64::from(found.x) - even) / (1.0 + even.abs()),
            (f64::from(found.y) - odd) / (1.0 + odd.abs()),
        ];
        assert!(
            errors.iter().all(|error| error.abs() < 1e-6),
            "{given}: {found} against {even}, {odd}"
        );
    }
}
