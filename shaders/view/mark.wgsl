// Marks: colours that stand for something and look the same at every exposure.
//
// Gives: MAGENTA, mark.

// A ray without an answer, in every view but `colour`.
const MAGENTA: vec3<f32> = vec3<f32>(1.0, 0.0, 1.0);

// The light of a colour whose channels are at most one.
fn mark(colour: vec3<f32>) -> vec4<f32> {
    return vec4<f32>(scene.picture.mark_brightness * colour, 1.0);
}
