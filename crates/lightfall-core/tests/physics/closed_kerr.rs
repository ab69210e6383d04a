//! Light around holes that spin in closed form, against the reference, which takes steps.

mod polar;
mod radial;
mod ray;
mod weierstrass;

use crate::random::Random;
use glam::DVec3;
use lightfall_core::accuracy::Quantiles;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::mino::{PhotonConstants, PhotonState};
use lightfall_core::geometry::schwarzschild::CRITICAL_IMPACT;
use lightfall_core::optics::reference::{HoleAndDisk, Reference};
use lightfall_core::optics::trace::Trace;
use lightfall_core::scene::{ObserverKind, Scene};
use ray::ClosedRay;

/// The reference of a camera with zero angular momentum, without a disk, and its rays in closed
/// form.
struct Camera {
    reference: Reference,
    kerr: Kerr,
}

impl Camera {
    fn new(spin: f64, r: f64, theta_deg: f64, outer: Option<f64>) -> Self {
        let mut scene = Scene::default();
        scene.hole.spin = spin;
        (scene.camera.r, scene.camera.theta_deg) = (r, theta_deg);
        scene.observer.kind = ObserverKind::Zamo;
        scene.disk.enabled = outer.is_some();
        (scene.disk.inner, scene.disk.outer) = (0.0, outer.unwrap_or(1.0));
        Self {
            reference: Reference::new(&scene).unwrap(),
            kerr: Kerr { spin },
        }
    }

    fn orbit(&self, direction: DVec3) -> ClosedRay {
        let (r, n) = self.reference.camera();
        let photon = self.reference.photon(direction);
        let (constants, start) = PhotonConstants::of_photon(self.kerr, &photon, r, n);
        ClosedRay::new(self.kerr, &constants, start)
    }
}

/// Cameras far away, close by, over the pole and in the plane, also next to nearly extremal holes.
const CAMERAS: [[f64; 3]; 18] = [
    [0.9, 20.0, 83.0],
    [0.998, 6.0, 60.0],
    [-0.7, 30.0, 100.0],
    [0.5, 3.0, 70.0],
    [0.9, 1000.0, 80.0],
    [0.9, 1.6, 20.0],
    [0.9, 4.0, 1.0],
    [0.999_999, 5.0, 90.0],
    [-0.9999, 20.0, 90.0],
    [0.1, 1.3, 20.0],
    [1e-3, 7.0, 20.0],
    [0.7, 2.0, 0.0],
    [0.998, 0.8, 60.0],
    [0.998, 0.56, 30.0],
    [0.9999, 0.6, 60.0],
    [0.9999, 1.0, 60.0],
    [0.9999, 6.0, 60.0],
    [-0.9999, 0.8, 90.0],
];

/// Rays that failed once: spin, E, L and K, u and u', n, n'. A root of Weierstrass's cubic past the
/// inflection, a critical point next to the horizon, and sums over halves that agreed by chance.
const HARD_RAYS: [[f64; 12]; 3] = [
    [
        0.9999,
        0.490_432_584_370_639_63,
        0.473_706_044_186_810_17,
        0.309_051_639_036_557_9,
        1.666_666_666_666_666_7,
        -0.139_461_371_520_194_97,
        0.866_025_403_784_438_6,
        0.0,
        0.500_000_000_000_000_1,
        -0.078_874_639_552_549_9,
        -0.546_988_624_256_015_2,
        0.136_614_883_133_698_13,
    ],
    [
        0.9999,
        0.625_392_918_779_013_5,
        0.626_834_635_509_098_7,
        0.621_239_946_181_725_7,
        1.0,
        -0.370_929_168_415_798_26,
        0.866_025_403_784_438_6,
        0.0,
        0.500_000_000_000_000_1,
        0.174_488_022_059_757_03,
        -0.723_806_291_097_118_1,
        -0.302_222_119_519_698_13,
    ],
    [
        0.9999,
        0.549_500_588_274_177_7,
        0.546_598_082_384_839_5,
        0.555_859_253_612_449,
        1.666_666_666_666_666_7,
        -0.064_407_695_850_745_66,
        0.866_025_403_784_438_6,
        0.0,
        0.500_000_000_000_000_1,
        -0.209_981_026_260_720_13,
        -0.631_157_100_006_840_8,
        0.363_697_806_109_021_8,
    ],
];

