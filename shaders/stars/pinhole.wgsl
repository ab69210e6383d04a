// The projection of the picture: a pinhole camera. Another projection replaces this part.
//
// Needs: scene.
// Gives: is_in_view, pixel_solid_angle, project, seen_direction.

// The place of a direction in front of the camera, in pixels from the upper left corner: the
// inverse of pixel_direction.
fn project(direction: vec3<f32>) -> vec2<f32> {
    let across = direction.xy / direction.z / scene.picture.tan_half_fov;
    return (across * vec2<f32>(0.5, -0.5) + 0.5) * scene.picture.size;
}

// The unit direction that is seen at a place: the inverse of `project`.
fn seen_direction(place: vec2<f32>) -> vec3<f32> {
    let across = place / scene.picture.size * vec2<f32>(2.0, -2.0) + vec2<f32>(-1.0, 1.0);
    return normalize(vec3<f32>(across * scene.picture.tan_half_fov, 1.0));
}

// Whether a direction is seen within the picture or at most `margin` pixels beside it.
fn is_in_view(direction: vec3<f32>, margin: f32) -> bool {
    // In the middle of the picture at (0, 0), at its edges at +-(1, 1).
    let bound = direction.z * scene.picture.tan_half_fov * (1.0 + 2.0 * margin / scene.picture.size);
    return direction.z > 0.0 && abs(direction.x) <= bound.x && abs(direction.y) <= bound.y;
}

// The solid angle of the pixel with its middle at this place: that of a pixel in the middle of the
// picture times the cube of the cosine of the angle off the axis.
fn pixel_solid_angle(place: vec2<f32>) -> f32 {
    let tangents = (place / scene.picture.size * 2.0 - 1.0) * scene.picture.tan_half_fov;
    let cosine = inverseSqrt(1.0 + dot(tangents, tangents));
    let side = 2.0 * scene.picture.tan_half_fov / scene.picture.size;
    return side.x * side.y * cosine * cosine * cosine;
}
