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
// with s = r_+ - r_-, vanishes at the centre, so that its integral has no logarithm there.
//
// A leg is integrated by Gauss's and Legendre's rule over the distance y from the centre, or behind a
// turning point over its root, which takes away the root of U. Where the integrand changes on a scale
// that is much smaller than the leg (next to the critical curve, or next to the horizon), the leg is
// divided in parts, each at most twice as long as its distance from the centre, and from the horizon if
// the leg leads toward it. Derived.
//
// Needs: Centre, Constants, TINY, scene, square.
// Gives: Regular, Way, dragging_along, leg_between, regular_along, regular_at, regular_scale,
//     way_of.

// The eight Gauss-Legendre nodes on [0, 1], and their weights on both sides of the middle.
const LOW_NODES: vec4<f32> = vec4<f32>(0.0198550718, 0.101666761, 0.237233795, 0.408282679);
const HIGH_NODES: vec4<f32> = vec4<f32>(0.980144928, 0.898333239, 0.762766205, 0.591717321);
const WEIGHTS: vec4<f32> = vec4<f32>(0.0506142681, 0.111190517, 0.156853323, 0.181341892);

// A leg is divided if it is more than this many times as long as the scale on which the integrand
// changes: behind a turning point, and next to a place that the ray passes.
const MAX_SMOOTH_TURN: f32 = 6.0;
const MAX_SMOOTH_PASSAGE: f32 = 1.0;
// f32 tells no more halvings of a leg apart.
const MAX_PARTS: u32 = 20u;
// The dragging at the centre times the time may be this large, in radians. The rounding of a larger
// angle, which the rest of the integral cancels, would show.
const MAX_STEADY_TURN: f32 = 7.0;

// A leg between two distances from its centre.
struct Leg {
    centre: Centre,
    low: f32,
    high: f32,
    // How often the ray goes along it.
    count: f32,
    // Whether its centre is a turning point.
    turns: bool,
    // The number of parts that grow away from the centre: zero if the leg is not divided.
    parts: u32,
    // The number of parts in the far half of a leg that ends next to the horizon. They become shorter
    // toward the horizon.
    far_parts: u32,
}

// The legs of the way from the camera to a place.
struct Way {
    first: Leg,
    second: Leg,
}

fn way_of(first: Leg, second: Leg) -> Way {
    var way = Way(first, second);
    // If one leg is divided, so is the other, because dragging_along sums divided ways otherwise.
    if max(first.parts, second.parts) > 0u {
        way.first.parts = select(0u, max(first.parts, 1u), first.count > 0.0);
        way.second.parts = select(0u, max(second.parts, 1u), second.count > 0.0);
    }
    return way;
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
    let ratio = high / max(least, TINY);
    let doublings = log2(max(ratio, 1.0)) * select(1.0, 0.5, turns);
    let parts = min(1u + u32(ceil(doublings)), MAX_PARTS);
    let pole = -centre.beyond;
    let gap = max(pole - high, TINY);
    let ends_near_horizon = centre.side < 0.0 && pole > high && gap < high;
    let far_parts = min(u32(ceil(log2(1.0 + 0.5 * high / gap))), MAX_PARTS);
    let uneven = ratio > select(MAX_SMOOTH_PASSAGE, MAX_SMOOTH_TURN, turns);
    let divides = count > 0.0 && (uneven || ends_near_horizon);
    let near_parts = select(0u, parts, divides);
    return Leg(centre, low, high, count, turns, near_parts, select(0u, far_parts, divides && ends_near_horizon));
}

// The places on a part of a leg between two distances.
fn places_on(leg: Leg, part_low: f32, part_high: f32, nodes: vec4<f32>) -> LegPlaces {
    let low = max(leg.low, part_low);
    let high = max(leg.low, part_high);
    let first = select(low, sqrt(low), leg.turns);
    let width = select(high, sqrt(high), leg.turns) - first;
    let x = first + width * nodes;
    let y = select(x, x * x, leg.turns);
    let c = leg.centre.c;
    let dy = width * select(vec4<f32>(1.0), 2.0 * x, leg.turns);
    return LegPlaces(y, dy, y * (c.x + y * (c.y + y * (c.z + y * c.w))));
}

// A pass of the loop over the parts of both legs, with half of a part's nodes: one loop, because it is
// rare work, and software renderers pay for every loop.
struct Pass {
    leg: Leg,
    places: LegPlaces,
}

fn count_passes(way: Way) -> u32 {
    return 2u * (way.first.parts + way.first.far_parts + way.second.parts + way.second.far_parts);
}

