//! Announces that a fall, a journey or the ship crosses the horizon.

use super::free_fall::FreeFall;
use super::journey_player::JourneyPlayer;
use super::steering::is_inside;
use crate::app::state::helm::Helm;
use crate::app::state::notice::Notice;
use bevy::prelude::*;
use lightfall_render::CurrentScene;

/// Announces the crossing of the horizon. `was_inside` is None before the first frame.
pub(crate) fn announce_crossing(
    scene: Res<CurrentScene>,
    free_fall: Res<FreeFall>,
    player: Res<JourneyPlayer>,
    helm: Res<Helm>,
    mut notice: ResMut<Notice>,
    mut was_inside: Local<Option<bool>>,
) {
    if !scene.is_changed() {
        return;
    }
    let is_inside = is_inside(&scene);
    let flies_itself = free_fall.is_moving() || player.is_playing() || helm.has_ship();
    if is_inside && *was_inside == Some(false) && flies_itself {
        *notice = Notice::new([
            "You have crossed the horizon",
            "From here no signal can get out",
        ]);
    } else if !is_inside {
        *notice = Notice::default();
    }
    *was_inside = Some(is_inside);
}
