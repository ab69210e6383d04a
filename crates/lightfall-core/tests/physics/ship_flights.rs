//! Three flights with thrust and rotation, against numbers that two other programs agree on to 13
//! digits: one with the spin connection, one with Christoffel symbols in other coordinates, both
//! with an explicit Runge-Kutta method of order 8.

use glam::{DMat3, DMat4, DVec3, DVec4, Vec4Swizzles};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::geometry::ship::{
    Controls, Place, Ship, ShipError, boost, components, rain_axes,
};
use lightfall_core::geometry::sphere::celestial_frame;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

/// The numbers have ten decimals.
const LAST_DIGIT: f64 = 0.6e-10;

/// A ship at (`r`, `theta`) and the ingoing azimuth 0 that moves with `velocity` relative to `rain`,
/// with the axes of that observer.
pub(crate) fn ship(spin: f64, r: f64, theta: f64, velocity: DVec3) -> Ship {
    let kerr = Kerr { spin };
    let [n, ..] = celestial_frame(theta, 0.0);
    let place = Place::at(kerr, r, n);
    let gamma = 1.0 / (1.0 - velocity.length_squared()).sqrt();
    let frame = rain_axes(&place, 0.0) * boost(gamma * velocity);
    Ship::new(&place, 0.0, &frame, [min_infall_radius(kerr), 1e7]).unwrap()
}

pub(crate) fn controls(acceleration: [f64; 3], rotation: [f64; 3]) -> Controls {
    Controls {
        acceleration: acceleration.into(),
        rotation: rotation.into(),
    }
}

/// The velocity relative to `rain`, and the ship's axes on the observer that `rain` is boosted to
/// without rotation.
pub(crate) fn on_observer(ship: &Ship) -> (DVec3, DMat3) {
    let rain = rain_axes(&ship.place(), 0.0);
    let frame = ship.frame();
    let on_rain = |p: DVec4| components(&rain, p);
    let momentum = on_rain(frame.x_axis);
    let observer = rain * boost(momentum.yzw());
    let axis = |p: DVec4| components(&observer, p).yzw();
    (
        momentum.yzw() / momentum.x,
        DMat3::from_cols(axis(frame.y_axis), axis(frame.z_axis), axis(frame.w_axis)),
    )
}

struct Expected {
    place: [f64; 4],
    constants: [f64; 3],
    velocity: [f64; 3],
    first_axis: [f64; 3],
    along_null: f64,
}

fn check(name: &str, ship: &Ship, expected: &Expected) {
    let place = ship.place();
    let constants = ship.constants();
    let (velocity, axes) = on_observer(ship);
    let found = [
        place.r,
        place.theta(),
        place.azimuth().unwrap(),
        ship.time(),
        constants.energy,
        constants.angular_momentum,
        constants.carter_q(&place),
        velocity.x,
        velocity.y,
        velocity.z,
        axes.x_axis.x,
        axes.x_axis.y,
        axes.x_axis.z,
        place.along_null(ship.velocity()),
    ];
    let wanted = [
        expected.place.as_slice(),
        &expected.constants,
        &expected.velocity,
        &expected.first_axis,
        &[expected.along_null],
    ]
    .concat();
    for (i, (found, wanted)) in found.into_iter().zip(wanted).enumerate() {
        assert!(
            (found - wanted).abs() < LAST_DIGIT,
            "{name}, number {i}: found {found:.12}, expected {wanted}"
        );
    }
}