/// A direction of the whole sky, or one about the hole.
fn direction(random: &mut Random, r: f64) -> DVec3 {
    let any = random.direction();
    if random.one_in(2) {
        return any;
    }
    let aside = random.log_between(1e-3, 1.0) * (6.0 / r).min(1.0);
    (DVec3::NEG_X + aside * any).normalize()
}

/// The largest change of the reference's trace if the ray is turned by 1e-12 rad: what the rounding
/// of its constants can do.
fn rounding(reference: &Reference, direction: DVec3, change: impl Fn(&Trace) -> f64) -> f64 {
    let across = direction.any_orthonormal_vector();
    let axes = [
        across,
        -across,
        across.cross(direction),
        direction.cross(across),
    ];
    let turned = axes.map(|axis| (direction + 1e-12 * axis).normalize());
    turned
        .into_iter()
        .map(|direction| change(&reference.trace(direction)))
        .fold(0.0, f64::max)
}

/// The distance of a trace's sky direction from `truth`; infinite where the ray ends elsewhere.
fn change_of_sky(trace: &Trace, truth: DVec3) -> f64 {
    let sky = trace.sky;
    sky.map_or(f64::INFINITY, |sky| (sky - truth).length())
}

/// The radii of a trace's hits.
fn radii(trace: &Trace) -> Vec<f64> {
    trace.hits.iter().flatten().map(|hit| hit.r).collect()
}

/// The largest relative difference of two lists of radii; infinite where one is longer.
fn difference(given: &[f64], known: &[f64]) -> f64 {
    if given.len() != known.len() {
        return f64::INFINITY;
    }
    let differences = given.iter().zip(known).map(|(a, b)| (a / b - 1.0).abs());
    differences.fold(0.0, f64::max)
}

/// The tolerance is 1e-11 rad. A larger error, next to the critical curve, must be no larger than a
/// tenth of that of a turn of the ray by 1e-12 rad.
#[test]
fn every_outcome_and_sky_direction_of_random_rays_is_that_of_the_reference() {
    let mut random = Random::new();
    for [spin, r, theta] in CAMERAS {
        let camera = Camera::new(spin, r, theta, None);
        let mut errors = Vec::new();
        for _ in 0..2000 {
            let direction = direction(&mut random, r);
            let truth = camera.reference.trace(direction).sky;
            let given = camera.orbit(direction).sky();
            assert_eq!(truth.is_some(), given.is_some(), "{spin} {r} {direction}");
            let Some((truth, given)) = truth.zip(given) else {
                continue;
            };
            let error = (truth - given).length();
            let sensitivity = || {
                let change = |trace: &Trace| change_of_sky(trace, truth);
                rounding(&camera.reference, direction, change)
            };
            assert!(
                error < 1e-11 || error < 0.1 * sensitivity(),
                "{spin} {r} {direction}: {error:e}"
            );
            errors.push(error);
        }
        let sensitive = errors.iter().filter(|error| **error > 1e-11).count();
        // From next to the horizon a few dozen rays escape: too few to tell a share from chance.
        let share = sensitive as f64 / errors.len().max(200) as f64;
        let Quantiles { p50, p99, max, .. } = Quantiles::of(errors.into_iter());
        println!("{spin} {r} {theta}: {p50:.1e} {p99:.1e} {max:.1e} {share:.3}");
        assert!(
            p50 < 1e-13 && share < 0.05,
            "{spin} {r} {theta}: {p50:e} {p99:e} {max:e} {share}"
        );
    }
}

