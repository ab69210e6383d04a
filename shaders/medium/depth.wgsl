// The view `depth`: the optical depth of the matter along each ray. The scale is logarithmic, from dark blue at
// 0.01 or less to white at 5 or more, where a ray is given up soon.
//
// Gives: light_along.

// The ends of the scale, in powers of two: 0.01 and 5.
const LOG_THIN: f32 = -6.64385619;
const LOG_OPAQUE: f32 = 2.32192809;

// Lightness grows linearly along the scale, so that it can also be read without its hues.
fn depth_colour(depth: f32) -> vec3<f32> {
    let share = (log2(max(depth, TINY)) - LOG_THIN) / (LOG_OPAQUE - LOG_THIN);
    let t = clamp(share, 0.0, 1.0);
    return from_oklab(0.24 + 0.72 * t, -0.01 - 0.09 * t * (1.0 - t), -0.09 + t * (0.20 - 0.10 * t));
}

fn light_along(photon: Photon) -> vec4<f32> {
    let seen = passage(photon);
    if seen.ray.outcome == OUTCOME_UNFINISHED {
        return mark(MAGENTA);
    }
    let depth = -log_precise(max(seen.transmission, TINY));
    return mark(select(depth_colour(depth), vec3<f32>(0.0), seen.transmission >= 1.0));
}
