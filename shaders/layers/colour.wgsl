// The view `colour` in layers: the light that a ray brings from the layers that are drawn, with their share
// of the ray in alpha. view/colour.wgsl adds up the light of all layers in the same way.
//
// Gives: compared_light, light_along, seen_along.

struct Seen {
    // The light of the layers that are drawn, and their share of the ray.
    light: vec4<f32>,
    // The light of all layers.
    compared: vec3<f32>,
    // The visible outcome and hits.
    outcome: u32,
    hit_count: u32,
}

fn seen_along(photon: Photon) -> Seen {
    let ray = trace(photon);
    // Before any branch, because neighbouring rays must call these together.
    let footprints = hit_footprints(ray);
    let sky_footprint = differences(ray.sky);
    var light = vec3<f32>(0.0);
    var drawn = vec4<f32>(0.0);
    var transmission = 1.0;
    var visible = VisibleHits(0u, 1.0);
    var layer = LAYER_HIT1;
    var hit = ray.hits[0];
    var footprint = footprints.first;
    for (var i = 0u; i < min(ray.hit_count, MAX_HITS); i++) {
        let r = length(hit.position);
        let through = disk_transmission(r);
        let arriving = transmission * disk_light(photon, hit, footprint);
        layer = select(LAYER_HIT1, LAYER_HIT2, i > 0u);
        light += arriving;
        drawn += light_of_layer(layer, arriving, transmission * (1.0 - through));
        visible = with_crossing(visible, disk_cover(r));
        transmission *= through;
        if transmission == 0.0 {
            break;
        }
        hit = ray.hits[1];
        footprint = footprints.second;
    }
    let ends_dark = ray.outcome == OUTCOME_CAPTURED || ray.outcome == OUTCOME_UNFINISHED;
    if ray.outcome == OUTCOME_SKY {
        let arriving = transmission * sky_light(ray.sky, sky_shift(photon), sky_footprint);
        light += arriving;
        drawn += light_of_layer(LAYER_SKY, arriving, transmission);
    } else {
        // The rest of a ray that ends at a crossing of the disk belongs to this crossing.
        drawn += light_of_layer(select(layer, LAYER_HOLE, ends_dark), vec3<f32>(0.0), transmission);
    }
    return Seen(drawn, light, visible_outcome(ray.outcome, visible.share), visible.count);
}

// The light that the search for edges compares.
fn compared_light(seen: Seen) -> vec3<f32> {
    return seen.compared;
}

fn light_along(photon: Photon) -> vec4<f32> {
    return seen_along(photon).light;
}
