//! The uniform of the hot spot, in a binding of its own: only scenes with a spot read it.

use super::time_lead;
use encase::ShaderType;
use lightfall_model::scene::Scene;
use lightfall_optics::hot_spot::{FINEST_SHEARED, HotSpot};

/// Mirror of `HotSpot` in shaders/disk/hot_spot/spot.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuHotSpot {
    pub inverse_r: f32,
    pub angular_velocity: f32,
    pub azimuth: f32,
    pub elapsed: f32,
    pub size: f32,
    pub strength: f32,
    pub inverse_duration: f32,
    pub finest: f32,
}

impl GpuHotSpot {
    /// The scene's hot spot; zeros if it has none.
    pub fn new(scene: &Scene) -> Self {
        let Some(moving) = HotSpot::new(scene) else {
            return Self::default();
        };
        let (spot, clock) = (
            scene.hot_spot,
            scene.disk.time - time_lead(scene).unwrap_or(0.0),
        );
        Self {
            inverse_r: (1.0 / spot.r) as f32,
            angular_velocity: moving.angular_velocity() as f32,
            azimuth: moving.azimuth(clock) as f32,
            elapsed: (clock - spot.time) as f32,
            size: spot.size as f32,
            strength: spot.strength as f32,
            inverse_duration: if spot.duration > 0.0 {
                (1.0 / spot.duration) as f32
            } else {
                0.0
            },
            finest: FINEST_SHEARED as f32,
        }
    }
}
