// Slow outgoing rays of the method closed, which start next to the horizon of a nearly extremal
// hole. U has no critical point then, and its expansion about u = 0 cancels at the camera. So U is
// expanded about the camera, where the ray's own slope gives it, with coefficients of that about
// the horizon.
//
// Gives: camera_centre, is_slow_outgoing, slow_outgoing_time.

// The largest u'^2 of a slow ray at the camera, as a share of u'^2 at infinity: there the expansion
// about u = 0 has lost two binary digits.
const MAX_SLOW_SHARE: f32 = 0.25;

// Whether a ray without a critical point moves slowly outward from a camera next to the horizon.
fn is_slow_outgoing(m: Radial, slope: f32) -> bool {
    return begins_near_horizon() && m.base == 0.0 && !m.has_barrier
        && slope < 0.0 && square(slope) < MAX_SLOW_SHARE * square(m.energy);
}

// The camera as the centre of a leg on its outer side.
fn camera_centre(m: Radial, c: PhotonConstants, slope: f32) -> Centre {
    let u = scene.observer.u;
    let v = -scene.observer.u_to_horizon;
    let q_1 = stiffness_slope_at_horizon(c);
    let accel = stiffness_at_horizon(c) + v * (q_1 + v * m.p.z);
    let accel_slope = q_1 + 2.0 * m.p.z * v;
    let growth = vec4<f32>(
        -2.0 * u * accel,
        accel + u * accel_slope,
        -(2.0 / 3.0) * (accel_slope + u * m.p.z),
        0.5 * m.p.z,
    );
    return Centre(u, v, 1.0, square(slope), growth, 0.0, 0.0);
}

// The Mino time from the camera, as a centre, to a place (u, |u'|) farther out. U has a linear term
// b_1 about the camera. With it, the cubic for `offset` is
//
//   4 offset^3 - 2 alpha offset^2 + (alpha^2/4 - gamma b_0 + beta b_1/4) offset
//     + (beta^2 b_0 + gamma b_1^2 - alpha beta b_1)/16 = 0,
//
// and 4 h2 has the term -beta b_1/4. The root of the expansion about u = 0 is the start.
fn slow_outgoing_time(m: Radial, camera: Centre, place: vec2<f32>) -> f32 {
    let c = camera.c;
    let b_0 = camera.c_0;
    // By the distance outward b_1 is -c.x, and beta is -c.z.
    let bend = c.z * c.x;
    let slope = 0.25 * c.y * c.y - c.w * b_0 + 0.25 * bend;
    let constant = 0.0625 * (c.z * c.z * b_0 + c.w * c.x * c.x - c.y * bend);
    var x = m.offset + (c.y - m.alpha) * (1.0 / 6.0);
    for (var i = 0u; i < 3u; i++) {
        let rate = slope + x * (12.0 * x - 4.0 * c.y);
        x -= (constant + x * (slope + x * (4.0 * x - 2.0 * c.y))) / select(rate, TINY, abs(rate) < TINY);
    }
    let h2 = 0.25 * (c.w * b_0 - 0.25 * bend + x * (c.y - 3.0 * x));
    let y = camera.u - place.x;
    let pair = 0.5 * x + 0.5 * (b_0 + 0.5 * c.x * y + sqrt(b_0) * place.y) / max(y * y, TINY);
    return carlson_rf_pair(pair + 0.25 * c.y - 1.5 * x, pair, h2);
}
