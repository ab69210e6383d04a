//! The structure of the disk's light against what its model promises: the statistics of a Gaussian
//! field, a mean that nothing changes, and filaments that never wind up.

use crate::assert_close;
use crate::random::Random;
use crate::structure_field::{StructureField, in_plane};
use glam::{DMat3, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::structure::{Covariance, Structure, Term};
use lightfall_core::scene::{DiskStructure, Scene};
use std::array;
use std::f64::consts::{PI, TAU};

/// Radii all over the disk from 3 to 11 r_s: in the middle of rings, and where two overlap.
const RADII: [f64; 5] = [3.2, 4.6, 5.7, 7.1, 10.5];

/// No footprint.
const POINT: Covariance = Covariance::POINT;

/// A random seed of the disk's structure.
fn random_seed(random: &mut Random) -> u32 {
    random.integer(0, 1 << 30)
}

fn structure(seed: u32, change: impl Fn(&mut Scene)) -> Structure {
    let mut scene = Scene::default();
    (scene.disk.structure, scene.disk.seed) = (DiskStructure::Turbulent, seed);
    change(&mut scene);
    Structure::new(&scene, None).unwrap()
}

/// `count` times, farther apart than the lives of all waves, and azimuths, without a common rhythm.
fn moments(count: u32) -> impl Iterator<Item = (f64, f64)> {
    (0..count).map(|i| {
        let i = f64::from(i);
        (1037.3 * i, TAU * (i * 0.618_033_988_749_895).fract())
    })
}

/// Mean, and the standard error of the mean when `count` of the values are independent.
fn mean_and_error(values: &[f64], count: f64) -> (f64, f64) {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let variance =
        values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (values.len() - 1) as f64;
    (mean, (variance / count).sqrt())
}

#[test]
fn a_random_field_has_variance_one_and_is_nearly_gaussian() {
    let seed = random_seed(&mut Random::new());
    let structure = structure(seed, |_| {});
    for r in RADII {
        let values: Vec<f64> = moments(60_000)
            .map(|(time, phi)| structure.field_at(r, phi, time, POINT).value)
            .collect();
        let moment =
            |power| values.iter().map(|v: &f64| v.powi(power)).sum::<f64>() / values.len() as f64;
        let (variance, kurtosis) = (moment(2), moment(4) / moment(2).powi(2));
        // 60 000 independent Gaussian values have standard errors of 0.006 and 0.02. The
        // kurtosis of 24 waves is 2.87, since that of one is 3/2, and 2.93 where two rings
        // overlap by halves.
        eprintln!("r {r}: variance {variance}, kurtosis {kurtosis}");
        assert!(
            (variance - 1.0).abs() < 0.03,
            "seed {seed}, r {r}: variance {variance}"
        );
        assert!(
            (2.8..3.1).contains(&kurtosis),
            "seed {seed}, r {r}: kurtosis {kurtosis}"
        );
    }
}

#[test]
fn the_variance_of_the_waves_is_one_at_every_radius_and_time() {
    for (waves, period) in [(12, 0.0), (24, 0.0), (48, 0.0), (12, 25.0), (24, 300.0)] {
        let structure = structure(1, |scene| {
            (scene.disk.waves, scene.disk.period) = (waves, period);
        });
        for (time, phi) in moments(300) {
            let r = 3.0 * (11.0_f64 / 3.0).powf(phi / TAU);
            // cos^4 has two harmonics: three waves or more per octave cancel both.
            let field = structure.field_at(r, phi, time, POINT);
            assert_close(format!("r {r} at {time}"), field.squares, 2.0, 1e-12);
        }
    }
}

#[test]
fn the_mean_of_a_random_factor_is_one_whatever_the_contrast_and_the_footprint() {
    // A footprint that hides about half of the waves' power.
    let [xx, xp, pp] = [0.0004, 0.0001, 0.001];
    let blurred = DMat3::from_cols_array_2d(&[[xx, xp, 0.0], [xp, pp, 0.0], [0.0; 3]]);
    let blurred = Covariance(blurred);
    let seed = random_seed(&mut Random::new());
    for sigma in [0.5, 1.0] {
        let structure = structure(seed, |scene| scene.disk.contrast = sigma);
        for (r, footprint) in RADII.into_iter().flat_map(|r| [(r, POINT), (r, blurred)]) {
            let factors: Vec<f64> = moments(8000)
                .map(|(time, phi)| structure.factor_at(r, phi, time, footprint))
                .collect();
            let (mean, error) = mean_and_error(&factors, 8000.0);
            // Five standard errors: of twenty means one in 90 000 runs is outside.
            assert!(
                (mean - 1.0).abs() < 5.0 * error,
                "seed {seed}, sigma {sigma}, r {r}: {mean} +- {error}"
            );
        }
    }
}

/// ln I_0 by its series (Abramowitz & Stegun 1964 9.6.12).
fn ln_bessel_i0(z: f64) -> f64 {
    let mut term = 1.0;
    let mut sum = 1.0;
    for k in 1..30 {
        term *= (0.5 * z / f64::from(k)).powi(2);
        sum += term;
    }
    sum.ln()
}

#[test]
fn the_mean_by_squares_and_fourth_powers_is_that_of_bessels_function() {
    let structure = structure(1, |_| {});
    for sigma in [0.5, 1.0, 1.5] {
        let mut worst = 0.0_f64;
        for (time, phi) in moments(2000) {
            let r = 3.0 * (11.0_f64 / 3.0).powf(phi / TAU);
            let terms = structure.terms(&in_plane(r, phi, time), POINT);
            let value: f64 = terms.iter().map(|t| t.amplitude * t.phase.cos()).sum();
            let exact: f64 = terms
                .iter()
                .map(|Term { amplitude, .. }| ln_bessel_i0(sigma * amplitude))
                .sum();
            let found = structure.field_at(r, phi, time, POINT).factor(sigma);
            worst = worst.max((found.ln() - (sigma * value - exact)).abs());
        }
        // The next term is sigma^6 sum A^6/576, with A up to 0.56.
        assert!(worst < 1e-3 * sigma.powi(6), "sigma {sigma}: {worst:e}");
    }
}

#[test]
fn a_random_field_has_no_mean_around_a_circle() {
    let seed = random_seed(&mut Random::new());
    let structure = structure(seed, |_| {});
    for (r, time) in [(3.5, 0.0), (5.0, 1e4), (9.0, -1e7)] {
        let around = |i: u32| TAU * f64::from(i) / 512.0;
        let values: Vec<_> = (0..512)
            .map(|i| structure.field_at(r, around(i), time, POINT))
            .collect();
        // No wave has fewer than one crest or more than 100, so 512 places average each
        // exactly.
        let mean = values.iter().map(|f| f.value).sum::<f64>() / 512.0;
        assert!(mean.abs() < 1e-9, "seed {seed}, r {r}: {mean:e}");
        let flux = values.iter().map(|f| f.factor(0.5)).sum::<f64>() / 512.0;
        // Products of waves with equal m have a mean, so that the flux scatters a little; with
        // waves of m = 0 it scattered by 0.13.
        assert!(
            (flux - 1.0).abs() < 0.25,
            "seed {seed}, r {r}: mean flux {flux}"
        );
    }
}

#[test]
fn a_random_field_is_a_function_of_seed_and_time_without_a_seam() {
    let mut random = Random::new();
    let [seed, another] = [(); 2].map(|()| random_seed(&mut random));
    let one = structure(seed, |_| {});
    let again = structure(seed, |_| {});
    let other = structure(another, |_| {});
    let mut unlike = 0.0_f64;
    for (time, phi) in moments(200) {
        let early = one.factor_at(5.0, phi, time, POINT);
        let late = one.factor_at(5.0, phi, 1e7, POINT);
        assert_ne!(early, late);
        assert_eq!(again.factor_at(5.0, phi, 1e7, POINT), late);
        assert_eq!(again.factor_at(5.0, phi, time, POINT), early);
        unlike = unlike.max((other.factor_at(5.0, phi, time, POINT) - early).abs());
        let seam = one.factor_at(5.0, PI, time, POINT) / one.factor_at(5.0, -PI, time, POINT);
        assert!((seam - 1.0).abs() < 1e-6, "{seam}");
    }
    assert!(unlike > 0.5, "another seed is another disk: {unlike}");
}

/// Angle of the filaments from the orbits, positive where they trail, and the lengths in ln r and
/// phi over which the field changes across and along them: from the tensor of its gradients.
fn filaments(seeds: std::ops::Range<u32>, time: f64) -> (f64, f64, f64) {
    let (mut xx, mut xp, mut pp, mut power) = (0.0, 0.0, 0.0, 0.0);
    for seed in seeds {
        let structure = structure(seed, |_| {});
        for (i, (_, phi)) in moments(400).enumerate() {
            let r = 3.0 * (11.0_f64 / 3.0).powf((i as f64 * 0.754_877_666).fract());
            let step = 1e-4;
            let value = |dx: f64, dphi: f64| {
                structure
                    .field_at(r * dx.exp(), phi + dphi, time, POINT)
                    .value
            };
            let here = value(0.0, 0.0);
            let dx = (value(step, 0.0) - here) / step;
            let dphi = (value(0.0, step) - here) / step;
            (xx, xp, pp) = (xx + dx * dx, xp + dx * dphi, pp + dphi * dphi);
            power += here * here;
        }
    }
    let half_turn = 0.5 * (2.0 * xp).atan2(xx - pp);
    let middle = 0.5 * (xx + pp);
    let radius = (0.25 * (xx - pp).powi(2) + xp * xp).sqrt();
    (
        half_turn.to_degrees(),
        (power / (middle + radius)).sqrt(),
        (power / (middle - radius)).sqrt(),
    )
}

#[test]
fn random_filaments_trail_by_the_same_angle_at_all_times_and_never_wind_up() {
    let seed = random_seed(&mut Random::new());
    let first = filaments(seed..seed + 120, 0.0);
    for time in [1e3, 1e5, 1e7] {
        let later = filaments(seed..seed + 120, time);
        eprintln!("{first:?} and at {time:e} {later:?}");
        assert!((first.0 - later.0).abs() < 1.0, "{first:?} {later:?}");
        assert_close("across", later.1, first.1, 0.06);
        assert_close("along", later.2, first.2, 0.12);
    }
    // Near the pitch of the middle of a life, 15 degrees. The aspect is 5 for the longest waves and
    // 10 for the finest, and the shear of a life turns part of the length into width.
    assert!((10.0..17.0).contains(&first.0), "{first:?}");
    assert!((5.0..8.0).contains(&(first.2 / first.1)), "{first:?}");
}

#[test]
fn somebody_who_goes_round_with_the_matter_sees_the_field_forget_itself_within_an_orbit() {
    for r in [3.6, 5.0, 7.5] {
        let omega = Kerr { spin: 0.0 }
            .circular_orbit(r)
            .unwrap()
            .angular_velocity;
        let structures: Vec<Structure> = (0..8).map(|seed| structure(seed, |_| {})).collect();
        let correlation = |orbits: f64| {
            let (mut product, mut power) = (0.0, 0.0);
            for (i, (time, phi)) in moments(6000).enumerate() {
                let structure = &structures[i % 8];
                let later = orbits * TAU / omega;
                let here = structure.field_at(r, phi, time, POINT).value;
                let there = structure
                    .field_at(r, phi + omega * later, time + later, POINT)
                    .value;
                product += here * there;
                power += 0.5 * (here * here + there * there);
            }
            product / power
        };
        let found = [0.1, 0.25, 0.5, 1.0].map(correlation);
        // The correlation of the windows alone, cos^2 against cos^2 at another age, for a life of
        // one orbit of the ring's centre, which lies within 11 per cent of r: 0.96, 0.73, 0.24 and
        // 0.
        let ranges = [(0.93, 0.98), (0.63, 0.80), (0.10, 0.36), (-0.08, 0.08)];
        for (found, (least, most)) in found.into_iter().zip(ranges) {
            assert!((least..most).contains(&found), "r {r}: {found}");
        }
    }
}

/// ln r and phi of the crossings of the disk that the pixel at (x, y) of a picture shows.
fn crossings(scene: &Scene, reference: &Reference, x: f64, y: f64) -> Vec<[f64; 2]> {
    let (width, height) = (240.0, 135.0);
    let tan_half = (scene.camera.fov_deg.to_radians() / 2.0).tan();
    let direction = DVec3::new(
        (2.0 * x - width) / height * tan_half,
        (1.0 - 2.0 * y / height) * tan_half,
        1.0,
    );
    let trace = reference.trace(scene.camera.tetrad_from_camera() * direction.normalize());
    let hits = trace.hits.into_iter().flatten();
    hits.map(|hit| [hit.r.ln(), hit.phi]).collect()
}

/// The change from a pixel's first crossing to that of its neighbour in the same image of the disk,
/// in units of its radius, outward and along the orbit. As in footprint.wgsl the neighbour's
/// crossing is the first one, or the last one if the pixel has no other and this one is nearer.
fn change(here: &[[f64; 2]], there: &[[f64; 2]]) -> Option<[f64; 2]> {
    let from = here[0];
    let change = |to: &[f64; 2]| {
        let (r, turn) = ((to[0] - from[0]).exp(), to[1] - from[1]);
        [r * turn.cos() - 1.0, r * turn.sin()]
    };
    let last = there.last().filter(|_| here.len() == 1);
    let candidates = there.first().into_iter().chain(last).map(change);
    candidates.min_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1])))
}

