//! Projections in tiles, against the same pictures drawn at once, and the light of bloom at the seam of
//! a picture of the whole sky.

use super::tiles::{check_scene, scene};
use exr::prelude::f16;
use glam::UVec2;
use lightfall_core::scene::{Projection, Scene, SkyMode};
use lightfall_picture::{HeadlessOptions, PngBits, Studio};

fn projected(number: usize, projection: Projection, size: UVec2) -> Scene {
    let mut scene = scene(number, size);
    scene.camera.projection = projection;
    scene
}

/// The disk and the hole lie on the seam, because the camera looks away from them. Some tiles are as wide
/// as the picture: they have columns of its other side at both of their sides.
#[test]
#[ignore = "needs a graphics adapter"]
fn tiles_of_the_whole_sky_have_the_light_and_levels_of_the_whole_picture() {
    let size = UVec2::new(480, 240);
    let tiles = [
        UVec2::new(128, 64),
        UVec2::new(96, 112),
        UVec2::new(480, 100),
    ];
    for (number, samples) in [(2, 1), (2, 4), (9, 1)] {
        let mut scene = projected(number, Projection::Equirectangular, size);
        scene.camera.yaw_deg += 180.0;
        scene.picture.samples = samples;
        let name = format!("whole sky of {number} with {samples} samples");
        check_scene(&name, &scene, &tiles);
    }
}

/// The circle is not in the middle, so that some tiles are within it, some at its edge and some outside.
#[test]
#[ignore = "needs a graphics adapter"]
fn tiles_of_a_dome_have_the_light_and_levels_of_the_whole_picture() {
    let size = UVec2::new(320, 240);
    for (number, fisheye_deg) in [(2, 180.0), (9, 360.0)] {
        let mut scene = projected(number, Projection::Fisheye, size);
        (scene.camera.fisheye_deg, scene.camera.tilt_deg) = (fisheye_deg, 30.0);
        (scene.camera.shift, scene.camera.circle) = ([0.2, 0.05], 0.9);
        let tiles = [UVec2::new(128, 64), UVec2::new(96, 112)];
        check_scene(&format!("dome of {number}"), &scene, &tiles);
    }
}

const WIDTH: u32 = 512;

/// The green levels of a picture of the whole sky in which only some pixels of the middle rows shine,
/// from this column on.
fn glow(studio: &mut Studio, first: u32) -> Vec<u16> {
    let shines = |x: u32, y: u32| y / 8 == 16 && (x + WIDTH - first) % WIDTH < 4;
    let pixels = (0..WIDTH * WIDTH / 2).map(|number| (number % WIDTH, number / WIDTH));
    let light = pixels.flat_map(|(x, y)| {
        let light = if shines(x, y) { 50.0 } else { 0.0 };
        [light, light, light, 1.0].map(|value| f16::from_f32(value).to_bits().to_le_bytes())
    });
    studio.give_light(Some(light.flatten().collect()));
    let levels = studio.levels().unwrap().rgb;
    levels.into_iter().skip(1).step_by(3).collect()
}

/// Half a turn of the camera moves all columns by half of the width, which is a whole number of texels in
/// every level of the bloom. What is left is the noise of the rounding, one level, and the fractions in
/// which a sampler counts the place between two texels: a graphics card has 256 steps, so that a hundredth
/// of the light is a generous bar. Without a way around the edge there is no light on its other side.
#[test]
#[ignore = "needs a graphics adapter"]
fn bloom_goes_around_the_whole_sky() {
    let size = UVec2::new(WIDTH, WIDTH / 2);
    let mut scene = projected(2, Projection::Equirectangular, size);
    (scene.disk.enabled, scene.sky.mode) = (false, SkyMode::Off);
    scene.picture.automatic_exposure = false;
    (scene.picture.bloom, scene.picture.antialias) = (0.5, false);
    let options = HeadlessOptions {
        levels: Some(PngBits::Sixteen.top()),
        ..HeadlessOptions::default()
    };
    let mut studio = Studio::with_options(&scene, UVec2::ONE, options).unwrap();
    let at_edge = glow(&mut studio, 2);
    let in_middle = glow(&mut studio, 2 + WIDTH / 2);
    let row = 16 * 8 + 4;
    let at = |levels: &[u16], x: u32| f64::from(levels[(row * WIDTH + x % WIDTH) as usize]);
    for x in 0..WIDTH {
        let (edge, middle) = (at(&at_edge, x), at(&in_middle, x + WIDTH / 2));
        assert!(
            (edge - middle).abs() <= 0.01 * middle + 2.0,
            "column {x}: {edge} and {middle}"
        );
    }
    // There is light on the other side of the edge, and it fades.
    let beyond = [1, 20, 200].map(|off| at(&at_edge, WIDTH - off));
    println!("{beyond:?}");
    assert!(beyond[0] > 2.0 * beyond[1] && beyond[1] > 2.0 * beyond[2]);
}
