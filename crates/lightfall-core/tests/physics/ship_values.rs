//! Closed forms and published numbers, repeated by flying them. All numbers have ten decimals.

use crate::bisect;
use crate::timelike::scene;
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::ship::{
    Controls, Place, Ship, VectorConstants, boost, components, zamo_axes,
};
use lightfall_core::optics::readout::held_acceleration_components;
use lightfall_core::optics::readout::si::MASSES;
use lightfall_core::optics::ship::{
    Clocks, Flight, Hold, Mount, Orders, Rocket, Thrust, Voyage, board, longest_life, radial_life,
};
use lightfall_core::scene::ObserverKind;
use lightfall_core::scene::mission::Quantity;
use std::f64::consts::FRAC_PI_2;

/// The numbers have ten decimals.
pub(crate) const LAST_DIGIT: f64 = 0.6e-10;

/// Where a flight repeats a number, ten decimals of it leave the place less well known.
pub(crate) const FLOWN: f64 = 2e-9;

#[track_caller]
pub(crate) fn assert_digits(what: &str, found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(
        error < LAST_DIGIT,
        "{what}: found {found:.12}, expected {expected}"
    );
}

#[track_caller]
pub(crate) fn assert_near(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(
        error < tolerance,
        "{what}: found {found:.12}, expected {expected}, off by {error:e}"
    );
}

/// A ship like the scene's observer, whose nose points inward.
pub(crate) fn ship(
    spin: f64,
    kind: ObserverKind,
    velocity: [f64; 3],
    r: f64,
    theta_deg: f64,
) -> Ship {
    board(&scene(spin, kind, velocity, r, theta_deg), &Mount::NOSE).unwrap()
}

fn outward(size: f64) -> Controls {
    Controls {
        acceleration: -size * DVec3::X,
        rotation: DVec3::ZERO,
    }
}

pub(crate) fn hold(hold: Hold, ship: Ship) -> Flight {
    let mut flight = Flight::new(ship, Rocket::new(1e3, 1e3, 1.0).unwrap());
    flight.order(Orders {
        thrust: Thrust::Hold(hold, 100.0),
        ..Orders::COAST
    });
    flight
}

#[test]
fn thrust_that_holds_a_ship_has_the_size_of_the_closed_form() {
    for (r, expected) in [
        (1.5, 0.3849001795),
        (2.0, 0.1767766953),
        (3.0, 0.0680413817),
    ] {
        let kind = ObserverKind::Static;
        let [held, _] = held_acceleration_components(Kerr { spin: 0.0 }, kind, r, FRAC_PI_2);
        assert_digits("hover", held, expected);
        let mut ship = ship(0.0, kind, [0.0; 3], r, 40.0);
        ship.advance(&outward(expected), 1.0).unwrap();
        assert_near("r", ship.place().r, r, FLOWN);
    }
    // Where light circles, thrust is the same at every speed (Abramowicz & Lasota 1986), and
    // gyroscopes keep to the motion.
    for speed in [0.0, 0.3, 0.5_f64.sqrt(), 0.9, 0.99] {
        let mut ship = ship(0.0, ObserverKind::Static, [0.0, 0.0, speed], 1.5, 90.0);
        ship.advance(&outward(0.3849001795), 0.5).unwrap();
        // The weight of an error of the last digit grows with gamma^2.
        assert_near("r", ship.place().r, 1.5, FLOWN / (1.0 - speed * speed));
    }
    for (kind, r, theta_deg, expected) in [
        (ObserverKind::Static, 1.2, 90.0, [1.1548728034, 0.0]),
        (
            ObserverKind::Static,
            1.2,
            60.0,
            [0.8736964087, -0.1989396449],
        ),
        (ObserverKind::Zamo, 0.8, 90.0, [1.6680647459, 0.0]),
    ] {
        let theta = f64::to_radians(theta_deg);
        let found = held_acceleration_components(Kerr { spin: 0.9 }, kind, r, theta);
        assert_digits("outward", found[0], expected[0]);
        assert_digits("along theta", found[1], expected[1]);
        let ship = ship(0.9, kind, [0.0; 3], r, theta_deg);
        let held = if kind == ObserverKind::Static {
            Hold::Hover(r)
        } else {
            Hold::Zamo(r)
        };
        let needed = held.acceleration(&ship, 100.0).unwrap().length();
        assert_near("needed", needed, expected[0].hypot(expected[1]), FLOWN);
        let mut flight = hold(held, ship);
        assert_eq!(flight.advance(0.5), Ok(None));
        // Constant thrust for a tick of 0.02 misses by its square, 4e-4 of a radian, and a hold takes most of that back.
        assert_near("r", flight.ship.place().r, r, 2e-5);
        assert_near("theta", flight.ship.place().theta(), theta, 2e-5);
    }
}

