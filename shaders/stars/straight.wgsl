// The images of stars along straight rays, in the frame of the observer with zero angular momentum:
// one of each star that the hole, a black ball, does not hide.
//
// Gives: frame_image.

// As in closed.wgsl; the magnification is zero where there is no image.
fn frame_image(star: vec3<f32>, order: u32) -> vec4<f32> {
    let hidden = star.x < 0.0 && length(star.yz) * scene.observer.r <= scene.hole.horizon;
    return vec4<f32>(star, select(1.0, 0.0, hidden || order > 0u));
}
