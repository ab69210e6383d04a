//! The reference method against closed forms, symmetries and limits.

use crate::schwarzschild::SHADOW;
use crate::{assert_close, bisect};
use glam::{DMat3, DVec2, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::observer_matrix;
use lightfall_core::geometry::schwarzschild::{shadow_half_angle_rain, shadow_half_angle_static};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::{Outcome, Trace};
use lightfall_core::scene::{ObserverKind, Scene};
use std::f64::consts::PI;

/// A scene without a disk.
fn scene(spin: f64, r: f64, theta_deg: f64, kind: ObserverKind) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg) = (r, theta_deg);
    scene.observer.kind = kind;
    scene.disk.enabled = false;
    scene
}

fn trace(scene: &Scene, direction: DVec3) -> Trace {
    Reference::new(scene).unwrap().trace(direction)
}

/// Directions spread over the sphere by the golden angle.
pub fn directions(count: u32) -> impl Iterator<Item = DVec3> {
    (0..count).map(move |i| {
        let z = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(count);
        let (sin, cos) = (2.399_963_229_728_653 * f64::from(i)).sin_cos();
        DVec3::new(z, (1.0 - z * z).sqrt() * cos, (1.0 - z * z).sqrt() * sin)
    })
}

/// The angle from the inward direction at which rays stop being captured.
fn shadow_half_angle(scene: &Scene) -> f64 {
    let reference = Reference::new(scene).unwrap();
    bisect(0.0, PI, |angle| {
        reference
            .trace(DVec3::new(
                -angle.cos(),
                0.6 * angle.sin(),
                0.8 * angle.sin(),
            ))
            .outcome
            == Outcome::Captured
    })
}

/// Against a table of twelve digits (mpmath) and the closed form, which also covers an observer in
/// free fall inside the horizon. 1e-12: outcomes change where D = 0 except for some rounding
/// errors.
#[test]
fn shadow_half_angles_are_those_of_the_closed_form() {
    for [r, at_rest, falling] in SHADOW {
        for (kind, degrees, closed) in [
            (ObserverKind::Static, at_rest, shadow_half_angle_static(r)),
            (ObserverKind::Rain, falling, shadow_half_angle_rain(r)),
        ] {
            let found = shadow_half_angle(&scene(0.0, r, 70.0, kind));
            assert_close(
                format_args!("table, {kind:?}, r = {r}"),
                found.to_degrees(),
                degrees,
                5e-12,
            );
            assert_close(
                format_args!("closed form, {kind:?}, r = {r}"),
                found,
                closed,
                1e-12,
            );
        }
    }
    for r in [1.0, 0.7, 0.1] {
        let found = shadow_half_angle(&scene(0.0, r, 70.0, ObserverKind::Rain));
        assert_close(
            format_args!("inside, r = {r}"),
            found,
            shadow_half_angle_rain(r),
            1e-12,
        );
    }
}

/// Without spin a radial ray is straight: outward to the point of the sky overhead, inward to the
/// hole.
#[test]
fn radial_rays_are_straight() {
    for r in [1.0001, 1.5, 20.0, 1e7] {
        let view = scene(0.0, r, 55.0, ObserverKind::Static);
        let theta = 55.0_f64.to_radians();
        let out = trace(&view, DVec3::X);
        assert!(
            (out.sky.unwrap() - DVec3::new(theta.sin(), 0.0, theta.cos())).length() < 1e-15,
            "r = {r}"
        );
        assert_eq!(
            trace(&view, DVec3::NEG_X).outcome,
            Outcome::Captured,
            "r = {r}"
        );
    }
    // The axis of a spinning hole is a principal null direction, where this holds as well.
    for spin in [-0.7, 0.95] {
        let out = trace(&scene(spin, 3.0, 0.0, ObserverKind::Static), DVec3::X);
        assert!(
            (out.sky.unwrap() - DVec3::Z).length() < 1e-15,
            "spin {spin}"
        );
    }
}

