// The sky mode `grid`: circles of latitude and meridians every 15 degrees. The lines have no
// temperature, so the shift changes their brightness only.
//
// Needs: PI, atan2_precise, shifted_spot_radius, spot_profile, square.
// Gives: sky_background.

const GRID_SPACING: f32 = PI / 12.0;
// The light between the lines, enough for the hole's shadow to stand out.
const GRID_FILL: vec3<f32> = vec3<f32>(0.004, 0.008, 0.015);
const GRID_LINE: vec3<f32> = vec3<f32>(0.05, 0.10, 0.16);
const GRID_STRONG_LINE: vec3<f32> = vec3<f32>(0.16, 0.28, 0.40);
const GRID_EQUATOR: vec3<f32> = vec3<f32>(0.80, 0.30, 0.06);
const GRID_PRIME_MERIDIAN: vec3<f32> = vec3<f32>(0.10, 0.70, 0.22);
// Every third line is strong. The other meridians end at the last circle, so that they do not crowd
// the poles.
const GRID_STRONG: i32 = 3;
const GRID_LAST_CIRCLE_SINE: f32 = 0.2588190;

fn line_colour(index: i32, coloured: i32, colour: vec3<f32>) -> vec3<f32> {
    if index == coloured {
        return colour;
    }
    return select(GRID_LINE, GRID_STRONG_LINE, index % GRID_STRONG == 0);
}

fn sky_background(direction: vec3<f32>, g: f32) -> vec3<f32> {
    let radius = shifted_spot_radius(g);
    let sine = length(direction.xy);
    // Circles: differences of theta are distances on the sky. The poles are no circles.
    let theta = atan2_precise(sine, direction.z);
    let circle = i32(round(theta / GRID_SPACING));
    let circle_distance = theta - f32(circle) * GRID_SPACING;
    var light = vec3<f32>(0.0);
    if circle > 0 && circle < 12 {
        light = line_colour(circle, 6, GRID_EQUATOR) * spot_profile(square(circle_distance), radius);
    }
    // Meridians: the distance from a meridian is sin(theta) times the difference in azimuth.
    let phi = atan2_precise(direction.y, direction.x);
    let meridian = i32(round(phi / GRID_SPACING));
    let meridian_distance = sine * (phi - f32(meridian) * GRID_SPACING);
    if meridian % GRID_STRONG == 0 || sine > GRID_LAST_CIRCLE_SINE {
        let line = line_colour(meridian, 0, GRID_PRIME_MERIDIAN) * spot_profile(square(meridian_distance), radius);
        light = max(light, line);
    }
    return GRID_FILL + light;
}
