// The motion in latitude of the method closed around a spinning hole. With n = n_z, K_0 =
// K - a^2 E^2 and the largest square m of n,
//
//   n'^2 = Q - K_0 n^2 - a^2 E^2 n^4 = (m - n^2) rho^2,   rho^2 = K_+ + a^2 E^2 n^2,
//   K_+ = K_0 + a^2 E^2 m,   n = sqrt(m) sin(psi),   psi' = rho.
//
// So the ray moves along a great circle by Jacobi's amplitude psi, and the circle turns about the
// axis. On the circle the azimuth changes by -(L/rho_1)/(1 - n^2) per psi, with rho_1^2 = K_+ + a^2
// E^2, because L^2 = (1 - m) rho_1^2. The ray's azimuth changes by -(L/rho)/(1 - n^2). Since
// rho_1^2 - rho^2 = a^2 E^2 (1 - n^2), the difference has no pole at the axis: the circle turns by
//
//   -(L a^2 E^2/rho_1) integral of dtau/(rho + rho_1).
//
// psi and this integral are short series in the phase, because the modulus is small. Derived.
//
// Gives: arc_after, place_after, polar_of.

// Rays with a larger a^2 E^2 m/K_+ pass next to the axis and are integrated by steps.
const MAX_MODULUS: f32 = 0.25;
const MAX_AXIAL_STEPS: u32 = 64u;
const AXIAL_STEP: f32 = 0.2;

struct Polar {
    n: vec3<f32>,
    dn: vec3<f32>,
    k: f32,
    k_plus: f32,
    axial: f32,
    angular_momentum: f32,
    // Whether the ray crosses the plane, the time of its first crossing, and the time between
    // crossings.
    crosses: bool,
    first_crossing: f32,
    period: f32,
    // Whether the ray moves along a great circle; then the circle's direction, rho_1, the rate of
    // the phase, its lead over psi, and sin and cos of 2 psi, all at the camera.
    on_circle: bool,
    tangent: vec3<f32>,
    rho_axis: f32,
    rate: f32,
    lead: f32,
    double_psi: vec2<f32>,
    nome: f32,
}

// (sin, cos) of the sum of two angles.
fn add_angles(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(a.x * b.y + a.y * b.x, a.y * b.y - a.x * b.x);
}

// (sin, cos) of an angle below 0.2.
fn small_sin_cos(x: f32) -> vec2<f32> {
    let y = x * x;
    return vec2<f32>(x * (1.0 - y * (1.0 / 6.0) * (1.0 - 0.05 * y)), 1.0 - 0.5 * y * (1.0 - y * (1.0 / 12.0)));
}

