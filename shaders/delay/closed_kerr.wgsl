// The delay of the method closed around a spinning hole, by the integral of delay/mino.wgsl.
// closed_kerr_radial.wgsl or closed_kerr_throat.wgsl integrates the first two terms of its bracket;
// method/closed_kerr_polar.wgsl gives the last one in closed form.
//
// Gives: crossing_delay.

// The delay of light from u, which the backward ray reaches at the time t, after its turning point
// if it has `returned`; counted from the camera's outgoing time. `height2` is the integral of a^2
// E^2 n_z^2.
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
