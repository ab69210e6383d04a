// What reaches the camera along a ray through matter with depth, by the steps of the method mino. The
// scene's matter adds its part of each step: medium/matter has a file for each kind of scene.
// optics/medium has the equations, and the twin in f64.
//
// Gives: Passage, Way, hides, passage.

// A ray ends when the brightest light behind would add less than this share of the light in front: where the
// front is dark, a bright ring still shows through it.
const HIDDEN_SHARE: f32 = 0.05;
// The share of light that counts as none.
const NO_TRANSMISSION: f32 = 1e-6;

struct Passage {
    // The light of the medium, and the share of the light from behind that comes through it.
    light: vec3<f32>,
    transmission: f32,
    // Outcome and sky of the ray, and its steps.
    ray: Trace,
    // The number of nodes at which the matter was asked for its light.
    samples: u32,
}

// A step of a ray: its path, and what the ray had at its start.
struct Way {
    path: Curve,
    step: Step,
    motion: Motion,
    h: f32,
    chi: Angle,
    delay: f32,
    ingoing: bool,
    // Whether r does not turn within the step, next to the horizon.
    regular: bool,
    neighbours: Neighbours,
}

// Whether what a ray has met hides what is behind.
fn hides(seen: Passage) -> bool {
    let light = max(seen.light.r, max(seen.light.g, seen.light.b));
    let dim = seen.transmission * brightest_light() < HIDDEN_SHARE * light;
    return seen.transmission < NO_TRANSMISSION || seen.transmission < MIN_TRANSMISSION && dim;
}

// Whether a ray can only end in the hole, and meets nothing before.
fn ends_in_hole(ray: Ray) -> bool {
    let u = ray.motion.base + ray.y.x;
    let u_horizon = scene.hole.horizon_u;
    let inside = is_within_matter(u);
    return ray.dy.x > 0.0 && (u >= u_horizon || inside && cannot_turn(ray.motion, ray.y.x, u_horizon - u));
}

fn passage(photon: Photon) -> Passage {
    var result = Passage(vec3<f32>(0.0), 1.0, empty_trace(), 0u);
    let orbit = kerr_ray(photon);
    let h = step_of(orbit);
    var ray = ray_at_camera(photon, orbit, h);
    var neighbours = neighbours_of(photon, orbit, ray, h);
    if camera_is_inside() && orbit.constants.horizon_w <= 0.0 {
        // The light comes through the horizon's other branch, and nothing from outside does.
        result.ray.outcome = OUTCOME_CAPTURED;
        return result;
    }
    for (var i = 0u; i < MAX_STEPS; i++) {
        change_base(&ray, orbit.constants);
        if ends_in_hole(ray) {
            result.ray.outcome = OUTCOME_CAPTURED;
            break;
        }
        if hides(result) {
            result.ray.outcome = OUTCOME_HIDDEN;
            break;
        }
        restore_radial_speed(&ray, h);
        let step = nystroem_step(ray.motion, h * h, ray.y, ray.dy, ray.k);
        let end = end_of(step, ray.motion);
        result.ray.steps += 1u;
        if NEAR_HORIZON && ray.ingoing && !(end.regular && ray.dy.x < 0.0) {
            ray.ingoing = false;
            ray.chi = add_angle(ray.chi, azimuth_lag_to_infinity(ray.motion, ray.y.x));
        }
        let way = Way(curve(step), step, ray.motion, h, ray.chi, ray.delay, ray.ingoing, end.regular, neighbours);
        add_step(&result, way, orbit, photon, end.share);
        if DELAY {
            ray.delay += step_delay(ray.motion, step, h);
        }
        if SPINNING && (SKY_DIRECTION || AZIMUTH) {
            let gain = azimuth_gain(ray.motion, way.path, h, end.share, end.y.x, end.regular, ray.ingoing);
            ray.chi = add_angle(ray.chi, gain);
        }
        if end.escapes {
            // A pointer to a part of a variable is no argument in WGSL.
            var escaped = result.ray;
            record_escape(&escaped, ray, end, orbit.constants.energy);
            result.ray = escaped;
            break;
        }
        neighbours = carried(way);
        ray.y = end.y;
        ray.dy = step.dy1;
        ray.k = step.k1;
    }
    return result;
}
