// Traces the rays of the mesh, without the disk, at which `turn` would end.
//
// Gives: trace_mesh.

@group(0) @binding(BINDING_MESH_POINTS) var<storage, read_write> mesh_points: array<MeshPoint>;

// One invocation for each point.
@compute @workgroup_size(WORKGROUP_SIZE)
fn trace_mesh(@builtin(global_invocation_id) id: vec3<u32>) {
    let columns = max(mesh.points.x, 1u);
    let row = id.x / columns;
    if row >= mesh.points.y || id.x >= arrayLength(&mesh_points) {
        return;
    }
    let place = mesh_place(vec2<f32>(f32(id.x - row * columns), f32(row)));
    let photon = photon_from(pixel_direction(place));
    let ray = trace(photon);
    let gain = beaming_factor(min(sky_shift(photon), MAX_SHIFT));
    let sees_sky = ray.outcome == OUTCOME_SKY;
    mesh_points[id.x] = MeshPoint(in_list(ray.sky), ray.turn, select(-1.0, gain, sees_sky));
}
