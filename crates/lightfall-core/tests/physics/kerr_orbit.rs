//! Light around holes that spin in closed form, against the reference, which takes steps.

use crate::random::Random;
use glam::DVec3;
use lightfall_core::accuracy::Quantiles;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::kerr_orbit::{KerrOrbit, weierstrass};
use lightfall_core::geometry::mino::Constants;
use lightfall_core::geometry::schwarzschild::CRITICAL_IMPACT;
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{ObserverKind, Scene};

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

    fn orbit(&self, direction: DVec3) -> KerrOrbit {
        let (r, n) = self.reference.camera();
        let photon = self.reference.photon(direction);
        let (constants, start) = Constants::of_photon(self.kerr, &photon, r, n);
        KerrOrbit::new(self.kerr, &constants, start)
    }
}

/// Cameras far away, close by, over the pole and in the plane. Within 2 r_+ of a nearly extremal
/// hole the closed form still loses digits next to the critical curve, up to 1e-3 rad.
const CAMERAS: [[f64; 3]; 12] = [
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

/// The largest change of the reference's sky direction if the ray is turned by 1e-12 rad: what the
/// rounding of its constants can do. Infinite where the turned ray may end elsewhere.
fn rounding_of_sky(reference: &Reference, direction: DVec3, truth: DVec3) -> f64 {
    let across = direction.any_orthonormal_vector();
    let turned = |axis: DVec3| {
        let sky = reference.trace((direction + 1e-12 * axis).normalize()).sky;
        sky.map_or(f64::INFINITY, |sky| (sky - truth).length())
    };
    let axes = [
        across,
        -across,
        across.cross(direction),
        direction.cross(across),
    ];
    axes.into_iter().map(turned).fold(0.0, f64::max)
}

/// The tolerance is 1e-10 rad. A larger error, next to the critical curve, must be no larger than
/// that of a turn of the ray by 1e-12 rad.
#[test]
fn every_outcome_and_sky_direction_is_that_of_the_reference() {
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
            assert!(
                error < 1e-10 || error < rounding_of_sky(&camera.reference, direction, truth),
                "{spin} {r} {direction}: {error:e}"
            );
            errors.push(error);
        }
        let Quantiles { p50, p99, max, .. } = Quantiles::of(errors.into_iter());
        println!("{spin} {r} {theta}: {p50:.1e} {p99:.1e} {max:.1e}");
        assert!(
            p50 < 1e-13 && p99 < 1e-10,
            "{spin} {r} {theta}: {p50:e} {p99:e} {max:e}"
        );
    }
}

/// Crossings of rays that reach the sky, at radii up to 1000 r_s.
#[test]
fn crossings_of_the_plane_are_those_of_the_reference() {
    let mut random = Random::new();
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
            let crossings = (0..8).map_while(|index| orbit.crossing(index));
            let hits: Vec<f64> = crossings
                .map(|u| 1.0 / u)
                .filter(|r| *r > inner && *r < 1000.0)
                .take(2)
                .collect();
            let known: Vec<f64> = truth.hits.iter().flatten().map(|hit| hit.r).collect();
            assert_eq!(
                known.len(),
                hits.len(),
                "{spin} {r} {direction}: {known:?}, {hits:?}"
            );
            errors.extend(
                known
                    .iter()
                    .zip(&hits)
                    .map(|(known, hit)| (hit / known - 1.0).abs()),
            );
        }
        if errors.is_empty() {
            continue;
        }
        let Quantiles { p50, p99, .. } = Quantiles::of(errors.into_iter());
        println!("{spin} {r} {theta}: {p50:.1e} {p99:.1e}");
        assert!(
            p50 < 1e-12 && p99 < 1e-9,
            "{spin} {r} {theta}: {p50:e} {p99:e}"
        );
    }
}

/// P'^2 = 4 P^3 - g2 P - g3, and the homogeneity of P: two independent identities.
#[test]
fn weierstrass_function_obeys_its_equation_and_scales() {
    let mut random = Random::new();
    for _ in 0..1000 {
        let (z, g2, g3) = (
            random.between(0.01, 2.0),
            random.between(-1.0, 1.0),
            random.between(-1.0, 1.0),
        );
        let [p, dp] = weierstrass(z, g2, g3);
        let right = 4.0 * p.powi(3) - g2 * p - g3;
        let scale = 4.0 * p.abs().powi(3) + (g2 * p).abs() + g3.abs();
        assert!(
            (dp * dp - right).abs() < 1e-10 * scale,
            "{z} {g2} {g3}: {p} {dp}"
        );
        let t = random.between(0.5, 2.0);
        let [q, dq] = weierstrass(t * z, g2 / t.powi(4), g3 / t.powi(6));
        assert!(
            (q * t * t - p).abs() < 1e-9 * p.abs().max(1.0),
            "{z} {g2} {g3}"
        );
        assert!(
            (dq * t.powi(3) - dp).abs() < 1e-8 * dp.abs().max(1.0),
            "{z} {g2} {g3}"
        );
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
