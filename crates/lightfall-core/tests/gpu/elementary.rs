//! The shaders' elementary functions against those of f64.

use crate::functions::value_of_functions;
use glam::Vec4;

#[test]
#[ignore = "needs a graphics adapter"]
fn the_arctangent_has_its_stated_error() {
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
    let angles = value_of_functions("vec4<f32>(atan2_precise(given.y, given.x))", &points);
    for (point, angle) in points.iter().zip(angles) {
        let truth = f64::from(point.y).atan2(f64::from(point.x));
        assert!(
            (f64::from(angle.x) - truth).abs() < 5e-7,
            "{point}: {angle} against {truth}"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn sine_and_cosine_have_their_stated_error() {
    let angles = (-50_000..=50_000).map(|i| Vec4::splat(i as f32 * 4e-4));
    let angles: Vec<Vec4> = angles.collect();
    let pairs = value_of_functions("vec4<f32>(sin_cos_precise(given.x), 0.0, 0.0)", &angles);
    for (angle, pair) in angles.iter().zip(pairs) {
        let (sine, cosine) = f64::from(angle.x).sin_cos();
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
    // Numbers from 1e-30 to 1e30, and many near 1, where the logarithm vanishes.
    let wide = (-60_000..=60_000).map(|i| 10.0_f64.powf(f64::from(i) * 5e-4) as f32);
    let close = (-20_000..=20_000).map(|i| 1.0 + i as f32 * 1e-5);
    let numbers: Vec<Vec4> = wide.chain(close).map(Vec4::splat).collect();
    let logarithms = value_of_functions("vec4<f32>(log_precise(given.x))", &numbers);
    for (number, logarithm) in numbers.iter().zip(logarithms) {
        let truth = f64::from(number.x).ln();
        // The bound is relative because logarithms next to a horizon are many radians.
        assert!(
            (f64::from(logarithm.x) - truth).abs() <= 3e-7 * truth.abs(),
            "{number}: {logarithm} against {truth}"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_exponential_has_its_stated_error() {
    let numbers = (-80_000..=80_000).map(|i| Vec4::splat(i as f32 * 1e-3));
    let numbers: Vec<Vec4> = numbers.collect();
    let powers = value_of_functions("vec4<f32>(exp_precise(given.x))", &numbers);
    for (number, power) in numbers.iter().zip(powers) {
        let truth = f64::from(number.x).exp();
        // Beside the stated error, the multiple of ln 2 that is subtracted may be rounded.
        let bound = 2e-7 + 1e-9 * f64::from(number.x.abs());
        assert!(
            (f64::from(power.x) - truth).abs() <= bound * truth,
            "{number}: {power} against {truth}"
        );
    }
}