fn polar_of(n: vec3<f32>, dn: vec3<f32>, k: f32, angular_momentum: f32, c: PhotonConstants) -> Polar {
    let z2 = n.z * n.z;
    let axial = c.axial;
    let k_0 = -c.stiffness;
    // Carter's Q, without a difference of large numbers next to the plane.
    var q = k - angular_momentum * angular_momentum;
    if z2 < 0.5 {
        q = (dn.z * dn.z + square(angular_momentum) * z2) / (1.0 - z2) - axial * z2;
    }
    let root = sqrt(max(k_0 * k_0 + 4.0 * axial * q, 0.0));
    let k_plus = select(2.0 * axial * q / max(root - k_0, TINY), 0.5 * (k_0 + root), k_0 > 0.0);
    let tilt = max(k_plus - k_0, 0.0);
    var polar: Polar;
    polar.n = n;
    polar.dn = dn;
    polar.k = k;
    polar.k_plus = k_plus;
    polar.axial = axial;
    polar.angular_momentum = angular_momentum;
    polar.crosses = k_plus > 0.0 && !(n.z == 0.0 && dn.z == 0.0);
    let rho = sqrt(max(k_plus + axial * z2, TINY));
    let height = abs(n.z);
    let fall = select(-dn.z, dn.z, n.z < 0.0);
    polar.on_circle = k_plus > 0.0 && tilt <= MAX_MODULUS * k_plus;
    // These numbers are not used for rays off a circle.
    let circle = max(k_plus, TINY);
    polar.rho_axis = sqrt(circle + axial);
    let turned = angular_momentum * axial / (rho * polar.rho_axis * (rho + polar.rho_axis));
    polar.tangent = dn / rho + turned * vec3<f32>(-n.y, n.x, 0.0);
    let slow = sqrt(circle);
    let fast = sqrt(circle + tilt);
    let r = tilt / square(slow + fast);
    let r2 = r * r;
    let c_0 = 1.0 + r2 * (0.25 + 0.140625 * r2);
    polar.rate = 0.5 * (slow + fast) / c_0;
    polar.nome = 0.25 * r * (1.0 + r2 * (0.25 + 0.1328125 * r2));
    // sin and cos of psi, of which the sine is n_z/sqrt(m).
    let across = vec2<f32>(n.z * rho, dn.z);
    let psi = across * inverseSqrt(max(dot(across, across), TINY));
    let double = vec2<f32>(2.0 * psi.x * psi.y, psi.y * psi.y - psi.x * psi.x);
    let fourfold = vec2<f32>(2.0 * double.x * double.y, double.y * double.y - double.x * double.x);
    let sixfold = add_angles(double, fourfold).x;
    let eightfold = 2.0 * fourfold.x * fourfold.y;
    polar.double_psi = double;
    let high = sixfold * (0.10416667 + 0.0455729 * r2) + r * eightfold * 0.068359375;
    let low = double.x * (0.5 + r2 * (0.1875 + 0.1171875 * r2)) + r * fourfold.x * (0.1875 + 0.078125 * r2);
    polar.lead = r * (low + r2 * high) / c_0;
    let to_plane = select(atan2_precise(height * rho, fall), PI, n.z == 0.0);
    // In the plane the phase is psi.
    polar.first_crossing = (to_plane - polar.lead) / polar.rate;
    polar.period = PI / polar.rate;
    if !polar.on_circle {
        // m = n_z^2 + n_z'^2/rho^2, and the times are R_F.
        let climb2 = dn.z * dn.z / (rho * rho);
        let m = max(z2 + climb2, TINY);
        let share = height * inverseSqrt(m);
        let mean = 0.5 * (rho * rho + k_plus);
        let fall_time = share * carlson_rf_pair(max(climb2 * k_plus / m, TINY), mean, square(0.5 * axial * z2));
        let quarter = carlson_rf_pair(TINY, k_plus + 0.5 * axial * m, square(0.5 * axial * m));
        polar.first_crossing = select(2.0 * quarter - fall_time, fall_time, fall > 0.0 && n.z != 0.0);
        polar.period = 2.0 * quarter;
        polar.rate = select(sqrt(max(k, 0.0)), PI / polar.period, polar.crosses);
    }
    return polar;
}

// The turn of the great circle about the axis after the phase has grown by `grown`, with the sines
// of 2 and 4 times the phase at both ends.
fn circle_turn(p: Polar, grown: f32, sines_0: vec2<f32>, sines_1: vec2<f32>) -> f32 {
    let share = p.rate / (p.rho_axis + p.rate);
    let y_1 = -4.0 * p.nome * share;
    let y_2 = 4.0 * p.nome * p.nome * share;
    let change = sines_1 - sines_0;
    let sum = (1.0 + 0.5 * y_1 * y_1) * grown - 0.5 * (y_1 + 0.75 * y_1 * y_1 * y_1) * change.x
        + 0.25 * (0.5 * y_1 * y_1 - y_2) * change.y;
    return -p.angular_momentum * p.axial / (p.rho_axis * (p.rho_axis + p.rate) * p.rate) * sum;
}

// The integral of rho^2 = (dpsi/dtau)^2 over the same growth.
fn circle_height(p: Polar, grown: f32, sines_0: vec2<f32>, sines_1: vec2<f32>) -> f32 {
    // dpsi/dphase = 1 + c_2 cos 2 phase + c_4 cos 4 phase.
    let q2 = p.nome * p.nome;
    let c_2 = -4.0 * p.nome * (1.0 - q2);
    let c_4 = 4.0 * q2;
    let change = sines_1 - sines_0;
    let mean = 1.0 + 0.5 * (c_2 * c_2 + c_4 * c_4);
    let sum = mean * grown + c_2 * (1.0 + 0.5 * c_4) * change.x + (0.5 * c_4 + 0.125 * c_2 * c_2) * change.y;
    return p.rate * sum;
}

// The sines of 2 and 4 times the phase at the camera.
fn first_sines(p: Polar) -> vec3<f32> {
    let phase = add_angles(p.double_psi, small_sin_cos(2.0 * p.lead));
    return vec3<f32>(phase, 2.0 * phase.x * phase.y);
}

