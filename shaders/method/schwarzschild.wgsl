// The orbits of the method closed: Schwarzschild's null geodesics in closed form. The twin in f64
// is geometry/schwarzschild/rain_sky.rs. With u = 1/r and phi the angle from the camera (Darwin
// 1959),
//
//   (du/dphi)^2 = f(u) = q - u^2 + u^3,   q = 1/b^2.
//
// Rays with D = b_c^2 q - 1 < 0, b_c^2 = 27/4, turn; rays with D > 0 do not. For every D the cubic
// has one root -k < 0, k^2 (1 + k) = q; the others are (1 + k)/2 +- sqrt(v)/2 with
//
//   v = (1 + k)(1 - 3 k) = -4 D (1 + k) / (2 + 3 k)^2,
//
// a conjugate pair where D > 0. Computed from D, v is accurate next to the critical curve. Derived.
//
// Gives: Orbit, angle_to_infinity, orbit_g3, orbit_root, u_after.

struct Orbit {
    // u and du/dphi at the camera, with phi along the backward ray.
    u: f32,
    slope: f32,
    // 1/b, 1/b^2, b_c^2/b^2 - 1.
    inverse_b: f32,
    q: f32,
    discriminant: f32,
}

// k: minimax polynomials in 1/b or its power -2/3, within 4e-4, then one step of Newton's method.
fn orbit_root(inverse_b: f32, q: f32) -> f32 {
    let x = inverse_b;
    var k = x * (0.99991836 + x * (-0.49241213 + x * (0.50929576 - x * 0.34869361)));
    if inverse_b >= 0.385 {
        let s = exp2(log2(inverse_b) * (-2.0 / 3.0));
        k = q * s * s * (0.99962648 + s * (-0.32762602 + s * (0.09698567 - s * 0.01438903)));
    }
    return (k * k * (2.0 * k + 1.0) + q) / (k * (3.0 * k + 2.0));
}

// The angle phi from the camera to infinity of a ray that escapes. Each section of the orbit is one
// R_F (DLMF 19.29.4):
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

// g3 of Weierstrass's function. Rays with larger q are straight.
fn orbit_g3(orbit: Orbit) -> f32 {
    return (1.0 / 216.0) - 0.0625 * min(orbit.q, 1e4);
}

// u at the angle phi after a place with u0, du/dphi: Biermann's and Weierstrass's solution of
// (du/dphi)^2 = f(u) (Whittaker & Watson 1927 section 20.6), with P = P(phi; g2, g3), g2 = 1/12, g3
// = 1/216 - q/16, x0 = (u0 - 1/3)/4:
//
//   u = u0 + (-P' du/dphi + f'(u0) (P - x0)/2 + f(u0)/4) / (2 (P - x0)^2)
//
// It holds through turning points and for either sign of D.
fn u_after(phi: f32, u0: f32, slope: f32, g3: f32) -> f32 {
    let p = weierstrass(phi, g3);
    let phi2 = phi * phi;
    let x = 1.0 + p.even - phi2 * 0.25 * (u0 - (1.0 / 3.0));
    let rise = phi * slope;
    let numerator = rise * (1.0 + p.odd + 0.125 * phi2 * rise) + 0.25 * phi2 * u0 * (3.0 * u0 - 2.0) * x;
    return u0 + numerator / (x * x);
}
