// The picture: pixel -> photon -> trace -> light. A triangle at the far plane covers the picture, so the depth test
// lets only those pixels through that nothing stands in front of.

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0);
}

// What a half float holds with room for sums to come.
const BRIGHTEST: f32 = 60000.0;
const MAGENTA: vec3<f32> = vec3<f32>(1.0, 0.0, 1.0);

// The disk shines at each of the first two crossings and lets a share of what lies behind through.
fn light_along(photon: Photon) -> vec3<f32> {
    let ray = trace(photon);
    var light = vec3<f32>(0.0);
    var transmission = 1.0;
    if ray.hit_count > 0u {
        light = disk_light(ray.hits[0]);
        transmission = scene.disk_transmission;
    }
    if ray.hit_count > 1u {
        light += transmission * disk_light(ray.hits[1]);
        transmission *= scene.disk_transmission;
    }
    if ray.outcome == OUTCOME_SKY {
        light += transmission * sky_light(ray.sky, 1.0 / photon_energy(photon));
    }
    if SHOW_UNFINISHED && ray.outcome == OUTCOME_UNFINISHED {
        light = scene.mark_brightness * MAGENTA;
    }
    return light;
}

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let light = light_along(photon_from(pixel_direction(position.xy)));
    // A comparison with what is not a number is false, so none can leave here.
    return vec4<f32>(select(vec3<f32>(0.0), min(light, vec3<f32>(BRIGHTEST)), light > vec3<f32>(0.0)), 1.0);
}
