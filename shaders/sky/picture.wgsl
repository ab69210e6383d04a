// The sky mode `picture`: a picture of the whole sky from a file, as a cube map. A texel is linear
// light and the logarithm of a temperature; its light is shifted as that of a black body of this
// temperature, channel by channel (optics/sky_picture/colour.rs).
//
// Gives: sky_background, starlight.

// Mirror of `GpuStarlight` in gpu/starlight.rs, which the passes of point stars share. Here the
// matrix leads to the axes of the picture, and the texel is one of its finest level.
struct Starlight {
    celestial_from_hole: mat3x3<f32>,
    magnitude_limit: f32,
    last_magnitude: f32,
    temperatures: vec2<f32>,
    nebular: array<vec4<f32>, NEBULAR_LEN>,
    texel: f32,
    light_unit: f32,
    squares_per_pixel: f32,
    columns: u32,
}

@group(0) @binding(BINDING_STARLIGHT) var<uniform> starlight: Starlight;
// Red, green, blue, and ln(T / NEUTRAL_TEMPERATURE).
@group(0) @binding(BINDING_MILKY_WAY) var sky_picture: texture_cube<f32>;
@group(0) @binding(BINDING_MILKY_WAY_SAMPLER) var sky_picture_sampler: sampler;

// Maximum number of samples along a footprint, as for the Milky Way.
const MAX_TAPS: f32 = 4.0;
// The temperature of a texel without light, in kelvin.
const NEUTRAL_TEMPERATURE: f32 = 6500.0;
// A channel of thermal light counts as at least this share of the brightest one.
const MIN_CHANNEL: f32 = 1e-3;

// The texels in a direction, filtered along the footprint with as many samples as the ratio of its
// axes.
fn picture_texel(direction: vec3<f32>, axes: Axes) -> vec4<f32> {
    let along = starlight.celestial_from_hole * axes.long;
    let middle = starlight.celestial_from_hole * direction;
    let taps = clamp(ceil(axes.lengths.x / max(axes.lengths.y, TINY) - 0.25), 1.0, MAX_TAPS);
    let level = log2(max(max(axes.lengths.y, axes.lengths.x / taps) / starlight.texel, 1.0));
    var texel = vec4<f32>(0.0);
    for (var tap = 0.5; tap < taps; tap += 1.0) {
        let place = middle + (tap / taps - 0.5) * along;
        texel += textureSampleLevel(sky_picture, sky_picture_sampler, place, level);
    }
    return texel / taps;
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
