// The images of stars around a hole without spin, by the table of optics/stars/images/table.rs, in
// the frame of the observer `rain`. The twin in f64 is optics/stars/images/inversion.rs.
//
// Gives: frame_image.

// A star at a smaller angle from the outward direction has the magnification of one at zero.
const OVERHEAD: f32 = 3e-3;

// For each interval, y and dy at its start and at its end: y is the logarithm of the angle from the
// edge of the shadow, dy its slope times the interval.
@group(0) @binding(BINDING_STAR_TABLE) var<uniform> star_table: array<vec4<f32>, STAR_INTERVALS>;

// Inverse hyperbolic sine, with an error of at most 2e-7 plus 3e-7 of its value.
fn asinh_precise(x: f32) -> f32 {
    let size = abs(x);
    let value = log_precise(size + sqrt(size * size + 1.0));
    return select(value, -value, x < 0.0);
}

// 1/sin(distance), averaged over a star with the radius MIN_SOURCE_RADIUS.
fn inverse_sine(distance: f32, sine: f32) -> f32 {
    let x = distance / MIN_SOURCE_RADIUS;
    if x < 1.0 {
        let x2 = x * x;
        return (2.0 - x2 * (0.5 + 0.227 * x2)) / MIN_SOURCE_RADIUS;
    }
    let share = 1.0 / (x * x);
    return (1.0 + share * (0.125 + 0.148 * share * share)) / sine;
}

// The direction in which `rain` sees a star's image of this order, and its magnification. Star and
// image are unit vectors (outward, toward growing theta, toward growing phi).
fn frame_image(star: vec3<f32>, order: u32) -> vec4<f32> {
    let sine = length(star.yz);
    let nearest = atan2_precise(sine, abs(star.x));
    let is_behind = star.x < 0.0;
    // The angles from the directions behind the hole and straight outward.
    let behind = select(PI - nearest, nearest, is_behind);
    let overhead = select(nearest, PI - nearest, is_behind);
    let even = (order & 1u) == 0u;
    let turns = f32(order);
    let beyond = select((turns - 1.0) * PI + behind, turns * PI - behind, even);

    let place = (asinh_precise(beyond / stars.table_width) - stars.table_first) * stars.table_density;
    let interval = min(u32(max(place, 0.0)), STAR_INTERVALS - 1u);
    let x = place - f32(interval);
    let ends = star_table[interval];
    let rise = ends.z - ends.x;
    let bend = 3.0 * rise - 2.0 * ends.y - ends.w;
    let twist = ends.y + ends.w - 2.0 * rise;
    let y = ends.x + x * (ends.y + x * (bend + x * twist));
    let rate = ends.y + x * (2.0 * bend + x * 3.0 * twist);
    let off_edge = exp_precise(y);
    // The decrease of off_edge per angle about the hole.
    let width2 = stars.table_width * stars.table_width + beyond * beyond;
    let slope = -off_edge * rate * stars.table_density * inverseSqrt(width2);

    let seen = sin_cos_precise(stars.shadow_half_angle + off_edge);
    // A star overhead is on a caustic too, except for its image of order 0.
    let from_caustic = select(nearest, behind, order == 0u);
    let tangential = select(seen.x * inverse_sine(from_caustic, sine), slope, order == 0u && overhead < OVERHEAD);
    let across = select(vec2<f32>(1.0, 0.0), star.yz / max(sine, 1e-30), sine > 0.0);
    return vec4<f32>(-seen.y, select(-seen.x, seen.x, even) * across, tangential * slope);
}
