// The delay of the method closed around a hole that spins. As for the method mino (delay/mino.wgsl),
// on every stretch on which r does not turn
//
//   delay = |r*(end) - r*(start)|
//       + integral of [K' (1 + a^2 u^2)/(W + |u'|) - B + a^2 E n_z^2] dtau.
//
// The first term of the bracket at the centre of the ray's course, times the time, is taken out, so
// that what grows next to the critical curve is exact; closed_kerr_legs.wgsl integrates the rest, and
// closed_kerr_polar.wgsl has the last term in closed form. Derived.
//
// Needs: Constants, Course, Radial, TINY, horizon_factors_at, regular_at, regular_way, scene,
//     square, tortoise.
// Gives: crossing_delay.

// The delay of light from u, which the backward ray reaches at the time t, before or after it has
// turned. It is counted from the camera's outgoing time. `height2` is the integral of a^2 E^2 n_z^2.
fn crossing_delay(
    m: Radial,
    c: Constants,
    course: Course,
    inward: bool,
    u: f32,
    returned: bool,
    t: f32,
    height2: f32,
) -> f32 {
    let at = regular_at(c, course.centre, 1.0, square(scene.hole.a));
    let energy = select(c.energy, TINY, abs(c.energy) < TINY);
    let delay = (at.value - c.drag) * t + regular_way(m, c, course, at, u, returned) + height2 / energy;
    // The tortoise coordinate, less that of the camera for light that leaves outward.
    let here = tortoise(u, horizon_factors_at(u));
    let camera = select(2.0 * scene.observer.time_lead, 0.0, inward);
    if returned {
        let turn = 2.0 * tortoise(course.centre.u, horizon_factors_at(course.centre.u));
        return delay + select(turn - here, here - turn, inward) - camera;
    }
    return delay + select(here, -here, inward) - camera;
}
