// Where images of stars are searched for: in the picture itself.
//
// Gives: in_picture, is_own_image.

// Whether an image in this direction (right, up, forward) has light in the picture.
fn is_own_image(direction: vec3<f32>) -> bool {
    return is_in_view(direction, 2.0 * stars.stretch);
}

// The direction on the axes of the picture.
fn in_picture(direction: vec3<f32>) -> vec3<f32> {
    return direction;
}
