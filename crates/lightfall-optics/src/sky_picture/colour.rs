//! How light of a picture is shifted. A picture has three numbers for each texel and no spectrum, so
//! its light counts as that of a black body with the same ratio of red to blue, times a factor for
//! each channel: seen with the frequency ratio g, the light c of temperature T is
//! g^4 c colour(g T) / colour(T), channel by channel. It is exact for thermal light, and at g = 1 for
//! any light. The twin in WGSL is shaders/sky/picture.wgsl.

use crate::spectrum::{TABLE_MAX_TEMPERATURE, TABLE_MIN_TEMPERATURE, colour};
use glam::DVec3;
use std::sync::LazyLock;

/// The temperature of a texel without light, in kelvin.
pub const NEUTRAL_TEMPERATURE: f64 = 6500.0;

/// The temperatures that a texel can have, in kelvin.
pub const TEMPERATURES: [f64; 2] = [1500.0, 40_000.0];

/// A channel counts as at least this share of the brightest one, so that no channel is divided by
/// zero: thermal light below 1900 K has no blue within the gamut.
pub const MIN_CHANNEL: f64 = 1e-3;

/// Entries of the table of colour ratios.
const TABLE_LEN: usize = 128;

/// ln(red / blue) of thermal light, falling, at equal steps of ln T.
static RATIOS: LazyLock<[f64; TABLE_LEN]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let thermal = thermal(temperature_at(i as f64));
        (thermal.x / thermal.z).ln()
    })
});

fn temperature_at(position: f64) -> f64 {
    let [low, high] = TEMPERATURES;
    low * (high / low).powf(position / (TABLE_LEN - 1) as f64)
}

/// Thermal light as it is divided and multiplied: at a temperature of the shader's table, and no
/// channel darker than [`MIN_CHANNEL`] says.
fn thermal(temperature: f64) -> DVec3 {
    let temperature = temperature.clamp(TABLE_MIN_TEMPERATURE, TABLE_MAX_TEMPERATURE);
    let light = DVec3::from(colour(temperature)).max(DVec3::ZERO);
    light + MIN_CHANNEL * light.max_element()
}

/// The temperature in kelvin of the thermal light that has the ratio of red to blue of this linear
/// light.
pub fn temperature([red, _, blue]: [f64; 3]) -> f64 {
    let floor = MIN_CHANNEL * red.max(blue);
    if floor <= 0.0 {
        return NEUTRAL_TEMPERATURE;
    }
    let ratio = ((red + floor) / (blue + floor)).ln();
    let after = RATIOS.partition_point(|known| *known > ratio);
    if after == 0 || after == TABLE_LEN {
        return TEMPERATURES[usize::from(after == TABLE_LEN)];
    }
    let [high, low] = [RATIOS[after - 1], RATIOS[after]];
    temperature_at((after - 1) as f64 + (high - ratio) / (high - low))
}

/// Linear light of this temperature, seen with the frequency ratio `g`, without beaming.
pub fn shifted(light: DVec3, temperature: f64, g: f64) -> DVec3 {
    light * (thermal(g * temperature) / thermal(temperature))
}
