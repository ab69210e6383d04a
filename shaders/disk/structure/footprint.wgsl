// The footprint of a pixel on the disk.
//
// Needs: Footprint.
// Gives: hit_footprint.

// The change of a hit's position from this pixel to its neighbours. All pixels must call it, before any
// branch.
fn hit_footprint(position: vec3<f32>) -> Footprint {
    return Footprint(dpdx(position), dpdy(position));
}
