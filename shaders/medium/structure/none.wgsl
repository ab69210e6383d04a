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

fn matter_factors(way: Way, shares: vec4<f32>, parts: vec4<f32>, at: Places) -> Factors {
    return Factors(vec4<f32>(1.0), vec4<f32>(1.0));
}
