// The ray of the method mino and its steps: where it begins, which base its radial variable has, and
// where a step ends. mino_motion.wgsl has the equations.
//
// Gives: MAX_STEPS, Ray, StepEnd, change_base, end_of, ray_at_camera, record_escape,
//     restore_radial_speed, step_of.

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

// Records a ray that has reached u = 0. Light of negative energy does not come from infinity.
fn record_escape(result: ptr<function, Trace>, ray: Ray, end: StepEnd, energy: f32) {
    let from_sky = energy > 0.0;
    (*result).outcome = select(OUTCOME_CAPTURED, OUTCOME_SKY, from_sky);
    let across = select(end.y.zw, rotate_z(end.y.zw, sin_cos_precise(wrap_angle(ray.chi))), SPINNING);
    (*result).turn = select((*result).turn, ray.turn, from_sky && (*result).hit_count == 0u);
    (*result).sky = select(vec3<f32>(0.0), safe_normalize(vec3<f32>(across, end.y.y)), from_sky);
}
