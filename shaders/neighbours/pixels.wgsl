// Differences between a pixel and its neighbours, in a fragment entry.
//
// Gives: differences, ray_share.

// All pixels must call it before any branch.
fn differences(value: vec3<f32>) -> Footprint {
    return Footprint(dpdx(value) * scene.picture.footprint, dpdy(value) * scene.picture.footprint);
}

// The share of the pixel that the ray stands for.
fn ray_share() -> f32 {
    return square(scene.picture.footprint);
}
