// The equidistant fisheye projection: the distance from the line of sight is proportional to the
// angle. The twin in f64 is scene/projection.rs. Places are in pixels from the upper left corner of
// the whole picture, and directions are (right, up, forward) of the camera.
// scene.picture.projection holds the angle that a pixel covers along a radius and the radius of the
// circle, in pixels.
//
// Gives: coverage, image_reach, is_in_view, is_on_sky, pixel_direction, pixel_solid_angle, project,
//     ray_solid_angle, shown_place.

// Images of stars grow at most by this factor along the circle, where its edge shows one direction.
const MAX_STRETCH: f32 = 8.0;

// The solid angle of a pixel about the last pixel_direction, in steradians.
var<private> ray_solid_angle: f32;

// The place of the line of sight.
fn axis_place() -> vec2<f32> {
    return (scene.picture.axis * vec2<f32>(0.5, -0.5) + 0.5) * scene.picture.whole;
}

// The angle from the line of sight at a place.
fn angle_at(place: vec2<f32>) -> f32 {
    return length(place - axis_place()) * scene.picture.projection.x;
}

// The unit direction that is seen at a place. Beyond the circle the formula goes on, so that the
// differences between neighbouring pixels are smooth; `coverage` masks the light.
fn pixel_direction(place: vec2<f32>) -> vec3<f32> {
    let off = (place - axis_place()) * vec2<f32>(1.0, -1.0);
    let distance = length(off);
    let angle = sin_cos_precise(distance * scene.picture.projection.x);
    ray_solid_angle = pixel_solid_angle(place);
    return vec3<f32>(off * (angle.x / max(distance, TINY)), angle.y);
}

// The place at which a direction is seen: the inverse of pixel_direction.
fn project(direction: vec3<f32>) -> vec2<f32> {
    let aside = length(direction.xy);
    let distance = atan2_precise(aside, direction.z) / scene.picture.projection.x;
    let toward = select(vec2<f32>(1.0, 0.0), direction.xy / max(aside, TINY), aside > 0.0);
    return axis_place() + distance * toward * vec2<f32>(1.0, -1.0);
}

// Whether a direction is seen within the whole picture and its circle or at most `margin` pixels
// beside them.
fn is_in_view(direction: vec3<f32>, margin: f32) -> bool {
    let place = project(direction);
    let is_in_circle = distance(place, axis_place()) <= scene.picture.projection.y + margin;
    return is_in_circle && all(place >= vec2<f32>(-margin)) && all(place <= scene.picture.whole + margin);
}

// Whether a place shows any direction: not where the angle from the line of sight is beyond straight
// back.
fn is_on_sky(place: vec2<f32>) -> bool {
    return angle_at(place) < PI;
}

// The share of the pixel with its middle at a place that lies within the circle.
fn coverage(place: vec2<f32>) -> f32 {
    return clamp(scene.picture.projection.y - distance(place, axis_place()) + 0.5, 0.0, 1.0);
}

// The place within the picture that shows the same direction as a place beside it: there is none.
fn shown_place(place: vec2<f32>) -> vec2<f32> {
    return place;
}

// The ratio of an angle to its sine: how much longer a line across a radius is than one along it.
fn stretch_at(place: vec2<f32>) -> f32 {
    let angle = angle_at(place);
    return select(1.0, angle / max(sin_cos_precise(angle).x, TINY), angle > 1e-3);
}

// The solid angle in steradians of the pixel with its middle at this place, zero beyond straight
// back.
fn pixel_solid_angle(place: vec2<f32>) -> f32 {
    let side = scene.picture.projection.x;
    return select(0.0, side * side / stretch_at(place), is_on_sky(place));
}

// Half the width and the height of the rectangle about a place that shows what lies within `reach`
// pixels of the line of sight about its direction.
fn image_reach(place: vec2<f32>, reach: f32) -> vec2<f32> {
    return vec2<f32>(reach * min(stretch_at(place), MAX_STRETCH));
}
