// The delay of the method closed around a spinning hole. As for the method mino (delay/mino.wgsl),
// on every stretch on which r does not turn
//
//   delay = |r*(end) - r*(start)|
//       + integral of [K' (1 + a^2 u^2)/(W + |u'|) - B + a^2 E n_z^2] dtau.
//
// closed_kerr_radial.wgsl or closed_kerr_throat.wgsl integrates the first two terms of the bracket;
// method/closed_kerr_polar.wgsl gives the last one in closed form. Derived.
//
// Gives: crossing_delay.

// The delay of light from u, counted from the camera's outgoing time. The backward ray reaches u at
// the time t, after its turning point if it has `returned`. `height2` is the integral of a^2 E^2
// n_z^2.
fn crossing_delay(
    m: Radial,
    c: PhotonConstants,
    course: RadialCourse,
    inward: bool,
    u: f32,
    returned: bool,
    t: f32,
    height2: f32,
) -> f32 {
    let energy = select(c.energy, TINY, abs(c.energy) < TINY);
    let delay = radial_delay(m, c, course, u, returned, t) + height2 / energy;
    // The tortoise coordinate, less the camera's for a backward ray that starts outward.
    let here = tortoise(u, horizon_factors_at(u));
    let camera = select(2.0 * scene.observer.time_lead, 0.0, inward);
    if returned {
        let turn = 2.0 * tortoise(course.centre.u, horizon_factors_at(course.centre.u));
        return delay + select(turn - here, here - turn, inward) - camera;
    }
    return delay + select(here, -here, inward) - camera;
}
