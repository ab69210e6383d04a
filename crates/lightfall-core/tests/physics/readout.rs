//! Read-outs against closed forms, published formulas and the traced picture.

use crate::reference::directions;
use crate::schwarzschild::SHADOW;
use crate::{assert_close, bisect};
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::observer_matrix;
use lightfall_core::geometry::tetrad::{four_velocity, velocity_in_rain};
use lightfall_core::optics::readout::{Readout, held_acceleration, shadow_radius, si, tide};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::shift::RestFrame;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::ObserverKind::{Orbit, Rain, Static, Zamo};
use lightfall_core::scene::{HotSpotKind, ObserverKind, Scene};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn scene(spin: f64, kind: ObserverKind, r: f64, theta_deg: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.phi_deg) = (r, theta_deg, 25.0);
    (scene.observer.kind, scene.disk.enabled) = (kind, false);
    scene
}

fn read(scene: &Scene) -> Readout {
    Readout::new(scene).unwrap()
}

#[test]
fn thrust_is_that_of_hovering_and_zero_in_free_fall() {
    for r in [1.001_f64, 1.5, 3.0, 1e3, 1e6] {
        let hover = 0.5 / (r * r * (1.0 - 1.0 / r).sqrt());
        for kind in [Static, Zamo] {
            assert_close(
                format!("{kind:?} at {r}"),
                read(&scene(0.0, kind, r, 60.0)).acceleration,
                hover,
                1e-12,
            );
        }
    }
    assert_eq!(read(&scene(0.5, Rain, 2.0, 60.0)).acceleration, 0.0);
    assert_eq!(read(&scene(0.5, Orbit, 4.0, 90.0)).acceleration, 0.0);
    let mut coasting = scene(0.5, Static, 4.0, 90.0);
    coasting.observer.velocity = [0.0, 0.1, 0.0];
    assert_eq!(read(&coasting).acceleration, 0.0);
    // With spin, from the potentials themselves by central differences, good to 1e-8.
    for spin in [-0.9, 0.5, 0.998] {
        for (r, theta) in [(2.0_f64, 1.2_f64), (5.0, 0.3), (1.1, 0.05)] {
            let kerr = Kerr { spin };
            let potentials: [(ObserverKind, &dyn Fn(f64, f64) -> f64); 2] = [
                (Static, &|r, theta| {
                    0.5 * (1.0 - r / kerr.sigma(r, theta.cos())).ln()
                }),
                (Zamo, &|r, theta| RestFrame::at(kerr, r, theta).lapse.ln()),
            ];
            for (kind, potential) in potentials {
                let h = 1e-5;
                let by_r = (potential(r + h, theta) - potential(r - h, theta)) / (2.0 * h);
                let by_theta = (potential(r, theta + h) - potential(r, theta - h)) / (2.0 * h);
                let expected = ((kerr.delta(r) * by_r * by_r + by_theta * by_theta)
                    / kerr.sigma(r, theta.cos()))
                .sqrt();
                if expected.is_finite() {
                    assert_close(
                        format!("{kind:?}"),
                        held_acceleration(kerr, kind, r, theta),
                        expected,
                        1e-7,
                    );
                }
            }
        }
    }
}