/// phi -> -phi reverses the spin. The arithmetic is the same, so only rounding errors differ, which
/// rays near the critical curve amplify.
#[test]
fn a_mirrored_hole_shows_the_mirrored_sky() {
    for spin in [0.3, 0.95, 0.9999] {
        let [one, other] = [spin, -spin]
            .map(|spin| Reference::new(&scene(spin, 8.0, 70.0, ObserverKind::Zamo)).unwrap());
        let mut compared = 0;
        for d in directions(300) {
            let (a, b) = (one.trace(d), other.trace(DVec3::new(d.x, d.y, -d.z)));
            assert_eq!(a.outcome, b.outcome, "spin {spin}, {d}");
            if let (Some(a), Some(b)) = (a.sky, b.sky) {
                assert!(
                    (a - DVec3::new(b.x, -b.y, b.z)).length() < 1e-11,
                    "spin {spin}, {d}"
                );
                compared += 1;
            }
        }
        assert!(compared > 200, "spin {spin}: {compared} rays");
    }
}

/// The hole is symmetric about its axis: a change of the camera's azimuth rotates the sky. On the
/// axis a rotation of the direction does the same.
#[test]
fn a_rotation_about_the_axis_rotates_the_sky() {
    let turn = DMat3::from_rotation_z(40.0_f64.to_radians());
    let still = scene(0.95, 6.0, 65.0, ObserverKind::Static);
    let mut turned = still.clone();
    turned.camera.phi_deg = 40.0;
    let axis = Reference::new(&scene(0.95, 6.0, 0.0, ObserverKind::Static)).unwrap();
    let (still, turned) = (
        Reference::new(&still).unwrap(),
        Reference::new(&turned).unwrap(),
    );
    let mut compared = 0;
    for d in directions(300) {
        // On the axis the axes toward growing theta and phi are x and y, the outward one is z.
        let around = turn * DVec3::new(d.y, d.z, d.x);
        let around = DVec3::new(around.z, around.x, around.y);
        for (a, b) in [
            (still.trace(d), turned.trace(d)),
            (axis.trace(d), axis.trace(around)),
        ] {
            assert_eq!(a.outcome, b.outcome, "{d}");
            if let (Some(a), Some(b)) = (a.sky, b.sky) {
                assert!((turn * a - b).length() < 1e-11, "{d}: {a} and {b}");
                compared += 1;
            }
        }
    }
    assert!(compared > 400, "{compared} rays");
}

/// Away from the critical curve the effect of a small spin is linear in the spin: a tenth of the
/// spin has a tenth of the effect, within a percent.
#[test]
fn kerr_is_continuous_at_zero_spin() {
    let [none, small, smaller] = [0.0, 1e-6, 1e-7]
        .map(|spin| Reference::new(&scene(spin, 10.0, 70.0, ObserverKind::Static)).unwrap());
    let mut compared = 0;
    for d in directions(100).filter(|d| d.x > -0.9) {
        let sky = |reference: &Reference| reference.trace(d).sky.unwrap();
        let (one, ten) = (
            (sky(&smaller) - sky(&none)).length(),
            (sky(&small) - sky(&none)).length(),
        );
        assert!((ten / one - 10.0).abs() < 0.1, "{d}: {one:e} and {ten:e}");
        compared += 1;
    }
    assert!(compared > 90);
}

