// The method closed: Schwarzschild's null geodesics in closed form, without steps and residuals.
// schwarzschild.wgsl has the orbits; this file finds the hits and the outcome.
//
// Gives: trace.

// Rays with a smaller |D| get this one; they are within 1e-7 of the shadow's radius of the critical
// curve.
const MIN_DISCRIMINANT: f32 = 1e-14;
// Below this, near D = -1 where light is hardly bent, D is computed from b.
const WEAK_DISCRIMINANT: f32 = -0.6;
// Rays with a smaller impact parameter, in r_s, get this one.
const MIN_IMPACT: f32 = 1e-8;
// A ray with D > 0 crosses the disk's range of radii, at most from u = 0 to 1/3, within the angle
// DISK_ANGLE b: there u^2 (1 - u) <= 2/27 <= q/2, so that phi <= (1/3) sqrt(2/q) = (sqrt(2)/3) b.
const DISK_ANGLE: f32 = 0.471404521;

// A crossing of the disk's plane.
struct Crossing {
    u: f32,
    // Angle from the camera.
    angle: f32,
    direction: vec3<f32>,
    // Whether it is known to lie after the turning point.
    on_way_out: bool,
}

fn add_crossing(result: ptr<function, Trace>, orbit: Orbit, crossing: Crossing, energy: f32, lambda: f32) {
    let u = crossing.u;
    if u * scene.disk.outer > 1.0 && u * scene.disk.inner < 1.0 {
        let delay = crossing_delay(orbit, crossing.angle, u, crossing.on_way_out);
        add_hit(result, crossing.direction / u, energy, lambda, delay);
    }
}

// Direction of the line in which the orbit's plane intersects the disk's, on the side of the first
// crossing. Without AZIMUTH any direction serves.
fn crossing_direction(n: vec3<f32>, tangent: vec3<f32>, side: f32) -> vec3<f32> {
    if !AZIMUTH {
        return vec3<f32>(1.0, 0.0, 0.0);
    }
    // Divided by the larger component first, because the square of a small tilt may underflow.
    let tilt = vec2<f32>(n.z, tangent.z) / max(max(abs(n.z), abs(tangent.z)), TINY);
    return (side * inverseSqrt(max(dot(tilt, tilt), TINY))) * (vec3<f32>(-tilt.y * n.xy + tilt.x * tangent.xy, 0.0));
}

fn trace(photon: Photon) -> Trace {
    var result = empty_trace();
    let n = scene.observer.position_direction;
    let energy = photon_energy(photon);
    let w = photon.w - dot(photon.w, n) * n;
    let w2 = max(dot(w, w), square(MIN_IMPACT * energy * scene.observer.u));
    let inverse_w = inverseSqrt(w2);
    // The orbit's plane is spanned by n and the tangential direction of the backward ray.
    let tangent = -inverse_w * w;
    let scale = scene.observer.u * inverse_w;
    let inverse_b = energy * scale;
    // (radial - c E) (radial + c E) = (1 - u) |w|^2 D is accurate next to the critical curve; where
    // light is hardly bent, D must agree with b.
    let other_margin = photon.shadow_margin + scene.shadow.twice_critical_radial * energy;
    let critical = photon.shadow_margin * other_margin * scene.shadow.inverse_lapse_squared * inverse_w * inverse_w;
    let d = select(6.75 * inverse_b * inverse_b - 1.0, critical, critical > WEAK_DISCRIMINANT);
    let turns = d < 0.0;
    let discriminant = select(max(d, MIN_DISCRIMINANT), min(d, -MIN_DISCRIMINANT), turns);
    let orbit = Orbit(scene.observer.u, photon.radial * scale, inverse_b, inverse_b * inverse_b, discriminant);

    // A ray that turns stays on its side of the photon sphere.
    let inward = orbit.slope > 0.0;
    let escapes = select(!inward, scene.observer.r > 1.5, turns);
    result.outcome = select(OUTCOME_CAPTURED, OUTCOME_SKY, escapes);

    // The ray crosses the disk's plane at the angles crossing_angle + m pi, crossing_angle in
    // (0, pi]; a ray in the plane does not cross it.
    let side = select(select(-1.0, 1.0, tangent.z > 0.0), sign(n.z), n.z != 0.0);
    let crossing_angle = select(atan2_precise(abs(n.z), -side * tangent.z), PI, n.z == 0.0);
    let coplanar = n.z == 0.0 && tangent.z == 0.0;
    // Inside the disk's inner edge, only the way out can cross the disk.
    let outside_inner_edge = scene.observer.u < 1.0 / 3.0;
    let meets_first = !turns && inward && crossing_angle * inverse_b < DISK_ANGLE && outside_inner_edge;
    let may_hit = HAS_DISK && !coplanar && (escapes || meets_first);
    if !(escapes || may_hit) {
        return result;
    }
    var angle = crossing_angle;
    if escapes {
        angle = angle_to_infinity(orbit);
    }
    if may_hit {
        let across = crossing_direction(n, tangent, side);
        let lambda = photon_angular_momentum(photon) / energy;
        let g3 = orbit_g3(orbit);
        // The ray sweeps at most 2.1 rad from u = 0 to 1/3, or to an earlier turning point. So it
        // crosses the annulus at most at the first and at the last crossing of the plane.
        let last = floor((angle - crossing_angle) * (1.0 / PI));
        if last >= 0.0 && outside_inner_edge {
            let u = u_after(crossing_angle, orbit.u, orbit.slope, g3);
            add_crossing(&result, orbit, Crossing(u, crossing_angle, across, false), energy, lambda);
            result.turn = select(0.0, crossing_angle, result.hit_count == 1u);
        }
        if escapes && last >= select(0.0, 1.0, outside_inner_edge) && result.hit_count < MAX_HITS {
            let beyond = angle - crossing_angle - last * PI;
            let u = u_after(beyond, 0.0, inverse_b, g3);
            let first = result.hit_count == 0u;
            let there = select(across, -across, (i32(last) & 1) == 1);
            let there_angle = crossing_angle + last * PI;
            add_crossing(&result, orbit, Crossing(u, there_angle, there, true), energy, lambda);
            result.turn = select(result.turn, there_angle, first && result.hit_count == 1u);
        }
    }
    if escapes {
        result.turn = select(result.turn, angle, result.hit_count == 0u);
        if !FOLLOW_BEYOND_HITS && result.hit_count == MAX_HITS {
            result.outcome = OUTCOME_HIDDEN;
        } else if SKY_DIRECTION {
            let turn = sin_cos_precise(angle);
            result.sky = turn.y * n + turn.x * tangent;
        }
    }
    return result;
}
