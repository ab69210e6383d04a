// The method kerr-schild: Kerr's null geodesics by Runge-Kutta in ingoing Kerr-Schild Cartesian
// coordinates. It is the article's integrator, and a baseline for the other methods.
//
// The metric is eta + f l l (Kerr 1963; Misner, Thorne & Wheeler 1973 box 33.2), with r the
// Boyer-Lindquist radius and
//
//   f = r^3 / (r^4 + a^2 z^2),   l = (1, (r x + a y)/(r^2 + a^2), (r y - a x)/(r^2 + a^2), z/r),
//   r^4 - (x^2 + y^2 + z^2 - a^2) r^2 - a^2 z^2 = 0.
//
// The backward ray has the momentum p with p_t = +1 and, with S = l.p - 1, the Hamiltonian
// (p^2 - 1 - f S^2)/2 = 0:
//
//   x' = p - f S l,   p' = S^2 grad(f)/2 + f S grad(l.p).
//
// p_t and x p_y - y p_x are conserved. These coordinates are singular at the past horizon, from
// which rays come that end in the hole: momenta grow without bound and steps shrink, so many such
// rays around fast-spinning holes stay unfinished.
//
// Gives: trace.

// At this multiple of the horizon's radius an ingoing ray counts as captured.
const CAPTURE_MARGIN: f32 = 1.015;
// The step rule: shares of the radius, the largest step in r_s, and a term that prevents division
// by zero.
const RADIUS_SHARE: f32 = 0.16;
const BENDING_SHARE: f32 = 0.12;
const IMPACT_REGULARIZER: f32 = 0.01;
const MAX_STEP: f32 = 12.0;
const MAX_STEP_SHARE: f32 = 0.15;
const DISPLACEMENT_SHARE: f32 = 0.10;
const HORIZON_SHARE: f32 = 0.12;
const MIN_HORIZON_DISTANCE: f32 = 0.002;
const MIN_INWARD_SPEED: f32 = 0.01;
// The step scale above which the last two shares do not grow.
const BALANCED: f32 = 0.85;

struct Canonical {
    x: vec3<f32>,
    p: vec3<f32>,
}

struct Metric {
    r: f32,
    gradient_r: vec3<f32>,
    f: f32,
    l: vec3<f32>,
}

// grad(r) follows from r's quartic: (x, y, z (r^2 + a^2)/r^2) r^3 / (r^4 + a^2 z^2).
fn metric_at(x: vec3<f32>) -> Metric {
    let a = scene.hole.a;
    let a2 = a * a;
    let excess = dot(x, x) - a2;
    let r2 = max(0.5 * (excess + sqrt(excess * excess + 4.0 * a2 * x.z * x.z)), TINY);
    let r = sqrt(r2);
    let wide = r2 + a2;
    let f = r * r2 / (r2 * r2 + a2 * x.z * x.z);
    let l = vec3<f32>((r * x.x + a * x.y) / wide, (r * x.y - a * x.x) / wide, x.z / r);
    return Metric(r, f * vec3<f32>(x.xy, x.z * wide / r2), f, l);
}

fn velocity(metric: Metric, p: vec3<f32>) -> vec3<f32> {
    return p - metric.f * (dot(metric.l, p) - 1.0) * metric.l;
}

// The derivatives of x and p, with
//
//   grad(f) = f (3 grad(r)/r - (4 r^3 grad(r) + 2 a^2 z e_z)/(r^4 + a^2 z^2)).
fn derivatives(state: Canonical) -> Canonical {
    let x = state.x;
    let p = state.p;
    let a = scene.hole.a;
    let metric = metric_at(x);
    let r = metric.r;
    let wide = r * r + a * a;
    let s = dot(metric.l, p) - 1.0;
    let over = metric.f / (r * r * r);
    let gradient_f = metric.f * ((3.0 / r - 4.0 * r * r * r * over) * metric.gradient_r
        - vec3<f32>(0.0, 0.0, 2.0 * a * a * x.z * over));
    let along_r = (dot(x.xy, p.xy) - 2.0 * r * dot(metric.l.xy, p.xy)) / wide - x.z * p.z / (r * r);
    let gradient_l = along_r * metric.gradient_r
        + vec3<f32>((r * p.x - a * p.y) / wide, (r * p.y + a * p.x) / wide, p.z / r);
    return Canonical(p - metric.f * s * metric.l, 0.5 * s * s * gradient_f + metric.f * s * gradient_l);
}

fn advance(state: Canonical, rate: Canonical, h: f32) -> Canonical {
    return Canonical(state.x + h * rate.x, state.p + h * rate.p);
}

