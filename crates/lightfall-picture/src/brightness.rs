//! The brightness of captured light, as a screen shows it.

use exr::prelude::f16;
use lightfall_render::Captured;

/// The brightness that a screen shows of each pixel of a part of a picture (left, top, width,
/// height), from 0 to 1, rows from the top.
#[must_use]
pub fn brightness(
    captured: &Captured,
    [left, top, width, height]: [u32; 4],
    exposure_ev: f64,
) -> Vec<f64> {
    let light = |bits: u16| f64::from(f16::from_bits(bits).to_f32());
    let pixel = |x: u32, y: u32| {
        let [r, g, b, _] = captured.rgba[(y * captured.size.x + x) as usize];
        shown_brightness([r, g, b].map(light), exposure_ev)
    };
    (top..top + height)
        .flat_map(|y| (left..left + width).map(move |x| (x, y)))
        .map(|(x, y)| pixel(x, y))
        .collect()
}

/// The brightness that a screen shows at an exposure, without the tone curve: sRGB's encoding of the
/// luminance of linear light (IEC 61966-2-1), at most 1. shaders/antialias/geodesic.wgsl does the
/// same.
fn shown_brightness([r, g, b]: [f64; 3], exposure_ev: f64) -> f64 {
    let luminance = (0.2126 * r + 0.7152 * g + 0.0722 * b) * exposure_ev.exp2();
    match luminance.clamp(0.0, 1.0) {
        dark if dark < 0.003_130_8 => 12.92 * dark,
        light => 1.055 * light.powf(1.0 / 2.4) - 0.055,
    }
}