#[test]
fn falls_last_as_long_as_the_closed_forms_say() {
    for (spin, theta_deg, expected) in [
        (0.0, 90.0, 20.4151844011),
        (0.9, 90.0, 20.5133306123),
        (0.9, 0.0, 20.8470058216),
    ] {
        let kerr = Kerr { spin };
        let start = ship(spin, ObserverKind::Rain, [0.0; 3], 10.0, theta_deg);
        for engine in [0.0, 1e-30] {
            let mut ship = start;
            assert_eq!(ship.advance(&outward(engine), expected), Ok(None));
            assert_near("horizon", ship.place().r, kerr.horizon(), 2.0 * LAST_DIGIT);
        }
    }
    let mut at_horizon = ship(0.0, ObserverKind::Static, [0.0; 3], 10.0, 90.0);
    let mut to_the_end = at_horizon;
    at_horizon
        .advance(&Controls::default(), 48.9851284063)
        .unwrap();
    assert_near("horizon", at_horizon.place().r, 1.0, 2.0 * LAST_DIGIT);
    to_the_end.advance(&Controls::default(), 100.0).unwrap();
    let rest = radial_life(to_the_end.place().r, to_the_end.constants().energy);
    assert_digits(
        "to the centre",
        to_the_end.proper_time() + rest,
        49.6729413290,
    );
}

#[test]
fn lives_inside_are_as_long_as_the_closed_forms_say() {
    let still = Kerr { spin: 0.0 };
    assert_digits("longest", longest_life(still, 1.0, 0.0), FRAC_PI_2);
    assert_digits("from infinity", radial_life(1.0, 1.0), 0.6666666667);
    for (r, expected) in [(1.5, 0.8890032891), (3.0, 0.7486366366)] {
        let start = ship(0.0, ObserverKind::Static, [0.0; 3], r, 90.0);
        let crossing = bisect(0.0, 20.0, |time| {
            let mut ship = start;
            ship.advance(&Controls::default(), time).unwrap();
            ship.place().r > 1.0
        });
        let mut ship = start;
        ship.advance(&Controls::default(), 20.0).unwrap();
        let rest = radial_life(ship.place().r, ship.constants().energy);
        assert_digits("inside", ship.proper_time() - crossing + rest, expected);
    }
    for spin in [0.3, 0.9, 0.998] {
        let kerr = Kerr { spin };
        assert_digits(
            "equator",
            longest_life(kerr, kerr.horizon(), 0.0),
            FRAC_PI_2,
        );
    }
    for (spin, expected) in [(0.9, 2.1389608636), (0.998, 2.2197757007)] {
        let kerr = Kerr { spin };
        assert_digits("axis", longest_life(kerr, kerr.horizon(), 1.0), expected);
    }
    // From inside without spin: arcsin(sqrt(r)) - sqrt(r (1 - r)).
    let r: f64 = 0.4;
    assert_digits(
        "left",
        longest_life(still, r, 0.3),
        r.sqrt().asin() - (r * (1.0 - r)).sqrt(),
    );
}

/// The rapidity, toward growing phi and relative to the observer with zero angular momentum, at which
/// the energy is `energy`.
fn rapidity_of_energy(place: &Place, energy: f64) -> f64 {
    let zamo = zamo_axes(place, 0.0).unwrap();
    bisect(0.0, 5.0, |rapidity| {
        let u = (zamo * boost(rapidity.sinh() * DVec3::Z)).x_axis;
        VectorConstants::new(place, u).energy < energy
    })
}

