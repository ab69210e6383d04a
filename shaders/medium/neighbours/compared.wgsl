// How the photons of the next pixels differ, from the rays beside this one.
//
// Gives: PhotonChange, photon_changes.

struct PhotonChange {
    energy: f32,
    radial: f32,
    w: vec3<f32>,
}

// To the right, and downward. All rays must call it before any branch.
fn photon_changes(photon: Photon) -> array<PhotonChange, 2> {
    let change = differences(vec3<f32>(photon.energy, photon.radial, 0.0));
    let w = differences(photon.w);
    return array<PhotonChange, 2>(
        PhotonChange(change.to_the_right.x, change.to_the_right.y, w.to_the_right),
        PhotonChange(change.downward.x, change.downward.y, w.downward),
    );
}
