// The method mino: Kerr's null geodesics for any spin, by steps in Mino time on the celestial
// sphere. mino_motion.wgsl has the equations and the step, mino_ray.wgsl the ray, and
// mino_azimuth.wgsl the azimuth.
//
// Gives: trace.

// Keeps the largest residuals of the constraints: u'^2 = U, |n| = 1, and L.
fn record_residuals(result: ptr<function, Trace>, ray: Ray, orbit: KerrRay, h: f32) {
    let w2 = square(quadratic(ray.motion.w, ray.y.x));
    let u2 = speed_squared(ray.motion, ray.y.x, w2);
    let radial = abs(square(ray.dy.x / h) - u2) / max(w2 + abs(w2 - u2), TINY);
    let length = abs(dot(ray.y.yzw, ray.y.yzw) - 1.0);
    (*result).residual = max((*result).residual, max(radial, length));
    let axial = abs((ray.y.z * ray.dy.w - ray.y.w * ray.dy.z) / h + orbit.angular_momentum);
    (*result).angular_momentum_drift = max((*result).angular_momentum_drift, axial);
}

// Whether the ray can only end in the hole. The function does not write the outcome: if it did,
// NVIDIA's compiler would slow the whole loop by 2 %.
fn is_captured(ray: Ray, hit_count: u32) -> bool {
    let u = ray.motion.base + ray.y.x;
    let u_horizon = scene.hole.horizon_u;
    let u_inner = select(0.0, 1.0 / scene.disk.inner, HAS_DISK);
    let nothing_more_to_hit = u >= u_inner || hit_count == MAX_HITS;
    return ray.dy.x > 0.0 && (u >= u_horizon || nothing_more_to_hit && cannot_turn(ray.motion, ray.y.x, u_horizon - u));
}

// Whether another crossing of the annulus can follow.
fn may_hit(ray: Ray, hit_count: u32) -> bool {
    let beyond = ray.dy.x < 0.0 && (ray.motion.base + ray.y.x) * scene.disk.outer < 1.0;
    return HAS_DISK && hit_count < MAX_HITS && !beyond;
}

// Adds the step's crossing of the annulus to the record, for a photon of this `energy`, not scaled.
// n_z'' vanishes in the plane, so Newton's method converges at once.
fn record_plane_crossing(
    result: ptr<function, Trace>,
    ray: Ray,
    step: Step,
    end: StepEnd,
    orbit: KerrRay,
    h: f32,
    energy: f32,
) {
    let path = curve(step);
    var t = end.share * ray.y.y / (ray.y.y - end.y.y);
    for (var i = 0u; i < 2u; i++) {
        t = clamp(t - curve_at(path, t).y / curve_slope(path, t).y, 0.0, end.share);
    }
    let crossing = curve_at(path, t);
    let r = 1.0 / (ray.motion.base + crossing.x);
    if !in_annulus(r) {
        return;
    }
    var place = crossing.zw * inverseSqrt(max(dot(crossing.zw, crossing.zw), TINY));
    // Pictures do not need the azimuth of a hit.
    if SPINNING && AZIMUTH {
        var gain = azimuth_gain(ray.motion, path, h, t, crossing.x, end.regular, ray.ingoing);
        if ray.ingoing {
            gain += azimuth_lag_to_infinity(ray.motion, crossing.x);
        }
        place = rotate_z(place, sin_cos_precise(wrap_angle(add_angle(ray.chi, gain))));
    }
    if DIAGNOSTICS && (*result).hit_count == 0u {
        (*result).turn = ray.turn + angle_between(ray.y.yzw, crossing.yzw);
    }
    let delay = ray.delay + crossing_delay(ray.motion, step, h, t, crossing.x);
    add_hit(result, vec3<f32>(r * place, 0.0), energy, orbit.lambda, delay);
}

fn trace(photon: Photon) -> Trace {
    var result = empty_trace();
    let orbit = kerr_ray(photon);
    if camera_is_inside() && orbit.constants.horizon_w <= 0.0 {
        // The light comes through the horizon's other branch, and nothing from outside does.
        result.outcome = OUTCOME_CAPTURED;
        return result;
    }
    let h = step_of(orbit);
    var ray = ray_at_camera(photon, orbit, h);
    for (var i = 0u; i < MAX_STEPS; i++) {
        change_base(&ray, orbit.constants);
        if DIAGNOSTICS {
            record_residuals(&result, ray, orbit, h);
        }
        if is_captured(ray, result.hit_count) {
            result.outcome = OUTCOME_CAPTURED;
            break;
        }
        if !FOLLOW_BEYOND_HITS && result.hit_count == MAX_HITS {
            result.outcome = OUTCOME_HIDDEN;
            break;
        }
        restore_radial_speed(&ray, h);
        let step = nystroem_step(ray.motion, h * h, ray.y, ray.dy, ray.k);
        let end = end_of(step, ray.motion);
        result.steps += 1u;

        if NEAR_HORIZON && ray.ingoing && !(end.regular && ray.dy.x < 0.0) {
            ray.ingoing = false;
            ray.chi = add_angle(ray.chi, azimuth_lag_to_infinity(ray.motion, ray.y.x));
        }
        if HAS_DISK && crosses_plane(ray.y.y, end.y.y) && result.hit_count < MAX_HITS {
            record_plane_crossing(&result, ray, step, end, orbit, h, photon.energy);
        }
        if DELAY && may_hit(ray, result.hit_count) {
            ray.delay += step_delay(ray.motion, step, h);
        }
        // A picture of a smooth disk without a sky needs no azimuth at all.
        if SPINNING && (SKY_DIRECTION || AZIMUTH) {
            let gain = azimuth_gain(ray.motion, curve(step), h, end.share, end.y.x, end.regular, ray.ingoing);
            ray.chi = add_angle(ray.chi, gain);
        }
        if DIAGNOSTICS {
            ray.turn += angle_between(ray.y.yzw, end.y.yzw);
        }
        if end.escapes {
            record_escape(&result, ray, end, orbit.constants.energy);
            break;
        }
        ray.y = end.y;
        ray.dy = step.dy1;
        ray.k = step.k1;
    }
    return result;
}
