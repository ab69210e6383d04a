// What reaches the camera through matter with depth along each of an array of rays, for tests and
// measurements. A single ray sees points of the structure, as its twin in f64 does.
//
// Gives: passages.

// Unit looking directions; the fourth component is padding.
@group(0) @binding(BINDING_INPUT) var<storage, read> directions: array<vec4<f32>>;
@group(0) @binding(BINDING_OUTPUT) var<storage, read_write> rays_passages: array<Passage>;

@compute @workgroup_size(WORKGROUP_SIZE)
fn passages(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&directions) || id.x >= arrayLength(&rays_passages) {
        return;
    }
    rays_passages[id.x] = passage(photon_from(directions[id.x].xyz));
}
