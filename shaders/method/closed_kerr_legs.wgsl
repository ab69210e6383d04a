// Integrals over the legs of a ray of the method closed around a spinning hole. They give the
// growth of chi by frame dragging,
//
//   d(u) = a (E - W/D)
//
// per Mino time. A leg begins or ends at the ray's centre c: the turning point, or the place where
// the ray is slowest. The difference
//
//   d(u) - d(c) = -a (u - c) (W_+ (s - a^2 (v + v_c)) - B v v_c)/(D(u) D(c)),   v = u - 1/r_+,
//
// with s = r_+ - r_-, vanishes at the centre, so its integral has no logarithm there.
//
// Gauss-Legendre quadrature integrates over the distance y from the centre or, from a turning
// point, over its root, which removes the root of U. Where the integrand changes on a scale much
// smaller than the leg (next to the critical curve or the horizon), the leg is divided into parts,
// each at most twice as long as its distance from the centre, and from a horizon that it leads
// toward. Derived.
//
// Gives: Leg, LegPlaces, Path, Regular, WEIGHTS, dragging_along, is_divided, leg_between,
//     parts_of_path, pass_at, regular_along, regular_at, regular_scale.

// The eight Gauss-Legendre nodes on [0, 1], and their weights on both sides of the middle.
const LOW_NODES: vec4<f32> = vec4<f32>(0.0198550718, 0.101666761, 0.237233795, 0.408282679);
const HIGH_NODES: vec4<f32> = vec4<f32>(0.980144928, 0.898333239, 0.762766205, 0.591717321);
const WEIGHTS: vec4<f32> = vec4<f32>(0.0506142681, 0.111190517, 0.156853323, 0.181341892);
// Four nodes, and their weights.
const FEW_NODES: vec4<f32> = vec4<f32>(0.0694318442, 0.330009478, 0.669990522, 0.930568156);
const FEW_WEIGHTS: vec4<f32> = vec4<f32>(0.173927423, 0.326072577, 0.326072577, 0.173927423);
// A smooth leg takes four nodes if its ends have at least this ratio: the integrand's poles are
// then four times as far from its middle as its ends are, and the error is 1e-7 of the integral.
const MIN_SHORT_RATIO: f32 = 0.36;

// A longer leg, relative to the scale of its integrand, is divided: one from a turning point, and
// one from a place that the ray passes.
const MAX_SMOOTH_TURN: f32 = 6.0;
const MAX_SMOOTH_PASSAGE: f32 = 1.0;
// f32 does not resolve more halvings of a leg.
const MAX_PARTS: u32 = 20u;

// A leg between two distances from its centre.
struct Leg {
    centre: Centre,
    low: f32,
    high: f32,
    // How often the ray covers it.
    count: f32,
    // Whether its centre is a turning point.
    turns: bool,
    // The smallest scale of the integrand, apart from that of U.
    scale: f32,
}

// The legs from the camera to a place.
struct Path {
    first: Leg,
    second: Leg,
}

// Places on a leg: the distance from the centre, its derivative by the variable of integration, and
// the growth of U from the centre.
struct LegPlaces {
    y: vec4<f32>,
    dy: vec4<f32>,
    rise: vec4<f32>,
}

// D at a distance from the horizon.
fn horizon_function(beyond: vec4<f32>) -> vec4<f32> {
    return max(beyond * (square(scene.hole.a) * beyond - scene.hole.horizon_separation), vec4<f32>(TINY));
}

fn leg_between(centre: Centre, low: f32, high: f32, count: f32, scale: f32) -> Leg {
    return Leg(centre, low, high, count, centre.c_0 <= 0.0, scale);
}

// Ratio of the leg's length to the scale of its integrand. The scale of U is the distance at which
// two of its first terms are equal.
fn length_over_scale(leg: Leg) -> f32 {
    let c = abs(leg.centre.c);
    let c_0 = leg.centre.c_0;
    var least = min(c_0 / max(c.x, TINY), sqrt(c_0 / max(c.y, TINY)));
    if leg.turns {
        least = min(c.x / max(c.y, TINY), sqrt(c.x / max(c.z, TINY)));
    }
    return leg.high / max(min(leg.scale, least), TINY);
}

// Whether length_over_scale is too large for an undivided leg, without divisions and roots.
fn is_too_long(leg: Leg) -> bool {
    let c = abs(leg.centre.c);
    let c_0 = leg.centre.c_0;
    let share = leg.high / select(MAX_SMOOTH_PASSAGE, MAX_SMOOTH_TURN, leg.turns);
    let changes = select(
        share * c.x > c_0 || share * share * c.y > c_0,
        share * c.y > c.x || share * share * c.z > c.x,
        leg.turns,
    );
    return changes || share > leg.scale;
}

