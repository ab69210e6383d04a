// The light of a chunk of a ray's way through a disk with thickness. A chunk has Gauss-Legendre nodes, four
// in a vector. The depth up to each of them follows from the polynomial through the densities at all of them.
//
// Gives: Factors, Places, add_chunk, places_at.

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

// Adds a chunk between two shares of a step, unless its smooth matter has more than `most` depth. Gives
// whether it was added.
fn add_chunk(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, ends: vec2<f32>, most: f32) -> bool {
    var node_places = MEDIUM_PLACES;
    var node_weights = MEDIUM_WEIGHTS;
    var partial = MEDIUM_PARTIAL;
    let width = ends.y - ends.x;
    var smooth_depth = 0.0;
    var places: array<Places, MEDIUM_BLOCKS>;
    for (var i = 0u; i < MEDIUM_BLOCKS; i++) {
        places[i] = places_at(way, orbit, ends.x + width * node_places[i]);
        smooth_depth += width * dot(node_weights[i], places[i].rate);
    }
    if smooth_depth > most {
        return false;
    }
    var factors = matter_factors(way, ends, places);
    var depth = 0.0;
    for (var i = 0u; i < MEDIUM_BLOCKS; i++) {
        places[i].rate *= factors[i].density;
        depth += width * dot(node_weights[i], places[i].rate);
    }
    if depth <= 0.0 {
        return true;
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
    return true;
}
