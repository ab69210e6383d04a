// Limb darkening of an atmosphere that scatters light on electrons.
//
// Needs: Hit, Photon.
// Gives: limb_darkening.

fn limb_darkening(photon: Photon, hit: Hit) -> f32 {
    return 1.0;
}
