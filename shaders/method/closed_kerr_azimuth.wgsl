// The azimuth of the method closed around a hole that spins: how far frame dragging has turned the
// ray when it is at u. What the dragging at the centre of the ray's course gives is in closed form;
// closed_kerr_legs.wgsl adds the rest.
//
// Light that comes in from outside to a camera next to the horizon, or inside it, is followed in Kerr's
// ingoing azimuth, whose rate a (E - K' u^2/(W + |u'|)) has no pole there. Derived.
//
// Needs: Centre, Constants, NEAR_HORIZON, Radial, Regular, Way, azimuth_lag, camera_centre,
//     distance_from, dragging_along, horizon_factors_at, leaves_slowly, leg_between, passing_centre,
//     regular_along, regular_at, regular_scale, scene, turning_point.
// Gives: Course, course_from, dragged_azimuth, regular_way, way_to.

// A ray's radial motion from the camera on.
struct Course {
    // The turning point, or the place where the ray is slowest.
    centre: Centre,
    // The camera's distance from it.
    distance: f32,
    // Whether the light came in from outside to a camera next to the horizon or inside it.
    comes_in: bool,
}

// The way from the camera to u, before or after the turn. A ray that has turned goes twice along the leg
// from the centre to the nearer one of camera and u. `scale` is that of leg_between.
fn way_to(m: Radial, course: Course, u: f32, returned: bool, scale: f32) -> Way {
    let centre = course.centre;
    let y = centre.side * (centre.u - u);
    let end = abs(y);
    let near = min(end, course.distance);
    let far = max(end, course.distance);
    var second = leg_between(centre, 0.0, near, select(0.0, 2.0, returned), scale);
    if m.has_barrier || y >= 0.0 {
        return Way(leg_between(centre, near, far, 1.0, scale), second);
    }
    // The ray passes the centre.
    second = leg_between(passing_centre(m, centre.u, -centre.side), 0.0, end, 1.0, scale);
    return Way(leg_between(centre, 0.0, course.distance, 1.0, scale), second);
}

// The integral of a regular quantity less its value at the centre, from the camera to u before or after
// the turn.
fn regular_way(m: Radial, c: Constants, course: Course, at: Regular, u: f32, returned: bool) -> f32 {
    return regular_along(c, way_to(m, course, u, returned, regular_scale(c, course.centre, at)), at);
}

// Boyer-Lindquist's azimuth of light that came in from outside and has not turned, at u.
fn azimuth_of_ingoing(m: Radial, c: Constants, course: Course, u: f32, t: f32) -> f32 {
    let at = regular_at(c, course.centre, 0.0, 1.0);
    let gain = (c.energy - at.value) * t - regular_way(m, c, course, at, u, false);
    let lag = azimuth_lag(horizon_factors_at(u), vec2<f32>(1.0), u);
    return scene.observer.ingoing_azimuth_lead + scene.hole.a * gain + lag;
}

// The course of a ray that has the slope u' at the camera, and ends at u_end.
fn course_from(m: Radial, c: Constants, slope: f32, u_end: f32) -> Course {
    let u = scene.observer.u;
    let comes_in = NEAR_HORIZON && slope < 0.0;
    if leaves_slowly(m, slope) {
        return Course(camera_centre(m, c, slope), 0.0, comes_in);
    }
    if m.has_barrier {
        let turn = turning_point(m, u < m.barrier);
        return Course(turn, distance_from(turn, u, slope * slope), comes_in);
    }
    let u_slowest = clamp(m.base, min(u, u_end), max(u, u_end));
    let slowest = passing_centre(m, u_slowest, select(-1.0, 1.0, u <= u_slowest));
    return Course(slowest, abs(u_slowest - u), comes_in);
}

// The azimuth at u, which the ray reaches at the time t, before or after it has turned at the time
// `turn_time`.
fn dragged_azimuth(m: Radial, c: Constants, course: Course, u: f32, returned: bool, t: f32, turn_time: f32) -> f32 {
    if NEAR_HORIZON && course.comes_in && !returned {
        return azimuth_of_ingoing(m, c, course, u, t);
    }
    let scale = abs(course.centre.beyond);
    var way = way_to(m, course, u, returned, scale);
    var before = 0.0;
    var since = t;
    let camera_is_nearer = course.distance < abs(course.centre.u - u);
    var end = select(u, scene.observer.u, camera_is_nearer);
    if NEAR_HORIZON && course.comes_in {
        // Up to the turn in the ingoing azimuth.
        before = azimuth_of_ingoing(m, c, course, course.centre.u, turn_time);
        since = t - turn_time;
        end = u;
        let from_turn = leg_between(course.centre, 0.0, abs(course.centre.u - u), 1.0, scale);
        way = Way(leg_between(course.centre, 0.0, 0.0, 0.0, scale), from_turn);
    }
    return before + dragging_along(c, way, since, end);
}
