//! Journeys: where they lead, and that nothing jumps on the way.

use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::gpu::Drawable;
use lightfall_core::gpu::GpuScene;
use lightfall_core::scene::journey;
use lightfall_core::scene::journey::{Journey, Track, between};
use lightfall_core::scene::{ObserverKind, Scene};

fn default() -> Journey {
    journey::load("default.toml", journey::DEFAULT).unwrap()
}

fn preset() -> Scene {
    default().preset.unwrap().scene(&[]).unwrap()
}

fn at(journey: &Journey, time: f64, kind: ObserverKind) -> Scene {
    at_from(&preset(), journey, time, kind)
}

fn at_from(scene: &Scene, journey: &Journey, time: f64, kind: ObserverKind) -> Scene {
    let mut scene = scene.clone();
    scene.observer.kind = kind;
    journey.apply(time, &mut scene);
    scene
}

/// What a viewer sees move: ln r, the angles without whole turns, the field of view, the velocity.
fn numbers(scene: &Scene) -> Vec<f64> {
    let camera = scene.camera;
    let turns = [
        camera.phi_deg,
        camera.yaw_deg,
        camera.pitch_deg,
        camera.roll_deg,
    ]
    .map(f64::to_radians);
    let mut all = vec![
        camera.r.ln(),
        camera.theta_deg.to_radians(),
        camera.fov_deg.to_radians(),
    ];
    all.extend(turns.into_iter().flat_map(|turn| [turn.cos(), turn.sin()]));
    all.extend(scene.observer.velocity);
    all
}

/// Central differences of a millisecond, at every keyframe, which are at whole seconds, and in
/// between: accelerations stay within what a gentle flight has, so neither places nor speeds jump.
#[test]
fn the_default_journey_is_continuous_with_its_speed() {
    let journey = default();
    for kind in [ObserverKind::Static, ObserverKind::Rain] {
        let (h, preset) = (1e-3, preset());
        for step in 0..=(50.0 * journey.duration) as i32 {
            let time = f64::from(step) / 50.0;
            let [a, b, c] =
                [-h, 0.0, h].map(|d| numbers(&at_from(&preset, &journey, time + d, kind)));
            for ((a, b), c) in a.into_iter().zip(b).zip(c) {
                assert!((c - b).abs() < 0.6 * h, "jump at {time}: {b} {c}");
                let change = (c - 2.0 * b + a).abs();
                assert!(change < 1.0 * h * h, "kink at {time}: {change:e}");
            }
        }
    }
}

#[test]
fn the_default_journey_reaches_its_places_and_all_of_it_can_be_drawn() {
    let journey = default();
    assert_eq!(journey.duration, 132.0);
    for kind in [
        ObserverKind::Static,
        ObserverKind::Zamo,
        ObserverKind::Orbit,
        ObserverKind::Rain,
    ] {
        for step in 0..=1500 {
            let scene = at(&journey, journey.duration * f64::from(step) / 1500.0, kind);
            assert_eq!(scene.check(), Ok(()));
            GpuScene::for_rays(&scene).unwrap();
        }
    }
    let still = |time| at(&journey, time, ObserverKind::Static).camera;
    assert_eq!(still(0.0).r, 60.0_f64.ln().exp());
    let ends = [ObserverKind::Static, ObserverKind::Rain]
        .map(|kind| at(&journey, journey.duration, kind).camera.r);
    assert!((still(115.0).r - 1.14).abs() < 1e-12, "near the limit");
    assert!((ends[0] - 10.0).abs() < 1e-12, "out again");
    assert!((ends[1] - 0.5).abs() < 1e-12, "beyond it");
    let thetas: Vec<f64> = (0..132)
        .map(|time| still(f64::from(time)).theta_deg)
        .collect();
    assert!(thetas.iter().any(|theta| *theta < 35.0) && thetas.iter().any(|theta| *theta > 80.0));
    // Led along, a circular orbit is left.
    assert_eq!(
        at(&journey, 50.0, ObserverKind::Orbit).observer.kind,
        ObserverKind::Static
    );
    // Before and after, it stays at its ends.
    assert_eq!(
        at(&journey, -5.0, ObserverKind::Rain),
        at(&journey, 0.0, ObserverKind::Rain)
    );
    assert_eq!(
        at(&journey, 1e9, ObserverKind::Rain),
        at(&journey, journey.duration, ObserverKind::Rain)
    );
}

