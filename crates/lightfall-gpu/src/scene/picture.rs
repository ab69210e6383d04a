//! The picture's part of the uniform.

use encase::ShaderType;
use glam::{UVec2, Vec2};
use lightfall_model::scene::{Frame, Scene};
use lightfall_optics::pixel_samples::pixel_offset;

/// Light of a mark after exposure: below the light at which tone mapping begins to bleach colours.
pub const MARK_BRIGHTNESS: f64 = 0.7;

/// Steps per pixel in which rays are placed. So the middle of every pixel of the largest picture plus
/// an offset is exact in f32, and a part of a picture has the rays of the whole one.
const PLACES_PER_PIXEL: f64 = 256.0;

/// Mirror of `Picture` in shaders/scene.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuPicture {
    pub whole: Vec2,
    pub origin: UVec2,
    pub size: Vec2,
    pub corner: Vec2,
    pub projection: Vec2,
    pub mark_brightness: f32,
    pub exposure: f32,
    pub offset: Vec2,
    pub footprint: f32,
    pub middle_solid_angle: f32,
    pub axis: Vec2,
    pub layers: u32,
}

impl GpuPicture {
    /// The numbers of a frame of the scene.
    pub fn new(scene: &Scene, frame: &Frame) -> Self {
        let whole = frame.whole.max(UVec2::ONE).as_dvec2();
        let exposure = frame.exposure_ev.exp2();
        Self {
            whole: whole.as_vec2(),
            origin: frame.origin,
            size: frame.size.max(UVec2::ONE).as_vec2(),
            corner: frame.corner.as_vec2(),
            projection: scene.camera.projection_numbers(whole).as_vec2(),
            mark_brightness: (MARK_BRIGHTNESS / exposure) as f32,
            exposure: exposure as f32,
            offset: ((pixel_offset(frame.sample) * PLACES_PER_PIXEL).round() / PLACES_PER_PIXEL)
                .as_vec2(),
            footprint: f64::from(frame.samples.max(1)).sqrt().recip() as f32,
            middle_solid_angle: scene.camera.solid_angle(scene.camera.axis(whole), whole) as f32,
            axis: scene.camera.axis_across(whole).as_vec2(),
            // The passes write those that they draw.
            layers: 0,
        }
    }
}
