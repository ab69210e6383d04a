//! What the stops of a journey switch around the picture: guides, the comparison and the ray inspector.
//! When the journey is left, all that its stops have switched is put back.

use super::journey::{advance_journey, put_fields_back};
use super::journey_player::{JourneyPlayer, ShownStops};
use super::ship::ShipFlight;
use crate::app::state::end_card::{Closes, EndCard};
use crate::app::state::lessons::{AskedRay, LessonUnderWay};
use crate::app::state::overlays::{Overlays, Side};
use crate::app::state::scene_editor::SceneEditor;
use bevy::prelude::*;
use lightfall_core::scene::journey::{InspectorView, SideBySide, Switches};
use lightfall_render::{Comparison, ComparisonMode, Pinned};

/// What was shown before the stops switched anything, and what they have switched since.
#[derive(Resource, Default)]
struct Stage {
    before: Option<Around>,
    shown: Option<ShownStops>,
}

/// What is shown around the picture.
struct Around {
    guides: bool,
    inspector: bool,
    comparison: Option<(Pinned, ComparisonMode)>,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Stage>()
        .add_systems(Update, follow_stops.after(advance_journey));
}

fn follow_stops(
    mut player: ResMut<JourneyPlayer>,
    mut stage: ResMut<Stage>,
    mut overlays: ResMut<Overlays>,
    mut comparison: ResMut<Comparison>,
    mut asked: ResMut<AskedRay>,
    mut under_way: ResMut<LessonUnderWay>,
    (end_card, ship): (Res<EndCard>, Res<ShipFlight>),
    mut editor: SceneEditor,
) {
    under_way.set_if_neq(LessonUnderWay {
        is_flown: player.has_lesson(),
        asks: player
            .waits_at()
            .is_some_and(|(stop, _)| stop.question.is_some()),
    });
    let shown = player.shown_stops().filter(|_| player.has_lesson());
    let Some(now) = shown else {
        // The card at the end stands over the last stop's picture. The cards of missions close
        // otherwise.
        let has_card = end_card.is_open() && end_card.closes == Closes::Anything;
        if player.has_lesson() || stage.before.is_some() && has_card {
            return;
        }
        if !player.is_playing() {
            put_fields_back(&mut player, &mut editor);
        }
        // Nothing is touched without need, since a comparison that changes is drawn again.
        if let Some(before) = stage.before.take() {
            // A mission has the picture for itself.
            let come_back = ship.attempt().is_none();
            overlays.guides = before.guides;
            overlays.show_side(Side::Left, come_back && before.inspector);
            comparison.0 = before.comparison.filter(|_| come_back);
            asked.0 = None;
        }
        return;
    };
    if stage.before.is_some() && stage.shown == Some(now) {
        return;
    }
    let before = stage.before.get_or_insert_with(|| Around {
        guides: overlays.guides,
        inspector: overlays.inspector,
        comparison: comparison.0.clone(),
    });
    let switches = player.journey().switches_of(now.stops);
    overlays.guides = switches.guides.unwrap_or(before.guides);
    // An inspector or a comparison from before the lesson would cover what its stops show.
    let inspects = switches.inspector.map(|view| view != InspectorView::Closed);
    overlays.show_side(Side::Left, inspects.unwrap_or(false));
    asked.set_if_neq(AskedRay(switches.inspector));
    let compared = compared(&player, &switches);
    // Nothing is touched without need, as above.
    if compared.is_some() || comparison.0.is_some() {
        comparison.0 = compared;
    }
    stage.shown = Some(now);
}

/// The comparison after these switches: with what the stops before had led to.
fn compared(player: &JourneyPlayer, switches: &Switches) -> Option<(Pinned, ComparisonMode)> {
    let divider = ComparisonMode::MIDDLE;
    let mode = match switches.side_by_side {
        None | Some(SideBySide::Off) => return None,
        Some(SideBySide::Divided) => ComparisonMode::SideBySide { divider },
        Some(SideBySide::TwoPictures) => ComparisonMode::TwoPictures,
    };
    Some((Pinned::new(&player.beside(switches)?), mode))
}
