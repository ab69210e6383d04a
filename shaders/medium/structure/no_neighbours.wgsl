// Matter without structure needs no footprint.
//
// Gives: Neighbours, carried, neighbours_of.

struct Neighbours {
    none: u32,
}

fn neighbours_of(photon: Photon, orbit: KerrRay, ray: Ray, h: f32) -> Neighbours {
    return Neighbours(0u);
}

fn carried(way: Way) -> Neighbours {
    return way.neighbours;
}
