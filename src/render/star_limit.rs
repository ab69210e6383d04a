//! How faint the stars are that are drawn as points at most. A window on a slow adapter stops
//! earlier; stills draw as deep as their pixels show.

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::optics::stars::MAX_MAGNITUDE;
use wgpu::DeviceType;

/// The faintest V in a window on a software renderer: 80 000 stars take it a few milliseconds.
const FAINTEST_ON_CPU: f64 = 8.5;

/// The faintest V that is drawn as a point. The Milky Way holds the light of all fainter stars.
#[derive(Resource, Clone, Copy, Debug, PartialEq, ExtractResource)]
pub struct StarLimit(pub f64);

impl Default for StarLimit {
    fn default() -> Self {
        Self(MAX_MAGNITUDE)
    }
}

impl StarLimit {
    /// The limit of a window on an adapter of this kind.
    #[must_use]
    pub fn of_window(kind: DeviceType) -> Self {
        if kind == DeviceType::Cpu {
            Self(FAINTEST_ON_CPU)
        } else {
            Self::default()
        }
    }
}
