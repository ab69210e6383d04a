// The equations of motion of the method mino, and one step along them; geometry/mino.rs, the twin
// in f64, gives the sources. With u = 1/r, the unit vector n of azimuth psi, and phi = psi + chi:
//
//   u'^2 = U(u) = W^2 - K' u^2 D,   W = E + B u^2,   D = 1 - u + a^2 u^2 = (1 - r_+ u)(1 - r_- u),
//   u''  = u (2 B W - K' S),   S = D + u dD/du / 2,
//   n''  = a^2 E^2 n_z e_z - (K + 2 a^2 E^2 n_z^2) n,   chi' = a (E - W/D),
//   B = a (a E - L),   K' = Q + (L - a E)^2,   K = K' - 2 E B + a^2 E^2.
//
// In this form of U, unlike in that of a polynomial, E, B and K' are the only constants: however
// they are rounded, they are those of a nearby ray, and the radius of the critical orbit does not
// change. Next to the horizon of a fast-spinning hole W and D cancel. There the radial variable is
// u - 1/r_+, D's root is exact, and u' is recomputed from U at each step.
//
// The step is Nystroem's of fifth order (Nystroem 1925; Hairer, Norsett & Wanner 1993, section
// II.14). Its dense output is the quintic with the values, slopes and accelerations of both ends.
// The constants are scaled such that the step in Mino time is an angle; docs/physics/steps.md
// explains its choice.
//
// Gives: Curve, Motion, Step, acceleration, cannot_turn, curve, curve_at, curve_slope,
//     motion_about, nystroem_step, quadratic, speed_squared.

// The motion about u = base, in the variable v = u - base.
struct Motion {
    base: f32,
    constants: PhotonConstants,
    // Coefficients of the polynomials W, D, S, and E D - W.
    w: vec3<f32>,
    d: vec3<f32>,
    s: vec3<f32>,
    dragging: vec3<f32>,
}

// Both ends of a step: the state (v, n_z, n_x, n_y), its slope times the step, and its acceleration
// times the step squared.
struct Step {
    y0: vec4<f32>,
    dy0: vec4<f32>,
    k0: vec4<f32>,
    y1: vec4<f32>,
    dy1: vec4<f32>,
    k1: vec4<f32>,
}

// The state within the step, as a polynomial in the share of the step.
struct Curve {
    c0: vec4<f32>,
    c1: vec4<f32>,
    c2: vec4<f32>,
    c3: vec4<f32>,
    c4: vec4<f32>,
    c5: vec4<f32>,
}

fn motion_about(base: f32, c: PhotonConstants) -> Motion {
    let a2 = square(scene.hole.a);
    let w = vec3<f32>(select(c.energy, c.horizon_w, base > 0.0), 2.0 * c.drag * base, c.drag);
    // D's root at 1/r_+ is exact.
    let d = select(vec3<f32>(1.0, -1.0, a2), vec3<f32>(0.0, -scene.hole.horizon_separation, a2), base > 0.0);
    let s = vec3<f32>(d.x + 0.5 * base * d.y, 1.5 * d.y + base * a2, 2.0 * a2);
    return Motion(base, c, w, d, s, c.energy * d - w);
}

fn quadratic(c: vec3<f32>, v: f32) -> f32 {
    return c.x + v * (c.y + v * c.z);
}

// u''/u.
fn u_acceleration_over_u(m: Motion, v: f32) -> f32 {
    return 2.0 * m.constants.drag * quadratic(m.w, v) - m.constants.k_prime * quadratic(m.s, v);
}

fn acceleration(m: Motion, y: vec4<f32>) -> vec4<f32> {
    let polar = m.constants.stiffness - 2.0 * m.constants.axial * y.y * y.y;
    return vec4<f32>((m.base + y.x) * u_acceleration_over_u(m, y.x), polar * y.y, (polar - m.constants.axial) * y.zw);
}

// A step from the state y with dy and k1 as in Step; h2 is the step squared.
fn nystroem_step(m: Motion, h2: f32, y: vec4<f32>, dy: vec4<f32>, k1: vec4<f32>) -> Step {
    let k2 = h2 * acceleration(m, y + 0.2 * dy + 0.02 * k1);
    let k3 = h2 * acceleration(m, y + (2.0 / 3.0) * dy + ((7.0 / 27.0) * k2 - (1.0 / 27.0) * k1));
    let k4 = h2 * acceleration(m, y + dy + 0.3 * k1 + ((9.0 / 35.0) * k3 - (2.0 / 35.0) * k2));
    let end = y + (dy + ((14.0 / 336.0) * k1 + (100.0 / 336.0) * k2 + (54.0 / 336.0) * k3));
    let change = (14.0 / 336.0) * k1 + (125.0 / 336.0) * k2 + (162.0 / 336.0) * k3 + (35.0 / 336.0) * k4;
    return Step(y, dy, k1, end, dy + change, h2 * acceleration(m, end));
}

// Compilers compute only those of the four components that are used.
fn curve(s: Step) -> Curve {
    // The deviations of the end from the parabola of the start: value, slope, half the second
    // derivative.
    let r0 = (s.y1 - s.y0) - s.dy0 - 0.5 * s.k0;
    let r1 = (s.dy1 - s.dy0) - s.k0;
    let r2 = 0.5 * (s.k1 - s.k0);
    let c3 = 10.0 * r0 - 4.0 * r1 + r2;
    return Curve(s.y0, s.dy0, 0.5 * s.k0, c3, 7.0 * r1 - 15.0 * r0 - 2.0 * r2, 6.0 * r0 - 3.0 * r1 + r2);
}

fn curve_at(c: Curve, t: f32) -> vec4<f32> {
    return c.c0 + t * (c.c1 + t * (c.c2 + t * (c.c3 + t * (c.c4 + t * c.c5))));
}

fn curve_slope(c: Curve, t: f32) -> vec4<f32> {
    return c.c1 + t * (2.0 * c.c2 + t * (3.0 * c.c3 + t * (4.0 * c.c4 + t * (5.0 * c.c5))));
}

// U(u), from W^2.
fn speed_squared(m: Motion, v: f32, w2: f32) -> f32 {
    return w2 - m.constants.k_prime * square(m.base + v) * quadratic(m.d, v);
}

// Whether U is certainly positive from v to v + width, so that no ray turns there: a polynomial is
// nowhere below its smallest Bernstein coefficient (Farouki & Rajan 1987).
fn cannot_turn(m: Motion, v: f32, width: f32) -> bool {
    let u = m.base + v;
    let u2 = speed_squared(m, v, square(quadratic(m.w, v)));
    // dU/du = 2 u p, and the derivatives of p.
    let p = u_acceleration_over_u(m, v);
    let p2 = 2.0 * (2.0 * square(m.constants.drag) - m.constants.k_prime * m.s.z);
    let p1 = 2.0 * m.constants.drag * m.w.y - m.constants.k_prime * m.s.y + p2 * v;
    let c1 = 2.0 * width * u * p;
    let c2 = width * width * (p + u * p1);
    let c3 = width * width * width * (2.0 * p1 + u * p2) / 3.0;
    let c4 = 0.25 * square(width * width) * p2;
    let b12 = min(u2 + 0.25 * c1, u2 + 0.5 * c1 + c2 / 6.0);
    let b34 = min(u2 + 0.75 * c1 + 0.5 * c2 + 0.25 * c3, u2 + c1 + c2 + c3 + c4);
    return min(u2, min(b12, b34)) > 0.0;
}
