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
// Away from the horizon it is integrated over the root x of the distance y from the centre. Next to
// the critical curve dtau/dx has a bend at small x. There the part in which the difference is linear
// and U is quadratic is integrated in closed form:
//
//   integral of y dy/sqrt(V) = sqrt(V)/c_2 - c_1/(2 c_2^(3/2)) ln(2 sqrt(c_2 V) + 2 c_2 y + c_1),
//   V = c_0 + c_1 y + c_2 y^2.
//
// Where the horizon's pole is close (nearly extremal holes), or light comes in to a camera next to the
// horizon, the leg is divided by theta: y, or behind a turning point x, is a scale times sinh(theta).
// So the nodes follow the smallest scale on which the integrand changes. Derived.
//
// Needs: Centre, Constants, NEARLY_EXTREMAL, TINY, scene, square.
// Gives: Regular, horizon_function, leg_azimuth, regular_at, regular_leg.

// The twelve Gauss-Legendre nodes on [0, 1] and their weights.
const NODES_1: vec4<f32> = vec4<f32>(0.00921968288, 0.0479413718, 0.115048663, 0.206341023);
const NODES_2: vec4<f32> = vec4<f32>(0.316084251, 0.437383296, 0.562616704, 0.683915749);
const NODES_3: vec4<f32> = vec4<f32>(0.793658977, 0.884951337, 0.952058628, 0.990780317);
const WEIGHTS_1: vec4<f32> = vec4<f32>(0.0235876682, 0.053469663, 0.0800391643, 0.101583713);
const WEIGHTS_2: vec4<f32> = vec4<f32>(0.116746268, 0.124573523, 0.124573523, 0.116746268);
const WEIGHTS_3: vec4<f32> = vec4<f32>(0.101583713, 0.0800391643, 0.053469663, 0.0235876682);

// The squares of the twelve Gauss-Legendre nodes on [0, 1], and the weights that belong to them.
const SQUARES_1: vec4<f32> = vec4<f32>(8.50025523e-05, 0.00229837513, 0.0132361948, 0.0425766177);
const SQUARES_2: vec4<f32> = vec4<f32>(0.0999092534, 0.191304147, 0.316537556, 0.467740752);
const SQUARES_3: vec4<f32> = vec4<f32>(0.629894572, 0.783138869, 0.906415632, 0.981645637);
const SQUARE_WEIGHTS_1: vec4<f32> = vec4<f32>(0.000434941641, 0.00512681799, 0.0184167977, 0.0419217746);
const SQUARE_WEIGHTS_2: vec4<f32> = vec4<f32>(0.0738033134, 0.108972756, 0.14017429, 0.159689223);
const SQUARE_WEIGHTS_3: vec4<f32> = vec4<f32>(0.161245652, 0.141661531, 0.101812508, 0.0467403947);

// A leg's smallest scale is at least this share of it.
const MIN_LEG_SCALE: f32 = 1e-5;

// D at a distance from the horizon.
fn horizon_function(beyond: vec4<f32>) -> vec4<f32> {
    return max(beyond * (square(scene.hole.a) * beyond - scene.hole.horizon_separation), vec4<f32>(TINY));
}

struct Leg {
    centre: Centre,
    horizon_w: f32,
    drag: f32,
    // The difference at the centre, divided by the distance and by a/D(c).
    linear: f32,
    low: f32,
    width: f32,
}

fn leg_sum(leg: Leg, nodes: vec4<f32>, weights: vec4<f32>) -> f32 {
    let centre = leg.centre;
    let c = centre.c;
    let x = leg.low + leg.width * nodes;
    let y = x * x;
    let v = centre.beyond - centre.side * y;
    let bent = centre.c_0 + y * (c.x + y * c.y);
    let speed = sqrt(max(bent + y * y * y * (c.z + y * c.w), vec4<f32>(TINY)));
    let bent_speed = sqrt(max(bent, vec4<f32>(TINY)));
    let rise = leg.horizon_w * (scene.hole.horizon_separation - square(scene.hole.a) * (centre.beyond + v))
        - leg.drag * centre.beyond * v;
    // rise/(D speed) - linear/bent_speed, with one division.
    let d_speed = horizon_function(v) * speed;
    return dot(weights, x * y * ((rise * bent_speed - leg.linear * d_speed) / max(d_speed * bent_speed, vec4<f32>(TINY))));
}

// The integral of d(u) - d(c) between two roots of distances.
fn smooth_leg_azimuth(constants: Constants, centre: Centre, low: f32, high: f32) -> f32 {
    let c = centre.c;
    let here = horizon_function(vec4<f32>(centre.beyond)).x;
    let narrowing = scene.hole.horizon_separation - 2.0 * square(scene.hole.a) * centre.beyond;
    let slope = (constants.horizon_w * narrowing - constants.drag * square(centre.beyond)) / here;
    // Whether the bend lies within the leg.
    let high2 = high * high;
    let bends = c.y * high2 > max(abs(c.x), centre.c_0 / max(high2, TINY));
    let leg = Leg(centre, constants.horizon_w, constants.drag, select(0.0, slope, bends), low, high - low);
    var sum = leg_sum(leg, SQUARES_1, SQUARE_WEIGHTS_1) + leg_sum(leg, SQUARES_2, SQUARE_WEIGHTS_2)
        + leg_sum(leg, SQUARES_3, SQUARE_WEIGHTS_3);
    sum *= 2.0 * leg.width;
    // The closed form at both ends.
    let y = vec2<f32>(low * low, high2);
    let c_2 = max(c.y, TINY);
    let speed = sqrt(max(centre.c_0 + y * (c.x + y * c_2), vec2<f32>(0.0)));
    let root = sqrt(c_2);
    let grown = max(2.0 * root * speed + 2.0 * c_2 * y + c.x, vec2<f32>(TINY));
    let closed = (speed.y - speed.x) / c_2 - 0.5 * c.x / (c_2 * root) * log(grown.y / grown.x);
    sum += select(0.0, slope * closed, bends);
    return centre.side * scene.hole.a / here * sum;
}

