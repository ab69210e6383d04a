// The method verlet: Schwarzschild's null geodesics by velocity Verlet in areal Cartesian
// coordinates, x = r n, v = dx/dlambda. It is the article's integrator for holes without spin.
//
//   d2x/dlambda2 = -(3/2) L^2 x / r^5,      v_r^2 + (1 - 1/r) L^2 / r^2 = 1,      L = x cross v
//
// The second equation is the null condition with |E| = 1 (Misner, Thorne & Wheeler 1973, section
// 25.6). Its derivative gives the radial part of the first: Cartesian coordinates include the
// centrifugal term L^2 / r^3. The affine parameter lambda grows backward along the ray.
//
// Gives: trace.

// At this radius an ingoing ray counts as captured: none turns inside the photon sphere, at 1.5.
const CAPTURE_RADIUS: f32 = 1.015;
// A bound of the loop.
const MAX_HALVINGS: u32 = 24u;
// The step rule: shares of the radius, the largest step in r_s, and a term for radial rays.
const RADIUS_SHARE: f32 = 0.16;
const BENDING_SHARE: f32 = 0.12;
const IMPACT_REGULARIZER: f32 = 0.01;
const MAX_STEP: f32 = 12.0;
const MAX_STEP_SHARE: f32 = 0.15;
const DISPLACEMENT_SHARE: f32 = 0.12;

// The factor of x in the acceleration, computed from 1/r: -(3/2) L^2 / r^5.
fn acceleration_factor(l2: f32, inverse_r: f32) -> f32 {
    let inverse_r2 = inverse_r * inverse_r;
    return -1.5 * l2 * inverse_r2 * inverse_r2 * inverse_r;
}

// The step rule: shorter where light bends, and never a large share of the radius.
fn step_length(r: f32, v: vec3<f32>, impact: f32) -> f32 {
    let wanted = scene.quality.step_scale * min(RADIUS_SHARE * r, BENDING_SHARE * r * r / (impact + IMPACT_REGULARIZER));
    let allowed = clamp(wanted, scene.quality.min_step, max(MAX_STEP, MAX_STEP_SHARE * r));
    return min(allowed, DISPLACEMENT_SHARE * r * inverseSqrt(max(dot(v, v), 1.0)));
}

// The violation of the null condition, relative to its larger side.
fn null_residual(x: vec3<f32>, v: vec3<f32>, l2: f32) -> f32 {
    let r2 = max(dot(x, x), TINY);
    let sum = square(dot(x, v)) / r2 + (1.0 - inverseSqrt(r2)) * l2 / r2;
    return abs(sum - 1.0) / max(sum, 1.0);
}

// A ray's constants: L, L^2 and |L|, per unit energy.
struct Impact {
    vector: vec3<f32>,
    l2: f32,
    length: f32,
}

// L is computed from w, because x cross v cancels for the small impact parameters of a far camera.
fn impact_of(photon: Photon, energy: f32) -> Impact {
    let vector = -scene.observer.r / energy * cross(scene.observer.position_direction, photon.w);
    let l2 = dot(vector, vector);
    return Impact(vector, l2, sqrt(l2));
}

// For an observer at rest, this is the article's mu e_r + (d - mu e_r) / sqrt(1 - 1/r). Its length
// sets the scale of the affine parameter, so it is not normalized.
fn initial_velocity(photon: Photon, energy: f32) -> vec3<f32> {
    return (-photon.radial * scene.observer.position_direction - photon.w) / energy;
}

// Keeps the largest residual of the null condition and the largest drift of L.
fn record_residuals(result: ptr<function, Trace>, x: vec3<f32>, v: vec3<f32>, impact: Impact) {
    let drift = length(cross(x, v) - impact.vector) / max(impact.length, 1e-3);
    (*result).residual = max((*result).residual, null_residual(x, v, impact.l2));
    (*result).angular_momentum_drift = max((*result).angular_momentum_drift, drift);
}

fn record_outcome(result: ptr<function, Trace>, v: vec3<f32>, captured: bool, escaped: bool) {
    if captured {
        (*result).outcome = OUTCOME_CAPTURED;
    } else if escaped {
        (*result).outcome = OUTCOME_SKY;
        (*result).sky = safe_normalize(v);
    } else if !FOLLOW_BEYOND_HITS && (*result).hit_count == MAX_HITS {
        (*result).outcome = OUTCOME_HIDDEN;
    }
}

fn trace(photon: Photon) -> Trace {
    var result = empty_trace();
    let energy = photon_energy(photon);
    let impact = impact_of(photon, energy);
    let max_steps = min(scene.quality.max_steps, MAX_STEP_BUDGET);
    var x = scene.observer.r * scene.observer.position_direction;
    var v = initial_velocity(photon, energy);
    var inverse_r = 1.0 / scene.observer.r;
    var affine = 0.0;
    var turn = 0.0;
    var delay = 0.0;
    var captured = false;
    var escaped = false;

    for (var i = 0u; i <= MAX_STEP_BUDGET; i++) {
        if DIAGNOSTICS {
            record_residuals(&result, x, v, impact);
        }
        let r = 1.0 / inverse_r;
        let outward = dot(x, v) >= 0.0;
        // A camera may stand within the capture radius; its outgoing rays can still escape.
        captured = r <= CAPTURE_RADIUS && !outward;
        escaped = r >= scene.quality.escape_radius && outward;
        let enough = !FOLLOW_BEYOND_HITS && result.hit_count == MAX_HITS;
        if captured || escaped || enough || i >= max_steps || affine >= scene.quality.max_affine {
            break;
        }

        // The step of velocity Verlet. It is inline, because a function with a loop of its own
        // makes NVIDIA's compiler slow the whole trace by 2 %.
        var h = step_length(r, v, impact.length);
        let factor = acceleration_factor(impact.l2, inverse_r);
        var next_x = x + h * (v + (0.5 * h * factor) * x);
        var next_r2 = dot(next_x, next_x);
        // The step ends outside the horizon, where the acceleration is defined.
        for (var halving = 0u; halving < MAX_HALVINGS && next_r2 <= 1.0; halving++) {
            h *= 0.5;
            next_x = x + h * (v + (0.5 * h * factor) * x);
            next_r2 = dot(next_x, next_x);
        }
        let next_inverse_r = inverseSqrt(max(next_r2, 0.25));
        let next_v = v + (0.5 * h) * (factor * x + acceleration_factor(impact.l2, next_inverse_r) * next_x);

        let unseen = result.hit_count == 0u;
        var rates = vec2<f32>(0.0);
        if DELAY {
            // dt/dlambda = 1/(1 - 1/r).
            rates = 1.0 / max(1.0 - vec2<f32>(inverse_r, next_inverse_r), vec2<f32>(TINY));
        }
        let segment = Segment(x, v, next_x, next_v, h, delay, rates);
        record_crossing(&result, segment);
        if DIAGNOSTICS && unseen {
            turn += angle_between(x, select(next_x, result.hits[0].position, result.hit_count == 1u));
        }
        result.steps += 1u;
        affine += h;
        delay = segment_delay(segment, 1.0);
        x = next_x;
        v = next_v;
        inverse_r = next_inverse_r;
    }
    shift_hits(&result, energy, -impact.vector.z);
    if DIAGNOSTICS {
        let at_infinity = escaped && result.hit_count == 0u;
        turn += select(0.0, angle_between(x, v), at_infinity);
        result.turn = select(0.0, turn, at_infinity || result.hit_count > 0u);
    }
    record_outcome(&result, v, captured, escaped);
    return result;
}
