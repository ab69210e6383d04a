// The sky mode `off`: nothing shines at infinity.
//
// Needs: nothing.
// Gives: sky_light.

fn sky_light(direction: vec3<f32>, g: f32) -> vec3<f32> {
    return vec3<f32>(0.0);
}
