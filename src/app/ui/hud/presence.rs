//! The visibility of the read-outs and the keys: while something happens, and for some seconds after.

use crate::app::input::hands::Hands;
use crate::app::motion::free_fall::FreeFall;
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::session::frame_pacing::FramePacing;
use crate::app::state::FADE;
use crate::app::state::helm::Helm;
use crate::app::state::preferences::Preferences;
use bevy::input::mouse::MouseWheel;
use bevy::prelude::*;
use bevy_egui::EguiPreUpdateSet;
use lightfall_render::Progress;
use std::time::Duration;

/// How long the read-outs stay after the last input or motion.
const STAY: Duration = Duration::from_secs(6);
/// How long the mouse counts as moving after its last motion.
const MOUSE_STAY: Duration = Duration::from_secs(3);
/// The opacity of the read-outs and the keys.
#[derive(Resource, Default)]
pub(super) struct Presence {
    /// When something last happened, as a time since the start.
    active: Duration,
    /// When the mouse last moved. None before it does.
    mouse: Option<Duration>,
    now: Duration,
    reduced_motion: bool,
}

impl Presence {
    /// Opacity of the read-outs, from 0 to 1.
    pub(super) fn of_read_outs(&self) -> f32 {
        self.left(self.active + STAY)
    }

    /// Opacity of texts that appear while the mouse moves, from 0 to 1.
    pub(super) fn of_mouse(&self) -> f32 {
        self.mouse
            .map_or(0.0, |moved| self.left(moved + MOUSE_STAY))
    }

    /// Opacity of something that begins to fade at the time `end`.
    fn left(&self, end: Duration) -> f32 {
        let left = (end + FADE).as_secs_f32() - self.now.as_secs_f32();
        self.opacity(f32::INFINITY, left)
    }

    /// Opacity of words that appeared `since` seconds ago and go in `left` seconds. They begin at one
    /// half, so that their first frame is legible.
    pub(super) fn opacity(&self, since: f32, left: f32) -> f32 {
        let fade = FADE.as_secs_f32();
        if self.reduced_motion {
            f32::from(left > 0.0)
        } else {
            (0.5 + 0.5 * since / fade).min(left / fade).clamp(0.0, 1.0)
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Presence>().add_systems(
        PreUpdate,
        watch_input
            .after(bevy::input::InputSystems)
            .after(EguiPreUpdateSet::ProcessInput),
    );
}

fn watch_input(
    time: Res<Time<Real>>,
    hands: Hands,
    mut moves: MessageReader<CursorMoved>,
    mut wheel: MessageReader<MouseWheel>,
    pacing: Res<FramePacing>,
    (free_fall, helm): (Res<FreeFall>, Res<Helm>),
    player: Res<JourneyPlayer>,
    progress: Res<Progress>,
    mut has_picture: Local<bool>,
    preferences: Res<Preferences>,
    mut presence: ResMut<Presence>,
) {
    presence.now = time.elapsed();
    presence.reduced_motion = preferences.settings.reduced_motion;
    let pointed = moves.read().count() + wheel.read().count() > 0;
    let pressed = hands.hold() || hands.keys.get_just_pressed().next().is_some();
    let moves = pacing.moving
        || free_fall.is_moving()
        || player.is_playing() && !player.rests()
        || helm.has_ship();
    // The first seconds count from the first picture, which may take a while to be drawn.
    *has_picture |= progress.is_shown();
    if pointed || pressed || moves || !*has_picture {
        presence.active = presence.now;
    }
    if pointed {
        presence.mouse = Some(presence.now);
    }
}
