// The sky mode `picture`: a picture of the whole sky from a file, as a cube map. A texel is linear
// light and the logarithm of a temperature; its light is shifted as that of a black body of this
// temperature, channel by channel (optics/sky_picture/colour.rs).
//
// Gives: sky_background.

// Red, green, blue, and ln(T / NEUTRAL_TEMPERATURE).
@group(0) @binding(BINDING_MILKY_WAY) var sky_picture: texture_cube<f32>;
@group(0) @binding(BINDING_MILKY_WAY_SAMPLER) var sky_picture_sampler: sampler;

// The temperature of a texel without light, in kelvin.
const NEUTRAL_TEMPERATURE: f32 = 6500.0;
// A channel of thermal light counts as at least this share of the brightest one.
const MIN_CHANNEL: f32 = 1e-3;

// The texels in a direction, filtered along the footprint.
fn picture_texel(direction: vec3<f32>, axes: Axes) -> vec4<f32> {
    let taps = map_taps(direction, axes);
    var texel = vec4<f32>(0.0);
    for (var tap = 0.5; tap < taps.count; tap += 1.0) {
        let place = taps.middle + (tap / taps.count - 0.5) * taps.along;
        texel += textureSampleLevel(sky_picture, sky_picture_sampler, place, taps.level);
    }
    return texel / taps.count;
}

// Thermal light as it is divided and multiplied.
fn divisible_colour(temperature: f32) -> vec3<f32> {
    let light = thermal_colour(temperature);
    return light + MIN_CHANNEL * max(light.r, max(light.g, light.b));
}

fn sky_background(direction: vec3<f32>, g: f32, footprint: Footprint) -> vec3<f32> {
    let texel = picture_texel(direction, footprint_axes(footprint));
    let temperature = NEUTRAL_TEMPERATURE * exp(texel.a);
    return texel.rgb * (divisible_colour(g * temperature) / divisible_colour(temperature));
}
