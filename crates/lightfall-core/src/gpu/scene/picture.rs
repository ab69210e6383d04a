//! The picture's part of the uniform.

use crate::optics::pixel_samples::pixel_offset;
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
    pub projection: Vec2,
    pub mark_brightness: f32,
    pub exposure: f32,
    pub offset: Vec2,
    pub footprint: f32,
    pub middle_solid_angle: f32,
}

impl GpuPicture {
    /// The numbers of one frame among `frames` that are averaged.
    #[must_use]
    pub fn of_frame(&self, frame: u32, frames: u32) -> Self {
        Self {
            offset: pixel_offset(frame).as_vec2(),
            footprint: f64::from(frames.max(1)).sqrt().recip() as f32,
            ..self.clone()
        }
    }

    pub(super) fn new(scene: &Scene, size: DVec2) -> Self {
        let exposure = scene.picture.exposure_ev.exp2();
        Self {
            size: size.as_vec2(),
            projection: scene.camera.projection_numbers(size).as_vec2(),
            mark_brightness: (MARK_BRIGHTNESS / exposure) as f32,
            exposure: exposure as f32,
            offset: Vec2::ZERO,
            footprint: 1.0,
            middle_solid_angle: scene.camera.solid_angle(0.5 * size, size) as f32,
        }
    }
}
