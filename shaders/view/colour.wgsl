// The views `colour` and `unfinished`: the light itself.
//
// Gives: compared_light, light_along, seen_along.

// The light along a ray, and its visible outcome and hits, by which the search for edges compares
// neighbouring pixels.
struct Seen {
    light: vec4<f32>,
    outcome: u32,
    hit_count: u32,
}

// Alpha is the share of the ray that ends at a source, disk or sky: zero in the shadow, where bloom
// must add nothing (presentation.wgsl).
fn seen_along(photon: Photon) -> Seen {
    let ray = trace(photon);
    // Before any branch, because neighbouring rays must call these together.
    let footprints = hit_footprints(ray);
    let sky_footprint = differences(ray.sky);
    var light = vec3<f32>(0.0);
    var transmission = 1.0;
    var without_source = 1.0;
    var visible = VisibleHits(0u, 1.0);
    var hit = ray.hits[0];
    var footprint = footprints.first;
    // A loop, which ends early also in drivers that execute both sides of a branch.
    for (var i = 0u; i < min(ray.hit_count, MAX_HITS); i++) {
        let r = length(hit.position);
        let cover = disk_cover(r);
        light += transmission * disk_light(photon, hit, footprint);
        visible = with_crossing(visible, cover);
        transmission *= disk_transmission(r);
        without_source *= 1.0 - cover;
        if transmission == 0.0 {
            break;
        }
        hit = ray.hits[1];
        footprint = footprints.second;
    }
    if ray.outcome == OUTCOME_SKY {
        light += transmission * sky_light(ray.sky, sky_shift(photon), sky_footprint);
    }
    let outcome = visible_outcome(ray.outcome, visible.share);
    if SHOW_UNFINISHED && ray.outcome == OUTCOME_UNFINISHED {
        return Seen(mark(MAGENTA), outcome, visible.count);
    }
    let ends_dark = ray.outcome == OUTCOME_CAPTURED || ray.outcome == OUTCOME_UNFINISHED;
    return Seen(vec4<f32>(light, select(1.0, 1.0 - without_source, ends_dark)), outcome, visible.count);
}

// The light that the search for edges compares.
fn compared_light(seen: Seen) -> vec3<f32> {
    return seen.light.rgb;
}

fn light_along(photon: Photon) -> vec4<f32> {
    return seen_along(photon).light;
}
