//! Closed forms and published numbers, repeated by flying them. All numbers have ten decimals.

use crate::bisect;
use crate::timelike::scene;
use glam::{DMat3, DMat4, DQuat, DVec3, Vec4Swizzles};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::geometry::ship::{
    Controls, Place, Ship, VectorConstants, boost, components, rain_axes, zamo_axes,
};
use lightfall_core::geometry::sphere::wrap_angle;
use lightfall_core::optics::readout::held_acceleration_components;
use lightfall_core::optics::ship::{
    Apsides, Clocks, Flight, Hold, HoldRefusal, Mount, Orders, Rocket, Thrust, board,
    circular_velocity, longest_life, radial_life, time_to_apsis, write_scene,
};
use lightfall_core::scene::{ObserverKind, Scene};
use std::f64::consts::{FRAC_PI_2, TAU};

/// The numbers have ten decimals.
const LAST_DIGIT: f64 = 0.6e-10;

/// Where a flight repeats a number, ten decimals of it leave the place less well known.
const FLOWN: f64 = 2e-9;

#[track_caller]
fn assert_digits(what: &str, found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(
        error < LAST_DIGIT,
        "{what}: found {found:.12}, expected {expected}"
    );
}

#[track_caller]
fn assert_near(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(
        error < tolerance,
        "{what}: found {found:.12}, expected {expected}, off by {error:e}"
    );
}

/// A ship like the scene's observer, whose nose points inward.
fn ship(spin: f64, kind: ObserverKind, velocity: [f64; 3], r: f64, theta_deg: f64) -> Ship {
    board(&scene(spin, kind, velocity, r, theta_deg), &Mount::NOSE).unwrap()
}

fn outward(size: f64) -> Controls {
    Controls {
        acceleration: -size * DVec3::X,
        rotation: DVec3::ZERO,
    }
}

