// The radial part of the delay of the method closed around a spinning hole: the integral of K' (1 +
// a^2 u^2)/(W + |u'|) - B. Its value at the ray's centre times the time, which grows next to the
// critical curve, is exact.
//
// Gives: radial_delay.

// The integral from the camera to u, which the ray reaches at the time t, before or after its turn.
fn radial_delay(m: Radial, c: PhotonConstants, course: RadialCourse, u: f32, returned: bool, t: f32) -> f32 {
    let at = regular_at(c, course.centre, 1.0, square(scene.hole.a));
    return (at.value - c.drag) * t + regular_integral(m, c, course, at, u, returned);
}
