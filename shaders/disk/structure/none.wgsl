// A smooth disk.
//
// Needs: Footprint, Hit.
// Gives: hit_footprint, structure_factor.

fn hit_footprint(position: vec3<f32>) -> Footprint {
    return Footprint(vec3<f32>(0.0), vec3<f32>(0.0));
}

fn structure_factor(hit: Hit, footprint: Footprint) -> f32 {
    return 1.0;
}