#[test]
fn a_falling_observer_passes_the_horizon_of_any_hole_without_winding() {
    let journey = default();
    for spin in [-0.9999, -0.9, -0.5, 0.3, 0.9, 0.998, 0.9999] {
        let kerr = Kerr { spin };
        let mut scene = preset();
        (scene.hole.spin, scene.observer.kind) = (spin, ObserverKind::Rain);
        assert_eq!(
            journey.check(&scene, 0.0, Drawable::new),
            Ok(()),
            "chi {spin}"
        );
        // Kerr's ingoing azimuth is the keyframes' own, less its lead at the beginning: as without
        // spin.
        let begin = kerr.ingoing_azimuth_lead(60.0).to_degrees();
        for step in 0..=3000 {
            let time = journey.duration * f64::from(step) / 3000.0;
            let camera = at_from(&scene, &journey, time, ObserverKind::Rain).camera;
            let plain = at(&journey, time, ObserverKind::Rain).camera;
            let outside = camera.r > kerr.horizon();
            let lead = if outside {
                kerr.ingoing_azimuth_lead(camera.r).to_degrees()
            } else {
                0.0
            };
            let off = (camera.phi_deg + lead - begin - plain.phi_deg).to_radians();
            assert!(
                off.sin().abs() < 1e-9 && off.cos() > 0.0,
                "chi {spin}, {time} s, r {}: {off}",
                camera.r
            );
        }
        assert!(
            at_from(&scene, &journey, journey.duration, ObserverKind::Rain)
                .camera
                .r
                < kerr.horizon()
        );
    }
}

#[test]
fn nothing_jumps_where_an_observer_begins_to_fall_or_stops() {
    let text = "[[keyframe]]\ntime = 0\nr = 9\nphi_deg = 10\nobserver = \"static\"\n[[keyframe]]\ntime = 10\nr = 3\n\
                observer = \"rain\"\n[[keyframe]]\ntime = 20\nr = 2\nphi_deg = 40\nobserver = \"zamo\"\n\
                [[keyframe]]\ntime = 30\nr = 5\nphi_deg = 60";
    let (journey, mut scene) = (journey::load("j.toml", text).unwrap(), preset());
    scene.hole.spin = 0.95;
    let phi = |time| {
        at_from(&scene, &journey, time, ObserverKind::Static)
            .camera
            .phi_deg
    };
    for change in [10.0, 20.0] {
        assert!(
            (phi(change + 1e-6) - phi(change - 1e-6)).abs() < 1e-4,
            "at {change} s"
        );
    }
    assert!(
        (phi(5.0) - 10.0) < phi(10.0) - 10.0 && (phi(30.0) - 60.0).abs() > 1.0,
        "the fall's lead is kept"
    );
}

#[test]
fn captions_appear_in_their_time_and_give_way_to_the_next() {
    let text = "[[keyframe]]\ntime = 10\n[[keyframe]]\ntime = 40\n[[caption]]\ntime = 12\ntext = \"One\"\n\
                [[caption]]\ntime = 16\nseconds = 3.5\ntext = \" Two \"";
    let journey = journey::load("j.toml", text).unwrap();
    let shown = |time: f64| {
        journey
            .caption_at(time)
            .map(|caption| caption.text.as_str())
    };
    for (time, text) in [
        (-1.0, None),
        (1.9, None),
        (2.0, Some("One")),
        // Six seconds unless the caption says so, but the next one comes after four.
        (5.9, Some("One")),
        (6.0, Some("Two")),
        (9.4, Some("Two")),
        (9.5, None),
        (1e9, None),
    ] {
        assert_eq!(shown(time), text, "{time} s");
    }
}

/// A reader of plain text needs about a second for 15 characters (200 words a minute), and the
/// picture has to be looked at too: captions are short, stay long enough, and leave pauses.
#[test]
fn the_captions_of_the_default_journey_leave_time_to_read_and_to_look() {
    let journey = default();
    assert!(journey.captions.len() >= 8 && !journey.title.is_empty());
    let mut free = 4.5;
    for caption in &journey.captions {
        let length = caption.text.chars().count() as f64;
        assert!(length <= 90.0, "{}: {length} characters", caption.text);
        assert!(caption.seconds >= length / 15.0 + 1.0, "{}", caption.text);
        assert!(caption.time >= free, "{} follows at once", caption.text);
        free = caption.time + caption.seconds + 1.0;
    }
    assert!(
        free - 1.0 <= journey.duration,
        "the last caption is cut off"
    );
}

#[test]
fn tracks_meet_their_points_and_never_overshoot() {
    let points = [
        (0.0, 1.0),
        (1.0, 5.0),
        (1.5, 5.0),
        (4.0, -2.0),
        (9.0, -2.5),
        (9.1, 7.0),
    ];
    let track = Track::through(&points).unwrap();
    for pair in points.windows(2) {
        let [(start, from), (end, to)] = [pair[0], pair[1]];
        assert!((track.at(start) - from).abs() < 1e-14 && (track.at(end) - to).abs() < 1e-14);
        let mut last = from;
        for i in 0..=1000 {
            let value = track.at(start + (end - start) * f64::from(i) / 1000.0);
            assert!(
                (value - last) * (to - from) >= -1e-13
                    && (from.min(to) - 1e-12..=from.max(to) + 1e-12).contains(&value)
            );
            last = value;
        }
    }
    assert_eq!(Track::through(&[]), None);
    assert_eq!(Track::through(&[(3.0, 2.0)]).unwrap().at(-7.0), 2.0);
    // A straight line in between is kept straight.
    let line = Track::through(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]).unwrap();
    assert!((line.at(1.3) - 1.3).abs() < 1e-14);
}

