//! Tilted disks in whole pictures: the sky stays where it is, and the disk is the one that a camera
//! sees that is moved with everything but the hole.

use super::moved_camera::Twin;
use super::plain;
use lightfall_core::scene::{Method, Scene, SkyMode, presets};
use lightfall_picture::render;

/// A small picture of the article's preset by this method, with a tilted disk.
fn tilted(method: Method, mode: SkyMode) -> Scene {
    let mut scene = presets::find("article").unwrap().scene(&[]).unwrap();
    (scene.method, scene.sky.mode) = (method, mode);
    (scene.disk.tilt_deg, scene.disk.node_deg) = (40.0, 100.0);
    (scene.picture.width, scene.picture.height) = (320, 180);
    (scene.picture.grid_width, scene.picture.grid_height) = (320, 180);
    scene
}

/// The share of the pixels whose levels differ by more than a tenth of white, and that of the pixels
/// that shine.
fn differing(scene: Scene, other: Scene) -> [f64; 2] {
    let [a, b] = [scene, other].map(|scene| {
        let (scene, size) = plain(scene);
        render(&scene, size).unwrap().rgb
    });
    let pixels = a.chunks_exact(3).zip(b.chunks_exact(3));
    let differs = pixels
        .filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 25))
        .count();
    let lit = b
        .chunks_exact(3)
        .filter(|p| p.iter().any(|level| *level > 25));
    [differs, lit.count()].map(|count| count as f64 / (a.len() / 3) as f64)
}

/// Directions are rounded to 6e-8, which moves the steep edges of stars and lines a little, and stars
/// next to the shadow's edge more.
#[test]
#[ignore = "needs a graphics adapter"]
fn every_sky_stays_where_it_is_when_the_disk_is_tilted() {
    for (method, mode) in [
        (Method::Closed, SkyMode::Stars),
        (Method::Mino, SkyMode::Stars),
        (Method::Verlet, SkyMode::Procedural),
        (Method::Closed, SkyMode::Grid),
    ] {
        let mut scene = tilted(method, mode);
        (scene.disk.enabled, scene.picture.exposure_ev) = (false, 4.0);
        let mut level = scene.clone();
        level.disk.tilt_deg = 0.0;
        let [differs, lit] = differing(scene, level);
        assert!(
            lit > 0.02,
            "{method:?} {mode:?}: {lit} of the picture shines"
        );
        assert!(differs < 0.003, "{method:?} {mode:?}: {differs} differ");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_tilted_disk_is_drawn_as_by_a_camera_that_is_moved_and_rolled_instead() {
    for method in [Method::Closed, Method::Verlet] {
        let scene = tilted(method, SkyMode::Off);
        let mut level = scene.clone();
        level.disk.tilt_deg = 0.0;
        let twin = Twin::of(&scene).scene;
        let [differs, lit] = differing(scene, twin.clone());
        assert!(lit > 0.1, "{method:?}: {lit} of the picture shines");
        assert!(differs < 0.003, "{method:?}: {differs} differ");
        let [differs, _] = differing(level, twin);
        assert!(differs > 0.1, "{method:?}: the tilt changes the picture");
    }
}
