//! Stars as points: where they show, and when their passes run.

use super::preset;
use lightfall_core::scene::{Method, Scene, SkyMode};
use lightfall_picture::{HeadlessOptions, Studio, render};

/// A small picture of a preset at a fixed exposure.
fn small(number: usize) -> Scene {
    let mut scene = preset(number);
    scene.picture.automatic_exposure = false;
    (scene.picture.width, scene.picture.height) = (480, 270);
    (scene.picture.grid_width, scene.picture.grid_height) = (480, 270);
    scene
}

/// The scene with its disk hidden and so few stars that even those of a hole with spin are found
/// fast: some hundred.
fn few_stars(mut scene: Scene) -> Scene {
    (scene.disk.enabled, scene.sky.magnitude_limit) = (false, 4.5);
    scene
}

#[test]
#[ignore = "needs a graphics adapter"]
fn what_the_probe_covers_shows_no_star() {
    let mut scene = small(6);
    // A large one, which covers many stars.
    (scene.disk.enabled, scene.probe.size) = (false, 2.0);
    // Behind a smooth edge a star shines through the samples that the probe does not cover.
    scene.probe.antialias = false;
    let options = HeadlessOptions {
        light: true,
        ..HeadlessOptions::default()
    };
    let mut studio = Studio::with_options(&scene, scene.picture.size(), options).unwrap();
    let covered: Vec<bool> = studio
        .depth()
        .unwrap()
        .iter()
        .map(|depth| depth.is_finite())
        .collect();
    let mut light = |scene: &Scene| {
        studio.show(scene).unwrap();
        let pixels = studio.light().unwrap().rgba.into_iter().zip(&covered);
        pixels
            .filter_map(|(pixel, covered)| covered.then_some(pixel))
            .collect::<Vec<_>>()
    };
    for antialias in [false, true] {
        scene.picture.antialias = antialias;
        let (mut dark, mut bare) = (scene.clone(), scene.clone());
        dark.sky.mode = SkyMode::Off;
        bare.probe.enabled = false;
        // The same pixels without the probe: what lies behind it are stars. Those that are brighter
        // than four times the middle one of all pixels are points, not the Milky Way. Positive half
        // floats are in the order of their bits, and a step of the exponent is worth 1024.
        let mut behind: Vec<u16> = light(&bare).iter().map(|pixel| pixel[1]).collect();
        behind.sort_unstable();
        let middle = behind[behind.len() / 2];
        let points = behind.iter().filter(|bits| **bits > middle + 2048).count();
        assert!(points > 20, "only {points} pixels with stars are covered");
        assert!(
            light(&scene) == light(&dark),
            "antialias {antialias}: stars shine through the probe"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn two_runs_of_a_picture_with_stars_have_the_same_bytes() {
    for spin in [0.0, 0.9] {
        let mut scene = few_stars(small(2));
        (scene.hole.spin, scene.picture.exposure_ev) = (spin, 6.0);
        let draw = |scene: &Scene| render(scene, scene.picture.size()).unwrap().rgb;
        let first = draw(&scene);
        assert!(draw(&scene) == first, "spin {spin}");
        // A change of what belongs to the stars alone shows, so these bytes are those of stars.
        scene.sky.magnitude_limit = 0.0;
        assert!(draw(&scene) != first, "spin {spin}: no stars");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_change_of_the_exposure_alone_looks_for_no_star() {
    for spin in [0.0, 0.9] {
        let mut scene = few_stars(small(2));
        (scene.hole.spin, scene.picture.exposure_ev) = (spin, 0.0);
        let size = scene.picture.size();
        let mut studio = Studio::open(&scene, size).unwrap();
        let mut looks_for_stars = |scene: &Scene| {
            let passes = studio.passes_to_show(scene).unwrap();
            let fresh = render(scene, size).unwrap().rgb;
            assert!(
                studio.picture().unwrap().rgb == fresh,
                "another picture than a fresh one"
            );
            let ran = |name: &str| passes.iter().any(|pass| pass == name);
            (!passes.is_empty()).then(|| {
                assert!(ran("geodesic"), "nothing was drawn: {passes:?}");
                ran("stars")
            })
        };
        scene.camera.yaw_deg = 1.0;
        if looks_for_stars(&scene).is_none() {
            println!("skipped: the device has no timestamps");
            return;
        }
        // The camera turns: all images are found anew. So this test would see it.
        scene.camera.yaw_deg = 2.0;
        assert_eq!(looks_for_stars(&scene), Some(true), "spin {spin}");
        for exposure in [0.25, 1.0, -1.0] {
            scene.picture.exposure_ev = exposure;
            assert_eq!(
                looks_for_stars(&scene),
                Some(false),
                "spin {spin}, exposure {exposure}"
            );
        }
        // Sums are whole numbers of a unit of light, which follows the exposure in large steps.
        scene.picture.exposure_ev = 8.0;
        assert_eq!(looks_for_stars(&scene), Some(true), "spin {spin}, a step");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_picture_that_is_too_coarse_for_any_star_is_drawn_and_a_finer_one_has_its_stars_again() {
    for spin in [0.0, 0.9] {
        let mut scene = few_stars(small(2));
        (scene.hole.spin, scene.picture.exposure_ev) = (spin, 6.0);
        let mut coarse = scene.clone();
        (coarse.picture.width, coarse.picture.height) = (2, 1);
        (coarse.picture.grid_width, coarse.picture.grid_height) = (2, 1);
        let mut studio = Studio::open(&scene, scene.picture.size()).unwrap();
        let fine = studio.picture().unwrap().rgb;
        for (what, scene, wanted) in [("coarse", &coarse, None), ("fine", &scene, Some(&fine))] {
            studio.show(scene).unwrap();
            studio.settle().unwrap();
            let shown = studio.picture().unwrap().rgb;
            assert!(
                wanted.unwrap_or(&shown) == &shown,
                "spin {spin}, {what}: its stars are not as before"
            );
            assert!(
                shown.iter().any(|channel| *channel > 0),
                "spin {spin}, {what}: no light"
            );
        }
    }
}

/// Without spin the images of stars can be found by inversion, and by the mesh that a hole with spin
/// needs. Only images squeezed next to the shadow, which the mesh does not find, may differ.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_hole_without_spin_has_the_same_stars_in_whichever_way_they_are_found() {
    let mut scene = small(12);
    scene.hole.spin = 0.0;
    (scene.picture.antialias, scene.picture.bypass) = (false, true);
    let [inverted, meshed] = [Method::Closed, Method::Mino].map(|method| {
        scene.method = method;
        render(&scene, scene.picture.size()).unwrap().rgb
    });
    let differs = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 16);
    let pixels = inverted.chunks_exact(3).zip(meshed.chunks_exact(3));
    let share = pixels.clone().filter(differs).count() as f64 / pixels.len() as f64;
    println!("{share:.1e} of the pixels differ");
    // Stars show on a tenth of the pixels here; the edge of the shadow passes through half a percent.
    assert!(share < 2e-3, "{share}");
}
