// The view `colour` of a scene with matter with depth, in layers: the light that a ray brings from the
// layers that are drawn, with their share of the ray in alpha. medium/colour.wgsl adds up the light of all
// layers in the same way.
//
// Gives: compared_light, light_along, seen_along.

// As in layers/colour.wgsl.
struct Seen {
    light: vec4<f32>,
    compared: vec3<f32>,
    outcome: u32,
    hit_count: u32,
}

fn seen_along(photon: Photon) -> Seen {
    begin_sheets();
    let seen = passage(photon);
    // Before any branch, because neighbouring rays must call it together.
    let sky_footprint = differences(seen.ray.sky);
    let is_sky = seen.ray.outcome == OUTCOME_SKY;
    let ends_dark = seen.ray.outcome == OUTCOME_CAPTURED || seen.ray.outcome == OUTCOME_UNFINISHED;
    // A ray that sees nothing behind the matter ends there.
    let behind = select(0.0, seen.transmission, is_sky || ends_dark);
    var light = seen.light;
    let first = sheet_of(0u);
    let later = sheet_of(1u);
    let matter = vec4<f32>(seen.light, 1.0 - behind) - first - later;
    var drawn = light_of_layer(LAYER_VOLUME, matter.rgb, matter.a);
    drawn += light_of_layer(LAYER_HIT1, first.rgb, first.a);
    drawn += light_of_layer(LAYER_HIT2, later.rgb, later.a);
    if is_sky {
        let arriving = seen.transmission * sky_light(seen.ray.sky, sky_shift(photon), sky_footprint);
        light += arriving;
        drawn += light_of_layer(LAYER_SKY, arriving, behind);
    } else {
        drawn += light_of_layer(LAYER_HOLE, vec3<f32>(0.0), behind);
    }
    let hit_count = select(0u, 1u, seen.transmission < 0.5);
    let outcome = visible_outcome(seen.ray.outcome, seen.transmission);
    return Seen(drawn, light, outcome, hit_count);
}

// The light that the search for edges compares.
fn compared_light(seen: Seen) -> vec3<f32> {
    return seen.compared;
}

fn light_along(photon: Photon) -> vec4<f32> {
    return seen_along(photon).light;
}