// A leg divided by theta.
struct SpreadLeg {
    centre: Centre,
    turns: bool,
    scale: f32,
    low: f32,
    width: f32,
}

// Places on such a leg: the distance from the centre, its change with theta, what U grows by since
// the centre, and |u'|.
struct LegPlaces {
    y: vec4<f32>,
    dy: vec4<f32>,
    rise: vec4<f32>,
    speed: vec4<f32>,
}

// Between two distances. `scale` is the smallest distance on which the integrand changes, apart from
// U itself.
fn spread_leg(centre: Centre, scale: f32, low: f32, high: f32) -> SpreadLeg {
    let turns = centre.c_0 <= 0.0;
    let bend = max(centre.c.y, TINY);
    var ends = vec2<f32>(low, high);
    var least = min(scale, sqrt(centre.c_0 / bend));
    if turns {
        ends = sqrt(ends);
        least = sqrt(min(scale, max(centre.c.x, TINY) / bend));
    }
    least = clamp(least, max(MIN_LEG_SCALE * ends.y, TINY), max(ends.y, TINY));
    ends /= least;
    let theta = log(ends + sqrt(1.0 + ends * ends));
    return SpreadLeg(centre, turns, least, theta.x, 0.5 * (theta.y - theta.x));
}

fn places_on(leg: SpreadLeg, nodes: vec4<f32>) -> LegPlaces {
    let centre = leg.centre;
    let q = centre.c;
    let e = exp(leg.low + leg.width * nodes);
    let z = 0.5 * leg.scale * (e - 1.0 / e);
    let dz = 0.5 * leg.scale * (e + 1.0 / e);
    let y = select(z, z * z, leg.turns);
    let rise = y * (q.x + y * (q.y + y * (q.z + y * q.w)));
    let speed = sqrt(max(centre.c_0 + rise, vec4<f32>(TINY)));
    return LegPlaces(y, select(dz, 2.0 * z * dz, leg.turns), rise, speed);
}

fn spread_sum(c: Constants, leg: SpreadLeg, nodes: vec4<f32>, weights: vec4<f32>) -> f32 {
    let p = places_on(leg, nodes);
    let v_centre = leg.centre.beyond;
    let v = v_centre - leg.centre.side * p.y;
    let rise = c.horizon_w * (scene.hole.horizon_separation - square(scene.hole.a) * (v_centre + v))
        - c.drag * v_centre * v;
    return dot(weights, p.y * p.dy * rise / max(horizon_function(v) * p.speed, vec4<f32>(TINY)));
}

fn spread_leg_azimuth(c: Constants, centre: Centre, low: f32, high: f32) -> f32 {
    let leg = spread_leg(centre, abs(centre.beyond), low, high);
    var sum = 0.0;
    for (var i = 0u; i < 2u; i++) {
        let half = SpreadLeg(centre, leg.turns, leg.scale, leg.low + f32(i) * leg.width, leg.width);
        sum += spread_sum(c, half, NODES_1, WEIGHTS_1) + spread_sum(c, half, NODES_2, WEIGHTS_2)
            + spread_sum(c, half, NODES_3, WEIGHTS_3);
    }
    let here = horizon_function(vec4<f32>(centre.beyond)).x;
    return centre.side * scene.hole.a / here * leg.width * sum;
}

// The integral of d(u) - d(c) between two distances from the centre.
fn leg_azimuth(c: Constants, centre: Centre, low: f32, high: f32) -> f32 {
    if NEARLY_EXTREMAL {
        return spread_leg_azimuth(c, centre, low, high);
    }
    return smooth_leg_azimuth(c, centre, sqrt(low), sqrt(high));
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

fn regular_sum(c: Constants, leg: SpreadLeg, at: Regular, nodes: vec4<f32>, weights: vec4<f32>) -> f32 {
    let p = places_on(leg, nodes);
    let centre = leg.centre;
    // The changes of u^2, and of W + |u'|, since the centre.
    let squares = -centre.side * p.y * (2.0 * centre.u - centre.side * p.y);
    let sums = c.drag * squares + p.rise / (p.speed + sqrt(centre.c_0));
    return dot(weights, p.dy * (c.k_prime * at.q * squares - at.value * sums) / max((at.sum + sums) * p.speed, vec4<f32>(TINY)));
}

// The integral of the quantity less its value at the centre, between two distances from there.
fn regular_leg(c: Constants, centre: Centre, at: Regular, low: f32, high: f32) -> f32 {
    let leg = spread_leg(centre, at.sum * at.sum / max(abs(centre.c.x), TINY), low, high);
    var sum = 0.0;
    for (var i = 0u; i < 2u; i++) {
        let half = SpreadLeg(centre, leg.turns, leg.scale, leg.low + f32(i) * leg.width, leg.width);
        sum += regular_sum(c, half, at, NODES_1, WEIGHTS_1) + regular_sum(c, half, at, NODES_2, WEIGHTS_2)
            + regular_sum(c, half, at, NODES_3, WEIGHTS_3);
    }
    return leg.width * sum;
}