#[test]
fn the_way_to_the_start_is_short_and_gentle() {
    let (mut from, mut to) = (Scene::default().camera, Scene::default().camera);
    (from.r, from.phi_deg, to.r, to.phi_deg, to.yaw_deg) = (4.0, 170.0, 64.0, -170.0, 30.0);
    assert_eq!(between(&from, &to, 0.0), from);
    assert_eq!(between(&from, &to, 1.0), to);
    let half = between(&from, &to, 0.5);
    assert!(
        (half.r - 16.0).abs() < 1e-12
            && (half.phi_deg.abs() - 180.0).abs() < 1e-9
            && (half.yaw_deg - 15.0).abs() < 1e-12
    );
    let near = between(&from, &to, 1e-4);
    assert!((near.r - from.r).abs() < 1e-6, "it begins at rest");
}

#[test]
fn a_journey_sets_what_its_keyframes_name_and_leaves_the_rest() {
    let text = "schema = 1\ntitle = \"Fall\"\n[[keyframe]]\ntime = 10\nr = 8\nobserver = \"static\"\n[[keyframe]]\ntime = 14\n\
                r = 2\n[[keyframe]]\ntime = 15\nobserver = \"rain\"\nvelocity = [0.1, 0, 0]\nfov_deg = 90\nphi_deg = 725\n\
                rain = { r = 1.5, fov_deg = 80 }\n";
    let journey = journey::load("mine.toml", text).unwrap();
    assert_eq!((journey.title.as_str(), journey.duration), ("Fall", 5.0));
    let before = at(&journey, 2.0, ObserverKind::Zamo);
    assert!((before.camera.r - 4.0).abs() < 1e-12 && before.observer.kind == ObserverKind::Static);
    let after = at(&journey, 5.0, ObserverKind::Zamo);
    assert_eq!(
        (after.observer.kind, after.observer.velocity),
        (ObserverKind::Rain, [0.1, 0.0, 0.0])
    );
    assert_eq!((after.camera.fov_deg, after.camera.phi_deg), (80.0, 5.0));
    assert!(
        (after.camera.r - 1.5).abs() < 1e-12,
        "the value for an observer in free fall"
    );
    assert_eq!(after.camera.theta_deg, preset().camera.theta_deg);
}

#[test]
fn a_journey_may_name_the_preset_in_which_it_is_flown() {
    let keyframes = "[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 1\n";
    let preset_of = |line: &str| {
        let journey = journey::load("j.toml", &format!("{line}\n{keyframes}")).unwrap();
        journey.preset.map(|preset| preset.name)
    };
    assert_eq!(preset_of(""), None);
    for line in ["preset = \"falling\"", "preset = \"9\"", "preset = 9"] {
        assert_eq!(preset_of(line), Some("falling"), "{line}");
    }
    // Its captions speak of the disk, and its observer hovers.
    let preset = default().preset.unwrap().plain_scene();
    assert!(preset.disk.enabled && preset.observer.kind == ObserverKind::Static);
    assert_eq!(default().check(preset, 0.0, Drawable::new), Ok(()));
}

/// The middle of a track between two points at which it rests is their mean, by symmetry.
#[test]
fn a_journey_tilts_the_disk_and_turns_its_node_on_by_any_number_of_turns() {
    let text = "[[keyframe]]\ntime = 0\ndisk_tilt_deg = 10\ndisk_node_deg = 100\n\
                [[keyframe]]\ntime = 4\ndisk_tilt_deg = 70\ndisk_node_deg = 1000\n";
    let journey = journey::load("tilt.toml", text).unwrap();
    let tilt_at = |time: f64| {
        let mut scene = Scene::default();
        journey.apply(time, &mut scene);
        Drawable::new(scene.clone()).unwrap();
        (scene.disk.tilt_deg, scene.disk.node_deg)
    };
    assert_eq!(tilt_at(0.0), (10.0, 100.0));
    let (tilt, node) = tilt_at(2.0);
    // 550 degrees are 190, or -170.
    assert!((tilt - 40.0).abs() < 1e-9 && (node + 170.0).abs() < 1e-9);
    assert_eq!(tilt_at(4.0), (70.0, -80.0));
    // A journey that does not name them leaves both alone.
    let mut scene = Scene::default();
    (scene.disk.tilt_deg, scene.disk.node_deg) = (33.0, -200.0);
    default().apply(3.0, &mut scene);
    assert_eq!((scene.disk.tilt_deg, scene.disk.node_deg), (33.0, -200.0));
    // Where the hole spins, the journey is refused with the keyframe.
    let mut spinning = Scene::default();
    spinning.hole.spin = 0.5;
    let refused = journey
        .check(&spinning, 0.0, Drawable::new)
        .unwrap_err()
        .to_string();
    assert!(
        refused.starts_with("keyframe 1 (time = 0): disk.tilt_deg = 10 is refused"),
        "{refused}"
    );
}
