//! The shadow's part of the uniform: the edge of the shadow of a hole without spin.

use crate::error::GpuError;
use encase::ShaderType;
use glam::{DMat3, DVec4, Vec3, Vec4};
use lightfall_model::geometry::observer::ObserverMatrix;
use lightfall_model::geometry::schwarzschild::ShadowEdge;
use lightfall_model::scene::{ObserverKind, Scene};
use lightfall_optics::camera_rays::CameraRays;

/// An observer closer to the horizon than this, in r_s, is moved to this distance outside it.
const NEXT_TO_HORIZON: f64 = 1e-8;

/// Mirror of `Shadow` in shaders/scene.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuShadow {
    pub margin: Vec4,
    pub center: Vec3,
    pub curvature: f32,
    pub twice_critical_radial: f32,
    pub inverse_lapse_squared: f32,
    pub u_to_photon_sphere: f32,
}

impl GpuShadow {
    pub(super) fn new(
        scene: &Scene,
        matrix: &ObserverMatrix,
        tetrad_from_direction: DMat3,
    ) -> Result<Self, GpuError> {
        let (edge, inverse_lapse_squared) = edge(scene, matrix)?;
        let exact_center = tetrad_from_direction.transpose() * edge.center;
        let center = exact_center.as_vec3();
        // The margin is expanded about the rounded center.
        let moved = center.as_dvec3() - exact_center;
        let at_center = edge.margin_at_center + 0.5 * edge.curvature * moved.length_squared();
        let slope = edge.curvature * moved;
        Ok(Self {
            margin: DVec4::new(at_center, slope.x, slope.y, slope.z).as_vec4(),
            center,
            curvature: edge.curvature as f32,
            twice_critical_radial: (2.0 * edge.critical_radial) as f32,
            inverse_lapse_squared: inverse_lapse_squared as f32,
            u_to_photon_sphere: (2.0 / 3.0 - 1.0 / scene.camera.r) as f32,
        })
    }
}

/// The edge of the shadow, and 1/(1 - 1/r).
///
/// Both have a limit on the horizon itself: an observer in free fall there is moved to
/// [`NEXT_TO_HORIZON`] outside, which changes what it sees by no more than that.
fn edge(scene: &Scene, matrix: &ObserverMatrix) -> Result<(ShadowEdge, f64), GpuError> {
    let at = |r: f64, [energy, radial, ..]: [[f64; 4]; 5]| {
        (ShadowEdge::new(energy, radial, r), r / (r - 1.0))
    };
    if scene.observer.kind == ObserverKind::Rain && (scene.camera.r - 1.0).abs() < NEXT_TO_HORIZON {
        let mut outside = scene.clone();
        outside.camera.r = 1.0 + NEXT_TO_HORIZON;
        return Ok(at(outside.camera.r, CameraRays::new(&outside)?.matrix.rows));
    }
    Ok(at(scene.camera.r, matrix.rows))
}