// Classical Runge-Kutta.
fn runge_kutta_step(state: Canonical, h: f32) -> Canonical {
    let k1 = derivatives(state);
    let k2 = derivatives(advance(state, k1, 0.5 * h));
    let k3 = derivatives(advance(state, k2, 0.5 * h));
    let k4 = derivatives(advance(state, k3, h));
    let mean = Canonical((k1.x + 2.0 * (k2.x + k3.x) + k4.x) / 6.0, (k1.p + 2.0 * (k2.p + k3.p) + k4.p) / 6.0);
    return advance(state, mean, h);
}

// The step rule: shorter where light bends and on the way to the horizon, and never a large share
// of the radius. Below the balanced setting the limits shrink, the horizon's more for fast-spinning
// holes.
fn step_length(metric: Metric, x: vec3<f32>, v: vec3<f32>) -> f32 {
    let r = metric.r;
    let impact = length(cross(x, v));
    let wanted = scene.quality.step_scale * min(RADIUS_SHARE * r, BENDING_SHARE * r * r / (impact + IMPACT_REGULARIZER));
    let allowed = clamp(wanted, scene.quality.min_step, max(MAX_STEP, MAX_STEP_SHARE * r));
    let refinement = min(1.0, scene.quality.step_scale / BALANCED);
    var h = min(allowed, DISPLACEMENT_SHARE * refinement * r / max(length(v), 1.0));
    let inward_speed = -dot(metric.gradient_r, v);
    if inward_speed > 0.0 {
        // sqrt(1 - chi^2), from r_+ - r_-.
        let slowness = select(1.0, max(0.5, scene.hole.horizon - scene.hole.inner_horizon), refinement < 1.0);
        let distance = max(r - scene.hole.horizon, MIN_HORIZON_DISTANCE);
        h = min(h, HORIZON_SHARE * refinement * slowness * distance / max(inward_speed, MIN_INWARD_SPEED));
    }
    return h;
}

// The backward momentum of the photon that meets the camera at n, whose azimuth is
// Boyer-Lindquist's. In ingoing coordinates p_theta and p_phi are the same and
//
//   p_r = (Sigma p^r + P)/Delta - E,   P = E (r^2 + a^2) - a L,
//
// which for ingoing light is K'/(P - Sigma p^r) - E, since P^2 - (Sigma p^r)^2 = Delta K'. With x =
// r n + a e_z x n, p.n = p_r, and the tangential part solves
// p - (a n_z/r) n x p = w + (a/r) p_r e_z x n. Derived.
fn backward_momentum(photon: Photon, n: vec3<f32>) -> vec3<f32> {
    let r = scene.observer.r;
    let a = scene.hole.a;
    let energy = photon_energy(photon);
    let angular_momentum = photon_angular_momentum(photon);
    let across = vec3<f32>(-n.y, n.x, 0.0);
    let outward = r * r * photon.radial;
    let power = energy * (r * r + a * a) - a * angular_momentum;
    let dragged = r * photon.w - a * energy * across;
    let delta = (r - scene.hole.horizon) * (r - scene.hole.inner_horizon);
    var radial = (power + outward) / delta;
    if outward < 0.0 {
        radial = dot(dragged, dragged) / (power - outward);
    }
    radial -= energy;
    let twisted = photon.w + (a * radial / r) * across;
    let tilt = a * n.z / r;
    return -(radial * n + (twisted + tilt * cross(n, twisted)) / (1.0 + tilt * tilt)) / energy;
}

// The violation of the null condition, relative to its larger side.
fn null_residual(metric: Metric, p: vec3<f32>) -> f32 {
    let s = dot(metric.l, p) - 1.0;
    return abs(dot(p, p) - 1.0 - metric.f * s * s) / max(dot(p, p), 1.0);
}

fn axial_angular_momentum(state: Canonical) -> f32 {
    return state.x.x * state.p.y - state.x.y * state.p.x;
}

// The place r n of a point in the plane, with the Boyer-Lindquist azimuth of the camera's frame.
fn boyer_lindquist(x: vec3<f32>) -> vec3<f32> {
    let a = scene.hole.a;
    let r = metric_at(x).r;
    let n = vec2<f32>(r * x.x + a * x.y, r * x.y - a * x.x) / (r * r + a * a);
    let lead = a / (scene.hole.horizon - scene.hole.inner_horizon) * log((r - scene.hole.horizon) / (r - scene.hole.inner_horizon));
    return vec3<f32>(r * rotate_z(n, sin_cos_precise(scene.observer.ingoing_azimuth_lead - lead)), 0.0);
}

