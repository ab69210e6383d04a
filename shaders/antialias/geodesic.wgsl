// The picture's fragment entry where edges are refined: the light of each pixel, and the traits
// that the search for edges compares. Where layers are drawn, the traits are those of all light, so
// that every layer is refined in the same pixels.
//
// Gives: fragment.

struct Pixel {
    @location(0) light: vec4<f32>,
    // The class of the ray, and the brightness of its light on a scale of 255 levels.
    @location(1) traits: vec2<u32>,
}

// The brightness that a screen shows, without the tone curve: sRGB's encoding of the luminance at
// the scene's exposure (IEC 61966-2-1).
fn shown_brightness(light: vec3<f32>) -> f32 {
    let luminance = clamp(dot(light, vec3<f32>(0.2126, 0.7152, 0.0722)) * scene.picture.exposure, 0.0, 1.0);
    return select(1.055 * pow(luminance, 1.0 / 2.4) - 0.055, 12.92 * luminance, luminance < 0.0031308);
}

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> Pixel {
    let pixel = vec2<u32>(position.xy - scene.picture.corner);
    let place = place_of(pixel);
    let seen = seen_along(photon_from(pixel_direction(place + scene.picture.offset)));
    let whole = bounded_light(bounded_light(seen.light.rgb) + point_light(pixel));
    let brightness = shown_brightness(bounded_light(compared_light(seen)));
    return Pixel(
        vec4<f32>(coverage(place) * whole, seen.light.a),
        vec2<u32>(ray_class(seen.outcome, seen.hit_count), u32(255.0 * brightness + 0.5)),
    );
}
