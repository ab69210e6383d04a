//! Projections in f64, against pairs of pixels and directions that an independent program computed,
//! and solid angles against closed forms.

use crate::projection_pairs::{Pair, pairs};
use glam::{DVec2, DVec3};
use lightfall_core::optics::apparent_hole::dark_share;
use lightfall_core::optics::exposure::metered_exposure;
use lightfall_core::scene::{Camera, CubeLayout, Projection, Scene};
use std::f64::consts::PI;

/// A camera with this projection and field of view.
fn camera(projection: Projection, field_deg: f64) -> Camera {
    let mut camera = Camera {
        projection,
        ..Scene::default().camera
    };
    camera.set_field_deg(field_deg);
    camera
}

/// The pairs have nine decimals. An inverse that is right to f64 is off by what those leave: less than
/// 2e-3 pixels, except where a picture shows one direction at many places, which are compared as
/// directions.
#[test]
fn directions_and_places_are_those_of_an_independent_program() {
    let mut counts = [0; 2];
    for pair in pairs() {
        let Pair { size, place, .. } = pair;
        let camera = camera(pair.projection, pair.angle_deg);
        let name = format!("{} {place}", pair.projection.word());
        let side = size.x / 3.0;
        let (seen, back) = match pair.projection {
            Projection::Cube => {
                let layout = CubeLayout::THREE_BY_TWO;
                let seen = layout.looking(place, side).unwrap();
                (seen, layout.pixel_of(pair.looking, side))
            }
            _ => {
                let seen = camera.looking(place, size);
                (
                    seen,
                    camera.pixel_of(pair.looking, size).unwrap_or_default(),
                )
            }
        };
        assert_eq!(
            camera.coverage(place, size) >= 0.5,
            pair.is_inside || pair.projection == Projection::Cube,
            "{name}"
        );
        counts[usize::from(pair.is_inside)] += 1;
        if !pair.is_inside {
            continue;
        }
        assert!(seen.distance(pair.looking) < 1e-6, "{name}: {seen}");
        let is_pole =
            pair.projection == Projection::Equirectangular && pair.looking.y.abs() > 0.999_999;
        if is_pole {
            assert!(camera.looking(back, size).distance(pair.looking) < 1e-6);
        } else {
            assert!(back.distance(place) < 2e-3, "{name}: {back}");
        }
    }
    assert_eq!(counts, [2, 48]);
}

/// Sums over whole pictures against the solid angle of a pyramid, of a cap, and of the sphere. Those
/// over rows and circles of pixels are off by the width of a pixel, squared.
#[test]
fn solid_angles_of_pixels_add_up_to_those_of_the_pictures() {
    let sum = |camera: &Camera, size: DVec2| -> f64 {
        let pixels = 0..(size.x * size.y) as usize;
        let places = pixels.map(|i| {
            let columns = size.x as usize;
            DVec2::new((i % columns) as f64, (i / columns) as f64) + 0.5
        });
        places
            .map(|place| camera.coverage(place, size) * camera.solid_angle(place, size))
            .sum()
    };
    let half = DVec2::new(16.0 / 9.0, 1.0) * 30_f64.to_radians().tan();
    let [x, y] = half.to_array();
    // Of a pyramid over a rectangle (Van Oosterom & Strackee 1983).
    let pyramid = 4.0 * (x * y / ((1.0 + x * x) * (1.0 + y * y)).sqrt()).asin();
    let square = DVec2::splat(720.0);
    let cases = [
        (
            camera(Projection::Perspective, 60.0),
            DVec2::new(640.0, 360.0),
            pyramid,
        ),
        (
            camera(Projection::Perspective, 90.0),
            square,
            4.0 * PI / 6.0,
        ),
        (camera(Projection::Fisheye, 180.0), square, 2.0 * PI),
        (camera(Projection::Fisheye, 360.0), square, 4.0 * PI),
        (
            camera(Projection::Equirectangular, 0.0),
            DVec2::new(720.0, 360.0),
            4.0 * PI,
        ),
    ];
    for (camera, size, exact) in cases {
        let error = sum(&camera, size) / exact - 1.0;
        println!("{}: {error:.1e}", camera.projection.word());
        assert!(error.abs() < 1e-4, "{}: {error}", camera.projection.word());
    }
}

/// A shift by (a, b) heights shows at each place what the picture without it shows that much farther
/// to the left and down.
#[test]
fn a_shift_moves_the_line_of_sight() {
    let size = DVec2::new(300.0, 200.0);
    for projection in [Projection::Perspective, Projection::Fisheye] {
        let plain = Camera {
            projection,
            ..Scene::default().camera
        };
        let shifted = Camera {
            shift: [0.25, 0.1],
            ..plain
        };
        let moved = DVec2::new(0.25, -0.1) * size.y;
        for place in [DVec2::new(150.0, 100.0), DVec2::new(31.5, 160.0)] {
            let seen = shifted.looking(place + moved, size);
            assert!(seen.distance(plain.looking(place, size)) < 1e-12);
            let back = shifted.pixel_of(seen, size).unwrap();
            assert!(back.distance(place + moved) < 1e-9);
        }
        assert!(shifted.looking(shifted.axis(size), size).distance(DVec3::Z) < 1e-15);
        assert_eq!(plain.pixel_angle(size), shifted.pixel_angle(size));
    }
}

