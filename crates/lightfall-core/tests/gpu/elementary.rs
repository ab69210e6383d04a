//! The shaders' elementary functions against those of f64.

use crate::gpu;
use glam::{Vec2, Vec4};
use lightfall_core::gpu::Gpu;
use lightfall_core::gpu::bindings::{INPUT, OUTPUT};
use lightfall_core::gpu::kernel::ArrayKernel;

/// A kernel that evaluates a WGSL expression of `given`, with the types of `given` and of the
/// answer.
fn of_each(gpu: &Gpu, expression: &str, [given, answer]: [&str; 2]) -> ArrayKernel {
    let elementary = include_str!("../../../../shaders/elementary.wgsl");
    let source = format!(
        "const PI: f32 = 3.14159265358979; const TINY: f32 = 1e-30;
         {elementary}
         @group(0) @binding({INPUT}) var<storage, read> inputs: array<{given}>;
         @group(0) @binding({OUTPUT}) var<storage, read_write> answers: array<{answer}>;
         @compute @workgroup_size(64) fn of_each(@builtin(global_invocation_id) id: vec3<u32>) {{
             if id.x < arrayLength(&inputs) {{
                 let given = inputs[id.x];
                 answers[id.x] = {expression};
             }}
         }}"
    );
    ArrayKernel::new(gpu, &source, "of_each", &[]).unwrap()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_arctangent_has_its_stated_error() {
    let gpu = gpu();
    let mut points: Vec<Vec4> = (0..20_000_u32)
        .map(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 20_000.0).sin_cos();
            let length = 10.0_f64.powi(i as i32 % 13 - 6);
            Vec4::new((length * cos) as f32, (length * sin) as f32, 0.0, 0.0)
        })
        .collect();
    points.extend(
        [(0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)]
            .map(|(x, y)| Vec4::new(x, y, 0.0, 0.0)),
    );
    let angles: Vec<f32> = of_each(gpu, "atan2_precise(given.y, given.x)", ["vec4<f32>", "f32"])
        .run(gpu, &points)
        .unwrap();
    for (point, angle) in points.iter().zip(angles) {
        let truth = f64::from(point.y).atan2(f64::from(point.x));
        assert!(
            (f64::from(angle) - truth).abs() < 5e-7,
            "{point}: {angle} against {truth}"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn sine_and_cosine_have_their_stated_error() {
    let gpu = gpu();
    let angles: Vec<f32> = (-50_000..=50_000).map(|i| i as f32 * 4e-4).collect();
    let pairs: Vec<Vec2> = of_each(gpu, "sin_cos_precise(given)", ["f32", "vec2<f32>"])
        .run(gpu, &angles)
        .unwrap();
    for (angle, pair) in angles.iter().zip(pairs) {
        let (sine, cosine) = f64::from(*angle).sin_cos();
        let error = (f64::from(pair.x) - sine)
            .abs()
            .max((f64::from(pair.y) - cosine).abs());
        // Measured 9e-8 on the software adapter: a unit in the last place of 1 is 1.2e-7.
        assert!(error < 2e-7, "{angle}: {pair} is {error:e} off");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_logarithm_has_its_stated_error() {
    let gpu = gpu();
    // Numbers from 1e-30 to 1e30, and many near 1, where the logarithm vanishes.
    let wide = (-60_000..=60_000).map(|i| 10.0_f64.powf(f64::from(i) * 5e-4) as f32);
    let close = (-20_000..=20_000).map(|i| 1.0 + i as f32 * 1e-5);
    let numbers: Vec<f32> = wide.chain(close).collect();
    let logarithms: Vec<f32> = of_each(gpu, "log_precise(given)", ["f32", "f32"])
        .run(gpu, &numbers)
        .unwrap();
    for (number, logarithm) in numbers.iter().zip(logarithms) {
        let truth = f64::from(*number).ln();
        // The bound is relative because logarithms next to a horizon are many radians.
        assert!(
            (f64::from(logarithm) - truth).abs() <= 3e-7 * truth.abs(),
            "{number}: {logarithm} against {truth}"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_exponential_has_its_stated_error() {
    let gpu = gpu();
    let numbers: Vec<f32> = (-80_000..=80_000).map(|i| i as f32 * 1e-3).collect();
    let powers: Vec<f32> = of_each(gpu, "exp_precise(given)", ["f32", "f32"])
        .run(gpu, &numbers)
        .unwrap();
    for (number, power) in numbers.iter().zip(powers) {
        let truth = f64::from(*number).exp();
        // Beside the stated error, the multiple of ln 2 that is subtracted may be rounded.
        let bound = 2e-7 + 1e-9 * f64::from(number.abs());
        assert!(
            (f64::from(power) - truth).abs() <= bound * truth,
            "{number}: {power} against {truth}"
        );
    }
}
