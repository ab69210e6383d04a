//! How much work a measurement is, for the progress of long commands.

use lightfall_model::scene::{Method, Scene};

/// The work of judging one ray of this scene with the scene's method, in multiples of a ray of the
/// closed form. Stepping methods are often wrong near the critical curve, and finding the turn that
/// explains an error traces many more reference rays. The numbers are rounded measurements, which
/// only decide how evenly a progress bar moves.
pub fn ray_work(scene: &Scene) -> f64 {
    let by_method = match scene.method {
        Method::Verlet | Method::KerrSchild => 2.5,
        _ => 1.0,
    };
    let by_spin = if scene.hole.spin == 0.0 { 1.0 } else { 2.0 };
    by_method * by_spin
}
