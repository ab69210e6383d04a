//! What the GPU cannot do, and the errors that say so.

use crate::edge_on;
use glam::UVec2;
use lightfall_core::gpu::kernel::ArrayKernel;
use lightfall_core::gpu::timing::{Stage, Stopwatch};
use lightfall_core::gpu::{GpuError, GpuScene};
use lightfall_core::scene::{Method, ObserverKind, Scene};

fn refusal(change: fn(&mut Scene)) -> String {
    let mut scene = Scene::default();
    change(&mut scene);
    GpuScene::for_rays(&scene).unwrap_err().to_string()
}

#[test]
fn a_method_without_spin_refuses_a_spinning_hole() {
    let sentence = "hole.spin = 0.9 is refused: holes without spin are all that verlet can trace, so it must be 0 \
                    (methods auto, closed, mino and kerr-schild trace any spin)";
    let found = refusal(|scene| (scene.method, scene.hole.spin) = (Method::Verlet, 0.9));
    assert_eq!(found, sentence);
}

#[test]
fn the_reference_is_refused_on_the_gpu() {
    let sentence = "method = \"reference\" is refused: it runs on the CPU only, with `trace --device cpu`, so here it must be auto, verlet, \
         closed, mino or kerr-schild";
    assert_eq!(refusal(|scene| scene.method = Method::Reference), sentence);
}

#[test]
fn an_impossible_observer_is_refused_with_the_observers_own_reason() {
    let sentence = refusal(|scene| {
        scene.observer.kind = ObserverKind::Orbit;
        scene.camera.theta_deg = 80.0;
    });
    assert!(sentence.starts_with("camera.theta_deg is 80"), "{sentence}");
}

#[test]
fn the_message_about_a_missing_driver_names_the_packages_to_install() {
    let sentence = GpuError::NoAdapter.to_string();
    assert!(
        sentence.contains("libvulkan1") && sentence.contains("mesa-vulkan-drivers"),
        "{sentence}"
    );
    // A wrong adapter name is no reason to install a driver.
    let named = GpuError::UnknownAdapter {
        given: "zzz".into(),
        adapters: vec!["0: llvmpipe".into()],
    }
    .to_string();
    assert!(
        named.contains("zzz") && named.contains("--list-gpus") && named.contains("llvmpipe"),
        "{named}"
    );
    assert!(!named.contains("libvulkan1"), "{named}");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_shader_that_does_not_compile_is_an_error_and_no_panic() {
    let gpu = crate::gpu();
    let error = gpu
        .shader("broken", "fn broken() -> f32 { return true; }")
        .unwrap_err();
    assert!(matches!(error, GpuError::Shader(_)), "{error}");
}

/// The entry point is missing, but the text is valid: nothing is wrong with the shader.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_pipeline_that_the_device_refuses_is_not_called_a_shader_that_does_not_compile() {
    let text = "@compute @workgroup_size(64) fn there() {}";
    let error = ArrayKernel::new(crate::gpu(), text, "missing", &[]).unwrap_err();
    assert!(matches!(error, GpuError::Invalid(_)), "{error}");
}

/// 16 GiB: Vulkan states the limit of a storage buffer in 32 bits, so no device allows as much.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_picture_that_needs_too_large_a_buffer_is_refused_with_the_devices_limit() {
    let size = UVec2::splat(1 << 15);
    let timed = Stopwatch::new(crate::gpu(), &edge_on(), size, Stage::Compute);
    let Err(GpuError::TooLarge { bytes, limit, .. }) = timed else {
        panic!("{:?}", timed.err())
    };
    assert_eq!(bytes, 16 << 30);
    assert!(limit < bytes);
}
