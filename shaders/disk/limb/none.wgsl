// A surface that is equally bright from everywhere.
//
// Gives: limb_darkening.

fn limb_darkening(photon: Photon, hit: Hit) -> f32 {
    return 1.0;
}
