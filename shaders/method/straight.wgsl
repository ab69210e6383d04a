// Straight rays, for scenes without lensing: flat space, in which the hole is a black ball. The
// photons are those of flat space too (optics/camera_rays.rs). The twin in f64 is
// optics/straight.rs.
//
// Gives: trace.

fn trace(photon: Photon) -> Trace {
    var result = empty_trace();
    let n = scene.observer.position_direction;
    let start = scene.observer.r * n;
    let direction = safe_normalize(-photon.radial * n - photon.w);
    let along = dot(start, direction);
    let moment = cross(start, direction);
    // The square of half the chord through the hole; negative for a ray that misses the hole.
    let half_chord2 = square(scene.hole.horizon) - dot(moment, moment);
    let captured = along < 0.0 && half_chord2 >= 0.0;
    let to_end = -along - sqrt(max(half_chord2, 0.0));
    let crosses = start.z * direction.z < 0.0;
    let to_plane = -start.z / select(1.0, direction.z, crosses);
    if crosses && (!captured || to_plane < to_end) {
        let position = vec3<f32>(start.xy + to_plane * direction.xy, 0.0);
        let r = length(position);
        if r > scene.disk.inner && r < scene.disk.outer {
            let delay = select(0.0, to_plane - scene.observer.time_lead, DELAY);
            add_hit(&result, position, photon_energy(photon), straight_lambda(r, -moment.z), delay);
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
