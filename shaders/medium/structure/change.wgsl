// How the coordinates of a place change along a step.
//
// Gives: change_at.

// The change of (ln r, phi, n_z, delay) for each unit of the step's share, where the ray has the state y and
// this slope. The rates of azimuth and delay are chi' = a (E - W/D), and delay.wgsl's plain form.
fn change_at(way: Way, y: vec4<f32>, slope: vec4<f32>) -> vec4<f32> {
    let a = scene.hole.a;
    let u = max(way.motion.base + y.x, TINY);
    let energies = quadratic(way.motion.w, y.x) / max(quadratic(way.motion.d, y.x), TINY);
    let swept = (y.z * slope.w - y.w * slope.z) / max(dot(y.zw, y.zw), TINY);
    let turning = swept + a * way.h * (way.motion.constants.energy - energies);
    let slowing = (1.0 / (u * u) + a * a) * energies - way.motion.constants.drag + a * a * way.motion.constants.energy * y.y * y.y;
    return vec4<f32>(-slope.x / u, turning, slope.y, way.h * slowing);
}
