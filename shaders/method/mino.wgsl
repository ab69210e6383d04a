const MOST_STEPS: u32 = 1024u;
const ENERGY_WEIGHT: f32 = 4.0;

struct Ray {
    e: f32,
    b: f32,
    k: f32,
    stiffness: f32,
    axial: f32,
}
struct Coefficients {
    pull: f32,
    linear: f32,
    quadratic: f32,
    cubic: vec2<f32>,
    stiffness: f32,
    axial: f32,
    w0: f32,
    w1: f32,
    w2: f32,
    d0: f32,
    d1: f32,
    d2: f32,
    swirl: f32,
}
struct Series {
    y0: vec2<f32>,
    y1: vec2<f32>,
    y2: vec2<f32>,
    y3: vec2<f32>,
    y4: vec2<f32>,
    y5: vec2<f32>,
    y6: vec2<f32>,
    y7: vec2<f32>,
    y8: vec2<f32>,
    y9: vec2<f32>,
    y10: vec2<f32>,
    x0: vec2<f32>,
    x1: vec2<f32>,
    x2: vec2<f32>,
    x3: vec2<f32>,
    x4: vec2<f32>,
    x5: vec2<f32>,
    x6: vec2<f32>,
    x7: vec2<f32>,
    x8: vec2<f32>,
    x9: vec2<f32>,
    x10: vec2<f32>,
}
fn about(ray: Ray, base: f32) -> Coefficients {
    let a = scene.spin_length;
    let shifted = base > 0.0;
    let w = ray.e + ray.b * base * base;
    let d0 = select(1.0, 0.0, shifted);
    let d1 = select(-1.0, scene.inner_horizon - scene.horizon, shifted);
    let quartic = ray.b * ray.b - a * a * ray.k;
    return Coefficients(
        base * (2.0 * w * ray.b - ray.k * (d0 + 0.5 * base * d1)),
        4.0 * square(ray.b * base) + 2.0 * w * ray.b - ray.k * (d0 + base * (2.0 * d1 + a * a * base)),
        1.5 * ray.k + 6.0 * quartic * base,
        vec2<f32>(2.0 * quartic, -2.0 * ray.axial),
        ray.stiffness,
        ray.axial,
        w,
        2.0 * ray.b * base,
        ray.b,
        d0,
        d1,
        a * a,
        ray.e,
    );
}
fn w_at(c: Coefficients, v: f32) -> f32 { return c.w0 + v * (c.w1 + v * c.w2); }
fn delta_at(c: Coefficients, v: f32) -> f32 { return c.d0 + v * (c.d1 + v * c.d2); }
fn expand(c: Coefficients, y0: vec2<f32>, y1: vec2<f32>, x0: vec2<f32>, x1: vec2<f32>) -> Series {
    let s0 = y0 * y0;
    let p0 = vec2<f32>(c.linear + c.quadratic * y0.x, c.stiffness) + c.cubic * s0;
    let q0 = p0.y - c.axial;
    let y2 = (vec2<f32>(c.pull, 0.0) + p0 * y0) / 2.0;
    let x2 = (q0 * x0) / 2.0;
    let s1 = 2.0 * y0 * y1;
    let p1 = vec2<f32>(c.quadratic * y1.x, 0.0) + c.cubic * s1;
    let y3 = (p0 * y1 + p1 * y0) / 6.0;
    let x3 = (q0 * x1 + p1.y * x0) / 6.0;
    let s2 = 2.0 * y0 * y2 + y1 * y1;
    let p2 = vec2<f32>(c.quadratic * y2.x, 0.0) + c.cubic * s2;
    let y4 = (p0 * y2 + p1 * y1 + p2 * y0) / 12.0;
    let x4 = (q0 * x2 + p1.y * x1 + p2.y * x0) / 12.0;
    let s3 = 2.0 * (y0 * y3 + y1 * y2);
    let p3 = vec2<f32>(c.quadratic * y3.x, 0.0) + c.cubic * s3;
    let y5 = (p0 * y3 + p1 * y2 + p2 * y1 + p3 * y0) / 20.0;
    let x5 = (q0 * x3 + p1.y * x2 + p2.y * x1 + p3.y * x0) / 20.0;
    let s4 = 2.0 * (y0 * y4 + y1 * y3) + y2 * y2;
    let p4 = vec2<f32>(c.quadratic * y4.x, 0.0) + c.cubic * s4;
    let y6 = (p0 * y4 + p1 * y3 + p2 * y2 + p3 * y1 + p4 * y0) / 30.0;
    let x6 = (q0 * x4 + p1.y * x3 + p2.y * x2 + p3.y * x1 + p4.y * x0) / 30.0;
    let s5 = 2.0 * (y0 * y5 + y1 * y4 + y2 * y3);
    let p5 = vec2<f32>(c.quadratic * y5.x, 0.0) + c.cubic * s5;
    let y7 = (p0 * y5 + p1 * y4 + p2 * y3 + p3 * y2 + p4 * y1 + p5 * y0) / 42.0;
    let x7 = (q0 * x5 + p1.y * x4 + p2.y * x3 + p3.y * x2 + p4.y * x1 + p5.y * x0) / 42.0;
    let s6 = 2.0 * (y0 * y6 + y1 * y5 + y2 * y4) + y3 * y3;
    let p6 = vec2<f32>(c.quadratic * y6.x, 0.0) + c.cubic * s6;
    let y8 = (p0 * y6 + p1 * y5 + p2 * y4 + p3 * y3 + p4 * y2 + p5 * y1 + p6 * y0) / 56.0;
    let x8 = (q0 * x6 + p1.y * x5 + p2.y * x4 + p3.y * x3 + p4.y * x2 + p5.y * x1 + p6.y * x0) / 56.0;
    let s7 = 2.0 * (y0 * y7 + y1 * y6 + y2 * y5 + y3 * y4);
    let p7 = vec2<f32>(c.quadratic * y7.x, 0.0) + c.cubic * s7;
    let y9 = (p0 * y7 + p1 * y6 + p2 * y5 + p3 * y4 + p4 * y3 + p5 * y2 + p6 * y1 + p7 * y0) / 72.0;
    let x9 = (q0 * x7 + p1.y * x6 + p2.y * x5 + p3.y * x4 + p4.y * x3 + p5.y * x2 + p6.y * x1 + p7.y * x0) / 72.0;
    let s8 = 2.0 * (y0 * y8 + y1 * y7 + y2 * y6 + y3 * y5) + y4 * y4;
    let p8 = vec2<f32>(c.quadratic * y8.x, 0.0) + c.cubic * s8;
    let y10 = (p0 * y8 + p1 * y7 + p2 * y6 + p3 * y5 + p4 * y4 + p5 * y3 + p6 * y2 + p7 * y1 + p8 * y0) / 90.0;
    let x10 = (q0 * x8 + p1.y * x7 + p2.y * x6 + p3.y * x5 + p4.y * x4 + p5.y * x3 + p6.y * x2 + p7.y * x1 + p8.y * x0) / 90.0;
    return Series(y0, y1, y2, y3, y4, y5, y6, y7, y8, y9, y10, x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10);
}
fn y_at(s: Series, t: f32) -> vec2<f32> { return ((((((((((s.y10) * t + s.y9) * t + s.y8) * t + s.y7) * t + s.y6) * t + s.y5) * t + s.y4) * t + s.y3) * t + s.y2) * t + s.y1) * t + s.y0; }
fn dy_at(s: Series, t: f32) -> vec2<f32> { return (((((((((10.0 * s.y10) * t + 9.0 * s.y9) * t + 8.0 * s.y8) * t + 7.0 * s.y7) * t + 6.0 * s.y6) * t + 5.0 * s.y5) * t + 4.0 * s.y4) * t + 3.0 * s.y3) * t + 2.0 * s.y2) * t + s.y1; }
fn x_at(s: Series, t: f32) -> vec2<f32> { return ((((((((((s.x10) * t + s.x9) * t + s.x8) * t + s.x7) * t + s.x6) * t + s.x5) * t + s.x4) * t + s.x3) * t + s.x2) * t + s.x1) * t + s.x0; }
fn dx_at(s: Series, t: f32) -> vec2<f32> { return (((((((((10.0 * s.x10) * t + 9.0 * s.x9) * t + 8.0 * s.x8) * t + 7.0 * s.x7) * t + 6.0 * s.x6) * t + 5.0 * s.x5) * t + 4.0 * s.x4) * t + 3.0 * s.x3) * t + 2.0 * s.x2) * t + s.x1; }
fn dchi(c: Coefficients, v: f32) -> f32 { return scene.spin_length * (c.swirl - w_at(c, v) / delta_at(c, v)); }
fn chi_over(c: Coefficients, s: Series, t: f32) -> f32 {
    return t * (0.1739274226 * (dchi(c, y_at(s, 0.0694318442 * t).x) + dchi(c, y_at(s, 0.9305681558 * t).x))
        + 0.3260725774 * (dchi(c, y_at(s, 0.3300094782 * t).x) + dchi(c, y_at(s, 0.6699905218 * t).x)));
}
fn wrapped(angle: f32) -> f32 {
    let turns = round(angle / (2.0 * PI));
    return (angle - turns * 6.28125) - turns * 1.93530718e-3;
}

