// What reaches the camera along a ray through matter with depth, by the steps of the method mino.
// optics/medium has the equations, and the twin in f64.
//
// In each step the part of the ray inside the medium is cut out and divided into chunks, which end
// where the smooth density has the optical depths 1, 3, 7, 11 and so on from the start of the part.
// A chunk has Gauss-Legendre nodes, four in a vector. The depth up to each of them follows from the
// polynomial through the densities at all of them.
//
// Gives: Factors, Passage, Places, Way, passage.

struct Passage {
    // The light of the medium, and the share of the light from behind that comes through it.
    light: vec3<f32>,
    transmission: f32,
    // Outcome and sky of the ray, and its steps.
    ray: Trace,
    // The number of nodes at which the medium was asked for its light.
    samples: u32,
}

// Four places of a step inside the medium.
struct Places {
    r: vec4<f32>,
    n_z: vec4<f32>,
    opening: vec4<f32>,
    // Emitted over observed frequency, scaled like the constants of the ray.
    slowing: vec4<f32>,
    // Optical depth for each unit of the step's share.
    rate: vec4<f32>,
}

// The factors by which structure multiplies the flux and the density at four places.
struct Factors {
    flux: vec4<f32>,
    density: vec4<f32>,
}

// A step of a ray: its path, and what the ray had at its start.
struct Way {
    path: Curve,
    step: Step,
    motion: Motion,
    h: f32,
    chi: Angle,
    delay: f32,
    ingoing: bool,
    // Whether r does not turn within the step, next to the horizon.
    regular: bool,
    neighbours: Neighbours,
}

// Places of a part at which the smooth density decides where chunks end.
const DENSITIES: u32 = 9u;
// More chunks than a part has before nothing comes through it.
const MAX_CHUNKS: u32 = 16u;
// A chunk with more depth than the second number is summed in order, because the polynomial would
// overshoot; between the two numbers both ways count, so that no edge shows where they differ.
const SMOOTH_DEPTHS: vec2<f32> = vec2<f32>(4.0, 8.0);

fn places_at(way: Way, orbit: KerrRay, share: vec4<f32>) -> Places {
    let path = way.path;
    let v = path.c0.x + share * (path.c1.x + share * (path.c2.x + share * (path.c3.x + share * (path.c4.x + share * path.c5.x))));
    let n_z = path.c0.y + share * (path.c1.y + share * (path.c2.y + share * (path.c3.y + share * (path.c4.y + share * path.c5.y))));
    // Beyond the outer edge nothing depends on r, and at u = 0 it would have no end.
    let r = 1.0 / max(way.motion.base + v, vec4<f32>(0.5 / scene.disk.outer));
    let opening = half_opening(r);
    let turning = rotation(r, n_z);
    let slowing = turning.u_t * max(orbit.constants.energy - turning.omega * orbit.angular_momentum, vec4<f32>(1e-6));
    let sigma = r * r + square(scene.hole.a) * n_z * n_z;
    return Places(r, n_z, opening, slowing, way.h * sigma * slowing * opacity(r, n_z, opening));
}

// Adds a chunk between two shares of a step.
fn add_chunk(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, ends: vec2<f32>) {
    var node_places = MEDIUM_PLACES;
    var node_weights = MEDIUM_WEIGHTS;
    var partial = MEDIUM_PARTIAL;
    let width = ends.y - ends.x;
    var places: array<Places, MEDIUM_BLOCKS>;
    for (var i = 0u; i < MEDIUM_BLOCKS; i++) {
        places[i] = places_at(way, orbit, ends.x + width * node_places[i]);
    }
    var factors = matter_factors(way, ends, places);
    var depth = 0.0;
    for (var i = 0u; i < MEDIUM_BLOCKS; i++) {
        places[i].rate *= factors[i].density;
        depth += width * dot(node_weights[i], places[i].rate);
    }
    if depth <= 0.0 {
        return;
    }
    let in_order = smoothstep(SMOOTH_DEPTHS.x, SMOOTH_DEPTHS.y, depth);
    var passed = 0.0;
    for (var i = 0u; i < MEDIUM_BLOCKS; i++) {
        let at = places[i];
        let own = width * node_weights[i] * at.rate;
        // The depth in front of each node, and how much of the node's light passes.
        let before = passed + vec4<f32>(0.0, own.x, own.x + own.y, own.x + own.y + own.z);
        var share = exp(-before) * (1.0 - exp(-own));
        if in_order < 1.0 {
            var to_node = vec4<f32>(0.0);
            for (var j = 0u; j < MEDIUM_BLOCKS; j++) {
                to_node += partial[i * MEDIUM_BLOCKS + j] * places[j].rate;
            }
            share = mix(own * exp(-max(width * to_node, vec4<f32>(0.0))), share, in_order);
        }
        passed += dot(own, vec4<f32>(1.0));
        let light = emission(photon, at, share, factors[i].flux, orbit.scale / at.slowing);
        (*result).light += (*result).transmission * light;
    }
    (*result).transmission *= exp(-depth);
    (*result).samples += MEDIUM_NODES;
}

