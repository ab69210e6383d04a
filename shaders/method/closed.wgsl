// The method closed: Schwarzschild's null geodesics in closed form, without steps, without a limit
// to them, and without a radius that stands for infinity. The twin in f64 is
// crates/lightfall-core/src/geometry/schwarzschild.rs.
//
// In its plane an orbit obeys, with u = 1/r and phi the angle from the camera (Darwin 1959; r_s =
// 1),
//
//   (du/dphi)^2 = f(u) = q - u^2 + u^3,   q = 1/b^2,
//
// and everything depends on D = b_c^2 q - 1, b_c^2 = 27/4: where D > 0 the ray goes through, where
// D < 0 it turns. For every D the cubic has one root -k < 0, k^2 (1 + k) = q; the others are
// (1 + k)/2 +- sqrt(v)/2 with
//
//   v = (1 + k)(1 - 3 k) = -4 D (1 + k) / (2 + 3 k)^2,
//
// a conjugate pair where D > 0. Computed from D, v keeps its digits next to the critical curve.
// Derived. There are no steps, and no constraint can drift: the record's steps and residuals are 0.
//
// Needs: AZIMUTH, FOLLOW_BEYOND_HITS, HAS_DISK, MAX_HITS, OUTCOME_CAPTURED, OUTCOME_HIDDEN,
//     OUTCOME_SKY, PI, Photon, SKY_DIRECTION, TINY, Trace, add_hit, atan2_precise, carlson_rf_pair,
//     empty_trace, photon_angular_momentum, photon_energy, scene, sin_cos_precise, square,
//     weierstrass.
// Gives: trace.

// Rays with a smaller |D| are treated alike; they are at most 1e-7 of the shadow's radius from the
// critical curve.
const MIN_DISCRIMINANT: f32 = 1e-14;
// Below this, near D = -1 where light is hardly bent, D is computed from b.
const WEAK_DISCRIMINANT: f32 = -0.6;
// Rays with a smaller impact parameter, in r_s, get this one; they are bent by even less.
const MIN_IMPACT: f32 = 1e-8;
// A ray with D > 0 passes the disk's range of radii, at most from u = 0 to 1/3, within the angle
// DISK_ANGLE b: there u^2 (1 - u) <= 2/27 <= q/2, so that phi <= (1/3) sqrt(2/q) = (sqrt(2)/3) b.
const DISK_ANGLE: f32 = 0.471404521;

struct Orbit {
    // u and du/dphi at the camera, with phi along the backward ray.
    u: f32,
    slope: f32,
    // 1/b, 1/b^2, b_c^2/b^2 - 1.
    inverse_b: f32,
    q: f32,
    discriminant: f32,
}

// k. A first guess within 4e-4 (minimax polynomials in 1/b and in its power -2/3), then one step of
// Newton's method.
fn orbit_root(inverse_b: f32, q: f32) -> f32 {
    let x = inverse_b;
    var k = x * (0.99991836 + x * (-0.49241213 + x * (0.50929576 - x * 0.34869361)));
    if inverse_b >= 0.385 {
        let s = exp2(log2(inverse_b) * (-2.0 / 3.0));
        k = q * s * s * (0.99962648 + s * (-0.32762602 + s * (0.09698567 - s * 0.01438903)));
    }
    return (k * k * (2.0 * k + 1.0) + q) / (k * (3.0 * k + 2.0));
}

// The angle phi at which the backward ray is at infinity, for rays that escape. Each section of the
// orbit is one R_F (DLMF 19.29.4):
//
//   outward from u0:  2 u0 R_F(X, Y +- u0^2 sqrt(v)/2),
//                     X = k ((u0 + k) sqrt(1 + k) + |du/dphi|)^2 / (u0 + k),
//                     Y = (1 + k) (2 k - u0) (2 k + u0)/2 + 2 k sqrt(1 + k) |du/dphi|,
//                     2 k - u0 = 2/3 - u0 - (2/3) v/(1 + k)
//   0 -> u2:          2 sqrt(u2) R_F(rise u3, rise gap, k gap),
//                     u2 and u3 the pair, gap = u3 - u2 = sqrt(v), rise = u2 + k
//   u0 -> u2:         2 sqrt(d) R_F(rise (gap + d), rise gap, (u0 + k) gap),
//                     d = u2 - u0 from d (d + gap) = f(u0)/(u0 + k)
//
// In this form no argument is a difference of nearly equal numbers.
fn angle_to_infinity(orbit: Orbit) -> f32 {
    let k = orbit_root(orbit.inverse_b, orbit.q);
    let t = 2.0 + 3.0 * k;
    // v / (1 + k).
    let share = -4.0 * orbit.discriminant / (t * t);
    let v = share * (1.0 + k);
    let above = orbit.u + k;
    let inverse_above = 1.0 / above;
    if orbit.slope > 0.0 {
        let gap = sqrt(max(v, 0.0));
        let u2 = 2.0 * k * (1.0 + k) / (1.0 + k + gap);
        let rise = u2 + k;
        let rest = orbit.slope * orbit.slope * inverse_above;
        let d = 2.0 * rest / (gap + sqrt(gap * gap + 4.0 * rest) + TINY);
        let h = 0.5 * gap;
        let from_camera = sqrt(d) * carlson_rf_pair(rise * (gap + d), h * (rise + above), square(h * d));
        return 2.0 * (from_camera + sqrt(u2) * carlson_rf_pair(rise * (u2 + gap), h * (rise + k), square(h * u2)));
    }
    let slope = -orbit.slope;
    let root = sqrt(1.0 + k);
    // 2 k - u0, computed from the distance to the photon sphere, u = 2/3, unless k is small.
    let beyond = select(2.0 * k - orbit.u, scene.shadow.u_to_photon_sphere - (2.0 / 3.0) * share, k > 0.25);
    let mean = 0.5 * (1.0 + k) * beyond * (2.0 * k + orbit.u) + 2.0 * k * root * slope;
    let x = k * square(above * root + slope) * inverse_above;
    return 2.0 * orbit.u * carlson_rf_pair(x, mean, 0.25 * square(orbit.u * orbit.u) * v);
}

