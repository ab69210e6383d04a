//! Guides: curves on the camera's sky, against closed forms and against rays traced next to them.

use crate::assert_close;
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::mino::PhotonConstants;
use lightfall_core::geometry::schwarzschild::shadow_half_angle_static;
use lightfall_core::geometry::sphere::angle_between;
use lightfall_core::optics::guides::{
    Guide, Landmark, bar_across_hole, quick_guides, traced_guides,
};
use lightfall_core::optics::path::Path;
use lightfall_core::optics::reference::{HoleAndDisk, Reference};
use lightfall_core::optics::trace::{Hit, Outcome};
use lightfall_core::scene::{ObserverKind, Scene};

fn scene(spin: f64, kind: ObserverKind, velocity: [f64; 3], r: f64, theta_deg: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.observer.kind, scene.observer.velocity) = (kind, velocity);
    (scene.camera.r, scene.camera.theta_deg) = (r, theta_deg);
    scene
}

fn scenes() -> Vec<Scene> {
    use ObserverKind::{Orbit, Rain, Static, Zamo};
    vec![
        scene(0.0, Static, [0.0; 3], 20.0, 83.0),
        scene(0.0, Static, [0.3, -0.2, 0.5], 20.0, 70.0),
        scene(0.0, Static, [0.0; 3], 1.2, 50.0),
        scene(0.0, Rain, [0.0; 3], 0.8, 75.0),
        scene(0.9, Static, [0.0; 3], 20.0, 83.0),
        scene(0.998, Static, [0.0; 3], 10.5, 25.0),
        scene(-0.7, Zamo, [0.1, 0.4, -0.3], 6.0, 100.0),
        scene(0.9, Orbit, [0.0; 3], 8.0, 90.0),
        scene(0.95, Rain, [0.0; 3], 2.0, 60.0),
        scene(0.5, Rain, [0.0, 0.2, 0.1], 0.85, 60.0),
    ]
}

fn guide(guides: &[Guide], landmark: Landmark) -> &Guide {
    guides
        .iter()
        .find(|guide| guide.landmark == landmark)
        .unwrap()
}

/// The direction turned away from the middle of the curve by an angle in radians.
fn moved(curve: &[DVec3], point: DVec3, angle: f64) -> DVec3 {
    let middle = curve.iter().sum::<DVec3>().normalize();
    let away = (point - middle).reject_from_normalized(point).normalize();
    point * angle.cos() + away * angle.sin()
}

#[test]
fn the_edge_of_the_shadow_has_the_radius_of_synge_for_an_observer_at_rest() {
    for r in [1.05, 1.5, 2.0, 6.0, 20.0, 1000.0] {
        let scene = scene(0.0, ObserverKind::Static, [0.0; 3], r, 70.0);
        let guides = quick_guides(&scene).unwrap();
        let [edge] = &guide(&guides, Landmark::ShadowEdge).curves[..] else {
            panic!("one curve")
        };
        for point in edge {
            // Rounding, which the boost from a falling observer amplifies near the horizon.
            let found = angle_between(*point, DVec3::NEG_X);
            assert_close(r, found, shadow_half_angle_static(r), 1e-12);
        }
    }
}

#[test]
fn rays_inside_the_edge_of_the_shadow_end_at_the_hole_and_rays_outside_do_not() {
    for scene in scenes() {
        let reference = Reference::new(&scene).unwrap();
        let guides = quick_guides(&scene).unwrap();
        let edge = &guide(&guides, Landmark::ShadowEdge).curves[0];
        let dark_middle = reference.trace(edge.iter().sum::<DVec3>()).outcome == Outcome::Captured;
        for point in edge.iter().step_by(7) {
            // 1e-7 rad is far above rounding and far below what a picture can show.
            for (angle, inside) in [(-1e-7, true), (1e-7, false)] {
                let outcome = reference.trace(moved(edge, *point, angle)).outcome;
                let captured = outcome == Outcome::Captured;
                assert_eq!(
                    captured,
                    inside == dark_middle,
                    "{point} {angle} {:?}",
                    scene.camera
                );
            }
        }
    }
}

#[test]
fn the_images_of_the_innermost_stable_orbit_are_where_its_light_arrives() {
    for scene in scenes() {
        let kerr = Kerr {
            spin: scene.hole.spin,
        };
        let radius = kerr.isco();
        // From within the plane, a guide shows the orbit as from a small height.
        if scene.camera.theta_deg == 90.0 {
            continue;
        }
        let guides = traced_guides(&scene).unwrap();
        let reference = Reference::new(&scene).unwrap();
        let (r, n) = reference.camera();
        let ring = HoleAndDisk {
            kerr,
            annulus: Some([0.999 * radius, 1.001 * radius]),
        };
        for landmark in [Landmark::StableOrbit, Landmark::StableOrbitAgain] {
            let curve = &guide(&guides, landmark).curves[0];
            assert!(curve.len() >= 64, "{landmark:?}: {} points", curve.len());
            for point in curve {
                let photon = reference.photon(*point);
                let (constants, start) = PhotonConstants::of_photon(kerr, &photon, r, n);
                let hits = ring.trace(&constants, start).hits;
                let near = |hit: &Hit| (hit.r - radius).abs() < 1e-6 * radius;
                assert!(
                    hits.iter().flatten().any(near),
                    "{landmark:?}: {hits:?} for {radius}, {:?}",
                    scene.camera
                );
            }
        }
    }
}

