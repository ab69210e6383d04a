// The view `samples`: how many places of the matter each ray asks for their light. The scale is that of the view
// `steps`. A ray that meets no matter is black, and one left unfinished magenta.
//
// Gives: light_along.

fn light_along(photon: Photon) -> vec4<f32> {
    let seen = passage(photon);
    if seen.ray.outcome == OUTCOME_UNFINISHED {
        return mark(MAGENTA);
    }
    return mark(select(count_colour(f32(seen.samples)), vec3<f32>(0.0), seen.samples == 0u));
}
