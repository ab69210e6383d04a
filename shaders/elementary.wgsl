// Elementary functions with a stated error, where that of WGSL's own would show: atan2 may be wrong
// by 4096 units in the last place, 2.4e-4 of the result.
//
// Gives: angle_between, atan2_precise, atanh_small, exp_precise, log_precise, sin_cos_precise.

// Arctangent on [-1, 1]: a polynomial interpolated at Chebyshev's points, to 1e-8 rad.
fn atan_unit(x: f32) -> f32 {
    let y = x * x;
    var sum = 0.00276628346;
    sum = sum * y - 0.015731249;
    sum = sum * y + 0.0421376228;
    sum = sum * y - 0.0745685473;
    sum = sum * y + 0.106183708;
    sum = sum * y - 0.141977981;
    sum = sum * y + 0.199918717;
    sum = sum * y - 0.333330363;
    return x + x * y * sum;
}

// Angle of (x, y) from the x axis, in [-pi, pi]; zero for (0, 0). The error is at most 5e-7 rad
// with WGSL's division.
fn atan2_precise(y: f32, x: f32) -> f32 {
    let largest = max(max(abs(x), abs(y)), TINY);
    var angle = atan_unit(min(abs(x), abs(y)) / largest);
    angle = select(angle, 0.5 * PI - angle, abs(y) > abs(x));
    angle = select(angle, PI - angle, x < 0.0);
    return select(angle, -angle, y < 0.0);
}

// Angle between two vectors, in [0, pi].
fn angle_between(a: vec3<f32>, b: vec3<f32>) -> f32 {
    return atan2_precise(length(cross(a, b)), dot(a, b));
}

// (Sine, cosine) of an angle of up to some tens of radians, with an error of at most 2e-7 besides
// the angle's rounding. The nearest multiple of pi/2 is subtracted in two parts, the first with few
// digits (Cody & Waite 1980); minimax polynomials on [-pi/4, pi/4] follow, with errors below 4e-9.
fn sin_cos_precise(angle: f32) -> vec2<f32> {
    let turns = round(angle * 0.636619772);
    let x = (angle - turns * 1.5703125) - turns * 4.83826795e-4;
    let y = x * x;
    let sine = x + x * y * (-0.16666655 + y * (0.00833216 - y * 0.00019514));
    let cosine = 1.0 - 0.5 * y + y * y * (0.0416666463 + y * (-0.00138873371 + y * 2.44348455e-5));
    let quarter = i32(turns) & 3;
    let swapped = (quarter & 1) == 1;
    let s = select(sine, cosine, swapped);
    let c = select(cosine, sine, swapped);
    return vec2<f32>(select(s, -s, quarter >= 2), select(c, -c, quarter == 1 || quarter == 2));
}

// Inverse hyperbolic tangent of |x| <= 0.172 by its series, with a relative error of at most 1e-7.
fn atanh_small(x: f32) -> f32 {
    let y = x * x;
    return x + x * y * (0.333333333 + y * (0.2 + y * (0.142857143 + y * 0.111111111)));
}

// Natural logarithm of a normal positive number, with a relative error of at most 3e-7: the
// exponent's share in two parts, and 2 atanh((m - 1)/(m + 1)) of the mantissa m, from sqrt(1/2) to
// sqrt(2).
fn log_precise(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let below_root = (bits & 0x7fffffu) < 0x3504f3u;
    let exponent = f32(bits >> 23u) - select(126.0, 127.0, below_root);
    let mantissa = bitcast<f32>((bits & 0x7fffffu) | select(0x3f000000u, 0x3f800000u, below_root));
    let ratio = (mantissa - 1.0) / (mantissa + 1.0);
    return exponent * 0.693145752 + (exponent * 1.42860677e-6 + 2.0 * atanh_small(ratio));
}

// e^x for |x| <= 80, with a relative error of at most 2e-7 besides that of x: the nearest multiple
// of ln 2 is subtracted in two parts; the series follows.
fn exp_precise(x: f32) -> f32 {
    let doublings = round(x * 1.44269504);
    let y = (x - doublings * 0.693145752) - doublings * 1.42860677e-6;
    let series = 1.0 + y * (1.0 + y * (0.5 + y * (0.166666667 + y * (0.0416666667 + y * (0.00833333333
        + y * (0.00138888889 + y * 0.000198412698))))));
    return series * bitcast<f32>(u32(i32(doublings) + 127) << 23u);
}
