// The view `steps`: the number of steps that the method takes along each ray, behind the disk as
// well. The scale is logarithmic, from dark violet at 4 steps or fewer through red to pale yellow
// at 256 or more, the same for every method. A ray without a step is black, and one left unfinished
// magenta.
//
// Gives: light_along.

// The ends of the scale, in powers of two.
const LOG_FEWEST_STEPS: f32 = 2.0;
const LOG_MOST_STEPS: f32 = 8.0;

// Lightness grows linearly along the scale, so that it can also be read without its hues.
fn steps_colour(steps: f32) -> vec3<f32> {
    let share = (log2(max(steps, 1.0)) - LOG_FEWEST_STEPS) / (LOG_MOST_STEPS - LOG_FEWEST_STEPS);
    let t = clamp(share, 0.0, 1.0);
    return from_oklab(0.24 + 0.705 * t, 0.05 + t * (0.42 - 0.49 * t), t * (0.30 - 0.10 * t) - 0.10);
}

fn light_along(photon: Photon) -> vec4<f32> {
    let ray = trace(photon);
    if ray.outcome == OUTCOME_UNFINISHED {
        return mark(MAGENTA);
    }
    return mark(select(steps_colour(f32(ray.steps)), vec3<f32>(0.0), ray.steps == 0u));
}
