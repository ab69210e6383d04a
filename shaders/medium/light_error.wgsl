// The view `light-error`: how much the light of the matter changes when each chunk of a ray is divided in two,
// as a share of the light, or of a hundredth of what the brightest surface shines, if that is more. The
// scale is that of the view `error`.
//
// Gives: light_along.

// The share of the brightest light below which errors are no larger shares.
const LIGHT_FLOOR: f32 = 0.01;

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
    let off = abs(seen.light - finer.light);
    let size = max(finer.light, vec3<f32>(LIGHT_FLOOR * brightest_light()));
    let errors = off / max(size, vec3<f32>(TINY));
    return mark(error_colour(max(errors.r, max(errors.g, errors.b))));
}
