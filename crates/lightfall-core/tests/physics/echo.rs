//! The light echo of a hot spot, against delays that three independent computations share: the
//! orbit's equation with 30 digits, Hamilton's equations, and the separated form.

use crate::assert_close;
use glam::DVec2;
use lightfall_core::geometry::observer::ObserverKind;
use lightfall_core::optics::echo::{Image, echo};
use lightfall_core::optics::hot_spot::HotSpot;
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{HotSpotKind, Scene};
use std::f64::consts::PI;

/// Radius of the spot, and impact parameter and delay of its images of order 0, 1 and 2, for a
/// camera at r = 20 on the axis of a hole without spin. From the orbit's equation with 30 digits.
pub const ON_THE_AXIS: [(f64, [[f64; 2]; 3]); 4] = [
    (
        3.0,
        [
            [3.591_858_375_8, 22.749_512_218_6],
            [2.721_138_694_93, 32.791_218_128_2],
            [2.603_268_638_97, 41.070_005_636_9],
        ],
    ),
    (
        4.5,
        [
            [5.101_337_306_41, 22.521_771_456_4],
            [2.784_898_432_1, 34.372_260_342_2],
            [2.605_596_367_64, 42.707_549_924_9],
        ],
    ),
    (
        6.0,
        [
            [6.534_607_157_12, 22.605_808_415_9],
            [2.824_286_961_89, 35.995_524_085_2],
            [2.606_933_716_48, 44.364_546_917_1],
        ],
    ),
    (
        10.0,
        [
            [9.889_685_100_02, 23.679_112_623_6],
            [2.881_283_717_31, 40.303_023_761_8],
            [2.608_737_314_05, 48.719_250_806],
        ],
    ),
];

fn scene(spin: f64, theta_deg: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (20.0, theta_deg, 50.0);
    (scene.disk.follow_isco, scene.disk.time) = (true, 1234.5);
    (scene.hot_spot.kind, scene.hot_spot.r) = (HotSpotKind::Rigid, 4.5);
    scene
}

/// That an image is where the spot was when its light left, seen by the reference.
fn check(scene: &Scene, image: &Image) {
    let spot = HotSpot::new(scene).unwrap();
    // The reference records two crossings of the disk. Around a hole that spins, both may lie
    // farther in or out than the spot.
    let mut ring = scene.clone();
    (ring.disk.follow_isco, ring.disk.inner, ring.disk.outer) = (false, 4.0, 10.3);
    let seen = Reference::new(&ring)
        .unwrap()
        .trace_with_delays(image.direction);
    let near = |hit: &&lightfall_core::optics::trace::Hit| (hit.r - spot.r()).abs() < 1e-6;
    let hit = *seen
        .hits
        .iter()
        .flatten()
        .find(near)
        .unwrap_or_else(|| panic!("{image:?} {seen:?}"));
    assert_close("delay", image.delay, hit.delay.unwrap(), 1e-9);
    assert_close("g", image.hit.g, hit.g, 1e-9);
    let off = (hit.phi - spot.azimuth(scene.disk.time - image.delay)).rem_euclid(2.0 * PI);
    assert!(off.min(2.0 * PI - off) < 1e-9, "{image:?}: {off:e}");
}

#[test]
fn echo_on_the_axis_has_the_known_impact_parameters_and_delays() {
    for (r, images) in ON_THE_AXIS {
        let mut scene = scene(0.0, 0.0);
        scene.hot_spot.r = r;
        let found = echo(&scene).unwrap();
        assert_eq!(found.len(), 3);
        for (image, [b, delay]) in found.iter().zip(images) {
            // b = r0 sin(angle)/sqrt(1 - 1/r0) for a camera at rest.
            let sine = image.direction.with_x(0.0).length();
            assert_close(format!("{r} b"), 20.0 * sine / 0.95_f64.sqrt(), b, 1e-10);
            assert_close(format!("{r} delay"), image.delay, delay, 1e-11);
            // The disk ends at 3 r_s, and what rounds to less is no hit.
            if r > 3.0 {
                check(&scene, image);
            }
        }
    }
}

#[test]
fn echo_is_seen_where_the_reference_meets_the_moving_spot() {
    for (spin, theta_deg) in [
        (0.0, 60.0),
        (0.0, 135.0),
        (0.5, 60.0),
        (0.9, 83.0),
        (0.998, 30.0),
        (-0.9, 100.0),
        (0.95, 89.0),
        (0.7, 1.0),
    ] {
        for turn in 0..12 {
            let mut scene = scene(spin, theta_deg);
            scene.disk.time += 7.0 * f64::from(turn);
            let images = echo(&scene).unwrap();
            assert_eq!(images.len(), 3, "{spin} {theta_deg} {turn}");
            for (order, image) in images.iter().enumerate() {
                assert_eq!(image.order, order as u32);
                check(&scene, image);
            }
            assert!(images[0].delay < images[1].delay && images[1].delay < images[2].delay);
        }
    }
}

#[test]
fn echo_moves_with_the_observer_and_is_stated_in_pixels() {
    let mut scene = scene(0.9, 60.0);
    (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Rain, [0.1, -0.2, 0.3]);
    scene.camera.yaw_deg = 3.0;
    let size = scene.picture.size().as_dvec2();
    let images = echo(&scene).unwrap();
    assert_eq!(images.len(), 3);
    for image in images {
        check(&scene, &image);
        let pixel = image.pixel.unwrap();
        let direction = scene.camera.tetrad_from_camera() * scene.camera.looking(pixel, size);
        assert!((direction - image.direction).length() < 1e-12);
        assert!(
            pixel.cmpgt(DVec2::ZERO).all() && pixel.cmplt(size).all(),
            "{pixel}"
        );
    }
}

#[test]
fn echo_of_effects_switched_off_is_that_of_the_picture() {
    let mut scene = scene(0.9, 60.0);
    scene.observer.velocity = [0.0, 0.0, 0.4];
    (scene.effects.aberration, scene.effects.doppler) = (false, false);
    for image in echo(&scene).unwrap() {
        check(&scene, &image);
    }
    scene.effects.lensing = false;
    let images = echo(&scene).unwrap();
    assert_eq!(images.len(), 1, "straight rays meet the spot once");
    check(&scene, &images[0]);
}

#[test]
fn echo_is_empty_without_a_spot_in_the_plane_and_inside() {
    let mut without = scene(0.0, 60.0);
    without.hot_spot.kind = HotSpotKind::None;
    let in_the_plane = scene(0.0, 90.0);
    let mut inside = scene(0.0, 60.0);
    (inside.observer.kind, inside.camera.r) = (ObserverKind::Rain, 0.8);
    for scene in [without, in_the_plane, inside] {
        assert_eq!(echo(&scene).unwrap(), []);
    }
}
