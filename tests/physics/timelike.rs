//! Real motion against closed forms, quadratures and the metric.

use crate::assert_close;
use glam::DVec3;
use lightfall::{
    physics::{
        kerr::Kerr,
        observer::observer_matrix,
        shift::RestFrame,
        sight::Sight,
        timelike::{Geodesic, Limit, Worldline, frame::four_velocity, innermost},
    },
    scene::{ObserverKind, Scene},
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The bar for times and periods; what is measured here is rounding, some 1e-13.
const BAR: f64 = 1e-9;

fn scene(spin: f64, kind: ObserverKind, velocity: [f64; 3], r: f64, theta_deg: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.phi_deg) = (r, theta_deg, 25.0);
    (scene.observer.kind, scene.observer.velocity) = (kind, velocity);
    scene
}

/// Places and motions all over: with spin, over poles, bound and unbound, next to the hole.
fn thrown() -> Vec<Scene> {
    let mut all = Vec::new();
    for spin in [-0.998, -0.5, 0.0, 0.7, 0.9999] {
        for (r, theta_deg) in [(1.6, 90.0), (2.5, 40.0), (6.0, 75.0), (30.0, 0.0), (30.0, 179.0), (1e4, 10.0)] {
            for velocity in [[0.0; 3], [-0.1, 0.2, 0.3], [0.5, 0.0, -0.6], [0.0, -0.4, 0.0]] {
                for kind in [ObserverKind::Static, ObserverKind::Zamo, ObserverKind::Rain] {
                    all.push(scene(spin, kind, velocity, r, theta_deg));
                }
            }
        }
    }
    all
}

fn place(scene: &Scene) -> DVec3 {
    scene.camera.r * scene.camera.direction()
}

/// A start for [`Geodesic`] alone.
fn geodesic(scene: &Scene) -> Geodesic {
    Worldline::start(scene).unwrap().geodesic().copied().unwrap()
}