// Whether a leg on the inner side of its centre ends next to the horizon.
fn ends_near_horizon(leg: Leg) -> bool {
    let pole = -leg.centre.beyond;
    return leg.centre.side < 0.0 && pole > leg.high && pole < 2.0 * leg.high;
}

fn is_leg_divided(leg: Leg) -> bool {
    return leg.count > 0.0 && (is_too_long(leg) || ends_near_horizon(leg));
}

// If one leg is divided, so is the other.
fn is_divided(path: Path) -> bool {
    return is_leg_divided(path.first) || is_leg_divided(path.second);
}

// The numbers of a leg's parts: those that grow away from the centre, and in the far half of a leg
// that ends next to the horizon those that shrink toward it.
struct Parts {
    near: u32,
    far: u32,
}

fn parts_of(leg: Leg) -> Parts {
    if !is_leg_divided(leg) {
        return Parts(select(0u, 1u, leg.count > 0.0), 0u);
    }
    let doublings = log2(max(length_over_scale(leg), 1.0)) * select(1.0, 0.5, leg.turns);
    let gap = max(-leg.centre.beyond - leg.high, TINY);
    let far = min(u32(ceil(log2(1.0 + 0.5 * leg.high / gap))), MAX_PARTS);
    return Parts(min(1u + u32(ceil(doublings)), MAX_PARTS), select(0u, far, ends_near_horizon(leg)));
}

// The nodes on a part of a leg between two distances.
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

// The parts of a divided path. One loop sums them, half of a part's nodes in each pass: the work is
// rare, and software renderers pay for every loop.
struct PathParts {
    first: Parts,
    second: Parts,
    passes: u32,
}

fn parts_of_path(path: Path) -> PathParts {
    let first = parts_of(path.first);
    let second = parts_of(path.second);
    return PathParts(first, second, 2u * (first.near + first.far + second.near + second.far));
}

struct Pass {
    leg: Leg,
    places: LegPlaces,
}

fn pass_at(path: Path, parts: PathParts, i: u32) -> Pass {
    var leg = path.first;
    var own = parts.first;
    var part = i / 2u;
    if part >= own.near + own.far {
        part -= own.near + own.far;
        own = parts.second;
        leg = path.second;
    }
    let nodes = select(HIGH_NODES, LOW_NODES, (i & 1u) == 0u);
    let middle = select(leg.high, 0.5 * leg.high, own.far > 0u);
    if part < own.far {
        let pole = -leg.centre.beyond;
        let gap = exp2(f32(part)) * (pole - leg.high);
        let high = select(pole - gap, leg.high, part == 0u);
        let low = select(max(pole - 2.0 * gap, middle), middle, part + 1u == own.far);
        return Pass(leg, places_on(leg, low, high, nodes));
    }
    // Halvings of the variable of integration.
    let halvings = f32(part - own.far) * select(1.0, 2.0, leg.turns);
    let high = middle * exp2(-halvings);
    let next = high * select(0.5, 0.25, leg.turns);
    let low = select(next, 0.0, part - own.far + 1u >= own.near);
    return Pass(leg, places_on(leg, low, high, nodes));
}

// d(u); `beyond` is u - 1/r_+.
fn dragging_at(c: PhotonConstants, u: vec4<f32>, beyond: vec4<f32>) -> vec4<f32> {
    let d = horizon_function(beyond);
    let w = c.horizon_w + c.drag * beyond * (2.0 * scene.hole.horizon_u + beyond);
    // E - W/D, and the same where both are nearly E.
    let far = -u * (c.energy - (square(scene.hole.a) * c.energy - c.drag) * u) / d;
    return scene.hole.a * select(far, c.energy - w / d, u > vec4<f32>(0.5 * scene.hole.horizon_u));
}

// The integral of d(u) - d(c) along a leg, times D(c)/a.
fn smooth_dragging_sum(c: PhotonConstants, leg: Leg, nodes: vec4<f32>, weights: vec4<f32>) -> f32 {
    let centre = leg.centre;
    let p = places_on(leg, leg.low, leg.high, nodes);
    let v = centre.beyond - centre.side * p.y;
    let change = c.horizon_w * (scene.hole.horizon_separation - square(scene.hole.a) * (centre.beyond + v))
        - c.drag * centre.beyond * v;
    let d = horizon_function(v);
    let speed2 = max(d * d * (centre.c_0 + p.rise), vec4<f32>(TINY));
    return leg.count * centre.side * dot(weights, p.y * p.dy * change * inverseSqrt(speed2));
}

