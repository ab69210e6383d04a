// No hot spot.
//
// Gives: hot_spot_factor.

fn hot_spot_factor(hit: Hit) -> f32 {
    return 1.0;
}
