//! Tilted disks, against the view without tilt from a camera that is moved with everything but the
//! hole, and against the geometry of straight rays.

use crate::assert_close;
use crate::moved_camera::Twin;
use glam::{DMat3, DVec3};
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::accuracy::{Ray, rays_over_sky};
use lightfall_core::geometry::sphere::wrap_angle;
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::apparent_hole::dark_share;
use lightfall_core::optics::echo::echo;
use lightfall_core::optics::exposure::metered_exposure;
use lightfall_core::optics::guides::{Landmark, quick_guides, traced_guides};
use lightfall_core::optics::limb::Limb;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::{Outcome, Trace};
use lightfall_core::scene::{HotSpotKind, LimbDarkening, ObserverKind, Scene};

/// A wide disk with this tilt and node, and a camera at rest off every axis.
fn tilted(tilt_deg: f64, node_deg: f64) -> Scene {
    let mut scene = Scene::default();
    (scene.disk.tilt_deg, scene.disk.node_deg) = (tilt_deg, node_deg);
    scene.disk.outer = 40.0;
    (scene.camera.r, scene.camera.theta_deg) = (12.0, 70.0);
    (scene.camera.phi_deg, scene.camera.yaw_deg) = (25.0, 7.0);
    (scene.camera.pitch_deg, scene.camera.roll_deg) = (-4.0, 11.0);
    scene
}

fn scenes() -> Vec<Scene> {
    let with = |mut scene: Scene, kind, velocity, r| {
        (scene.observer.kind, scene.observer.velocity) = (kind, velocity);
        scene.camera.r = r;
        scene
    };
    let mut straight = tilted(35.0, -70.0);
    straight.effects.lensing = false;
    let mut below = tilted(120.0, 200.0);
    below.camera.theta_deg = 130.0;
    vec![
        tilted(30.0, 40.0),
        below,
        tilted(180.0, 10.0),
        straight,
        with(
            tilted(60.0, -110.0),
            ObserverKind::Static,
            [0.3, -0.2, 0.5],
            8.0,
        ),
        with(
            tilted(60.0, -110.0),
            ObserverKind::Rain,
            [0.1, 0.4, -0.2],
            0.7,
        ),
        with(tilted(80.0, 5.0), ObserverKind::Rain, [0.0; 3], 3.0),
    ]
}

/// Directions spread evenly over the sphere.
fn all_around(count: usize) -> Vec<DVec3> {
    rays_over_sky(count).iter().map(Ray::direction).collect()
}

/// That two traces are the same, but for the frame of the sky.
#[track_caller]
fn assert_same(found: &Trace, twin: &Trace, turn: DMat3) {
    assert_eq!(found.outcome, twin.outcome);
    if let (Some(sky), Some(other)) = (found.sky, twin.sky) {
        assert!(sky.distance(turn * other) < 1e-9, "{sky} and {other}");
    }
    for (hit, other) in found.hits.iter().zip(twin.hits) {
        assert_eq!(hit.is_some(), other.is_some());
        let (Some(hit), Some(other)) = (hit, other) else {
            continue;
        };
        assert_close("r", hit.r, other.r, 1e-9);
        assert_close("g", hit.g, other.g, 1e-9);
        assert!(wrap_angle(hit.phi - other.phi).abs() < 1e-9);
        if let (Some(delay), Some(other)) = (hit.delay, other.delay) {
            assert_close("delay", delay, other, 1e-9);
        }
    }
}

/// The tolerances are roundings of 1e-16, which rays near the photon sphere amplify a million times.
#[test]
fn a_tilted_disk_is_seen_as_by_a_camera_that_is_moved_and_rolled_instead() {
    let mut seen = [0; 3];
    for scene in scenes() {
        let twin = Twin::of(&scene);
        let (reference, other) = (
            Reference::new(&scene).unwrap(),
            Reference::new(&twin.scene).unwrap(),
        );
        // The hole is the smaller part of what is around a distant camera: more rays toward it.
        let toward_hole = all_around(400).into_iter().map(|d| d - 3.0 * DVec3::X);
        for direction in all_around(400).into_iter().chain(toward_hole) {
            let direction = direction.normalize();
            let found = reference.trace_with_delays(direction);
            let expected = other.trace_with_delays(twin.axes * direction);
            assert_same(&found, &expected, twin.turn);
            seen[0] += usize::from(found.hits[0].is_some());
            seen[1] += usize::from(found.hits[1].is_some());
            seen[2] += usize::from(found.outcome == Outcome::Sky);
        }
    }
    // First hits, second hits and rays to the sky, so that each is compared often.
    assert!(seen[0] > 500 && seen[1] > 20 && seen[2] > 1000, "{seen:?}");
}

