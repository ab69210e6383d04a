// The footprints of a pixel on the disk in a compute entry, which knows no neighbouring pixels: a
// hundredth of the radius, for timing only.
//
// Needs: Footprint, Footprints, Trace.
// Gives: hit_footprints.

fn fixed_footprint(position: vec3<f32>) -> Footprint {
    return Footprint(0.01 * position, 0.01 * vec3<f32>(-position.y, position.x, 0.0));
}

fn hit_footprints(ray: Trace) -> Footprints {
    return Footprints(fixed_footprint(ray.hits[0].position), fixed_footprint(ray.hits[1].position));
}
