//! The light of random scenes, before the picture's shader bounds it: every number of it is finite.

use crate::gpu;
use crate::light::light_from;
use crate::random::Random;
use crate::random_scene::random_scene;
use glam::{UVec2, Vec4};
use lightfall_core::gpu::kernel::uniform;
use lightfall_core::gpu::timing::light_tables;
use lightfall_core::gpu::{GpuScene, Variant, bindings};
use lightfall_core::scene::SkyMode;

/// Random scenes, each with a shader of its own to compile.
const SCENES: usize = 60;
const SIZE: UVec2 = UVec2::new(96, 54);

/// The skies that a compute entry draws without textures; pictures of the program show the others.
const SKIES: [SkyMode; 3] = [SkyMode::Procedural, SkyMode::Grid, SkyMode::Off];

#[test]
#[ignore = "needs a graphics adapter"]
fn the_light_of_every_pixel_of_random_scenes_is_finite_and_not_negative() {
    let mut random = Random::new();
    let mut lit = 0;
    for number in 0..SCENES {
        let scene = random_scene(&mut random, &SKIES);
        let scene = scene.scene();
        let variant = Variant::timed_light(scene);
        let numbers = GpuScene::new(scene, SIZE).unwrap();
        let mut uniforms = light_tables(variant, scene);
        uniforms.push((bindings::SCENE, uniform(&numbers)));
        let pixels = (0..SIZE.y).flat_map(|y| (0..SIZE.x).map(move |x| UVec2::new(x, y)));
        let places = pixels
            .clone()
            .map(|pixel| (pixel.as_vec2() + 0.5).extend(0.0).extend(0.0));
        let lights = light_from(
            gpu(),
            &variant.source(),
            "light_at(given.xy)",
            &uniforms,
            places,
        );
        for (pixel, light) in pixels.zip(lights) {
            assert!(
                light.is_finite() && light.min_element() >= 0.0,
                "scene {number}, pixel {pixel}: {light}\n{}",
                scene.to_preset()
            );
            lit += usize::from(light.truncate() != Vec4::ZERO.truncate());
        }
    }
    // A fifth of all pixels shows light, so there was something to look at.
    let all = SCENES * (SIZE.x * SIZE.y) as usize;
    assert!(5 * lit > all, "{lit} of {all} pixels show light");
}
