// What potentials and motions do to light, apart from each other, where one of them is switched
// off. crates/lightfall-core/src/optics/shift.rs has the same in f64 and says what each means: g = gravity * motion, at
// both ends for the observer with zero angular momentum, whose frequency is E (1 - omega lambda) /
// N.

// What a shift does to bolometric intensity: g^4, since I_nu / nu^3 is the same for everyone
// (Misner, Thorne & Wheeler 1973, section 22.6).
fn beamed(g: f32) -> f32 {
    let g2 = g * g;
    return select(1.0, g2 * g2, BEAMING);
}

// g without the share of what is switched off.
fn parted(g: f32, gravity: f32) -> f32 {
    if DOPPLER && GRAVITATIONAL_SHIFT {
        return g;
    }
    return select(1.0, gravity, GRAVITATIONAL_SHIFT) * select(1.0, g / gravity, DOPPLER);
}

// N and omega in the disk's plane: N^2 = r Delta / B, omega = a / B, B = r^3 + a^2 r + a^2
// (Bardeen, Press & Teukolsky 1972 eqs. 2.3, 2.5 with 2 M = 1).
fn lapse_and_dragging(r: f32) -> vec2<f32> {
    let a2 = square(scene.spin_length);
    let b = r * (r * r + a2) + a2;
    return vec2<f32>(sqrt(max(r * (r * (r - 1.0) + a2) / b, TINY)), select(0.0, scene.spin_length / b, LENSING));
}

fn camera_gravity(lambda: f32) -> f32 {
    return (1.0 - scene.camera_dragging * lambda) / scene.camera_lapse;
}

// Camera's over source's frequency of light from infinity.
fn sky_shift(photon: Photon) -> f32 {
    let energy = photon_energy(photon);
    return parted(1.0 / energy, camera_gravity(photon_angular_momentum(photon) / energy));
}

// Of light from the disk at r, g being the whole shift.
fn disk_shift(g: f32, r: f32, lambda: f32) -> f32 {
    let there = lapse_and_dragging(r);
    return parted(g, camera_gravity(lambda) * there.x / (1.0 - there.y * lambda));
}
