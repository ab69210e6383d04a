// The sky mode `stars`: the light of the Milky Way, which is that of nebulae and of all stars that
// the passes of shaders/stars/ do not draw as points.
//
// Gives: sky_background.

// Light per steradian of bluer stars, of redder ones and of nebulae.
@group(0) @binding(BINDING_MILKY_WAY) var milky_way: texture_cube<f32>;
@group(0) @binding(BINDING_MILKY_WAY_SAMPLER) var milky_way_sampler: sampler;

// The share of starlight from stars fainter than a magnitude (optics/stars/counts.rs).
fn faint_share(magnitude: f32) -> f32 {
    let x = clamp(magnitude - 11.0, -13.0, 14.0);
    let cubic = FAINTER_SHARE.x + x * (FAINTER_SHARE.y + x * (FAINTER_SHARE.z + x * FAINTER_SHARE.w));
    return 1.0 / (1.0 + exp(cubic));
}

// The light of the components in a direction, filtered along the footprint.
fn milky_way_light(direction: vec3<f32>, axes: Axes) -> vec3<f32> {
    let taps = map_taps(direction, axes);
    let level = taps.level;
    var light = vec3<f32>(0.0);
    for (var tap = 0.5; tap < taps.count; tap += 1.0) {
        let place = taps.middle + (tap / taps.count - 0.5) * taps.along;
        light += textureSampleLevel(milky_way, milky_way_sampler, place, level).rgb;
    }
    return light / taps.count;
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
