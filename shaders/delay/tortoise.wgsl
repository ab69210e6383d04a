// Kerr's tortoise coordinate, by which ingoing and outgoing time differ from Boyer-Lindquist's.
//
// Gives: tortoise, tortoise_sum.

// The integral of (r^2 + a^2)/Delta dr at u = 1/r, with the factors 1 - r_+ u and 1 - r_- u of
// Delta/r^2 (Misner, Thorne & Wheeler 1973 box 33.2, with 2M = 1):
//
//   r + (r_+ ln(r - r_+) - r_- ln(r - r_-))/(r_+ - r_-)
//     = r + ln(r - r_-) + r_+ ln((r - r_+)/(r - r_-))/(r_+ - r_-)
//
// The last logarithm is an inverse hyperbolic tangent, accurate however close the horizons are.
fn tortoise(u: f32, factors: vec2<f32>) -> f32 {
    let separation = scene.hole.horizon_separation;
    let tangent = separation * u / (factors.x + factors.y);
    var difference = -2.0 * atanh_small(tangent);
    if tangent > 0.17 {
        difference = log(factors.x / factors.y);
    }
    let r = 1.0 / u;
    return r + log(r * factors.y) + scene.hole.horizon / separation * difference;
}

// The sum of r* at two places, with one logarithm for both, by the addition theorem of tanh.
fn tortoise_sum(u: vec2<f32>, factors_0: vec2<f32>, factors_1: vec2<f32>) -> f32 {
    let separation = scene.hole.horizon_separation;
    let tangents = separation * u / vec2<f32>(factors_0.x + factors_0.y, factors_1.x + factors_1.y);
    let tangent = (tangents.x + tangents.y) / (1.0 + tangents.x * tangents.y);
    var difference = -2.0 * atanh_small(tangent);
    if tangent > 0.17 {
        difference = log(factors_0.x * factors_1.x / (factors_0.y * factors_1.y));
    }
    let r = 1.0 / u;
    return r.x + r.y + log(r.x * factors_0.y * r.y * factors_1.y) + scene.hole.horizon / separation * difference;
}
