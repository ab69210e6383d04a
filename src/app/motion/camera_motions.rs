//! What moves or turns the camera by itself, apart from the ship.

use super::facing::Facing;
use super::free_fall::FreeFall;
use super::journey_player::JourneyPlayer;
use crate::app::state::paused::Paused;
use bevy::ecs::system::SystemParam;
use bevy::prelude::ResMut;

/// The motions of a camera that nobody flies, and the pause.
#[derive(SystemParam)]
pub(super) struct CameraMotions<'w> {
    free_fall: ResMut<'w, FreeFall>,
    player: ResMut<'w, JourneyPlayer>,
    facing: ResMut<'w, Facing>,
    paused: ResMut<'w, Paused>,
}

impl CameraMotions<'_> {
    /// Ends them and the pause, so that the ship alone moves.
    pub(super) fn end(&mut self) {
        self.free_fall.stop();
        self.player.stop();
        self.facing.stop();
        self.paused.0 = false;
    }
}
