// The delay of the method mino: dt/dtau = (1/u^2 + a^2) W/D - B + a^2 E n_z^2. On every stretch on
// which r does not turn (optics/delay.rs derives it)
//
//   delay = |r*(end) - r*(start)|
//       + integral of [K' (1 + a^2 u^2)/(W + |u'|) - B + a^2 E n_z^2] dtau.
//
// In the step in which r turns, |u'| has a kink, so the plain form is integrated; u is not small
// there.
//
// Gives: crossing_delay, first_delay, step_delay.

// The rate at the shares t of a step of length h.
fn rates_at(m: Motion, c: Curve, h: f32, turns: bool, t: Nodes) -> Nodes {
    let a2 = square(scene.hole.a);
    let v = c.c0.x + t * (c.c1.x + t * (c.c2.x + t * (c.c3.x + t * (c.c4.x + t * c.c5.x))));
    let n_z = c.c0.y + t * (c.c1.y + t * (c.c2.y + t * (c.c3.y + t * (c.c4.y + t * c.c5.y))));
    let u = m.base + v;
    let w = m.w.x + v * (m.w.y + v * m.w.z);
    let twist = a2 * m.constants.energy * n_z * n_z - m.constants.drag;
    if turns {
        let d = m.d.x + v * (m.d.y + v * m.d.z);
        return (1.0 + a2 * u * u) * w / max(u * u * d, Nodes(TINY)) + twist;
    }
    let speed = abs(c.c1.x + t * (2.0 * c.c2.x + t * (3.0 * c.c3.x + t * (4.0 * c.c4.x + t * (5.0 * c.c5.x)))));
    return m.constants.k_prime * (1.0 + a2 * u * u) / max(w + speed / h, Nodes(TINY)) + twist;
}

// The rate's integral over the first `share` of a step.
fn delay_integral(m: Motion, c: Curve, h: f32, turns: bool, share: f32) -> f32 {
    var sum = dot(DELAY_WEIGHTS, rates_at(m, c, h, turns, share * DELAY_NODES));
    if DELAY_MORE_NODES {
        sum += dot(DELAY_WEIGHTS_2, rates_at(m, c, h, turns, share * DELAY_NODES_2));
    }
    return h * share * sum;
}

// r* with its sign in the delay: positive at the end of an outgoing leg.
fn signed_tortoise(m: Motion, v: f32, inward: bool) -> f32 {
    let value = tortoise(m.base + v, horizon_factors(m.base, v));
    return select(value, -value, inward);
}

// The delay at the start of a ray, counted from the camera's outgoing time.
fn first_delay(inward: bool) -> f32 {
    return select(-2.0 * scene.observer.time_lead, 0.0, inward);
}

// The delay that a whole step adds. Where r turns, one leg ends and another one begins.
fn step_delay(m: Motion, step: Step, h: f32) -> f32 {
    let inward = vec2<bool>(step.dy0.x > 0.0, step.dy1.x > 0.0);
    let turns = inward.x != inward.y;
    var delay = delay_integral(m, curve(step), h, turns, 1.0);
    if turns {
        let ends = vec2<f32>(step.y0.x, step.y1.x);
        let legs = tortoise_sum(m.base + ends, horizon_factors(m.base, ends.x), horizon_factors(m.base, ends.y));
        delay += select(legs, -legs, inward.x);
    }
    return delay;
}

// The delay that the first `share` of a step adds, up to a crossing at v.
fn crossing_delay(m: Motion, step: Step, h: f32, share: f32, v: f32) -> f32 {
    let inward = step.dy0.x > 0.0;
    let turns = inward != (step.dy1.x > 0.0);
    let leg_end = select(v, step.y0.x, turns);
    return delay_integral(m, curve(step), h, turns, share) + signed_tortoise(m, leg_end, inward);
}
