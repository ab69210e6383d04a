// The horizons' factors of D, and the lag of Kerr's ingoing azimuth behind Boyer-Lindquist's.
//
// Gives: azimuth_lag, horizon_factors, horizon_factors_at.

// 1 - r_+ u and 1 - r_- u, the factors of D, at u = base + v. The base is 0 or 1/r_+.
fn horizon_factors(base: f32, v: f32) -> vec2<f32> {
    let about_horizon = base > 0.0;
    let outer = select(1.0, 0.0, about_horizon) - scene.hole.horizon * v;
    let inner = select(1.0, scene.hole.horizon_separation * base, about_horizon) - scene.hole.inner_horizon * v;
    return vec2<f32>(max(outer, TINY), inner);
}

// The same at u, expanded about the horizon next to it.
fn horizon_factors_at(u: f32) -> vec2<f32> {
    let u_horizon = scene.hole.horizon_u;
    let about_horizon = u > 0.5 * u_horizon;
    let v = select(u, (u - u_horizon) - scene.hole.horizon_u_low, about_horizon);
    return horizon_factors(select(0.0, u_horizon, about_horizon), v);
}

// Integral of a/D over u between two places this distance apart, whose factors of D are p and q:
//
//   a / (r_+ - r_-) |ln(p_1 q_2 / (p_2 q_1))|,   |p_1 q_2 - p_2 q_1| = (r_+ - r_-) distance,
//
// by an inverse hyperbolic tangent, which is accurate however close the two horizons are.
fn azimuth_lag(p: vec2<f32>, q: vec2<f32>, distance: f32) -> f32 {
    let products = vec2<f32>(p.x * q.y, q.x * p.y);
    let tangent = scene.hole.horizon_separation * distance / (products.x + products.y);
    if tangent < 0.17 {
        return 2.0 * scene.hole.a / scene.hole.horizon_separation * atanh_small(tangent);
    }
    let ratio = max(products.x, products.y) / min(products.x, products.y);
    return scene.hole.a / scene.hole.horizon_separation * log_precise(ratio);
}
