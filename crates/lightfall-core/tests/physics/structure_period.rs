//! The structure of a disk that repeats: exactly after its period, not before, and with the statistics
//! of one that never does.

use crate::structure_field::StructureField;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::optics::structure::{Covariance, Structure};
use lightfall_core::scene::{DiskStructure, Scene};
use std::f64::consts::TAU;

/// Turbulence around a hole of spin 0.9, whose innermost orbit takes 14 r_s/c and whose outermost one
/// takes 324.
fn structure(seed: u32, period: f64) -> Structure {
    let mut scene = Scene::default();
    (scene.hole.spin, scene.disk.follow_isco) = (0.9, true);
    (scene.disk.structure, scene.disk.seed) = (DiskStructure::Turbulent, seed);
    scene.disk.period = period;
    Structure::new(&scene, None).unwrap()
}

/// A number between 0 and 1 without a rhythm.
fn share(i: u32, step: f64) -> f64 {
    (f64::from(i) * step).fract()
}

/// `count` radii, azimuths, and shares of a period.
fn places(count: u32) -> impl Iterator<Item = [f64; 3]> {
    (0..count).map(|i| {
        let r = 1.17 * (10.9_f64 / 1.17).powf(share(i, 0.754_877_666));
        [r, TAU * share(i, 0.618_033_989), share(i, 0.569_840_291)]
    })
}

fn value(structure: &Structure, [r, phi, time]: [f64; 3]) -> f64 {
    structure.field_at(r, phi, time, Covariance::POINT).value
}

#[test]
fn the_field_repeats_after_its_period_and_not_before() {
    for period in [2.0, 24.0, 131.7, 1e4] {
        let structure = structure(3, period);
        for start in [0.0, -7.0 * period, 1e5] {
            let (mut off, mut unlike, mut count) = (0.0_f64, 0.0, 0.0);
            for [r, phi, part] in places(400) {
                let time = start + part * period;
                let at = |later: f64| value(&structure, [r, phi, time + later * period]);
                let now = at(0.0);
                for periods in [1.0, -1.0, 5.0] {
                    off = off.max((at(periods) - now).abs());
                }
                unlike += (at(0.5) - now).powi(2);
                count += 1.0;
            }
            // A time of 10^5 has a rounding of 1.5e-11, and in the shortest period, of 2, the phase of
            // a wave changes by up to 100 Omega, some 50 radians per r_s/c.
            assert!(off < 1e-8, "period {period} from {start}: {off:e}");
            // Two independent fields of variance one differ by two in the mean square. Between rings
            // of a single life per period, half a period later another half of the waves shines.
            let unlike: f64 = unlike / count;
            assert!(unlike > 0.7, "period {period} from {start}: {unlike}");
        }
    }
}

#[test]
fn lives_are_whole_parts_of_the_period_near_the_lifetime() {
    for period in [2.0, 24.0, 131.7, 1e4] {
        for (ring, endless) in structure(1, period)
            .rings
            .iter()
            .zip(structure(1, 0.0).rings)
        {
            let lives = period / ring.life;
            assert!((lives - lives.round()).abs() < 1e-9, "{lives} lives");
            assert_eq!(ring.cycle, Some(lives.round() as u32));
            assert_eq!(endless.cycle, None);
            // Rounding to whole lives changes 1.5 lives the most, to 1 or 2; where the period is
            // shorter than a life, it is the life.
            if period < endless.life {
                assert_eq!(ring.life, period);
            } else {
                assert!((0.66..1.51).contains(&(ring.life / endless.life)));
            }
            // Nothing else depends on the period.
            assert_eq!(
                (ring.centre, &ring.groups),
                (endless.centre, &endless.groups)
            );
        }
    }
}

#[test]
fn with_a_period_the_field_has_variance_one_and_is_nearly_gaussian() {
    // One structure that repeats has few phases, so the mean is over structures as well.
    for period in [24.0, 131.7] {
        let structures: Vec<_> = (0..2000).map(|seed| structure(seed, period)).collect();
        for r in [1.3, 3.2, 5.7, 10.5] {
            let values: Vec<f64> = structures
                .iter()
                .enumerate()
                .flat_map(|(i, structure)| {
                    (0..30).map(move |j| {
                        let i = 30 * i as u32 + j;
                        let [_, phi, part] =
                            [0.0, TAU * share(i, 0.618_033_989), share(i, 0.569_840_291)];
                        value(structure, [r, phi, part * period])
                    })
                })
                .collect();
            let moment = |power| {
                values.iter().map(|v: &f64| v.powi(power)).sum::<f64>() / values.len() as f64
            };
            let (variance, kurtosis) = (moment(2), moment(4) / moment(2).powi(2));
            eprintln!("period {period}, r {r}: variance {variance}, kurtosis {kurtosis}");
            // The limits are those of a structure that never repeats.
            assert!((variance - 1.0).abs() < 0.03, "r {r}: variance {variance}");
            assert!((2.8..3.1).contains(&kurtosis), "r {r}: kurtosis {kurtosis}");
        }
    }
}

#[test]
fn somebody_who_goes_round_with_the_matter_sees_the_field_change_within_a_period() {
    let omega = Kerr { spin: 0.9 }
        .circular_orbit(6.0)
        .unwrap()
        .angular_velocity;
    let (period, mut product, mut power) = (60.0, 0.0, 0.0);
    for seed in 0..200 {
        let structure = structure(seed, period);
        for [_, phi, part] in places(40) {
            let (time, later) = (part * period, 0.5 * period);
            let here = value(&structure, [6.0, phi, time]);
            let there = value(&structure, [6.0, phi + omega * later, time + later]);
            product += here * there;
            power += 0.5 * (here * here + there * there);
        }
    }
    // The life of the waves there is the period. The windows' correlation half a life later is 1/6, in
    // the same life, as the mean of cos^2 x sin^2 over that of cos^4 is 1/3 for half of the waves.
    let found: f64 = product / power;
    assert!((0.05..0.3).contains(&found), "{found}");
}
