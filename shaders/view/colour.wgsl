// The views `colour` and `unfinished`: the light itself.
//
// Needs: MAGENTA, MAX_HITS, OUTCOME_SKY, OUTCOME_UNFINISHED, Photon, SHOW_UNFINISHED, disk_light,
//     mark, scene, sky_light, sky_shift, trace.
// Gives: light_along.

// The disk shines at each of the first two crossings and lets a share of the light from behind
// through.
fn light_along(photon: Photon) -> vec3<f32> {
    let ray = trace(photon);
    var light = vec3<f32>(0.0);
    var transmission = 1.0;
    if ray.hit_count > 0u {
        light = disk_light(ray.hits[0]);
        transmission = scene.disk.transmission;
    }
    if MAX_HITS > 1u && ray.hit_count > 1u {
        light += transmission * disk_light(ray.hits[1]);
        transmission *= scene.disk.transmission;
    }
    if ray.outcome == OUTCOME_SKY {
        light += transmission * sky_light(ray.sky, sky_shift(photon));
    }
    if SHOW_UNFINISHED && ray.outcome == OUTCOME_UNFINISHED {
        light = mark(MAGENTA);
    }
    return light;
}
