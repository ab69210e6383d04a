// Kerr's null geodesics in Mino time, on the celestial sphere, for any spin; crates/lightfall-core/src/geometry/mino.rs is
// the f64 twin and says where the equations come from. With u = 1/r, the unit vector n of azimuth
// psi, and phi = psi + chi, along the backward ray (2 M = 1):
//
//   u'^2 = U(u) = W^2 - K' u^2 D,   W = E + B u^2,   D = 1 - u + a^2 u^2 = (1 - r_+ u)(1 - r_- u),
//   u''  = u (2 B W - K' S),   S = D + u dD/du / 2,
//   n''  = a^2 E^2 n_z e_z - (K + 2 a^2 E^2 n_z^2) n,   chi' = a (E - W/D),
//   B = a (a E - L),   K' = Q + (L - a E)^2,   K = K' - 2 E B + a^2 E^2.
//
// U is Carter's (1968) R(r)/r^4 = ((E (r^2 + a^2) - a L)^2 - (r^2 - r + a^2) K')/r^4. Kept like
// this and not as a polynomial, it makes E, B and K' the only constants: whatever their rounding,
// they are those of some ray nearby, and the circle on which a critical ray lingers is where it
// should be. Next to the horizon of a fast hole W and D are differences of numbers near one, so
// there the radial variable is u - 1/r_+, D's root is exact, and u' is taken from U anew at each
// step; mino_azimuth.wgsl has the azimuth.
//
// The step is Nystroem's of fifth order (Nystroem 1925; Hairer, Norsett & Wanner 1993, section
// II.14), four accelerations, the first of which is the last one's end; its dense output is the
// quintic with the values, slopes and accelerations of both ends. The constants are scaled such
// that the step in Mino time is an angle: docs/PHYSICS.md has the measurements that chose them.

// More than a ray within f32's rounding of the critical curve takes at the shortest step.
const MAX_STEPS: u32 = 1024u;
// By how much E^2 adds to K in the scale: radial rays, with K = 0, cover no more than du = step/2
// in a step.
const ENERGY_WEIGHT: f32 = 4.0;
// Rays with sqrt(K)/E below this may come near the critical curve, where it is 3.5 at most. Their
// step is shorter, lest the shadow's edge be off.
const FAR_IMPACT: f32 = 4.0;
// Where U is below this share of W^2, a turning point is near and U is no longer a good measure of
// u'.
const TURNING_SHARE: f32 = 0.0625;

struct Constants {
    energy: f32,
    // B and K'.
    drag: f32,
    k_prime: f32,
    // a^2 E^2 - K, and a^2 E^2.
    stiffness: f32,
    axial: f32,
    // W at the horizon.
    horizon_w: f32,
}

// The motion about u = base, by v = u - base.
struct Motion {
    base: f32,
    constants: Constants,
    // Coefficients of W, D, S, and of E D - W.
    w: vec3<f32>,
    d: vec3<f32>,
    s: vec3<f32>,
    dragging: vec3<f32>,
}

// The ends of a step: (v, n_z, n_x, n_y), its change over a step, were it constant, and that one's.
struct Step {
    y0: vec4<f32>,
    dy0: vec4<f32>,
    k0: vec4<f32>,
    y1: vec4<f32>,
    dy1: vec4<f32>,
    k1: vec4<f32>,
}

// What is between them, as a polynomial of the share of the step.
struct Curve {
    c0: vec4<f32>,
    c1: vec4<f32>,
    c2: vec4<f32>,
    c3: vec4<f32>,
    c4: vec4<f32>,
    c5: vec4<f32>,
}

fn motion_about(base: f32, c: Constants) -> Motion {
    let a2 = square(scene.spin_length);
    let w = vec3<f32>(select(c.energy, c.horizon_w, base > 0.0), 2.0 * c.drag * base, c.drag);
    // D's root at 1/r_+ is exact.
    let d = select(vec3<f32>(1.0, -1.0, a2), vec3<f32>(0.0, -scene.horizon_gap, a2), base > 0.0);
    let s = vec3<f32>(d.x + 0.5 * base * d.y, 1.5 * d.y + base * a2, 2.0 * a2);
    return Motion(base, c, w, d, s, c.energy * d - w);
}

fn quadratic(c: vec3<f32>, v: f32) -> f32 {
    return c.x + v * (c.y + v * c.z);
}

