// Kerr's null geodesics in Mino time, on the celestial sphere, for any spin; src/physics/mino.rs is the f64 twin and
// says where the equations come from. With u = 1/r, the unit vector n of azimuth psi, and phi = psi + chi, along the
// backward ray (2 M = 1):
//
//   u'^2 = U(u) = W^2 - K' u^2 D,   W = E + B u^2,   D = 1 - u + a^2 u^2 = (1 - r_+ u)(1 - r_- u),
//   n''  = a^2 E^2 n_z e_z - (K + 2 a^2 E^2 n_z^2) n,   chi' = a (E - W/D),
//   B = a (a E - L),   K' = Q + (L - a E)^2,   K = K' - 2 E B + a^2 E^2.
//
// U is Carter's (1968) R(r)/r^4 = ((E (r^2 + a^2) - a L)^2 - (r^2 - r + a^2) K')/r^4. Kept like this and not as a
// polynomial, it makes E, B and K' the only constants: whatever their rounding, they are those of some ray nearby. Next
// to the horizon of a fast hole W and D are differences of numbers near one, so there the radial variable is u - 1/r_+,
// D's root is exact, and u' is taken from U anew at each step.
//
// The step is Nystroem's of fifth order (Nystroem 1925; Hairer, Norsett & Wanner 1993, section II.14), four
// accelerations; its dense output is the quintic with the values, slopes and accelerations of both ends. The constants
// are scaled such that the step in Mino time is an angle: docs/PHYSICS.md has the measurements that chose them.

// More than a ray within f32's rounding of the critical curve takes at the shortest step.
const MOST_STEPS: u32 = 1024u;
// By how much E^2 adds to K in the scale: radial rays, with K = 0, cover no more than du = step/2 in a step.
const ENERGY_WEIGHT: f32 = 4.0;
// Where U is below this share of W^2, a turning point is near and U is no longer a good measure of u'.
const TURNING_SHARE: f32 = 0.0625;

struct Constants {
    energy: f32,
    // B and K'.
    drag: f32,
    k_prime: f32,
    // a^2 E^2 - K, and a^2 E^2.
    stiffness: f32,
    axial: f32,
}

// The constants about u = base: everything as a polynomial of v = u - base.
struct Motion {
    // v'' = U'/2.
    pull: vec4<f32>,
    stiffness: f32,
    axial: f32,
    // W and D.
    w: vec3<f32>,
    d: vec3<f32>,
}

// One step: (v, n_z, n_x, n_y) as a polynomial of the share of the step.
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
    let shifted = base > 0.0;
    // D's root at 1/r_+ is exact, and r_+ + r_- = 1.
    let d = vec3<f32>(select(1.0, 0.0, shifted), select(-1.0, scene.inner_horizon - scene.horizon, shifted), a2);
    let w = c.energy + c.drag * base * base;
    let quartic = c.drag * c.drag - a2 * c.k_prime;
    let pull = vec4<f32>(
        base * (2.0 * w * c.drag - c.k_prime * (d.x + 0.5 * base * d.y)),
        4.0 * square(c.drag * base) + 2.0 * w * c.drag - c.k_prime * (d.x + base * (2.0 * d.y + a2 * base)),
        1.5 * c.k_prime + 6.0 * quartic * base,
        2.0 * quartic,
    );
    return Motion(pull, c.stiffness, c.axial, vec3<f32>(w, 2.0 * c.drag * base, c.drag), d);
}

fn quadratic(c: vec3<f32>, v: f32) -> f32 {
    return c.x + v * (c.y + v * c.z);
}

fn acceleration(m: Motion, y: vec4<f32>) -> vec4<f32> {
    let radial = m.pull.x + y.x * (m.pull.y + y.x * (m.pull.z + y.x * m.pull.w));
    let polar = m.stiffness - 2.0 * m.axial * y.y * y.y;
    return vec4<f32>(radial, polar * y.y, (polar - m.axial) * y.zw);
}

