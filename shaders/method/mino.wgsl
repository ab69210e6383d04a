// The method mino: Kerr's null geodesics for any spin, by steps in Mino time on the celestial
// sphere. mino_motion.wgsl has the equations and the step, mino_azimuth.wgsl the azimuth.
//
// Gives: trace.

// More than a ray within f32's rounding of the critical curve takes at the shortest step.
const MAX_STEPS: u32 = 1024u;
// Rays with sqrt(K)/E below this may come near the critical curve, on which it is at most 3.5, and
// take shorter steps.
const FAR_IMPACT: f32 = 4.0;
// Where U is below this share of W^2, a turning point is near and U is not a precise measure of u'.
const TURNING_SHARE: f32 = 0.0625;

// The state of a ray.
struct Ray {
    motion: Motion,
    // (v, n_z, n_x, n_y), its slope times the step, and its acceleration times the step squared.
    y: vec4<f32>,
    dy: vec4<f32>,
    k: vec4<f32>,
    // The azimuth's chi: that of Kerr's ingoing azimuth while `ingoing`.
    chi: Angle,
    ingoing: bool,
    // Angle swept about the hole.
    turn: f32,
    // Delay, without the tortoise coordinate of the leg that has not ended.
    delay: f32,
}

// The end of a step: at u = 0 if the ray escapes, otherwise after the whole step.
struct StepEnd {
    y: vec4<f32>,
    share: f32,
    escapes: bool,
    // Whether r does not turn within the step, next to the horizon.
    regular: bool,
}

// The step in Mino time.
fn step_of(orbit: KerrRay) -> f32 {
    let c = orbit.constants;
    let far = orbit.k > square(FAR_IMPACT * c.energy);
    let h = select(scene.quality.mino_critical_step, scene.quality.mino_step, far);
    if !camera_is_inside() {
        return h;
    }
    // Deep inside, u grows by its own value in less than a radian, by the growing terms of U. The
    // step is a share of that time.
    let u = scene.observer.u;
    return h * inverseSqrt(max(1.0, u * (6.0 * c.k_prime + 8.0 * u * (square(c.drag) + square(scene.hole.a) * c.k_prime))));
}

fn ray_at_camera(photon: Photon, orbit: KerrRay, h: f32) -> Ray {
    let n = scene.observer.position_direction;
    let near = begins_near_horizon();
    let motion = motion_about(select(0.0, scene.hole.horizon_u, near), orbit.constants);
    let y = vec4<f32>(select(scene.observer.u, -scene.observer.u_to_horizon, near), n.z, n.xy);
    let dy = h * vec4<f32>(orbit.scale * photon.radial, -orbit.w.z, -orbit.w.xy);
    let k = h * h * acceleration(motion, y);
    // Kerr's ingoing azimuth has no pole along infalling light.
    let ingoing = NEAR_HORIZON && photon.radial < 0.0;
    let chi = select(0.0, scene.observer.ingoing_azimuth_lead, ingoing);
    return Ray(motion, y, dy, k, Angle(0.0, chi), ingoing, 0.0, first_delay(photon.radial > 0.0));
}

// Changes the base of the radial variable when the ray approaches the horizon or leaves it.
fn change_base(ray: ptr<function, Ray>, constants: PhotonConstants) {
    let u_horizon = scene.hole.horizon_u;
    let base = (*ray).motion.base;
    let v = (*ray).y.x;
    let nearer = SPINNING && base == 0.0 && v > 0.5 * u_horizon;
    if nearer || (SPINNING || NEAR_HORIZON) && base > 0.0 && v < -0.5 * u_horizon {
        let low = scene.hole.horizon_u_low;
        (*ray).y.x = select((v + low) + u_horizon, (v - u_horizon) - low, nearer);
        (*ray).motion = motion_about(select(0.0, u_horizon, nearer), constants);
    }
}

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

// Recomputes u' from U, with its sign, where the base is the horizon and no turning point is near.
fn restore_radial_speed(ray: ptr<function, Ray>, h: f32) {
    if (SPINNING || NEAR_HORIZON) && (*ray).motion.base > 0.0 {
        let v = (*ray).y.x;
        let w2 = square(quadratic((*ray).motion.w, v));
        let u2 = speed_squared((*ray).motion, v, w2);
        if u2 > TURNING_SHARE * w2 {
            (*ray).dy.x = select(-h, h, (*ray).dy.x > 0.0) * sqrt(u2);
        }
    }
}

// The end of a step. An outgoing ray may reach u = 0 within it, where u'' vanishes and Newton's
// method converges at once.
fn end_of(step: Step, motion: Motion) -> StepEnd {
    let escapes = step.dy0.x < 0.0 && motion.base + step.y1.x <= 0.0;
    var end = StepEnd(step.y1, 1.0, escapes, NEAR_HORIZON && step.dy0.x * step.dy1.x > 0.0);
    if escapes {
        let path = curve(step);
        var share = (motion.base + step.y0.x) / (step.y0.x - step.y1.x);
        for (var i = 0u; i < 3u; i++) {
            share = clamp(share - (motion.base + curve_at(path, share).x) / curve_slope(path, share).x, 0.0, 1.0);
        }
        end.share = share;
        end.y = curve_at(path, share);
    }
    return end;
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

// Records a ray that has reached u = 0. Light of negative energy does not come from infinity.
fn record_escape(result: ptr<function, Trace>, ray: Ray, end: StepEnd, energy: f32) {
    let from_sky = energy > 0.0;
    (*result).outcome = select(OUTCOME_CAPTURED, OUTCOME_SKY, from_sky);
    let across = select(end.y.zw, rotate_z(end.y.zw, sin_cos_precise(wrap_angle(ray.chi))), SPINNING);
    (*result).turn = select((*result).turn, ray.turn, from_sky && (*result).hit_count == 0u);
    (*result).sky = select(vec3<f32>(0.0), safe_normalize(vec3<f32>(across, end.y.y)), from_sky);
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
