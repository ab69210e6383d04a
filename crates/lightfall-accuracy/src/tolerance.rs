//! The largest backward error that a method is allowed.

use lightfall_model::scene::{AccuracySetting, Scene};

/// The largest backward error that the scene's method is allowed for any ray, in radians.
///
/// The closed forms are held to f32's precision of a direction, and mino also to its setting in
/// pixels of the scene's picture. The article's methods are held to a pixel of the article's
/// pictures, 960x540 at 60 degrees.
pub fn tolerance(scene: &Scene) -> f64 {
    let most = scene.method.backward_max(scene.hole.spin);
    match scene.method.properties().setting {
        AccuracySetting::MaxError => {
            let pixel = scene.pixel_angle();
            f64::max(most, scene.quality.max_error_px * pixel)
        }
        AccuracySetting::None | AccuracySetting::StepScale => most,
    }
}
