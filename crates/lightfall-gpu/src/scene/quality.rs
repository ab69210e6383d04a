//! Accuracy against time: the steps of the methods that step.

use encase::ShaderType;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::scene::{Quality, Scene};

/// Mirror of `Quality` in shaders/scene.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuQuality {
    pub step_scale: f32,
    pub max_steps: u32,
    pub max_affine: f32,
    pub escape_radius: f32,
    pub min_step: f32,
    pub mino_step: f32,
    pub mino_critical_step: f32,
}

impl GpuQuality {
    /// For a picture whose pixels span `pixel` radians.
    pub(super) fn new(scene: &Scene, kerr: Kerr, pixel: f64) -> Self {
        let (quality, r) = (&scene.quality, scene.camera.r);
        let [mino_step, mino_critical_step] = mino_steps(quality.max_error_px, pixel, kerr, r);
        Self {
            step_scale: quality.step_scale as f32,
            max_steps: quality.max_steps,
            max_affine: quality.max_affine as f32,
            escape_radius: scene.escape_radius() as f32,
            min_step: scene.min_step() as f32,
            mino_step: mino_step as f32,
            mino_critical_step: mino_critical_step as f32,
        }
    }
}

/// The steps of method mino, in radians, where a pixel spans `pixel` radians: of rays that pass far
/// from the critical curve, and of rays that may come near it.
///
/// Measured: the rotation that explains a ray's error is at most 4.5e-4 step^5.5, and mostly below
/// 3e-4 step^5.5. Below a step of 0.25 only f32's rounding is left. Up to 0.53 the places on the
/// disk are right to 1e-5 of their radius in the median of common views, and up to 0.4 the shadow's
/// edge to 2e-6 of its radius. The default setting asks for both; a setting that allows a larger
/// error relaxes both in proportion. With the camera next to a spinning hole the error is up to
/// three times as large, and all rays may come near the curve.
fn mino_steps(max_error_px: f64, pixel: f64, kerr: Kerr, r: f64) -> [f64; 2] {
    let growth = |error: f64| error.powf(1.0 / 5.5);
    let wanted = growth(max_error_px * pixel / 4.5e-4);
    let relaxed = growth((max_error_px / Quality::default().max_error_px).max(1.0));
    let [far, near] = [0.53, 0.4].map(|max_step| wanted.clamp(0.25, max_step * relaxed));
    if kerr.spin != 0.0 && r < 2.0 * kerr.horizon() {
        [0.8 * near; 2]
    } else {
        [far, near]
    }
}