#[test]
fn clocks_and_speeds_follow_the_textbook_formulas() {
    for r in [1.7_f64, 4.0, 50.0] {
        let fall = (1.0 / r).sqrt();
        let still = read(&scene(0.0, Static, r, 90.0));
        assert_close(
            "at rest",
            still.time_dilation.unwrap(),
            (1.0 - 1.0 / r).sqrt(),
            1e-14,
        );
        assert!(still.speed_for_static.unwrap() < 1e-15 && still.speed_for_zamo.unwrap() < 1e-15);
        let rain = read(&scene(0.0, Rain, r, 90.0));
        assert_close(
            "rain's clock",
            rain.time_dilation.unwrap(),
            1.0 - 1.0 / r,
            1e-14,
        );
        assert_close("rain's speed", rain.speed_for_static.unwrap(), fall, 1e-13);
        let orbit = read(&scene(0.0, Orbit, r, 90.0));
        assert_close(
            "orbit's clock",
            orbit.time_dilation.unwrap(),
            (1.0 - 1.5 / r).sqrt(),
            1e-13,
        );
        assert_close(
            "orbit's speed",
            orbit.speed_for_zamo.unwrap(),
            (0.5 / (r - 1.0)).sqrt(),
            1e-13,
        );
    }
    // In the ergosphere no observer is at rest. Inside the horizon no observer hovers, and there is
    // no comparison with a clock far away.
    let ergosphere = read(&scene(0.9, Zamo, 0.9, 90.0));
    assert!(ergosphere.speed_for_static.is_none() && ergosphere.speed_for_zamo.unwrap() < 1e-15);
    let inside = read(&scene(0.9, Rain, 0.5, 90.0));
    assert_eq!(
        (
            inside.speed_for_static,
            inside.speed_for_zamo,
            inside.time_dilation
        ),
        (None, None, None)
    );
    assert!(inside.shadow_radius.is_finite() && inside.tide.is_finite());
}

#[test]
fn light_from_straight_ahead_is_shifted_by_the_potential_and_the_speed() {
    let mut scene = scene(0.0, Static, 4.0, 70.0);
    assert_eq!(read(&scene).ahead, None, "ahead is the hole");
    scene.camera.yaw_deg = 180.0;
    let ahead = read(&scene).ahead.unwrap();
    let gravity = 1.0 / 0.75_f64.sqrt();
    assert!(!ahead.from_disk);
    assert_close("hovering", ahead.shift, gravity, 1e-14);
    assert_close(
        "hovering",
        ahead.gravitational_shift.unwrap(),
        gravity,
        1e-14,
    );
    // From behind an observer that falls from rest at infinity: 1/(1 + sqrt(1/r)).
    scene.observer.kind = Rain;
    scene.effects.doppler = false;
    let ahead = read(&scene).ahead.unwrap();
    assert_close("falling", ahead.shift, 1.0 / 1.5, 1e-14);
    assert_close(
        "falling",
        ahead.gravitational_shift.unwrap(),
        gravity,
        1e-14,
    );
    scene.camera.r = 0.25;
    let ahead = read(&scene).ahead.unwrap();
    assert_close("inside", ahead.shift, 1.0 / 3.0, 1e-14);
    assert_eq!(ahead.gravitational_shift, None);
    // Down onto the disk.
    scene.disk.enabled = true;
    (scene.observer.kind, scene.camera.r, scene.camera.theta_deg) = (Static, 20.0, 80.0);
    (scene.camera.yaw_deg, scene.camera.pitch_deg) = (0.0, -8.0);
    let (direction, ahead) = (
        scene.camera.tetrad_from_camera().z_axis,
        read(&scene).ahead.unwrap(),
    );
    let hit = Reference::new(&Scene {
        effects: Default::default(),
        ..scene
    })
    .unwrap()
    .trace(direction)
    .hits[0]
        .unwrap();
    assert!(ahead.from_disk);
    assert_eq!(ahead.shift, hit.g);
    // lambda = 0 in the camera's meridian, where matter at r has dtau/dt = sqrt(1 - 1.5/r) and at
    // rest sqrt(1 - 1/r).
    assert_close(
        "disk",
        ahead.shift,
        ((1.0 - 1.5 / hit.r) / 0.95_f64).sqrt(),
        1e-12,
    );
    assert_close(
        "disk",
        ahead.gravitational_shift.unwrap(),
        ((1.0 - 1.0 / hit.r) / 0.95_f64).sqrt(),
        1e-12,
    );
}