// u''/u.
fn pull(m: Motion, v: f32) -> f32 {
    return 2.0 * m.constants.drag * quadratic(m.w, v) - m.constants.k_prime * quadratic(m.s, v);
}

fn acceleration(m: Motion, y: vec4<f32>) -> vec4<f32> {
    let polar = m.constants.stiffness - 2.0 * m.constants.axial * y.y * y.y;
    return vec4<f32>((m.base + y.x) * pull(m, y.x), polar * y.y, (polar - m.constants.axial) * y.zw);
}

// From the state y, its change dy over a step, were it constant, and the acceleration k1 there, in
// the same unit.
fn nystroem_step(m: Motion, h2: f32, y: vec4<f32>, dy: vec4<f32>, k1: vec4<f32>) -> Step {
    let k2 = h2 * acceleration(m, y + 0.2 * dy + 0.02 * k1);
    let k3 = h2 * acceleration(m, y + (2.0 / 3.0) * dy + ((7.0 / 27.0) * k2 - (1.0 / 27.0) * k1));
    let k4 = h2 * acceleration(m, y + dy + 0.3 * k1 + ((9.0 / 35.0) * k3 - (2.0 / 35.0) * k2));
    let end = y + (dy + ((14.0 / 336.0) * k1 + (100.0 / 336.0) * k2 + (54.0 / 336.0) * k3));
    let change = (14.0 / 336.0) * k1 + (125.0 / 336.0) * k2 + (162.0 / 336.0) * k3 + (35.0 / 336.0) * k4;
    return Step(y, dy, k1, end, dy + change, h2 * acceleration(m, end));
}

// Of its four components only those are computed that are used.
fn curve(s: Step) -> Curve {
    // What the end has beyond the parabola of the start: values, slopes, half the second
    // derivatives.
    let r0 = (s.y1 - s.y0) - s.dy0 - 0.5 * s.k0;
    let r1 = (s.dy1 - s.dy0) - s.k0;
    let r2 = 0.5 * (s.k1 - s.k0);
    let c3 = 10.0 * r0 - 4.0 * r1 + r2;
    return Curve(s.y0, s.dy0, 0.5 * s.k0, c3, 7.0 * r1 - 15.0 * r0 - 2.0 * r2, 6.0 * r0 - 3.0 * r1 + r2);
}

fn curve_at(c: Curve, t: f32) -> vec4<f32> {
    return c.c0 + t * (c.c1 + t * (c.c2 + t * (c.c3 + t * (c.c4 + t * c.c5))));
}

fn curve_slope(c: Curve, t: f32) -> vec4<f32> {
    return c.c1 + t * (2.0 * c.c2 + t * (3.0 * c.c3 + t * (4.0 * c.c4 + t * (5.0 * c.c5))));
}

// U(u), where W^2 is given.
fn speed2(m: Motion, v: f32, w2: f32) -> f32 {
    return w2 - m.constants.k_prime * square(m.base + v) * quadratic(m.d, v);
}

// Whether U is positive from v up to v + width, so that no ray turns there. May answer no where it
// is yes, never the other way: a polynomial lies above the least of its Bernstein coefficients
// (Farouki & Rajan 1987).
fn cannot_turn(m: Motion, v: f32, width: f32) -> bool {
    let u = m.base + v;
    let u2 = speed2(m, v, square(quadratic(m.w, v)));
    // dU/du = 2 u p, and p's own derivatives.
    let p = pull(m, v);
    let p2 = 2.0 * (2.0 * square(m.constants.drag) - m.constants.k_prime * m.s.z);
    let p1 = 2.0 * m.constants.drag * m.w.y - m.constants.k_prime * m.s.y + p2 * v;
    let c1 = 2.0 * width * u * p;
    let c2 = width * width * (p + u * p1);
    let c3 = width * width * width * (2.0 * p1 + u * p2) / 3.0;
    let c4 = 0.25 * square(width * width) * p2;
    let b12 = min(u2 + 0.25 * c1, u2 + 0.5 * c1 + c2 / 6.0);
    let b34 = min(u2 + 0.75 * c1 + 0.5 * c2 + 0.25 * c3, u2 + c1 + c2 + c3 + c4);
    return min(u2, min(b12, b34)) > 0.0;
}

