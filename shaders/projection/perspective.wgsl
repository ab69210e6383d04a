// The perspective projection; the twin in f64 is scene/projection.rs. Places are in pixels from the
// upper left corner of the whole picture, and directions are (right, up, forward) of the camera.
// scene.picture.projection holds the tangents of half the field of view, horizontal and vertical.
//
// Gives: coverage, is_in_view, pixel_direction, pixel_solid_angle, project, ray_solid_angle,
//     shown_place.

// The solid angle of a pixel about the last pixel_direction, in steradians.
var<private> ray_solid_angle: f32;

// The unit direction that is seen at a place.
fn pixel_direction(place: vec2<f32>) -> vec3<f32> {
    let across = place / scene.picture.whole * vec2<f32>(2.0, -2.0) + vec2<f32>(-1.0, 1.0) - scene.picture.axis;
    let direction = normalize(vec3<f32>(across * scene.picture.projection, 1.0));
    // That of the middle pixel times the cube of the cosine of the angle off the axis.
    ray_solid_angle = scene.picture.middle_solid_angle * direction.z * direction.z * direction.z;
    return direction;
}

// The place at which a direction in front of the camera is seen: the inverse of pixel_direction.
fn project(direction: vec3<f32>) -> vec2<f32> {
    let across = direction.xy / direction.z / scene.picture.projection + scene.picture.axis;
    return (across * vec2<f32>(0.5, -0.5) + 0.5) * scene.picture.whole;
}

// Whether a direction is seen within the whole picture or at most `margin` pixels beside it.
fn is_in_view(direction: vec3<f32>, margin: f32) -> bool {
    // In the middle of the picture at (0, 0), at its edges at +-(1, 1).
    let bound = direction.z * scene.picture.projection * (1.0 + 2.0 * margin / scene.picture.whole);
    let across = direction.xy + direction.z * scene.picture.projection * scene.picture.axis;
    return direction.z > 0.0 && abs(across.x) <= bound.x && abs(across.y) <= bound.y;
}

// The share of the pixel with its middle at a place that shows anything.
fn coverage(place: vec2<f32>) -> f32 {
    return 1.0;
}

// The place within the picture that shows the same direction as a place beside it, in projections
// that show a direction at several places; else the same place.
fn shown_place(place: vec2<f32>) -> vec2<f32> {
    return place;
}

// The solid angle in steradians of the pixel with its middle at this place.
fn pixel_solid_angle(place: vec2<f32>) -> f32 {
    let across = place / scene.picture.whole * 2.0 - 1.0;
    let tangents = (across - scene.picture.axis * vec2<f32>(1.0, -1.0)) * scene.picture.projection;
    let cosine = inverseSqrt(1.0 + dot(tangents, tangents));
    let side = 2.0 * scene.picture.projection / scene.picture.whole;
    return side.x * side.y * cosine * cosine * cosine;
}
