//! The night sky of the presets is black, and its Milky Way stands out.

use crate::preset;
use glam::{DVec2, UVec2};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::{Scene, presets};
use lightfall_picture::{Still, render};

const SIZE: UVec2 = UVec2::new(160, 90);
/// The lightest level that the darkest tenth of a preset's sky may have, of 255: a screen's black to
/// the eye.
const MAX_NIGHT: u8 = 6;

/// The scene as a small picture, pixel by pixel.
fn small(mut scene: Scene) -> Scene {
    (scene.picture.width, scene.picture.height) = (SIZE.x, SIZE.y);
    (scene.picture.grid_width, scene.picture.grid_height) = (SIZE.x, SIZE.y);
    scene.picture.bypass = true;
    scene
}

/// Levels of the brightest channel where a picture shows the sky alone, darkest first.
fn sky_levels(scene: &Scene, still: &Still) -> Vec<u8> {
    let reference = Reference::new(scene).unwrap();
    let axes = scene.camera.tetrad_from_camera();
    let pixels = still.rgb.chunks_exact(3).enumerate();
    let mut levels: Vec<u8> = pixels
        .filter_map(|(number, rgb)| {
            let (x, y) = (number as u32 % SIZE.x, number as u32 / SIZE.x);
            let pixel = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let trace = reference.trace(axes * scene.camera.looking(pixel, SIZE.as_dvec2()));
            let is_sky = trace.outcome == Outcome::Sky && trace.hits.iter().all(Option::is_none);
            is_sky.then(|| rgb.iter().copied().max().unwrap_or(0))
        })
        .collect();
    levels.sort_unstable();
    levels
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_darkest_tenth_of_the_sky_of_every_preset_is_black() {
    let mut grey = Vec::new();
    for number in 1..=presets::PRESETS.len() {
        let scene = small(preset(number));
        let still = render(&scene, SIZE).unwrap();
        let levels = sky_levels(&scene, &still);
        // Each of them shows the sky in a tenth of the picture or more.
        assert!(10 * levels.len() > still.rgb.len() / 3, "preset {number}");
        let night = levels[levels.len() / 10];
        println!("preset {number}: {night} of 255");
        if night > MAX_NIGHT {
            grey.push((number, night));
        }
    }
    assert!(grey.is_empty(), "presets and levels: {grey:?}");
}

/// A picture without hole and disk toward a right ascension and a declination.
fn toward(ra_deg: f64, dec_deg: f64) -> Still {
    let mut scene = small(preset(13));
    scene.effects.lensing = false;
    (scene.camera.r, scene.camera.yaw_deg, scene.camera.fov_deg) = (1e5, 0.0, 20.0);
    (scene.sky.ra_deg, scene.sky.dec_deg) = (ra_deg, dec_deg);
    // Without stars that are points.
    scene.sky.magnitude_limit = -2.0;
    render(&scene, SIZE).unwrap()
}

/// Mean light of the three channels, from sRGB's levels.
fn mean_rgb(still: &Still) -> [f64; 3] {
    let linear = |level: u8| (f64::from(level) / 255.0).powf(2.2);
    let mut sums = [0.0; 3];
    for rgb in still.rgb.chunks_exact(3) {
        for (sum, level) in sums.iter_mut().zip(rgb) {
            *sum += linear(*level);
        }
    }
    sums.map(|sum| sum / f64::from(SIZE.x * SIZE.y))
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_milky_way_has_the_colours_of_its_photographs() {
    let [pole, bulge, carina, cygnus, orion] = [
        (192.9, 27.1),
        (269.0, -31.0),
        (161.2, -59.7),
        (314.8, 44.5),
        (83.8, -5.4),
    ]
    .map(|(ra, dec)| mean_rgb(&toward(ra, dec)));
    println!("pole {pole:.4?}, bulge {bulge:.4?}, Carina {carina:.4?}, Cygnus {cygnus:.4?}");
    // The bulge is warm, and more than ten times as bright as the pole.
    assert!(bulge[0] > 1.3 * bulge[2] && bulge[1] > 10.0 * pole[1]);
    // Where the catalogues of nebulae have one, red is more than the stars' light gives: their
    // green is nearer to red.
    for [r, g, b] in [carina, cygnus, orion] {
        assert!(r > 1.2 * g && r > 1.1 * b, "{r}, {g}, {b}");
    }
}
