// The sky mode `stars`: the light of the Milky Way, which is that of nebulae and of all stars that
// the passes of shaders/stars/ do not draw as points.
//
// Gives: sky_background, starlight.

// Mirror of `GpuStarlight` in gpu/starlight.rs.
struct Starlight {
    // From the hole's frame to the equatorial frame (J2000).
    celestial_from_hole: mat3x3<f32>,
    // The faintest magnitude of a star drawn as a point, if its image has the star's own flux, and
    // at any flux.
    magnitude_limit: f32,
    last_magnitude: f32,
    // Temperatures of the two components, in kelvin.
    temperatures: vec2<f32>,
    // Colour of nebulae, at equal steps of the logarithm of the frequency ratio.
    nebular: array<vec4<f32>, NEBULAR_LEN>,
    // Width of a texel of the finest level, in radians.
    texel: f32,
    // Linear light per unit of the sums of points.
    light_unit: f32,
    // The squares in which light is summed: their number along the side of a pixel, and in a row.
    squares_per_pixel: f32,
    columns: u32,
}

@group(0) @binding(BINDING_STARLIGHT) var<uniform> starlight: Starlight;
// Light per steradian of bluer stars, of redder ones and of nebulae.
@group(0) @binding(BINDING_MILKY_WAY) var milky_way: texture_cube<f32>;
@group(0) @binding(BINDING_MILKY_WAY_SAMPLER) var milky_way_sampler: sampler;

// Maximum number of samples along a footprint. Four reduce the error next to the shadow to a third.
const MAX_TAPS: f32 = 4.0;
// The share of starlight from stars fainter than a magnitude (optics/stars/counts.rs).
fn faint_share(magnitude: f32) -> f32 {
    let x = clamp(magnitude - 11.0, -13.0, 14.0);
    let cubic = FAINTER_SHARE.x + x * (FAINTER_SHARE.y + x * (FAINTER_SHARE.z + x * FAINTER_SHARE.w));
    return 1.0 / (1.0 + exp(cubic));
}

// The light of the components in a direction, filtered along the footprint with as many samples as
// the ratio of its axes.
fn milky_way_light(direction: vec3<f32>, axes: Axes) -> vec3<f32> {
    let along = starlight.celestial_from_hole * axes.long;
    let middle = starlight.celestial_from_hole * direction;
    let taps = clamp(ceil(axes.lengths.x / max(axes.lengths.y, TINY) - 0.25), 1.0, MAX_TAPS);
    let level = log2(max(max(axes.lengths.y, axes.lengths.x / taps) / starlight.texel, 1.0));
    var light = vec3<f32>(0.0);
    for (var tap = 0.5; tap < taps; tap += 1.0) {
        let place = middle + (tap / taps - 0.5) * along;
        light += textureSampleLevel(milky_way, milky_way_sampler, place, level).rgb;
    }
    return light / taps;
}

// Linear sRGB of a nebula per unit of flux: its lines, seen with the frequency ratio g
// (optics/milky_way/nebular.rs).
fn nebular_colour(g: f32) -> vec3<f32> {
    let share = log(max(g, TINY) / NEBULAR_MIN_SHIFT) / log(NEBULAR_MAX_SHIFT / NEBULAR_MIN_SHIFT);
    let position = clamp(share, 0.0, 1.0) * f32(NEBULAR_LEN - 1u);
    let low = min(u32(position), NEBULAR_LEN - 2u);
    return mix(starlight.nebular[low].rgb, starlight.nebular[low + 1u].rgb, position - f32(low));
}

fn sky_background(direction: vec3<f32>, g: f32, footprint: Footprint) -> vec3<f32> {
    let axes = footprint_axes(footprint);
    // The gain of an image: the ray's solid angle in the picture over that on the sky, with
    // beaming.
    let gain = ray_solid_angle * ray_share() / max(axes.lengths.x * axes.lengths.y, TINY) * beaming_factor(g);
    let faintest = starlight.magnitude_limit + 2.5 * LOG10_2 * log2(clamp(gain, 1e-12, 1e12));
    let share = faint_share(min(faintest, starlight.last_magnitude));
    let light = milky_way_light(direction, axes);
    let stars = thermal_colour(starlight.temperatures.x * g) * light.x
        + thermal_colour(starlight.temperatures.y * g) * light.y;
    return stars * share + nebular_colour(g) * light.z;
}