/// No observer, spin or direction leaves a ray unfinished, and the number of steps stays small. The
/// constraints hold to some rounding errors over E, because E per unit frequency is a small
/// difference where light comes from below a camera that falls through the horizon. At these places
/// other formulations stall or divide by zero.
#[test]
fn extreme_rays_end_in_few_steps() {
    let mut most = 0;
    for spin in [0.0, 1e-9, 0.5, -0.9, 0.998, -0.9999, 0.999_999_9] {
        let horizon = Kerr { spin }.horizon();
        for r in [1.0001 * horizon, 1.4 * horizon, 20.0, 1e7] {
            for theta_deg in [0.0, 1e-7, 37.0, 90.0, 180.0] {
                for kind in [ObserverKind::Zamo, ObserverKind::Rain] {
                    let mut view = scene(spin, r, theta_deg, kind);
                    view.disk.enabled = true;
                    let reference = Reference::new(&view).unwrap();
                    let theta = theta_deg.to_radians();
                    let matrix = observer_matrix(spin, kind, [0.0; 3], r, theta, 0.0).unwrap();
                    let axes = [
                        DVec3::X,
                        DVec3::NEG_X,
                        DVec3::Y,
                        DVec3::NEG_Y,
                        DVec3::Z,
                        DVec3::NEG_Z,
                    ];
                    // Toward the hole, which a far camera sees at a small angle.
                    let near =
                        directions(40).map(|d| DVec3::new(-r.max(3.0), 4.0 * d.y, 4.0 * d.z));
                    for d in axes.into_iter().chain(directions(40)).chain(near) {
                        let trace = reference.trace(d);
                        let place = format!("spin {spin}, r {r}, theta {theta_deg}, {kind:?}, {d}");
                        assert_ne!(trace.outcome, Outcome::Unfinished, "{place}");
                        let bound = 1e-12 + 1e-15 / matrix.photon(d.normalize()).energy.abs();
                        assert!(
                            trace.residual < bound,
                            "{place}: residual {:e}",
                            trace.residual
                        );
                        assert_eq!(
                            trace.sky.is_some(),
                            trace.outcome == Outcome::Sky,
                            "{place}"
                        );
                        most = most.max(trace.steps);
                    }
                }
            }
        }
    }
    println!("most steps: {most}");
    assert!(most < 400, "{most} steps");
}

/// Far away the moment of light that crosses the line of sight is large, and a fast observer sees it
/// another hundred times larger. High powers of it are still finite in f64.
#[test]
fn fast_observers_far_away_finish_every_ray() {
    for (spin, r) in [(-0.842, 761_378.0), (0.0, 1e7), (0.9999, 1e7)] {
        let mut view = scene(spin, r, 119.8, ObserverKind::Rain);
        view.observer.velocity = [-0.239, 0.4555, 0.857_36];
        let reference = Reference::new(&view).unwrap();
        let toward_the_hole = DVec3::NEG_X;
        for direction in directions(400).chain([toward_the_hole]) {
            let trace = reference.trace(direction);
            assert_ne!(
                trace.outcome,
                Outcome::Unfinished,
                "spin {spin}, r {r}, {direction}"
            );
        }
    }
}

/// Next to the critical curve the number of windings grows only with the logarithm of the distance.
#[test]
fn rays_next_to_the_critical_curve_end_on_both_sides() {
    for spin in [0.0, 0.9] {
        let view = scene(spin, 20.0, 90.0, ObserverKind::Static);
        let reference = Reference::new(&view).unwrap();
        let ray = |angle: f64| reference.trace(DVec3::new(-angle.cos(), 0.0, angle.sin()));
        let edge = bisect(0.0, 1.0, |angle| ray(angle).outcome == Outcome::Captured);
        for distance in [1e-3, 1e-7, 1e-11, 1e-15] {
            let [inside, outside] = [-distance, distance].map(|x| ray(edge * (1.0 + x)));
            assert_eq!(
                [inside.outcome, outside.outcome],
                [Outcome::Captured, Outcome::Sky],
                "spin {spin}, {distance:e}"
            );
            assert!(
                outside.steps < 150 && inside.steps < 150,
                "spin {spin}: {} and {} steps",
                inside.steps,
                outside.steps
            );
        }
    }
}

