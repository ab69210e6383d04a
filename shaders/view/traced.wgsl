// The light at a place of the whole picture, in pixels from its upper left corner: that of the ray
// through it.
//
// Gives: light_at.

fn light_at(place: vec2<f32>) -> vec4<f32> {
    return light_along(photon_from(pixel_direction(place)));
}
