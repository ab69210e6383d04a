//! Nobody gets lost: hand flight slows down before the hole fills the view, keeps the hole where it
//! is on the screen, and leads out again; the camera turns to the hole, and round it.

use glam::{DMat3, DVec2, DVec3};
use lightfall::app::{
    Aim, Barrier, OrbitStep, Steering, aimed, between_axes, next_aim, orbited, steered,
    thrust_fades, zoomed,
};
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::apparent_hole::{ApparentHole, dark_share};
use lightfall_core::optics::camera_rays::CameraRays;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::{Camera, ObserverKind, Scene, presets};

const FRAME: f64 = 1.0 / 60.0;

fn preset(name: &str) -> Drawable {
    Drawable::new(presets::find(name).unwrap().scene(&[]).unwrap()).unwrap()
}

fn placed(spin: f64, kind: ObserverKind, r: f64, theta_deg: f64) -> Drawable {
    let mut scene = Scene::default();
    (scene.hole.spin, scene.observer.kind) = (spin, kind);
    (scene.camera.r, scene.camera.theta_deg) = (r, theta_deg);
    Drawable::new(scene).unwrap()
}

/// The light of a uniform sky in the picture, in any unit: g^4 of the rays that come from it.
fn light_of_sky(scene: &Scene) -> f64 {
    let (reference, rays) = (
        Reference::new(scene).unwrap(),
        CameraRays::new(scene).unwrap(),
    );
    let axes = scene.camera.tetrad_from_camera();
    let size = scene.picture.size().as_dvec2();
    let pixels = (0..16).flat_map(|x| (0..9).map(move |y| DVec2::new(x.into(), y.into())));
    let looking = pixels.map(|pixel| {
        let at = (pixel + 0.5) / DVec2::new(16.0, 9.0) * size;
        axes * scene.camera.looking(at, size)
    });
    looking
        .filter(|ray| reference.trace(*ray).outcome == Outcome::Sky)
        .map(|ray| rays.photon(ray).energy.powi(-4))
        .sum()
}

/// The scene after thrust has been held for so many seconds, and what stopped it in the last frame.
fn held(scene: &Drawable, thrust: DVec3, seconds: f64) -> (Drawable, Option<Barrier>) {
    let steering = Steering {
        thrust,
        turn: DVec3::ZERO,
        speed: 1.0,
        seconds: FRAME,
    };
    let mut after = (scene.clone(), None);
    for _ in 0..(seconds / FRAME).round() as u32 {
        let next = steered(&after.0, &steering).unwrap();
        after = (next.scene, next.stopped_by);
    }
    after
}

#[test]
fn ten_seconds_forward_from_any_preset_that_looks_at_the_hole_leave_its_edge_in_the_picture() {
    for name in ["1", "2", "3", "4", "5", "6", "8"] {
        let (after, _) = held(&preset(name), DVec3::Z, 10.0);
        let dark = dark_share(&after).unwrap();
        println!("preset {name}: r {:.2}, {dark:.2} dark", after.camera.r);
        assert!(
            dark < 0.9,
            "preset {name}: r {}, {dark} dark",
            after.camera.r
        );
        let hole = ApparentHole::new(&after).unwrap();
        assert!(hole.is_in_picture(&after), "preset {name}");
    }
    // And the way was worth it: the hole is large.
    let (near, _) = held(&preset("2"), DVec3::Z, 10.0);
    assert!((2.5..4.5).contains(&near.camera.r), "{}", near.camera.r);
    // The approach goes on, slowly.
    let (nearer, _) = held(&near, DVec3::Z, 10.0);
    assert!(nearer.camera.r < near.camera.r - 0.1, "{}", nearer.camera.r);
}

#[test]
fn backing_away_leaves_the_black_quickly_from_as_near_as_the_hand_flies() {
    let (away, _) = held(
        &placed(0.0, ObserverKind::Static, 1.08, 80.0),
        -DVec3::Z,
        4.0,
    );
    assert!(away.camera.r > 4.0, "{}", away.camera.r);
    // Nor is the hole lost in the distance: it stays larger than a hundredth of the picture.
    let (far, _) = held(&preset("2"), -DVec3::Z, 10.0);
    assert!((100.0..1000.0).contains(&far.camera.r), "{}", far.camera.r);
}

#[test]
fn sideways_flight_keeps_the_radius_and_the_holes_place_on_the_screen() {
    for name in ["1", "2", "4", "8"] {
        for thrust in [DVec3::X, DVec3::Y] {
            let start = preset(name);
            let mut turned = start.scene().clone();
            // Facing the hole exactly, thrust to the side is sideways exactly.
            (turned.camera.yaw_deg, turned.camera.pitch_deg) = (0.0, 0.0);
            let start = Drawable::new(turned).unwrap();
            let (after, _) = held(&start, thrust, 8.0);
            let shift = (after.camera.r / start.camera.r - 1.0).abs();
            assert!(shift < 1e-6, "preset {name}: {}", after.camera.r);
            let way = after
                .camera
                .direction()
                .angle_between(start.camera.direction());
            assert!(way > 0.3, "preset {name}: {way}");
            let place =
                |scene: &Scene| scene.camera.tetrad_from_camera().transpose() * DVec3::NEG_X;
            let moved = (place(&after) - place(&start)).length();
            assert!(moved < 1e-6, "preset {name}: {moved}");
        }
    }
}

