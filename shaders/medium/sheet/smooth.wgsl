// A disk without structure needs no footprint.
//
// Gives: sheet_footprint.

fn sheet_footprint(way: Way, share: f32, y: vec4<f32>, position: vec3<f32>) -> Footprint {
    return Footprint(vec3<f32>(0.0), vec3<f32>(0.0));
}
