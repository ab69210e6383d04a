//! Camera paths: what is written is read back, as USD by the numbers in its text and as CSV by the program.

use glam::DVec3;
use lightfall_core::geometry::sphere::wrap_degrees;
use lightfall_core::scene::camera_path::{COLUMNS, CameraPath};
use lightfall_core::scene::journey::{self, Journey, load_camera_path};
use lightfall_core::scene::{Camera, ObserverKind, Scene, presets};

/// What the issue asks of a path that is read back: places to 1e-6 r_s, angles to 1e-4 degrees.
const PLACE: f64 = 1e-6;
const ANGLE_DEG: f64 = 1e-4;

/// The scene of a frame, as `lightfall render` draws it.
fn frame(journey: &Journey, scene: &Scene, seconds: f64) -> Scene {
    let [mut first, mut next] = [scene.clone(), scene.clone()];
    journey.apply(0.0, &mut first);
    journey.apply(seconds, &mut next);
    journey.drive_clock([0.0, seconds], &first, &mut next);
    next
}

/// A flight with every turn, in a picture that is tilted and shifted, and over the hole's axis.
const TURNED: &str = r#"
[[keyframe]]
time = 0
r = 40
theta_deg = 100
phi_deg = 170
yaw_deg = -60
pitch_deg = -50
roll_deg = 10
fov_deg = 20
velocity = [0.1, -0.2, 0.3]
ease = "linear"
set = { camera.tilt_deg = 0, camera.shift = [0, 0] }
[[keyframe]]
time = 5
r = 3
theta_deg = 0
phi_deg = 600
yaw_deg = 90
pitch_deg = 80
roll_deg = 500
fov_deg = 120
velocity = [0, 0, -0.4]
set = { camera.tilt_deg = 60, camera.shift = [0.25, -0.5] }
"#;

/// Scenes of frames with their path: of the built-in journey, at rest and falling through the horizon of a
/// hole that spins, and of a flight with every turn. Ten frames a second.
fn flights() -> Vec<(Vec<Scene>, CameraPath)> {
    let default = journey::load("default.toml", journey::DEFAULT).unwrap();
    let turned = journey::load("turned.toml", TURNED).unwrap();
    let stage = default.stage().scene(&[]).unwrap();
    let mut falling = stage.clone();
    (falling.hole.spin, falling.observer.kind) = (0.9, ObserverKind::Rain);
    let other = presets::find("telescope").unwrap().scene(&[]).unwrap();
    let cases = [(&default, stage), (&default, falling), (&turned, other)];
    let flight = |(journey, scene): (&Journey, Scene)| {
        let frames = (10.0 * journey.duration) as u32;
        let mut path = CameraPath::new(10.0, 16.0 / 9.0);
        let scenes: Vec<Scene> = (0..=frames)
            .map(|number| frame(journey, &scene, f64::from(number) / 10.0))
            .collect();
        for (number, scene) in (0..).zip(&scenes) {
            path.add(number, scene);
        }
        (scenes, path)
    };
    cases.map(flight).into()
}

/// The place and the axes right, up, forward of a camera's picture, from the meaning of its angles: at first
/// it looks at the hole, right is growing phi, up is decreasing theta. Then it turns to the right, up,
/// clockwise, and up by the tilt.
fn expected(camera: &Camera) -> (DVec3, [DVec3; 3]) {
    let turn = |degrees: f64, from: DVec3, to: DVec3| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        (cos * from + sin * to, cos * to - sin * from)
    };
    let (theta, phi) = (camera.theta_deg.to_radians(), camera.phi_deg.to_radians());
    let outward = DVec3::new(
        theta.sin() * phi.cos(),
        theta.sin() * phi.sin(),
        theta.cos(),
    );
    let up = DVec3::new(
        -theta.cos() * phi.cos(),
        -theta.cos() * phi.sin(),
        theta.sin(),
    );
    let right = DVec3::new(-phi.sin(), phi.cos(), 0.0);
    let (forward, right) = turn(camera.yaw_deg, -outward, right);
    let (forward, up) = turn(camera.pitch_deg, forward, up);
    let (up, right) = turn(camera.roll_deg, up, right);
    let (forward, up) = turn(camera.tilt_deg, forward, up);
    (camera.r * outward, [right, up, forward])
}

/// Says that two directions are the same to within [`ANGLE_DEG`].
fn same_direction(a: DVec3, b: DVec3) {
    let angle = a.cross(b).length().atan2(a.dot(b)).to_degrees();
    assert!(angle < ANGLE_DEG, "{a} {b}: {angle} degrees");
}

/// The values of an attribute in USD's text, by their frames: every number of the line.
fn samples(text: &str, attribute: &str) -> Vec<(u32, Vec<f64>)> {
    let head = format!("{attribute}.timeSamples = {{\n");
    let (_, body) = text.split_once(&head).unwrap();
    let (body, _) = body.split_once('}').unwrap();
    let lines = body.lines().filter(|line| !line.trim().is_empty());
    lines
        .map(|line| {
            let (number, value) = line.trim().split_once(": ").unwrap();
            let numbers = value.split(['(', ')', ',', ' ']);
            let numbers = numbers.filter(|number| !number.is_empty());
            let numbers = numbers.map(|number| number.parse().unwrap());
            (number.parse().unwrap(), numbers.collect())
        })
        .collect()
}

