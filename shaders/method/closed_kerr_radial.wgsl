// The radial motion of the method closed around a spinning hole. With u = 1/r and Mino time tau,
//
//   u'^2 = U(u) = W^2 - K' u^2 D,   u'' = u p(u),   p = p_0 + p_1 u + p_2 u^2,
//   W = E + B u^2,   D = 1 - u + a^2 u^2,   B = a (a E - L),
//   p_0 = 2 E B - K',   p_1 = 3 K'/2,   p_2 = 2 (B^2 - a^2 K').
//
// U has critical points at u = 0 and where p vanishes. About one of them, with v = u - base,
//
//   U = b_0 + alpha v^2 + beta v^3 + gamma v^4
//
// has no linear term. Weierstrass's cubic 4 t^3 - g2 t - g3 has the root -alpha/6 + offset, where
//
//   4 offset^3 - 2 alpha offset^2 + (alpha^2/4 - gamma b_0) offset + beta^2 b_0/16 = 0,
//
// and the pair alpha/12 - offset/2 +- sqrt(h2), 4 h2 = gamma b_0 + offset (alpha - 3 offset). All
// of them are accurate next to the critical curve, where b_0 alone is small. Derived.
//
// Gives: Anchor, Centre, Radial, TimeArguments, anchor_at, anchor_at_centre, distance_from,
//     mino_time, passing_centre, potential, radial_of, radial_series, stiffness_at_horizon,
//     stiffness_slope_at_horizon, time_between, time_from_turn, turning_point, u_after.

// The cubic's root is small below this share of |alpha|: the cubic term changes it by under a
// tenth.
const MAX_SMALL_ROOT: f32 = 0.05;
// The largest pole term in the arguments of R_F next to a turning point: its square is finite in
// f32.
const MAX_POLE: f32 = 1e18;
// Rays with a smaller |b_0|/W^2 get this one.
const MIN_MARGIN: f32 = 2e-8;

struct Radial {
    energy: f32,
    k_prime: f32,
    // p_0, p_1, p_2.
    p: vec3<f32>,
    base: f32,
    // base - 1/r_+.
    base_beyond: f32,
    b_0: f32,
    alpha: f32,
    beta: f32,
    gamma: f32,
    offset: f32,
    h2: f32,
    // Whether light turns on both sides of u = barrier.
    has_barrier: bool,
    barrier: f32,
}

// A turning point, or another point of expansion: U is c_0 + dot(c, (y, y^2, y^3, y^4)) at the
// distance y toward smaller u (side 1) or larger u (side -1).
struct Centre {
    u: f32,
    // u - 1/r_+.
    beyond: f32,
    side: f32,
    c_0: f32,
    c: vec4<f32>,
    // The arguments of R_F for y -> infinity.
    isolated: f32,
    pair: f32,
}

// `offset`: the root of its cubic with the sign opposite to that of b_0; of three, the one next to
// zero.
//
// The start is the root without the cubic term where it is small, or else the root about the
// inflection at alpha/6: Cardano's where the cubic has one real root, and where it has three, with
// z = +-m (1 + x), an approximation of 3 x^2 + x^3 = t to two per cent. Two steps of Newton's
// method leave a relative error of 1e-7.
fn isolated_offset(alpha: f32, beta: f32, gamma: f32, b_0: f32) -> f32 {
    let side = select(1.0, -1.0, b_0 > 0.0);
    let bend = side * alpha;
    let slope = 0.25 * alpha * alpha - gamma * b_0;
    let constant = 0.0625 * beta * beta * abs(b_0);
    let discriminant = slope * slope - 8.0 * bend * constant;
    let small = 2.0 * constant / max(slope + sqrt(max(discriminant, 0.0)), TINY);
    var y = small;
    if small >= MAX_SMALL_ROOT * abs(bend) || discriminant < 0.25 * slope * slope {
        let m2 = bend * bend * (1.0 / 36.0) - slope * (1.0 / 12.0);
        let half_q = 0.125 * (constant + bend * (bend * bend * (1.0 / 27.0) - slope * (1.0 / 6.0)));
        let d = half_q * half_q - m2 * m2 * m2;
        y = bend * (1.0 / 6.0);
        if d >= 0.0 {
            let cube_root = exp2(log2(max(abs(half_q) + sqrt(d), TINY)) * (1.0 / 3.0));
            y += select(-1.0, 1.0, half_q >= 0.0) * (cube_root + m2 / cube_root);
        } else {
            let m = sqrt(m2);
            let which = select(1.0, -1.0, bend > 0.0 && slope > 0.0);
            let t = max(2.0 + which * 2.0 * half_q / max(m * m2, TINY), 0.0);
            y += which * m * (1.0 + sqrt(t / (3.0 + sqrt(t * (1.0 / 3.0)))));
        }
    }
    for (var i = 0u; i < 2u; i++) {
        let rate = slope + y * (12.0 * y - 4.0 * bend);
        y -= (y * (slope + y * (4.0 * y - 2.0 * bend)) - constant) / select(rate, TINY, abs(rate) < TINY);
    }
    return side * y;
}

