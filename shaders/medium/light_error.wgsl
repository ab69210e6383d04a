// The view `light-error`: how much the light of the matter changes when each chunk of a ray is divided in
// two. The scale is that of the view `error`.
//
// Gives: light_along.

fn light_along(photon: Photon) -> vec4<f32> {
    let seen = passage(photon);
    chunk_parts = 2u;
    let finer = passage(photon);
    if seen.ray.outcome == OUTCOME_UNFINISHED || finer.ray.outcome == OUTCOME_UNFINISHED {
        return mark(MAGENTA);
    }
    if finer.samples == 0u {
        return mark(vec3<f32>(0.0));
    }
    return mark(error_colour(light_change(seen.light, finer.light)));
}
