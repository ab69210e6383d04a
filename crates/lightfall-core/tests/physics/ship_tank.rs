//! The tank of a ship empties, whatever its clock shows.

use crate::random::Random;
use crate::ship_flights::ship;
use glam::DVec3;
use lightfall_core::optics::ship::{Flight, Heading, Hold, Orders, Rocket, Thrust};
use std::f64::consts::FRAC_PI_2;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// A flight takes some milliseconds. One that makes no progress would never end.
const PATIENCE: Duration = Duration::from_secs(60);

/// A ship that falls far out, whose clock shows `time`, with a tank of this rapidity.
fn old_ship(time: f64, rapidity: f64) -> Flight {
    let rocket = Rocket::new(rapidity, 3.0, 1.0).unwrap();
    let mut flight = Flight::new(ship(0.9, 1e5, FRAC_PI_2, DVec3::ZERO), rocket);
    flight.order(Orders {
        thrust: Thrust::Axes(1e-7 * DVec3::X),
        ..Orders::COAST
    });
    flight.advance(time).unwrap();
    flight
}

/// A burn of a few ten times the rounding of the clock leaves a rest of the tank that is smaller than it.
#[test]
fn random_tanks_empty_at_the_end_of_a_burn_however_late_it_is() {
    let mut random = Random::new();
    for number in 0..300 {
        let (time, rapidity) = (random.log_between(1.0, 1e4), random.log_between(0.01, 2.0));
        let acceleration = random.log_between(0.01, 3.0);
        let thrust = match random.integer(0, 2) {
            0 => Thrust::Axes(acceleration * random.direction()),
            1 => Thrust::Along(Heading::Retrograde, acceleration),
            _ => Thrust::Hold(Hold::Hover(random.between(9e4, 1.1e5)), acceleration),
        };
        let (sender, receiver) = mpsc::channel();
        thread::spawn(move || {
            let mut flight = old_ship(time, rapidity);
            flight.order(Orders {
                thrust,
                ..Orders::COAST
            });
            let burn = flight.rocket.time_left(acceleration);
            let event = flight.advance(1.5 * burn);
            // Nobody listens after the patience is at an end.
            sender.send((event, flight.rocket.left())).ok();
        });
        let what = format!("{number}: {thrust:?} at {time}, {rapidity}");
        let (event, left) = receiver
            .recv_timeout(PATIENCE)
            .unwrap_or_else(|_| panic!("{what} does not end"));
        event.unwrap_or_else(|error| panic!("{what}: {error}"));
        if !matches!(thrust, Thrust::Hold(..)) {
            assert_eq!(left, 0.0, "{what}");
        }
    }
}
