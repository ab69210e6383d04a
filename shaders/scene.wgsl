// What every part shares: the scene's numbers, a photon at the camera, and what became of it.
//
// Units: G = c = 1 and r_s = 1, so M = 1/2. Frame: the hole's, right-handed, z along the disk
// normal. Photons are the physical, future-directed ones, per unit frequency for the camera: E =
// -p_t, L = p_phi. Rays are followed backward. Every number here was worked out in f64 on the CPU
// (crates/lightfall-core/src/gpu/scene.rs) and rounded once.

struct Scene {
    // The observer's matrix takes the unit looking direction d to the photon that arrives from it.
    // Pixels give d as (right, up, forward) of the camera, ray files as (outward, theta, phi) of
    // the observer. Rows and bends are for off = d - dimmest: dot(row, (1, off)) + bend |off|^2/2.
    energy: vec4<f32>,
    radial: vec4<f32>,
    w_x: vec4<f32>,
    w_y: vec4<f32>,
    w_z: vec4<f32>,
    // Of radial, w_x, w_y, w_z; the direction from which light has the least energy; and the bend
    // of the energy.
    bend: vec4<f32>,
    dimmest: vec3<f32>,
    energy_bend: f32,
    // Without ABERRATION, frequency for the camera of that photon, which is then divided by it:
    // dot(row, (1, d)).
    frequency: vec4<f32>,
    // Where the camera is: unit vector from the hole, and radius.
    camera_direction: vec3<f32>,
    camera_radius: f32,
    // Without spin, the photon's plunge = radial - c E, reckoned from the middle of the shadow or
    // of the sky, whichever is smaller: dot(row, (1, off)) + bend |off|^2/2 with off = d - middle.
    // Then 2 c, and 1/(1 - 1/r).
    plunge: vec4<f32>,
    plunge_middle: vec3<f32>,
    plunge_bend: f32,
    plunge_span: f32,
    inverse_lapse2: f32,
    // 1/r, and by how much that is less than at the photon sphere, 2/3.
    camera_u: f32,
    photon_sphere_depth: f32,
    // Size of the picture in pixels; tangents of half the field of view, horizontal and vertical.
    picture_size: vec2<f32>,
    tan_half_fov: vec2<f32>,
    // The step policy of verlet and kerr-schild.
    step_scale: f32,
    max_steps: u32,
    max_affine: f32,
    escape_radius: f32,
    // The disk: edges, widths of the fade at each edge, temperature scale in kelvin, scale of the
    // emission, transmission.
    disk_inner: f32,
    disk_outer: f32,
    disk_inner_fade: f32,
    disk_outer_fade: f32,
    disk_temperature: f32,
    disk_brightness: f32,
    disk_transmission: f32,
    // The sky: scale of its light, radius of a star's or line's image in radians, which stars, the
    // reference star.
    sky_brightness: f32,
    reference_star: vec3<f32>,
    spot_radius: f32,
    star_brightness: f32,
    sky_seed: u32,
    // Light of a mark that must be seen whatever the exposure.
    mark_brightness: f32,
    // Of the observer with zero angular momentum at the camera: lapse, and angular velocity (zero
    // without LENSING).
    camera_lapse: f32,
    camera_dragging: f32,
    // The hole: a = chi/2, the horizons' radii r_+ and r_-, 1 - chi; 1/r_+, and what rounding left
    // of it; r_+ - r_-.
    spin_length: f32,
    horizon: f32,
    horizon_u: f32,
    horizon_u_rest: f32,
    horizon_gap: f32,
    inner_horizon: f32,
    spin_gap: f32,
    // By how much the camera's 1/r is less than 1/r_+; by how much Kerr's ingoing azimuth is ahead
    // of the camera's, but for whole turns: zero at and inside the horizon, where it is the
    // camera's.
    horizon_depth: f32,
    azimuth_lead: f32,
    // Step in Mino time, in radians.
    mino_step: f32,
    mino_near_step: f32,
}

@group(0) @binding(0) var<uniform> scene: Scene;

const PI: f32 = 3.14159265358979;
// The hole's mass.
const MASS: f32 = 0.5;

// A photon where it meets the camera; crates/lightfall-core/src/geometry/observer.rs has the same.
struct Photon {
    // E = -p_t.
    energy: f32,
    // Sigma p^r / r^2.
    radial: f32,
    // (p_theta theta_hat + p_phi / sin(theta) phi_hat) / r, tangent to the celestial sphere at the
    // camera.
    w: vec3<f32>,
    // Without spin: what is positive for light from the horizon, and is zero at the edge of the
    // shadow.
    plunge: f32,
}

// The ray comes from infinity, ends at the horizon, was given up, or (pictures only) passed two
// crossings of the disk behind which no light matters.
const OUTCOME_SKY: u32 = 0u;
const OUTCOME_CAPTURED: u32 = 1u;
const OUTCOME_UNFINISHED: u32 = 2u;
const OUTCOME_HIDDEN: u32 = 3u;

// A crossing of the disk's annulus: r n, n toward Boyer-Lindquist theta and phi, and observed over
// emitted frequency.
struct Hit {
    position: vec3<f32>,
    g: f32,
}

struct Trace {
    // Unit vector toward the source at infinity, where the outcome is the sky; else zero.
    sky: vec3<f32>,
    outcome: u32,
    // The first crossings along the backward ray, and how many of them there are.
    hits: array<Hit, 2>,
    hit_count: u32,
    steps: u32,
    // Largest normalized residual of the null constraint; largest relative drift of the angular
    // momentum. Zero unless DIAGNOSTICS.
    residual: f32,
    angular_momentum_drift: f32,
    // Angle swept about the hole, in radians, up to the first of the crossings or, without any, to
    // infinity, without what the hole's spin drags along: its whole half-turns are the order of the
    // image. Zero where nothing is seen, and unless DIAGNOSTICS.
    turn: f32,
}

// One step of a ray: positions and velocities at its ends, and its affine length.
struct Segment {
    x0: vec3<f32>,
    v0: vec3<f32>,
    x1: vec3<f32>,
    v1: vec3<f32>,
    h: f32,
}

fn untraced() -> Trace {
    let nothing = Hit(vec3<f32>(0.0), 0.0);
    return Trace(vec3<f32>(0.0), OUTCOME_UNFINISHED, array<Hit, 2>(nothing, nothing), 0u, 0u, 0.0, 0.0, 0.0);
}

// Divisors and roots that must not vanish: the smallest number here is far above f32's subnormals.
const TINY: f32 = 1e-30;

fn safe_normalize(v: vec3<f32>) -> vec3<f32> {
    return v * inverseSqrt(max(dot(v, v), TINY));
}

fn square(x: f32) -> f32 {
    return x * x;
}

// A vector turned about z.
fn turned(v: vec2<f32>, sine_cosine: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(sine_cosine.y * v.x - sine_cosine.x * v.y, sine_cosine.x * v.x + sine_cosine.y * v.y);
}
