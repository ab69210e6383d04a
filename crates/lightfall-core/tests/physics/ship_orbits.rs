//! Orbits of ships against quadratures and published numbers, and what holds them.

use crate::ship_values::{FLOWN, LAST_DIGIT, assert_digits, assert_near, ship};
use glam::{DMat4, DVec3, Vec4Swizzles};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::geometry::ship::{
    Controls, Place, Ship, VectorConstants, boost, components, rain_axes, zamo_axes,
};
use lightfall_core::geometry::sphere::wrap_angle;
use lightfall_core::optics::ship::{
    Apsides, Clocks, Hold, HoldRefusal, circular_velocity, time_to_apsis,
};
use lightfall_core::scene::ObserverKind;

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
    // From a circle with a velocity along it, the rapidity of that velocity.
    let slow = ship(0.0, ObserverKind::Orbit, [0.0, 0.0, -0.05], 10.0, 90.0);
    let takes = Hold::Orbit(10.0).rapidity(&slow).unwrap();
    assert_near("rapidity to the circle", takes, 0.05_f64.atanh(), 1e-12);
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
