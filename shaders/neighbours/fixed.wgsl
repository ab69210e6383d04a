// Neighbours at a fixed distance, a thousandth of what is compared, for timing in a compute entry, where a
// pixel has none.
//
// Gives: differences, ray_share.

fn differences(value: vec3<f32>) -> Footprint {
    return Footprint(0.001 * value.yzx, 0.001 * value.zxy);
}

// The share of the pixel that the ray stands for.
fn ray_share() -> f32 {
    return 1.0;
}