fn pass_at(way: Way, i: u32) -> Pass {
    var leg = way.first;
    var own = i;
    let of_first = 2u * (leg.parts + leg.far_parts);
    if i >= of_first {
        own = i - of_first;
        leg = way.second;
    }
    let nodes = select(HIGH_NODES, LOW_NODES, (own & 1u) == 0u);
    let part = own / 2u;
    let middle = select(leg.high, 0.5 * leg.high, leg.far_parts > 0u);
    if part < leg.far_parts {
        let pole = -leg.centre.beyond;
        let gap = exp2(f32(part)) * (pole - leg.high);
        let high = select(pole - gap, leg.high, part == 0u);
        let low = select(max(pole - 2.0 * gap, middle), middle, part + 1u == leg.far_parts);
        return Pass(leg, places_on(leg, low, high, nodes));
    }
    // Halvings of the rule's variable.
    let halvings = f32(part - leg.far_parts) * select(1.0, 2.0, leg.turns);
    let high = middle * exp2(-halvings);
    let next = high * select(0.5, 0.25, leg.turns);
    let low = select(next, 0.0, part - leg.far_parts + 1u >= leg.parts);
    return Pass(leg, places_on(leg, low, high, nodes));
}

// d(u), at distances from the horizon too.
fn dragging_at(c: Constants, u: vec4<f32>, beyond: vec4<f32>) -> vec4<f32> {
    let d = horizon_function(beyond);
    let w = c.horizon_w + c.drag * beyond * (2.0 * scene.hole.horizon_u + beyond);
    // E - W/D, and the same where both are nearly E.
    let far = -u * (c.energy - (square(scene.hole.a) * c.energy - c.drag) * u) / d;
    return scene.hole.a * select(far, c.energy - w / d, u > vec4<f32>(0.5 * scene.hole.horizon_u));
}

// The integral of d(u) - d(c) along a leg, times D(c)/a.
fn smooth_dragging_sum(c: Constants, leg: Leg, nodes: vec4<f32>) -> f32 {
    let centre = leg.centre;
    let p = places_on(leg, leg.low, leg.high, nodes);
    let v = centre.beyond - centre.side * p.y;
    let change = c.horizon_w * (scene.hole.horizon_separation - square(scene.hole.a) * (centre.beyond + v))
        - c.drag * centre.beyond * v;
    let d = horizon_function(v);
    let speed2 = max(d * d * (centre.c_0 + p.rise), vec4<f32>(TINY));
    return leg.count * centre.side * dot(WEIGHTS, p.y * p.dy * change * inverseSqrt(speed2));
}

fn smooth_dragging(c: Constants, leg: Leg) -> f32 {
    if leg.count == 0.0 {
        return 0.0;
    }
    return smooth_dragging_sum(c, leg, LOW_NODES) + smooth_dragging_sum(c, leg, HIGH_NODES);
}

// The integral of d(u) along a way that takes the time t and has an end at `end`. d(c) t is exact where
// light lingers, but next to the horizon of a nearly extremal hole it may be much larger than the sum.
// There the rest of the integral is relative to the dragging at the end.
fn dragging_along(c: Constants, way: Way, t: f32, end: f32) -> f32 {
    let centre = way.first.centre;
    let at_centre = dragging_at(c, vec4<f32>(centre.u), vec4<f32>(centre.beyond)).x;
    let passes = count_passes(way);
    if passes == 0u {
        let sum = smooth_dragging(c, way.first) + smooth_dragging(c, way.second);
        return at_centre * t + scene.hole.a / horizon_function(vec4<f32>(centre.beyond)).x * sum;
    }
    let end_beyond = (end - scene.hole.horizon_u) - scene.hole.horizon_u_low;
    let at_end = dragging_at(c, vec4<f32>(end), vec4<f32>(end_beyond)).x;
    let steady = select(at_centre, at_end, abs(at_centre * t) > MAX_STEADY_TURN);
    var sum = steady * t;
    for (var i = 0u; i < passes; i++) {
        let part = pass_at(way, i);
        let place = part.leg.centre;
        let distance = place.side * part.places.y;
        let rate = dragging_at(c, place.u - distance, place.beyond - distance) - steady;
        let speed2 = max(place.c_0 + part.places.rise, vec4<f32>(TINY));
        sum += part.leg.count * dot(WEIGHTS, part.places.dy * rate * inverseSqrt(speed2));
    }
    return sum;
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

// The distance on which the quantity changes next to the centre. Its pole is not nearer than this.
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
    if leg.count == 0.0 {
        return 0.0;
    }
    return regular_sum(c, leg, at, places_on(leg, leg.low, leg.high, LOW_NODES))
        + regular_sum(c, leg, at, places_on(leg, leg.low, leg.high, HIGH_NODES));
}

// The integral of the quantity less its value at the centre, along a way.
fn regular_along(c: Constants, way: Way, at: Regular) -> f32 {
    let passes = count_passes(way);
    if passes == 0u {
        return smooth_regular(c, way.first, at) + smooth_regular(c, way.second, at);
    }
    var sum = 0.0;
    for (var i = 0u; i < passes; i++) {
        let part = pass_at(way, i);
        sum += regular_sum(c, part.leg, at, part.places);
    }
    return sum;
}
