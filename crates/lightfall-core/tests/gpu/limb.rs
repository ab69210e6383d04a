//! Cosines of emission in the shader, against those in f64.

use crate::gpu;
use crate::light::light_from;
use glam::DVec2;
use lightfall_core::gpu::kernel::uniform;
use lightfall_core::gpu::{GpuScene, Variant, bindings};
use lightfall_core::optics::limb::{Limb, electron_scattering};
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{LimbDarkening, Method, Scene};

/// The emission cosine and the darkening of the first hit of the ray from a direction.
const SEEN: &str =
    "vec4<f32>(emission_cosine(photon_from(given.xyz), trace(photon_from(given.xyz)).hits[0]),
    limb_darkening(photon_from(given.xyz), trace(photon_from(given.xyz)).hits[0]), 0.0, 0.0)";

fn scene(method: Method, spin: f64) -> Scene {
    let mut scene = Scene {
        method,
        ..Scene::default()
    };
    (scene.hole.spin, scene.disk.follow_isco) = (spin, true);
    (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (20.0, 83.0, 50.0);
    scene.disk.limb = LimbDarkening::ElectronScattering;
    scene
}

#[test]
#[ignore = "needs a graphics adapter"]
fn limb_cosines_of_emission_agree_with_those_in_f64_whatever_effects_are_off() {
    // Places whose cosines two other computations give; the physics tests compare the ones in f64.
    let pixels = [
        [200.5, 300.5],
        [760.5, 300.5],
        [480.5, 150.5],
        [430.5, 190.5],
        [600.5, 215.5],
        [300.5, 240.5],
        [480.5, 380.5],
    ];
    for (method, spin) in [(Method::Closed, 0.0), (Method::Mino, 0.9)] {
        for effects_off in 0..8 {
            let mut scene = scene(method, spin);
            scene.observer.velocity = [0.01, 0.02, -0.03];
            scene.effects.lensing = effects_off & 1 == 0;
            scene.effects.doppler = effects_off & 2 == 0;
            scene.effects.gravitational_shift = effects_off & 4 == 0;
            let reference = Reference::new(&scene).unwrap();
            let limb = Limb::new(&scene);
            let size = scene.picture.size().as_dvec2();
            let directions = pixels.map(|[x, y]| {
                let looking = scene.camera.looking(DVec2::new(x, y), size);
                scene.camera.tetrad_from_camera() * looking
            });
            let uniforms = [(
                bindings::SCENE,
                uniform(&GpuScene::for_rays(&scene).unwrap()),
            )];
            let source = Variant::picture(&scene).source();
            let given = directions.iter().map(|d| d.as_vec3().extend(0.0));
            let mut compared = 0;
            for (direction, seen) in
                directions
                    .iter()
                    .zip(light_from(gpu(), &source, SEEN, &uniforms, given))
            {
                let Some(hit) = reference.trace(*direction).hits[0] else {
                    continue;
                };
                let mu = limb.cosine(&reference.photon(*direction), hit.r).unwrap();
                // What f32 and the method's own error leave of a cosine.
                let error = (f64::from(seen.x) - mu).abs();
                assert!(error < 1e-4, "{method:?} {effects_off}: {seen} for {mu}");
                // The root is steep where mu is small.
                let error = (f64::from(seen.y) - electron_scattering(mu)).abs();
                assert!(error < 1e-4, "{method:?} {effects_off}: {seen} for {mu}");
                compared += 1;
            }
            assert!(compared >= 2, "only {compared} places are seen");
        }
    }
}

#[test]
fn limb_darkening_that_is_off_is_not_in_the_shader() {
    let mut scene = scene(Method::Closed, 0.0);
    assert!(
        Variant::picture(&scene)
            .source()
            .contains("fn emission_cosine")
    );
    scene.disk.limb = LimbDarkening::None;
    assert!(
        !Variant::picture(&scene)
            .source()
            .contains("fn emission_cosine")
    );
}
