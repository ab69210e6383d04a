// Colours of scales.
//
// Gives: from_oklab.

// Linear sRGB of a colour in Oklab (Ottosson 2020), in which equal distances look equal.
fn from_oklab(lightness: f32, a: f32, b: f32) -> vec3<f32> {
    let l = lightness + 0.3963377774 * a + 0.2158037573 * b;
    let m = lightness - 0.1055613458 * a - 0.0638541728 * b;
    let s = lightness - 0.0894841775 * a - 1.2914855480 * b;
    let cones = vec3<f32>(l * l * l, m * m * m, s * s * s);
    return vec3<f32>(
        dot(vec3<f32>(4.0767416621, -3.3077115913, 0.2309699292), cones),
        dot(vec3<f32>(-1.2684380046, 2.6097574011, -0.3413193965), cones),
        dot(vec3<f32>(-0.0041960863, -0.7034186147, 1.7076147010), cones),
    );
}
