//! The errors of flights, measured in ways that do not depend on each other: what the engine adds to
//! E, L and K', the length of the four-velocity, the geodesics, Marck's gyroscopes.

use crate::random::Random;
use crate::ship_flights::{controls, ship};

use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::geometry::ship::{Controls, Ship, minkowski};
use lightfall_core::geometry::timelike::Limit;

const SPINS: [f64; 5] = [-0.9, 0.0, 0.5, 0.9, 0.998];

/// A ship somewhere, at most with the speed 0.9 relative to rain.
fn random_ship(random: &mut Random) -> Ship {
    let spin = random.of(&SPINS);
    let kerr = Kerr { spin };
    let near = min_infall_radius(kerr);
    let r = if random.one_in(3) {
        random.between(near + 0.3 * (kerr.horizon() - near), kerr.horizon())
    } else {
        random.log_between(1.01 * kerr.horizon(), 30.0)
    };
    let theta = if random.one_in(8) {
        0.0
    } else {
        random.between(-1.0, 1.0).acos()
    };
    ship(
        spin,
        r,
        theta,
        random.between(0.0, 0.9) * random.direction(),
    )
}

/// The largest component of the axes.
fn largest(ship: &Ship) -> f64 {
    ship.frame()
        .to_cols_array()
        .into_iter()
        .fold(0.0, |most, x| most.max(x.abs()))
}

fn random_controls(random: &mut Random, r: f64) -> Controls {
    let scale = 1.0 / r;
    Controls {
        acceleration: random.between(0.0, 2.0) * scale * random.direction(),
        rotation: random.between(0.0, 2.0) * scale * random.direction(),
    }
}

/// The engine's work is integrated beside the motion, so the balance does not hold by construction.
/// Each step has an error of about 1e-15 of the largest component, and a flight some dozens of
/// steps. The error is relative to the largest terms of which a constant is the sum: deep inside,
/// terms of some hundreds cancel. It grows with the largest component of the axes, to 2e-14 times
/// that in 120 seeds, so that 1e-12 holds up to components of 25 and the same share beyond.
#[test]
fn thrust_of_random_programs_adds_what_it_must_to_energy_angular_momentum_and_carters_constant() {
    let mut random = Random::new();
    let (mut inside, mut worst) = (0, [0.0_f64; 3]);
    for flight in 0..300 {
        let mut ship = random_ship(&mut random);
        // The terms of which the constants are sums: p_b = eta p + H (l.p) l.
        let size = |ship: &Ship| {
            let place = ship.place();
            let u = ship.velocity();
            let momentum = u.abs().max_element() + place.h * place.along_null(u).abs();
            let arm = place.rho2().sqrt();
            [momentum, arm * momentum, (arm * momentum).powi(2)]
        };
        let mut scale = size(&ship);
        for _ in 0..8 {
            let r = ship.place().r;
            let commands = random_controls(&mut random, r);
            let limit = ship
                .advance(&commands, random.between(0.0, 0.3) * r)
                .unwrap();
            assert_ne!(limit, Some(Limit::Lost), "flight {flight}");
            for (scale, now) in scale.iter_mut().zip(size(&ship)) {
                *scale = scale.max(now);
            }
        }
        inside += u32::from(ship.place().r < ship.kerr().horizon());
        for ((worst, balance), scale) in worst.iter_mut().zip(ship.balance()).zip(scale) {
            let growth = (largest(&ship) / 25.0).max(1.0);
            *worst = worst.max(balance.abs() / (scale * growth));
        }
        let u = ship.velocity();
        assert!((minkowski(u, u) + 1.0).abs() < 1e-14 * u.length_squared());
    }
    eprintln!("balances of E, L, K': {worst:?}, {inside} flights end inside");
    assert!(inside > 60, "{inside}");
    assert!(worst.into_iter().all(|worst| worst < 1e-12), "{worst:?}");
}

/// With the engine off, place and velocity are the geodesic's. The equations with the engine are
/// then the independent ones, and the difference is that of two methods in two sets of
/// coordinates. Deep inside, and where the ship nearly circles with light, the
/// axes have components of some tens, and errors of a part in 1e15
/// grow with the tide as the square of the largest on the way. Elsewhere the square is about one. They also grow with
/// the time of the fall, and so with the radius where it begins. What is left was 1e-13 at most in
/// 120 seeds.
#[test]
fn a_random_ship_that_coasts_is_where_its_equations_with_an_engine_lead() {
    let mut random = Random::new();
    let mut worst = 0.0_f64;
    for flight in 0..200 {
        let ship = random_ship(&mut random);
        let time = random.between(0.0, 3.0) * ship.place().r;
        let mut coasting = ship;
        let mut size = largest(&ship);
        for _ in 0..40 {
            let limit = coasting.advance(&Controls::default(), time / 40.0).unwrap();
            assert_ne!(limit, Some(Limit::Lost), "flight {flight}");
            size = size.max(largest(&coasting));
        }
        // An engine as weak as this one moves nothing by more than rounding.
        let mut driven = ship;
        let weak = controls([1e-30, 0.0, 0.0], [0.0; 3]);
        driven.advance(&weak, coasting.proper_time()).unwrap();
        let distance = (driven.place().position - coasting.place().position).length();
        let clocks = (driven.time() - coasting.time()).abs() / (1.0 + coasting.time().abs());
        let axes = coasting.frame();
        let turned = (driven.frame() - axes)
            .to_cols_array()
            .into_iter()
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        let error = (distance / coasting.place().r)
            .max(clocks)
            .max(turned / size);
        worst = worst.max(error / (size * size * ship.place().r.max(1.0)));
    }
    eprintln!(
        "coasting against the equations with an engine, per square of the axes and start: {worst:.1e}"
    );
    assert!(worst < 1e-12, "{worst:e}");
}
