//! From a pixel to a direction: the camera's axes, its rotations, and the shader's arithmetic.

use crate::{bare_hole, gpu};
use glam::{DMat3, DVec3, UVec2, Vec4};
use lightfall_core::geometry::observer::observer_matrix;
use lightfall_core::gpu::kernel::{ArrayKernel, uniform};
use lightfall_core::gpu::{GpuScene, Variant, bindings};
use lightfall_core::scene::{Camera, Frame, ObserverKind, Scene};

#[test]
fn an_unrotated_camera_looks_at_the_hole_with_decreasing_theta_up_and_increasing_phi_to_the_right()
{
    let expected = DMat3::from_cols(DVec3::Z, DVec3::NEG_Y, DVec3::NEG_X);
    assert_eq!(Camera::default().tetrad_from_camera(), expected);
}

#[test]
fn a_camera_turns_right_then_up_then_clockwise() {
    let turned = |yaw_deg, pitch_deg, roll_deg| {
        Camera {
            yaw_deg,
            pitch_deg,
            roll_deg,
            ..Camera::default()
        }
        .tetrad_from_camera()
    };
    let [right, up, forward] = [DVec3::Z, DVec3::NEG_Y, DVec3::NEG_X];
    // Quarter turns are exact, so that a camera looks exactly in the direction of its angles.
    assert_eq!(
        turned(90.0, 0.0, 0.0),
        DMat3::from_cols(-forward, up, right)
    );
    assert_eq!(
        turned(0.0, 90.0, 0.0),
        DMat3::from_cols(right, -forward, up)
    );
    assert_eq!(
        turned(0.0, 0.0, 90.0),
        DMat3::from_cols(-up, right, forward)
    );
    assert_eq!(
        turned(90.0, 90.0, 0.0),
        DMat3::from_cols(-forward, -right, up)
    );
    assert_eq!(
        turned(-180.0, 360.0, -360.0),
        DMat3::from_cols(-right, up, -forward)
    );
    // Every rotation keeps the axes orthogonal and their handedness; f64 rounds a few times.
    let axes = turned(33.0, -71.0, 158.0);
    assert!((axes.transpose() * axes).abs_diff_eq(DMat3::IDENTITY, 1e-15));
    assert!((axes.determinant() + 1.0).abs() < 1e-15);
    // A yaw and a pitch of 30 degrees look half a unit up.
    let forward_now = turned(30.0, 30.0, 77.0).z_axis;
    assert!(
        (forward_now - (0.75 * forward + 0.5 * up + 0.75_f64.sqrt() * 0.5 * right)).length()
            < 1e-15
    );
}

/// A hole that a turned camera sees from a fast observer.
fn turned_and_fast() -> Scene {
    let mut scene = bare_hole(3.0);
    (
        scene.camera.yaw_deg,
        scene.camera.pitch_deg,
        scene.camera.roll_deg,
    ) = (20.0, -35.0, 10.0);
    (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Rain, [0.1, 0.2, -0.3]);
    scene
}

/// The shader's photons at these places of the part of a frame that is drawn, in pixels: energy and
/// radial momentum, then w.
fn photons(scene: &Scene, frame: &Frame, places: &[(f32, f32)]) -> Vec<[Vec4; 2]> {
    let gpu = gpu();
    let source = Variant::picture(scene).source()
        + "@group(0) @binding(BINDING_INPUT) var<storage, read> pixels: array<vec4<f32>>;
           @group(0) @binding(BINDING_OUTPUT) var<storage, read_write> photons: array<mat2x4<f32>>;
           @compute @workgroup_size(WORKGROUP_SIZE) fn photons_of(@builtin(global_invocation_id) id: vec3<u32>) {
               if id.x < arrayLength(&pixels) {
                   let place = pixels[id.x].xy;
                   let in_whole = corner_of(vec2<u32>(place)) + fract(place);
                   let photon = photon_from(pixel_direction(in_whole));
                   photons[id.x] = mat2x4<f32>(vec4(photon.energy, photon.radial, 0.0, 0.0), vec4(photon.w, 0.0));
               }
           }";
    let numbers = GpuScene::new(scene, frame).unwrap();
    let kernel = ArrayKernel::new(
        gpu,
        &source,
        "photons_of",
        &[(bindings::SCENE, uniform(&numbers))],
    )
    .unwrap();
    let pixels: Vec<Vec4> = places
        .iter()
        .map(|(x, y)| Vec4::new(*x, *y, 0.0, 0.0))
        .collect();
    kernel.run(gpu, &pixels).unwrap()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_part_of_a_picture_has_the_rays_of_the_whole_picture_at_its_place() {
    let scene = turned_and_fast();
    let whole = Frame::of(&scene).with_whole(UVec2::new(640, 360));
    let part = Frame {
        origin: UVec2::new(128, 200),
        size: UVec2::new(64, 48),
        ..whole
    };
    let places = [(0.5, 0.5), (63.5, 0.5), (20.5, 47.5), (31.5, 12.5)];
    let in_whole = places.map(|(x, y)| (x + 128.0, y + 200.0));
    // The places are exact in f32, so that the same arithmetic follows.
    assert_eq!(
        photons(&scene, &part, &places),
        photons(&scene, &whole, &in_whole)
    );
    assert_ne!(
        photons(&scene, &part, &places),
        photons(&scene, &whole, &places)
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_shader_and_the_observers_matrix_give_the_same_photon_for_a_pixel() {
    let scene = turned_and_fast();
    let frame = Frame::of(&scene).with_whole(UVec2::new(640, 360));
    let places = [
        (0.0, 0.0),
        (640.0, 0.0),
        (0.0, 360.0),
        (320.0, 180.0),
        (100.5, 300.5),
    ];
    let photons = photons(&scene, &frame, &places);

    let Camera {
        r,
        theta_deg,
        phi_deg,
        fov_deg,
        ..
    } = scene.camera;
    let (theta, phi) = (theta_deg.to_radians(), phi_deg.to_radians());
    let matrix = observer_matrix(
        0.0,
        ObserverKind::Rain,
        scene.observer.velocity,
        r,
        theta,
        phi,
    )
    .unwrap();
    let tan_half = (fov_deg.to_radians() / 2.0).tan();
    for (place, [head, w]) in places.iter().zip(photons) {
        let [x, y] = [f64::from(place.0) / 640.0, f64::from(place.1) / 360.0];
        let direction = DVec3::new(
            (2.0 * x - 1.0) * tan_half * 16.0 / 9.0,
            (1.0 - 2.0 * y) * tan_half,
            1.0,
        );
        let photon = matrix.photon(scene.camera.tetrad_from_camera() * direction.normalize());
        let found = [head.x, head.y, w.x, w.y, w.z].map(f64::from);
        let truth = [
            photon.energy,
            photon.radial,
            photon.w.x,
            photon.w.y,
            photon.w.z,
        ];
        for (found, truth) in found.into_iter().zip(truth) {
            // A few f32 roundings of numbers of the order of one.
            assert!(
                (found - truth).abs() < 1e-6,
                "place {place:?}: {found} against {truth}"
            );
        }
    }
}
