// From linear light to the levels of a screen or a file.
//
// Gives: srgb_decode, srgb_encode, to_levels.

// sRGB transfer function and its inverse (IEC 61966-2-1).
fn srgb_encode(linear: vec3<f32>) -> vec3<f32> {
    let c = clamp(linear, vec3<f32>(0.0), vec3<f32>(1.0));
    return select(1.055 * pow(c, vec3<f32>(1.0 / 2.4)) - 0.055, 12.92 * c, c <= vec3<f32>(0.0031308));
}

fn srgb_decode(encoded: vec3<f32>) -> vec3<f32> {
    return select(pow((encoded + 0.055) / 1.055, vec3<f32>(2.4)), encoded / 12.92, encoded <= vec3<f32>(0.04045));
}

// Interleaved gradient noise, strictly between 0 and 1, whose mean over a few neighbouring pixels
// is nearly 1/2 (Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced
// Warfare").
fn noise(place: vec2<f32>) -> f32 {
    return mix(0.001, 0.999, fract(52.9829189 * fract(dot(place, vec2<f32>(0.06711056, 0.00583715)))));
}

// Rounds perceptual channel values to whole levels, the highest of which is `top`, with noise, which
// preserves their mean, so that gradients show no bands. Black and white do not change.
fn to_levels(encoded: vec3<f32>, top: f32, place: vec2<f32>) -> vec3<f32> {
    return min(floor(encoded * top + noise(place)), vec3<f32>(top));
}
