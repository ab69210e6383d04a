//! The brightness of captured light, as a screen shows it.

use crate::render::Captured;
use exr::prelude::f16;
use lightfall_lab::bench::shown_brightness;

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
