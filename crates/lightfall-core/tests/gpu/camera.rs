//! From a pixel to a direction: the camera's axes, its rotations, and the shader's arithmetic.

use crate::{bare_hole, gpu};
use glam::{DMat3, DVec3, UVec2, Vec4};
use lightfall_core::geometry::observer::observer_matrix;
use lightfall_core::gpu::kernel::{Kernel, uniform};
use lightfall_core::gpu::{GpuScene, Variant, bindings};
use lightfall_core::scene::{Camera, ObserverKind};

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

#[test]
#[ignore = "needs a graphics adapter"]
fn the_shader_and_the_observers_matrix_give_the_same_photon_for_a_pixel() {
    let gpu = gpu();
    let mut scene = bare_hole(3.0);
    (
        scene.camera.yaw_deg,
        scene.camera.pitch_deg,
        scene.camera.roll_deg,
    ) = (20.0, -35.0, 10.0);
    (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Rain, [0.1, 0.2, -0.3]);
    let size = UVec2::new(640, 360);
    let source = Variant::picture(&scene).source()
        + "@group(0) @binding(BINDING_INPUT) var<storage, read> pixels: array<vec4<f32>>;
           @group(0) @binding(BINDING_OUTPUT) var<storage, read_write> photons: array<mat2x4<f32>>;
           @compute @workgroup_size(WORKGROUP_SIZE) fn photons_of(@builtin(global_invocation_id) id: vec3<u32>) {
               if id.x < arrayLength(&pixels) {
                   let photon = photon_from(pixel_direction(pixels[id.x].xy));
                   photons[id.x] = mat2x4<f32>(vec4(photon.energy, photon.radial, 0.0, 0.0), vec4(photon.w, 0.0));
               }
           }";
    let numbers = GpuScene::new(&scene, size).unwrap();
    let kernel = Kernel::new(
        gpu,
        &source,
        "photons_of",
        &[(bindings::SCENE, uniform(&numbers))],
    )
    .unwrap();
    let pixels: Vec<Vec4> = [
        (0.0, 0.0),
        (640.0, 0.0),
        (0.0, 360.0),
        (320.0, 180.0),
        (100.5, 300.5),
    ]
    .map(|(x, y)| Vec4::new(x, y, 0.0, 0.0))
    .to_vec();
    let photons: Vec<[Vec4; 2]> = kernel.run(gpu, &pixels).unwrap();

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
    for (pixel, [head, w]) in pixels.iter().zip(photons) {
        let [x, y] = [f64::from(pixel.x) / 640.0, f64::from(pixel.y) / 360.0];
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
                "pixel {pixel}: {found} against {truth}"
            );
        }
    }
}