// Next to the axis: Nystroem's rule of fifth order (mino_motion.wgsl).
fn axial_acceleration(p: Polar, n: vec3<f32>) -> vec3<f32> {
    let pull = p.k + 2.0 * p.axial * n.z * n.z;
    return vec3<f32>(0.0, 0.0, p.axial * n.z) - pull * n;
}

// The place after the time t, and the integral of n_z^2 up to then.
fn step_along_axis(p: Polar, t: f32) -> vec4<f32> {
    let angle = t * sqrt(abs(p.k) + 2.0 * p.axial);
    let steps = clamp(u32(ceil(angle / AXIAL_STEP)), 1u, MAX_AXIAL_STEPS);
    let h = t / f32(steps);
    let h2 = h * h;
    var n = p.n;
    var dn = h * p.dn;
    var height2 = 0.0;
    for (var i = 0u; i < steps; i++) {
        let k1 = h2 * axial_acceleration(p, n);
        let k2 = h2 * axial_acceleration(p, n + 0.2 * dn + 0.02 * k1);
        let k3 = h2 * axial_acceleration(p, n + (2.0 / 3.0) * dn + ((7.0 / 27.0) * k2 - (1.0 / 27.0) * k1));
        let k4 = h2 * axial_acceleration(p, n + dn + 0.3 * k1 + ((9.0 / 35.0) * k3 - (2.0 / 35.0) * k2));
        let first = vec2<f32>(n.z * n.z, 2.0 * n.z * dn.z);
        n += dn + ((14.0 / 336.0) * k1 + (100.0 / 336.0) * k2 + (54.0 / 336.0) * k3);
        dn += (14.0 / 336.0) * k1 + (125.0 / 336.0) * k2 + (162.0 / 336.0) * k3 + (35.0 / 336.0) * k4;
        // The Euler-Maclaurin rule.
        height2 += h * (0.5 * (first.x + n.z * n.z) + (first.y - 2.0 * n.z * dn.z) * (1.0 / 12.0));
    }
    return vec4<f32>(n, height2);
}

fn rotate_about_axis(n: vec3<f32>, angle: f32) -> vec3<f32> {
    return vec3<f32>(rotate_z(n.xy, sin_cos_precise(angle)), n.z);
}

// A ray's place on the celestial sphere after some time.
struct SpherePlace {
    n: vec3<f32>,
    // The integral of a^2 E^2 n_z^2 up to then.
    height2: f32,
}

// The place after the time t, with the azimuth that the radial motion has dragged.
fn place_after(p: Polar, t: f32, dragging: f32) -> SpherePlace {
    if !p.on_circle {
        let along_axis = step_along_axis(p, t);
        return SpherePlace(rotate_about_axis(along_axis.xyz, dragging), p.axial * along_axis.w);
    }
    let grown = p.rate * t;
    let sweep = sin_cos_precise(grown);
    let start = first_sines(p);
    let end = add_angles(start.xy, vec2<f32>(2.0 * sweep.x * sweep.y, sweep.y * sweep.y - sweep.x * sweep.x));
    let fourfold = vec2<f32>(2.0 * end.x * end.y, end.y * end.y - end.x * end.x);
    let sixfold = add_angles(end, fourfold).x;
    let q = p.nome;
    let q2 = q * q;
    let lag = p.lead + (-2.0 * q * (1.0 - q2)) * end.x + q2 * fourfold.x - (2.0 / 3.0) * q * q2 * sixfold;
    let swept = add_angles(sweep, small_sin_cos(lag));
    let circle = circle_turn(p, grown, vec2<f32>(start.x, start.z), vec2<f32>(end.x, fourfold.x));
    var height2 = 0.0;
    if DELAY || DIAGNOSTICS {
        let sines = vec2<f32>(end.x, fourfold.x);
        height2 = circle_height(p, grown, vec2<f32>(start.x, start.z), sines) - p.k_plus * t;
    }
    return SpherePlace(rotate_about_axis(swept.y * p.n + swept.x * p.tangent, dragging + circle), height2);
}

// The arc that the ray has swept about the hole after the time t: the integral of |dn/dtau| =
// sqrt(K + a^2 E^2 n_z^2), which is nearly constant.
fn arc_after(p: Polar, t: f32) -> f32 {
    return sqrt(max(t * (p.k * t + place_after(p, t, 0.0).height2), 0.0));
}
