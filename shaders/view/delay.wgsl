// The view `delay`: the travel time of light from the first crossing of the disk, less the camera's
// time_lead. From pale yellow for light of the near side through red to deep blue for light that
// has gone around the hole. A new band begins every 2 r_s/c; its edge is a line of equal delay.
//
// Gives: light_along.

// The ends of the scale and the width of a band, in r_s/c.
const SOONEST: f32 = -10.0;
const LATEST: f32 = 30.0;
const BAND: f32 = 2.0;

// Lightness falls linearly along the scale, so that it can also be read without its hues.
fn delay_colour(delay: f32) -> vec3<f32> {
    let t = clamp((delay - SOONEST) / (LATEST - SOONEST), 0.0, 1.0);
    return from_oklab(0.95 - 0.71 * t, t * (0.44 - 0.41 * t) - 0.01, 0.085 + t * (0.02 - 0.245 * t));
}

fn light_along(photon: Photon) -> vec4<f32> {
    let ray = trace(photon);
    if ray.outcome == OUTCOME_UNFINISHED {
        return mark(MAGENTA);
    }
    let delay = ray.hits[0].delay;
    let shade = 0.7 + 0.3 * fract(delay / BAND);
    return mark(select(vec3<f32>(0.0), shade * delay_colour(delay), ray.hit_count > 0u));
}
