// A source that is the same at every depth: a surface that is equally bright from everywhere.
//
// Gives: source_function.

fn source_function(r: vec4<f32>, n_z: vec4<f32>, opening: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(1.0);
}
