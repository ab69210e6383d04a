// The shift of light by gravity and by motion, for pictures with one of them switched off. The twin
// in f64, optics/shift.rs, defines each part: g = gravity * motion, where gravity is that of the
// observers with zero angular momentum (ZAMO) at both ends, who measure the frequency E (1 - omega
// lambda) / N.
//
// Gives: beaming_factor, camera_gravity, disk_lambda, disk_shift, lapse_and_dragging, sky_shift,
//     straight_lambda.

// The factor by which a shift multiplies bolometric intensity: g^4, since I_nu / nu^3 is the same
// for all observers (Misner, Thorne & Wheeler 1973, section 22.6).
fn beaming_factor(g: f32) -> f32 {
    let g2 = g * g;
    return select(1.0, g2 * g2, BEAMING);
}

// g without the parts that are switched off.
fn split_shift(g: f32, gravity: f32) -> f32 {
    if DOPPLER && GRAVITATIONAL_SHIFT {
        return g;
    }
    return select(1.0, gravity, GRAVITATIONAL_SHIFT) * select(1.0, g / gravity, DOPPLER);
}

// N and omega in the disk's plane: N^2 = r Delta / B, omega = a / B, B = r^3 + a^2 r + a^2
// (Bardeen, Press & Teukolsky 1972 eqs. 2.3, 2.5 with 2 M = 1).
fn lapse_and_dragging(r: f32) -> vec2<f32> {
    let a2 = square(scene.hole.a);
    let b = r * (r * r + a2) + a2;
    return vec2<f32>(sqrt(max(r * (r * (r - 1.0) + a2) / b, TINY)), select(0.0, scene.hole.a / b, LENSING));
}

// On straight rays, the lambda for which 1 - Omega lambda is the Doppler factor of matter with the
// speed (Omega - omega) W / N, where moment_z / r is the cosine between its velocity and the light,
// and W = sqrt(B / r).
fn straight_lambda(r: f32, moment_z: f32) -> f32 {
    let a = scene.hole.a;
    let b = r * (r * r + a * a) + a * a;
    let inverse_omega = r * sqrt(r / MASS) + a;
    return moment_z / r * (1.0 - a / b * inverse_omega) * sqrt(b / r) / lapse_and_dragging(r).x;
}

// The lambda for the shift of light from the disk at r: L/E, which is constant along bent rays.
fn disk_lambda(photon: Photon, r: f32) -> f32 {
    let lambda = photon_angular_momentum(photon) / photon_energy(photon);
    if LENSING {
        return lambda;
    }
    // A straight ray's energy is its momentum times the camera's lapse.
    return straight_lambda(r, lambda * scene.observer.zamo_lapse);
}

fn camera_gravity(lambda: f32) -> f32 {
    return (1.0 - scene.observer.zamo_angular_velocity * lambda) / scene.observer.zamo_lapse;
}

// The ratio of the camera's frequency to the source's, for light from infinity.
fn sky_shift(photon: Photon) -> f32 {
    let energy = photon_energy(photon);
    return split_shift(1.0 / energy, camera_gravity(photon_angular_momentum(photon) / energy));
}

// The same for light from the disk at r, where g is the whole shift.
fn disk_shift(g: f32, r: f32, lambda: f32) -> f32 {
    let zamo = lapse_and_dragging(r);
    return split_shift(g, camera_gravity(lambda) * zamo.x / (1.0 - zamo.y * lambda));
}
