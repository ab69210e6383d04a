// The sky mode `procedural`: stars at pseudo-random places, and a faint band of unresolved ones.
// The images of stars have the size of pixels on the sky, so lensing stretches them.
//
// Three layers of stars overlap, each on the six gnomonic charts of a cube that is rotated against
// the other two. A cell of a chart holds at most one star, far enough from the cell's edges that
// the whole image lies inside. So a pixel looks up one cell per layer, and the edges of charts do
// not show.
//
// Gives: sky_background.

const CELLS: f32 = 36.0;
// The bolometric fluxes of the faintest and the brightest star; N(> F) goes as F^(-3/2), as for
// stars evenly spread through space.
const MIN_STAR_FLUX: f32 = 0.15;
const MAX_STAR_FLUX: f32 = 60.0;
// Temperature of the coldest star in kelvin, and the ratio of the hottest to it.
const MIN_TEMPERATURE: f32 = 2800.0;
const MAX_TEMPERATURE_RATIO: f32 = 10.0;
// The band: its pole, its half width as a sine of latitude, its light and temperature, and the
// density of stars off the band relative to that on it.
const BAND_POLE: vec3<f32> = vec3<f32>(2.0, 3.0, 6.0) / 7.0;
const BAND_WIDTH: f32 = 0.16;
const BAND_LIGHT: f32 = 0.03;
const BAND_TEMPERATURE: f32 = 6500.0;
const OFF_BAND: f32 = 0.55;

// A permuted congruential generator (Jarzynski & Olano 2020, "Hash Functions for GPU Rendering").
fn hash(key: vec3<u32>) -> vec3<u32> {
    var v = key * 1664525u + 1013904223u;
    for (var turn = 0u; turn < 2u; turn++) {
        v.x += v.y * v.z;
        v.y += v.z * v.x;
        v.z += v.x * v.y;
        if turn == 0u {
            v ^= v >> vec3<u32>(16u);
        }
    }
    return v;
}

// The lower and the upper half of a number's bits, each scaled to [0, 1).
fn unit_halves(bits: u32) -> vec2<f32> {
    return vec2<f32>(f32(bits & 0xffffu), f32(bits >> 16u)) / 65536.0;
}

// Relative density of the band at a sine of latitude.
fn band_profile(sine: f32) -> f32 {
    let inside = 1.0 / (1.0 + square(sine / BAND_WIDTH));
    return inside * inside;
}

// The index, 0 to 2, of the component with the largest absolute value.
fn largest_axis(d: vec3<f32>) -> u32 {
    let size = abs(d);
    if size.x >= size.y && size.x >= size.z {
        return 0u;
    }
    return select(2u, 1u, size.y >= size.z);
}

// A cyclic permutation of the components that makes the given one the third.
fn rotate_axis_to_z(d: vec3<f32>, axis: u32) -> vec3<f32> {
    return select(select(d.xyz, d.zxy, axis == 1u), d.yzx, axis == 0u);
}

// Light of one layer; `frame` rotates its cube.
fn star_layer(direction: vec3<f32>, g: f32, frame: mat3x3<f32>, layer: u32) -> vec3<f32> {
    let rotated = frame * direction;
    let axis = largest_axis(rotated);
    let d = rotate_axis_to_z(rotated, axis);
    let face = axis * 2u + select(0u, 1u, d.z < 0.0);
    let place = clamp((d.xy / max(abs(d.z), 0.5) * 0.5 + 0.5) * CELLS, vec2<f32>(0.0), vec2<f32>(CELLS - 1.0));
    let cell = floor(place);
    let bits = hash(vec3<u32>(u32(cell.x + CELLS * cell.y), face + 6u * layer, scene.sky.seed));

    // Toward the corners of a face one radian spans up to three units of the chart.
    let radius = shifted_spot_radius(g);
    let half_cell = 1.0 / CELLS;
    let middle = (cell + 0.5) * (2.0 * half_cell) - 1.0;
    let outermost = abs(middle) + half_cell;
    let room = max(half_cell - MAX_SPOT_RADIUS * (1.0 + dot(outermost, outermost)), 0.0);
    let uv = middle + room * (2.0 * unit_halves(bits.x) - 1.0);
    let stretch = inverseSqrt(1.0 + dot(uv, uv));
    let star = stretch * vec3<f32>(uv, sign(d.z));
    let offset = d - star;
    let distance2 = dot(offset, offset);
    if distance2 >= radius * radius {
        return vec3<f32>(0.0);
    }
    // The chance of a star is proportional to the cell's solid angle, and higher on the band.
    let density = mix(OFF_BAND, 1.0, band_profile(dot(star, rotate_axis_to_z(frame * BAND_POLE, axis))));
    let chances = unit_halves(bits.z);
    if chances.x >= stretch * stretch * stretch * density {
        return vec3<f32>(0.0);
    }
    let rank = (f32(bits.y >> 8u) + 0.5) / 16777216.0;
    let flux = min(MIN_STAR_FLUX * pow(rank, -2.0 / 3.0), MAX_STAR_FLUX);
    let temperature = MIN_TEMPERATURE * pow(MAX_TEMPERATURE_RATIO, square(chances.y));
    // The flux is spread over the image's area on the sky.
    let spread = square(scene.sky.spot_radius / radius) * scene.sky.star_brightness;
    return thermal_colour(temperature * g) * (flux * spread * spot_profile(distance2, radius));
}

// The glow of the band, mottled, with a dark lane along its middle.
fn band_light(direction: vec3<f32>, g: f32) -> vec3<f32> {
    let sine = dot(direction, BAND_POLE);
    let profile = band_profile(sine);
    if profile < 0.02 {
        return vec3<f32>(0.0);
    }
    let q = 7.0 * direction;
    let folds = sin(q.x + 1.9 * sin(1.4 * q.y + q.z)) * sin(1.1 * q.z + 2.1 * sin(1.6 * q.x - q.y));
    let lane = 1.0 - 0.7 / (1.0 + square((sine + 0.03 * folds) / 0.035));
    return thermal_colour(BAND_TEMPERATURE * g) * (BAND_LIGHT * (profile - 0.02) * lane * (1.0 + 0.6 * folds));
}

// The rotations of the three cubes; their entries are rational, exact except for rounding.
const FRAME_OF_THREE: mat3x3<f32> =
    mat3x3<f32>(2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0);
const FRAME_OF_SEVEN: mat3x3<f32> =
    mat3x3<f32>(2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0, 3.0 / 7.0, -6.0 / 7.0, 2.0 / 7.0, 6.0 / 7.0, 2.0 / 7.0, -3.0 / 7.0);
const UPRIGHT: mat3x3<f32> = mat3x3<f32>(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);

fn sky_background(direction: vec3<f32>, g: f32, footprint: Footprint) -> vec3<f32> {
    return band_light(direction, g) + star_layer(direction, g, UPRIGHT, 0u)
        + star_layer(direction, g, FRAME_OF_THREE, 1u) + star_layer(direction, g, FRAME_OF_SEVEN, 2u);
}
