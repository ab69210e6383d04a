// The sky mode `off`: nothing shines at infinity.
//
// Gives: sky_light.

fn sky_light(direction: vec3<f32>, g: f32, footprint: Footprint) -> vec3<f32> {
    return vec3<f32>(0.0);
}
