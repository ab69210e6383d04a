// A smooth disk.
//
// Gives: hit_footprints, structure_factor.

fn hit_footprints(ray: Trace) -> Footprints {
    let none = Footprint(vec3<f32>(0.0), vec3<f32>(0.0));
    return Footprints(none, none);
}

fn structure_factor(hit: Hit, footprint: Footprint) -> f32 {
    return 1.0;
}