fn value(text: &str, attribute: &str) -> String {
    let (_, after) = text.split_once(&format!("{attribute} = ")).unwrap();
    after.lines().next().unwrap().to_owned()
}

#[test]
fn a_camera_in_usd_has_the_places_axes_and_fields_of_view_of_the_pictures() {
    for (scenes, path) in flights() {
        let mut text = Vec::new();
        path.write_usd(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert!(text.starts_with("#usda 1.0\n"));
        assert_eq!(value(&text, "upAxis"), "\"Z\"");
        for key in ["timeCodesPerSecond", "framesPerSecond"] {
            assert_eq!(value(&text, key), "10");
        }
        assert_eq!(value(&text, "startTimeCode"), "0");
        let last = scenes.len() - 1;
        assert_eq!(value(&text, "endTimeCode"), last.to_string());
        let height: f64 = value(&text, "verticalAperture").parse().unwrap();
        let width: f64 = value(&text, "horizontalAperture").parse().unwrap();
        assert!((width / height - 16.0 / 9.0).abs() < 1e-12);
        let focal = samples(&text, "focalLength");
        let matrices = samples(&text, "matrix4d xformOp:transform");
        assert_eq!((focal.len(), matrices.len()), (scenes.len(), scenes.len()));
        for (index, scene) in scenes.iter().enumerate() {
            let camera = &scene.camera;
            let (number, matrix) = &matrices[index];
            assert_eq!(*number as usize, index);
            let row = |row: usize| DVec3::from_slice(&matrix[4 * row..4 * row + 3]);
            let last: Vec<f64> = (0..4).map(|row| matrix[4 * row + 3]).collect();
            assert_eq!((matrix.len(), last), (16, vec![0.0, 0.0, 0.0, 1.0]));
            let (place, [right, up, forward]) = expected(camera);
            assert!((row(3) - place).length() < PLACE, "{} {place}", row(3));
            same_direction(row(0), right);
            same_direction(row(1), up);
            // A camera in USD looks along -z.
            same_direction(-row(2), forward);
            assert!(
                (row(0).cross(row(1)).dot(row(2)) - 1.0).abs() < 1e-12,
                "right-handed"
            );
            let fov = 2.0 * (0.5 * height / focal[index].1[0]).atan().to_degrees();
            assert!((fov - camera.fov_deg).abs() < ANGLE_DEG, "{fov}");
        }
        let is_shifted = scenes.iter().any(|scene| scene.camera.shift != [0.0; 2]);
        assert_eq!(text.contains("ApertureOffset"), is_shifted);
        if is_shifted {
            // The line of sight is right of the middle where the film is moved to the left.
            let offsets = ["horizontalApertureOffset", "verticalApertureOffset"];
            let offsets = offsets.map(|attribute| samples(&text, attribute));
            for (index, scene) in scenes.iter().enumerate() {
                for (axis, offsets) in offsets.iter().enumerate() {
                    let moved = -height * scene.camera.shift[axis];
                    assert!((offsets[index].1[0] - moved).abs() < 1e-12);
                }
            }
        }
    }
}

fn csv(path: &CameraPath) -> String {
    let mut text = Vec::new();
    path.write_csv(&mut text).unwrap();
    String::from_utf8(text).unwrap()
}

/// The text with these columns only.
fn with_columns(text: &str, columns: &[&str]) -> String {
    let places: Vec<usize> = columns
        .iter()
        .map(|column| COLUMNS.iter().position(|name| name == column).unwrap())
        .collect();
    let line = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        let fields: Vec<&str> = places.iter().map(|place| fields[*place]).collect();
        fields.join(",") + "\n"
    };
    text.lines().map(line).collect()
}

#[test]
fn a_table_of_cameras_has_a_row_for_each_frame_with_the_columns_of_the_design() {
    let (scenes, path) = flights().remove(2);
    let text = csv(&path);
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some(
            "frame,time_s,r,theta_deg,phi_deg,yaw_deg,pitch_deg,roll_deg,fov_deg,x,y,z,qw,qx,qy,qz,observer,vx,vy,vz,\
             disk_time,exposure_ev"
        )
    );
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), scenes.len());
    let mut last_phi = None;
    for (index, (row, scene)) in rows.iter().zip(&scenes).enumerate() {
        assert_eq!(
            (row.len(), row[0]),
            (COLUMNS.len(), index.to_string().as_str())
        );
        let number = |column: usize| -> f64 { row[column].parse().unwrap() };
        assert_eq!(number(1), index as f64 / 10.0);
        assert_eq!(number(2), scene.camera.r);
        // Azimuths go on without a jump, whatever whole turns a scene leaves out.
        let phi = number(4);
        assert!(wrap_degrees(phi - scene.camera.phi_deg).abs() < 1e-9);
        assert!(last_phi.is_none_or(|last: f64| (phi - last).abs() < 180.0));
        last_phi = Some(phi);
        let (place, _) = expected(&scene.camera);
        assert!((DVec3::new(number(9), number(10), number(11)) - place).length() < PLACE);
        assert_eq!(row[16], scene.observer.kind.word());
    }
    assert!(last_phi.unwrap() > 590.0, "more than a turn");
}

