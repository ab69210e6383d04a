// The reference star, a bright disc in a fixed direction. Next to the shadow a pixel may hold all of
// it and much of the sky besides.
//
// Gives: reference_star_light.

// Temperature in kelvin, brightness, and angular radius, a quarter of a degree.
const REFERENCE_TEMPERATURE: f32 = 8000.0;
const REFERENCE_BRIGHTNESS: f32 = 4.0;
const REFERENCE_RADIUS: f32 = 0.00436332;
// The star dims linearly over this share of its radius, up to its edge.
const EDGE_SHARE: f32 = 0.25;

// The radius of the star along an axis of a footprint of this length. A star that is narrower than
// the distance between rays is widened until the light that neighbouring rays see adds up to the
// same sum wherever the star lies between them: half of its light must lie within one distance.
fn widened_radius(length: f32) -> f32 {
    return max(REFERENCE_RADIUS, length / (1.0 - 0.5 * EDGE_SHARE));
}

// A widened star has the same light in all.
fn reference_star_light(direction: vec3<f32>, g: f32, footprint: Footprint) -> vec3<f32> {
    let axes = footprint_axes(footprint);
    let radii = vec2<f32>(widened_radius(axes.lengths.x), widened_radius(axes.lengths.y));
    let offset = direction - scene.sky.reference_star;
    let along = dot(offset, axes.long / max(length(axes.long), TINY));
    let across = sqrt(max(dot(offset, offset) - along * along, 0.0));
    let distance = length(vec2<f32>(along, across) / radii);
    let share = clamp((1.0 - distance) / EDGE_SHARE, 0.0, 1.0);
    if share == 0.0 {
        return vec3<f32>(0.0);
    }
    let dimming = REFERENCE_RADIUS * REFERENCE_RADIUS / (radii.x * radii.y);
    return thermal_colour(REFERENCE_TEMPERATURE * g) * (REFERENCE_BRIGHTNESS * share * dimming);
}
