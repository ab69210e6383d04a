// The integral of K' (1 + a^2 u^2)/(W + |u'|) - B, a part of the delay of the method closed around a hole
// that spins (delay/closed_kerr.wgsl). The first term at the centre of the ray's course, times the time, is
// taken out, so that what grows next to the critical curve is exact. Derived.
//
// Needs: Constants, Course, Radial, regular_at, regular_way, scene, square.
// Gives: radial_delay.

// The integral from the camera to u, which the backward ray reaches at the time t, before or after the
// turn.
fn radial_delay(m: Radial, c: Constants, course: Course, u: f32, returned: bool, t: f32) -> f32 {
    let at = regular_at(c, course.centre, 1.0, square(scene.hole.a));
    return (at.value - c.drag) * t + regular_way(m, c, course, at, u, returned);
}
