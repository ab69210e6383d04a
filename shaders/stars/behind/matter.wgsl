// How much light from behind comes through matter with depth.
//
// Gives: transmission_along.

fn transmission_along(photon: Photon) -> f32 {
    return passage(photon).transmission;
}