fn smooth_dragging(c: PhotonConstants, leg: Leg) -> f32 {
    if leg.count == 0.0 {
        return 0.0;
    }
    let is_short = leg.low > MIN_SHORT_RATIO * leg.high;
    let nodes = select(LOW_NODES, FEW_NODES, is_short);
    let sum = smooth_dragging_sum(c, leg, nodes, select(WEIGHTS, FEW_WEIGHTS, is_short));
    if is_short {
        return sum;
    }
    return sum + smooth_dragging_sum(c, leg, HIGH_NODES, WEIGHTS);
}

// The integral of d(u) along a path that takes the time t and has an end at `end`. A divided path
// is summed relative to the dragging at its end: next to the horizon of a nearly extremal hole d(c)
// t may be much larger than the integral.
fn dragging_along(c: PhotonConstants, path: Path, t: f32, end: f32) -> f32 {
    let centre = path.first.centre;
    let at_centre = dragging_at(c, vec4<f32>(centre.u), vec4<f32>(centre.beyond)).x;
    if !is_divided(path) {
        let sum = smooth_dragging(c, path.first) + smooth_dragging(c, path.second);
        return at_centre * t + scene.hole.a / horizon_function(vec4<f32>(centre.beyond)).x * sum;
    }
    let end_beyond = (end - scene.hole.horizon_u) - scene.hole.horizon_u_low;
    let at_end = dragging_at(c, vec4<f32>(end), vec4<f32>(end_beyond)).x;
    let steady = select(at_centre, at_end, abs(at_end) < abs(at_centre));
    var sum = steady * t;
    let parts = parts_of_path(path);
    for (var i = 0u; i < parts.passes; i++) {
        let part = pass_at(path, parts, i);
        let place = part.leg.centre;
        let distance = place.side * part.places.y;
        let rate = dragging_at(c, place.u - distance, place.beyond - distance) - steady;
        let speed2 = max(place.c_0 + part.places.rise, vec4<f32>(TINY));
        sum += part.leg.count * dot(WEIGHTS, part.places.dy * rate * inverseSqrt(speed2));
    }
    return sum;
}

// The quantity K' (p + q u^2)/(W + |u'|) at the centre, which has no pole at the horizon for
// infalling light. With p = 0 and q = 1 it is (a E - d)/a, d being Kerr's ingoing dragging; with p
// = 1 and q = a^2 it is a part of the delay.
struct Regular {
    q: f32,
    // W + |u'|.
    sum: f32,
    value: f32,
}

fn regular_at(c: PhotonConstants, centre: Centre, p: f32, q: f32) -> Regular {
    let w = c.horizon_w + c.drag * centre.beyond * (2.0 * scene.hole.horizon_u + centre.beyond);
    let sum = max(w + sqrt(centre.c_0), TINY);
    return Regular(q, sum, c.k_prime * (p + q * square(centre.u)) / sum);
}

// The scale of the quantity next to the centre. Its pole is not nearer than this.
fn regular_scale(c: PhotonConstants, centre: Centre, at: Regular) -> f32 {
    let pole = min(at.sum * at.sum / max(abs(centre.c.x), TINY), at.sum / max(abs(c.drag) * centre.u, TINY));
    return pole / MAX_SMOOTH_TURN;
}

fn regular_sum(c: PhotonConstants, leg: Leg, at: Regular, p: LegPlaces) -> f32 {
    let centre = leg.centre;
    let speed = sqrt(max(centre.c_0 + p.rise, vec4<f32>(TINY)));
    // The changes of u^2, and of W + |u'|, since the centre.
    let squares = -centre.side * p.y * (2.0 * centre.u - centre.side * p.y);
    let sums = c.drag * squares + p.rise / (speed + sqrt(centre.c_0));
    let change = (c.k_prime * at.q * squares - at.value * sums) / max((at.sum + sums) * speed, vec4<f32>(TINY));
    return leg.count * dot(WEIGHTS, p.dy * change);
}

fn smooth_regular(c: PhotonConstants, leg: Leg, at: Regular) -> f32 {
    if leg.count == 0.0 {
        return 0.0;
    }
    return regular_sum(c, leg, at, places_on(leg, leg.low, leg.high, LOW_NODES))
        + regular_sum(c, leg, at, places_on(leg, leg.low, leg.high, HIGH_NODES));
}

// The integral of the quantity less its value at the centre, along a path.
fn regular_along(c: PhotonConstants, path: Path, at: Regular) -> f32 {
    if !is_divided(path) {
        return smooth_regular(c, path.first, at) + smooth_regular(c, path.second, at);
    }
    var sum = 0.0;
    let parts = parts_of_path(path);
    for (var i = 0u; i < parts.passes; i++) {
        let part = pass_at(path, parts, i);
        sum += regular_sum(c, part.leg, at, part.places);
    }
    return sum;
}
