// The light of the disk, and what it hides.
//
// Needs: Footprint, Hit, Photon, beaming_factor, disk_flux, hot_spot_factor, limb_darkening, scene,
//     structure_factor, thermal_colour.
// Gives: disk_cover, disk_light, disk_transmission.

// How much of the disk there is at radius r: one, except in the fades at both edges. Emission and
// opacity fade together, so that an edge is never darker than both the disk and what lies behind.
fn disk_cover(r: f32) -> f32 {
    let inner = (r - scene.disk.inner) / max(scene.disk.inner_fade, 1e-6);
    let outer = (scene.disk.outer - r) / max(scene.disk.outer_fade, 1e-6);
    let share = clamp(vec2<f32>(inner, outer), vec2<f32>(0.0), vec2<f32>(1.0));
    let smooth_share = share * share * (3.0 - 2.0 * share);
    return smooth_share.x * smooth_share.y;
}

// Share of the light from behind that passes through the disk at radius r.
fn disk_transmission(r: f32) -> f32 {
    return mix(1.0, scene.disk.transmission, disk_cover(r));
}

// Linear light of a crossing. The disk model gives the flux F in the matter's frame, and
// Stefan-Boltzmann's law the temperature T = T_scale F^(1/4). Shifted thermal light has Planck's
// spectrum at the temperature g T, and its intensity is beamed.
fn disk_light(photon: Photon, hit: Hit, footprint: Footprint) -> vec3<f32> {
    let r = length(hit.position);
    let flux = disk_flux(r) * structure_factor(hit, footprint) * hot_spot_factor(hit);
    let temperature = scene.disk.temperature * sqrt(sqrt(flux));
    let brightness = scene.disk.brightness * disk_cover(r) * limb_darkening(photon, hit);
    return thermal_colour(temperature * hit.g) * (flux * beaming_factor(hit.g) * brightness);
}