fn trace(photon: Photon) -> Trace {
    var result = untraced();
    let n = scene.camera_direction;
    let a = scene.spin_length;

    // K = |w|^2 - a^2 E^2 n_z^2, with the length's unit back in w; the scale makes K +
    // ENERGY_WEIGHT E^2 one.
    let w_camera = scene.camera_radius * photon.w;
    let k_camera = dot(w_camera, w_camera) - square(a * n.z * photon.energy);
    let scale = inverseSqrt(max(k_camera + ENERGY_WEIGHT * square(photon.energy), TINY));
    let energy = scale * photon.energy;
    let w = scale * w_camera;
    // K' = |w - a E e_z x n|^2, and L - a E is that vector's moment about the axis, less a E n_z^2.
    let dragged = w - a * energy * vec3<f32>(-n.y, n.x, 0.0);
    let k_prime = dot(dragged, dragged);
    let drag = -a * (n.x * dragged.y - n.y * dragged.x - a * energy * n.z * n.z);
    let angular_momentum = n.x * w.y - n.y * w.x;
    let u_horizon = scene.horizon_u;
    let near = NEAR_HORIZON && scene.camera_u > 0.5 * u_horizon;
    let depth = scene.horizon_depth;
    var horizon_w = energy + drag * u_horizon * u_horizon;
    if near && depth > 0.0 {
        // E and B u^2 may cancel at the camera; u'^2 and K' u^2 D do not, outside.
        let d = depth * (scene.horizon_gap + a * a * depth);
        let w_there = sqrt(square(scale * photon.radial) + k_prime * square(scene.camera_u) * d);
        horizon_w = w_there + drag * depth * (2.0 * u_horizon - depth);
    }
    let constants = Constants(energy, drag, k_prime, 2.0 * energy * drag - k_prime, square(a * energy), horizon_w);

    // Next to the horizon an observer can meet light that has no energy.
    let lambda = angular_momentum / select(energy, TINY, abs(energy) < TINY);

    let far = k_camera > square(FAR_IMPACT * photon.energy);
    var h = select(scene.mino_near_step, scene.mino_step, far);
    // A camera at or inside the horizon.
    let inside = NEAR_HORIZON && depth <= 0.0;
    if inside {
        // Deep inside u changes by its own measure in less than a radian: a share of that time, by
        // U's growing terms.
        let u = scene.camera_u;
        h *= inverseSqrt(max(1.0, u * (6.0 * k_prime + 8.0 * u * (square(drag) + square(a) * k_prime))));
    }
    let u_inner = select(0.0, 1.0 / scene.disk_inner, HAS_DISK);
    var m = motion_about(select(0.0, u_horizon, near), constants);
    var y = vec4<f32>(select(scene.camera_u, -depth, near), n.z, n.xy);
    var dy = h * vec4<f32>(scale * photon.radial, -w.z, -w.xy);
    var k = h * h * acceleration(m, y);
    // In two parts, for it can be many turns.
    var chi = 0.0;
    var chi_whole = 0.0;
    var turn = 0.0;
    // Light that comes in from outside has an azimuth without a pole, which the camera's is known
    // in: Kerr's ingoing one.
    var ingoing = NEAR_HORIZON && photon.radial < 0.0;
    if ingoing {
        chi = scene.azimuth_lead;
    }
    if inside && horizon_w <= 0.0 {
        // Light on its way from the horizon's other branch, through which nothing comes from
        // outside.
        result.outcome = OUTCOME_CAPTURED;
        return result;
    }

    for (var i = 0u; i < MAX_STEPS; i++) {
        // 1/r_+ in two parts, so that the distance to the horizon keeps its digits.
        let nearer = SPINNING && m.base == 0.0 && y.x > 0.5 * u_horizon;
        if nearer || (SPINNING || NEAR_HORIZON) && m.base > 0.0 && y.x < -0.5 * u_horizon {
            y.x = select((y.x + scene.horizon_u_rest) + u_horizon, (y.x - u_horizon) - scene.horizon_u_rest, nearer);
            m = motion_about(select(0.0, u_horizon, nearer), constants);
        }
        let u = m.base + y.x;
        if DIAGNOSTICS {
            let w2 = square(quadratic(m.w, y.x));
            let u2 = speed2(m, y.x, w2);
            let radial = abs(square(dy.x / h) - u2) / max(w2 + abs(w2 - u2), TINY);
            let length = abs(dot(y.yzw, y.yzw) - 1.0);
            result.residual = max(result.residual, max(radial, length));
            let axial = abs((y.z * dy.w - y.w * dy.z) / h + angular_momentum);
            result.angular_momentum_drift = max(result.angular_momentum_drift, axial);
        }
        let nothing_more_to_hit = u >= u_inner || result.hit_count == MAX_HITS;
        if dy.x > 0.0 && (u >= u_horizon || nothing_more_to_hit && cannot_turn(m, y.x, u_horizon - u)) {
            result.outcome = OUTCOME_CAPTURED;
            break;
        }
        if !FOLLOW_BEYOND_HITS && result.hit_count == MAX_HITS {
            result.outcome = OUTCOME_HIDDEN;
            break;
        }
        if (SPINNING || NEAR_HORIZON) && m.base > 0.0 {
            let w2 = square(quadratic(m.w, y.x));
            let u2 = speed2(m, y.x, w2);
            if u2 > TURNING_SHARE * w2 {
                dy.x = select(-h, h, dy.x > 0.0) * sqrt(u2);
            }
        }
        let step = nystroem_step(m, h * h, y, dy, k);
        var end = step.y1;
        result.steps += 1u;

        // An outgoing ray that is at u = 0 within the step; u'' vanishes there, so Newton's method
        // converges at once.
        let escapes = dy.x < 0.0 && m.base + end.x <= 0.0;
        var share = 1.0;
        if escapes {
            let path = curve(step);
            share = u / (y.x - end.x);
            for (var j = 0u; j < 3u; j++) {
                share = clamp(share - (m.base + curve_at(path, share).x) / curve_slope(path, share).x, 0.0, 1.0);
            }
            end = curve_at(path, share);
        }
        let regular = NEAR_HORIZON && dy.x * step.dy1.x > 0.0;
        if NEAR_HORIZON && ingoing && !(regular && dy.x < 0.0) {
            ingoing = false;
            add_angle(&chi_whole, &chi, azimuth_lag_to_infinity(m, y.x));
        }
        if HAS_DISK && crosses_plane(y.y, end.y) && result.hit_count < MAX_HITS {
            let path = curve(step);
            // So does n_z'' in the plane.
            var t = share * y.y / (y.y - end.y);
            for (var j = 0u; j < 2u; j++) {
                t = clamp(t - curve_at(path, t).y / curve_slope(path, t).y, 0.0, share);
            }
            let crossing = curve_at(path, t);
            let r = 1.0 / (m.base + crossing.x);
            if in_annulus(r) {
                var place = crossing.zw * inverseSqrt(max(dot(crossing.zw, crossing.zw), TINY));
                // Pictures know no azimuth of a hit.
                if SPINNING && AZIMUTH {
                    var gain = azimuth_gain(m, path, h, t, crossing.x, regular, ingoing);
                    if ingoing {
                        gain += azimuth_lag_to_infinity(m, crossing.x);
                    }
                    var whole = chi_whole;
                    var rest = chi;
                    add_angle(&whole, &rest, gain);
                    place = turned(place, sine_cosine(wrapped(whole, rest)));
                }
                if DIAGNOSTICS && result.hit_count == 0u {
                    result.turn = turn + angle_between(y.yzw, crossing.yzw);
                }
                add_hit(&result, vec3<f32>(r * place, 0.0), photon.energy, lambda);
            }
        }
        // A picture without a sky asks for no azimuth at all.
        if SPINNING && SKY_DIRECTION {
            add_angle(&chi_whole, &chi, azimuth_gain(m, curve(step), h, share, end.x, regular, ingoing));
        }
        if DIAGNOSTICS {
            turn += angle_between(y.yzw, end.yzw);
        }
        if escapes {
            // Light of negative energy never was at infinity.
            result.outcome = select(OUTCOME_CAPTURED, OUTCOME_SKY, energy > 0.0);
            let across = select(end.zw, turned(end.zw, sine_cosine(wrapped(chi_whole, chi))), SPINNING);
            result.turn = select(result.turn, turn, energy > 0.0 && result.hit_count == 0u);
            result.sky = select(vec3<f32>(0.0), safe_normalize(vec3<f32>(across, end.y)), energy > 0.0);
            break;
        }
        y = end;
        dy = step.dy1;
        k = step.k1;
    }
    return result;
}
