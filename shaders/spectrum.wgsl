// The colour of thermal light, from the table of optics/spectrum.rs. Entries are equidistant in ln
// T; each holds the colour divided by its brightest channel, and the logarithm of that channel.
//
// Gives: thermal_colour.

@group(0) @binding(BINDING_SPECTRUM) var<uniform> spectrum: array<vec4<f32>, SPECTRUM_LEN>;

// Linear sRGB per unit of relative bolometric flux; 6500 K has luminance one. Temperatures outside
// the table are clamped to its ends, and colours outside the gamut are clipped.
fn thermal_colour(temperature: f32) -> vec3<f32> {
    let last = f32(SPECTRUM_LEN - 1u);
    let share = log(clamp(temperature, SPECTRUM_MIN_TEMPERATURE, SPECTRUM_MAX_TEMPERATURE) / SPECTRUM_MIN_TEMPERATURE) / SPECTRUM_LN_RANGE;
    let position = clamp(share, 0.0, 1.0) * last;
    let low = min(u32(position), SPECTRUM_LEN - 2u);
    let entry = mix(spectrum[low], spectrum[low + 1u], position - f32(low));
    return max(entry.rgb, vec3<f32>(0.0)) * exp(entry.a);
}