#[test]
fn thrust_inward_fades_where_the_hole_fills_the_view() {
    let far = placed(0.0, ObserverKind::Static, 20.0, 83.0);
    assert!(!thrust_fades(&far));
    let (near, stopped) = held(&far, DVec3::Z, 20.0);
    assert!(
        thrust_fades(&near) && stopped.is_none(),
        "{}",
        near.camera.r
    );
}

#[test]
fn hand_flight_says_what_it_cannot_pass() {
    let near = placed(0.0, ObserverKind::Static, 1.09, 80.0);
    let (after, stopped) = held(&near, DVec3::Z, 20.0);
    assert_eq!((after.camera.r, stopped), (1.08, Some(Barrier::MinRadius)));
    // A preset may be nearer. The hand goes no farther from there, and out again.
    let nearer = placed(0.0, ObserverKind::Static, 1.01, 80.0);
    let (after, stopped) = held(&nearer, DVec3::Z, 1.0);
    assert_eq!((after.camera.r, stopped), (1.01, Some(Barrier::MinRadius)));
    let (after, stopped) = held(&nearer, -DVec3::Z, 1.0);
    assert!(after.camera.r > 1.3 && stopped.is_none());
    // Sideways nothing is in the way.
    let (_, stopped) = held(&nearer, DVec3::X, 1.0);
    assert_eq!(stopped, None);
    for thrust in [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::Z] {
        let inside = placed(0.0, ObserverKind::Rain, 0.1, 80.0);
        let (after, stopped) = held(&inside, thrust, 1.0);
        assert_eq!(after.camera, inside.camera);
        assert_eq!(stopped, Some(Barrier::Horizon));
    }
}

#[test]
fn the_camera_faces_the_hole_level_and_then_outward() {
    for (spin, kind, r, theta_deg) in [
        (0.0, ObserverKind::Static, 20.0, 83.0),
        (0.9, ObserverKind::Zamo, 1.3, 0.0),
        (0.9, ObserverKind::Orbit, 4.0, 90.0),
        (0.5, ObserverKind::Rain, 0.8, 120.0),
    ] {
        let scene = placed(spin, kind, r, theta_deg);
        let direction = ApparentHole::new(&scene).unwrap().direction;
        for (aim, sign) in [(Aim::Hole, 1.0), (Aim::Outward, -1.0)] {
            let mut turned = scene.scene().clone();
            turned.camera.set_orientation(aimed(&scene, aim).unwrap());
            let axes = turned.camera.tetrad_from_camera();
            assert!(axes.z_axis.dot(sign * direction) > 1.0 - 1e-12);
            // Level: the camera's right is perpendicular to growing theta.
            assert!(axes.x_axis.y.abs() < 1e-9 && axes.y_axis.y < 0.0, "{axes}");
            let inside = r < scene.kerr().horizon();
            let next = match aim {
                Aim::Hole if inside => Aim::Edge,
                Aim::Hole => Aim::Outward,
                _ => Aim::Hole,
            };
            assert_eq!(next_aim(&turned), next);
        }
    }
}

/// At the end of a fall the sky ahead is a hole, and what is left of the sky behind is too red to be
/// seen. Its light is gathered at the edge of the hole.
#[test]
fn inside_the_horizon_the_key_faces_the_edge_where_the_light_is() {
    for (spin, r) in [(0.0, 0.1), (0.0, 0.5), (0.9, 0.4), (0.998, 0.5)] {
        let mut scene = placed(spin, ObserverKind::Rain, r, 75.0).scene().clone();
        let mut seen = Vec::new();
        for aim in [Aim::Hole, Aim::Edge, Aim::Outward] {
            scene.camera.set_orientation(aimed(&scene, aim).unwrap());
            seen.push(light_of_sky(&scene));
            let next = [Aim::Edge, Aim::Outward, Aim::Hole][aim as usize];
            assert_eq!(next_aim(&scene), next, "spin {spin}, r {r}");
        }
        assert!(seen[1] > seen[0] && seen[1] > seen[2], "{seen:?}");
        // A camera that looks anywhere else is turned to the light first.
        scene
            .camera
            .set_orientation(aimed(&scene, Aim::Hole).unwrap());
        scene.camera.yaw_deg += 30.0;
        assert_eq!(next_aim(&scene), Aim::Edge);
    }
}

