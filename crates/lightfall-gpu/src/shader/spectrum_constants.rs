//! The constants of shaders/spectrum.wgsl.

use super::text::add_constant;
use lightfall_optics::spectrum::{TABLE_LEN, TABLE_MAX_TEMPERATURE, TABLE_MIN_TEMPERATURE};

/// Appends the constants of the table of thermal colours.
pub(crate) fn add_spectrum_constants(text: &mut String) {
    add_constant(text, "SPECTRUM_LEN", "u32", format!("{TABLE_LEN}u"));
    let temperatures = [
        ("SPECTRUM_MIN_TEMPERATURE", TABLE_MIN_TEMPERATURE),
        ("SPECTRUM_MAX_TEMPERATURE", TABLE_MAX_TEMPERATURE),
        (
            "SPECTRUM_LN_RANGE",
            (TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE).ln(),
        ),
    ];
    for (name, value) in temperatures {
        add_constant(text, name, "f32", format!("{value:?}"));
    }
}
