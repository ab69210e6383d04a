// Schwarzschild's null geodesics by velocity Verlet in areal Cartesian coordinates: x = r n, v = dx/dlambda.
//
//   d2x/dlambda2 = -(3/2) L^2 x / r^5,      v_r^2 + (1 - 1/r) L^2 / r^2 = 1,      L = x cross v
//
// The second equation is the null condition with |E| = 1 (Misner, Thorne & Wheeler 1973 eq. 25.55); the first follows by
// differentiation, the centrifugal term being the part of a Cartesian acceleration that moves no photon.
// The affine parameter lambda grows backward along the ray.

// At this radius an ingoing ray counts as captured: no ray turns outward within the photon sphere, at 1.5.
const CAPTURE_RADIUS: f32 = 1.015;
// Loop bounds that hold whatever the uniform says.
const MOST_STEPS: u32 = 768u;
const MOST_HALVINGS: u32 = 24u;
// Steps: shares of the radius, range in r_s, and what keeps the rule from dividing by zero for radial rays.
const RADIUS_SHARE: f32 = 0.16;
const BENDING_SHARE: f32 = 0.12;
const IMPACT_REGULARIZER: f32 = 0.01;
const SHORTEST_STEP: f32 = 0.018;
const LONGEST_STEP: f32 = 12.0;
const LONGEST_STEP_SHARE: f32 = 0.15;
const DISPLACEMENT_SHARE: f32 = 0.12;

fn acceleration(x: vec3<f32>, l2: f32) -> vec3<f32> {
    let inverse_r2 = 1.0 / max(dot(x, x), 0.25);
    return (-1.5 * l2 * inverse_r2 * inverse_r2 * sqrt(inverse_r2)) * x;
}

// The step rule: shorter where light bends, and never a large share of the radius.
fn step_length(r: f32, speed: f32, impact: f32) -> f32 {
    let wanted = scene.step_scale * min(RADIUS_SHARE * r, BENDING_SHARE * r * r / (impact + IMPACT_REGULARIZER));
    let allowed = clamp(wanted, SHORTEST_STEP, max(LONGEST_STEP, LONGEST_STEP_SHARE * r));
    return min(allowed, DISPLACEMENT_SHARE * r / max(speed, 1.0));
}

// By how much the null condition is violated, as a share of its larger side.
fn null_residual(x: vec3<f32>, v: vec3<f32>, l2: f32) -> f32 {
    let r2 = max(dot(x, x), TINY);
    let sum = square(dot(x, v)) / r2 + (1.0 - inverseSqrt(r2)) * l2 / r2;
    return abs(sum - 1.0) / max(sum, 1.0);
}

fn trace(photon: Photon) -> Trace {
    var result = untraced();
    let energy = photon_energy(photon);
    // For an observer at rest this is the article's mu e_r + (d - mu e_r) / sqrt(1 - 1/r): radial = -mu sqrt(1 - 1/r),
    // w = -(d - mu e_r), E = sqrt(1 - 1/r). Not normalized: its length carries the affine parameter's scale.
    var x = scene.camera_radius * scene.camera_direction;
    var v = (-photon.radial * scene.camera_direction - photon.w) / energy;
    // From w, not from x cross v, which would lose the small impact parameters of a far camera.
    let impact_vector = -scene.camera_radius / energy * cross(scene.camera_direction, photon.w);
    let l2 = dot(impact_vector, impact_vector);
    let impact = sqrt(l2);
    let lambda = -impact_vector.z;
    var a = acceleration(x, l2);
    var affine = 0.0;
    let max_steps = min(scene.max_steps, MOST_STEPS);

    for (var i = 0u; i <= MOST_STEPS; i++) {
        let r = length(x);
        let outward = dot(x, v) >= 0.0;
        if DIAGNOSTICS {
            let drift = length(cross(x, v) - impact_vector) / max(impact, 1e-3);
            result.residual = max(result.residual, null_residual(x, v, l2));
            result.angular_momentum_drift = max(result.angular_momentum_drift, drift);
        }
        // A camera may stand within the capture radius: its outgoing rays still have their chance.
        if r <= CAPTURE_RADIUS && !outward {
            result.outcome = OUTCOME_CAPTURED;
            break;
        }
        if r >= scene.escape_radius && outward {
            result.outcome = OUTCOME_SKY;
            result.sky = safe_normalize(v);
            break;
        }
        if i >= max_steps || affine >= scene.max_affine {
            break;
        }
        var h = step_length(r, length(v), impact);
        var next_x = x + h * v + (0.5 * h * h) * a;
        // The trial endpoint stays outside the horizon, where the acceleration has a meaning.
        for (var halving = 0u; halving < MOST_HALVINGS; halving++) {
            if dot(next_x, next_x) > 1.0 {
                break;
            }
            h *= 0.5;
            next_x = x + h * v + (0.5 * h * h) * a;
        }
        let next_a = acceleration(next_x, l2);
        let next_v = v + (0.5 * h) * (a + next_a);
        result.steps += 1u;
        affine += h;
        record_crossing(&result, Segment(x, v, next_x, next_v, h), energy, lambda);
        if !FOLLOW_BEYOND_HITS && result.hit_count == 2u {
            result.outcome = OUTCOME_HIDDEN;
            break;
        }
        x = next_x;
        v = next_v;
        a = next_a;
    }
    return result;
}