// q_0, where p is q_0 + q_1 v + p_2 v^2 at the distance v from the horizon.
fn stiffness_at_horizon(c: PhotonConstants) -> f32 {
    let fall = 0.5 * scene.hole.horizon_u * scene.hole.horizon_separation;
    return 2.0 * c.drag * c.horizon_w + c.k_prime * fall;
}

// q_1. By a^2 = r_+ r_-, 4 a^2/r_+ is 2 - 2 s.
fn stiffness_slope_at_horizon(c: PhotonConstants) -> f32 {
    return c.k_prime * (2.0 * scene.hole.horizon_separation - 0.5) + 4.0 * square(c.drag) * scene.hole.horizon_u;
}

fn radial_of(c: PhotonConstants, slope: f32) -> Radial {
    let energy = c.energy;
    let p = vec3<f32>(c.stiffness, 1.5 * c.k_prime, 2.0 * (square(c.drag) - square(scene.hole.a) * c.k_prime));
    var radial: Radial;
    radial.energy = energy;
    radial.k_prime = c.k_prime;
    radial.p = p;
    // About u = 0.
    radial.base_beyond = -scene.hole.horizon_u;
    radial.b_0 = energy * energy;
    radial.alpha = p.x;
    radial.beta = c.k_prime;
    radial.gamma = 0.5 * p.z;
    let root2 = p.y * p.y - 4.0 * p.x * p.z;
    if p.x < 0.0 && root2 >= 0.0 {
        var root = sqrt(root2);
        var u = -2.0 * p.x / (p.y + root);
        var v = (u - scene.hole.horizon_u) - scene.hole.horizon_u_low;
        var w = energy + c.drag * u * u;
        var d = 1.0 - u + square(scene.hole.a * u);
        let q_1 = stiffness_slope_at_horizon(c);
        if q_1 > 0.0 && abs(v) < 0.25 * scene.hole.horizon_u {
            // The same about the horizon: p_1^2 and 4 p_0 p_2 nearly cancel in a throat.
            let q_0 = stiffness_at_horizon(c);
            root = sqrt(max(q_1 * q_1 - 4.0 * q_0 * p.z, 0.0));
            v = -2.0 * q_0 / (q_1 + root);
            u = scene.hole.horizon_u + (scene.hole.horizon_u_low + v);
            w = c.horizon_w + c.drag * v * (2.0 * scene.hole.horizon_u + v);
            d = v * (square(scene.hole.a) * v - scene.hole.horizon_separation);
        }
        let least = MIN_MARGIN * max(w * w, TINY);
        var b_0 = w * w - c.k_prime * u * u * d;
        let alpha = u * root;
        let beta = (2.0 / 3.0) * (root + p.z * u);
        // Next to the camera, its slope gives b_0 more accurately.
        let v_0 = -(scene.observer.u_to_horizon + v);
        let bent = v_0 * v_0 * (alpha + v_0 * (beta + 0.5 * v_0 * p.z));
        if slope * slope + abs(bent) < 0.25 * w * w {
            b_0 = slope * slope - bent;
        }
        b_0 = select(max(b_0, least), min(b_0, -least), b_0 < 0.0);
        radial.has_barrier = v < 0.0 && b_0 < 0.0;
        radial.barrier = u;
        // Where light is hardly bent, the critical point at u = 0 is the better base.
        if b_0 > -energy * energy || v_0 > 0.0 {
            radial.base = u;
            radial.base_beyond = v;
            radial.b_0 = b_0;
            radial.alpha = alpha;
            radial.beta = beta;
        }
    }
    radial.offset = isolated_offset(radial.alpha, radial.beta, radial.gamma, radial.b_0);
    radial.h2 = 0.25 * (radial.gamma * radial.b_0 + radial.offset * (radial.alpha - 3.0 * radial.offset));
    return radial;
}

