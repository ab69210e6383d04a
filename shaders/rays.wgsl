// Rays in, traces out: for ray files, tests and measurements, through the very parts that draw the
// picture.

// Unit looking directions on the observer's axes; the fourth number is padding.
@group(0) @binding(2) var<storage, read> directions: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read_write> traces: array<Trace>;

@compute @workgroup_size(64)
fn rays(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&directions) || id.x >= arrayLength(&traces) {
        return;
    }
    traces[id.x] = trace(photon_from(directions[id.x].xyz));
}
