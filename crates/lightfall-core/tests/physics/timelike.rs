//! Free motion against closed forms, quadratures and the metric.

use crate::assert_close;
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::geometry::timelike::{Geodesic, Limit};
use lightfall_core::optics::worldline::Worldline;
use lightfall_core::scene::{ObserverKind, Scene};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The tolerance for times and periods. The measured errors are rounding errors of about 1e-13.
const TOLERANCE: f64 = 1e-9;

pub(crate) fn scene(
    spin: f64,
    kind: ObserverKind,
    velocity: [f64; 3],
    r: f64,
    theta_deg: f64,
) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.phi_deg) = (r, theta_deg, 25.0);
    (scene.observer.kind, scene.observer.velocity) = (kind, velocity);
    scene
}

fn place(scene: &Scene) -> DVec3 {
    scene.camera.r * scene.camera.direction()
}

/// The geodesic of the scene's observer.
fn geodesic(scene: &Scene) -> Geodesic {
    Worldline::start(scene)
        .unwrap()
        .geodesic()
        .copied()
        .unwrap()
}

#[test]
fn a_circular_orbit_has_keplers_period_and_the_published_proper_time() {
    for spin in [-0.9, 0.0, 0.5, 0.998] {
        let isco = Kerr { spin }.isco();
        for r in [1.001 * isco, 2.0 * isco, 50.0] {
            // Bardeen, Press & Teukolsky 1972 eq. 2.16 in units of M = 1/2: T = 2 pi M (x^3 + chi),
            // x = sqrt(r/M); and dtau/dt = sqrt(1 - 3/x^2 + 2 chi/x^3) / (1 + chi/x^3).
            let x = (2.0 * r).sqrt();
            let far = PI * (x.powi(3) + spin);
            let own = far * (1.0 - 3.0 / (x * x) + 2.0 * spin / x.powi(3)).sqrt()
                / (1.0 + spin / x.powi(3));
            let mut scene = scene(spin, ObserverKind::Orbit, [0.0; 3], r, 90.0);
            let start = place(&scene);
            let mut worldline = Worldline::start(&scene).unwrap();
            assert!(worldline.is_circular());
            assert_eq!(worldline.advance(own, &mut scene), None);
            assert_close(
                "far time",
                worldline.coordinate_time().unwrap(),
                far,
                TOLERANCE,
            );
            assert!(
                (place(&scene) - start).length() < TOLERANCE,
                "spin {spin}, r {r}"
            );
        }
    }
}

#[test]
fn a_circular_orbit_is_closed_after_a_hundred_turns_in_steps_of_a_frame() {
    for (spin, r) in [(0.0, 1.6), (0.0, 3.0), (0.9, 2.0), (-0.9, 20.0)] {
        let orbit = Kerr { spin }.circular_orbit(r).unwrap();
        let period = TAU / (orbit.angular_velocity * orbit.u_t);
        let mut scene = scene(spin, ObserverKind::Orbit, [0.0; 3], r, 90.0);
        let start = scene.clone();
        let mut worldline = Worldline::start(&scene).unwrap();
        for _ in 0..100 * 64 {
            worldline.advance(period / 64.0, &mut scene);
        }
        assert!((place(&scene) - place(&start)).length() < 1e-9);
        scene.camera.phi_deg = start.camera.phi_deg;
        assert_eq!(scene, start, "nothing but the azimuth changes");
    }
}

