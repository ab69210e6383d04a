//! The read-outs of a ship's flight: its clocks, and its error.

use super::readouts_page::{clock, table};
use bevy_egui::egui;
use lightfall_core::geometry::ship::Ship;
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::Clocks;

/// The clocks of the ship and, where words are not simple, the error of its flight.
pub(super) fn show(ui: &mut egui::Ui, ship: &Ship, (mass, units): (HoleMass, Units)) {
    let clocks = Clocks::new(ship);
    let both = |time: f64| clock(time, (mass, units));
    let far = clocks
        .far
        .map_or_else(|| "not defined here".to_owned(), both);
    let rows = [("Own time", both(clocks.own)), ("Far time", far)];
    table(ui, "Clocks of the ship", &rows);
    if !units.are_simple() {
        table(ui, "Error of its flight", &flight_error(ship));
    }
}

/// The error of a flight so far, by measures that do not depend on each other: the stated one of the
/// steps, that of the length of the four-velocity, the difference from the geodesic with the engine
/// off, and what is left of E, L and K' after the engine's work.
#[must_use]
pub fn flight_error(ship: &Ship) -> [(&'static str, String); 6] {
    let error = ship.error();
    let [energy, angular_momentum, carter] = ship.balance();
    [
        ("Stated error", error.stated()),
        ("Length of the velocity", error.norm),
        ("Beside the geodesic", error.geodesic),
        ("Balance of E", energy),
        ("Balance of L", angular_momentum),
        ("Balance of K'", carter),
    ]
    .map(|(name, error)| (name, size(error)))
}

/// An error with one digit and its power of ten.
fn size(error: f64) -> String {
    match error {
        0.0 => "0".into(),
        _ => format!("{error:.0e}"),
    }
}
