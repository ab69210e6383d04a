// The images of stars: what the kernels that find them and the kernel that draws them share.
// crates/lightfall-core/src/gpu/stars/ has the same structs and says in which order the kernels run.
//
// Needs: BINDING_STARS.
// Gives: MAX_SHIFT, StarImage, stars.

// Largest shift that counts; the picture's sky has the same limit.
const MAX_SHIFT: f32 = 1e6;

struct Stars {
    // The list's frame: the unit vector straight behind the hole, and rows that give how far a star
    // lies from it toward growing theta and toward growing phi, dot(row, (star - behind, 1)), or
    // from the opposite direction, dot(row, (star + behind, -1)). So these components keep their
    // digits next to the line through the camera and the hole.
    behind: vec3<f32>,
    shadow_half_angle: f32,
    along_theta: vec4<f32>,
    along_phi: vec4<f32>,
    // Rows that take (1, d), d being a direction of the observer in whose frame images are found
    // (outward, toward growing theta, toward growing phi), to the camera's frequency and to that
    // times the camera's direction.
    frequency: vec4<f32>,
    right: vec4<f32>,
    up: vec4<f32>,
    forward: vec4<f32>,
    // How many of the list's stars may have an image of each order that is bright enough.
    counts: vec4<u32>,
    // The table over psi = pi + width sinh(t): its width, its first t, and its intervals per t.
    table_width: f32,
    table_first: f32,
    table_density: f32,
    // The smallest luminous flux of an image, at the star's own temperature.
    flux_limit: f32,
    // How many images fit in the list.
    capacity: u32,
    // By how much an image on the picture is stretched, and the units of its sums per linear light.
    stretch: f32,
    unit: f32,
    // The side of the squares whose light is added up, in pixels.
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
