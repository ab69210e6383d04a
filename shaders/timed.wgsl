// What tracing alone costs: every pixel of the picture, one vector each, whether from a compute
// entry or from a fragment one. All that a picture could use goes into the vector, so that no
// compiler leaves any of it out.

@group(0) @binding(3) var<storage, read_write> answers: array<vec4<f32>>;

fn answer(position: vec2<f32>) -> vec4<f32> {
    let trace = trace(photon_from(pixel_direction(position)));
    let first = trace.hits[0];
    let second = trace.hits[1];
    let seen = dot(first.position + 2.0 * second.position, vec3<f32>(1.0)) + first.g + 3.0 * second.g;
    return vec4<f32>(trace.sky, seen + f32(trace.outcome + 4u * trace.hit_count));
}

@compute @workgroup_size(64)
fn timed(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.y * groups.x * 64u + id.x;
    let width = u32(scene.picture_size.x);
    if index < arrayLength(&answers) {
        answers[index] = answer(vec2<f32>(vec2<u32>(index % width, index / width)) + 0.5);
    }
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0);
}

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return answer(position.xy);
}
