//! What the GPU cannot do, and the sentence that says so.

use lightfall_core::gpu::{GpuError, GpuScene};
use lightfall_core::scene::{Method, ObserverKind, Scene};

fn refusal(change: fn(&mut Scene)) -> String {
    let mut scene = Scene::default();
    change(&mut scene);
    GpuScene::for_rays(&scene).unwrap_err().to_string()
}

#[test]
fn a_spinning_hole_is_refused_by_a_method_that_knows_none() {
    let sentence = "hole.spin = 0.9 is refused: methods verlet and closed trace holes without spin only, so it must be 0 \
                    (methods auto, mino and kerr-schild trace any spin)";
    for method in [Method::Verlet, Method::Closed] {
        let mut scene = Scene {
            method,
            ..Scene::default()
        };
        scene.hole.spin = 0.9;
        assert_eq!(
            GpuScene::for_rays(&scene).unwrap_err().to_string(),
            sentence
        );
    }
}

#[test]
fn the_reference_is_refused_on_the_gpu() {
    let sentence = "method = \"reference\" is refused: it runs on the CPU only, so here it must be auto, verlet, \
         closed, mino or kerr-schild";
    assert_eq!(refusal(|scene| scene.method = Method::Reference), sentence);
}

#[test]
fn an_observer_that_cannot_be_is_refused_in_its_own_words() {
    let sentence = refusal(|scene| {
        scene.observer.kind = ObserverKind::Orbit;
        scene.camera.theta_deg = 80.0;
    });
    assert!(sentence.starts_with("camera.theta_deg is 80"), "{sentence}");
}

#[test]
fn a_missing_driver_is_told_with_the_packages_that_help() {
    let sentence = GpuError::NoAdapter.to_string();
    assert!(
        sentence.contains("libvulkan1") && sentence.contains("mesa-vulkan-drivers"),
        "{sentence}"
    );
    // An adapter that is only called otherwise needs no driver.
    let named = GpuError::UnknownAdapter {
        given: "zzz".into(),
        names: vec!["llvmpipe".into()],
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
