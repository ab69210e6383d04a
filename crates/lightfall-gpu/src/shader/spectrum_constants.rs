//! The constants of shaders/spectrum.wgsl.

use super::text::{add_f32, add_u32};
use lightfall_optics::spectrum::{TABLE_LEN, TABLE_MAX_TEMPERATURE, TABLE_MIN_TEMPERATURE};

/// Appends the constants of the table of thermal colours.
pub(crate) fn add_spectrum_constants(text: &mut String) {
    let range: f64 = TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE;
    add_u32(text, "SPECTRUM_LEN", TABLE_LEN as u32);
    add_f32(text, "SPECTRUM_MIN_TEMPERATURE", TABLE_MIN_TEMPERATURE);
    add_f32(text, "SPECTRUM_MAX_TEMPERATURE", TABLE_MAX_TEMPERATURE);
    add_f32(text, "SPECTRUM_LN_RANGE", range.ln());
}
