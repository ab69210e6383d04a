// The view `delay`.
//
// Needs: MAGENTA, OUTCOME_UNFINISHED, Photon, from_oklab, mark, trace.
// Gives: light_along.

fn light_along(photon: Photon) -> vec4<f32> {
    let ray = trace(photon);
    let colour = select(vec3<f32>(0.0), from_oklab(0.5 + 0.01 * ray.hits[0].delay, 0.0, 0.0), ray.hit_count > 0u);
    return mark(select(colour, MAGENTA, ray.outcome == OUTCOME_UNFINISHED));
}
