//! Pausing a journey, a fall or the disk's clock, and going on.

use super::free_fall::FreeFall;
use super::journey_player::JourneyPlayer;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::state::paused::Paused;
use crate::app::state::toast::Toast;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use lightfall_render::CurrentScene;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, (apply_pause_command, end_pause));
}

/// What can be paused.
#[derive(SystemParam)]
struct Motion<'w> {
    player: Res<'w, JourneyPlayer>,
    free_fall: Res<'w, FreeFall>,
    scene: Res<'w, CurrentScene>,
}

impl Motion<'_> {
    fn is_any(&self) -> bool {
        self.player.is_playing() || self.free_fall.is_moving() || self.scene.disk_moves()
    }
}

/// Ends the pause when nothing is left to pause.
fn end_pause(motion: Motion, mut moved: Local<bool>, mut paused: ResMut<Paused>) {
    let moves = motion.is_any();
    if *moved && !moves {
        paused.0 = false;
    }
    *moved = moves;
}

fn apply_pause_command(
    mut commands: MessageReader<AppCommand>,
    motion: Motion,
    bindings: Res<Bindings>,
    mut paused: ResMut<Paused>,
    mut toast: ResMut<Toast>,
) {
    for _ in 0..AppCommand::Pause.count(&mut commands) {
        let moves = motion.is_any();
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