/// Crossings of rays that reach the sky, at radii up to 1000 r_s, to a relative tolerance of 1e-11.
/// A larger error must be no larger than that of a turn of the ray by 1e-12 rad. Next to a nearly
/// extremal hole the constants nearly cancel in u', and their rounding has the effect of up to 5e-14
/// rad in 200 runs: a tenth of the turn would be too near.
#[test]
fn crossings_of_the_plane_by_random_rays_are_those_of_the_reference() {
    let mut random = Random::new();
    let mut compared = 0;
    for [spin, r, theta] in CAMERAS {
        let camera = Camera::new(spin, r, theta, Some(1000.0));
        let inner = camera.kerr.isco();
        let mut errors = Vec::new();
        for _ in 0..2000 {
            let direction = direction(&mut random, r);
            let truth = camera.reference.trace(direction);
            let orbit = camera.orbit(direction);
            if truth.sky.is_none() {
                continue;
            }
            let crossings = (0..64).map_while(|index| orbit.crossing(index));
            let hits: Vec<f64> = crossings
                .map(|u| 1.0 / u)
                .filter(|r| *r > inner && *r < 1000.0)
                .take(2)
                .collect();
            let known = radii(&truth);
            let error = difference(&hits, &known);
            let sensitivity = || {
                let change = |trace: &Trace| difference(&radii(trace), &known);
                rounding(&camera.reference, direction, change)
            };
            assert!(
                known.len() == hits.len() && (error < 1e-11 || error < sensitivity()),
                "{spin} {r} {direction}: {error:e} {known:?}, {hits:?}"
            );
            if !known.is_empty() {
                errors.push(error);
            }
        }
        if errors.is_empty() {
            continue;
        }
        let Quantiles { p50, p99, max, .. } = Quantiles::of(errors.into_iter());
        println!("{spin} {r} {theta}: {p50:.1e} {p99:.1e} {max:.1e}");
        assert!(p50 < 1e-12, "{spin} {r} {theta}: {p50:e} {p99:e} {max:e}");
        compared += 1;
    }
    // From next to the horizon no ray may both cross the plane and reach the sky.
    assert!(2 * compared > CAMERAS.len(), "{compared} cameras");
}

#[test]
fn rays_that_failed_once_are_those_of_the_reference() {
    for [spin, energy, l, k, u, du, x, y, z, dx, dy, dz] in HARD_RAYS {
        let kerr = Kerr { spin };
        let constants = PhotonConstants {
            a: kerr.a(),
            energy,
            angular_momentum: l,
            k,
            ingoing: false,
        };
        let (n, dn) = (DVec3::new(x, y, z), DVec3::new(dx, dy, dz));
        let start = PhotonState {
            u,
            du,
            n,
            dn,
            chi: 0.0,
        };
        let scene = HoleAndDisk {
            kerr,
            annulus: None,
        };
        let truth = scene.trace(&constants, start).sky.unwrap();
        let given = ClosedRay::new(kerr, &constants, start).sky().unwrap();
        let error = (truth - given).length();
        println!("{error:.1e}");
        assert!(error < 1e-11, "{energy} {l} {k}: {error:e}");
    }
}

/// The critical curve without spin, from the form that finds it for any spin.
#[test]
fn a_slow_hole_has_the_critical_impact_parameter_of_one_that_does_not_spin() {
    let camera = Camera::new(1e-9, 50.0, 90.0, None);
    let (r, _) = camera.reference.camera();
    let edge = (CRITICAL_IMPACT / r * (1.0 - 1.0 / r).sqrt()).asin();
    for (share, escapes) in [(1.0 - 1e-7, false), (1.0 + 1e-7, true)] {
        let alpha = edge * share;
        let direction = DVec3::new(-alpha.cos(), alpha.sin(), 0.0);
        assert_eq!(camera.orbit(direction).escapes(), escapes, "{share}");
    }
}
