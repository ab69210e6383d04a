// Structure of the disk's light.
//
// Needs: Footprint, Hit.
// Gives: hit_footprint, structure_factor.

// The change of a hit's position from this pixel to its neighbours. All pixels must call it, before any
// branch.
fn hit_footprint(position: vec3<f32>) -> Footprint {
    return Footprint(dpdx(position), dpdy(position));
}

fn structure_factor(hit: Hit, footprint: Footprint) -> f32 {
    return 1.0;
}
