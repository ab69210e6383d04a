//! Matter with depth on the GPU: its light against the converged f64 twin.

use crate::light::light_from;
use crate::{ALONG, gpu, pixel_directions, quantile};
use lightfall_core::gpu::kernel::uniform;
use lightfall_core::gpu::{GpuScene, Inputs, Variant, bindings};
use lightfall_core::optics::medium::{Medium, Tolerance};
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{ObserverKind, Scene, SkyMode};

/// A scene with a thick disk and nothing behind it.
fn thick(spin: f64, [r, theta_deg]: [f64; 2], thickness: f64, depth: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (r, theta_deg, 50.0);
    scene.observer.kind = ObserverKind::Static;
    scene.disk.follow_isco = true;
    (scene.disk.thickness, scene.disk.depth) = (thickness, depth);
    (scene.disk.outer, scene.disk.edge_taper) = (11.0, 0.2);
    scene.sky.mode = SkyMode::Off;
    scene
}

/// The errors of the light of lit pixels, relative to the larger of the pixel's light and 1 % of the
/// picture's 95th percentile.
fn errors(scene: &Scene) -> Vec<f64> {
    let source = Variant::timed_light(scene).source();
    let mut uniforms = Inputs::new(scene).declared_in(&source);
    uniforms.push((
        bindings::SCENE,
        uniform(&GpuScene::for_rays(scene).unwrap()),
    ));
    let directions = pixel_directions(scene, 96, 54);
    let given = directions
        .iter()
        .map(|direction| direction.as_vec3().extend(0.0));
    let found = light_from(gpu(), &source, ALONG, &uniforms, given);
    let reference = Reference::new(scene).unwrap();
    let medium = Medium::of(scene, 8).unwrap();
    let tolerance = Tolerance {
        relative: 1e-6,
        end_depth: 20.0,
    };
    let truth: Vec<f64> = directions
        .iter()
        .map(|direction| {
            let photon = reference.photon(direction.normalize());
            medium.seen(&photon, tolerance).light.max_element()
        })
        .collect();
    let lit: Vec<f64> = truth.iter().copied().filter(|light| *light > 0.0).collect();
    let floor = 0.01 * quantile(&lit, 0.95);
    let pairs = found.into_iter().zip(truth);
    pairs
        .filter(|(found, truth)| *truth > 0.0 || found.max_element() > 0.0)
        .map(|(found, truth)| {
            let found = f64::from(found.truncate().max_element());
            (found - truth).abs() / truth.max(floor)
        })
        .collect()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn four_nodes_hold_the_promised_error() {
    for (spin, camera, thickness, depth) in [
        (0.9, [20.0, 83.0], 0.06, 12.0),
        (0.9, [20.0, 60.0], 0.1, 3.0),
        (0.9, [6.5, 80.0], 0.06, 12.0),
        (0.0, [20.0, 83.0], 0.05, 200.0),
    ] {
        for max_error in [0.1, 0.02, 0.005, 0.0005] {
            let mut scene = thick(spin, camera, thickness, depth);
            scene.quality.max_error_light = max_error;
            let errors = errors(&scene);
            println!(
                "{spin} {camera:?} {thickness} {depth} {max_error}: {} lit; {:.1e} {:.1e} {:.1e}",
                errors.len(),
                quantile(&errors, 0.5),
                quantile(&errors, 0.95),
                quantile(&errors, 0.99)
            );
        }
    }
}
