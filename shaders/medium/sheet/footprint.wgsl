// The footprint of a ray on a disk without thickness, by the ray's differential.
//
// Gives: sheet_footprint.

// A neighbour's way across the ray, moved along the ray to the plane, as a change of position.
fn footprint_side(n: Neighbour, share: f32, y: vec4<f32>, u: f32, along: vec3<f32>, position: vec3<f32>) -> vec3<f32> {
    let across = deviation_at(n, share, y, u, along);
    let in_plane = across - across.z / select(along.z, TINY, along.z == 0.0) * along;
    return in_plane.x * position + in_plane.y * vec3<f32>(-position.y, position.x, 0.0);
}

// Where the ray has the state y and the disk this position.
fn sheet_footprint(way: Way, share: f32, y: vec4<f32>, position: vec3<f32>) -> Footprint {
    let u = max(way.motion.base + y.x, TINY);
    let along = change_at(way, y, curve_slope(way.path, share)).xyz;
    return Footprint(
        footprint_side(way.neighbours.right, share, y, u, along, position),
        footprint_side(way.neighbours.below, share, y, u, along, position),
    );
}
