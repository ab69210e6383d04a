// Footprints of a fixed size, a hundredth of the radius, for timing in a compute entry, where a
// pixel has no neighbours.
//
// Gives: hit_footprints.

fn fixed_footprint(position: vec3<f32>) -> Footprint {
    return Footprint(0.01 * position, 0.01 * vec3<f32>(-position.y, position.x, 0.0));
}

fn hit_footprints(ray: Trace) -> Footprints {
    return Footprints(fixed_footprint(ray.hits[0].position), fixed_footprint(ray.hits[1].position));
}