/// With a tilt of 60 degrees the hole, straight ahead of the flight, is 60 degrees below the line of
/// sight, so 30 degrees above the front of a dome's spring line, which is 90 degrees below.
#[test]
fn a_tilt_turns_the_picture_and_not_the_flight() {
    let mut camera = Scene::default().camera;
    let heading = camera.heading();
    camera.tilt_deg = 60.0;
    assert_eq!(camera.heading(), heading);
    let hole = camera.tetrad_from_camera().transpose() * heading.z_axis;
    let exact = DVec3::new(0.0, -60_f64.to_radians().sin(), 60_f64.to_radians().cos());
    assert!(hole.distance(exact) < 1e-12, "{hole}");
    // Turning the flight to axes leaves the tilt.
    let (mut turned, axes) = (camera, heading * glam::DMat3::from_rotation_x(0.3));
    turned.set_orientation(axes);
    assert!(
        (turned.heading() - axes)
            .abs()
            .to_cols_array()
            .into_iter()
            .fold(0.0, f64::max)
            < 1e-12
    );
    assert_eq!(turned.tilt_deg, 60.0);
}

/// Inside a circle of 360 degrees and in a picture of the whole sky the same light is seen, so the
/// meter chooses nearly the same exposure, although rows near the poles fill half of one of them. Its
/// few rays meet the disk at other places: 0.3 is what turns of the camera by a degree change.
#[test]
fn the_light_meter_weighs_light_by_its_solid_angle() {
    let exposure = |projection, fisheye_deg, size: [u32; 2]| {
        let mut scene = lightfall_core::scene::presets::PRESETS[1]
            .scene(&[])
            .unwrap();
        scene.picture.automatic_exposure = true;
        (scene.camera.projection, scene.camera.fisheye_deg) = (projection, fisheye_deg);
        [scene.picture.width, scene.picture.height] = size;
        metered_exposure(&scene).unwrap().unwrap()
    };
    let whole = exposure(Projection::Equirectangular, 180.0, [512, 256]);
    let circle = exposure(Projection::Fisheye, 360.0, [256, 256]);
    let beside = exposure(Projection::Fisheye, 360.0, [1024, 256]);
    println!("{whole} {circle} {beside}");
    assert!((whole - circle).abs() < 0.3, "{whole} {circle}");
    // What lies beside the circle does not count.
    assert_eq!(circle, beside);
}

/// A circle that the picture cuts off entirely shows nothing, and nothing hangs or panics.
#[test]
fn a_circle_beside_its_picture_is_dark_and_metered_as_nothing() {
    let mut scene = Scene::default();
    scene.camera.projection = Projection::Fisheye;
    scene.camera.shift = [10.0, 10.0];
    scene.picture.automatic_exposure = true;
    assert_eq!(dark_share(&scene).unwrap(), 0.0);
    assert_eq!(metered_exposure(&scene).unwrap(), None);
    assert!(
        !scene
            .camera
            .shows(DVec3::Z, scene.picture.size().as_dvec2())
    );
}

/// Each side of a cube is a perspective picture of its own camera: the same directions as the layout
/// says, in all of both layouts' sides.
#[test]
fn the_sides_of_a_cube_are_perspective_pictures() {
    let mut scene = Scene::default();
    scene.camera.projection = Projection::Cube;
    (
        scene.camera.yaw_deg,
        scene.camera.pitch_deg,
        scene.camera.tilt_deg,
    ) = (20.0, 10.0, 15.0);
    let own = scene.camera.tetrad_from_camera();
    for layout in [CubeLayout::THREE_BY_TWO, CubeLayout::COLUMN] {
        for (number, side) in layout.sides.iter().enumerate() {
            let scene = scene.cube_side(side, 64);
            let size = scene.picture.size().as_dvec2();
            for place in [
                DVec2::splat(0.5),
                DVec2::new(40.0, 10.0),
                DVec2::splat(63.5),
            ] {
                let corner = layout.corner(number as u32).as_dvec2() * 64.0;
                let whole = own * layout.looking(corner + place, 64.0).unwrap();
                let axes = scene.camera.tetrad_from_camera();
                let seen = axes * scene.camera.looking(place, size);
                assert!(seen.distance(whole) < 1e-9, "{} {place}", side.name);
                let back = layout.pixel_of(own.transpose() * whole, 64.0);
                assert!(back.distance(corner + place) < 1e-6);
            }
        }
    }
}
