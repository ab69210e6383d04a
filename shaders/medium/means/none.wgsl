// Nothing asks where the light of matter comes from.
//
// Gives: weigh.

fn weigh(way: Way, share: f32, r: f32, n_z: f32, g: f32, light: vec3<f32>) {}