#[test]
fn a_turn_begins_where_the_camera_looks_ends_at_its_aim_and_never_jumps() {
    let scene = preset("falling");
    let (from, to) = (
        scene.camera.tetrad_from_camera(),
        aimed(&scene, Aim::Hole).unwrap(),
    );
    assert!(between_axes(from, to, 0.0).abs_diff_eq(from, 1e-12));
    assert!(between_axes(from, to, 1.0).abs_diff_eq(to, 1e-12));
    let mut last = from;
    for step in 1..=100 {
        let axes = between_axes(from, to, f64::from(step) / 100.0);
        // Half a turn in a hundred steps, at most 1.5 times the mean speed.
        assert!((axes - last).to_cols_array().iter().all(|x| x.abs() < 0.05));
        assert!((axes * axes.transpose()).abs_diff_eq(DMat3::IDENTITY, 1e-12));
        last = axes;
    }
}

#[test]
fn the_orbit_camera_goes_round_at_the_same_radius_always_facing_the_hole() {
    for (spin, kind, r) in [
        (0.0, ObserverKind::Static, 20.0),
        (0.9, ObserverKind::Zamo, 1.2),
        (0.0, ObserverKind::Orbit, 6.0),
        (-0.5, ObserverKind::Rain, 3.0),
    ] {
        let mut scene = placed(spin, kind, r, 90.0);
        for frame in 0..600 {
            let around = DVec2::new(0.02, if frame < 300 { 0.011 } else { -0.013 });
            let step = OrbitStep {
                roll: 0.0,
                around,
                rise: 0.0,
                time: 0.0,
            };
            scene = orbited(&scene, &step).unwrap().scene;
            assert_eq!(scene.camera.r, r);
            assert_ne!(scene.observer.kind, ObserverKind::Orbit);
            let hole = ApparentHole::new(&scene).unwrap();
            assert!(hole.from_camera(&scene).z > 1.0 - 1e-12);
            // The camera's right is along the circle of latitude, and no place is a pole.
            assert!((1.0..=179.0).contains(&scene.camera.theta_deg));
            let right = scene.camera.tetrad_from_camera().x_axis;
            assert!(right.y.abs() < 1e-9, "{right}");
        }
    }
    let step = OrbitStep {
        roll: 0.0,
        around: DVec2::ZERO,
        rise: -1.0,
        time: 1.0,
    };
    let near = orbited(&preset("2"), &step).unwrap().scene;
    assert!((10.0..20.0).contains(&near.camera.r), "{}", near.camera.r);
    let inside = placed(0.0, ObserverKind::Rain, 0.5, 80.0);
    let held = orbited(&inside, &step).unwrap();
    assert_eq!(held.stopped_by, Some(Barrier::Horizon));
    assert_eq!(held.scene.camera, inside.camera);
}

#[test]
fn the_orbit_camera_keeps_the_roll_that_the_hand_gives_it() {
    let mut scene = placed(0.9, ObserverKind::Zamo, 6.0, 70.0);
    let level = aimed(&scene, Aim::Hole).unwrap();
    let mut facing = scene.scene().clone();
    facing.camera.set_orientation(level);
    scene = Drawable::new(facing).unwrap();
    for frame in 0..100 {
        let step = OrbitStep {
            around: DVec2::new(0.02, 0.005),
            rise: 0.1,
            time: 0.01,
            roll: if frame < 50 { 0.01 } else { 0.0 },
        };
        scene = orbited(&scene, &step).unwrap().scene;
    }
    let level = aimed(&scene, Aim::Hole).unwrap();
    let axes = scene.camera.tetrad_from_camera();
    assert!(axes.z_axis.dot(level.z_axis) > 1.0 - 1e-12);
    // Clockwise: the camera's up leans to its right.
    let [cos, sin] = [axes.y_axis.dot(level.y_axis), axes.y_axis.dot(level.x_axis)];
    assert!((sin.atan2(cos) - 0.5).abs() < 1e-9, "{sin} {cos}");
}

#[test]
fn the_zoom_keys_stay_between_5_and_120_degrees_and_leave_wider_views_alone() {
    let zoomed = |fov_deg, power| {
        let camera = Camera {
            fov_deg,
            ..Camera::default()
        };
        zoomed(&camera, power).unwrap()
    };
    assert!((zoomed(50.0, 0.0) - 50.0).abs() < 1e-12);
    assert!(zoomed(50.0, 0.1) > 50.0 && zoomed(50.0, -0.1) < 50.0);
    assert_eq!((zoomed(50.0, 9.0), zoomed(50.0, -9.0)), (120.0, 5.0));
    assert_eq!(zoomed(150.0, 1.0), 150.0);
    assert!(zoomed(150.0, -0.1) < 150.0);
    assert_eq!(zoomed(0.1, -1.0), 0.1);
}
