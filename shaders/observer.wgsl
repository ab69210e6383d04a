// The photon that arrives from a looking direction, by the observer's matrix in the uniform.
//
// Gives: photon_angular_momentum, photon_energy, photon_from.

// For a fast observer, and in the ergosphere, the momentum of most light is a small difference of
// large numbers. Expanded about the direction of the smallest photons, with |d| = 1 used for the
// component along it, every component is accurate.
fn photon_from(direction: vec3<f32>) -> Photon {
    let off = direction - scene.observer.expansion_centre;
    let one_off = vec4<f32>(1.0, off);
    let half = 0.5 * dot(off, off);
    let w = vec3<f32>(dot(scene.observer.w_x, one_off), dot(scene.observer.w_y, one_off), dot(scene.observer.w_z, one_off));
    // The margin to the edge of the shadow is expanded about the shadow's center in the same way.
    let aside = direction - scene.shadow.center;
    let photon = Photon(
        dot(scene.observer.energy, one_off) + scene.observer.energy_curvature * half,
        dot(scene.observer.radial, one_off) + scene.observer.curvature.x * half,
        w + scene.observer.curvature.yzw * half,
        dot(scene.shadow.margin, vec4<f32>(1.0, aside)) + scene.shadow.curvature * 0.5 * dot(aside, aside),
    );
    if ABERRATION {
        return photon;
    }
    let frequency = dot(scene.observer.frequency, vec4<f32>(1.0, direction));
    return Photon(
        photon.energy / frequency,
        photon.radial / frequency,
        photon.w / frequency,
        photon.shadow_margin / frequency,
    );
}

// E, kept away from zero: next to the horizon an observer can meet light without energy.
fn photon_energy(photon: Photon) -> f32 {
    return max(photon.energy, 1e-6);
}

// L = p_phi = r (n x w)_z.
fn photon_angular_momentum(photon: Photon) -> f32 {
    return scene.observer.r * cross(scene.observer.position_direction, photon.w).z;
}
