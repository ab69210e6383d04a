// The uniform that describes the scene. The CPU computes every number in f64 and rounds it to f32
// once (gpu/scene/).
//
// Units are G = c = 1 and r_s = 1, so M = 1/2. The frame is right-handed, with z along the disk's
// normal. Photons are the physical, future-directed ones, per unit frequency at the camera: E =
// -p_t, L = p_phi. Rays are followed backward from the camera.
//
// Gives: MASS, scene.

// The hole's mass.
const MASS: f32 = 0.5;

// The observer's matrix maps a unit looking direction d to the photon that arrives from it; d is
// (right, up, forward) of the camera or, for files of rays, (outward, theta, phi) of the observer.
// Each component of the photon is
//
//   dot(row, (1, off)) + curvature |off|^2/2,   off = d - expansion_centre.
struct Observer {
    energy: vec4<f32>,
    radial: vec4<f32>,
    w_x: vec4<f32>,
    w_y: vec4<f32>,
    w_z: vec4<f32>,
    // The curvatures of radial, w_x, w_y and w_z.
    curvature: vec4<f32>,
    // The direction of the least energy or, where it can be negative, of the smallest photon.
    expansion_centre: vec3<f32>,
    energy_curvature: f32,
    // Without ABERRATION the photon is divided by its frequency at the camera, dot(row, (1, d)).
    frequency: vec4<f32>,
    // Where the observer is: the unit vector from the hole, Boyer-Lindquist r, and u = 1/r.
    position_direction: vec3<f32>,
    r: f32,
    u: f32,
    // 1/r_+ - 1/r: zero at the horizon, negative inside.
    u_to_horizon: f32,
    // The lead of Kerr's ingoing azimuth over the observer's, less whole turns. Zero at and inside
    // the horizon, where the observer's azimuth is the ingoing one.
    ingoing_azimuth_lead: f32,
    // The same of the time, and the lag of the outgoing time: the tortoise coordinate, or r without
    // LENSING.
    time_lead: f32,
    // Lapse and angular velocity of the observer with zero angular momentum (ZAMO) at the same
    // place; the latter is zero without LENSING.
    zamo_lapse: f32,
    zamo_angular_velocity: f32,
}

struct Hole {
    // a = chi/2.
    a: f32,
    // 1 - chi.
    one_minus_spin: f32,
    // The horizons r_+ and r_-, and r_+ - r_-.
    horizon: f32,
    inner_horizon: f32,
    horizon_separation: f32,
    // 1/r_+ as the sum of two f32.
    horizon_u: f32,
    horizon_u_low: f32,
}

// The edge of the shadow of a hole without spin. The margin of a photon is radial - c E, with c =
// radial/E at the edge:
//
//   dot(margin, (1, off)) + curvature |off|^2/2,   off = d - center,
//
// where center is the middle of the shadow or of the rest of the sky, whichever is smaller.
struct Shadow {
    margin: vec4<f32>,
    center: vec3<f32>,
    curvature: f32,
    // 2 c.
    twice_critical_radial: f32,
    // 1/(1 - 1/r).
    inverse_lapse_squared: f32,
    // 2/3 - 1/r: the photon sphere's u less the observer's.
    u_to_photon_sphere: f32,
}

struct Disk {
    // The edges, and the widths over which the emission fades in at each.
    inner: f32,
    outer: f32,
    inner_fade: f32,
    outer_fade: f32,
    // Temperature scale in kelvin, and scale of the emission.
    temperature: f32,
    brightness: f32,
    // Share of the light from behind that passes through.
    transmission: f32,
}

struct Sky {
    // Unit vector toward the reference star.
    reference_star: vec3<f32>,
    // Scale of all light from the sky.
    brightness: f32,
    // Radius of the image of a star or line, in radians, and scale of a star's light in it.
    spot_radius: f32,
    star_brightness: f32,
    // The seed of the procedural stars.
    seed: u32,
}

struct Quality {
    // The step policy of the methods verlet and kerr-schild.
    step_scale: f32,
    max_steps: u32,
    max_affine: f32,
    escape_radius: f32,
    min_step: f32,
    // Steps of the method mino in Mino time, in radians: of rays that pass far from the critical
    // curve, and of rays that may come near it.
    mino_step: f32,
    mino_critical_step: f32,
}

struct Picture {
    // Size of the whole picture, which the field of view fills; upper left corner and size of the
    // part that is drawn. In pixels.
    whole: vec2<f32>,
    origin: vec2<u32>,
    size: vec2<f32>,
    // Where the upper left corner of the part is drawn in the target, in pixels.
    corner: vec2<f32>,
    // The numbers of the projection (shaders/projection/).
    projection: vec2<f32>,
    // The light of marks, which look the same at every exposure.
    mark_brightness: f32,
    // The factor of light before tone mapping.
    exposure: f32,
    // The place of the ray in its pixel, in pixels from the middle.
    offset: vec2<f32>,
    // Width of the area of a ray, in pixels or cells of a refined pixel's grid: less than one where
    // a picture is the mean of several frames.
    footprint: f32,
    // Solid angle of a pixel at the line of sight, in steradians.
    middle_solid_angle: f32,
    // The place of the line of sight, where the picture's middle is (0, 0) and its right and upper
    // edges are at 1.
    axis: vec2<f32>,
    // The layers that are drawn, as bits (gpu/layers.rs). The shaders of layers alone read them.
    layers: u32,
}

// Structs within a uniform must begin at multiples of 16 bytes. Those with vectors of three or four
// numbers do, and each other one precedes such a struct or is the first. A browser would lose
// attributes.
struct Scene {
    hole: Hole,
    observer: Observer,
    disk: Disk,
    shadow: Shadow,
    quality: Quality,
    sky: Sky,
    picture: Picture,
}

@group(0) @binding(BINDING_SCENE) var<uniform> scene: Scene;
