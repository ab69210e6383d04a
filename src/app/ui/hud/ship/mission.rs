//! Shows a mission under way: its goals in the upper left corner, and its captions at the top.

use super::places::PlacesNow;
use super::quantities::{Wanted, wanted};
use crate::app::controls::bindings::Bindings;
use crate::app::motion::ship::{MissionPlay, ShipFlight};
use crate::app::state::end_card::EndCard;
use crate::app::state::preferences::Preferences;
use crate::app::ui::hud::board::{BRIGHT, Board, PADDING, QUIET, TEXT, WARNING};
use crate::app::ui::layout::Slide;
use crate::app::ui::screen::Screen;
use bevy::prelude::*;
use bevy_egui::egui::{self, Align2, Color32, Rect};
use lightfall_core::numbers::{four_digits, steady_digits};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::Attempt;

/// Size of captions, in points.
const CAPTION: f32 = 18.0;
/// Largest width of captions, in points.
const MAX_CAPTION: f32 = 460.0;
/// What a pilot without fuel is told, with the names of controls in braces.
const NO_FUEL: &str = "The tank is empty: nothing pushes you any more. You can turn, and let time run. {scene.undo} goes back to the last goal, {journey.again} flies the mission again.";
/// Colour of a quantity that is what the goal wants.
const MET: Color32 = Color32::from_rgb(130, 220, 160);

pub(in crate::app::ui::hud) fn show_mission(
    mut screen: Screen,
    ship: Res<ShipFlight>,
    play: Res<MissionPlay>,
    end_card: Res<EndCard>,
    (bindings, preferences): (Res<Bindings>, Res<Preferences>),
    places: Res<PlacesNow>,
) {
    let (Some(attempt), Some(places)) = (ship.attempt(), places.0) else {
        return;
    };
    let Some((context, layout)) = screen.texts() else {
        return;
    };
    let units = ship.units(&preferences.settings);
    let rows = wanted(attempt, units);
    // Without their values the goals take less room, and the next one takes less than all.
    let (with_values, without): (&[Wanted], &[Wanted]) = (&rows, &[]);
    let tries = [
        (false, with_values),
        (false, without),
        (true, with_values),
        (true, without),
    ];
    let words = (units, &*bindings);
    // Laid out one after another, until one has room.
    let mut boards = tries
        .into_iter()
        .map(|(next_only, rows)| goals(context, (attempt, next_only), rows, (words, places.goals)));
    let has_room = |board: &Board| {
        let size = board.size();
        size.x <= places.goals.width() && size.y <= places.goals.height()
    };
    if let Some(board) = boards.find(has_room) {
        // Over the hole rather than elsewhere.
        let corner = layout.at(Align2::LEFT_TOP, Slide::Nowhere);
        board.paint(layout, corner.even_over_hole());
    }
    let captions = &attempt.mission.captions;
    let caption = play.caption().and_then(|index| captions.get(index));
    let text = if ship.is_empty() && !attempt.is_over() {
        // What a caption asks for takes fuel.
        Some(NO_FUEL)
    } else {
        caption.map(|caption| caption.text.as_str())
    };
    if let Some(text) = text.filter(|_| !end_card.is_open()) {
        let words = bindings.with_keys(&units.in_text(text));
        let board = Board::new(context, "caption", 1.0);
        // The instruments and the message have the lower edge.
        let wish = layout.at(Align2::CENTER_TOP, Slide::Anywhere);
        let wish = wish.even_over_hole();
        board.paint_text(layout, wish, (&words, CAPTION, BRIGHT), MAX_CAPTION);
    }
}

/// The goals or the next one only and, below the next one, its quantities.
fn goals(
    context: &egui::Context,
    (attempt, next_only): (&Attempt, bool),
    rows: &[Wanted],
    ((units, bindings), place): ((Units, &Bindings), Rect),
) -> Board {
    let mission = &attempt.mission;
    let mut board = Board::new(context, "mission", 1.0);
    let width = (place.width() - 2.0 * PADDING.x).max(1.0);
    if !next_only {
        let title = bindings.with_keys(&mission.title);
        board.add_line(board.text(&title, TEXT, WARNING, width), 0.0);
    }
    let reached = attempt.reached().len();
    for (index, goal) in mission.goals.iter().enumerate() {
        let is_next = index == reached && !attempt.is_over();
        if next_only && !is_next {
            continue;
        }
        let sign = if index < reached { "●" } else { "○" };
        let colour = if is_next { BRIGHT } else { QUIET };
        let text = bindings.with_keys(&units.in_text(&goal.text));
        let words = format!("{sign} {text}");
        board.add_line(board.text(&words, TEXT, colour, width), 3.0);
        for row in rows.iter().filter(|_| is_next) {
            let words = format!("     {}  {}  ({})", row.label, row.value, row.wanted);
            let colour = if row.is_met { MET } else { BRIGHT };
            board.add_line(board.text(&words, TEXT, colour, width), 2.0);
        }
        // Also before the time counts, so that the board keeps its height.
        if is_next && goal.hold > 0.0 {
            let now = attempt.voyage().flight.ship.proper_time();
            let held = now - attempt.held_since().unwrap_or(now);
            let [held, all] = [
                units.time(held, steady_digits),
                units.time(goal.hold, four_digits),
            ];
            let words = format!("     held so far  {held}  (≥ {all})");
            board.add_line(board.text(&words, TEXT, BRIGHT, width), 2.0);
        }
    }
    board
}
