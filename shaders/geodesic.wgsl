// The picture's fragment entry: the light of each pixel. view/traced.wgsl takes a pixel to a
// photon, a ray and its light; view/error.wgsl reads a table instead.
//
// Gives: fragment.

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let pixel = vec2<u32>(position.xy - scene.picture.corner);
    let place = place_of(pixel);
    let seen = light_at(place + scene.picture.offset);
    return vec4<f32>(coverage(place) * bounded_light(seen.rgb + point_light(pixel)), seen.a);
}
