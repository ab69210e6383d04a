//! Pictures of random scenes, drawn by the whole chain: no pixel of the linear light is infinite or
//! not a number, no channel of an EXR is infinite, and none is missing but where its ray has no such value.

use super::random::Random;
use super::random_scene::{SKIES, random_scene};
use exr::prelude::f16;
use lightfall_core::scene::Scene;
use lightfall_picture::{Channels, HeadlessOptions, PixelRays, Studio};
use std::collections::HashMap;

/// Random scenes, each with shaders of its own to compile.
const SCENES: usize = 24;
const SIZE: [u32; 2] = [96, 54];

/// A random scene as a small picture, with bloom and means of frames where they matter.
fn random_picture(random: &mut Random) -> Scene {
    let mut scene = random_scene(random, &SKIES).scene().clone();
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
        let depth = studio.depth().unwrap();
        let samples = rays.sample(&scene, &channels, &depth).unwrap();
        let named: HashMap<&str, Vec<f32>> = channels
            .list()
            .iter()
            .map(|channel| channel.old_name)
            .zip(samples)
            .collect();
        for pixel in 0..light.rgba.len() {
            if let Some(what) = data_fault(&named, pixel) {
                fault(pixel, what);
            }
        }
    }
    let all = SCENES * (SIZE[0] * SIZE[1]) as usize;
    assert!(5 * lit > all, "{lit} of {all} pixels show light");
}

/// What is wrong with a pixel's data. A missing value is NaN: the sky of a ray that does not reach it,
/// every number of a hit that a ray does not have, and its time at or inside the horizon. The depth is
/// infinite without a foreground.
fn data_fault(named: &HashMap<&str, Vec<f32>>, pixel: usize) -> Option<String> {
    let number = |name: &str| f64::from(named[name][pixel]);
    for name in named.keys() {
        let value = number(name);
        if value.is_infinite() && *name != "depth" {
            return Some(format!("{name} is {value}"));
        }
    }
    let reaches_sky = number("outcome") == 0.0;
    for (names, is_present) in [
        (&["sky.x", "sky.y", "sky.z"][..], reaches_sky),
        (
            &["hit1.phi", "hit1.g", "hit1.T"],
            !number("hit1.r").is_nan(),
        ),
        (
            &["hit2.phi", "hit2.g", "hit2.T"],
            !number("hit2.r").is_nan(),
        ),
        (&["residual", "depth"], true),
    ] {
        for name in names {
            if number(name).is_nan() == is_present {
                return Some(format!("{name} is {}, present: {is_present}", number(name)));
            }
        }
    }
    let is_orphan = number("hit1.r").is_nan() && !number("hit2.r").is_nan();
    is_orphan.then(|| "a second hit without a first".into())
}