#[test]
fn shadows_without_spin_have_the_closed_form() {
    for [r, still, falling] in SHADOW {
        for (kind, expected) in [(Static, still), (Rain, falling)] {
            let found = read(&scene(0.0, kind, r, 70.0)).shadow_radius.to_degrees();
            assert_close(format!("{kind:?} at {r}"), found, expected, 1e-11);
        }
    }
    let horizon = read(&scene(0.0, Rain, 1.0, 70.0))
        .shadow_radius
        .to_degrees();
    assert_close("at the horizon", horizon, 42.1034, 2e-6);
    // Up to the largest radius of a camera.
    let far = read(&scene(0.0, Static, 1e7, 70.0)).shadow_radius;
    assert_close("far away", far, 27.0_f64.sqrt() / 2.0 * 1e-7, 1e-6);
    let spinning = read(&scene(2e-4, Static, 1e7, 70.0)).shadow_radius;
    assert_close("far away, with spin", spinning, far, 1e-6);
}

/// The edge that the reference traces, bisected along great circles from a captured direction. The
/// share of the sky is the mean of 1 - cos. 96 directions on a smooth curve give a relative error
/// of 1e-6, as does the bisection.
#[test]
fn shadows_with_spin_and_speed_are_as_large_as_the_traced_ones() {
    for (spin, kind, velocity, r, theta_deg) in [
        (0.0, Static, [0.2, -0.5, 0.6], 4.0, 70.0),
        (0.0, Rain, [0.0, 0.7, 0.0], 0.6, 70.0),
        (0.9, Static, [0.0; 3], 5.0, 70.0),
        (-0.9, Rain, [0.0; 3], 5.0, 70.0),
        (0.9, Static, [0.3, 0.0, -0.8], 5.0, 30.0),
        (0.998, Zamo, [0.0; 3], 1.2, 90.0),
        (0.5, Orbit, [0.0; 3], 3.5, 90.0),
        (0.998, Rain, [0.0; 3], 20.0, 0.0),
        (0.7, Rain, [0.1, 0.2, 0.3], 0.6, 60.0),
        (0.001, Static, [0.0; 3], 1.6, 45.0),
    ] {
        let mut scene = scene(spin, kind, r, theta_deg);
        scene.observer.velocity = velocity;
        let reference = Reference::new(&scene).unwrap();
        let dark = |d: DVec3| reference.trace(d).outcome == Outcome::Captured;
        // A direction well inside: the mean of the dark directions of a coarse grid.
        let dark_ones = directions(4000).filter(|d| dark(*d));
        let middle = dark_ones.sum::<DVec3>().normalize();
        let (across, up) = middle.any_orthonormal_pair();
        let turns = 96;
        let share = (0..turns).map(|i| {
            let (sin, cos) = (TAU * f64::from(i) / f64::from(turns)).sin_cos();
            let side = cos * across + sin * up;
            let at = |angle: f64| middle * angle.cos() + side * angle.sin();
            1.0 - bisect(0.0, PI, |angle| dark(at(angle))).cos()
        });
        let expected = (1.0 - share.sum::<f64>() / f64::from(turns)).acos();
        let found = read(&scene).shadow_radius;
        assert_close(
            format!("spin {spin}, {kind:?} {velocity:?} at {r}, {theta_deg}"),
            found,
            expected,
            1e-5,
        );
    }
}

#[test]
fn shadows_are_continuous_at_the_horizon_and_at_the_smallest_spin_that_counts() {
    for spin in [0.0, 0.6, -0.95] {
        let kerr = Kerr { spin };
        let at = |r: f64| {
            let matrix = observer_matrix(spin, Rain, [0.1, 0.2, -0.3], r, 1.1, 0.4).unwrap();
            shadow_radius(kerr, &matrix, r, 1.1, 0.4)
        };
        let horizon = kerr.horizon();
        let [below, on, above] = [horizon * (1.0 - 1e-6), horizon, horizon * (1.0 + 1e-6)].map(at);
        assert!(
            (below - on).abs() < 1e-5 && (above - on).abs() < 1e-5,
            "{below} {on} {above}"
        );
    }
    let [without, with] =
        [0.99e-4, 1.01e-4].map(|spin| read(&scene(spin, Static, 3.0, 50.0)).shadow_radius);
    assert_close("spin", with, without, 1e-7);
}

