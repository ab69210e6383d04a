// How the photons of the next pixels differ, from the directions that are given with a single ray.
//
// Gives: PhotonChange, given_ray, photon_changes.

struct PhotonChange {
    energy: f32,
    radial: f32,
    w: vec3<f32>,
}

var<private> given_ray: GivenRay;

fn photon_change(photon: Photon, direction: vec3<f32>) -> PhotonChange {
    let beside = photon_from(direction);
    return PhotonChange(beside.energy - photon.energy, beside.radial - photon.radial, beside.w - photon.w);
}

// To the right, and downward.
fn photon_changes(photon: Photon) -> array<PhotonChange, 2> {
    return array<PhotonChange, 2>(photon_change(photon, given_ray.right), photon_change(photon, given_ray.below));
}
