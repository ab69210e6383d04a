//! Shows the ship's instruments in the lower left corner: two clocks as dials, and values below them. They
//! take their place, and that of the map, before anything that is said.

use super::dial::draw_dial;
use super::map::{map_painter, map_sizes};
use super::needed::KnownNeeds;
use super::places::{PilotNeeds, PilotPlaces, PlacesNow, pilot_places};
use super::values::{Instrument, TIME, instruments_of};
use crate::app::motion::ship::ShipFlight;
use crate::app::state::end_card::EndCard;
use crate::app::state::missions::AskedQuestion;
use crate::app::state::overlays::{Overlays, PathShown};
use crate::app::state::paused::Paused;
use crate::app::state::preferences::Preferences;
use crate::app::ui::hud::board::{BRIGHT, Board, PADDING, QUIET, TEXT, WARNING};
use crate::app::ui::screen::Screen;
use crate::app::ui::theme::ACCENT;
use bevy::prelude::*;
use bevy_egui::egui::{self, Color32, Rect, vec2};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::Clocks;

/// Name of the board.
const NAME: &str = "instruments";
/// Radius of a dial, and the largest width that it and its words take, in points.
const DIAL: f32 = 26.0;
const CLOCK_WIDTH: f32 = 176.0;
/// Room between the dials and the values, and between two values, in points.
const BELOW_DIALS: f32 = 8.0;
const GAP: f32 = 3.0;
/// Width of the labels, in points, and their largest share of the width.
const LABELS: f32 = 128.0;
const MAX_LABELS: f32 = 0.45;
/// Height below which the clocks alone stay beside a card, in points.
const LOW: f32 = 400.0;
/// The instruments that are the last to be left out.
const FIRST: [&str; 2] = ["radius, speed", TIME];
/// Colour of the hand of home's clock.
const HOME: Color32 = Color32::from_rgb(140, 190, 255);

/// A clock: its name, its time in words, and how often its hand has gone round.
struct Clock {
    name: &'static str,
    time: String,
    turns: f64,
    colour: Color32,
}

pub(in crate::app::ui::hud) fn show_instruments(
    mut screen: Screen,
    ship: Res<ShipFlight>,
    (preferences, paused, overlays): (Res<Preferences>, Res<Paused>, Res<Overlays>),
    (end_card, asked): (Res<EndCard>, Res<AskedQuestion>),
    mut places: ResMut<PlacesNow>,
    mut known: Local<KnownNeeds>,
) {
    places.0 = None;
    let Some(voyage) = ship.voyage() else {
        return;
    };
    let Some((context, layout)) = screen.texts() else {
        return;
    };
    let room = layout.above_touch_bar();
    if !room.is_positive() {
        return;
    }
    let units = ship.units(&preferences.settings);
    let attempt = ship.attempt();
    let has_card = end_card.is_open() || asked.question().is_some();
    let needed = known.of(attempt.map(|attempt| &attempt.mission));
    let rows = match has_card && room.height() < LOW {
        true => [0; 3],
        false => needed.most_rows(),
    };
    // The card at the end of a mission has the map beside it.
    let is_over = end_card.is_open() && attempt.is_some_and(|attempt| attempt.is_over());
    let maps = match overlays.path == PathShown::MapAndLine || is_over {
        true => map_sizes(&map_painter(context), voyage.flight.ship.kerr()),
        false => Vec::new(),
    };
    let row = Board::new(context, NAME, 1.0).text("0", TEXT, BRIGHT, f32::INFINITY);
    let needs = PilotNeeds {
        clocks: 2.0 * (DIAL + PADDING.y) + BELOW_DIALS,
        row: row.size().y + GAP,
        rows,
        maps,
    };
    let now = pilot_places(room, &needs);
    places.0 = Some(now);
    let boxes = [(NAME, now.instruments), ("map", now.map)];
    for (name, place) in boxes {
        if let Some(place) = place {
            layout.take(name, place);
        }
    }
    if let Some(place) = now.messages {
        layout.keep_for_messages(place);
    }
    let Some(place) = now.instruments else {
        return;
    };
    let mass = ship.hole_mass(&preferences.settings);
    let clocks = Clocks::new(&voyage.flight.ship);
    let ratio = clocks.far_rate.map(|rate| format!("× {rate:.4}"));
    let clocks = dials(&clocks, ship.dial(), units);
    let mut all = instruments_of(&ship, needed, mass, units);
    if paused.0 {
        for row in all.iter_mut().filter(|row| row.label == TIME) {
            row.value = "stands still".into();
        }
    }
    let shown = shown_rows(all, &now);
    paint(context, place, (&clocks, ratio.as_deref()), &shown);
}

/// The instruments that have room.
fn shown_rows(mut all: Vec<Instrument>, places: &PilotPlaces) -> Vec<Instrument> {
    all.retain(|row| match places.choice {
        0 => true,
        1 => !row.is_minor || row.is_needed,
        _ => row.is_needed,
    });
    if all.len() > places.rows {
        all.sort_by_key(|row| !FIRST.contains(&row.label));
        all.truncate(places.rows);
    }
    all
}

/// The ship's own clock, and home's: the time of clocks far away or, inside the horizon, home's as it is
/// seen.
fn dials(clocks: &Clocks, turn: f64, units: Units) -> [Clock; 2] {
    let clock = |name, time: f64, colour| Clock {
        name,
        time: units.steady_time(time),
        turns: time / turn,
        colour,
    };
    let home = match clocks.far {
        Some(far) => clock("home", far, HOME),
        None => clock("home, seen", clocks.home_seen, HOME),
    };
    [clock("you", clocks.own, ACCENT), home]
}

/// Paints the board into its box. What is too long for a line ends in an ellipsis.
fn paint(
    context: &egui::Context,
    place: Rect,
    (clocks, ratio): (&[Clock; 2], Option<&str>),
    shown: &[Instrument],
) {
    let mut board = Board::new(context, NAME, 1.0);
    let inside = Board::inside(place);
    let clock_width = CLOCK_WIDTH.min(0.5 * inside.width());
    let beside = 2.0 * DIAL + 8.0;
    for (index, clock) in clocks.iter().enumerate() {
        let left = index as f32 * clock_width + beside;
        let width = clock_width - beside - 4.0;
        let name = match (index, ratio) {
            (1, Some(ratio)) => format!("{} {ratio}", clock.name),
            _ => clock.name.to_owned(),
        };
        board.put(vec2(left, 6.0), board.line(&name, TEXT, QUIET, width));
        board.put(
            vec2(left, 26.0),
            board.line(&clock.time, TEXT, BRIGHT, width),
        );
    }
    let labels = LABELS.min(MAX_LABELS * inside.width());
    let mut top = 2.0 * DIAL + BELOW_DIALS;
    for instrument in shown {
        let label = board.line(instrument.label, TEXT, QUIET, labels);
        let height = label.size().y;
        board.put(vec2(0.0, top), label);
        let colour = if instrument.is_warning {
            WARNING
        } else {
            BRIGHT
        };
        let width = inside.width() - labels;
        board.put(
            vec2(labels, top),
            board.line(&instrument.value, TEXT, colour, width),
        );
        top += height + GAP;
    }
    let painter = board.painter();
    board.paint_at(place);
    for (index, clock) in clocks.iter().enumerate() {
        let middle = inside.min + vec2(index as f32 * clock_width + DIAL, DIAL);
        draw_dial(&painter, middle, DIAL, clock.turns, clock.colour);
    }
}
