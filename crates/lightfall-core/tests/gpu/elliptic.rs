//! Elliptic functions of the shaders against f64.

use crate::gpu;
use glam::{Vec2, Vec4};
use lightfall_core::gpu::bindings::{INPUT, OUTPUT};
use lightfall_core::gpu::kernel::ArrayKernel;

/// The functions, with an entry point that maps each `vec4` `v` to the `vec2` `expression`.
fn kernel(expression: &str) -> String {
    let functions = include_str!("../../../../shaders/elliptic.wgsl");
    format!(
        "{functions}
         @group(0) @binding({INPUT}) var<storage, read> given: array<vec4<f32>>;
         @group(0) @binding({OUTPUT}) var<storage, read_write> found: array<vec2<f32>>;
         @compute @workgroup_size(64) fn apply(@builtin(global_invocation_id) id: vec3<u32>) {{
             if id.x < arrayLength(&given) {{
                 let v = given[id.x];
                 found[id.x] = {expression};
             }}
         }}"
    )
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_symmetric_integral_agrees_with_the_one_in_f64_for_a_real_pair() {
    let gpu = gpu();
    let kernel = ArrayKernel::new(
        gpu,
        &kernel("vec2<f32>(carlson_rf_pair(v.x, v.y, v.z), 0.0)"),
        "apply",
        &[],
    )
    .unwrap();
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
    let found: Vec<Vec2> = kernel.run(gpu, &given).unwrap();
    for (given, found) in given.iter().zip(found) {
        let [x, mean, h2] = [given.x, given.y, given.z].map(f64::from);
        let truth = ellip::elliprf(x, mean + h2.sqrt(), mean - h2.sqrt()).unwrap();
        // Measured 2.5e-7 on the software adapter: rounding, and truncation after three
        // duplications. Other adapters' division and roots may be a few units in the last place
        // off.
        assert!(
            (f64::from(found.x) / truth - 1.0).abs() < 8e-7,
            "{given}: {} against {truth}",
            found.x
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_symmetric_integral_agrees_with_a_quadrature_for_a_conjugate_pair() {
    let gpu = gpu();
    let kernel = ArrayKernel::new(
        gpu,
        &kernel("vec2<f32>(carlson_rf_pair(v.x, v.y, v.z), 0.0)"),
        "apply",
        &[],
    )
    .unwrap();
    let pairs = [
        (1.0, -0.3),
        (0.5, -0.01),
        (0.02, -0.2),
        (-0.05, -0.09),
        (-0.3, -0.5),
        (3.0, -40.0),
    ];
    let given: Vec<Vec4> = pairs
        .iter()
        .map(|&(mean, h2)| Vec4::new(1.0, mean, h2, 0.0))
        .collect();
    let found: Vec<Vec2> = kernel.run(gpu, &given).unwrap();
    for (given, found) in given.iter().zip(found) {
        let [x, mean, h2] = [given.x, given.y, given.z].map(f64::from);
        // (1/2) integral over t > 0 of dt / sqrt((t + x) ((t + mean)^2 - h2)), with t = exp(s): the
        // trapezoidal rule converges exponentially on an integrand that dies out at both ends.
        let step = 0.01;
        let sum: f64 = (-6000..6000)
            .map(|i| (f64::from(i) * step).exp())
            .map(|t| t / ((t + x) * ((t + mean).powi(2) - h2)).sqrt())
            .sum();
        let truth = 0.5 * step * sum;
        // Measured 7e-8; the tolerance is that of the real pair.
        assert!(
            (f64::from(found.x) / truth - 1.0).abs() < 8e-7,
            "{given}: {} against {truth}",
            found.x
        );
    }
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
    let gpu = gpu();
    let source = kernel("vec2<f32>(weierstrass(v.x, v.y).even, weierstrass(v.x, v.y).odd)");
    let kernel = ArrayKernel::new(gpu, &source, "apply", &[]).unwrap();
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
    let found: Vec<Vec2> = kernel.run(gpu, &given).unwrap();
    for (given, found) in given.iter().zip(found) {
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
