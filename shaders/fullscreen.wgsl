// A triangle that covers the whole target, at the far plane (reverse depth: z = 0). With a depth
// test, only pixels that nothing covers are drawn.
//
// Gives: vertex.

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0);
}
