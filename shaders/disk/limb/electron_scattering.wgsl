// Limb darkening of an electron-scattering atmosphere (Chandrasekhar 1960, table XXIV), which is
// three times as bright from above as from the side. The twin in f64 is optics/limb.rs.
//
// Gives: limb_darkening.

// The cosine of the angle between the light and the disk's normal in the matter's frame (Cunningham
// 1975):
//
//   mu = g sqrt(Q) / r,   Q = J_x^2 + J_y^2 - a^2 E^2 n_z^2,   J = r n x w,
//
// with n and w at the camera, and g including the effects that are switched off. In flat space
// sqrt(Q) is the light's momentum along the normal for the observer with zero angular momentum at
// the camera; for the one at the disk it is larger by the ratio of their lapses.
fn emission_cosine(photon: Photon, hit: Hit) -> f32 {
    let r = length(hit.position);
    let n = scene.observer.position_direction;
    let j = scene.observer.r * cross(n, photon.w);
    let energy = photon_energy(photon);
    var normal = sqrt(dot(j.xy, j.xy)) * scene.observer.zamo_lapse / lapse_and_dragging(r).x;
    if LENSING {
        normal = sqrt(max(dot(j.xy, j.xy) - square(scene.hole.a * energy * n.z), 0.0));
    }
    var g = hit.g;
    if !(DOPPLER && GRAVITATIONAL_SHIFT) {
        g = whole_redshift(r, energy, disk_lambda(photon, r));
    }
    return clamp(g * normal / r, 0.0, 1.0);
}

// Intensity over its mean, which is flux/pi: a fit to the table, within 0.25 % of it, with the same
// flux.
fn limb_darkening(photon: Photon, hit: Hit) -> f32 {
    let mu = emission_cosine(photon, hit);
    return 0.41344 + 0.1137 * sqrt(mu) + 0.7434 * mu;
}
