//! How many waves the disk's structure is drawn with at most. A software renderer sums them up on
//! the processor, so the window draws fewer there. Stills have the number of the scene.

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use wgpu::DeviceType;

/// The most waves of a ring that a software renderer draws in a window. With fewer, single
/// waves can be told apart.
const WAVES_ON_CPU: u32 = 12;

/// The most waves that each ring of the disk's structure is drawn with. `None`: as many as the
/// scene says.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq, ExtractResource)]
pub struct WaveLimit(pub Option<u32>);

impl WaveLimit {
    /// The limit of a window on an adapter of this kind.
    #[must_use]
    pub fn of_window(kind: DeviceType) -> Self {
        Self((kind == DeviceType::Cpu).then_some(WAVES_ON_CPU))
    }

    /// The number of waves of a scene that are drawn.
    #[must_use]
    pub fn drawn(self, waves: u32) -> u32 {
        self.0.map_or(waves, |most| waves.min(most))
    }
}
