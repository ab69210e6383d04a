//! How many frames are averaged for a picture at rest, where the scene asks for fewer.

use crate::chain::Chain;
use bevy::prelude::*;

/// Number of frames that a window averages at rest. With edges refined in each of them, more frames
/// make no visible difference.
pub(super) const FRAMES_AT_REST: u32 = 16;

/// How many frames are averaged while a picture rests. The scene's own number counts where it is
/// larger.
#[derive(Resource, Clone, Copy, Debug, PartialEq, Eq)]
pub struct RestingFrames {
    /// The least number of frames.
    pub least: u32,
    /// Whether one frame is shown before the first that is averaged, so that a picture that changes
    /// in every frame never pays for a mean.
    pub first_alone: bool,
    /// Which frames refine edges with fewer rays.
    pub quick: QuickFrames,
}

/// Which frames refine edges with fewer rays, on an adapter that takes long for them. While something
/// moves every frame is the first of its picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuickFrames {
    /// None.
    None,
    /// The first frame of a picture.
    First,
    /// All of them.
    All,
}

impl Default for RestingFrames {
    /// As many frames as the scene asks for, from the first on: for pictures without a window.
    fn default() -> Self {
        Self {
            least: 1,
            first_alone: false,
            quick: QuickFrames::None,
        }
    }
}

impl RestingFrames {
    /// The frames of a window. `averages`: whether it averages frames at rest. `software`: whether
    /// it runs on a software renderer.
    #[must_use]
    pub fn of_window(averages: bool, software: bool) -> Self {
        Self {
            least: if averages { FRAMES_AT_REST } else { 1 },
            first_alone: true,
            quick: if software {
                QuickFrames::First
            } else {
                QuickFrames::None
            },
        }
    }

    /// One frame as a window on a software renderer shows it while something moves.
    #[must_use]
    pub fn in_motion() -> Self {
        Self {
            quick: QuickFrames::All,
            ..Self::default()
        }
    }

    /// Whether a frame outside the mean is drawn first, where a chain averages `frames` frames.
    pub(super) fn has_first(self, chain: &Chain, frames: u32) -> bool {
        self.first_alone && (frames > 1 || self.quick == QuickFrames::First && chain.antialias)
    }

    /// The number of frames of a chain's picture.
    pub(super) fn of(self, chain: &Chain) -> u32 {
        if chain.shows_light {
            chain.frames.max(self.least)
        } else {
            1
        }
    }
}
