// The delay of the method closed. The Hamilton-Jacobi action is constant along a null ray, so E dt
// = L dphi + p_r dr. With s(u) = sqrt(1 - b^2 u^2 (1 - u)) = b |du/dphi|, it is b phi plus, for
// each leg between u_a < u_b, which ends at the turning point u2,
//
//   |r*(u_a) - r*(u_b)| - b^2 J(u_a, u_b),   J(u_a, u_b) = integral of du/(1 + s(u)).
//
// The integrand lies between 1/2 and 1, so a few Gauss-Legendre nodes suffice. Derived.
//
// Gives: crossing_delay.

// u of the photon sphere, where s of rays next to the critical curve has a kink.
const PHOTON_SPHERE: f32 = 2.0 / 3.0;
// The square roots of the distance at which a leg that ends at the photon sphere is divided. With
// three parts, the delays of a camera at 0.1 r_s are accurate to 4e-4 r_s/c.
const DIVISIONS: vec2<f32> = vec2<f32>(0.1, 0.4);

// The turning point u2, and the cubic's other roots: -k, and u2 + gap.
struct Turn {
    u2: f32,
    k: f32,
    gap: f32,
}

fn turn_of(orbit: Orbit) -> Turn {
    let k = orbit_root(orbit.inverse_b, orbit.q);
    let t = 2.0 + 3.0 * k;
    let gap = sqrt(max(-4.0 * orbit.discriminant * (1.0 + k), 0.0)) / t;
    return Turn(2.0 * k * (1.0 + k) / (1.0 + k + gap), k, gap);
}

// x/(1 + s) at u = u2 - span x^2.
fn turning_terms(turn: Turn, b: f32, span: f32, x: Nodes) -> Nodes {
    let depth = span * x * x;
    let s = b * x * sqrt(span * max((turn.gap + depth) * (turn.u2 + turn.k - depth), Nodes(0.0)));
    return x / (1.0 + s);
}

// J on one side of the turning point: u = u2 - (u2 - u_a) x^2 removes the root of s.
fn turning_leg(turn: Turn, b: f32, u_a: f32, u_b: f32) -> f32 {
    let span = max(turn.u2 - u_a, TINY);
    let start = sqrt(clamp((turn.u2 - u_b) / span, 0.0, 1.0));
    let width = 1.0 - start;
    var sum = dot(DELAY_WEIGHTS, turning_terms(turn, b, span, start + width * DELAY_NODES));
    if DELAY_MORE_NODES {
        sum += dot(DELAY_WEIGHTS_2, turning_terms(turn, b, span, start + width * DELAY_NODES_2));
    }
    return 2.0 * span * width * sum;
}

// 1/(1 + s) of a ray that does not turn, without the cancellation in q - u^2 (1 - u) next to the
// critical curve.
fn through_terms(orbit: Orbit, u: Nodes) -> Nodes {
    let off = u - PHOTON_SPHERE;
    let f = (4.0 / 27.0) * orbit.discriminant + off * off * (u + (1.0 / 3.0));
    return 1.0 / (1.0 + sqrt(max(f, Nodes(0.0))) / orbit.inverse_b);
}

// J of a ray that does not turn, from u_a to u_b on one side of the photon sphere.
fn smooth_leg(orbit: Orbit, u_a: f32, u_b: f32) -> f32 {
    let width = u_b - u_a;
    var sum = dot(DELAY_WEIGHTS, through_terms(orbit, u_a + width * DELAY_NODES));
    if DELAY_MORE_NODES {
        sum += dot(DELAY_WEIGHTS_2, through_terms(orbit, u_a + width * DELAY_NODES_2));
    }
    return width * sum;
}

// J over the part from x_a to x_b of the leg from the photon sphere, u = 2/3 + distance x^2.
fn kinked_part(orbit: Orbit, distance: f32, x_a: f32, x_b: f32) -> f32 {
    let x = x_a + (x_b - x_a) * DELAY_NODES;
    var sum = dot(DELAY_WEIGHTS, x * through_terms(orbit, PHOTON_SPHERE + distance * x * x));
    if DELAY_MORE_NODES {
        let more = x_a + (x_b - x_a) * DELAY_NODES_2;
        sum += dot(DELAY_WEIGHTS_2, more * through_terms(orbit, PHOTON_SPHERE + distance * more * more));
    }
    return 2.0 * abs(distance) * (x_b - x_a) * sum;
}

fn kinked_leg(orbit: Orbit, u: f32) -> f32 {
    let distance = u - PHOTON_SPHERE;
    let near = kinked_part(orbit, distance, 0.0, DIVISIONS.x) + kinked_part(orbit, distance, DIVISIONS.x, DIVISIONS.y);
    return near + kinked_part(orbit, distance, DIVISIONS.y, 1.0);
}

fn through_leg(orbit: Orbit, u_a: f32, u_b: f32) -> f32 {
    if u_a < PHOTON_SPHERE && u_b > PHOTON_SPHERE {
        return kinked_leg(orbit, u_a) + kinked_leg(orbit, u_b);
    }
    return smooth_leg(orbit, u_a, u_b);
}

// Whether the ray has turned between the camera and u at the angle phi. The addition theorem for
// Weierstrass's function (Whittaker & Watson 1927 section 20.312) gives the slope there from the
// slope at the camera:
//
//   du/dphi = -du/dphi_0 - (u - u0) (P' - du/dphi_0/4)/(P - x0),   x0 = (u0 - 1/3)/4.
fn has_turned(orbit: Orbit, phi: f32, u: f32) -> bool {
    let p = weierstrass(phi, orbit_g3(orbit));
    let x = 1.0 + p.even - phi * phi * 0.25 * (orbit.u - (1.0 / 3.0));
    let chord = -(2.0 * (1.0 + p.odd) + 0.25 * phi * phi * phi * orbit.slope);
    return orbit.slope * phi * x + (u - orbit.u) * chord > 0.0;
}

// The delay of light from u, at the angle phi from the camera, less the camera's time_lead. Inside
// the horizon the clock is the ingoing time, and the lead is zero.
fn crossing_delay(orbit: Orbit, phi: f32, u: f32, on_way_out: bool) -> f32 {
    let b = 1.0 / orbit.inverse_b;
    let at_hit = tortoise(u, vec2<f32>(1.0 - u, 1.0));
    if orbit.discriminant < 0.0 {
        let turn = turn_of(orbit);
        if orbit.slope <= 0.0 {
            return b * (phi - b * turning_leg(turn, b, u, orbit.u)) + at_hit - 2.0 * scene.observer.time_lead;
        }
        if on_way_out || has_turned(orbit, phi, u) {
            let legs = turning_leg(turn, b, orbit.u, turn.u2) + turning_leg(turn, b, u, turn.u2);
            return b * (phi - b * legs) + at_hit - 2.0 * tortoise(turn.u2, vec2<f32>(1.0 - turn.u2, 1.0));
        }
        return b * (phi - b * turning_leg(turn, b, orbit.u, u)) - at_hit;
    }
    if orbit.slope > 0.0 {
        return b * (phi - b * through_leg(orbit, orbit.u, u)) - at_hit;
    }
    return b * (phi - b * through_leg(orbit, u, orbit.u)) + at_hit - 2.0 * scene.observer.time_lead;
}
