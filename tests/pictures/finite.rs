//! Pictures of random scenes, drawn by the whole chain: no pixel of the linear light is infinite or
//! not a number, and no channel of an EXR is infinite.

use super::random::Random;
use super::random_scene::random_scene;
use exr::prelude::f16;
use lightfall::picture::{Channels, HeadlessOptions, PixelRays, Samples, Studio};
use lightfall_core::scene::{Scene, SkyMode};

/// Random scenes, each with shaders of its own to compile.
const SCENES: usize = 24;
const SIZE: [u32; 2] = [96, 54];

/// A random scene as a small picture, with bloom and means of frames where they matter.
fn random_picture(random: &mut Random) -> Scene {
    let mut scene = random_scene(random, &SkyMode::ALL).scene().clone();
    [scene.picture.width, scene.picture.height] = SIZE;
    [scene.picture.grid_width, scene.picture.grid_height] = SIZE;
    scene.picture.samples = random.of(&[1, 1, 3]);
    scene.picture.antialias = random.one_in(2);
    scene.probe.enabled = random.one_in(4);
    scene
}

fn place(pixel: usize) -> [usize; 2] {
    let width = SIZE[0] as usize;
    [pixel % width, pixel / width]
}

#[test]
#[ignore = "needs a graphics adapter"]
fn no_pixel_of_random_pictures_is_infinite_or_not_a_number() {
    let mut random = Random::new();
    let options = HeadlessOptions {
        light: true,
        ..HeadlessOptions::default()
    };
    let first = random_picture(&mut random);
    let mut studio = Studio::with_options(&first, SIZE.into(), options).unwrap();
    let mut rays = PixelRays::open().unwrap();
    let channels: Channels = "all".parse().unwrap();
    let mut lit = 0;
    for number in 0..SCENES {
        let scene = random_picture(&mut random);
        let fault = |pixel: usize, what: String| {
            let [x, y] = place(pixel);
            panic!(
                "scene {number}, pixel {x}, {y}: {what}\n{}",
                scene.to_preset()
            )
        };
        studio.show(&scene).unwrap();
        let light = studio.light().unwrap();
        assert_eq!(light.size.to_array(), SIZE);
        for (pixel, rgba) in light.rgba.iter().enumerate() {
            let rgba = rgba.map(f16::from_bits);
            if !rgba.iter().all(|channel| channel.is_finite()) {
                fault(pixel, format!("{rgba:?}"));
            }
            lit += usize::from(rgba[..3].iter().any(|channel| *channel > f16::ZERO));
        }
        // Missing values are NaN there, and the depth of the sky is infinite.
        let depth = studio.depth().unwrap();
        let samples = rays.sample(&scene, &channels, &depth).unwrap();
        for (channel, samples) in channels.list().iter().zip(samples) {
            let Samples::Numbers(numbers) = samples else {
                continue;
            };
            for (pixel, value) in numbers.iter().enumerate() {
                let may_be_infinite = channel.name == "depth";
                let may_be_missing = channel.name != "depth" && channel.name != "residual";
                if value.is_infinite() && !may_be_infinite || value.is_nan() && !may_be_missing {
                    fault(pixel, format!("{} is {value}", channel.name));
                }
            }
        }
    }
    let all = SCENES * (SIZE[0] * SIZE[1]) as usize;
    assert!(5 * lit > all, "{lit} of {all} pixels show light");
}
