//! Shows the ship's instruments in the lower left corner: two clocks as dials, and values below them.

use super::dial::draw_dial;
use super::values::{Instrument, TIME, instruments};
use crate::app::motion::ship::ShipFlight;
use crate::app::state::paused::Paused;
use crate::app::state::preferences::Preferences;
use crate::app::ui::hud::board::{BRIGHT, Board, QUIET, TEXT, WARNING};
use crate::app::ui::layout::{Layout, Slide, Wish};
use crate::app::ui::screen::Screen;
use crate::app::ui::theme::ACCENT;
use bevy::prelude::*;
use bevy_egui::egui::{self, Align2, Color32, vec2};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::Clocks;

/// Name of the board.
const NAME: &str = "instruments";
/// Radius of a dial, and the width that it and its words take, in points.
const DIAL: f32 = 26.0;
const CLOCK_WIDTH: f32 = 176.0;
/// Room between the dials and the values, and between two values, in points.
const BELOW_DIALS: f32 = 8.0;
const GAP: f32 = 3.0;
/// Width of the labels, in points.
const LABELS: f32 = 128.0;
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
    (preferences, paused): (Res<Preferences>, Res<Paused>),
) {
    let Some(voyage) = ship.voyage() else {
        return;
    };
    let Some((context, layout)) = screen.texts() else {
        return;
    };
    let units = ship.units(&preferences.settings);
    let mass = ship.hole_mass(&preferences.settings);
    let clocks = Clocks::new(&voyage.flight.ship);
    let ratio = clocks.far_rate.map(|rate| format!("× {rate:.4}"));
    let clocks = dials(&clocks, ship.dial(), units);
    let mut all = instruments(&ship, mass, units);
    if paused.0 {
        for row in all.iter_mut().filter(|row| row.label == TIME) {
            row.value = "stands still".into();
        }
    }
    let rows = |is_shown: fn(&Instrument) -> bool| -> Vec<Instrument> {
        all.iter().filter(|row| is_shown(row)).cloned().collect()
    };
    let main = rows(|row| !row.is_minor || row.is_needed);
    let needed = rows(|row| row.is_needed);
    // They stay in their corner, over the hole rather than elsewhere.
    let wish = |slide| layout.at(Align2::LEFT_BOTTOM, slide);
    let corner = wish(Slide::Nowhere);
    let tries = [
        (corner, &all),
        (corner, &main),
        (corner.even_over_hole(), &main),
        (corner.even_over_hole(), &needed),
        (wish(Slide::Upright).even_over_hole(), &needed),
        (wish(Slide::Anywhere).even_over_hole(), &needed),
    ];
    for (wish, shown) in tries {
        if paint((context, layout), wish, (&clocks, ratio.as_deref()), shown) {
            break;
        }
    }
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

/// Paints the board. Returns whether there is room.
fn paint(
    (context, layout): (&egui::Context, &mut Layout),
    wish: Wish,
    (clocks, ratio): (&[Clock; 2], Option<&str>),
    shown: &[Instrument],
) -> bool {
    let mut board = Board::new(context, NAME, 1.0);
    let beside = 2.0 * DIAL + 8.0;
    for (index, clock) in clocks.iter().enumerate() {
        let left = index as f32 * CLOCK_WIDTH + beside;
        let name = match (index, ratio) {
            (1, Some(ratio)) => format!("{} {ratio}", clock.name),
            _ => clock.name.to_owned(),
        };
        board.put(
            vec2(left, 6.0),
            board.text(&name, TEXT, QUIET, f32::INFINITY),
        );
        board.put(
            vec2(left, 26.0),
            board.text(&clock.time, TEXT, BRIGHT, f32::INFINITY),
        );
    }
    let mut top = 2.0 * DIAL + BELOW_DIALS;
    for instrument in shown {
        let label = board.text(instrument.label, TEXT, QUIET, f32::INFINITY);
        let height = label.size().y;
        board.put(vec2(0.0, top), label);
        let colour = if instrument.is_warning {
            WARNING
        } else {
            BRIGHT
        };
        board.put(
            vec2(LABELS, top),
            board.text(&instrument.value, TEXT, colour, f32::INFINITY),
        );
        top += height + GAP;
    }
    board.widen(2.0 * CLOCK_WIDTH);
    let painter = board.painter();
    let Some(place) = board.paint(layout, wish) else {
        return false;
    };
    let inside = Board::inside(place).min;
    for (index, clock) in clocks.iter().enumerate() {
        let middle = inside + vec2(index as f32 * CLOCK_WIDTH + DIAL, DIAL);
        draw_dial(&painter, middle, DIAL, clock.turns, clock.colour);
    }
    true
}
