// The disk's light.

// Share of the emission at radius r that the fades at both edges leave.
fn edge_fade(r: f32) -> f32 {
    let inner = (r - scene.disk_inner) / max(scene.disk_inner_fade, 1e-6);
    let outer = (scene.disk_outer - r) / max(scene.disk_outer_fade, 1e-6);
    let share = clamp(vec2<f32>(inner, outer), vec2<f32>(0.0), vec2<f32>(1.0));
    let smooth_share = share * share * (3.0 - 2.0 * share);
    return smooth_share.x * smooth_share.y;
}

// Linear light of a crossing. The flux F in the matter's frame is the disk model's; T = T_scale
// F^(1/4), after Stefan-Boltzmann. Thermal light keeps Planck's shape at the temperature g T, and
// is beamed.
fn disk_light(hit: Hit) -> vec3<f32> {
    let r = length(hit.position);
    let flux = disk_flux(r);
    let temperature = scene.disk_temperature * sqrt(sqrt(flux));
    return thermal_colour(temperature * hit.g) * (flux * beamed(hit.g) * scene.disk_brightness * edge_fade(r));
}
