//! What the ship's pilot hears.

use bevy::prelude::Resource;
use lightfall_core::optics::sound::Readings;

/// A note for users of a build without sound; `None` in one that has it.
pub const NO_SOUND: Option<&str> = if cfg!(feature = "sound") {
    None
} else {
    Some(
        "This build plays no sound; ./play makes one that does where libasound2-dev and pkg-config are installed.",
    )
};

/// Why the sound cannot be heard, in the words of the log, once a device was asked for.
#[derive(Resource, Clone, Debug, Default, PartialEq)]
pub struct SoundFault(pub Option<String>);

/// The readings that the sound follows in this frame.
#[derive(Resource, Clone, Copy, Debug, PartialEq)]
pub struct CockpitSound {
    /// The readings. Their volume is zero while nobody listens.
    pub readings: Readings,
    /// Whether a device may be opened to play it. Tests open none.
    pub may_play: bool,
}

impl Default for CockpitSound {
    fn default() -> Self {
        Self {
            readings: Readings::SILENCE,
            may_play: true,
        }
    }
}
