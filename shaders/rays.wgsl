// Traces an array of rays, for files of rays, tests and measurements, with the files that draw the
// picture.
//
// Gives: rays.

// Unit looking directions; the fourth component is padding.
@group(0) @binding(BINDING_INPUT) var<storage, read> directions: array<vec4<f32>>;
@group(0) @binding(BINDING_OUTPUT) var<storage, read_write> traces: array<Trace>;

@compute @workgroup_size(WORKGROUP_SIZE)
fn rays(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&directions) || id.x >= arrayLength(&traces) {
        return;
    }
    traces[id.x] = trace(photon_from(directions[id.x].xyz));
}
