//! The levels of a film's pictures from linear light.

use exr::prelude::f16;
use lightfall_core::optics::lut::Look;
use rayon::prelude::*;

/// The highest level of sixteen bits.
const TOP: f64 = u16::MAX as f64;

/// The levels of red, green and blue of pixels, in sixteen bits, from the bits of half floats. The exposure
/// is in powers of two.
#[must_use]
pub fn levels_of_halves(rgba: &[[u16; 4]], look: Look, exposure_ev: f64) -> Vec<u16> {
    let gain = exposure_ev.exp2();
    let pixels = rgba.par_iter().map(|[r, g, b, _]| {
        let light = [*r, *g, *b].map(|bits| f16::from_bits(bits).to_f32());
        levels(look, light, gain)
    });
    pixels.collect::<Vec<_>>().into_flattened()
}

/// As [`levels_of_halves`], from numbers.
#[must_use]
pub fn levels_of_light(rgb: &[[f32; 3]], look: Look, exposure_ev: f64) -> Vec<u16> {
    let gain = exposure_ev.exp2();
    let pixels = rgb.par_iter().map(|light| levels(look, *light, gain));
    pixels.collect::<Vec<_>>().into_flattened()
}

fn levels(look: Look, light: [f32; 3], gain: f64) -> [u16; 3] {
    // NaN counts as no light.
    let light = light.map(|channel| if channel.is_nan() { 0.0 } else { channel });
    look.shown(light, gain)
        .map(|code| (code * TOP).round() as u16)
}