#[test]
fn tides_are_newtonian_for_radial_motion_and_marcks_for_orbits() {
    for r in [0.3_f64, 1.5, 20.0] {
        assert_close(
            "rain",
            read(&scene(0.0, Rain, r, 50.0)).tide,
            1.0 / r.powi(3),
            1e-14,
        );
    }
    assert_close(
        "at rest",
        read(&scene(0.0, Static, 3.0, 50.0)).tide,
        1.0 / 27.0,
        1e-14,
    );
    // Marck 1983: (M/r^3)(2 + 3 K/r^2) in the plane, K = (L - a E)^2.
    for spin in [-0.9, 0.0, 0.5, 0.998] {
        let kerr = Kerr { spin };
        let r = 1.2 * kerr.isco();
        let orbit = kerr.circular_orbit(r).unwrap();
        let k = (orbit.angular_momentum - kerr.a() * orbit.energy).powi(2);
        let expected = 0.5 / r.powi(3) * (2.0 + 3.0 * k / (r * r));
        assert_close(
            format!("orbit, spin {spin}"),
            read(&scene(spin, Orbit, r, 90.0)).tide,
            expected,
            1e-12,
        );
    }
    // On the axis, E_rr = -2 M r (r^2 - 3 a^2)/(r^2 + a^2)^3.
    let (r, a): (f64, f64) = (2.0, 0.45);
    let expected = r * (r * r - 3.0 * a * a) / (r * r + a * a).powi(3);
    assert_close(
        "axis",
        read(&scene(0.9, Rain, r, 0.0)).tide,
        expected,
        1e-12,
    );
}

/// The tide of a boosted observer against the transformation law of the curvature. The electric and
/// magnetic parts of the Weyl tensor are the real and imaginary parts of psi (1 - 3 e e); a boost
/// acts on E + i B as a complex rotation. The largest stretching is sought over a grid of
/// directions.
#[test]
fn tides_off_the_plane_are_those_of_the_boosted_weyl_tensor() {
    for (spin, velocity) in [
        (0.9, [0.1, 0.5, -0.6]),
        (-0.998, [-0.3, -0.6, 0.2]),
        (0.0, [0.0, 0.8, 0.1]),
    ] {
        let (kerr, r, theta) = (Kerr { spin }, 1.8, 0.8_f64);
        let matrix = observer_matrix(spin, Zamo, velocity, r, theta, 0.3).unwrap();
        let u = four_velocity(&matrix);
        let n = DVec3::new(
            theta.sin() * 0.3_f64.cos(),
            theta.sin() * 0.3_f64.sin(),
            theta.cos(),
        );
        let found = tide(kerr, r, n, &u);
        // In Carter's frame: the ZAMO moves along phi with a sin sqrt(Delta)/(r^2 + a^2) for it.
        let (a, sin) = (kerr.a(), theta.sin());
        let frame_speed = -a * sin * kerr.delta(r).sqrt() / (r * r + a * a);
        let v = DVec3::from_array(velocity);
        let for_carter = {
            // Velocity addition, with the frame's velocity along z (phi).
            let gamma = 1.0 / (1.0 - frame_speed * frame_speed).sqrt();
            let below = 1.0 + frame_speed * v.z;
            DVec3::new(
                v.x / (gamma * below),
                v.y / (gamma * below),
                (v.z + frame_speed) / below,
            )
        };
        let gamma = 1.0 / (1.0 - for_carter.length_squared()).sqrt();
        // e becomes gamma e - gamma^2/(gamma + 1) v (v.e) - i gamma v x e: Landau & Lifshitz,
        // section 24.
        let e = DVec3::X;
        let real = gamma * e - gamma * gamma / (gamma + 1.0) * for_carter.dot(e) * for_carter;
        let imaginary = -gamma * for_carter.cross(e);
        let height = a * theta.cos();
        let scale = 0.5 / (r * r + height * height).powi(3);
        let (p, q) = (
            scale * r * (r * r - 3.0 * height * height),
            scale * height * (3.0 * r * r - height * height),
        );
        // The stretching along the unit direction d is Re psi (3 (d.m)^2 - 1); the largest over all
        // directions counts.
        let stretch = |d: DVec3| {
            let (x, y) = (d.dot(real), d.dot(imaginary));
            3.0 * (p * (x * x - y * y) - q * 2.0 * x * y) - p
        };
        let mut best = f64::MIN;
        for i in 0..400 {
            for j in 0..400 {
                let (up, turn) = (PI * f64::from(i) / 400.0, PI * f64::from(j) / 400.0);
                best = best.max(stretch(DVec3::new(
                    up.sin() * turn.cos(),
                    up.sin() * turn.sin(),
                    up.cos(),
                )));
            }
        }
        // A grid of 0.5 degrees misses the maximum by 1e-4 at most.
        assert_close(format!("spin {spin}"), found, best, 2e-4);
    }
}

