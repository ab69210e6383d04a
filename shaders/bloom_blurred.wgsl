// A level of the bloom, blurred once more as it is enlarged: a tent three texels wide (Jimenez 2014,
// "Next Generation Post Processing in Call of Duty: Advanced Warfare").
//
// Gives: bloom_blurred.

fn bloom_blurred(level: texture_2d<f32>, level_sampler: sampler, across: vec2<f32>) -> vec3<f32> {
    let texel = 1.0 / vec2<f32>(textureDimensions(level));
    var light = vec3<f32>(0.0);
    for (var y = -1; y <= 1; y++) {
        for (var x = -1; x <= 1; x++) {
            let weight = f32((2 - abs(x)) * (2 - abs(y))) / 16.0;
            let place = across + vec2<f32>(f32(x), f32(y)) * texel;
            light += weight * textureSampleLevel(level, level_sampler, place, 0.0).rgb;
        }
    }
    return light;
}
