//! How much detail a window draws on a slow adapter. Stills draw all that a scene asks for.

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::gpu::stars::MAX_TRACED;
use lightfall_core::optics::stars::MAX_MAGNITUDE;
use wgpu::DeviceType;

/// The limits in a window on a software renderer.
const LIMITS_ON_CPU: DetailLimits = DetailLimits {
    // The processor sums up the waves. With fewer, single waves can be told apart.
    waves: Some(12),
    // 80 000 stars take it a few milliseconds without spin, and a twentieth of a second with it.
    faintest_star: 8.5,
    // An eighth of what other devices follow. Pictures from outside have some thousands.
    traced_stars: 1 << 14,
};

/// The most waves and the faintest stars that are drawn.
#[derive(Resource, Clone, Copy, Debug, PartialEq, ExtractResource)]
pub struct DetailLimits {
    /// The most waves of each ring of the disk's structure. `None`: as many as the scene says.
    pub waves: Option<u32>,
    /// The faintest V of a star that is drawn as a point. The Milky Way holds the light of all
    /// fainter stars.
    pub faintest_star: f64,
    /// How many candidates for images of stars rays follow. Where there are more, the faintest stars
    /// are left out.
    pub traced_stars: u32,
}

impl Default for DetailLimits {
    fn default() -> Self {
        Self {
            waves: None,
            faintest_star: MAX_MAGNITUDE,
            traced_stars: MAX_TRACED,
        }
    }
}

impl DetailLimits {
    /// The limits of a window on an adapter of this kind.
    #[must_use]
    pub fn of_window(kind: DeviceType) -> Self {
        if kind == DeviceType::Cpu {
            LIMITS_ON_CPU
        } else {
            Self::default()
        }
    }

    /// How many of a scene's waves are drawn.
    #[must_use]
    pub fn drawn_waves(self, waves: u32) -> u32 {
        self.waves.map_or(waves, |most| waves.min(most))
    }
}
