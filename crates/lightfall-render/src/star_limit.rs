//! How much work stars may be. A window on a slow adapter has stricter limits; stills draw as deep as
//! their pixels show.

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::gpu::stars::MAX_TRACED;
use lightfall_core::optics::stars::MAX_MAGNITUDE;
use wgpu::DeviceType;

/// The limits in a window on a software renderer.
const LIMIT_ON_CPU: StarLimit = StarLimit {
    // 80 000 stars take it a few milliseconds without spin, and a twentieth of a second with it.
    faintest: 8.5,
    // An eighth of what other devices follow. Pictures from outside have some thousands.
    traced: 1 << 14,
};

/// Which stars are drawn as points at most.
#[derive(Resource, Clone, Copy, Debug, PartialEq, ExtractResource)]
pub struct StarLimit {
    /// The faintest V. The Milky Way holds the light of all fainter stars.
    pub faintest: f64,
    /// How many candidates for images rays follow. Where there are more, the faintest stars are left
    /// out.
    pub traced: u32,
}

impl Default for StarLimit {
    fn default() -> Self {
        Self {
            faintest: MAX_MAGNITUDE,
            traced: MAX_TRACED,
        }
    }
}

impl StarLimit {
    /// The limit of a window on an adapter of this kind.
    #[must_use]
    pub fn of_window(kind: DeviceType) -> Self {
        if kind == DeviceType::Cpu {
            LIMIT_ON_CPU
        } else {
            Self::default()
        }
    }
}
