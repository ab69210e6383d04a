//! The round of a window for visitors: it flies its journeys one after another, goes on from their stops,
//! and puts everything back to the start when a visitor has left.

use super::journey::{apply_journey_commands, go_on_or_back};
use super::journey_player::JourneyPlayer;
use super::pilot::Pilot;
use crate::app::input::keyboard::undo_last_change;
use crate::app::input::visitor::Visitors;
use crate::app::state::end_card::EndCard;
use crate::app::state::kiosk::{Kiosk, in_kiosk};
use crate::app::state::kiosk_round::{JourneyNow, RoundStep, stop_reading_time};
use crate::app::state::lessons::StartJourney;
use crate::app::state::overlays::Overlays;
use crate::app::state::paused::Paused;
use crate::app::state::scene_editor::SceneEditor;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use lightfall_render::Comparison;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        Update,
        go_round
            .run_if(in_kiosk)
            .after(undo_last_change)
            // A visitor who begins a journey is seen before it is under way.
            .before(apply_journey_commands)
            .before(go_on_or_back),
    );
}

/// What visitors leave as they used it, and the next ones find as it was.
#[derive(SystemParam)]
struct LeftBehind<'w> {
    overlays: ResMut<'w, Overlays>,
    end_card: ResMut<'w, EndCard>,
    comparison: ResMut<'w, Comparison>,
    paused: ResMut<'w, Paused>,
    pilot: ResMut<'w, Pilot>,
}

impl LeftBehind<'_> {
    fn put_back(&mut self) {
        *self.overlays = Overlays::default();
        self.end_card.close();
        Comparison::end(&mut self.comparison);
        self.paused.0 = false;
        self.pilot.let_go();
    }
}

fn go_round(
    time: Res<Time<Real>>,
    mut visitors: Visitors,
    mut kiosk: ResMut<Kiosk>,
    mut player: ResMut<JourneyPlayer>,
    mut editor: SceneEditor,
    mut left: LeftBehind,
    mut starts: MessageWriter<StartJourney>,
) {
    let input = visitors.input();
    let Some(on_show) = &mut kiosk.0 else {
        return;
    };
    let journey = match player.waits_at() {
        Some((stop, _)) if player.rests() => JourneyNow::Waits(stop_reading_time(&stop.caption)),
        _ if player.is_playing() => JourneyNow::Flies,
        _ => JourneyNow::Rests,
    };
    match on_show.round.step(time.elapsed(), input, journey) {
        RoundStep::Stay => {}
        RoundStep::GoOn => player.go_on(&editor.drawn_scene()),
        RoundStep::Begin(number) => {
            let Some(show) = on_show.shows.get(number) else {
                return;
            };
            visitors.claim_held_keys();
            left.put_back();
            editor.begin_anew(&show.scene);
            starts.write(StartJourney(Box::new(show.journey.clone())));
        }
    }
}
