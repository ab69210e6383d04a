//! The hole's part of the uniform.

use encase::ShaderType;
use lightfall_model::geometry::kerr::Kerr;

/// Mirror of `Hole` in shaders/scene.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuHole {
    pub a: f32,
    pub one_minus_spin: f32,
    pub horizon: f32,
    pub inner_horizon: f32,
    pub horizon_separation: f32,
    pub horizon_u: f32,
    pub horizon_u_low: f32,
}

impl GpuHole {
    pub(super) fn new(kerr: Kerr) -> Self {
        let horizon_u = 1.0 / kerr.horizon();
        Self {
            a: kerr.a() as f32,
            one_minus_spin: (1.0 - kerr.spin) as f32,
            horizon: kerr.horizon() as f32,
            inner_horizon: kerr.inner_horizon() as f32,
            // r_+ - r_- = sqrt(1 - chi^2), without the cancellation of a difference.
            horizon_separation: ((1.0 - kerr.spin) * (1.0 + kerr.spin)).sqrt() as f32,
            horizon_u: horizon_u as f32,
            horizon_u_low: (horizon_u - f64::from(horizon_u as f32)) as f32,
        }
    }
}