/// A camera in the disk's plane: a ray in the plane has no isolated crossing, a ray that leaves the
/// plane does not hit the disk at the camera's place, and a ray that comes back hits it elsewhere.
#[test]
fn a_camera_in_the_plane_does_not_see_the_disk_at_its_own_place() {
    for spin in [0.0, 0.9] {
        let mut view = scene(spin, 6.0, 90.0, ObserverKind::Static);
        view.disk.enabled = true;
        for d in [
            DVec3::new(-0.8, 0.0, 0.6),
            DVec3::X,
            DVec3::new(0.0, 0.0, -1.0),
        ] {
            assert_eq!(trace(&view, d).hits, [None; 2], "spin {spin}, {d}");
        }
        for d in [DVec3::new(0.1, 1.0, 0.2), DVec3::new(0.1, -1.0, 0.2)] {
            assert_eq!(trace(&view, d).hits, [None; 2], "spin {spin}, {d}");
        }
        // Over the hole and down behind the hole.
        let over = trace(&view, DVec3::new(-1.0, -0.6, 0.0));
        let hit = over.hits[0].unwrap();
        assert!(hit.phi.cos() < 0.0 && hit.r > 3.0, "spin {spin}: {hit:?}");
    }
}

/// The view is continuous through the horizon. Boyer-Lindquist's azimuth outside and Kerr's ingoing
/// azimuth inside differ by the lead, which is added to the camera's azimuth. Hits have
/// Boyer-Lindquist azimuths on both sides.
#[test]
fn the_view_of_a_falling_camera_is_continuous_at_the_horizon() {
    for spin in [-0.6, 0.0, 0.9] {
        let kerr = Kerr { spin };
        let [inside, outside] = [-1e-7, 1e-7].map(|x| kerr.horizon() * (1.0 + x));
        let [mut within, mut without] =
            [inside, outside].map(|r| scene(spin, r, 60.0, ObserverKind::Rain));
        (within.disk.enabled, without.disk.enabled) = (true, true);
        without.camera.phi_deg = -kerr.ingoing_azimuth_lead(outside).to_degrees();
        let (within, without) = (
            Reference::new(&within).unwrap(),
            Reference::new(&without).unwrap(),
        );
        let (mut compared, mut hits) = (0, 0);
        // Looking outward, away from the critical curve, which would amplify the 2e-7 between the
        // two places.
        for d in directions(400).filter(|d| d.x > 0.0) {
            let (a, b) = (within.trace(d), without.trace(d));
            if let (Some(a), Some(b)) = (a.sky, b.sky) {
                assert!((a - b).length() < 1e-6, "spin {spin}, {d}: {a} and {b}");
                compared += 1;
            }
            if let ([Some(a), _], [Some(b), _]) = (a.hits, b.hits) {
                let apart =
                    (a.r * DVec2::from_angle(a.phi) - b.r * DVec2::from_angle(b.phi)).length();
                assert!(
                    apart < 1e-4 && (a.g - b.g).abs() < 1e-6,
                    "spin {spin}, {d}: {a:?} and {b:?}"
                );
                hits += 1;
            }
        }
        assert!(
            compared > 100 && hits > 5,
            "spin {spin}: only {compared} rays and {hits} hits"
        );
    }
}

#[test]
fn directions_may_have_any_length_and_a_zero_direction_is_unfinished() {
    let reference = Reference::new(&scene(0.5, 6.0, 65.0, ObserverKind::Static)).unwrap();
    let d = DVec3::new(-0.5, 0.75, 0.25);
    for scale in [1e-300, 1e-10, 1e300] {
        let (a, b) = (
            reference.trace(d).sky.unwrap(),
            reference.trace(scale * d).sky.unwrap(),
        );
        assert!((a - b).length() < 1e-13, "{scale:e}");
    }
    for d in [DVec3::ZERO, DVec3::NAN, DVec3::new(f64::INFINITY, 0.0, 0.0)] {
        assert_eq!(reference.trace(d).outcome, Outcome::Unfinished, "{d}");
    }
}