fn hold(hold: Hold, ship: Ship) -> Flight {
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
    assert_digits("longest", longest_life(still, 1.0, 0.0), 1.5707963268);
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
            1.5707963268,
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
        (0.0, 0.1091728041, 1.4142135624),
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

/// How the ship's axes are turned on the axes of the scene's observer.
fn attitude(ship: &Ship, scene: &Scene) -> DMat3 {
    let mut scene = scene.clone();
    write_scene(ship, &Mount::NOSE, &mut scene).unwrap();
    scene.camera.tetrad_from_camera() * Mount::NOSE.0.transpose()
}

#[test]
fn gyroscopes_turn_by_the_published_angles() {
    // In the circling axes a gyroscope turns back by a turn less the geodetic angle and that of
    // Lense and Thirring: 2 pi - sqrt(M/r^3) T (Rindler & Perlick 1990 without spin).
    for (spin, r, expected) in [
        (0.0, 6.0, 0.8417872145),
        (0.0, 4.0, 1.3158911743),
        (0.9, 6.0, 0.6869116514),
        (-0.9, 6.0, 1.0012020077),
    ] {
        let scene = scene(spin, ObserverKind::Orbit, [0.0; 3], r, 90.0);
        let mut ship = board(&scene, &Mount::NOSE).unwrap();
        let orbit = Kerr { spin }.circular_orbit(r).unwrap();
        let before = attitude(&ship, &scene);
        ship.advance(
            &Controls::default(),
            TAU / (orbit.angular_velocity * orbit.u_t),
        )
        .unwrap();
        let turn =
            DQuat::from_mat3(&(attitude(&ship, &scene) * before.transpose())).to_scaled_axis();
        assert_digits("angle", turn.length(), expected);
        assert!(turn.cross(DVec3::Y).length() < 1e-9, "about theta: {turn}");
    }
    let scene = scene(0.9, ObserverKind::Static, [0.0; 3], 3.0, 90.0);
    let ship = board(&scene, &Mount::NOSE).unwrap();
    let before = attitude(&ship, &scene);
    let mut flight = hold(Hold::Hover(3.0), ship);
    flight.advance(20.0).unwrap();
    let turn = DQuat::from_mat3(&(attitude(&flight.ship, &scene) * before.transpose()));
    // The hold keeps the place to the square of a tick, some 1e-6.
    assert_near("rate", turn.to_scaled_axis().y / 20.0, 0.0125, 2e-6);
}

/// A ship in the equator with these constants, that moves inward.
fn thrown(spin: f64, r: f64, energy: f64, angular_momentum: f64) -> Ship {
    let kerr = Kerr { spin };
    let place = Place::at(kerr, r, DVec3::X);
    let a = kerr.a();
    let p = energy * place.rho2() - a * angular_momentum;
    let k_prime = (angular_momentum - a * energy).powi(2);
    let u = VectorConstants {
        energy,
        angular_momentum,
        radial: -(p * p - kerr.delta(r) * (r * r + k_prime)).sqrt(),
        w: angular_momentum * DVec3::Y,
        mass2: 1.0,
    }
    .vector(&place);
    let rain = rain_axes(&place, 0.0);
    let frame: DMat4 = rain * boost(components(&rain, u).yzw());
    let time = kerr.ingoing_time_lead(r) - r;
    Ship::new(&place, time, &frame, [min_infall_radius(kerr), 1e7]).unwrap()
}

#[test]
fn slingshots_sweep_the_angles_of_quadratures() {
    for (spin, low, retrograde, swept, own, far) in [
        (0.0, 2.2, false, 6.0150679620, 58.4763499840, 84.7127988345),
        (0.9, 1.2, false, 7.9634237853, 55.6720394905, 84.0397436421),
        (0.9, 3.2, true, -4.7931255255, 59.0169310916, 82.9548418526),
    ] {
        let kerr = Kerr { spin };
        let (a, energy): (f64, f64) = (kerr.a(), 1.2);
        // R = 0 at the lowest point, with x = L - a E: (E r^2 - a x)^2 = Delta (r^2 + x^2).
        let delta = kerr.delta(low);
        let (c2, c1, c0) = (
            a * a - delta,
            -2.0 * a * energy * low * low,
            energy * energy * low.powi(4) - delta * low * low,
        );
        let root = (c1 * c1 - 4.0 * c2 * c0).sqrt();
        let roots = [(-c1 + root) / (2.0 * c2), (-c1 - root) / (2.0 * c2)];
        let [least, most] = [roots[0].min(roots[1]), roots[0].max(roots[1])];
        let x = if retrograde { least } else { most };
        let mut ship = thrown(spin, 20.0, energy, x + a * energy);
        let apsides = Apsides::of(&ship);
        assert_near("lowest", apsides.periapsis.unwrap(), low, 1e-12);
        assert_eq!(apsides.apoapsis, None);
        assert_near(
            "halfway",
            time_to_apsis(&ship).unwrap(),
            0.5 * own,
            LAST_DIGIT,
        );
        let azimuth = |ship: &Ship| ship.place().azimuth().unwrap();
        let start = azimuth(&ship);
        ship.advance(&Controls::default(), own).unwrap();
        assert_near("r", ship.place().r, 20.0, FLOWN);
        assert_near(
            "azimuth",
            wrap_angle(azimuth(&ship) - start - swept),
            0.0,
            FLOWN,
        );
        assert_near("t", Clocks::new(&ship).far.unwrap(), far, FLOWN);
    }
}

#[test]
fn a_polar_orbit_shifts_its_node_as_integrated() {
    let still = ship(0.9, ObserverKind::Zamo, [0.0, -0.1, 0.0], 5.0, 90.0);
    let velocity = circular_velocity(&still).unwrap();
    let mut ship = ship(0.9, ObserverKind::Zamo, [0.0, velocity.x, 0.0], 5.0, 90.0);
    let constants = ship.constants();
    assert_digits("E", constants.energy, 0.9559116358);
    assert_near("L", constants.angular_momentum, 0.0, 1e-14);
    let start = ship.place().azimuth().unwrap();
    ship.advance(&Controls::default(), 83.8840908290).unwrap();
    assert_near("height", ship.place().n.z, 0.0, LAST_DIGIT);
    assert_near("r", ship.place().r, 5.0, 1e-11);
    assert_digits(
        "node",
        wrap_angle(ship.place().azimuth().unwrap() - start),
        0.3557773711,
    );
}

/// The published speeds of circular orbits, prograde and retrograde, against the quadratic.
#[test]
fn the_orbit_hold_knows_the_speed_of_circular_orbits_and_where_there_are_none() {
    for spin in [-0.998, -0.5, 0.0, 0.9, 0.998] {
        let kerr = Kerr { spin };
        for stretch in [1.0001, 1.1, 2.0, 10.0] {
            let r = stretch * kerr.photon_orbit_prograde();
            let orbit = ship(spin, ObserverKind::Orbit, [0.0; 3], r, 90.0);
            let place = orbit.place();
            let zamo = zamo_axes(&place, 0.0).unwrap();
            let on_zamo = components(&zamo, orbit.velocity());
            let found = circular_velocity(&orbit).unwrap();
            // Near the photon orbit 1 - v is small, and its rounding not.
            assert_near("speed", found.y, on_zamo.w / on_zamo.x, 1e-11);
        }
        let r = 0.5 * (kerr.photon_orbit_prograde() + kerr.horizon());
        let inside = ship(spin, ObserverKind::Zamo, [0.0, 0.0, 0.1], r, 90.0);
        assert_eq!(
            circular_velocity(&inside),
            Err(HoldRefusal::NoOrbit {
                r: inside.place().r
            })
        );
        assert!(
            circular_velocity(&inside)
                .unwrap_err()
                .to_string()
                .contains("even light does not circle here")
        );
    }
    let inside = ship(0.9, ObserverKind::Rain, [0.0; 3], 0.7, 90.0);
    let ergosphere = ship(0.9, ObserverKind::Zamo, [0.0; 3], 0.9, 90.0);
    assert!(matches!(
        Hold::Zamo(0.7).acceleration(&inside, 1.0),
        Err(HoldRefusal::Inside { .. })
    ));
    assert!(matches!(
        Hold::Hover(0.9).acceleration(&ergosphere, 1.0),
        Err(HoldRefusal::Ergosphere { .. })
    ));
}
