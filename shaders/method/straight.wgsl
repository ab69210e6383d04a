// Rays that nothing bends, for comparison: flat space, the hole a black ball.
// crates/lightfall-core/src/optics/straight.rs has the same in f64. The photons are those of flat space, too: see
// crates/lightfall-core/src/optics/camera_rays.rs.

// The lambda of which 1 - Omega lambda makes what the matter's speed (Omega - omega) W / N does to
// light that meets it with the direction moment_z / r along it; W = sqrt(B / r).
fn straight_lambda(r: f32, moment_z: f32) -> f32 {
    let a = scene.spin_length;
    let b = r * (r * r + a * a) + a * a;
    let inverse_omega = r * sqrt(r / MASS) + a;
    return moment_z / r * (1.0 - a / b * inverse_omega) * sqrt(b / r) / lapse_and_dragging(r).x;
}

fn trace(photon: Photon) -> Trace {
    var result = untraced();
    let n = scene.camera_direction;
    let start = scene.camera_radius * n;
    let direction = safe_normalize(-photon.radial * n - photon.w);
    let along = dot(start, direction);
    let moment = cross(start, direction);
    // Half of the chord through the hole, squared; negative for a ray that misses it.
    let half_chord2 = square(scene.horizon) - dot(moment, moment);
    let captured = along < 0.0 && half_chord2 >= 0.0;
    let to_end = -along - sqrt(max(half_chord2, 0.0));
    let crosses = start.z * direction.z < 0.0;
    let to_plane = -start.z / select(1.0, direction.z, crosses);
    if crosses && (!captured || to_plane < to_end) {
        let position = vec3<f32>(start.xy + to_plane * direction.xy, 0.0);
        let r = length(position);
        if r > scene.disk_inner && r < scene.disk_outer {
            add_hit(&result, position, photon_energy(photon), straight_lambda(r, -moment.z));
        }
    }
    result.outcome = select(OUTCOME_SKY, OUTCOME_CAPTURED, captured);
    result.sky = select(direction, vec3<f32>(0.0), captured);
    if result.hit_count > 0u {
        result.turn = angle_between(n, result.hits[0].position);
    } else if !captured {
        result.turn = angle_between(n, direction);
    }
    return result;
}
