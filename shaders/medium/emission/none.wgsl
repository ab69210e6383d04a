// No light, for rays that only ask how much comes through the matter.
//
// Gives: emission.

fn emission(way: Way, shares: vec4<f32>, photon: Photon, at: Places, share: vec4<f32>, factor: vec4<f32>, shift: vec4<f32>) -> vec3<f32> {
    return vec3<f32>(0.0);
}