#[test]
fn the_images_of_an_orbit_seen_from_the_axis_are_circles_around_the_shadow() {
    let scene = scene(0.0, ObserverKind::Static, [0.0; 3], 30.0, 0.0);
    let traced = traced_guides(&scene).unwrap();
    let radius = |landmark| {
        let curve = &guide(&traced, landmark).curves[0];
        let angles = || {
            curve
                .iter()
                .map(|point| angle_between(*point, DVec3::NEG_X))
        };
        let [least, most] = [angles().fold(9.0, f64::min), angles().fold(0.0, f64::max)];
        assert_close("a circle", least, most, 1e-8);
        least
    };
    let shadow = shadow_half_angle_static(30.0);
    let (first, second) = (
        radius(Landmark::StableOrbit),
        radius(Landmark::StableOrbitAgain),
    );
    assert!(shadow < second && second < 1.1 * shadow && second < first);
    // In flat space the orbit has this radius; bending makes it larger.
    assert!((0.1..0.2).contains(&(first / (3.0_f64 / 30.0).atan() - 1.0)));
}

#[test]
fn a_scale_bar_has_the_angle_of_flat_space_and_aberration_shrinks_it() {
    let angle = |velocity, r| {
        let scene = scene(0.0, ObserverKind::Static, velocity, r, 70.0);
        let [left, right] = bar_across_hole(&scene, 2.0).unwrap();
        angle_between(left, right)
    };
    assert_close(
        "at rest",
        angle([0.0; 3], 50.0),
        2.0 * (1.0_f64 / 50.0).atan(),
        1e-12,
    );
    // Toward the hole at 0.6 c: tan(a/2) shrinks by sqrt((1 - v) / (1 + v)) = 1/2.
    let half = (1.0_f64 / 50.0).atan() / 2.0;
    assert_close(
        "moving",
        angle([-0.6, 0.0, 0.0], 50.0),
        4.0 * (half.tan() / 2.0).atan(),
        1e-12,
    );
}

#[test]
fn the_ergosphere_shows_beside_the_shadow_only_where_light_turns_with_the_hole() {
    let scene = scene(0.9, ObserverKind::Static, [0.0; 3], 20.0, 85.0);
    let edge = &guide(&quick_guides(&scene).unwrap(), Landmark::ShadowEdge).curves[0].clone();
    let ergosphere =
        &guide(&traced_guides(&scene).unwrap(), Landmark::Ergosphere).curves[0].clone();
    // Light that comes from the left has angular momentum along the spin. Its outermost orbit
    // there, at 0.78 r_s, is inside the ergosphere, whose equator is at 1 r_s.
    let leftmost = |curve: &[DVec3]| curve.iter().map(|point| point.z).fold(0.0, f64::min);
    let rightmost = |curve: &[DVec3]| curve.iter().map(|point| point.z).fold(0.0, f64::max);
    assert!(
        leftmost(ergosphere) < 1.02 * leftmost(edge),
        "{} {}",
        leftmost(ergosphere),
        leftmost(edge)
    );
    assert_close("right", rightmost(ergosphere), rightmost(edge), 1e-3);
    // A ray of the guide that is not captured passes the static limit closely.
    let kerr = Kerr { spin: 0.9 };
    let reference = Reference::new(&scene).unwrap();
    let mut checked = 0;
    for point in ergosphere {
        let outside = moved(ergosphere, *point, 1e-6);
        let (trace, path) = Path::of(&reference, outside, 40.0);
        let depth = |place: &DVec3| place.length() / kerr.static_limit(place.z / place.length());
        let closest = path.points.iter().map(depth).fold(f64::INFINITY, f64::min);
        assert_eq!(trace.outcome, Outcome::Sky);
        if closest < 1.01 {
            // The path's points are up to 1/24 rad apart.
            assert!(closest > 1.0 - 1e-3, "{closest}");
            checked += 1;
        }
    }
    assert!(checked > 10, "{checked} points");
}

#[test]
fn without_lensing_every_guide_is_flat_and_the_horizon_is_the_edge_of_the_dark() {
    for spin in [0.0, 0.9] {
        let mut scene = scene(spin, ObserverKind::Static, [0.1, 0.3, -0.2], 8.0, 60.0);
        scene.effects.lensing = false;
        assert!(traced_guides(&scene).unwrap().is_empty());
        let guides = quick_guides(&scene).unwrap();
        assert!(guides.iter().all(|guide| guide.flat));
        let reference = Reference::new(&scene).unwrap();
        let horizon = &guide(&guides, Landmark::Horizon).curves[0];
        for point in horizon {
            for (angle, captured) in [(-1e-7, true), (1e-7, false)] {
                let outcome = reference.trace(moved(horizon, *point, angle)).outcome;
                assert_eq!(outcome == Outcome::Captured, captured);
            }
        }
        assert_eq!(
            guides
                .iter()
                .any(|guide| guide.landmark == Landmark::Ergosphere),
            spin != 0.0
        );
    }
}

#[test]
fn every_scene_of_extreme_numbers_has_guides_without_panic_and_of_unit_directions() {
    for spin in [0.0, 1e-5, -0.999_99] {
        let horizon = Kerr { spin }.horizon();
        for r in [horizon, 1.000_001 * horizon, 1.4, 1e5] {
            for theta in [0.0, 1e-9, 90.0] {
                let scene = scene(spin, ObserverKind::Rain, [0.0; 3], r, theta);
                let (Ok(quick), Ok(traced)) = (quick_guides(&scene), traced_guides(&scene)) else {
                    panic!("the observer exists");
                };
                for point in quick
                    .iter()
                    .chain(&traced)
                    .flat_map(|guide| guide.curves.concat())
                {
                    assert_close(format!("{spin} {r} {theta}"), point.length(), 1.0, 1e-9);
                }
            }
        }
    }
}