fn potential(m: Radial, u: f32) -> f32 {
    let v = u - m.base;
    return max(m.b_0 + v * v * (m.alpha + v * (m.beta + v * m.gamma)), 0.0);
}

// The coefficients of U's growth from base + v to one side: `c` of a Centre.
fn growth_from(m: Radial, v: f32, side: f32) -> vec4<f32> {
    return vec4<f32>(
        -side * v * (2.0 * m.alpha + v * (3.0 * m.beta + v * 4.0 * m.gamma)),
        m.alpha + v * (3.0 * m.beta + v * 6.0 * m.gamma),
        -side * (m.beta + 4.0 * m.gamma * v),
        m.gamma,
    );
}

// The turning point on the outer or the inner side of the barrier, from the roots s = 1/v of b_0
// s^4 + alpha s^2 + beta s + gamma by Euler's solution.
fn turning_point(m: Radial, outer: bool) -> Centre {
    let mean = 0.25 * m.alpha - 0.5 * m.offset;
    let product = sqrt(max(mean * mean - m.h2, 0.0));
    // About a barrier b_0 is negative, with a root on either side; about u = 0 it is positive.
    let share = 4.0 / max(abs(m.b_0), TINY);
    let sum = sqrt(2.0 * share * (abs(mean) + product));
    let third = sign(m.beta) * sqrt(max(-select(-share, share, m.b_0 > 0.0) * m.offset, 0.0));
    let about_barrier = m.base > 0.0;
    let sum_of_roots = select(sum - third, sum + third, about_barrier && !outer);
    let v = select(2.0, -2.0, about_barrier && outer) / max(sum_of_roots, TINY);
    let side = select(-1.0, 1.0, outer);
    let bend = v * (3.0 * m.beta + v * 6.0 * m.gamma);
    let isolated = 0.25 * m.alpha + bend * (1.0 / 12.0) - m.offset;
    let pair = bend * (1.0 / 12.0) + 0.5 * m.offset;
    return Centre(m.base + v, m.base_beyond + v, side, 0.0, growth_from(m, v, side), isolated, pair);
}

// A place on a ray that does not turn, as the centre of a leg on one of its sides.
fn passing_centre(m: Radial, u: f32, side: f32) -> Centre {
    let v = u - m.base;
    let c_0 = m.b_0 + v * v * (m.alpha + v * (m.beta + v * m.gamma));
    return Centre(u, m.base_beyond + v, side, max(c_0, 0.0), growth_from(m, v, side), 0.0, 0.0);
}

// The distance of a place with u and u'^2 from a turning point. Close to it, u'^2 is more precise.
fn distance_from(centre: Centre, u: f32, speed2: f32) -> f32 {
    var y = max(centre.side * (centre.u - u), 0.0);
    if y < 0.25 * centre.u {
        let c = centre.c;
        for (var i = 0u; i < 2u; i++) {
            let value = y * (c.x + y * (c.y + y * (c.z + y * c.w))) - speed2;
            let rate = c.x + y * (2.0 * c.y + y * (3.0 * c.z + y * 4.0 * c.w));
            y = max(y - value / select(rate, TINY, abs(rate) < TINY), 0.0);
        }
    }
    return y;
}

// The arguments of R_F: the Mino time between two places is R_F(isolated, pair, h2).
struct TimeArguments {
    isolated: f32,
    pair: f32,
}

