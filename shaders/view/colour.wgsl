// The views `colour` and `unfinished`: the light itself.
//
// Needs: MAGENTA, MAX_HITS, OUTCOME_CAPTURED, OUTCOME_SKY, OUTCOME_UNFINISHED, Photon,
//     SHOW_UNFINISHED, disk_cover, disk_light, disk_transmission, hit_footprints, mark, sky_light,
//     sky_shift, trace.
// Gives: light_along.

// The disk shines at each of the first two crossings and lets a share of the light from behind
// through. Alpha is the share of the ray that ends at a source, disk or sky: zero in the shadow,
// where bloom must add nothing (pixelate.wgsl).
fn light_along(photon: Photon) -> vec4<f32> {
    let ray = trace(photon);
    // Before any branch: neighbouring pixels must call it together.
    let footprints = hit_footprints(ray);
    var light = vec3<f32>(0.0);
    var transmission = 1.0;
    var without_source = 1.0;
    var hit = ray.hits[0];
    var footprint = footprints.first;
    // A loop, so that drivers that execute both sides of a branch compute a light that nothing
    // hides only once for most pixels.
    for (var i = 0u; i < min(ray.hit_count, MAX_HITS); i++) {
        let r = length(hit.position);
        light += transmission * disk_light(photon, hit, footprint);
        transmission *= disk_transmission(r);
        without_source *= 1.0 - disk_cover(r);
        if transmission == 0.0 {
            break;
        }
        hit = ray.hits[1];
        footprint = footprints.second;
    }
    if ray.outcome == OUTCOME_SKY {
        light += transmission * sky_light(ray.sky, sky_shift(photon));
    }
    if SHOW_UNFINISHED && ray.outcome == OUTCOME_UNFINISHED {
        return mark(MAGENTA);
    }
    let ends_dark = ray.outcome == OUTCOME_CAPTURED || ray.outcome == OUTCOME_UNFINISHED;
    return vec4<f32>(light, select(1.0, 1.0 - without_source, ends_dark));
}
