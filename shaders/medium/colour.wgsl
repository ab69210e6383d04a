// The view `colour` of a scene with matter with depth: its light, and the sky's behind it.
//
// Gives: compared_light, light_along, seen_along.

// The light along a ray, and its visible outcome and hits, by which the search for edges compares
// neighbouring pixels.
struct Seen {
    light: vec4<f32>,
    outcome: u32,
    hit_count: u32,
}

// Alpha is the share of the ray that ends at a source, medium or sky: zero in the shadow, where bloom
// must add nothing (presentation.wgsl). A medium that lets less than half of the light through counts
// as a hit.
fn seen_along(photon: Photon) -> Seen {
    let seen = passage(photon);
    // Before any branch, because neighbouring rays must call it together.
    let sky_footprint = differences(seen.ray.sky);
    var light = seen.light;
    if seen.ray.outcome == OUTCOME_SKY {
        light += seen.transmission * sky_light(seen.ray.sky, sky_shift(photon), sky_footprint);
    }
    let hit_count = select(0u, 1u, seen.transmission < 0.5);
    let outcome = visible_outcome(seen.ray.outcome, seen.transmission);
    if SHOW_UNFINISHED && seen.ray.outcome == OUTCOME_UNFINISHED {
        return Seen(mark(MAGENTA), outcome, hit_count);
    }
    let ends_dark = seen.ray.outcome == OUTCOME_CAPTURED || seen.ray.outcome == OUTCOME_UNFINISHED;
    return Seen(vec4<f32>(light, select(1.0, 1.0 - seen.transmission, ends_dark)), outcome, hit_count);
}

// The light that the search for edges compares.
fn compared_light(seen: Seen) -> vec3<f32> {
    return seen.light.rgb;
}

fn light_along(photon: Photon) -> vec4<f32> {
    return seen_along(photon).light;
}
