// The integrals over the legs of a ray of the method closed around a hole that spins, which give the
// growth of chi by frame dragging,
//
//   d(u) = a (E - W/D)
//
// per Mino time. A leg begins or ends at the centre c of the ray's course: the turning point, or the
// place where the ray is slowest. The difference
//
//   d(u) - d(c) = -a (u - c) (W_+ (s - a^2 (v + v_c)) - B v v_c)/(D(u) D(c)),   v = u - 1/r_+,
//
// with s = r_+ - r_-, vanishes at the centre, so that its integral has no logarithm.
//
// A leg is integrated by Gauss's and Legendre's rule over the root x of the distance y from the centre,
// which takes away the root of U at a turning point. Where the integrand changes on a scale that is much
// smaller than the leg (next to the critical curve, or next to the horizon), the leg is divided by theta
// instead: y, or behind a turning point x, is the scale times sinh(theta). Derived.
//
// Needs: Centre, Constants, TINY, scene, square.
// Gives: Regular, Way, dragging_along, horizon_function, leg_between, regular_along, regular_at,
//     regular_scale.

// The eight Gauss-Legendre nodes on [0, 1], and their weights on both sides of the middle.
const LOW_NODES: vec4<f32> = vec4<f32>(0.0198550718, 0.101666761, 0.237233795, 0.408282679);
const HIGH_NODES: vec4<f32> = vec4<f32>(0.980144928, 0.898333239, 0.762766205, 0.591717321);
const WEIGHTS: vec4<f32> = vec4<f32>(0.0506142681, 0.111190517, 0.156853323, 0.181341892);

// A leg is integrated over x if it is at most this many times as long as the scale on which the
// integrand changes: behind a turning point, where the rule's error is below 3e-7 rad then, and next to
// a place that the ray passes, where the integrand has no root to take away.
const MAX_SMOOTH_TURN: f32 = 6.0;
const MAX_SMOOTH_PASSAGE: f32 = 0.1;
// Into how many parts a leg is divided over theta. The loop over them takes half of a part's nodes in
// each pass.
const SPREAD_PARTS: u32 = 3u;
const SPREAD_PASSES: u32 = 2u * SPREAD_PARTS;
// A leg's smallest scale is at least this share of it.
const MIN_LEG_SCALE: f32 = 1e-5;

// A leg between two distances from its centre.
struct Leg {
    centre: Centre,
    low: f32,
    high: f32,
    // How often the ray goes along it.
    count: f32,
    // Whether its centre is a turning point.
    turns: bool,
    // The smallest distance on which the integrand changes, and whether the leg is divided by theta.
    scale: f32,
    spreads: bool,
}

// The legs of the way from the camera to a place.
struct Way {
    first: Leg,
    second: Leg,
}

// Places on a leg: the distance from the centre, its change with the variable of the rule, and what U
// grows by since the centre.
struct LegPlaces {
    y: vec4<f32>,
    dy: vec4<f32>,
    rise: vec4<f32>,
}

// D at a distance from the horizon.
fn horizon_function(beyond: vec4<f32>) -> vec4<f32> {
    return max(beyond * (square(scene.hole.a) * beyond - scene.hole.horizon_separation), vec4<f32>(TINY));
}

// `scale` is the smallest distance on which the integrand changes, apart from U itself.
fn leg_between(centre: Centre, low: f32, high: f32, count: f32, scale: f32) -> Leg {
    let c = abs(centre.c);
    let turns = centre.c_0 <= 0.0;
    // Where the first terms of U are as large as each other.
    let bend = select(min(centre.c_0 / max(c.x, TINY), sqrt(centre.c_0 / max(c.y, TINY))), c.x / max(c.y, TINY), turns);
    let curl = sqrt(c.x / max(c.z, TINY));
    let least = min(scale, select(bend, min(bend, curl), turns));
    let spreads = count > 0.0 && high > select(MAX_SMOOTH_PASSAGE, MAX_SMOOTH_TURN, turns) * least;
    return Leg(centre, low, high, count, turns, least, spreads);
}

fn places_at(centre: Centre, y: vec4<f32>, dy: vec4<f32>) -> LegPlaces {
    let c = centre.c;
    return LegPlaces(y, dy, y * (c.x + y * (c.y + y * (c.z + y * c.w))));
}

fn smooth_places(leg: Leg, nodes: vec4<f32>) -> LegPlaces {
    let low = sqrt(leg.low);
    let width = sqrt(leg.high) - low;
    let x = low + width * nodes;
    return places_at(leg.centre, x * x, 2.0 * width * x);
}

// The places of a pass of the loop over theta.
fn spread_places(leg: Leg, i: u32) -> LegPlaces {
    var ends = vec2<f32>(leg.low, leg.high);
    var scale = leg.scale;
    if leg.turns {
        ends = sqrt(ends);
        scale = sqrt(scale);
    }
    scale = clamp(scale, max(MIN_LEG_SCALE * ends.y, TINY), max(ends.y, TINY));
    ends /= scale;
    let theta = log(ends + sqrt(1.0 + ends * ends));
    let width = (theta.y - theta.x) / f32(SPREAD_PARTS);
    let nodes = select(HIGH_NODES, LOW_NODES, (i & 1u) == 0u);
    let e = exp(theta.x + width * (f32(i / 2u) + nodes));
    let z = 0.5 * scale * (e - 1.0 / e);
    let dz = 0.5 * width * scale * (e + 1.0 / e);
    return places_at(leg.centre, select(z, z * z, leg.turns), select(dz, 2.0 * z * dz, leg.turns));
}