#[test]
fn a_ship_with_thrust_and_rotation_flies_as_two_other_programs_say() {
    let mut first = ship(0.9, 4.0, FRAC_PI_3, DVec3::ZERO);
    first
        .advance(&controls([0.3, 0.1, -0.2], [0.2, -0.1, 0.3]), 2.0)
        .unwrap();
    check(
        "outside",
        &first,
        &Expected {
            place: [3.4311948250, 1.1585679891, -0.1076391920, 2.3852076538],
            constants: [0.9662551358, -0.9393444255, 2.9891788356],
            velocity: [0.4561916399, 0.3775616430, -0.2284630767],
            first_axis: [0.8466191316, 0.4051180871, 0.3451309628],
            along_null: 1.2561163402,
        },
    );

    let mut second = ship(0.9, 1.0, FRAC_PI_2, DVec3::ZERO);
    second
        .advance(&controls([2.0, 0.5, 1.0], [0.0, 0.0, 1.0]), 0.5)
        .unwrap();
    check(
        "through the horizon",
        &second,
        &Expected {
            place: [0.5694265722, 1.7614385823, 0.2217035523, 0.8701228124],
            constants: [0.7676087461, 0.4248311672, 0.1622264215],
            velocity: [0.8020430591, 0.3128101959, 0.2149102291],
            first_axis: [0.8281136636, 0.3396152814, -0.4459699775],
            along_null: 1.0462876509,
        },
    );

    // At rest: rain falls with sqrt(1/10) there. E grows by A (r - r_0), which is exact.
    let mut third = ship(0.0, 10.0, FRAC_PI_2, DVec3::new(0.1_f64.sqrt(), 0.0, 0.0));
    third
        .advance(&controls([0.2, 0.0, 0.0], [0.0; 3]), 10.0)
        .unwrap();
    let r = 22.8203985962;
    check(
        "outward",
        &third,
        &Expected {
            place: [r, FRAC_PI_2, 0.0, 19.1961173980],
            constants: [3.5127630173, 0.0, 0.0],
            velocity: [0.9739798611, 0.0, 0.0],
            first_axis: [1.0, 0.0, 0.0],
            along_null: 7.2022887747,
        },
    );
    let lead = |r: f64| third.kerr().ingoing_time_lead(r) - r;
    let far = third.time() - lead(third.place().r) + lead(10.0);
    assert!((far - 18.3104967276).abs() < LAST_DIGIT, "{far:.12}");
}

/// Frames of a screen at 60 a second give the same flight, since every step is exact to rounding.
#[test]
fn a_flight_in_many_frames_is_the_flight_in_one() {
    let commands = controls([0.3, 0.1, -0.2], [0.2, -0.1, 0.3]);
    let mut frames = ship(0.9, 4.0, FRAC_PI_3, DVec3::ZERO);
    for _ in 0..120 {
        frames.advance(&commands, 2.0 / 120.0).unwrap();
    }
    let mut whole = ship(0.9, 4.0, FRAC_PI_3, DVec3::ZERO);
    whole.advance(&commands, 2.0).unwrap();
    // 120 frames, each with rounding errors of some 1e-16.
    let difference = (frames.place().position - whole.place().position).length();
    assert!(difference < 1e-13, "{difference:e}");
    assert!(frames.frame().abs_diff_eq(whole.frame(), 1e-13));
    // A frame takes one step of three rows.
    assert!(frames.evaluations() <= 120 * 13, "{}", frames.evaluations());
}

#[test]
fn what_is_not_a_ship_is_refused_in_words() {
    let kerr = Kerr { spin: 0.5 };
    let place = Place::at(kerr, 3.0, DVec3::X);
    let axes = rain_axes(&place, 0.0);
    let limits = [min_infall_radius(kerr), 1e7];
    let deep = Place::at(kerr, 0.05, DVec3::X);
    let said = |result: Result<Ship, ShipError>| result.unwrap_err().to_string();
    assert!(
        said(Ship::new(&deep, 0.0, &axes, limits))
            .contains("the ship is at r = 0.05; it must be from")
    );
    assert!(said(Ship::new(&place, 0.0, &DMat4::ZERO, limits)).contains("not orthonormal"));
    assert!(said(Ship::new(&place, f64::NAN, &axes, limits)).contains("not orthonormal"));
    let mut ship = Ship::new(&place, 0.0, &axes, limits).unwrap();
    let before = ship;
    let refusal = ship
        .advance(&controls([f64::NAN, 0.0, 0.0], [0.0; 3]), 1.0)
        .unwrap_err();
    assert!(
        refusal
            .to_string()
            .contains("acceleration is [NaN, 0.0, 0.0]")
    );
    assert!(ship.advance(&Controls::default(), -1.0).is_err());
    assert!(ship.with_tolerance(1.0).is_err());
    assert_eq!(ship, before, "a refusal changes nothing");
}
