// No neighbours: a compute entry of single rays.
//
// Gives: differences, ray_share.

fn differences(value: vec3<f32>) -> Footprint {
    return Footprint(vec3<f32>(0.0), vec3<f32>(0.0));
}

// The share of the pixel that the ray stands for.
fn ray_share() -> f32 {
    return 1.0;
}
