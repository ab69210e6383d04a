//! The presentation without cells: rounding to 8 bits with noise.

use crate::gpu;
use crate::light::light_from;
use glam::Vec4;
use lightfall_core::gpu::Presentation;

/// Levels, of 255, that perceptual values are rounded to at places of the output.
fn levels(given: impl IntoIterator<Item = ([u32; 2], f32)>) -> Vec<f32> {
    let given = given
        .into_iter()
        .map(|([x, y], value)| Vec4::new(x as f32 + 0.5, y as f32 + 0.5, value, 0.0));
    let rounded = light_from(
        gpu(),
        &Presentation::shader().source(),
        "vec4<f32>(to_levels(vec3<f32>(given.z), 255.0, given.xy), 0.0)",
        &[],
        given,
    );
    rounded.iter().map(|rounded| rounded.x).collect()
}

/// Every pixel of a square, with its value.
fn square(side: u32, value: impl Fn(u32, u32) -> f32) -> Vec<([u32; 2], f32)> {
    (0..side)
        .flat_map(|y| (0..side).map(move |x| [x, y]))
        .map(|[x, y]| ([x, y], value(x, y)))
        .collect()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn black_and_white_stay_what_they_are() {
    for (value, level) in [(0.0, 0.0), (1.0, 255.0), (0.999_999_9, 255.0)] {
        let levels = levels(square(512, |_, _| value));
        assert!(levels.iter().all(|found| *found == level));
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_smooth_dark_gradient_has_no_bands_and_keeps_its_mean() {
    // From level 3 to 7 over 512 pixels: without noise, bands 128 pixels wide.
    let side = 512;
    let level = |x: u32| 3.0 + 4.0 * x as f32 / side as f32;
    let levels = levels(square(side, |x, _| level(x) / 255.0));
    let at = |x: u32, y: u32| levels[(y * side + x) as usize].round();
    for y in (0..side).step_by(16) {
        let row: Vec<f32> = (0..side).map(|x| at(x, y)).collect();
        let (mut run, mut longest) = (1, 1);
        for (x, pair) in (0..).zip(row.windows(2)) {
            run = if pair[0] == pair[1] { run + 1 } else { 1 };
            // Within a twentieth of a whole level nearly all pixels have this level.
            let share = level(x).fract();
            if (0.05..0.95).contains(&share) {
                longest = longest.max(run);
            }
        }
        assert!(longest < 48, "a band of {longest} pixels in row {y}");
    }
    // Means of squares of 16 pixels against the gradient's: noise that is even within a square is
    // off by less than a twentieth of a level.
    for (x, y) in (0..side / 16).flat_map(|y| (0..side / 16).map(move |x| (16 * x, 16 * y))) {
        let inside = (0..16).flat_map(|j| (0..16).map(move |i| (x + i, y + j)));
        let mean = inside.map(|(x, y)| at(x, y)).sum::<f32>() / 256.0;
        let expected = (0..16).map(|i| level(x + i)).sum::<f32>() / 16.0;
        assert!(
            (mean - expected).abs() < 0.05,
            "{mean} and {expected} at {x}, {y}"
        );
    }
}
