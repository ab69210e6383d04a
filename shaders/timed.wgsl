// Tracing alone, for timing: every pixel gives one vector, which depends on everything that a
// picture could use, so that no compiler omits any of it.
//
// Gives: fragment, timed.

@group(0) @binding(BINDING_OUTPUT) var<storage, read_write> answers: array<vec4<f32>>;

fn answer(position: vec2<f32>) -> vec4<f32> {
    let ray = trace(photon_from(pixel_direction(position)));
    let first = ray.hits[0];
    let second = ray.hits[1];
    let seen = dot(first.position + 2.0 * second.position, vec3<f32>(1.0)) + first.g + 3.0 * second.g
        + 5.0 * first.delay + 7.0 * second.delay;
    return vec4<f32>(ray.sky, seen + f32(ray.outcome + 4u * ray.hit_count));
}

@compute @workgroup_size(WORKGROUP_SIZE)
fn timed(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.y * groups.x * WORKGROUP_SIZE + id.x;
    let width = u32(scene.picture.size.x);
    if index < arrayLength(&answers) {
        answers[index] = answer(vec2<f32>(vec2<u32>(index % width, index / width)) + 0.5);
    }
}

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return answer(position.xy);
}
