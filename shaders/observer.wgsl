// From a looking direction to the photon that arrives from it. The matrix knows who is looking;
// nothing else does.

// For a fast observer almost all light comes from ahead, and what comes from elsewhere is a small
// difference of large numbers. Yet all its numbers are smooth about the direction in which light
// has the least energy: so they are reckoned from there, with |d| = 1 for the component along it,
// and keep their digits next to it.
fn photon_from(direction: vec3<f32>) -> Photon {
    let off = direction - scene.dimmest;
    let one_off = vec4<f32>(1.0, off);
    let half = 0.5 * dot(off, off);
    let w = vec3<f32>(dot(scene.w_x, one_off), dot(scene.w_y, one_off), dot(scene.w_z, one_off));
    // For the edge of the shadow likewise, from the middle of what it encloses.
    let aside = direction - scene.plunge_middle;
    let photon = Photon(
        dot(scene.energy, one_off) + scene.energy_bend * half,
        dot(scene.radial, one_off) + scene.bend.x * half,
        w + scene.bend.yzw * half,
        dot(scene.plunge, vec4<f32>(1.0, aside)) + scene.plunge_bend * 0.5 * dot(aside, aside),
    );
    if ABERRATION {
        return photon;
    }
    let frequency = dot(scene.frequency, vec4<f32>(1.0, direction));
    return Photon(
        photon.energy / frequency,
        photon.radial / frequency,
        photon.w / frequency,
        photon.plunge / frequency,
    );
}

// Unit looking direction (right, up, forward) of a place on the picture, in pixels from its upper
// left corner.
fn pixel_direction(pixel: vec2<f32>) -> vec3<f32> {
    let across = pixel / scene.picture_size * vec2<f32>(2.0, -2.0) + vec2<f32>(-1.0, 1.0);
    return normalize(vec3<f32>(across * scene.tan_half_fov, 1.0));
}

// E, kept from zero: next to the horizon an observer can meet light that has none.
fn photon_energy(photon: Photon) -> f32 {
    return max(photon.energy, 1e-6);
}

// L = p_phi = r (n x w)_z.
fn photon_angular_momentum(photon: Photon) -> f32 {
    return scene.camera_radius * cross(scene.camera_direction, photon.w).z;
}