// The step from the state y and its change dy over a step, were it constant; and what these are at the end.
fn nystroem_step(
    m: Motion,
    h: f32,
    y: vec4<f32>,
    dy: vec4<f32>,
    end: ptr<function, vec4<f32>>,
    end_dy: ptr<function, vec4<f32>>,
) -> Curve {
    let h2 = h * h;
    let k1 = h2 * acceleration(m, y);
    let k2 = h2 * acceleration(m, y + 0.2 * dy + 0.02 * k1);
    let k3 = h2 * acceleration(m, y + (2.0 / 3.0) * dy + (7.0 * k2 - k1) / 27.0);
    let k4 = h2 * acceleration(m, y + dy + 0.3 * k1 + (9.0 * k3 - 2.0 * k2) / 35.0);
    *end = y + dy + (14.0 * k1 + 100.0 * k2 + 54.0 * k3) / 336.0;
    *end_dy = dy + (14.0 * k1 + 125.0 * k2 + 162.0 * k3 + 35.0 * k4) / 336.0;
    // What the end has beyond the parabola of the start: values, slopes, half the second derivatives.
    let parabola = 0.5 * k1;
    let r0 = (*end - y) - dy - parabola;
    let r1 = (*end_dy - dy) - k1;
    let r2 = 0.5 * h2 * acceleration(m, *end) - parabola;
    return Curve(y, dy, parabola, 10.0 * r0 - 4.0 * r1 + r2, 7.0 * r1 - 15.0 * r0 - 2.0 * r2, 6.0 * r0 - 3.0 * r1 + r2);
}

fn curve_at(c: Curve, t: f32) -> vec4<f32> {
    return c.c0 + t * (c.c1 + t * (c.c2 + t * (c.c3 + t * (c.c4 + t * c.c5))));
}

fn curve_slope(c: Curve, t: f32) -> vec4<f32> {
    return c.c1 + t * (2.0 * c.c2 + t * (3.0 * c.c3 + t * (4.0 * c.c4 + t * (5.0 * c.c5))));
}

fn radial_at(c: Curve, t: f32) -> f32 {
    return c.c0.x + t * (c.c1.x + t * (c.c2.x + t * (c.c3.x + t * (c.c4.x + t * c.c5.x))));
}

fn azimuth_rate(m: Motion, energy: f32, v: f32) -> f32 {
    return scene.spin_length * (energy - quadratic(m.w, v) / quadratic(m.d, v));
}

// By how much chi grows from the start of a step to its share t, by Gauss and Legendre with four nodes.
fn azimuth_gain(m: Motion, energy: f32, c: Curve, t: f32) -> f32 {
    let outer = azimuth_rate(m, energy, radial_at(c, 0.0694318442 * t))
        + azimuth_rate(m, energy, radial_at(c, 0.9305681558 * t));
    let inner = azimuth_rate(m, energy, radial_at(c, 0.3300094782 * t))
        + azimuth_rate(m, energy, radial_at(c, 0.6699905218 * t));
    return scene.mino_step * t * (0.1739274226 * outer + 0.3260725774 * inner);
}

// The same angle within [-pi, pi]; 2 pi in two parts, the first of few digits.
fn wrapped(angle: f32) -> f32 {
    let turns = round(angle / (2.0 * PI));
    return (angle - turns * 6.28125) - turns * 1.93530718e-3;
}

// U(u), where W^2 is given.
fn speed2(m: Motion, k_prime: f32, base: f32, v: f32, w2: f32) -> f32 {
    return w2 - k_prime * square(base + v) * quadratic(m.d, v);
}

// Whether U is positive from v up to v + width, so that no ray turns there. May answer no where it is yes, never the
// other way: a polynomial lies above the least of its Bernstein coefficients (Farouki & Rajan 1987).
fn cannot_turn(m: Motion, u2: f32, v: f32, width: f32) -> bool {
    let p = m.pull;
    let c1 = 2.0 * width * (p.x + v * (p.y + v * (p.z + v * p.w)));
    let c2 = width * width * (p.y + v * (2.0 * p.z + v * 3.0 * p.w));
    let c3 = width * width * width * (2.0 / 3.0) * (p.z + 3.0 * v * p.w);
    let c4 = square(width * width) * 0.5 * p.w;
    let b12 = min(u2 + 0.25 * c1, u2 + 0.5 * c1 + c2 / 6.0);
    let b34 = min(u2 + 0.75 * c1 + 0.5 * c2 + 0.25 * c3, u2 + c1 + c2 + c3 + c4);
    return min(u2, min(b12, b34)) > 0.0;
}

