// The structs of the kernels that find and draw the images of stars. gpu/stars/ has the same
// structs and the order of the kernels.
//
// Gives: MAX_SHIFT, StarImage, stars.

// The largest shift; the picture's sky has the same limit.
const MAX_SHIFT: f32 = 1e6;

struct Stars {
    // In the list's frame: the unit vector straight behind the hole, and rows for a star's
    // components toward growing theta and phi relative to it, dot(row, (star - behind, 1)), or to
    // the opposite direction, dot(row, (star + behind, -1)): accurate next to the line through
    // camera and hole.
    behind: vec3<f32>,
    shadow_half_angle: f32,
    along_theta: vec4<f32>,
    along_phi: vec4<f32>,
    // Rows that take (1, d) of the observer in whose frame images are found, on its axes (outward,
    // theta, phi), to the camera's frequency and to the frequency times the camera's direction.
    frequency: vec4<f32>,
    right: vec4<f32>,
    up: vec4<f32>,
    forward: vec4<f32>,
    // The numbers of stars that may have a bright enough image of each order.
    counts: vec4<u32>,
    // The table over psi = pi + width sinh(t): its width, its first t, and its intervals per t.
    table_width: f32,
    table_first: f32,
    table_density: f32,
    // The smallest luminous flux of an image, at the star's own temperature.
    flux_limit: f32,
    // The capacity of the list of images.
    capacity: u32,
    // The width of an image relative to one pixel's, and the units of the sums per linear light.
    stretch: f32,
    unit: f32,
    // The side of the squares in which light is summed, in pixels.
    sums_side: u32,
}

// An image of a star, in any projection.
struct StarImage {
    // Unit looking direction: right, up, forward.
    direction: vec3<f32>,
    // Bolometric flux at the camera, in linear light times steradians.
    flux: f32,
    // In kelvin, at the camera.
    temperature: f32,
    // The star's number in the list, and the number of whole half-turns about the hole.
    star: u32,
    order: u32,
}

@group(0) @binding(BINDING_STARS) var<uniform> stars: Stars;
