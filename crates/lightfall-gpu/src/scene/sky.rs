//! The sky's part of the uniform.

use encase::ShaderType;
use glam::{DVec2, Vec3};
use lightfall_model::geometry::sphere::celestial_frame;
use lightfall_model::scene::Scene;

/// Radius of the image of a star or line, in pixels. Smaller images flicker as the camera turns.
const SPOT_PIXELS: f64 = 1.5;

/// Height of the picture, in pixels, for which the brightness of stars is defined. A star's flux
/// does not depend on the picture, so it is four times as bright on a pixel half as wide.
const SPOT_HEIGHT: f64 = 540.0;

/// Mirror of `Sky` in shaders/scene.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuSky {
    pub reference_star: Vec3,
    pub brightness: f32,
    pub spot_radius: f32,
    pub star_brightness: f32,
    pub seed: u32,
}

impl GpuSky {
    /// For a picture of `size` pixels.
    pub(super) fn new(scene: &Scene, size: DVec2) -> Self {
        let sky = &scene.sky;
        let [reference_star, ..] = celestial_frame(
            sky.reference_theta_deg.to_radians(),
            sky.reference_phi_deg.to_radians(),
        );
        Self {
            reference_star: (scene.disk.hole_from_disk().transpose() * reference_star).as_vec3(),
            brightness: sky.brightness as f32,
            spot_radius: (SPOT_PIXELS * scene.camera.pixel_angle(size)) as f32,
            star_brightness: (size.y / SPOT_HEIGHT).powi(2) as f32,
            seed: sky.seed,
        }
    }
}