#[test]
fn a_circular_orbit_has_keplers_period_and_its_own_time() {
    for spin in [-0.9, 0.0, 0.5, 0.998] {
        let isco = Kerr { spin }.isco();
        for r in [1.001 * isco, 2.0 * isco, 50.0] {
            // Bardeen, Press & Teukolsky 1972 eq. 2.16 in units of M = 1/2: T = 2 pi M (x^3 + chi), x = sqrt(r/M); and
            // dtau/dt = sqrt(1 - 3/x^2 + 2 chi/x^3) / (1 + chi/x^3).
            let x = (2.0 * r).sqrt();
            let far = PI * (x.powi(3) + spin);
            let own = far * (1.0 - 3.0 / (x * x) + 2.0 * spin / x.powi(3)).sqrt() / (1.0 + spin / x.powi(3));
            let mut scene = scene(spin, ObserverKind::Orbit, [0.0; 3], r, 90.0);
            let start = place(&scene);
            let mut worldline = Worldline::start(&scene).unwrap();
            assert!(worldline.circles());
            assert_eq!(worldline.advance(own, &mut scene), None);
            assert_close("far time", worldline.far_time().unwrap(), far, BAR);
            assert!((place(&scene) - start).length() < BAR, "spin {spin}, r {r}");
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

/// The same orbit as a particle thrown from rest with the right speed, v^2 = 1/(2 (r - 1)) for an observer at rest: stable, so
/// that rounding does not grow.
#[test]
fn a_particle_thrown_into_a_circular_orbit_stays_on_it_for_a_hundred_turns() {
    let r: f64 = 10.0;
    let speed = (0.5 / (r - 1.0)).sqrt();
    let mut scene = scene(0.0, ObserverKind::Static, [0.0, 0.6 * speed, -0.8 * speed], r, 90.0);
    let mut worldline = Worldline::start(&scene).unwrap();
    let start = place(&scene);
    let far = TAU * (2.0 * r.powi(3)).sqrt();
    let own = far * (1.0 - 1.5 / r).sqrt();
    for _ in 0..100 * 16 {
        assert_eq!(worldline.advance(own / 16.0, &mut scene), None);
    }
    assert!((place(&scene) - start).length() < 1e-9, "{:e}", (place(&scene) - start).length());
    assert_close("far time", worldline.far_time().unwrap(), 100.0 * far, BAR);
}

#[test]
fn the_fall_from_rest_at_infinity_takes_the_time_it_takes() {
    // tau = (2/3) (r_0^(3/2) - r^(3/2)); Misner, Thorne & Wheeler 1973 eq. 25.38 for r_s = 1.
    let mut fall = geodesic(&scene(0.0, ObserverKind::Rain, [0.0; 3], 10.0, 70.0));
    assert_eq!(fall.advance(1e3, [1.0, 1e7]), Some(Limit::Inner));
    assert_close("to the horizon", fall.state.own_time, (10.0_f64.powf(1.5) - 1.0) / 1.5, BAR);
    // As near to the centre as no matter, for there the time left is (2/3) r^(3/2).
    assert_eq!(fall.advance(1e3, [1e-8, 1e7]), Some(Limit::Inner));
    assert_close("to the centre", fall.state.own_time, 10.0_f64.powf(1.5) / 1.5, BAR);

    // In a scene, by frames, down to where motion ends.
    let mut scene = scene(0.0, ObserverKind::Rain, [0.0; 3], 10.0, 70.0);
    let mut worldline = Worldline::start(&scene).unwrap();
    let still = scene.camera;
    for frame in 1.. {
        let limit = worldline.advance(0.01, &mut scene);
        let own_time = worldline.own_time();
        assert_close("r", scene.camera.r, (10.0_f64.powf(1.5) - 1.5 * own_time).powf(2.0 / 3.0), BAR);
        assert_eq!(worldline.far_time().is_some(), scene.camera.r > 1.0);
        assert_eq!((scene.observer.kind, scene.observer.velocity), (ObserverKind::Rain, [0.0; 3]));
        if limit.is_some() {
            assert_eq!(limit, Some(Limit::Inner));
            assert_close("the end", scene.camera.r, 0.1, 1e-14);
            break;
        }
        assert_close("own time", own_time, 0.01 * f64::from(frame), BAR);
    }
    assert!((scene.camera.theta_deg - still.theta_deg).abs() < 1e-12);
    assert!((scene.camera.phi_deg - still.phi_deg).abs() < 1e-12);
    assert_eq!([scene.camera.yaw_deg, scene.camera.pitch_deg, scene.camera.roll_deg], [0.0; 3]);
}

#[test]
fn a_drop_from_rest_follows_the_cycloid_on_both_clocks() {
    // Misner, Thorne & Wheeler 1973 eqs. 31.10, 31.12 for r_s = 1: r = (R/2)(1 + cos eta), tau = sqrt(R^3)/2 (eta + sin eta).
    let from: f64 = 8.0;
    let root = (from - 1.0).sqrt();
    for eta in [0.1_f64, 0.8, 1.7, 2.2] {
        let r = 0.5 * from * (1.0 + eta.cos());
        let own = 0.5 * from.powf(1.5) * (eta + eta.sin());
        let tan = (0.5 * eta).tan();
        let far = ((root + tan) / (root - tan)).ln() + root * (eta + 0.5 * from * (eta + eta.sin()));
        let mut scene = scene(0.0, ObserverKind::Static, [0.0; 3], from, 33.0);
        let mut worldline = Worldline::start(&scene).unwrap();
        assert_eq!(worldline.advance(own, &mut scene), None);
        assert_close("r", scene.camera.r, r, BAR);
        assert_close("far time", worldline.far_time().unwrap(), far, BAR);
    }
}

/// Sigma dr/dtau = -sqrt(r (r^2 + a^2)) for `rain`; and v' and the ingoing azimuth's rate by r are regular: integrated with
/// Simpson's rule in x = sqrt(r), where all is smooth.
#[test]
fn a_spinning_holes_rain_falls_through_the_horizon_as_quadratures_say() {
    for (spin, theta_deg) in [(0.9, 90.0), (-0.9, 50.0), (0.5, 0.0), (0.998, 120.0)] {
        let kerr = Kerr { spin };
        let (a, cos) = (spin / 2.0, f64::to_radians(theta_deg).cos());
        let (from, to) = (5.0_f64, innermost(kerr));
        let integral = |rate: &dyn Fn(f64) -> f64| -> f64 {
            let steps = 2000;
            let h = (from.sqrt() - to.sqrt()) / f64::from(steps);
            let weight = |i: i32| if i == 0 || i == steps { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
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
        assert_close(format!("own time, spin {spin}"), particle.state.own_time, own, BAR);
        // F = (W r^2 - fall) / Delta with W r^2 = r^2 + a^2 = fall^2/r, so F = (1 + a^2 u^2) / (1 + a^2 u^2 + fall u^2).
        let f = |r: f64| (r * r + a * a) / (r * r + a * a + fall(r));
        let ingoing = integral(&|r| ((r * r + a * a) * f(r) - (a * a) * (1.0 - cos * cos)) / fall(r));
        assert_close(format!("ingoing time, spin {spin}"), particle.state.ingoing_time, ingoing, BAR);
        let turned = integral(&|r| a * (f(r) - 1.0) / fall(r));
        assert_close(format!("azimuth, spin {spin}"), particle.state.chi - chi, turned, BAR);
    }
}

#[test]
fn what_is_thrown_keeps_its_constants_and_the_scene_has_its_four_velocity() {
    let (mut inside, mut outer) = (0, 0);
    for mut scene in thrown() {
        let Ok(mut worldline) = Worldline::start(&scene) else { continue };
        let shown = format!("{:?} {:?} spin {}", scene.camera, scene.observer, scene.hole.spin);
        let kerr = Kerr { spin: scene.hole.spin };
        let step = 0.03 * scene.camera.r.powf(1.5);
        for _ in 0..60 {
            let limit = worldline.advance(step, &mut scene);
            assert_ne!(limit, Some(Limit::Lost), "{shown}");
            outer += u32::from(limit == Some(Limit::Outer));
            inside += u32::from(scene.camera.r < kerr.horizon());
            let particle = worldline.geodesic().unwrap();
            assert!(particle.residual() < 1e-10, "{shown}: {:e}", particle.residual());
            // What the picture's observer is: her matrix's first column.
            let (theta, phi) = (scene.camera.theta_deg.to_radians(), scene.camera.phi_deg.to_radians());
            let rain = ObserverKind::Rain;
            assert_eq!(scene.observer.kind, rain);
            let matrix = observer_matrix(kerr.spin, rain, scene.observer.velocity, scene.camera.r, theta, phi).unwrap();
            let (found, expected) = (four_velocity(&matrix), particle.velocity());
            // Rounding grows with the speed for rain, whose gamma reaches some tens inside.
            assert_close(format!("E, {shown}"), found.energy, expected.energy, 1e-8);
            assert!((found.radial - expected.radial).abs() < 1e-8 * expected.radial.abs().max(1.0), "{shown}");
            assert!((found.w.length() - expected.w.length()).abs() < 1e-8 * expected.w.length().max(1.0), "{shown}");
            let [l, expected] = [scene.camera.r * scene.camera.direction().cross(found.w).z, particle.angular_momentum];
            assert!((l - expected).abs() < 1e-8 * expected.abs().max(1.0), "L, {shown}");
            if limit.is_some() {
                break;
            }
        }
    }
    assert!(inside > 500, "{inside} places inside the horizon");
    assert_eq!(outer, 0);
}

/// The rates of r, theta, phi and t by own time are the four-velocity's contravariant components, by the inverse metric
/// (Bardeen, Press & Teukolsky 1972 eq. 2.10): central differences, good to 1e-6 of the rate.
#[test]
fn places_and_far_time_grow_as_the_metric_says() {
    let mut compared = 0;
    for scene in thrown().into_iter().filter(|scene| scene.camera.r < 100.0) {
        let Ok(worldline) = Worldline::start(&scene) else { continue };
        let kerr = Kerr { spin: scene.hole.spin };
        let h = 1e-5 * scene.camera.r;
        let at = |own_time: f64| {
            let (mut worldline, mut scene) = (worldline.clone(), scene.clone());
            let limit = worldline.advance(own_time, &mut scene);
            (limit, scene, worldline)
        };
        for time in [0.0, 0.5, 2.0, 9.0].map(|time| time * scene.camera.r.sqrt() + h) {
            let [(before, a, earlier), (_, here, middle), (after, b, later)] = [time - h, time, time + h].map(at);
            if before.or(after).is_some() || b.camera.r < 1.02 * kerr.horizon() {
                break;
            }
            let cos = here.camera.direction().z;
            let sin2 = 1.0 - cos * cos;
            if sin2 < 1e-3 {
                continue;
            }
            let (r, particle) = (here.camera.r, middle.geodesic().unwrap());
            let RestFrame { lapse, dragging, width } = RestFrame::at(kerr, r, cos);
            let time_rate = (particle.energy - dragging * particle.angular_momentum) / (lapse * lapse);
            let phi_rate = dragging * time_rate + particle.angular_momentum / (width * width * sin2);
            let r_rate = r * r * particle.velocity().radial / kerr.sigma(r, cos);
            let rate = |first: f64, second: f64| (second - first) / (2.0 * h);
            let close = |what: &str, found: f64, expected: f64| {
                let scale = expected.abs().max(0.01);
                assert!((found - expected).abs() < 1e-6 * scale, "{what}: {found} {expected}, {scene:?} at {time}");
            };
            close("t", rate(earlier.far_time().unwrap(), later.far_time().unwrap()), time_rate);
            close("r", rate(a.camera.r, b.camera.r), r_rate);
            let swept = (b.camera.phi_deg - a.camera.phi_deg).to_radians();
            close("phi", (swept - TAU * (swept / TAU).round()) / (2.0 * h), phi_rate);
            compared += 1;
        }
    }
    assert!(compared > 300, "{compared}");
}

/// The picture: the photon that every pixel stands for is the same before and just after letting go, although the observer's
/// kind, and with it the legs, are others.
#[test]
fn letting_go_does_not_move_the_picture() {
    for mut before in thrown() {
        (before.camera.yaw_deg, before.camera.pitch_deg, before.camera.roll_deg) = (20.0, -35.0, 10.0);
        let Ok(mut worldline) = Worldline::start(&before) else { continue };
        let mut after = before.clone();
        worldline.advance(0.0, &mut after);
        let [(sight, legs), (other, turned)] =
            [&before, &after].map(|scene| (Sight::new(scene).unwrap(), scene.camera.legs_from_camera()));
        for pixel in [DVec3::Z, DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.48, 0.6, 0.64), DVec3::NEG_Y] {
            let [one, two] = [sight.photon(legs * pixel), other.photon(turned * pixel)];
            let scale = one.energy.abs().max(1.0);
            let off = (one.energy - two.energy).abs() + (one.radial - two.radial).abs() + (one.w - two.w).length();
            // Next to the horizon of a fast hole an observer at rest moves with gamma of some hundreds.
            assert!(off < 1e-8 * scale, "{:?} {:?}: {off:e}", before.camera, before.observer);
        }
    }
}

#[test]
fn a_flight_over_the_pole_keeps_the_hole_where_it_is_in_the_picture() {
    // Straight up along a meridian, no turns: over the pole theta's direction is the other way round.
    let r: f64 = 10.0;
    let speed = (0.5 / (r - 1.0)).sqrt();
    let mut scene = scene(0.0, ObserverKind::Static, [0.0, -speed, 0.0], r, 5.0);
    (scene.camera.yaw_deg, scene.camera.pitch_deg) = (12.0, 7.0);
    let normal = scene.camera.legs().z_axis;
    let mut worldline = Worldline::start(&scene).unwrap();
    // The legs become those of rain.
    worldline.advance(0.0, &mut scene);
    let axes = scene.camera.legs() * scene.camera.legs_from_camera();
    for _ in 0..50 {
        let before = scene.camera.direction();
        worldline.advance(0.5, &mut scene);
        let swept = before.angle_between(scene.camera.direction());
        assert!((swept - 0.5 * speed / ((1.0 - speed * speed).sqrt() * r)).abs() < 1e-9, "{swept}");
    }
    assert!(scene.camera.direction().dot(DVec3::Z) < 0.995 && scene.camera.phi_deg < -100.0, "{:?}", scene.camera);
    let turned = scene.camera.legs() * scene.camera.legs_from_camera();
    let angle = 25.0 * speed / ((1.0 - speed * speed).sqrt() * r);
    let expected = glam::DMat3::from_axis_angle(normal, -angle) * axes;
    assert!((turned.z_axis - expected.z_axis).length() < 1e-8, "{turned} {expected}");
    assert!((turned.y_axis - expected.y_axis).length() < 1e-8, "{turned} {expected}");
}

#[test]
fn what_cannot_be_is_not_let_go() {
    assert!(Worldline::start(&scene(0.0, ObserverKind::Static, [0.0; 3], 0.9, 90.0)).is_err());
    assert!(Worldline::start(&scene(0.0, ObserverKind::Orbit, [0.0; 3], 5.0, 80.0)).is_err());
    let kerr = Kerr { spin: 0.8 };
    assert!(innermost(kerr) > kerr.inner_horizon() && innermost(kerr) < kerr.horizon());
    let mut away = geodesic(&scene(0.0, ObserverKind::Static, [0.9, 0.0, 0.0], 1e6, FRAC_PI_2.to_degrees()));
    assert_eq!(away.advance(1e9, [0.1, 1e7]), Some(Limit::Outer));
    assert_close("r", 1.0 / away.state.u, 1e7, 1e-12);
}
