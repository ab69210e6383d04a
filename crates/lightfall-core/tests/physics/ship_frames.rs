//! Flights under orders, in frames of different lengths, and the fuel they take.

use crate::timelike::scene;
use glam::DVec3;
use lightfall_core::geometry::timelike::Limit;
use lightfall_core::optics::ship::{
    Event, Flight, Heading, Hold, HoldRefusal, Mount, Orders, Rocket, Thrust, board,
};
use lightfall_core::scene::ObserverKind;

fn flight(spin: f64, kind: ObserverKind, r: f64, rapidity: f64) -> Flight {
    let scene = scene(spin, kind, [0.0; 3], r, 90.0);
    let ship = board(&scene, &Mount::NOSE).unwrap();
    Flight::new(ship, Rocket::new(rapidity, 2.0, 1.0).unwrap())
}

fn thrust(thrust: Thrust) -> Orders {
    Orders {
        thrust,
        ..Orders::COAST
    }
}

/// A second in which a part of own time passes, in frames.
fn second(flight: &mut Flight, own: f64, frames: u32) {
    for _ in 0..frames {
        assert_eq!(flight.advance(own / f64::from(frames)), Ok(None));
    }
}

/// Orders change at whole seconds. Autopilots and courses give constant commands for ticks that do not
/// depend on frames, so only rounding differs: frames of 1/30 and 1/144 of a second end within ticks.
#[test]
fn flights_in_30_60_and_144_frames_a_second_end_at_the_same_place() {
    let ends = [30, 60, 144, 7].map(|frames| {
        let mut flight = flight(0.9, ObserverKind::Orbit, 6.0, 3.0);
        let turning = Orders {
            rotation: DVec3::new(0.0, 0.1, 0.2),
            ..thrust(Thrust::Axes(DVec3::new(0.05, 0.01, 0.0)))
        };
        let facing = Orders {
            face: Some(Heading::Retrograde),
            ..thrust(Thrust::Axes(DVec3::new(0.03, 0.0, 0.0)))
        };
        for (orders, own) in [
            (turning, 1.5),
            (thrust(Thrust::Along(Heading::Retrograde, 0.04)), 2.0),
            (facing, 1.3),
            (Orders::COAST, 4.0),
            (thrust(Thrust::Hold(Hold::Orbit(5.0), 0.2)), 20.0),
            (thrust(Thrust::Hold(Hold::Hover(4.5), 0.2)), 5.0),
            (Orders::COAST, 2.0),
        ] {
            flight.order(orders);
            second(&mut flight, own, frames);
        }
        flight
    });
    for flight in &ends {
        let distance = (flight.ship.place().position - ends[0].ship.place().position).length();
        // A thousandth of the bar, which is 1e-9 r_s: nothing but rounding differs.
        assert!(distance < 1e-12, "{distance:e}");
        assert!((flight.rocket.used() - ends[0].rocket.used()).abs() < 1e-12);
        assert!(flight.ship.frame().abs_diff_eq(ends[0].ship.frame(), 1e-12));
    }
}

/// The circle at 1.6 r_s is unstable: what is off grows by e^2 in a turn. Held with thrust off by
/// the square of a tick, the ship keeps its radius, for little fuel.
#[test]
fn the_orbit_hold_keeps_an_unstable_circle_for_almost_nothing() {
    let mut flight = flight(0.0, ObserverKind::Orbit, 1.61, 1.0);
    flight.order(thrust(Thrust::Hold(Hold::Orbit(1.6), 2.0)));
    // A turn takes 4.5 r_s/c of own time.
    let period = std::f64::consts::TAU * 1.6 * (2.0 * (1.6 - 1.5_f64)).sqrt();
    flight.advance(3.0 * period).unwrap();
    let before = flight.rocket.used();
    flight.advance(10.0 * period).unwrap();
    let (off, used) = (flight.ship.place().r - 1.6, flight.rocket.used() - before);
    eprintln!("orbit hold: off by {off:.1e} after ten turns, for the rapidity {used:.1e}");
    assert!(off.abs() < 1e-6, "{off:e}");
    assert!(used < 1e-3, "{used:e}");
}

#[test]
fn a_hold_takes_a_ship_from_rest_to_an_orbit_and_back() {
    let mut flight = flight(0.9, ObserverKind::Static, 8.0, 10.0);
    flight.order(thrust(Thrust::Hold(Hold::Orbit(6.0), 0.3)));
    flight.advance(400.0).unwrap();
    // Away from its radius a hold follows it with 2 t_c, so that after 400 r_s/c nothing is left.
    assert!(
        (flight.ship.place().r - 6.0).abs() < 1e-4,
        "{}",
        flight.ship.place().r
    );
    flight.order(thrust(Thrust::Hold(Hold::Hover(7.0), 0.3)));
    flight.advance(400.0).unwrap();
    let place = flight.ship.place();
    assert!((place.r - 7.0).abs() < 1e-4, "{}", place.r);
    let turning = flight.ship.constants().w.length();
    // At rest relative to the stars L is not zero, but as small as 2 M a/r.
    assert!(turning < 0.1, "{turning}");
}

#[test]
fn fuel_that_is_empty_ends_the_thrust_in_the_middle_of_a_frame() {
    let mut flight = flight(0.0, ObserverKind::Static, 10.0, 0.25);
    flight.order(thrust(Thrust::Axes(DVec3::new(-0.5, 0.0, 0.0))));
    flight.advance(0.4).unwrap();
    let energy = flight.ship.constants().energy;
    flight.advance(0.4).unwrap();
    assert!((flight.rocket.used() - 0.25).abs() < 1e-15);
    assert_eq!(flight.rocket.left(), 0.0);
    assert!((flight.rocket.mass() - (-0.25_f64).exp()).abs() < 1e-15);
    // E = E_0 + A (r - r_0) until the tank is empty after 0.5 r_s/c, and constant afterward.
    let mut other = flight;
    other.advance(3.0).unwrap();
    assert!(flight.ship.constants().energy > energy);
    let gained = (other.ship.constants().energy - flight.ship.constants().energy).abs();
    assert!(gained < 1e-14, "{gained:e}");
}

#[test]
fn flights_end_where_falls_end_and_holds_end_at_the_horizon() {
    let mut flight = flight(0.9, ObserverKind::Rain, 1.5, 5.0);
    flight.order(thrust(Thrust::Hold(Hold::Zamo(1.5), 1e-3)));
    let event = flight.advance(20.0).unwrap();
    assert!(
        matches!(event, Some(Event::Refused(HoldRefusal::Inside { .. }))),
        "{event:?}"
    );
    assert_eq!(flight.orders(), &Orders::COAST);
    flight.order(thrust(Thrust::Axes(DVec3::new(0.1, 0.0, 0.0))));
    assert_eq!(
        flight.advance(20.0).unwrap(),
        Some(Event::Limit(Limit::Inner))
    );
    let [inner, _] = flight.ship.limits();
    let r = flight.ship.place().r;
    assert!((r / inner - 1.0).abs() < 1e-12, "{r} {inner}");
    assert_eq!(
        flight.advance(1.0).unwrap(),
        Some(Event::Limit(Limit::Inner)),
        "the flight stays there"
    );
    assert_eq!(flight.ship.place().r, r);
}
