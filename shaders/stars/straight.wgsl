// The images of stars along straight rays: one of each star, unless the hole, a black ball, hides
// it. They are found in the frame of the observer with zero angular momentum.
//
// Gives: frame_image.

// The direction in which the observer sees a star's image of this order, and its magnification;
// zero where there is none. A star is given by its unit vector on the observer's axes (outward,
// toward growing theta, toward growing phi).
fn frame_image(star: vec3<f32>, order: u32) -> vec4<f32> {
    let hidden = star.x < 0.0 && length(star.yz) * scene.observer.r <= scene.hole.horizon;
    return vec4<f32>(star, select(1.0, 0.0, hidden || order > 0u));
}
