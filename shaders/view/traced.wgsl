// What a place of the picture shows, in pixels from its upper left corner: the light of the ray
// traced through it.

fn light_at(place: vec2<f32>) -> vec3<f32> {
    return light_along(photon_from(pixel_direction(place)));
}