#[test]
fn a_hole_of_a_given_mass_has_readouts_in_kilometres_and_g() {
    let [sagittarius, m87, suns] = si::MASSES;
    // 2 G M/c^2 of the sun is 2.9532 km.
    assert_close("Sgr A*", sagittarius.metres(), 2.95325e3 * 4.30e6, 1e-5);
    assert_close("M87*", m87.seconds(), 9.85098e-6 * 6.5e9, 1e-5);
    let still = read(&scene(0.0, Static, 2.0, 90.0)).in_si(suns);
    assert_close("r", still.r_km, 2.0 * 29.5325, 1e-5);
    // c^2/r_s = 3.0433e12 m/s^2; at 2 r_s the thrust is sqrt(2)/8 of it, the tide 1/8 of c^2/r_s^2.
    assert_close(
        "thrust",
        still.acceleration_g,
        2f64.sqrt() / 8.0 * 3.04326e12 / 9.80665,
        1e-4,
    );
    assert_close(
        "tide",
        still.tide_g_per_metre,
        3.04326e12 / 29_532.5 / 8.0 / 9.80665,
        1e-4,
    );
}

#[test]
fn rain_with_the_relative_velocity_is_the_same_observer() {
    for spin in [-0.9, 0.0, 0.98] {
        for (r, theta) in [
            (5.0, 0.7),
            (1.3, FRAC_PI_2),
            (0.8 * Kerr { spin }.horizon(), 2.0),
            (Kerr { spin }.horizon(), 1.0),
        ] {
            for velocity in [
                [0.0; 3],
                [-0.5, 0.1, 0.3],
                [0.6, -0.6, 0.1],
                [0.99, 0.0, 0.0],
            ] {
                let matrix = observer_matrix(spin, Rain, velocity, r, theta, 0.2).unwrap();
                let found = velocity_in_rain(Kerr { spin }, r, theta, 0.2, &four_velocity(&matrix));
                assert!(
                    (found - DVec3::from_array(velocity)).length() < 1e-11,
                    "{spin} {r} {velocity:?}: {found}"
                );
            }
        }
    }
}

#[test]
fn hot_spot_has_a_period_and_an_echo_and_no_spot_has_none() {
    let mut scene = scene(0.0, Static, 20.0, 0.0);
    assert_eq!(read(&scene).hot_spot, None);
    scene.disk.enabled = true;
    (scene.hot_spot.kind, scene.hot_spot.r) = (HotSpotKind::Rigid, 4.5);
    // Effects that are off change the picture, not the world.
    scene.effects.lensing = false;
    let spot = read(&scene).hot_spot.unwrap();
    assert_close(
        "period",
        spot.period,
        TAU * 4.5_f64.powf(1.5) / 0.5_f64.sqrt(),
        1e-12,
    );
    // The orbit's equation with 30 digits.
    let expected = [22.521_771_456_4, 34.372_260_342_2, 42.707_549_924_9];
    for (found, expected) in spot.delays.into_iter().zip(expected) {
        assert_close("delay", found.unwrap(), expected, 1e-11);
    }
}
