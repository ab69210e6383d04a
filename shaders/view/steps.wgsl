// The view `steps`: the number of steps that the method takes along each ray, behind the disk as
// well. The scale is logarithmic, from dark violet at 4 steps or fewer through red to pale yellow
// at 256 or more, the same for every method. A ray without a step is black, and one left unfinished
// magenta.
//
// Gives: light_along.

fn light_along(photon: Photon) -> vec4<f32> {
    let ray = trace(photon);
    if ray.outcome == OUTCOME_UNFINISHED {
        return mark(MAGENTA);
    }
    return mark(select(count_colour(f32(ray.steps)), vec3<f32>(0.0), ray.steps == 0u));
}
