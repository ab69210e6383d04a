// A disk with thickness: where it is, how much it absorbs, and how it turns, at four places at once.
// The twin in f64 is optics/medium/thick_disk.rs.
//
// Gives: half_opening, max_half_opening, opacity, opening_between_edges, rotation, thick_disk, vertical_depth.

struct ThickDisk {
    // Half of the opening, as the cosine of the angle from the normal, where 1/r is inverse_pivot;
    // and the largest one.
    half_opening: f32,
    max_half_opening: f32,
    inverse_pivot: f32,
    // The power of the radius with which it grows.
    flare: f32,
    // Optical depth along the normal.
    depth: f32,
    // The width of the fade at the outer edge.
    outer_fade: f32,
    // The scale of a scattering disk's emission, and 1/2 over its depth.
    emission_scale: f32,
    thin_emission: f32,
    // Standard deviations of the logarithms of the structure's flux and density.
    flux_spread: f32,
    density_spread: f32,
}

@group(0) @binding(BINDING_THICK_DISK) var<storage, read> thick_disk: ThickDisk;

// The share of the height that remains at the edges.
const EDGE_HEIGHT: f32 = 0.3;

fn smooth_fade(share: vec4<f32>) -> vec4<f32> {
    let s = clamp(share, vec4<f32>(0.0), vec4<f32>(1.0));
    return s * s * (3.0 - 2.0 * s);
}

// A fade narrower than f32 resolves is a wall, which has its whole height up to the edge.
fn outer_cover(r: vec4<f32>) -> vec4<f32> {
    let fades = thick_disk.outer_fade > 1e-5 * scene.disk.outer;
    return select(vec4<f32>(1.0), smooth_fade((scene.disk.outer - r) / max(thick_disk.outer_fade, 1e-6)), fades);
}

fn max_half_opening() -> f32 {
    return thick_disk.max_half_opening;
}

// Half of the disk's opening between its edges. Beyond an edge it is that of the edge, so that a ray at
// the edge counts as inside whatever the last digit of its radius.
fn opening_between_edges(r: vec4<f32>) -> vec4<f32> {
    let x = clamp(scene.disk.inner / max(r, vec4<f32>(TINY)), vec4<f32>(0.0), vec4<f32>(1.0));
    let height = EDGE_HEIGHT + (1.0 - EDGE_HEIGHT) * (1.0 - x * sqrt(x)) * outer_cover(r);
    var flare = vec4<f32>(1.0);
    if thick_disk.flare != 0.0 {
        flare = exp2(thick_disk.flare * log2(max(r * thick_disk.inverse_pivot, vec4<f32>(TINY))));
    }
    return thick_disk.half_opening * height * flare;
}

// The same; zero outside the edges.
fn half_opening(r: vec4<f32>) -> vec4<f32> {
    let between = r > vec4<f32>(scene.disk.inner) & r < vec4<f32>(scene.disk.outer);
    return select(vec4<f32>(0.0), opening_between_edges(r), between);
}

// Optical depth along the normal.
fn vertical_depth(r: vec4<f32>) -> vec4<f32> {
    let inner = smooth_fade((r - scene.disk.inner) / max(scene.disk.inner_fade, 1e-6));
    return thick_disk.depth * inner * outer_cover(r);
}

// kappa rho, where `opening` is half_opening(r): the optical depth for each r_s in the matter's frame.
// 35/32 makes the integral of (1 - zeta^2)^3 over zeta from -1 to 1 one.
fn opacity(r: vec4<f32>, n_z: vec4<f32>, opening: vec4<f32>) -> vec4<f32> {
    let zeta = n_z / max(opening, vec4<f32>(TINY));
    let rest = max(1.0 - zeta * zeta, vec4<f32>(0.0));
    let column = max(r * opening, vec4<f32>(TINY));
    return select(vec4<f32>(0.0), (35.0 / 32.0) * vertical_depth(r) / column * rest * rest * rest, opening > vec4<f32>(0.0));
}

// Omega and u^t of matter that turns as the circular orbit at the same distance from the axis does.
struct Rotation {
    omega: vec4<f32>,
    u_t: vec4<f32>,
}

fn rotation(r: vec4<f32>, n_z: vec4<f32>) -> Rotation {
    let a = scene.hole.a;
    let sin2 = max(1.0 - n_z * n_z, vec4<f32>(1e-6));
    let axial = r * sqrt(sin2);
    let omega = SQRT_MASS / (axial * sqrt(axial) + a * SQRT_MASS);
    let sigma = r * r + a * a * n_z * n_z;
    // -(g_tt + 2 g_tphi Omega + g_phiphi Omega^2): 1 - sin^2 (r^2 + a^2) Omega^2 less the hole's part,
    // r/Sigma (1 - a sin^2 Omega)^2.
    let dragged = 1.0 - a * sin2 * omega;
    let clock = 1.0 - sin2 * (r * r + a * a) * omega * omega - r / sigma * dragged * dragged;
    return Rotation(omega, inverseSqrt(max(clock, vec4<f32>(MIN_CLOCK))));
}

const SQRT_MASS: f32 = 0.707106781;
// The least square of the matter's clock rate.
const MIN_CLOCK: f32 = 1e-6;
