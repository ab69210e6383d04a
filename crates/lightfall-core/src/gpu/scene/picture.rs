//! The picture's part of the uniform.

use crate::scene::Scene;
use encase::ShaderType;
use glam::{DVec2, Vec2};

/// Light of a mark after exposure: below the light at which tone mapping begins to bleach colours.
pub const MARK_BRIGHTNESS: f64 = 0.7;

/// Mirror of `Picture` in shaders/scene.wgsl.
#[expect(missing_docs, reason = "shaders/scene.wgsl says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuPicture {
    pub size: Vec2,
    pub tan_half_fov: Vec2,
    pub mark_brightness: f32,
}

impl GpuPicture {
    pub(super) fn new(scene: &Scene, size: DVec2) -> Self {
        let vertical = scene.camera.half_height();
        Self {
            size: size.as_vec2(),
            tan_half_fov: DVec2::new(vertical * size.x / size.y, vertical).as_vec2(),
            mark_brightness: (MARK_BRIGHTNESS / scene.picture.exposure_ev.exp2()) as f32,
        }
    }
}