// dT/dlambda of Kerr-Schild's time T, which is Kerr's ingoing time less r.
fn delay_rate(metric: Metric, p: vec3<f32>) -> f32 {
    return 1.0 - metric.f * (dot(metric.l, p) - 1.0);
}

// The delay of a crossing at the radius r, from Kerr-Schild's time to Boyer-Lindquist's.
fn hit_delay(kerr_schild_delay: f32, r: f32) -> f32 {
    let factors = 1.0 - vec2<f32>(scene.hole.horizon, scene.hole.inner_horizon) / r;
    let lead = tortoise(1.0 / r, factors) - r;
    return kerr_schild_delay + scene.observer.r - 2.0 * scene.observer.time_lead + lead;
}

fn trace(photon: Photon) -> Trace {
    var result = empty_trace();
    let n = scene.observer.position_direction;
    let start = scene.observer.r * n + scene.hole.a * vec3<f32>(-n.y, n.x, 0.0);
    var state = Canonical(start, backward_momentum(photon, n));
    let axial = axial_angular_momentum(state);
    let max_steps = min(scene.quality.max_steps, MAX_STEP_BUDGET);
    var affine = 0.0;
    var turn = 0.0;
    var delay = 0.0;
    var captured = false;
    var escaped = false;
    var v = vec3<f32>(0.0);

    for (var i = 0u; i <= MAX_STEP_BUDGET; i++) {
        let metric = metric_at(state.x);
        v = velocity(metric, state.p);
        if DIAGNOSTICS {
            let drift = abs(axial_angular_momentum(state) - axial) / max(abs(axial), 1.0);
            result.residual = max(result.residual, null_residual(metric, state.p));
            result.angular_momentum_drift = max(result.angular_momentum_drift, drift);
        }
        let outward = dot(state.x, v) > 0.0;
        captured = metric.r <= CAPTURE_MARGIN * scene.hole.horizon && !outward;
        escaped = metric.r >= scene.quality.escape_radius && outward;
        let enough = !FOLLOW_BEYOND_HITS && result.hit_count == MAX_HITS;
        if captured || escaped || enough || i >= max_steps || affine >= scene.quality.max_affine {
            break;
        }
        let h = step_length(metric, state.x, v);
        let next = runge_kutta_step(state, h);
        // Overflowed momenta are meaningless.
        if !(is_below(dot(next.x, next.x), 1e20) && is_below(dot(next.p, next.p), 1e20)) {
            break;
        }
        let crosses = crosses_plane(state.x.z, next.x.z) && result.hit_count < MAX_HITS;
        // Drivers that execute both sides of a branch still skip a loop without a turn.
        let events = select(0u, 1u, crosses);
        for (var j = 0u; j < events; j++) {
            let next_v = velocity(metric_at(next.x), next.p);
            let segment = Segment(state.x, v, next.x, next_v, h, 0.0, vec2<f32>(0.0));
            let crossing = plane_crossing(segment, crosses);
            // The cubic gives the share of the step, a shorter step the place and L_z.
            if !near_annulus(metric_at(crossing.xyz).r) {
                break;
            }
            let event_h = crossing.w * h;
            let event = runge_kutta_step(state, event_h);
            let hit = boyer_lindquist(event.x);
            if in_annulus(length(hit)) {
                if DIAGNOSTICS && result.hit_count == 0u {
                    result.turn = turn + angle_between(state.x, event.x);
                }
                var event_delay = 0.0;
                if DELAY {
                    let rates = delay_rate(metric, state.p) + delay_rate(metric_at(event.x), event.p);
                    event_delay = hit_delay(delay + 0.5 * event_h * rates, length(hit));
                }
                // The backward ray's L_z is -L/E.
                add_hit(&result, hit, photon_energy(photon), -axial_angular_momentum(event), event_delay);
            }
        }
        if DIAGNOSTICS {
            turn += angle_between(state.x, next.x);
        }
        if DELAY {
            let rates = vec2<f32>(delay_rate(metric, state.p), delay_rate(metric_at(next.x), next.p));
            delay += 0.5 * h * (rates.x + rates.y);
        }
        result.steps += 1u;
        affine += h;
        state = next;
    }
    if captured {
        result.outcome = OUTCOME_CAPTURED;
    } else if escaped {
        result.outcome = OUTCOME_SKY;
        if DIAGNOSTICS && result.hit_count == 0u {
            result.turn = turn + angle_between(state.x, v);
        }
        result.sky = safe_normalize(vec3<f32>(rotate_z(v.xy, sin_cos_precise(scene.observer.ingoing_azimuth_lead)), v.z));
    } else if !FOLLOW_BEYOND_HITS && result.hit_count == MAX_HITS {
        result.outcome = OUTCOME_HIDDEN;
    }
    return result;
}
