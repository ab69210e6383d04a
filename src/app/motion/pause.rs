//! Pausing a journey, a fall, the ship or the disk's clock, and going on.

use super::free_fall::FreeFall;
use super::journey_player::JourneyPlayer;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::state::helm::Helm;
use crate::app::state::paused::Paused;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use lightfall_render::CurrentScene;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, pause);
}

/// Pauses and goes on when the key is pressed. Ends the pause when nothing is left to pause.
fn pause(
    mut commands: MessageReader<AppCommand>,
    player: Res<JourneyPlayer>,
    (free_fall, helm): (Res<FreeFall>, Res<Helm>),
    scene: Res<CurrentScene>,
    bindings: Res<Bindings>,
    mut moved: Local<bool>,
    mut paused: ResMut<Paused>,
    mut toast: ResMut<Toast>,
) {
    let moves =
        player.is_playing() || free_fall.is_moving() || helm.has_ship() || scene.disk_moves();
    if *moved && !moves {
        paused.0 = false;
    }
    *moved = moves;
    for _ in 0..AppCommand::Pause.count(&mut commands) {
        paused.0 = moves && !paused.0;
        let [pause, journey, fall] =
            ["motion.pause", "journey.fly", "motion.let_go"].map(|id| bindings.label(id));
        toast.say(if !moves {
            format!("Nothing to pause: {journey} starts the journey, {fall} starts a free fall")
        } else if paused.0 {
            format!("Paused: {pause} goes on")
        } else {
            format!("Goes on: {pause} pauses")
        });
    }
}