// From a turning point to the distance y.
fn time_from_turn(centre: Centre, y: f32) -> TimeArguments {
    let pole = centre.c.x / max(4.0 * y, max(centre.c.x / MAX_POLE, TINY));
    return TimeArguments(pole + centre.isolated, pole + centre.pair);
}

// Between two places (u, |u'|) without a turn between them, from the quartic's polarised form F(x,
// y): P = (F(x, y) + |x'| |y'|)/(2 (x - y)^2). With x and y relative to the critical point and C =
// alpha + beta (x + y)/2 + gamma x y, F is b_0 + x y C plus a term that P's root takes away. On
// opposite sides of the critical point x y C and |x'| |y'| nearly cancel, and their sum follows
// from
//
//   (|x'| |y'|)^2 - (x y C)^2 = b_0 (x'^2 + y'^2 - b_0) + (x y (x - y))^2 (alpha gamma - beta^2/4).
fn time_between(m: Radial, x: vec2<f32>, y: vec2<f32>) -> TimeArguments {
    let speeds = x.y * y.y;
    let width2 = max(square(x.x - y.x), TINY);
    let v = vec2<f32>(x.x, y.x) - m.base;
    let product = v.x * v.y;
    let middle = product * (m.alpha + 0.5 * m.beta * (v.x + v.y) + m.gamma * product);
    let squares = m.b_0 * (x.y * x.y + y.y * y.y - m.b_0)
        + product * product * width2 * (m.alpha * m.gamma - 0.25 * m.beta * m.beta);
    let sum = select(middle + speeds, squares / max(speeds - middle, TINY), product < 0.0);
    let pair = 0.5 * m.offset + 0.5 * (m.b_0 + sum) / width2;
    return TimeArguments(pair + 0.25 * m.alpha - 1.5 * m.offset, pair);
}

fn mino_time(m: Radial, arguments: TimeArguments) -> f32 {
    return carlson_rf_pair(arguments.isolated, arguments.pair, m.h2);
}

// A place on the ray, U there, and half its first, its second and its third derivative.
struct Anchor {
    u: f32,
    slope: f32,
    derivatives: vec3<f32>,
}

fn anchor_at(m: Radial, u: f32, slope: f32) -> Anchor {
    let accel = m.p.x + u * (m.p.y + u * m.p.z);
    let accel_slope = m.p.y + 2.0 * m.p.z * u;
    let derivatives = vec3<f32>(u * accel, 2.0 * (accel + u * accel_slope), 4.0 * (accel_slope + u * m.p.z));
    return Anchor(u, slope, derivatives);
}

fn anchor_at_centre(centre: Centre, slope: f32) -> Anchor {
    let c = centre.c;
    return Anchor(centre.u, slope, vec3<f32>(-0.5 * centre.side * c.x, 2.0 * c.y, -6.0 * centre.side * c.z));
}

fn radial_series(m: Radial) -> LaurentSeries {
    let e2 = m.energy * m.energy;
    let p = m.p;
    let g2 = p.x * p.x * (1.0 / 12.0) + 0.5 * p.z * e2;
    let g3 = e2 * (p.z * p.x * (1.0 / 12.0) - square(0.25 * m.k_prime)) - p.x * p.x * p.x * (1.0 / 216.0);
    return laurent_series(g2, g3);
}

// u at the time t after the anchor, through turning points: Biermann's and Weierstrass's solution
// (Whittaker & Watson 1927 section 20.6), times t^4 above and below.
fn u_after(m: Radial, series: LaurentSeries, anchor: Anchor, t: f32) -> f32 {
    let pole = weierstrass_of(series, t);
    let slope = anchor.slope;
    let d = anchor.derivatives;
    let t2 = t * t;
    let f = slope * slope;
    let x = 1.0 + pole.even - t2 * d.y * (1.0 / 24.0);
    let rise = 2.0 * slope * (1.0 + pole.odd) + t * (d.x * x + t2 * f * d.z * (1.0 / 24.0));
    let below = 2.0 * x * x - 0.25 * t2 * t2 * f * m.p.z;
    return anchor.u + t * rise / select(below, TINY, abs(below) < TINY);
}
