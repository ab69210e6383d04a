// The picture's fragment entry where edges are refined: the light of each pixel, and the traits
// that the search for edges compares.
//
// Gives: fragment.

struct Pixel {
    @location(0) light: vec4<f32>,
    // The class of the ray, and the brightness of its light on a scale of 255 levels.
    @location(1) traits: vec2<u32>,
}

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> Pixel {
    let pixel = vec2<u32>(position.xy - scene.picture.corner);
    let place = place_of(pixel);
    let seen = seen_along(photon_from(pixel_direction(place + scene.picture.offset)));
    let light = bounded_light(seen.light.rgb);
    let whole = bounded_light(light + point_light(pixel));
    return Pixel(
        vec4<f32>(coverage(place) * whole, seen.light.a),
        vec2<u32>(ray_class(seen.outcome, seen.hit_count), u32(255.0 * shown_brightness(light) + 0.5)),
    );
}
