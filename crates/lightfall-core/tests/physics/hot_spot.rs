//! The hot spot: where it is, how it is sheared, and that the light that it spreads is conserved.

use crate::assert_close;
use crate::hot_spot_flux::HotSpotFlux;
use lightfall_core::optics::hot_spot::HotSpot;
use lightfall_core::scene::{HotSpotKind, Scene};
use std::f64::consts::{PI, TAU};

fn scene(kind: HotSpotKind) -> Scene {
    let mut scene = Scene::default();
    (
        scene.hot_spot.kind,
        scene.hot_spot.r,
        scene.hot_spot.phi_deg,
    ) = (kind, 4.5, 70.0);
    scene
}

fn spot(scene: &Scene) -> HotSpotFlux {
    HotSpotFlux::new(scene)
}

/// The factor's mean along the orbit of radius r.
fn mean(spot: &HotSpotFlux, r: f64, t: f64) -> f64 {
    let sum: f64 = (0..4000)
        .map(|i| spot.factor(r, TAU * f64::from(i) / 4000.0, t))
        .sum();
    sum / 4000.0
}

#[test]
fn hot_spot_goes_around_in_the_period_of_its_orbit() {
    // GRAVITY Collaboration 2018: an orbit of 9 GM/c^2 around Sgr A* of 4.14e6 suns. 2 pi r^(3/2) /
    // sqrt(M) in r_s/c, which are 40.78 s.
    let spot = spot(&scene(HotSpotKind::Rigid));
    assert_close("period", spot.period(), 84.82, 1e-4);
    assert_close("minutes", spot.period() * 40.78 / 60.0, 57.7, 1e-3);
    for t in [0.0, 10.0, 1e7] {
        let (now, later) = (spot.azimuth(t), spot.azimuth(t + spot.period()));
        assert!((now - later).abs() < 1e-8, "{now} {later}");
        assert_close(
            "its middle",
            spot.factor(4.5, spot.azimuth(t), t),
            9.0,
            1e-9,
        );
    }
    assert_eq!(HotSpot::new(&scene(HotSpotKind::None)), None);
}

#[test]
fn hot_spot_that_is_rigid_has_the_same_shape_at_every_time() {
    let spot = spot(&scene(HotSpotKind::Rigid));
    let w: f64 = 0.08;
    for t in [-300.0, 0.0, 57.0, 1e6] {
        for (x, psi) in [(0.0, 0.1), (0.05, -0.08), (-0.1, 0.0)] {
            let expected = 1.0 + 8.0 * (-(x * x + psi * psi) / (2.0 * w * w)).exp();
            let found = spot.factor(4.5 * f64::exp(x), spot.azimuth(t) + psi, t);
            assert_close(format!("{t} {x} {psi}"), found, expected, 1e-8);
        }
    }
}

#[test]
fn hot_spot_that_is_sheared_begins_as_the_rigid_one_and_ends_as_a_ring() {
    let (rigid, sheared) = (
        spot(&scene(HotSpotKind::Rigid)),
        spot(&scene(HotSpotKind::Sheared)),
    );
    for (r, phi) in [(4.5, 1.2), (4.9, 1.3), (4.2, 0.9)] {
        assert_close(
            "at first",
            sheared.factor(r, phi, 0.0),
            rigid.factor(r, phi, 0.0),
            1e-9,
        );
    }
    // Half an orbit later what was in line is in line with the local rate: an arc.
    let half = 0.5 * sheared.period();
    let trailing = sheared.angular_velocity() * (1.05_f64.powf(-1.5) - 1.0) * half;
    let on_arc = sheared.factor(4.5 * 1.05, sheared.azimuth(half) + trailing, half);
    let off_arc = sheared.factor(4.5 * 1.05, sheared.azimuth(half) - trailing, half);
    assert!(on_arc > 4.0 && off_arc < 1.3, "{on_arc} {off_arc}");
    // What one orbit receives stays what it was, at any time.
    for r in [4.5, 4.8] {
        let at_first = mean(&rigid, r, 0.0);
        for t in [-50.0, 10.0, 84.8, 400.0, 1e4, 1e9] {
            assert_close(format!("{r} {t}"), mean(&sheared, r, t), at_first, 1e-9);
        }
        for phi in [-PI, 0.3, 2.0] {
            assert_close("ring", sheared.factor(r, phi, 1e4), at_first, 1e-9);
        }
    }
}

#[test]
fn hot_spot_with_a_duration_flares_and_fades() {
    let mut scene = scene(HotSpotKind::Rigid);
    (scene.hot_spot.duration, scene.hot_spot.time) = (20.0, 1e8);
    let spot = spot(&scene);
    let excess = |t: f64| spot.factor(4.5, spot.azimuth(t), t) - 1.0;
    assert_close("at its time", excess(1e8), 8.0, 1e-9);
    assert_close(
        "one deviation later",
        excess(1e8 + 20.0),
        8.0 * (-0.5_f64).exp(),
        1e-7,
    );
    assert_eq!(excess(1e8 + 1000.0), 0.0);
}