fn cannot_turn(c: Coefficients, k: f32, v: f32, base: f32, du: f32, high: f32) -> bool {
    let u = v + base;
    let h = high - u;
    let c0 = square(w_at(c, v)) - k * u * u * delta_at(c, v);
    let c1 = 2.0 * h * (c.pull + v * (c.linear + v * (c.quadratic + v * c.cubic.x)));
    let c2 = h * h * (c.linear + v * (2.0 * c.quadratic + v * 3.0 * c.cubic.x));
    let c3 = h * h * h * (2.0 * c.quadratic + 6.0 * v * c.cubic.x) / 3.0;
    let c4 = 0.5 * h * h * h * h * c.cubic.x;
    let b1 = c0 + 0.25 * c1;
    let b2 = c0 + 0.5 * c1 + c2 / 6.0;
    let b3 = c0 + 0.75 * c1 + 0.5 * c2 + 0.25 * c3;
    let b4 = c0 + c1 + c2 + c3 + c4;
    return min(min(min(c0, b1), min(b2, b3)), b4) > 0.0;
}

fn trace(photon: Photon) -> Trace {
    var result = untraced();
    let n = scene.camera_direction;
    let a = scene.spin_length;
    let w0 = scene.camera_radius * photon.w;
    let scale = inverseSqrt(max(dot(w0, w0) + (ENERGY_WEIGHT - square(a * n.z)) * square(photon.energy), TINY));
    let energy = scale * photon.energy;
    let ae = a * energy;
    let w = scale * w0;
    let dragged = w - ae * vec3<f32>(-n.y, n.x, 0.0);
    let l = n.x * w.y - n.y * w.x;
    let across = n.x * dragged.y - n.y * dragged.x - ae * n.z * n.z;
    let kp = dot(dragged, dragged);
    let ray = Ray(energy, -a * across, kp, -2.0 * a * across * energy - kp, ae * ae);
    let u_horizon = scene.horizon_u;
    let u_inner = select(0.0, 1.0 / scene.disk_inner, HAS_DISK);
    let h = scene.mino_step;
    var base = 0.0;
    var y = vec2<f32>(1.0 / scene.camera_radius, n.z);
    var dy = vec2<f32>(scale * photon.radial, -w.z);
    var x = n.xy;
    var dx = -w.xy;
    var chi = 0.0;
    for (var i = 0u; i < MOST_STEPS; i++) {
        if SPINNING {
            if base == 0.0 && y.x > 0.5 * u_horizon {
                base = u_horizon;
                y.x = (y.x - u_horizon) - scene.horizon_u_rest;
            } else if base > 0.0 && y.x < -0.5 * u_horizon {
                base = 0.0;
                y.x = (y.x + scene.horizon_u_rest) + u_horizon;
            }
        }
        let u0 = y.x + base;
        let c = about(ray, base);
        if dy.x > 0.0 && (u0 >= u_horizon || (u0 >= u_inner || result.hit_count == 2u) && cannot_turn(c, ray.k, y.x, base, dy.x, u_horizon)) {
            result.outcome = OUTCOME_CAPTURED;
            break;
        }
        if !FOLLOW_BEYOND_HITS && result.hit_count == 2u {
            result.outcome = OUTCOME_HIDDEN;
            break;
        }
        if SPINNING && base > 0.0 {
            let w2 = square(w_at(c, y.x));
            let speed2 = w2 - ray.k * u0 * u0 * delta_at(c, y.x);
            if speed2 > 0.0625 * w2 {
                dy.x = select(-1.0, 1.0, dy.x > 0.0) * sqrt(speed2);
            }
        }
        let s = expand(c, y, dy, x, dx);
        result.steps += 1u;
        var t = h;
        let u_end = y_at(s, h).x + base;
        let escapes = dy.x < 0.0 && u_end <= 0.0;
        if escapes {
            t = h * u0 / (u0 - u_end);
            for (var j = 0u; j < 3u; j++) {
                t = clamp(t - (y_at(s, t).x + base) / dy_at(s, t).x, 0.0, h);
            }
        }
        let end = y_at(s, t);
        if y.y > 0.0 && end.y <= 0.0 || y.y < 0.0 && end.y >= 0.0 {
            var tc = t * y.y / (y.y - end.y);
            for (var j = 0u; j < 2u; j++) {
                tc = clamp(tc - y_at(s, tc).y / dy_at(s, tc).y, 0.0, t);
            }
            let u = y_at(s, tc).x + base;
            var place = x_at(s, tc);
            if DIAGNOSTICS && SPINNING {
                place = turned(place, sine_cosine(wrapped(chi + chi_over(c, s, tc))));
            }
            if in_annulus(1.0 / u) && result.hit_count < 2u {
                add_hit(&result, vec3<f32>(place * (inverseSqrt(max(dot(place, place), TINY)) / u), 0.0), photon.energy, l / energy);
            }
        }
        x = x_at(s, t);
        if SPINNING {
            chi = wrapped(chi + chi_over(c, s, t));
        }
        if escapes {
            if energy > 0.0 {
                result.outcome = OUTCOME_SKY;
                result.sky = safe_normalize(vec3<f32>(turned(x, sine_cosine(chi)), end.y));
            } else {
                result.outcome = OUTCOME_CAPTURED;
            }
            break;
        }
        dy = dy_at(s, t);
        dx = dx_at(s, t);
        y = end;
    }
    return result;
}