/// Fields that `one_filtered_ray_a_pixel_stands_for_many_in_random_fields` looks at.
const FIELDS: usize = 15;

/// The filter against 16 rays a pixel, with differences to the neighbours as on the GPU: streaks of
/// sigma = 0.8 in a small picture, where they are finer than pixels.
#[test]
fn one_filtered_ray_a_pixel_stands_for_many_in_random_fields() {
    let mut scene = Scene::default();
    scene.disk.structure = DiskStructure::Turbulent;
    scene.disk.contrast = 0.8;
    // The view of the preset edge-on.
    (scene.camera.theta_deg, scene.camera.fov_deg) = (83.0, 50.0);
    let reference = Reference::new(&scene).unwrap();
    let mut random = Random::new();
    let structures: [_; FIELDS] = array::from_fn(|_| {
        scene.disk.seed = random_seed(&mut random);
        Structure::new(&scene, None).unwrap()
    });
    let mut sums = [[0.0; 4]; FIELDS];
    let mut count = 0.0;
    for pixel in (0..120 * 45).map(|i| [2 * (i % 120), 3 * (i / 120)]) {
        let [x, y] = pixel.map(f64::from);
        let at = |dx: f64, dy: f64| crossings(&scene, &reference, x + dx, y + dy);
        let here = at(0.5, 0.5);
        let shares = [0.125, 0.375, 0.625, 0.875];
        let rays: Vec<_> = (0..16).map(|i| at(shares[i % 4], shares[i / 4])).collect();
        // Pixels that show one image: what several images in a pixel look like is not the filter's.
        if here.is_empty() || rays.iter().any(|ray| ray.len() != here.len()) {
            continue;
        }
        let [right, down] = [[1.5, 0.5], [0.5, 1.5]].map(|[dx, dy]| change(&here, &at(dx, dy)));
        let (Some(right), Some(down)) = (right, down) else {
            continue;
        };
        count += 1.0;
        let footprint = Covariance::of_pixel(right, down);
        for (structure, sums) in structures.iter().zip(&mut sums) {
            let factor =
                |[x, phi]: [f64; 2], footprint| structure.factor_at(x.exp(), phi, 0.0, footprint);
            let many = rays.iter().map(|ray| factor(ray[0], POINT)).sum::<f64>() / 16.0;
            let (one, filtered) = (factor(here[0], POINT), factor(here[0], footprint));
            for (sum, value) in sums.iter_mut().zip([
                (one - many).powi(2),
                (filtered - many).powi(2),
                filtered,
                many,
            ]) {
                *sum += value;
            }
        }
    }
    assert!(count > 600.0, "the picture shows the disk: {count} pixels");
    let mut left = sums.map(|[unfiltered, filtered, ..]: [f64; 4]| (filtered / unfiltered).sqrt());
    left.sort_by(f64::total_cmp);
    eprintln!("{count} pixels: the shares of the error that are left: {left:.2?}");
    // What is left comes from pixels whose neighbours are not the same distance away on both sides,
    // and from the difference between the mean of an exponential and the exponential of a mean.
    // A few bright pixels decide about one field: of 200 fields the median is 0.33, and one in
    // sixteen is above 0.45. The median of 15 fields is above 0.45 once in a million runs.
    assert!(left[FIELDS / 2] < 0.45, "{left:?}");
    // The mean of one field is off by up to 1.8 per cent, with a standard deviation of 0.6: 0.15 for
    // the mean of 15.
    let [mean, truth] = [2, 3].map(|i| sums.iter().map(|sum| sum[i]).sum::<f64>());
    assert_close("mean of the pictures", mean, truth, 0.01);
}