fn trace(photon: Photon) -> Trace {
    var result = untraced();
    let n = scene.camera_direction;
    let a = scene.spin_length;
    let h = scene.mino_step;

    // K = |w|^2 - a^2 E^2 n_z^2, with the length's unit back in w; the scale makes K + ENERGY_WEIGHT E^2 one.
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
    let constants = Constants(energy, drag, k_prime, 2.0 * energy * drag - k_prime, square(a * energy));

    // Next to the horizon an observer can meet light that has no energy.
    let lambda = angular_momentum / select(energy, TINY, abs(energy) < TINY);

    let u_horizon = scene.horizon_u;
    let u_inner = select(0.0, 1.0 / scene.disk_inner, HAS_DISK);
    var base = 0.0;
    var y = vec4<f32>(1.0 / scene.camera_radius, n.z, n.xy);
    var dy = h * vec4<f32>(scale * photon.radial, -w.z, -w.xy);
    var chi = 0.0;
    var turn = 0.0;

    for (var i = 0u; i < MOST_STEPS; i++) {
        if SPINNING {
            // 1/r_+ in two parts, so that the distance to the horizon keeps its digits.
            if base == 0.0 && y.x > 0.5 * u_horizon {
                base = u_horizon;
                y.x = (y.x - u_horizon) - scene.horizon_u_rest;
            } else if base > 0.0 && y.x < -0.5 * u_horizon {
                base = 0.0;
                y.x = (y.x + scene.horizon_u_rest) + u_horizon;
            }
        }
        let m = motion_about(base, constants);
        let u = base + y.x;
        let w2 = square(quadratic(m.w, y.x));
        let u2 = speed2(m, k_prime, base, y.x, w2);
        if DIAGNOSTICS {
            let radial = abs(square(dy.x / h) - u2) / max(w2 + abs(w2 - u2), TINY);
            let length = abs(dot(y.yzw, y.yzw) - 1.0);
            result.residual = max(result.residual, max(radial, length));
            let axial = abs((y.z * dy.w - y.w * dy.z) / h + angular_momentum);
            result.angular_momentum_drift = max(result.angular_momentum_drift, axial);
        }
        let nothing_more_to_hit = u >= u_inner || result.hit_count == MOST_HITS;
        if dy.x > 0.0 && (u >= u_horizon || nothing_more_to_hit && cannot_turn(m, u2, y.x, u_horizon - u)) {
            result.outcome = OUTCOME_CAPTURED;
            break;
        }
        if !FOLLOW_BEYOND_HITS && result.hit_count == MOST_HITS {
            result.outcome = OUTCOME_HIDDEN;
            break;
        }
        if SPINNING && base > 0.0 && u2 > TURNING_SHARE * w2 {
            dy.x = select(-h, h, dy.x > 0.0) * sqrt(u2);
        }
        var end: vec4<f32>;
        var end_dy: vec4<f32>;
        let curve = nystroem_step(m, h, y, dy, &end, &end_dy);
        result.steps += 1u;

        // An outgoing ray that is at u = 0 within the step; u'' vanishes there, so Newton's method converges at once.
        let escapes = dy.x < 0.0 && base + end.x <= 0.0;
        var share = 1.0;
        if escapes {
            share = u / (y.x - end.x);
            for (var j = 0u; j < 3u; j++) {
                share = clamp(share - (base + radial_at(curve, share)) / curve_slope(curve, share).x, 0.0, 1.0);
            }
            end = curve_at(curve, share);
        }
        if HAS_DISK && crosses_plane(y.y, end.y) && result.hit_count < MOST_HITS {
            // So does n_z'' in the plane.
            var t = share * y.y / (y.y - end.y);
            for (var j = 0u; j < 2u; j++) {
                t = clamp(t - curve_at(curve, t).y / curve_slope(curve, t).y, 0.0, share);
            }
            let crossing = curve_at(curve, t);
            let r = 1.0 / (base + crossing.x);
            if in_annulus(r) {
                var place = crossing.zw * inverseSqrt(max(dot(crossing.zw, crossing.zw), TINY));
                // Pictures know no azimuth of a hit.
                if SPINNING && AZIMUTH {
                    place = turned(place, sine_cosine(wrapped(chi + azimuth_gain(m, energy, curve, t))));
                }
                if DIAGNOSTICS && result.hit_count == 0u {
                    result.turn = turn + angle_between(y.yzw, crossing.yzw);
                }
                add_hit(&result, vec3<f32>(r * place, 0.0), photon.energy, lambda);
            }
        }
        // A picture without a sky asks for no azimuth at all.
        if SPINNING && SKY_DIRECTION {
            chi = wrapped(chi + azimuth_gain(m, energy, curve, share));
        }
        if DIAGNOSTICS {
            turn += angle_between(y.yzw, end.yzw);
        }
        if escapes {
            // Light of negative energy never was at infinity.
            result.outcome = select(OUTCOME_CAPTURED, OUTCOME_SKY, energy > 0.0);
            let across = select(end.zw, turned(end.zw, sine_cosine(chi)), SPINNING);
            result.turn = select(result.turn, turn, energy > 0.0 && result.hit_count == 0u);
            result.sky = select(vec3<f32>(0.0), safe_normalize(vec3<f32>(across, end.y)), energy > 0.0);
            break;
        }
        y = end;
        dy = end_dy;
    }
    return result;
}