// u at the angle phi after a place with u0, du/dphi: Biermann's and Weierstrass's solution of
// (du/dphi)^2 = f(u) (Whittaker & Watson 1927 section 20.6), with P = P(phi; g2, g3), g2 = 1/12, g3
// = 1/216 - q/16, x0 = (u0 - 1/3)/4:
//
//   u = u0 + (-P' du/dphi + f'(u0) (P - x0)/2 + f(u0)/4) / (2 (P - x0)^2)
//
// It depends on the angle only and not on the place's position on its orbit, and it holds through
// turning points and for either sign of D. So a crossing costs no elliptic integral and no modulus.
fn u_after(phi: f32, u0: f32, slope: f32, g3: f32) -> f32 {
    let p = weierstrass(phi, g3);
    let phi2 = phi * phi;
    let x = 1.0 + p.even - phi2 * 0.25 * (u0 - (1.0 / 3.0));
    let rise = phi * slope;
    let numerator = rise * (1.0 + p.odd + 0.125 * phi2 * rise) + 0.25 * phi2 * u0 * (3.0 * u0 - 2.0) * x;
    return u0 + numerator / (x * x);
}

fn add_crossing(result: ptr<function, Trace>, u: f32, direction: vec3<f32>, energy: f32, lambda: f32) {
    if u * scene.disk.outer > 1.0 && u * scene.disk.inner < 1.0 {
        add_hit(result, direction / u, energy, lambda);
    }
}

// Direction of the line in which the orbit's plane intersects the disk's, on the side of the first
// crossing. Pictures do not need the azimuth of a hit.
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
    // (radial - c E) (radial + c E) = (1 - u) |w|^2 D keeps D's digits next to the critical curve;
    // where light is hardly bent, D must agree with b.
    let other_margin = photon.shadow_margin + scene.shadow.twice_critical_radial * energy;
    let critical = photon.shadow_margin * other_margin * scene.shadow.inverse_lapse_squared * inverse_w * inverse_w;
    let d = select(6.75 * inverse_b * inverse_b - 1.0, critical, critical > WEAK_DISCRIMINANT);
    let turns = d < 0.0;
    let discriminant = select(max(d, MIN_DISCRIMINANT), min(d, -MIN_DISCRIMINANT), turns);
    let orbit = Orbit(scene.observer.u, photon.radial * scale, inverse_b, inverse_b * inverse_b, discriminant);

    // A ray that turns stays on its side of the photon sphere; one that does not keeps its radial
    // direction.
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
        let g3 = (1.0 / 216.0) - 0.0625 * min(orbit.q, 1e4);
        // The way from u = 0 to 1/3, or to a turning point before, is at most 2.1 rad long, and the
        // ray crosses the plane every pi. So it crosses the annulus at most once on its way in and
        // once on its way out: at the first and the last crossing of the plane.
        let last = floor((angle - crossing_angle) * (1.0 / PI));
        if last >= 0.0 && outside_inner_edge {
            add_crossing(&result, u_after(crossing_angle, orbit.u, orbit.slope, g3), across, energy, lambda);
            result.turn = select(0.0, crossing_angle, result.hit_count == 1u);
        }
        if escapes && last >= select(0.0, 1.0, outside_inner_edge) && result.hit_count < MAX_HITS {
            let beyond = angle - crossing_angle - last * PI;
            let u = u_after(beyond, 0.0, inverse_b, g3);
            let first = result.hit_count == 0u;
            add_crossing(&result, u, select(across, -across, (i32(last) & 1) == 1), energy, lambda);
            result.turn = select(result.turn, crossing_angle + last * PI, first && result.hit_count == 1u);
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