// Adds the part of a step inside the medium, where the ray has the first `end` of the step.
fn add_step(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, end: f32) {
    let span = span_in_medium(way.path, way.motion.base, end);
    let width = (span.y - span.x) / f32(DENSITIES - 1u);
    if width <= 1e-7 {
        return;
    }
    // Where the chunk begins, and the depth at which it ends; and the density at the last place, with the
    // depth up to it.
    var start = span.x;
    var limit = 1.0;
    var place = 1u;
    var density = places_at(way, orbit, vec4<f32>(span.x)).rate.x * width;
    var depth = 0.0;
    for (var chunk = 0u; chunk <= MAX_CHUNKS; chunk++) {
        // Neighbouring rays find the ends of their chunks first, and then add the chunks together.
        var stop = span.y;
        for (var i = place; i < DENSITIES; i++) {
            let next_density = places_at(way, orbit, vec4<f32>(span.x + width * f32(i))).rate.x * width;
            let next_depth = depth + 0.5 * (density + next_density);
            if next_depth > limit && chunk < MAX_CHUNKS {
                // Where the depth of a linear density is the limit.
                let missing = limit - depth;
                let root = sqrt(max(density * density + 2.0 * (next_density - density) * missing, 0.0));
                let share = clamp(2.0 * missing / max(density + root, TINY), 0.0, 1.0);
                stop = min(span.x + width * (f32(i) - 1.0 + share), span.y);
                break;
            }
            depth = next_depth;
            density = next_density;
            place = i + 1u;
        }
        if stop > start {
            add_chunk(result, way, orbit, photon, vec2<f32>(start, stop));
        }
        if (*result).transmission < MIN_TRANSMISSION || place >= DENSITIES {
            return;
        }
        start = stop;
        limit += select(4.0, 2.0, chunk == 0u);
    }
}

// Whether a ray can only end in the hole, and meets nothing before.
fn ends_in_hole(ray: Ray) -> bool {
    let u = ray.motion.base + ray.y.x;
    let u_horizon = scene.hole.horizon_u;
    let inside = u * scene.disk.inner >= 1.0;
    return ray.dy.x > 0.0 && (u >= u_horizon || inside && cannot_turn(ray.motion, ray.y.x, u_horizon - u));
}

fn passage(photon: Photon) -> Passage {
    var result = Passage(vec3<f32>(0.0), 1.0, empty_trace(), 0u);
    let orbit = kerr_ray(photon);
    let h = step_of(orbit);
    var ray = ray_at_camera(photon, orbit, h);
    var neighbours = neighbours_of(photon, orbit, ray, h);
    if camera_is_inside() && orbit.constants.horizon_w <= 0.0 {
        // The light comes through the horizon's other branch, and nothing from outside does.
        result.ray.outcome = OUTCOME_CAPTURED;
        return result;
    }
    for (var i = 0u; i < MAX_STEPS; i++) {
        change_base(&ray, orbit.constants);
        if ends_in_hole(ray) {
            result.ray.outcome = OUTCOME_CAPTURED;
            break;
        }
        if result.transmission < MIN_TRANSMISSION {
            result.ray.outcome = OUTCOME_HIDDEN;
            break;
        }
        restore_radial_speed(&ray, h);
        let step = nystroem_step(ray.motion, h * h, ray.y, ray.dy, ray.k);
        let end = end_of(step, ray.motion);
        result.ray.steps += 1u;
        if NEAR_HORIZON && ray.ingoing && !(end.regular && ray.dy.x < 0.0) {
            ray.ingoing = false;
            ray.chi = add_angle(ray.chi, azimuth_lag_to_infinity(ray.motion, ray.y.x));
        }
        let way = Way(curve(step), step, ray.motion, h, ray.chi, ray.delay, ray.ingoing, end.regular, neighbours);
        add_step(&result, way, orbit, photon, end.share);
        if DELAY {
            ray.delay += step_delay(ray.motion, step, h);
        }
        if SPINNING && (SKY_DIRECTION || AZIMUTH) {
            let gain = azimuth_gain(ray.motion, way.path, h, end.share, end.y.x, end.regular, ray.ingoing);
            ray.chi = add_angle(ray.chi, gain);
        }
        if end.escapes {
            // A pointer to a part of a variable is no argument in WGSL.
            var escaped = result.ray;
            record_escape(&escaped, ray, end, orbit.constants.energy);
            result.ray = escaped;
            break;
        }
        neighbours = carried(way);
        ray.y = end.y;
        ray.dy = step.dy1;
        ray.k = step.k1;
    }
    return result;
}
