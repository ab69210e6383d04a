// The light of a picture, for timing: every pixel gives the light of its ray, from a compute entry.
//
// Gives: timed.

@group(0) @binding(BINDING_OUTPUT) var<storage, read_write> answers: array<vec4<f32>>;

@compute @workgroup_size(WORKGROUP_SIZE)
fn timed(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.y * groups.x * WORKGROUP_SIZE + id.x;
    let width = u32(scene.picture.size.x);
    if index < arrayLength(&answers) {
        answers[index] = light_at(vec2<f32>(vec2<u32>(index % width, index / width)) + 0.5);
    }
}
