// Matter without structure.
//
// Gives: Neighbours, carried, matter_factors, neighbours_of.

// Smooth matter needs no footprint.
struct Neighbours {
    none: u32,
}

fn neighbours_of(photon: Photon, orbit: KerrRay, ray: Ray, h: f32) -> Neighbours {
    return Neighbours(0u);
}

fn carried(way: Way) -> Neighbours {
    return way.neighbours;
}

fn matter_factors(way: Way, ends: vec2<f32>, places: array<Places, MEDIUM_BLOCKS>) -> array<Factors, MEDIUM_BLOCKS> {
    var factors: array<Factors, MEDIUM_BLOCKS>;
    for (var i = 0u; i < MEDIUM_BLOCKS; i++) {
        factors[i] = Factors(vec4<f32>(1.0), vec4<f32>(1.0));
    }
    return factors;
}
