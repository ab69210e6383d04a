// Jets without knots.
//
// Gives: Patterns, jet_factor.

struct Patterns {
    none: vec4<f32>,
}

fn jet_factor(way: Way, share: f32, part: f32, r: f32, stream: f32, y: vec4<f32>, slope: vec4<f32>) -> f32 {
    return 1.0;
}