/// The same orbit for a particle with the right speed relative to the observer at rest, v^2 = 1/(2
/// (r - 1)). The orbit is stable, so rounding errors do not grow.
#[test]
fn a_particle_with_orbital_speed_stays_on_the_circular_orbit_for_a_hundred_turns() {
    let r: f64 = 10.0;
    let speed = (0.5 / (r - 1.0)).sqrt();
    let mut scene = scene(
        0.0,
        ObserverKind::Static,
        [0.0, 0.6 * speed, -0.8 * speed],
        r,
        90.0,
    );
    let mut worldline = Worldline::start(&scene).unwrap();
    let start = place(&scene);
    let far = TAU * (2.0 * r.powi(3)).sqrt();
    let own = far * (1.0 - 1.5 / r).sqrt();
    for _ in 0..100 * 16 {
        assert_eq!(worldline.advance(own / 16.0, &mut scene), None);
    }
    assert!(
        (place(&scene) - start).length() < 1e-9,
        "{:e}",
        (place(&scene) - start).length()
    );
    assert_close(
        "far time",
        worldline.coordinate_time().unwrap(),
        100.0 * far,
        TOLERANCE,
    );
}

#[test]
fn the_fall_from_rest_at_infinity_takes_the_proper_time_of_the_closed_form() {
    // tau = (2/3) (r_0^(3/2) - r^(3/2)); Misner, Thorne & Wheeler 1973 eq. 25.38 for r_s = 1.
    let mut fall = geodesic(&scene(0.0, ObserverKind::Rain, [0.0; 3], 10.0, 70.0));
    assert_eq!(fall.advance(1e3, [1.0, 1e7]), Some(Limit::Inner));
    assert_close(
        "to the horizon",
        fall.state.proper_time,
        (10.0_f64.powf(1.5) - 1.0) / 1.5,
        TOLERANCE,
    );
    // As near to the centre as wanted: the remaining time is (2/3) r^(3/2).
    assert_eq!(fall.advance(1e3, [1e-8, 1e7]), Some(Limit::Inner));
    assert_close(
        "to the centre",
        fall.state.proper_time,
        10.0_f64.powf(1.5) / 1.5,
        TOLERANCE,
    );

    // In a scene, frame by frame, down to the smallest radius of motion.
    let mut scene = scene(0.0, ObserverKind::Rain, [0.0; 3], 10.0, 70.0);
    let mut worldline = Worldline::start(&scene).unwrap();
    let still = scene.camera;
    for frame in 1.. {
        let limit = worldline.advance(0.01, &mut scene);
        let own_time = worldline.proper_time();
        assert_close(
            "r",
            scene.camera.r,
            (10.0_f64.powf(1.5) - 1.5 * own_time).powf(2.0 / 3.0),
            TOLERANCE,
        );
        assert_eq!(worldline.coordinate_time().is_some(), scene.camera.r > 1.0);
        assert_eq!(
            (scene.observer.kind, scene.observer.velocity),
            (ObserverKind::Rain, [0.0; 3])
        );
        if limit.is_some() {
            assert_eq!(limit, Some(Limit::Inner));
            assert_close("the end", scene.camera.r, 0.1, 1e-14);
            break;
        }
        assert_close("own time", own_time, 0.01 * f64::from(frame), TOLERANCE);
    }
    assert!((scene.camera.theta_deg - still.theta_deg).abs() < 1e-12);
    assert!((scene.camera.phi_deg - still.phi_deg).abs() < 1e-12);
    assert_eq!(
        [
            scene.camera.yaw_deg,
            scene.camera.pitch_deg,
            scene.camera.roll_deg
        ],
        [0.0; 3]
    );
}

#[test]
fn a_drop_from_rest_follows_the_cycloid_on_both_clocks() {
    // Misner, Thorne & Wheeler 1973 eqs. 31.10, 31.12 for r_s = 1: r = (R/2)(1 + cos eta), tau =
    // sqrt(R^3)/2 (eta + sin eta).
    let from: f64 = 8.0;
    let root = (from - 1.0).sqrt();
    for eta in [0.1_f64, 0.8, 1.7, 2.2] {
        let r = 0.5 * from * (1.0 + eta.cos());
        let own = 0.5 * from.powf(1.5) * (eta + eta.sin());
        let tan = (0.5 * eta).tan();
        let far =
            ((root + tan) / (root - tan)).ln() + root * (eta + 0.5 * from * (eta + eta.sin()));
        let mut scene = scene(0.0, ObserverKind::Static, [0.0; 3], from, 33.0);
        let mut worldline = Worldline::start(&scene).unwrap();
        assert_eq!(worldline.advance(own, &mut scene), None);
        assert_close("r", scene.camera.r, r, TOLERANCE);
        assert_close(
            "far time",
            worldline.coordinate_time().unwrap(),
            far,
            TOLERANCE,
        );
    }
}

