// The constants of a photon's motion for the methods mino and closed; mino_motion.wgsl has the
// equations.
//
// Gives: KerrRay, PhotonConstants, begins_near_horizon, camera_is_inside, kerr_ray.

// The weight of E^2 beside K in the scale: radial rays cover at most du = step/2 in a step of mino.
const ENERGY_WEIGHT: f32 = 4.0;

// Constants of the motion, scaled.
struct PhotonConstants {
    energy: f32,
    // B and K'.
    drag: f32,
    k_prime: f32,
    // a^2 E^2 - K, and a^2 E^2.
    stiffness: f32,
    axial: f32,
    // W at the horizon.
    horizon_w: f32,
}

// A ray's constants, and its angular momentum vector at the camera.
struct KerrRay {
    constants: PhotonConstants,
    // The scaled w at the camera, its K, and its moment about the axis.
    w: vec3<f32>,
    k: f32,
    angular_momentum: f32,
    // L/E.
    lambda: f32,
    // The factor of the photon that makes K + ENERGY_WEIGHT E^2 one.
    scale: f32,
}

// Whether rays start in the expansion about u = 1/r_+.
fn begins_near_horizon() -> bool {
    return NEAR_HORIZON && scene.observer.u > 0.5 * scene.hole.horizon_u;
}

fn camera_is_inside() -> bool {
    return NEAR_HORIZON && scene.observer.u_to_horizon <= 0.0;
}

fn kerr_ray(photon: Photon) -> KerrRay {
    let n = scene.observer.position_direction;
    let a = scene.hole.a;
    // K = |w|^2 - a^2 E^2 n_z^2, for w as a length.
    let w_camera = scene.observer.r * photon.w;
    let k_camera = dot(w_camera, w_camera) - square(a * n.z * photon.energy);
    let scale = inverseSqrt(max(k_camera + ENERGY_WEIGHT * square(photon.energy), TINY));
    let energy = scale * photon.energy;
    let w = scale * w_camera;
    // K' = |w - a E e_z x n|^2, and L - a E is the moment of that vector about the axis, less
    // a E n_z^2.
    let dragged = w - a * energy * vec3<f32>(-n.y, n.x, 0.0);
    let k_prime = dot(dragged, dragged);
    let drag = -a * (n.x * dragged.y - n.y * dragged.x - a * energy * n.z * n.z);
    let angular_momentum = n.x * w.y - n.y * w.x;
    let u_horizon = scene.hole.horizon_u;
    let depth = scene.observer.u_to_horizon;
    var horizon_w = energy + drag * u_horizon * u_horizon;
    if begins_near_horizon() && depth > 0.0 {
        // E and B u^2 may cancel at the camera; outside, u'^2 and K' u^2 D do not.
        let d = depth * (scene.hole.horizon_separation + a * a * depth);
        let w_there = sqrt(square(scale * photon.radial) + k_prime * square(scene.observer.u) * d);
        horizon_w = w_there + drag * depth * (2.0 * u_horizon - depth);
    }
    let constants = PhotonConstants(energy, drag, k_prime, 2.0 * energy * drag - k_prime, square(a * energy), horizon_w);
    // Next to the horizon an observer can meet light without energy.
    let lambda = angular_momentum / select(energy, TINY, abs(energy) < TINY);
    return KerrRay(constants, w, dot(w, w) - square(a * energy * n.z), angular_momentum, lambda, scale);
}
