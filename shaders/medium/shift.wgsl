// The shift of light from the medium, for pictures with one of its parts switched off.
//
// Gives: medium_shift.

// g without the parts that are switched off, where `g` is the whole shift. N and omega are those of
// the observer with zero angular momentum at each place: N^2 = Sigma Delta / A, omega = a r / A
// (Bardeen, Press & Teukolsky 1972 eqs. 2.3, 2.5 with 2 M = 1).
fn medium_shift(photon: Photon, r: vec4<f32>, n_z: vec4<f32>, g: vec4<f32>) -> vec4<f32> {
    if DOPPLER && GRAVITATIONAL_SHIFT {
        return g;
    }
    let a2 = square(scene.hole.a);
    let sigma = r * r + a2 * n_z * n_z;
    let delta = r * (r - 1.0) + a2;
    let area = sigma * (r * r + a2) + r * a2 * (1.0 - n_z * n_z);
    let lambda = photon_angular_momentum(photon) / photon_energy(photon);
    let lapse = sqrt(max(sigma * delta / area, vec4<f32>(TINY)));
    let gravity = camera_gravity(lambda) * lapse / (1.0 - scene.hole.a * r / area * lambda);
    return select(vec4<f32>(1.0), gravity, GRAVITATIONAL_SHIFT) * select(vec4<f32>(1.0), g / gravity, DOPPLER);
}
