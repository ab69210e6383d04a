// How much light changes with twice the samples.
//
// Gives: light_change.

// The share of the brightest light below which errors are no larger shares.
const LIGHT_FLOOR: f32 = 0.01;

// As a share of the finer light, or of a hundredth of what the brightest surface shines, if that is more.
fn light_change(light: vec3<f32>, finer: vec3<f32>) -> f32 {
    let off = abs(light - finer);
    let size = max(max(finer.r, max(finer.g, finer.b)), LIGHT_FLOOR * brightest_light());
    return max(off.r, max(off.g, off.b)) / max(size, TINY);
}
