// Constants and small functions of general use.
//
// Gives: LOG10_2, PI, TINY, rotate_z, safe_normalize, square.

const PI: f32 = 3.14159265358979;
const LOG10_2: f32 = 0.301029996;

// The smallest allowed divisor or argument of a root: far above f32's subnormal numbers.
const TINY: f32 = 1e-30;

fn safe_normalize(v: vec3<f32>) -> vec3<f32> {
    return v * inverseSqrt(max(dot(v, v), TINY));
}

fn square(x: f32) -> f32 {
    return x * x;
}

// A vector rotated about z by an angle given as (sine, cosine).
fn rotate_z(v: vec2<f32>, sin_cos: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(sin_cos.y * v.x - sin_cos.x * v.y, sin_cos.x * v.x + sin_cos.y * v.y);
}
