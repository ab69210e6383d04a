//! A screenshot of the window that waits for a sharp picture.

use bevy::prelude::Resource;
use std::time::Duration;

/// Longest time for which it waits: the picture of somebody who flies on and on never rests.
const MAX_WAIT: Duration = Duration::from_secs(30);

/// Whether a screenshot of the window waits. Meanwhile falls, journeys and the disk's clock stand
/// still, and no message is shown.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WindowShot {
    /// None was asked for.
    #[default]
    None,
    /// One was asked for at this time since the start.
    Waits(Duration),
    /// It shows this frame.
    Taken,
}

impl WindowShot {
    /// Whether nothing may move, nor a message be shown.
    pub(crate) fn holds_still(self) -> bool {
        self != Self::None
    }

    /// The state in the next frame, at the time `now`.
    #[must_use]
    pub fn next(self, asked: bool, is_sharp: bool, now: Duration) -> Self {
        match self {
            Self::Waits(since) if is_sharp || now.saturating_sub(since) > MAX_WAIT => Self::Taken,
            Self::Waits(_) => self,
            Self::None | Self::Taken if asked => Self::Waits(now),
            Self::None | Self::Taken => Self::None,
        }
    }
}
