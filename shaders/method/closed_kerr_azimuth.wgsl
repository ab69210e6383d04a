// The azimuth of the method closed around a hole that spins: how far frame dragging has turned the
// ray when it is at u. What the dragging at the centre of the ray's course gives is in closed form;
// closed_kerr_legs.wgsl adds the rest.
//
// Light that comes in from outside to a camera next to the horizon, or inside it, is followed in Kerr's
// ingoing azimuth, whose rate a (E - K' u^2/(W + |u'|)) has no pole there. Derived.
//
// Needs: Centre, Constants, NEAR_HORIZON, Radial, Regular, azimuth_lag, distance_from,
//     horizon_factors_at, horizon_function, leg_azimuth, passing_centre, regular_at, regular_leg,
//     scene.
// Gives: Course, course_from, dragged_azimuth, regular_way.

// A ray's radial motion from the camera on.
struct Course {
    // The turning point, or the place where the ray is slowest.
    centre: Centre,
    // The dragging there.
    dragging: f32,
    // The camera's distance from it.
    distance: f32,
    // Whether the light came in from outside to a camera next to the horizon or inside it.
    comes_in: bool,
}

// The one or two legs of the way from the camera to a place: the distances from the centre between
// which the first leg leads, and the one to which the second leg leads from the centre.
struct Way {
    first: vec2<f32>,
    // The centre as the second leg sees it.
    far_side: Centre,
    second_end: f32,
    // How many second legs there are, for a loop in place of a branch (closed_kerr.wgsl).
    second_legs: u32,
}

fn way_to(m: Radial, course: Course, u: f32, returned: bool) -> Way {
    let centre = course.centre;
    let y = centre.side * (centre.u - u);
    let passes = returned || y < 0.0 && !m.has_barrier;
    var far_side = centre;
    if !m.has_barrier {
        far_side = passing_centre(m, centre.u, -centre.side);
    }
    let end = select(max(y, 0.0), abs(y), passes);
    let near = select(min(end, course.distance), 0.0, passes);
    let far = select(max(end, course.distance), course.distance, passes);
    return Way(vec2<f32>(near, far), far_side, end, select(0u, 1u, passes));
}

// The integral of a regular quantity less its value at the centre, from the camera to u before or after
// the turn.
fn regular_way(m: Radial, c: Constants, course: Course, at: Regular, u: f32, returned: bool) -> f32 {
    let way = way_to(m, course, u, returned);
    var sum = regular_leg(c, course.centre, at, way.first.x, way.first.y);
    for (var i = 0u; i < way.second_legs; i++) {
        sum += regular_leg(c, way.far_side, at, 0.0, way.second_end);
    }
    return sum;
}

// Boyer-Lindquist's azimuth of light that came in from outside and has not turned, at u.
fn azimuth_of_ingoing(m: Radial, c: Constants, course: Course, u: f32, t: f32) -> f32 {
    let at = regular_at(c, course.centre, 0.0, 1.0);
    let gain = (c.energy - at.value) * t - regular_way(m, c, course, at, u, false);
    let lag = azimuth_lag(horizon_factors_at(u), vec2<f32>(1.0), u);
    return scene.observer.ingoing_azimuth_lead + scene.hole.a * gain + lag;
}

// The course of a ray that turns at `turn`, or that leads from the camera to u_end without a turn.
// `slope` is u' at the camera.
fn course_from(m: Radial, c: Constants, angular_momentum: f32, slope: f32, turn: Centre, u_end: f32) -> Course {
    let u = scene.observer.u;
    let u_slowest = clamp(m.base, min(u, u_end), max(u, u_end));
    var centre = passing_centre(m, u_slowest, select(-1.0, 1.0, u <= u_slowest));
    var distance = abs(u_slowest - u);
    if m.has_barrier {
        centre = turn;
        distance = distance_from(turn, u, slope * slope);
    }
    let d = horizon_function(vec4<f32>(centre.beyond)).x;
    var dragging = -scene.hole.a * centre.u * (m.energy - scene.hole.a * angular_momentum * centre.u) / d;
    if centre.u > 0.5 * scene.hole.horizon_u {
        let w = c.horizon_w + c.drag * centre.beyond * (2.0 * scene.hole.horizon_u + centre.beyond);
        dragging = scene.hole.a * (c.energy - w / d);
    }
    return Course(centre, dragging, distance, NEAR_HORIZON && slope < 0.0);
}

// The azimuth at u, which the ray reaches at the time t, before or after it has turned at the time
// `turn_time`.
fn dragged_azimuth(m: Radial, c: Constants, course: Course, u: f32, returned: bool, t: f32, turn_time: f32) -> f32 {
    if NEAR_HORIZON && course.comes_in && !returned {
        return azimuth_of_ingoing(m, c, course, u, t);
    }
    let way = way_to(m, course, u, returned);
    var sum = 0.0;
    if NEAR_HORIZON && course.comes_in {
        sum = azimuth_of_ingoing(m, c, course, course.centre.u, turn_time) + course.dragging * (t - turn_time);
    } else {
        sum = course.dragging * t + leg_azimuth(c, course.centre, way.first.x, way.first.y);
    }
    for (var i = 0u; i < way.second_legs; i++) {
        sum += leg_azimuth(c, way.far_side, 0.0, way.second_end);
    }
    return sum;
}
