// The colours of errors, by a logarithmic scale: dark violet at 1e-4 or less through green to bright yellow at
// 1 or more.
//
// Gives: error_colour.

// The colour at a position in 0..1. Lightness grows linearly, so that the scale can also be read
// without its hues.
fn scale_colour(position: f32) -> vec3<f32> {
    let t = position;
    return from_oklab(0.30 + 0.65 * t, 0.04 + t * (0.32 * t - 0.42), -0.13 + t * (0.09 + 0.22 * t));
}

fn error_colour(error: f32) -> vec3<f32> {
    let position = 0.25 * LOG10_2 * log2(max(error, 1e-4)) + 1.0;
    return scale_colour(clamp(position, 0.0, 1.0));
}
