// The light of the disk.
//
// Gives: disk_light.

// Linear light of a crossing. The flux F in the matter's frame has the temperature T_scale F^(1/4)
// (Stefan-Boltzmann). Shifted thermal light has Planck's spectrum at g T, and its intensity is
// beamed.
fn disk_light(photon: Photon, hit: Hit, footprint: Footprint) -> vec3<f32> {
    let r = length(hit.position);
    let flux = disk_flux(r) * structure_factor(hit, footprint) * hot_spot_factor(hit);
    let temperature = scene.disk.temperature * sqrt(sqrt(flux));
    let brightness = scene.disk.brightness * disk_cover(r) * limb_darkening(photon, hit);
    return thermal_colour(temperature * hit.g) * (flux * beaming_factor(hit.g) * brightness);
}