/// Where straight rays meet the plane through the hole's centre across the normal (sin(tilt)
/// sin(node), -sin(tilt) cos(node), cos(tilt)), and the angle there from the node's direction.
#[test]
fn straight_rays_meet_a_tilted_disk_in_its_plane_and_azimuths_count_from_the_node() {
    let mut scene = tilted(50.0, 20.0);
    scene.effects.lensing = false;
    let (tilt, node) = (50.0_f64.to_radians(), 20.0_f64.to_radians());
    let normal = DVec3::new(
        tilt.sin() * node.sin(),
        -tilt.sin() * node.cos(),
        tilt.cos(),
    );
    let ascending = DVec3::new(node.cos(), node.sin(), 0.0);
    let quarter_on = normal.cross(ascending);
    assert!(quarter_on.z > 0.0, "orbits cross the equator upward here");
    let reference = Reference::new(&scene).unwrap();
    let mut hits = 0;
    for direction in all_around(500) {
        let Some(hit) = reference.trace_with_delays(direction).hits[0] else {
            continue;
        };
        let way = hit.delay.unwrap() * (scene.camera.tetrad() * direction);
        let place = scene.camera.r * scene.camera.direction() + way;
        assert!(place.dot(normal).abs() < 1e-12 * place.length());
        assert_close("r", hit.r, place.length(), 1e-12);
        let azimuth = node + place.dot(quarter_on).atan2(place.dot(ascending));
        assert!(wrap_angle(hit.phi - azimuth).abs() < 1e-12);
        hits += 1;
    }
    assert!(hits > 50);
}

#[test]
fn the_sky_does_not_turn_with_the_disk() {
    let mut level = tilted(0.0, 0.0);
    level.disk.enabled = false;
    let mut scene = tilted(75.0, 130.0);
    scene.disk.enabled = false;
    let [level, scene] = [level, scene].map(|scene| Reference::new(&scene).unwrap());
    let mut seen = 0;
    for direction in all_around(400) {
        let found = scene.trace(direction);
        assert_same(&found, &level.trace(direction), DMat3::IDENTITY);
        seen += usize::from(found.sky.is_some());
    }
    assert!(seen > 300, "{seen} rays reach the sky");
}

#[test]
fn a_node_without_tilt_changes_no_bit() {
    let level = Reference::new(&tilted(0.0, 0.0)).unwrap();
    let noded = Reference::new(&tilted(0.0, 77.0)).unwrap();
    for direction in all_around(200) {
        assert_eq!(level.trace(direction), noded.trace(direction));
    }
}

/// A camera in the disk's plane has no hit at its own place: no rounding of the rotation puts it
/// beside the plane.
#[test]
fn a_camera_in_a_tilted_disks_plane_sees_no_disk_where_it_is() {
    for (tilt_deg, node_deg, theta_deg, phi_deg) in [
        (30.0, 40.0, 60.0, 130.0),
        (90.0, 40.0, 33.0, 40.0),
        (50.0, 20.0, 90.0, 20.0),
        (65.0, -100.0, 25.0, -10.0),
    ] {
        let mut scene = tilted(tilt_deg, node_deg);
        (scene.camera.theta_deg, scene.camera.phi_deg) = (theta_deg, phi_deg);
        let reference = Reference::new(&scene).unwrap();
        let mut hits = 0;
        for direction in all_around(300) {
            for hit in reference.trace(direction).hits.into_iter().flatten() {
                assert!((hit.r - scene.camera.r).abs() > 1e-9, "{scene:?}: {hit:?}");
                hits += 1;
            }
        }
        assert!(hits > 3, "{hits} hits");
    }
}

#[test]
fn the_echo_of_a_spot_in_a_tilted_disk_comes_as_to_the_moved_camera() {
    for lensing in [true, false] {
        let mut scene = tilted(40.0, 65.0);
        scene.effects.lensing = lensing;
        (scene.hot_spot.kind, scene.hot_spot.r, scene.disk.time) = (HotSpotKind::Rigid, 5.0, 321.0);
        scene.observer.velocity = [0.1, -0.2, 0.3];
        let twin = Twin::of(&scene);
        let (found, expected) = (echo(&scene).unwrap(), echo(&twin.scene).unwrap());
        assert_eq!(found.len(), expected.len());
        assert!(!found.is_empty());
        for (image, other) in found.iter().zip(&expected) {
            assert_close("delay", image.delay, other.delay, 1e-8);
            assert_close("g", image.hit.g, other.hit.g, 1e-8);
            let turned = twin.axes * image.direction;
            assert!(turned.distance(other.direction) < 1e-8);
            let (pixel, other) = (image.pixel.unwrap(), other.pixel.unwrap());
            assert!(pixel.distance(other) < 1e-4, "{pixel} and {other}");
        }
    }
}

