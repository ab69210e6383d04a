// The brightness of light, by which the search for edges compares pixels.
//
// Gives: shown_brightness.

// The brightness that a screen shows, without the tone curve: sRGB's encoding of the luminance at
// the scene's exposure (IEC 61966-2-1).
fn shown_brightness(light: vec3<f32>) -> f32 {
    let luminance = clamp(dot(light, vec3<f32>(0.2126, 0.7152, 0.0722)) * scene.picture.exposure, 0.0, 1.0);
    return select(1.055 * pow(luminance, 1.0 / 2.4) - 0.055, 12.92 * luminance, luminance < 0.0031308);
}
