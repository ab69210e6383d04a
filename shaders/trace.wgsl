// A photon at the camera and the record of its ray: what every method's `trace` takes and gives.
//
// Gives: Footprint, Footprints, Hit, OUTCOME_CAPTURED, OUTCOME_HIDDEN, OUTCOME_SKY,
//     OUTCOME_UNFINISHED, Photon, Segment, Trace, empty_trace.

// A photon where it meets the camera, per unit frequency there, as geometry/observer.rs has it.
struct Photon {
    // E = -p_t.
    energy: f32,
    // Sigma p^r / r^2.
    radial: f32,
    // (p_theta theta_hat + p_phi / sin(theta) phi_hat) / r, tangent to the celestial sphere at the
    // camera.
    w: vec3<f32>,
    // Without spin: positive for light from the horizon, zero at the edge of the shadow.
    shadow_margin: f32,
}

// The outcome of a ray: it ends at infinity; at the horizon; nowhere, because the method gave up;
// or (in pictures only) at the last crossing of the disk through which light is visible.
const OUTCOME_SKY: u32 = 0u;
const OUTCOME_CAPTURED: u32 = 1u;
const OUTCOME_UNFINISHED: u32 = 2u;
const OUTCOME_HIDDEN: u32 = 3u;

// The change of a value from this ray to its neighbours: of a hit's position, in r_s.
struct Footprint {
    to_the_right: vec3<f32>,
    downward: vec3<f32>,
}

// The footprints of a ray's two hits.
struct Footprints {
    first: Footprint,
    second: Footprint,
}

// A crossing of the disk's annulus.
struct Hit {
    // r n, where n points toward Boyer-Lindquist theta and phi.
    position: vec3<f32>,
    // Observed over emitted frequency.
    g: f32,
    // The time from the emission to the camera, less scene.observer.time_lead, which is most of a
    // far camera's delay and which the CPU adds in f64. Zero without DELAY.
    delay: f32,
}

struct Trace {
    // Unit vector toward the source at infinity if the outcome is the sky, else zero.
    sky: vec3<f32>,
    outcome: u32,
    // The first crossings along the backward ray, and their number.
    hits: array<Hit, 2>,
    hit_count: u32,
    steps: u32,
    // Largest normalized residual of the null constraint, and largest relative drift of the angular
    // momentum. Zero without DIAGNOSTICS.
    residual: f32,
    angular_momentum_drift: f32,
    // Angle swept about the hole, in radians, without frame dragging, up to the first crossing or
    // else to infinity; its whole half-turns are the order of the image. Zero if nothing is seen,
    // and, for stepping methods, without DIAGNOSTICS.
    turn: f32,
}

// One step of a ray: positions and velocities at its ends, and its affine length. With DELAY, also
// the delay at its start and its rates at the ends.
struct Segment {
    x0: vec3<f32>,
    v0: vec3<f32>,
    x1: vec3<f32>,
    v1: vec3<f32>,
    h: f32,
    delay: f32,
    delay_rates: vec2<f32>,
}

// The record of a ray that has met nothing yet.
fn empty_trace() -> Trace {
    let no_hit = Hit(vec3<f32>(0.0), 0.0, 0.0);
    return Trace(vec3<f32>(0.0), OUTCOME_UNFINISHED, array<Hit, 2>(no_hit, no_hit), 0u, 0u, 0.0, 0.0, 0.0);
}
