// The azimuth of the method closed around a spinning hole: the angle by which frame dragging has
// turned the ray at u. The dragging at the ray's centre times the time is exact;
// closed_kerr_legs.wgsl integrates the difference. Light that falls in to a camera next to the
// horizon, or inside it, is followed in Kerr's ingoing azimuth, whose rate a (E - K' u^2/(W +
// |u'|)) has no pole there. Derived.
//
// Gives: RadialCourse, dragged_azimuth, path_to, radial_course, regular_integral.

// A ray's radial motion from the camera on.
struct RadialCourse {
    // The turning point, or the place where the ray is slowest.
    centre: Centre,
    // The camera's distance from it.
    distance: f32,
    // Whether the light falls in from outside to a camera next to the horizon or inside it.
    ingoing: bool,
}

// The path from the camera to u, before or after the turn. A ray that has turned covers the leg
// from the centre to the nearer of camera and u twice. `scale` is that of leg_between.
fn path_to(m: Radial, course: RadialCourse, u: f32, returned: bool, scale: f32) -> Path {
    let centre = course.centre;
    let y = centre.side * (centre.u - u);
    let end = abs(y);
    let near = min(end, course.distance);
    let far = max(end, course.distance);
    var second = leg_between(centre, 0.0, near, select(0.0, 2.0, returned), scale);
    if m.has_barrier || y >= 0.0 {
        return Path(leg_between(centre, near, far, 1.0, scale), second);
    }
    // The ray passes the centre.
    second = leg_between(passing_centre(m, centre.u, -centre.side), 0.0, end, 1.0, scale);
    return Path(leg_between(centre, 0.0, course.distance, 1.0, scale), second);
}

// The integral of a regular quantity less its value at the centre, from the camera to u.
fn regular_integral(m: Radial, c: PhotonConstants, course: RadialCourse, at: Regular, u: f32, returned: bool) -> f32 {
    return regular_along(c, path_to(m, course, u, returned, regular_scale(c, course.centre, at)), at);
}

// Boyer-Lindquist's azimuth, at u, of infalling light that has not turned.
fn azimuth_of_ingoing(m: Radial, c: PhotonConstants, course: RadialCourse, u: f32, t: f32) -> f32 {
    let at = regular_at(c, course.centre, 0.0, 1.0);
    let gain = (c.energy - at.value) * t - regular_integral(m, c, course, at, u, false);
    let lag = azimuth_lag(horizon_factors_at(u), vec2<f32>(1.0), u);
    return scene.observer.ingoing_azimuth_lead + scene.hole.a * gain + lag;
}

// The radial course of a ray with the slope u' at the camera, up to u_end.
fn radial_course(m: Radial, c: PhotonConstants, slope: f32, u_end: f32) -> RadialCourse {
    let u = scene.observer.u;
    let ingoing = NEAR_HORIZON && slope < 0.0;
    if is_slow_outgoing(m, slope) {
        return RadialCourse(camera_centre(m, c, slope), 0.0, ingoing);
    }
    if m.has_barrier {
        let turn = turning_point(m, u < m.barrier);
        return RadialCourse(turn, distance_from(turn, u, slope * slope), ingoing);
    }
    let u_slowest = clamp(m.base, min(u, u_end), max(u, u_end));
    let slowest = passing_centre(m, u_slowest, select(-1.0, 1.0, u <= u_slowest));
    return RadialCourse(slowest, abs(u_slowest - u), ingoing);
}

// The azimuth at u, which the ray reaches at the time t, before or after its turn at `turn_time`.
fn dragged_azimuth(m: Radial, c: PhotonConstants, course: RadialCourse, u: f32, returned: bool, t: f32, turn_time: f32) -> f32 {
    if NEAR_HORIZON && course.ingoing && !returned {
        return azimuth_of_ingoing(m, c, course, u, t);
    }
    let scale = abs(course.centre.beyond);
    var path = path_to(m, course, u, returned, scale);
    var before = 0.0;
    var since = t;
    let camera_is_nearer = course.distance < abs(course.centre.u - u);
    var end = select(u, scene.observer.u, camera_is_nearer);
    if NEAR_HORIZON && course.ingoing {
        // Up to the turn in the ingoing azimuth.
        before = azimuth_of_ingoing(m, c, course, course.centre.u, turn_time);
        since = t - turn_time;
        end = u;
        let from_turn = leg_between(course.centre, 0.0, abs(course.centre.u - u), 1.0, scale);
        path = Path(leg_between(course.centre, 0.0, 0.0, 0.0, scale), from_turn);
    }
    return before + dragging_along(c, path, since, end);
}