#[test]
fn meters_limbs_and_counts_of_dark_rays_are_those_of_the_moved_camera() {
    let mut scene = tilted(55.0, -20.0);
    scene.disk.limb = LimbDarkening::ElectronScattering;
    let twin = Twin::of(&scene);
    let exposure = |scene: &Scene| metered_exposure(scene).unwrap().unwrap();
    // The meter rounds to a thousandth.
    assert!((exposure(&scene) - exposure(&twin.scene)).abs() < 1.5e-3);
    assert_eq!(
        dark_share(&scene).unwrap(),
        dark_share(&twin.scene).unwrap()
    );
    let (reference, other) = (
        Reference::new(&scene).unwrap(),
        Reference::new(&twin.scene).unwrap(),
    );
    let (limb, other_limb) = (Limb::new(&scene), Limb::new(&twin.scene));
    let mut hits = 0;
    for direction in all_around(200) {
        if let Some(hit) = reference.trace(direction).hits[0] {
            let factor = limb.factor(&reference.photon(direction), hit.r);
            let photon = other.photon(twin.axes * direction);
            assert_close("limb", factor, other_limb.factor(&photon, hit.r), 1e-9);
            hits += 1;
        }
    }
    assert!(hits > 3, "{hits} rays meet the disk");
}

/// The guides' curves are dense, so that the twin's begin elsewhere: each point has a near
/// neighbour on the twin's curve, no farther than half of the largest gap.
#[test]
fn guides_of_the_disks_plane_are_tilted_with_it() {
    for lensing in [true, false] {
        let mut scene = tilted(40.0, 65.0);
        scene.effects.lensing = lensing;
        scene.observer.velocity = [0.1, -0.2, 0.3];
        let twin = Twin::of(&scene);
        let curve = |scene: &Scene, landmark| {
            let mut guides = traced_guides(scene).unwrap();
            guides.extend(quick_guides(scene).unwrap());
            let found = guides.into_iter().find(|guide| guide.landmark == landmark);
            found.map(|guide| guide.curves.concat())
        };
        let mut compared = 0;
        for landmark in [
            Landmark::StableOrbit,
            Landmark::StableOrbitAgain,
            Landmark::ShadowEdge,
        ] {
            let (found, other) = (curve(&scene, landmark), curve(&twin.scene, landmark));
            assert_eq!(found.is_some(), other.is_some(), "{landmark:?}");
            let (Some(found), Some(other)) = (found, other) else {
                continue;
            };
            let gap = other
                .iter()
                .zip(other.iter().cycle().skip(1))
                .map(|(a, b)| a.distance(*b))
                .fold(0.0, f64::max);
            for point in found {
                let turned = twin.axes * point;
                let near = other.iter().map(|other| turned.distance(*other));
                assert!(
                    near.fold(f64::INFINITY, f64::min) < 0.51 * gap,
                    "{landmark:?}"
                );
            }
            compared += 1;
        }
        assert_eq!(compared, if lensing { 3 } else { 1 });
    }
}

#[test]
fn an_inspected_ray_has_the_numbers_and_the_plane_of_the_moved_cameras() {
    let scene = tilted(30.0, 40.0);
    let twin = Twin::of(&scene);
    let mut deflected = 0;
    for direction in all_around(60) {
        let found = Inspected::new(&scene, direction, None, 60.0).unwrap();
        let other = Inspected::new(&twin.scene, twin.axes * direction, None, 60.0).unwrap();
        let (numbers, expected) = (&found.numbers, &other.numbers);
        assert_close("closest", numbers.closest_r, expected.closest_r, 1e-9);
        assert_close("swept", numbers.half_turns, expected.half_turns, 1e-9);
        assert_eq!(numbers.order, expected.order);
        assert_eq!(found.path.points.len(), other.path.points.len());
        for (point, other) in found.plane.points.iter().zip(&other.plane.points) {
            assert!(point.distance(*other) < 1e-7 * other.length());
        }
        if let (Some(angle), Some(other)) = (numbers.deflection, expected.deflection) {
            assert!((angle - other).abs() < 1e-9);
            deflected += 1;
        }
    }
    assert!(deflected > 10, "{deflected}");
}

#[test]
fn the_height_above_a_tilted_disk_is_that_of_the_moved_camera() {
    for scene in scenes() {
        let height = Twin::of(&scene).scene.degrees_above_disk();
        assert!((scene.degrees_above_disk() - height).abs() < 1e-9);
    }
}

/// The camera's circular orbit stays in the equator of the hole's frame, whatever the disk does.
#[test]
fn an_orbiting_camera_stays_in_the_equator_while_the_disk_is_tilted() {
    let mut scene = tilted(30.0, 40.0);
    (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Orbit, [0.0; 3]);
    assert!(Drawable::new(scene.clone()).is_err(), "off the equator");
    scene.camera.theta_deg = 90.0;
    let orbiting = Drawable::new(scene.clone()).unwrap();
    // The orbit is a boost along phi with v^2 = M / (r - 2M).
    let mut boosted = scene.clone();
    boosted.observer.kind = ObserverKind::Static;
    boosted.observer.velocity = [0.0, 0.0, (0.5 / (scene.camera.r - 1.0)).sqrt()];
    let (reference, other) = (
        Reference::new(orbiting.scene()).unwrap(),
        Reference::new(&boosted).unwrap(),
    );
    for direction in all_around(200) {
        assert_same(
            &reference.trace(direction),
            &other.trace(direction),
            DMat3::IDENTITY,
        );
    }
}
