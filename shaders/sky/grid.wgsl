// The sky mode `grid`: circles of latitude and meridians every 15 degrees. The lines have no
// temperature, so the shift changes their brightness only.
//
// Gives: sky_background.

const GRID_SPACING: f32 = PI / 12.0;
// The light between the lines, enough for the hole's shadow to stand out.
const GRID_FILL: vec3<f32> = vec3<f32>(0.004, 0.008, 0.015);
const GRID_LINE: vec3<f32> = vec3<f32>(0.05, 0.10, 0.16);
const GRID_STRONG_LINE: vec3<f32> = vec3<f32>(0.16, 0.28, 0.40);
const GRID_EQUATOR: vec3<f32> = vec3<f32>(0.80, 0.30, 0.06);
const GRID_PRIME_MERIDIAN: vec3<f32> = vec3<f32>(0.10, 0.70, 0.22);
// Every third line is strong. The other meridians end at the last circle, to keep the poles clear.
const GRID_STRONG: i32 = 3;
const GRID_LAST_CIRCLE_SINE: f32 = 0.2588190;

fn line_colour(index: i32, coloured: i32, colour: vec3<f32>) -> vec3<f32> {
    if index == coloured {
        return colour;
    }
    return select(GRID_LINE, GRID_STRONG_LINE, index % GRID_STRONG == 0);
}

// Light of a family of parallel lines, per unit of the nearest line's, and the share of their mean.
// Lines narrower than the distance between rays are widened to it, with the same total light. Where
// widened lines overlap, only their mean is drawn.
fn lines(distance: f32, spacing: f32, radius: f32, footprint: f32) -> vec2<f32> {
    let width = max(radius, footprint);
    let widest = max(0.5 * spacing, TINY);
    let drawn = max(min(width, widest), radius);
    let mean = select(0.0, clamp(footprint / widest - 1.0, 0.0, 1.0), footprint > radius);
    return vec2<f32>(spot_profile(square(distance), drawn) * radius / drawn, mean);
}

// The mean light of a family of lines: the integral of a line's profile over the spacing.
fn mean_of_lines(spacing: f32, radius: f32) -> vec3<f32> {
    let colour = (2.0 * GRID_LINE + GRID_STRONG_LINE) / 3.0;
    return colour * min(32.0 / 35.0 * radius / max(spacing, TINY), 1.0);
}

// The extent of a footprint along a direction.
fn extent(footprint: Footprint, along: vec3<f32>) -> f32 {
    return length(vec2<f32>(dot(footprint.to_the_right, along), dot(footprint.downward, along)));
}

fn sky_background(direction: vec3<f32>, g: f32, footprint: Footprint) -> vec3<f32> {
    let radius = shifted_spot_radius(g);
    let sine = length(direction.xy);
    let outward = vec2<f32>(direction.x, direction.y) / max(sine, TINY);
    // Circles: differences of theta are distances on the sky. There is no circle at the poles.
    let theta = atan2_precise(sine, direction.z);
    let circle = clamp(i32(round(theta / GRID_SPACING)), 1, 11);
    let across = extent(footprint, vec3<f32>(direction.z * outward, -sine));
    let circles = lines(theta - f32(circle) * GRID_SPACING, GRID_SPACING, radius, across);
    let mean_circle = mean_of_lines(GRID_SPACING, radius);
    let light = mix(line_colour(circle, 6, GRID_EQUATOR) * circles.x, mean_circle, circles.y);
    // Meridians: the distance from a meridian is sin(theta) times the difference in azimuth.
    let phi = atan2_precise(direction.y, direction.x);
    let stride = select(GRID_STRONG, 1, sine > GRID_LAST_CIRCLE_SINE);
    let spacing = f32(stride) * GRID_SPACING;
    let meridian = stride * i32(round(phi / spacing));
    let distance = sine * (phi - f32(meridian) * GRID_SPACING);
    let around = extent(footprint, vec3<f32>(-outward.y, outward.x, 0.0));
    let meridians = lines(distance, sine * spacing, radius, around);
    let mean_meridian = mean_of_lines(sine * spacing, radius);
    let line = mix(line_colour(meridian, 0, GRID_PRIME_MERIDIAN) * meridians.x, mean_meridian, meridians.y);
    return GRID_FILL + max(light, line);
}