/// Sigma dr/dtau = -sqrt(r (r^2 + a^2)) for `rain`, and the derivatives of v and of the ingoing
/// azimuth with respect to r are regular. They are integrated with Simpson's rule in x = sqrt(r),
/// where they are smooth.
#[test]
fn rain_falls_through_the_horizon_of_a_spinning_hole_in_the_times_of_quadratures() {
    for (spin, theta_deg) in [(0.9, 90.0), (-0.9, 50.0), (0.5, 0.0), (0.998, 120.0)] {
        let kerr = Kerr { spin };
        let (a, cos) = (spin / 2.0, f64::to_radians(theta_deg).cos());
        let (from, to) = (5.0_f64, min_infall_radius(kerr));
        let integral = |rate: &dyn Fn(f64) -> f64| -> f64 {
            let steps = 2000;
            let h = (from.sqrt() - to.sqrt()) / f64::from(steps);
            let weight = |i: i32| {
                if i == 0 || i == steps {
                    1.0
                } else {
                    2.0 + 2.0 * f64::from(i % 2)
                }
            };
            (0..=steps)
                .map(|i| {
                    let x = to.sqrt() + h * f64::from(i);
                    weight(i) * h / 3.0 * 2.0 * x * rate(x * x)
                })
                .sum()
        };
        let fall = |r: f64| (r * (r * r + a * a)).sqrt();
        let mut particle = geodesic(&scene(spin, ObserverKind::Rain, [0.0; 3], from, theta_deg));
        let chi = particle.state.chi;
        assert_eq!(particle.advance(1e3, [to, 1e7]), Some(Limit::Inner));
        let own = integral(&|r| kerr.sigma(r, cos) / fall(r));
        assert_close(
            format!("own time, spin {spin}"),
            particle.state.proper_time,
            own,
            TOLERANCE,
        );
        // F = (W r^2 - fall) / Delta with W r^2 = r^2 + a^2 = fall^2/r, so F = (1 + a^2 u^2) / (1 +
        // a^2 u^2 + fall u^2).
        let f = |r: f64| (r * r + a * a) / (r * r + a * a + fall(r));
        let ingoing =
            integral(&|r| ((r * r + a * a) * f(r) - (a * a) * (1.0 - cos * cos)) / fall(r));
        assert_close(
            format!("ingoing time, spin {spin}"),
            particle.state.ingoing_time,
            ingoing,
            TOLERANCE,
        );
        let turned = integral(&|r| a * (f(r) - 1.0) / fall(r));
        assert_close(
            format!("azimuth, spin {spin}"),
            particle.state.chi - chi,
            turned,
            TOLERANCE,
        );
    }
}

#[test]
fn observers_that_do_not_exist_cannot_be_released() {
    assert!(Worldline::start(&scene(0.0, ObserverKind::Static, [0.0; 3], 0.9, 90.0)).is_err());
    assert!(Worldline::start(&scene(0.0, ObserverKind::Orbit, [0.0; 3], 5.0, 80.0)).is_err());
    let kerr = Kerr { spin: 0.8 };
    assert!(
        min_infall_radius(kerr) > kerr.inner_horizon() && min_infall_radius(kerr) < kerr.horizon()
    );
    let mut away = geodesic(&scene(
        0.0,
        ObserverKind::Static,
        [0.9, 0.0, 0.0],
        1e6,
        FRAC_PI_2.to_degrees(),
    ));
    assert_eq!(away.advance(1e9, [0.1, 1e7]), Some(Limit::Outer));
    assert_close("r", 1.0 / away.state.u, 1e7, 1e-12);
}
