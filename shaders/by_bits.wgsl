// Comparisons that hold for NaN, too. A compiler may assume that no number is NaN, so these compare
// bits: those of positive numbers are in the order of the numbers, and those of NaN and of negative
// numbers are larger than those of infinity.
//
// Gives: is_below, is_at_least, is_positive, are_positive, all_positive.

const INFINITY_BITS: u32 = 0x7f800000u;

// Whether a number is from 0 to a positive limit, without the limit.
fn is_below(x: f32, limit: f32) -> bool {
    return bitcast<u32>(x) < bitcast<u32>(limit);
}

// Whether a number is a limit that is not negative, or larger.
fn is_at_least(x: f32, limit: f32) -> bool {
    let bits = bitcast<u32>(x);
    return bits >= bitcast<u32>(limit) && bits <= INFINITY_BITS;
}

// Whether a number is larger than 0. The bits of 0 wrap around.
fn is_positive(x: f32) -> bool {
    return bitcast<u32>(x) - 1u < INFINITY_BITS;
}

fn are_positive(x: vec3<f32>) -> vec3<bool> {
    return bitcast<vec3<u32>>(x) - vec3<u32>(1u) < vec3<u32>(INFINITY_BITS);
}

fn all_positive(x: vec4<f32>) -> bool {
    return all(bitcast<vec4<u32>>(x) - vec4<u32>(1u) < vec4<u32>(INFINITY_BITS));
}
