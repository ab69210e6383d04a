// The light of a disk with thickness along a part of a step. The part is divided into chunks, which end
// where the smooth density has the optical depths 1, 3, 7, 11 and so on from the start of the part.
// A chunk has Gauss-Legendre nodes, four in a vector. The depth up to each of them follows from the
// polynomial through the densities at all of them.
//
// Gives: Factors, Places, add_disk.

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
        let shares = ends.x + width * node_places[i];
        let arriving = (*result).transmission * share;
        (*result).light += emission(way, shares, photon, at, arriving, factors[i].flux, orbit.scale / at.slowing);
    }
    (*result).transmission *= exp(-depth);
    (*result).samples += MEDIUM_NODES;
}

// Adds a span of a step inside the disk, between two shares of the step.
fn add_disk(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, span: vec2<f32>) {
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
            let parts = parts_of_chunk();
            let part = (stop - start) / f32(parts);
            for (var i = 0u; i < parts; i++) {
                let ends = vec2<f32>(start + part * f32(i), select(start + part * f32(i + 1u), stop, i + 1u == parts));
                add_chunk(result, way, orbit, photon, ends);
            }
        }
        if (*result).transmission < MIN_TRANSMISSION || place >= DENSITIES {
            return;
        }
        start = stop;
        limit += select(4.0, 2.0, chunk == 0u);
    }
}
