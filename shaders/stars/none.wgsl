// No point sources.
//
// Gives: point_light.

// Light of the point sources whose images fall on a pixel. It is added to the pixel once, after its
// rays are averaged, and no offset of the rays moves it.
fn point_light(pixel: vec2<u32>) -> vec3<f32> {
    return vec3<f32>(0.0);
}