// How many passes the loop over theta takes: one loop for both legs, because it is rare work for which
// software renderers pay once per loop.
fn spread_passes(way: Way) -> u32 {
    return select(0u, SPREAD_PASSES, way.first.spreads) + select(0u, SPREAD_PASSES, way.second.spreads);
}

// The leg of a pass.
fn spread_leg(way: Way, i: u32) -> Leg {
    if way.first.spreads && i < SPREAD_PASSES {
        return way.first;
    }
    return way.second;
}

// The integral of the difference d(u) - d(c) over some places on a leg, times D(c)/a.
fn dragging_sum(c: Constants, leg: Leg, p: LegPlaces) -> f32 {
    let centre = leg.centre;
    let v = centre.beyond - centre.side * p.y;
    let change = c.horizon_w * (scene.hole.horizon_separation - square(scene.hole.a) * (centre.beyond + v))
        - c.drag * centre.beyond * v;
    let d = horizon_function(v);
    let speed2 = max(d * d * (centre.c_0 + p.rise), vec4<f32>(TINY));
    return leg.count * centre.side * dot(WEIGHTS, p.y * p.dy * change * inverseSqrt(speed2));
}

fn smooth_dragging(c: Constants, leg: Leg) -> f32 {
    if leg.count == 0.0 || leg.spreads {
        return 0.0;
    }
    return dragging_sum(c, leg, smooth_places(leg, LOW_NODES)) + dragging_sum(c, leg, smooth_places(leg, HIGH_NODES));
}

// The integral of d(u) - d(c) along a way.
fn dragging_along(c: Constants, way: Way) -> f32 {
    var sum = smooth_dragging(c, way.first) + smooth_dragging(c, way.second);
    for (var i = 0u; i < spread_passes(way); i++) {
        let leg = spread_leg(way, i);
        sum += dragging_sum(c, leg, spread_places(leg, i % SPREAD_PASSES));
    }
    return scene.hole.a / horizon_function(vec4<f32>(way.first.centre.beyond)).x * sum;
}

// The quantity K' (p + q u^2)/(W + |u'|) at the centre: what Kerr's ingoing dragging falls short of a E
// by, divided by a, with p = 0 and q = 1, and a part of the delay with p = 1 and q = a^2. It has no
// pole at the horizon for light that comes in from outside.
struct Regular {
    q: f32,
    // W + |u'|.
    sum: f32,
    value: f32,
}

fn regular_at(c: Constants, centre: Centre, p: f32, q: f32) -> Regular {
    let w = c.horizon_w + c.drag * centre.beyond * (2.0 * scene.hole.horizon_u + centre.beyond);
    let sum = max(w + sqrt(centre.c_0), TINY);
    return Regular(q, sum, c.k_prime * (p + q * square(centre.u)) / sum);
}

// The distance on which the quantity changes next to the centre: a leg that is much shorter has no pole
// of it nearby.
fn regular_scale(c: Constants, centre: Centre, at: Regular) -> f32 {
    let pole = min(at.sum * at.sum / max(abs(centre.c.x), TINY), at.sum / max(abs(c.drag) * centre.u, TINY));
    return pole / MAX_SMOOTH_TURN;
}

fn regular_sum(c: Constants, leg: Leg, at: Regular, p: LegPlaces) -> f32 {
    let centre = leg.centre;
    let speed = sqrt(max(centre.c_0 + p.rise, vec4<f32>(TINY)));
    // The changes of u^2, and of W + |u'|, since the centre.
    let squares = -centre.side * p.y * (2.0 * centre.u - centre.side * p.y);
    let sums = c.drag * squares + p.rise / (speed + sqrt(centre.c_0));
    let change = (c.k_prime * at.q * squares - at.value * sums) / max((at.sum + sums) * speed, vec4<f32>(TINY));
    return leg.count * dot(WEIGHTS, p.dy * change);
}

fn smooth_regular(c: Constants, leg: Leg, at: Regular) -> f32 {
    if leg.count == 0.0 || leg.spreads {
        return 0.0;
    }
    return regular_sum(c, leg, at, smooth_places(leg, LOW_NODES)) + regular_sum(c, leg, at, smooth_places(leg, HIGH_NODES));
}

// The integral of the quantity less its value at the centre, along a way.
fn regular_along(c: Constants, way: Way, at: Regular) -> f32 {
    var sum = smooth_regular(c, way.first, at) + smooth_regular(c, way.second, at);
    for (var i = 0u; i < spread_passes(way); i++) {
        let leg = spread_leg(way, i);
        sum += regular_sum(c, leg, at, spread_places(leg, i % SPREAD_PASSES));
    }
    return sum;
}
