// The picture's fragment entry where layers are drawn and edges are refined: the light of the layers on
// each pixel, and the traits that the search for edges compares. The traits are those of all light, so
// that every layer is refined in the same pixels.
//
// Gives: fragment.

// As in antialias/geodesic.wgsl.
struct Pixel {
    @location(0) light: vec4<f32>,
    @location(1) traits: vec2<u32>,
}

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> Pixel {
    let pixel = vec2<u32>(position.xy - scene.picture.corner);
    let place = place_of(pixel);
    let seen = seen_along(photon_from(pixel_direction(place + scene.picture.offset)));
    let brightness = shown_brightness(bounded_light(seen.light));
    let drawn = bounded_light(bounded_light(seen.drawn.rgb) + point_light(pixel));
    return Pixel(
        vec4<f32>(coverage(place) * drawn, seen.drawn.a),
        vec2<u32>(ray_class(seen.outcome, seen.hit_count), u32(255.0 * brightness + 0.5)),
    );
}
