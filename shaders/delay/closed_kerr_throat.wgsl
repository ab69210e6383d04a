// The radial part of the delay, as in closed_kerr_radial.wgsl, around a nearly extremal hole. In
// its throat the integrand may be a thousand times larger at the ray's centre than at the end of
// its path, and the two parts almost cancel. A divided path is summed relative to the value at its
// end.
//
// Gives: radial_delay.

// The value at the end replaces the value at the centre if it is smaller than this share of it.
const MAX_SHARE_AT_END: f32 = 0.125;

// |u'| at a distance from the centre.
fn speed_at(centre: Centre, y: f32) -> f32 {
    let rise = y * (centre.c.x + y * (centre.c.y + y * (centre.c.z + y * centre.c.w)));
    return sqrt(max(centre.c_0 + rise, 0.0));
}

// K' (1 + a^2 u^2)/(W + |u'|) at u, where the speed |u'| is known. `beyond` is u - 1/r_+.
fn regular_value(c: PhotonConstants, u: vec4<f32>, beyond: vec4<f32>, speed: vec4<f32>) -> vec4<f32> {
    let w = c.horizon_w + c.drag * beyond * (2.0 * scene.hole.horizon_u + beyond);
    return c.k_prime * (1.0 + square(scene.hole.a) * u * u) / max(w + speed, vec4<f32>(TINY));
}

// The integral of the same less its value `at_end` at the end of the path, over places on a leg.
fn regular_sum_to_end(c: PhotonConstants, leg: Leg, places: LegPlaces, at_end: f32) -> f32 {
    let centre = leg.centre;
    let away = centre.side * places.y;
    let speed = sqrt(max(centre.c_0 + places.rise, vec4<f32>(TINY)));
    let change = regular_value(c, centre.u - away, centre.beyond - away, speed) - at_end;
    return leg.count * dot(WEIGHTS, places.dy * change / speed);
}

// The integral from the camera to u, which the ray reaches at the time t, before or after its turn.
fn radial_delay(m: Radial, c: PhotonConstants, course: RadialCourse, u: f32, returned: bool, t: f32) -> f32 {
    let centre = course.centre;
    let at = regular_at(c, centre, 1.0, square(scene.hole.a));
    let path = path_to(m, course, u, returned, regular_scale(c, centre, at));
    let speed = speed_at(centre, centre.side * (centre.u - u));
    let beyond = (u - scene.hole.horizon_u) - scene.hole.horizon_u_low;
    let at_end = regular_value(c, vec4<f32>(u), vec4<f32>(beyond), vec4<f32>(speed)).x;
    if !is_divided(path) || at_end >= MAX_SHARE_AT_END * at.value {
        return (at.value - c.drag) * t + regular_along(c, path, at);
    }
    var sum = (at_end - c.drag) * t;
    let parts = parts_of_path(path);
    for (var i = 0u; i < parts.passes; i++) {
        let part = pass_at(path, parts, i);
        sum += regular_sum_to_end(c, part.leg, part.places, at_end);
    }
    return sum;
}
