//! The error of a ship's flight, as the panel shows it.

use lightfall::app::flight_error;
use lightfall_core::geometry::ship::{Controls, Ship};
use lightfall_core::optics::ship::{Mount, board};
use lightfall_core::scene::presets;

/// A flight with thrust, with steps of this tolerance.
fn flown(tolerance: f64) -> Ship {
    let scene = presets::find("close").unwrap().plain_scene();
    let ship = board(scene, &Mount::NOSE).unwrap();
    let mut ship = ship.with_tolerance(tolerance).unwrap();
    let controls = Controls {
        acceleration: [0.05, 0.02, 0.0].into(),
        rotation: [0.0, 0.1, 0.2].into(),
    };
    assert_eq!(ship.advance(&controls, 5.0), Ok(None));
    ship
}

/// The rows follow the size of the flight's errors, whatever that is: coarse steps make all of those
/// that thrust has larger.
#[test]
fn the_panel_shows_the_stated_error_and_the_three_balances() {
    let fine = flight_error(&flown(3e-15));
    let coarse = flight_error(&flown(1e-6));
    let names = fine.each_ref().map(|(name, _)| *name);
    assert_eq!(
        names,
        [
            "Stated error",
            "Length of the velocity",
            "Beside the geodesic",
            "Balance of E",
            "Balance of L",
            "Balance of K'"
        ]
    );
    for ((name, fine), (_, coarse)) in fine.into_iter().zip(coarse) {
        let [fine, coarse]: [f64; 2] = [fine, coarse].map(|text| text.parse().unwrap());
        if name == "Beside the geodesic" {
            // The engine was never off.
            assert_eq!([fine, coarse], [0.0; 2]);
        } else {
            assert!(fine.abs() < 1e-12, "{name}: {fine}");
            assert!(coarse.abs() > 10.0 * fine.abs(), "{name}: {coarse}, {fine}");
        }
    }
}
