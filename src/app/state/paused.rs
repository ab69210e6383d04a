//! Whether journeys, falls and the disk's clock are paused.

use bevy::prelude::Resource;

/// While this is set, a journey, a fall and the disk stand still where they are, and the camera can
/// still be turned or flown by hand.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Paused(pub(crate) bool);
