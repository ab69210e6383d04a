// The azimuth of the method mino: the growth of chi by frame dragging, chi' = a (E - W/D).
//
// Gives: Angle, add_angle, azimuth_gain, azimuth_lag_to_infinity, wrap_angle.

// The four Gauss-Legendre nodes on [0, 1], 1/2 -+ sqrt(3/7 +- (2/7) sqrt(6/5))/2, and the weights
// of the outer and the inner two, (18 -+ sqrt(30))/72.
const NODE_1: f32 = 0.0694318442;
const NODE_2: f32 = 0.3300094782;
const NODE_3: f32 = 0.6699905218;
const NODE_4: f32 = 0.9305681558;
const OUTER_WEIGHT: f32 = 0.1739274226;
const INNER_WEIGHT: f32 = 0.3260725774;

// An angle of any number of turns: a multiple of 1/16, and the rest of at most 1/32.
struct Angle {
    whole: f32,
    rest: f32,
}

// The growth of chi from the start of a step to its share t, where the ray is at v.
fn azimuth_gain(m: Motion, c: Curve, h: f32, t: f32, v: f32, regular: bool, ingoing: bool) -> f32 {
    if !NEAR_HORIZON || !regular {
        return smooth_azimuth_gain(m, c, h, t);
    }
    let gain = regular_azimuth_gain(m, c, h, t);
    if ingoing {
        return gain;
    }
    let start = c.c0.x;
    return gain - azimuth_lag(horizon_factors(m.base, start), horizon_factors(m.base, v), abs(v - start));
}

// Away from the horizon and at a turning point the rate is smooth.
fn smooth_azimuth_gain(m: Motion, c: Curve, h: f32, t: f32) -> f32 {
    let outer = vec2<f32>(curve_at(c, NODE_1 * t).x, curve_at(c, NODE_4 * t).x);
    let inner = vec2<f32>(curve_at(c, NODE_2 * t).x, curve_at(c, NODE_3 * t).x);
    let sum = OUTER_WEIGHT * dragging_sum(m, outer) + INNER_WEIGHT * dragging_sum(m, inner);
    return scene.hole.a * h * t * sum;
}

// The sum of E - W/D at two places, with one division for both.
fn dragging_sum(m: Motion, v: vec2<f32>) -> f32 {
    let above = m.dragging.x + v * (m.dragging.y + v * m.dragging.z);
    let below = m.d.x + v * (m.d.y + v * m.d.z);
    return (above.x * below.y + above.y * below.x) / (below.x * below.y);
}

// Next to the horizon W/D has a pole. There W^2 - U = K' u^2 D makes
//
//   chi' = a (E - K' u^2 / (W + |u'|)) - a |u'| / D.
//
// The first part is the regular rate in Kerr's ingoing coordinates for infalling light, and in the
// outgoing ones for outgoing light; this function integrates it. While the ray does not turn,
// azimuth_lag integrates the second part.
fn regular_azimuth_gain(m: Motion, c: Curve, h: f32, t: f32) -> f32 {
    var nodes = array<vec2<f32>, 4>(
        vec2<f32>(NODE_1, OUTER_WEIGHT),
        vec2<f32>(NODE_2, INNER_WEIGHT),
        vec2<f32>(NODE_3, INNER_WEIGHT),
        vec2<f32>(NODE_4, OUTER_WEIGHT),
    );
    var sum = 0.0;
    for (var i = 0u; i < 4u; i++) {
        let share = t * nodes[i].x;
        let v = curve_at(c, share).x;
        let speed = abs(curve_slope(c, share).x) / h;
        let pulled = m.constants.k_prime * square(m.base + v);
        sum += nodes[i].y * (m.constants.energy - pulled / max(quadratic(m.w, v) + speed, TINY));
    }
    return scene.hole.a * h * t * sum;
}

// The lag of Kerr's ingoing azimuth, which vanishes at u = 0.
fn azimuth_lag_to_infinity(m: Motion, v: f32) -> f32 {
    return azimuth_lag(horizon_factors(m.base, v), vec2<f32>(1.0), m.base + v);
}

fn add_angle(angle: Angle, gain: f32) -> Angle {
    let sum = angle.rest + gain;
    let sixteenths = 0.0625 * round(16.0 * sum);
    return Angle(angle.whole + sixteenths, sum - sixteenths);
}

// The angle within [-pi, pi]; 2 pi is subtracted in two parts, the first with few digits.
fn wrap_angle(angle: Angle) -> f32 {
    let turns = round(angle.whole * 0.159154943);
    return (angle.whole - turns * 6.28125) + (angle.rest - turns * 1.93530718e-3);
}
