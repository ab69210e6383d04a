// Where images of stars are searched for: on one side of a cube about the camera. Each side has its
// own mesh and keeps the images within it (gpu/stars/sides.rs).
//
// Gives: in_picture, is_own_image.

// Whether an image in this direction (right, up, forward) is on this side.
fn is_own_image(direction: vec3<f32>) -> bool {
    return is_in_view(direction, 0.0);
}

// The direction on the axes of the picture.
fn in_picture(direction: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(dot(mesh.picture_right, direction), dot(mesh.picture_up, direction), dot(mesh.picture_forward, direction));
}
