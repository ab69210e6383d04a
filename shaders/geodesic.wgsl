// The picture: pixel -> photon -> trace -> light or, in a diagnostic view, the colour of a mark
// (view/; view/traced.wgsl goes this way, view/error.wgsl reads a table instead). A triangle at the
// far plane covers the picture, so the depth test lets only those pixels through that nothing
// stands in front of.

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0);
}

// What a half float holds with room for sums to come.
const MAX_LIGHT: f32 = 60000.0;
// Rays without an answer, in every view but `colour`.
const MAGENTA: vec3<f32> = vec3<f32>(1.0, 0.0, 1.0);

// A colour, of channels up to one, that is the same whatever the exposure.
fn mark(colour: vec3<f32>) -> vec3<f32> {
    return scene.mark_brightness * colour;
}

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let light = light_at(position.xy);
    // A comparison with what is not a number is false, so none can leave here.
    return vec4<f32>(select(vec3<f32>(0.0), min(light, vec3<f32>(MAX_LIGHT)), light > vec3<f32>(0.0)), 1.0);
}
