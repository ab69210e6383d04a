// The light of point sources as a layer. The file of their sums is linked with its `point_light` renamed
// to `light_of_all_points` (gpu/shader/choices.rs).
//
// Gives: point_light.

fn point_light(pixel: vec2<u32>) -> vec3<f32> {
    return select(vec3<f32>(0.0), light_of_all_points(pixel), is_drawn(LAYER_STARS));
}
