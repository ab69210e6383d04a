// What the sky modes `stars` and `picture` share: the numbers of a map of the whole sky, and how the map is
// filtered along a footprint.
//
// Gives: map_taps, starlight.

// Mirror of `GpuStarlight` in gpu/starlight.rs.
struct Starlight {
    // From the hole's frame to the axes of the map: of the Milky Way, to the equatorial frame (J2000).
    celestial_from_hole: mat3x3<f32>,
    // The faintest magnitude of a star drawn as a point, if its image has the star's own flux, and
    // at any flux.
    magnitude_limit: f32,
    last_magnitude: f32,
    // Temperatures of the two components of the Milky Way, in kelvin.
    temperatures: vec2<f32>,
    // Colour of nebulae, at equal steps of the logarithm of the frequency ratio.
    nebular: array<vec4<f32>, NEBULAR_LEN>,
    // Width of a texel of the finest level, in radians.
    texel: f32,
    // Linear light per unit of the sums of points.
    light_unit: f32,
    // The squares in which light is summed: their number along the side of a pixel, and in a row.
    squares_per_pixel: f32,
    columns: u32,
}

@group(0) @binding(BINDING_STARLIGHT) var<uniform> starlight: Starlight;

// Maximum number of samples along a footprint. Four reduce the error next to the shadow to a third.
const MAX_TAPS: f32 = 4.0;

// The samples of the map along a footprint.
struct MapTaps {
    // The middle of the footprint and its longer axis, on the axes of the map.
    middle: vec3<f32>,
    along: vec3<f32>,
    // The number of samples, and the level of the map that they are taken from.
    count: f32,
    level: f32,
}

// The samples about a direction: as many as the ratio of the footprint's axes.
fn map_taps(direction: vec3<f32>, axes: Axes) -> MapTaps {
    let along = starlight.celestial_from_hole * axes.long;
    let middle = starlight.celestial_from_hole * direction;
    let count = clamp(ceil(axes.lengths.x / max(axes.lengths.y, TINY) - 0.25), 1.0, MAX_TAPS);
    let level = log2(max(max(axes.lengths.y, axes.lengths.x / count) / starlight.texel, 1.0));
    return MapTaps(middle, along, count, level);
}
