// A sky without the reference star.
//
// Gives: reference_star_light.

fn reference_star_light(direction: vec3<f32>, g: f32, footprint: Footprint) -> vec3<f32> {
    return vec3<f32>(0.0);
}