#[test]
fn burns_cost_the_rapidity_of_the_closed_forms() {
    for (spin, rapidity, rate) in [
        (0.0, 0.1091728041, std::f64::consts::SQRT_2),
        (0.9, 0.1852606119, 2.6963775519),
        (0.998, 0.2797543213, 10.7909428342),
    ] {
        let r = Kerr { spin }.isco();
        let ship = ship(spin, ObserverKind::Orbit, [0.0; 3], r, 90.0);
        let place = ship.place();
        let zamo = zamo_axes(&place, 0.0).unwrap();
        let circular = components(&zamo, ship.velocity()).w.asinh();
        assert_digits(
            "circularise",
            rapidity_of_energy(&place, 1.0) - circular,
            rapidity,
        );
        assert_digits("dt/dtau", Clocks::new(&ship).far_rate.unwrap(), rate);
    }
    let start = ship(0.0, ObserverKind::Static, [0.0; 3], 1.5, 90.0);
    assert_digits(
        "impulse",
        rapidity_of_energy(&start.place(), 1.0),
        1.1462158348,
    );
    for (acceleration, expected) in [(5.0, 1.1875874320), (1.0, 1.3958202174)] {
        let time = bisect(0.0, 5.0, |time| {
            let mut ship = start;
            ship.advance(&outward(acceleration), time).unwrap();
            ship.constants().energy < 1.0
        });
        assert_digits("to leave", acceleration * time, expected);
    }
}

/// The gas circles with v^2 = M/(r - 2 M) for those at rest. Where its plane crosses the equator, it
/// rises there by the tilt.
#[test]
fn the_speed_past_the_gas_is_that_past_the_gas_of_a_tilted_disk() {
    const R: f64 = 8.0;
    const TILT: f64 = 30.0;
    const NODE: f64 = 40.0;
    let speed = (0.5 / (R - 1.0)).sqrt();
    let (sin, cos) = f64::to_radians(TILT).sin_cos();
    let gas_speed = |tilt: f64, phi: f64, theta: f64, velocity: [f64; 3]| {
        let mut scene = scene(0.0, ObserverKind::Static, velocity, R, theta);
        scene.camera.phi_deg = phi;
        (scene.disk.tilt_deg, scene.disk.node_deg) = (tilt, NODE);
        let ship = board(&scene, &Mount::NOSE).unwrap();
        let rocket = Rocket::new(1.0, 1.0, 1.0).unwrap();
        let voyage = Voyage::new(Flight::new(ship, rocket), MASSES[0], &scene.disk);
        voyage.quantity(Quantity::GasSpeed)
    };
    let along_phi = [0.0, 0.0, speed];
    let along_gas = [0.0, -speed * sin, speed * cos];
    let past = |cosine: f64| {
        // The speed of two with the same speed, at this angle to each other.
        let gamma = (1.0 - speed * speed * cosine) / (1.0 - speed * speed);
        (1.0 - 1.0 / (gamma * gamma)).sqrt()
    };
    // A speed of zero is the root of a rounding.
    for (tilt, velocity, expected, tolerance) in [
        (0.0, along_phi, 0.0, 1e-7),
        (TILT, along_gas, 0.0, 1e-7),
        (TILT, along_phi, past(cos), 1e-12),
        (0.0, along_gas, past(cos), 1e-12),
    ] {
        let found = gas_speed(tilt, NODE, 90.0, velocity).unwrap();
        assert_near("gas_speed", found, expected, tolerance);
    }
    // A quarter of a turn on, the gas is above the equator.
    assert_eq!(gas_speed(TILT, NODE + 90.0, 90.0, along_phi), None);
    let found = gas_speed(TILT, NODE + 90.0, 90.0 - TILT, along_phi).unwrap();
    assert_near("gas_speed at the highest point", found, 0.0, 1e-7);
}
