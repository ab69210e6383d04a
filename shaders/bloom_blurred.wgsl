// A level of the bloom, blurred once more as it is enlarged: a tent three texels wide (Jimenez 2014,
// "Next Generation Post Processing in Call of Duty: Advanced Warfare").
//
// Gives: bloom_blurred.

fn bloom_blurred(level: texture_2d<f32>, level_sampler: sampler, across: vec2<f32>) -> vec3<f32> {
    // With linear interpolation three samples a texel apart, weighted 1:2:1, read four texels along each
    // axis. One sample between the first two and one between the last two give the same.
    let size = vec2<f32>(textureDimensions(level));
    let place = across * size - 0.5;
    let share = fract(place);
    let middle = floor(place) + 0.5;
    let before = (middle + (2.0 - share) / (3.0 - 2.0 * share) - 1.0) / size;
    let after = (middle + share / (1.0 + 2.0 * share) + 1.0) / size;
    let weight = (1.0 + 2.0 * share) / 4.0;
    let above = mix(
        textureSampleLevel(level, level_sampler, before, 0.0).rgb,
        textureSampleLevel(level, level_sampler, vec2<f32>(after.x, before.y), 0.0).rgb,
        weight.x,
    );
    let below = mix(
        textureSampleLevel(level, level_sampler, vec2<f32>(before.x, after.y), 0.0).rgb,
        textureSampleLevel(level, level_sampler, after, 0.0).rgb,
        weight.x,
    );
    return mix(above, below, weight.y);
}
