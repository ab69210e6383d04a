// The view `redshift`: observed over emitted frequency g of the first source on the ray, disk or
// sky. White at g = 1, through blue to dark blue at g = 2 and more, through orange to dark red at g
// = 1/2 and less, with equal steps in ln g. Colour-blind people can tell blue and orange apart. A
// ray that ends at the horizon without a crossing is black.
//
// Gives: light_along.

fn shift_colour(g: f32) -> vec3<f32> {
    let octaves = clamp(log2(max(g, TINY)), -1.0, 1.0);
    let half_way = clamp(2.0 * abs(octaves), 0.0, 1.0);
    let beyond = clamp(2.0 * abs(octaves) - 1.0, 0.0, 1.0);
    let blue = mix(vec3<f32>(0.10, 0.40, 0.95), vec3<f32>(0.01, 0.04, 0.40), beyond);
    let red = mix(vec3<f32>(0.90, 0.30, 0.03), vec3<f32>(0.25, 0.01, 0.01), beyond);
    return mix(vec3<f32>(0.90), select(red, blue, octaves > 0.0), half_way);
}

fn light_along(photon: Photon) -> vec4<f32> {
    let ray = trace(photon);
    if ray.hit_count > 0u {
        return mark(shift_colour(ray.hits[0].g));
    }
    if ray.outcome == OUTCOME_SKY {
        return mark(shift_colour(sky_shift(photon)));
    }
    return mark(select(vec3<f32>(0.0), MAGENTA, ray.outcome == OUTCOME_UNFINISHED));
}