#[test]
fn a_table_that_was_written_flies_the_same_journey() {
    for (scenes, path) in flights() {
        let again = load_camera_path("path.csv", &csv(&path), 10.0).unwrap();
        for (number, scene) in scenes.iter().enumerate() {
            // Frames of the same numbers, flown from a scene with another camera, observer and clock.
            let mut from = scene.clone();
            let tilt_deg = scene.camera.tilt_deg;
            let shift = scene.camera.shift;
            from.camera = Camera {
                tilt_deg,
                shift,
                ..Camera::default()
            };
            (from.observer.kind, from.disk.time) = (ObserverKind::Zamo, 77.0);
            from.picture.automatic_exposure = true;
            let there = frame(&again, &from, number as f64 / 10.0);
            let (a, b) = (&there.camera, &scene.camera);
            let near = |a: f64, b: f64| {
                assert!((a - b).abs() < 1e-9 * b.abs().max(1.0), "{number}: {a} {b}")
            };
            near(a.r, b.r);
            near(a.theta_deg, b.theta_deg);
            near(a.fov_deg, b.fov_deg);
            near(a.pitch_deg, b.pitch_deg);
            near(wrap_degrees(a.phi_deg - b.phi_deg), 0.0);
            near(wrap_degrees(a.yaw_deg - b.yaw_deg), 0.0);
            near(wrap_degrees(a.roll_deg - b.roll_deg), 0.0);
            assert_eq!(there.observer, scene.observer, "{number}");
            if scene.disk_moves() {
                near(there.disk.time, scene.disk.time);
            }
            assert_eq!(
                (there.picture.automatic_exposure, there.picture.exposure_ev),
                (false, scene.picture.exposure_ev)
            );
        }
    }
}

#[test]
fn places_and_quaternions_alone_give_the_same_places_and_axes() {
    for (scenes, path) in flights() {
        let text = with_columns(
            &csv(&path),
            &["frame", "x", "y", "z", "qw", "qx", "qy", "qz"],
        );
        let again = load_camera_path("path.csv", &text, 10.0).unwrap();
        for (number, scene) in scenes.iter().enumerate() {
            let mut there = scene.clone();
            (there.camera.r, there.camera.yaw_deg) = (99.0, 99.0);
            again.apply(number as f64 / 10.0, &mut there);
            let (place, axes) = expected(&scene.camera);
            let (found, found_axes) = expected(&there.camera);
            assert!(
                (found - place).length() < PLACE,
                "{number}: {found} {place}"
            );
            for (found, axis) in found_axes.into_iter().zip(axes) {
                same_direction(found, axis);
            }
            assert_eq!(
                there.camera.fov_deg, scene.camera.fov_deg,
                "it has no column"
            );
        }
    }
}

#[test]
fn a_path_of_places_looks_at_the_hole_and_counts_frames_at_the_rate_of_the_pictures() {
    let text = "# from another program\nframe, x, y, z\n\n24, 10, 0, 0\n48, 0, \"20\", 0\n";
    for fps in [24.0, 12.0] {
        let path = load_camera_path("path.csv", text, fps).unwrap();
        assert_eq!(path.duration, 48.0 / fps);
        // Until the first row, too.
        for (time, r, phi_deg) in [
            (0.0, 10.0, 0.0),
            (24.0 / fps, 10.0, 0.0),
            (48.0 / fps, 20.0, 90.0),
        ] {
            let mut scene = Scene::default();
            (scene.camera.yaw_deg, scene.camera.pitch_deg) = (30.0, 10.0);
            path.apply(time, &mut scene);
            let Camera {
                r: found,
                theta_deg,
                phi_deg: turned,
                ..
            } = scene.camera;
            let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
            assert!(near(found, r) && near(theta_deg, 90.0) && near(turned, phi_deg));
            assert_eq!(scene.camera.angles(), [0.0; 3]);
        }
    }
}

/// Between rows the camera does not rest at the first and the last one, as keyframes would make it do.
#[test]
fn a_path_at_a_constant_speed_keeps_it_between_its_rows() {
    let text = "time_s,r,theta_deg,phi_deg\n0,20,80,350\n1,20,81,360\n2,20,82,370\n3,20,83,380\n";
    let path = load_camera_path("path.csv", text, 30.0).unwrap();
    for step in 0..=30 {
        let time = f64::from(step) / 10.0;
        let mut scene = Scene::default();
        path.apply(time, &mut scene);
        assert!((scene.camera.theta_deg - 80.0 - time).abs() < 1e-12);
        assert!(wrap_degrees(scene.camera.phi_deg - 350.0 - 10.0 * time).abs() < 1e-9);
    }
}
