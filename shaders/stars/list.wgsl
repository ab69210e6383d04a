// The list of stars, brightest first.
//
// Gives: star_list, unpacked_flux, unpacked_temperature.

// A star of the list: its unit direction, and its luminous flux and temperature in one number.
struct Star {
    direction: vec3<f32>,
    light: u32,
}

@group(0) @binding(BINDING_STAR_LIST) var<storage, read> star_list: array<Star>;

// The upper 18 bits are those of an f32 below its sign, rounded to 12 bits of mantissa, and less
// the exponents below 2^-40.
fn unpacked_flux(light: u32) -> f32 {
    return bitcast<f32>(((light >> 14u) + STAR_FLUX_BIAS) << 11u);
}

// The lower 14 bits are the place of ln T in the table of thermal colours.
fn unpacked_temperature(light: u32) -> f32 {
    return SPECTRUM_MIN_TEMPERATURE * exp(f32(light & 0x3fffu) * (SPECTRUM_LN_RANGE / STAR_TEMPERATURE_STEPS));
}
