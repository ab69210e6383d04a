//! Animated pictures, read back by another decoder.

use super::Drawer;
use super::linear::{program, small};
use glam::UVec2;
use image::codecs::png::PngDecoder;
use image::{AnimationDecoder, Frame, ImageDecoder, Rgba, metadata::LoopCount};
use lightfall_core::scene::resized;
use lightfall_core::scene::{DiskStructure, Scene};
use std::fs::File;
use std::io::BufReader;

const SIZE: UVec2 = UVec2::new(160, 90);

/// An edge-on disk that repeats after 12 r_s/c, which are six frames of an animation.
fn repeating() -> Scene {
    let mut scene = small(2);
    scene.picture.automatic_exposure = false;
    scene.disk.structure = DiskStructure::Turbulent;
    (scene.disk.time, scene.disk.rate, scene.disk.period) = (3.0, 40.0, 12.0);
    scene
}

/// The pixels of the still at the time of a frame.
fn still(drawer: &mut Drawer, scene: &Scene, frame: u32) -> Vec<u8> {
    let mut then = scene.clone();
    then.picture = resized(&then.picture, SIZE);
    then.disk.time += then.disk.rate * f64::from(frame) / 20.0;
    drawer.draw(&then, SIZE).rgb
}

fn rgb(frame: &Frame) -> Vec<u8> {
    let pixels = frame.buffer().pixels();
    pixels.flat_map(|Rgba([r, g, b, _])| [*r, *g, *b]).collect()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn an_animation_repeats_for_ever_and_shows_the_still_of_every_frames_time() {
    let (folder, scene) = (tempfile::tempdir().unwrap(), repeating());
    program(
        folder.path(),
        &scene,
        "--journey none --frames 0..5 --fps 20 --size 160x90 -o disk.apng",
    );
    let decoder = || {
        let file = File::open(folder.path().join("disk.apng")).unwrap();
        PngDecoder::new(BufReader::new(file)).unwrap()
    };
    assert_eq!(decoder().dimensions(), (SIZE.x, SIZE.y));
    let animation = decoder().apng().unwrap();
    assert!(matches!(animation.loop_count(), LoopCount::Infinite));
    let frames = animation.into_frames().collect_frames().unwrap();
    assert_eq!(frames.len(), 6);
    let mut drawer = Drawer::default();
    for (number, frame) in (0..).zip(&frames) {
        assert_eq!(frame.delay().numer_denom_ms(), (50, 1), "frame {number}");
        assert!(
            rgb(frame) == still(&mut drawer, &scene, number),
            "frame {number}"
        );
    }
    // A viewer that knows no animations shows the first frame.
    let file = folder.path().join("disk.png");
    std::fs::rename(folder.path().join("disk.apng"), &file).unwrap();
    let first = image::open(&file).unwrap().to_rgb8().into_raw();
    assert!(first == rgb(&frames[0]));
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_frame_after_the_last_one_of_a_period_is_the_first() {
    let scene = repeating();
    let mut drawer = Drawer::default();
    let [first, half, again] = [0, 3, 6].map(|frame| still(&mut drawer, &scene, frame));
    let unlike = |other: &[u8]| {
        let differ = first.iter().zip(other).filter(|(a, b)| a != b).count();
        differ as f64 / first.len() as f64
    };
    // The clock's rounding moves a few values across the border of a level.
    assert!(unlike(&again) < 0.002, "{}", unlike(&again));
    assert!(unlike(&half) > 0.1, "{}", unlike(&half));
}
