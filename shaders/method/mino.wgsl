const MOST_STEPS: u32 = 1024u;

struct Constants {
    a: f32,
    axial: f32,
    cubic: f32,
    quartic: vec2<f32>,
    a2: f32,
    swirl: f32,
    swirl_quadratic: f32,
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
    x0: vec2<f32>,
    x1: vec2<f32>,
    x2: vec2<f32>,
    x3: vec2<f32>,
    x4: vec2<f32>,
    x5: vec2<f32>,
    x6: vec2<f32>,
    x7: vec2<f32>,
    x8: vec2<f32>,
    w0: f32,
    w1: f32,
    w2: f32,
    w3: f32,
    w4: f32,
    w5: f32,
    w6: f32,
    w7: f32,
}
fn expand(c: Constants, y0: vec2<f32>, y1: vec2<f32>, x0: vec2<f32>, x1: vec2<f32>) -> Series {
    let s0 = y0 * y0;
    let p0 = vec2<f32>(c.a + c.cubic * y0.x, c.a) + c.quartic * s0;
    let q0 = p0.y - c.axial;
    let y2 = (p0 * y0) * 0.5;
    let x2 = (q0 * x0) * 0.5;
    let s1 = 2.0 * y0 * y1;
    let p1 = vec2<f32>(c.cubic * y1.x, 0.0) + c.quartic * s1;
    let y3 = (p0 * y1 + p1 * y0) * 0.16666666666666666;
    let x3 = (q0 * x1 + p1.y * x0) * 0.16666666666666666;
    let s2 = 2.0 * y0 * y2 + y1 * y1;
    let p2 = vec2<f32>(c.cubic * y2.x, 0.0) + c.quartic * s2;
    let y4 = (p0 * y2 + p1 * y1 + p2 * y0) * 0.08333333333333333;
    let x4 = (q0 * x2 + p1.y * x1 + p2.y * x0) * 0.08333333333333333;
    let s3 = 2.0 * (y0 * y3 + y1 * y2);
    let p3 = vec2<f32>(c.cubic * y3.x, 0.0) + c.quartic * s3;
    let y5 = (p0 * y3 + p1 * y2 + p2 * y1 + p3 * y0) * 0.05;
    let x5 = (q0 * x3 + p1.y * x2 + p2.y * x1 + p3.y * x0) * 0.05;
    let s4 = 2.0 * (y0 * y4 + y1 * y3) + y2 * y2;
    let p4 = vec2<f32>(c.cubic * y4.x, 0.0) + c.quartic * s4;
    let y6 = (p0 * y4 + p1 * y3 + p2 * y2 + p3 * y1 + p4 * y0) * 0.03333333333333333;
    let x6 = (q0 * x4 + p1.y * x3 + p2.y * x2 + p3.y * x1 + p4.y * x0) * 0.03333333333333333;
    let s5 = 2.0 * (y0 * y5 + y1 * y4 + y2 * y3);
    let p5 = vec2<f32>(c.cubic * y5.x, 0.0) + c.quartic * s5;
    let y7 = (p0 * y5 + p1 * y4 + p2 * y3 + p3 * y2 + p4 * y1 + p5 * y0) * 0.023809523809523808;
    let x7 = (q0 * x5 + p1.y * x4 + p2.y * x3 + p3.y * x2 + p4.y * x1 + p5.y * x0) * 0.023809523809523808;
    let s6 = 2.0 * (y0 * y6 + y1 * y5 + y2 * y4) + y3 * y3;
    let p6 = vec2<f32>(c.cubic * y6.x, 0.0) + c.quartic * s6;
    let y8 = (p0 * y6 + p1 * y5 + p2 * y4 + p3 * y3 + p4 * y2 + p5 * y1 + p6 * y0) * 0.017857142857142856;
    let x8 = (q0 * x6 + p1.y * x5 + p2.y * x4 + p3.y * x3 + p4.y * x2 + p5.y * x1 + p6.y * x0) * 0.017857142857142856;
    if SPINNING {
        let d0 = 1.0 - y0.x + c.a2 * s0.x;
        let inverse = 1.0 / d0;
        let w0 = (c.swirl_quadratic * s0.x - c.swirl * y0.x) * inverse;
        let d1 = -y1.x + c.a2 * s1.x;
        let w1 = (c.swirl_quadratic * s1.x - c.swirl * y1.x - (d1 * w0)) * inverse;
        let d2 = -y2.x + c.a2 * s2.x;
        let w2 = (c.swirl_quadratic * s2.x - c.swirl * y2.x - (d1 * w1 + d2 * w0)) * inverse;
        let d3 = -y3.x + c.a2 * s3.x;
        let w3 = (c.swirl_quadratic * s3.x - c.swirl * y3.x - (d1 * w2 + d2 * w1 + d3 * w0)) * inverse;
        let d4 = -y4.x + c.a2 * s4.x;
        let w4 = (c.swirl_quadratic * s4.x - c.swirl * y4.x - (d1 * w3 + d2 * w2 + d3 * w1 + d4 * w0)) * inverse;
        let d5 = -y5.x + c.a2 * s5.x;
        let w5 = (c.swirl_quadratic * s5.x - c.swirl * y5.x - (d1 * w4 + d2 * w3 + d3 * w2 + d4 * w1 + d5 * w0)) * inverse;
        let d6 = -y6.x + c.a2 * s6.x;
        let w6 = (c.swirl_quadratic * s6.x - c.swirl * y6.x - (d1 * w5 + d2 * w4 + d3 * w3 + d4 * w2 + d5 * w1 + d6 * w0)) * inverse;
        let s7 = 2.0 * (y0 * y7 + y1 * y6 + y2 * y5 + y3 * y4);
        let d7 = -y7.x + c.a2 * s7.x;
        let w7 = (c.swirl_quadratic * s7.x - c.swirl * y7.x - (d1 * w6 + d2 * w5 + d3 * w4 + d4 * w3 + d5 * w2 + d6 * w1 + d7 * w0)) * inverse;
        return Series(y0, y1, y2, y3, y4, y5, y6, y7, y8, x0, x1, x2, x3, x4, x5, x6, x7, x8, w0 * 1.0, w1 * 0.5, w2 * 0.3333333333333333, w3 * 0.25, w4 * 0.2, w5 * 0.16666666666666666, w6 * 0.14285714285714285, w7 * 0.125);
    }
    return Series(y0, y1, y2, y3, y4, y5, y6, y7, y8, x0, x1, x2, x3, x4, x5, x6, x7, x8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
}
fn y_at(s: Series, t: f32) -> vec2<f32> { return ((((((((s.y8) * t + s.y7) * t + s.y6) * t + s.y5) * t + s.y4) * t + s.y3) * t + s.y2) * t + s.y1) * t + s.y0; }
fn dy_at(s: Series, t: f32) -> vec2<f32> { return (((((((8.0 * s.y8) * t + 7.0 * s.y7) * t + 6.0 * s.y6) * t + 5.0 * s.y5) * t + 4.0 * s.y4) * t + 3.0 * s.y3) * t + 2.0 * s.y2) * t + s.y1; }
fn x_at(s: Series, t: f32) -> vec2<f32> { return ((((((((s.x8) * t + s.x7) * t + s.x6) * t + s.x5) * t + s.x4) * t + s.x3) * t + s.x2) * t + s.x1) * t + s.x0; }
fn dx_at(s: Series, t: f32) -> vec2<f32> { return (((((((8.0 * s.x8) * t + 7.0 * s.x7) * t + 6.0 * s.x6) * t + 5.0 * s.x5) * t + 4.0 * s.x4) * t + 3.0 * s.x3) * t + 2.0 * s.x2) * t + s.x1; }
fn chi_at(s: Series, t: f32) -> f32 { return ((((((((s.w7) * t + s.w6) * t + s.w5) * t + s.w4) * t + s.w3) * t + s.w2) * t + s.w1) * t + s.w0) * t; }

fn cannot_turn(c: Constants, e2: f32, low: f32, high: f32) -> bool {
    // c_k of U in powers of (u - low) / (to - low)
    let quartic = 0.5 * c.quartic.x;
    let cubic = c.cubic * (2.0 / 3.0);
    let h = high - low;
    let u2 = low * low;
    let c0 = e2 + u2 * (c.a + low * (cubic + low * quartic));
    let c1 = h * low * (2.0 * c.a + low * (3.0 * cubic + 4.0 * low * quartic));
    let c2 = h * h * (c.a + low * (3.0 * cubic + 6.0 * low * quartic));
    let c3 = h * h * h * (cubic + 4.0 * low * quartic);
    let c4 = h * h * h * h * quartic;
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
    let scale = inverseSqrt(max(dot(w0, w0) + (1.0 + a * a * (1.0 - n.z * n.z)) * square(photon.energy), TINY));
    let energy = scale * photon.energy;
    let ae = a * energy;
    let w = scale * w0;
    let dragged = w - ae * vec3<f32>(-n.y, n.x, 0.0);
    let l = n.x * w.y - n.y * w.x;
    let k = dot(w, w) - square(ae * n.z);
    let c = Constants(ae * ae - k, ae * ae, 1.5 * dot(dragged, dragged),
        vec2<f32>(-2.0 * a * a * (k - l * l), -2.0 * ae * ae), a * a, ae, a * a * l);
    let e2 = energy * energy;
    let u_horizon = 1.0 / scene.horizon;
    let u_inner = select(0.0, 1.0 / scene.disk_inner, HAS_DISK);
    let h = scene.mino_step;
    var y = vec2<f32>(1.0 / scene.camera_radius, n.z);
    var dy = vec2<f32>(scale * photon.radial, -w.z);
    var x = n.xy;
    var dx = -w.xy;
    var chi = 0.0;
    for (var i = 0u; i < MOST_STEPS; i++) {
        if dy.x > 0.0 && (y.x >= u_horizon || (y.x >= u_inner || result.hit_count == 2u) && cannot_turn(c, e2, y.x, u_horizon)) {
            result.outcome = OUTCOME_CAPTURED;
            break;
        }
        if !FOLLOW_BEYOND_HITS && result.hit_count == 2u {
            result.outcome = OUTCOME_HIDDEN;
            break;
        }
        let s = expand(c, y, dy, x, dx);
        result.steps += 1u;
        var t = h;
        let u_end = y_at(s, h).x;
        let escapes = dy.x < 0.0 && u_end <= 0.0;
        if escapes {
            t = h * y.x / (y.x - u_end);
            for (var j = 0u; j < 3u; j++) {
                t = clamp(t - y_at(s, t).x / dy_at(s, t).x, 0.0, h);
            }
        }
        let end = y_at(s, t);
        if y.y > 0.0 && end.y <= 0.0 || y.y < 0.0 && end.y >= 0.0 {
            var tc = t * y.y / (y.y - end.y);
            for (var j = 0u; j < 2u; j++) {
                tc = clamp(tc - y_at(s, tc).y / dy_at(s, tc).y, 0.0, t);
            }
            let u = y_at(s, tc).x;
            var place = x_at(s, tc);
            if DIAGNOSTICS && SPINNING {
                place = turned(place, sine_cosine(chi + chi_at(s, tc)));
            }
            if in_annulus(1.0 / u) && result.hit_count < 2u {
                add_hit(&result, vec3<f32>(place * (inverseSqrt(max(dot(place, place), TINY)) / u), 0.0), photon.energy, l / energy);
            }
        }
        x = x_at(s, t);
        if SPINNING {
            chi += chi_at(s, t);
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
