//! The layers of a picture's light: their sum is the picture, and their shares make a whole.

use super::linear::{Linear, linear, small};
use super::tiles::scene;
use glam::{DVec2, UVec2};
use lightfall_core::scene::{Projection, Scene, SkyMode};
use lightfall_picture::{
    Captured, Channels, ExrForm, HeadlessOptions, LargePicture, Linear as Picture, PictureError,
    Studio, Tiles, exposed, write_exr,
};
use std::fs;
use std::path::Path;

/// The layers with light.
pub(super) const LAYERS: [&str; 6] = [
    "light_sky",
    "light_stars",
    "light_hit1",
    "light_hit2",
    "light_volume",
    "light_probe",
];

/// Half floats have eleven bits, and a device may cut further ones off: every number is off by up to a
/// 1024th of itself, and the smallest ones by 2^-24.
fn rounding(largest: f64, numbers: usize) -> f64 {
    largest / 1024.0 + numbers as f64 * 2.0_f64.powi(-24)
}

/// Light beyond this may be cut off in the sum and not in the layers.
const MAX_LIGHT: f64 = 50_000.0;

/// The layers of a picture.
fn layers_of(picture: &Linear) -> Vec<&'static str> {
    let is_there = |layer: &&str| picture.has(&format!("{layer}.R"));
    LAYERS.into_iter().filter(is_there).collect()
}

/// A channel of each layer.
fn parts(picture: &Linear, channel: &str) -> Vec<Vec<f64>> {
    layers_of(picture)
        .into_iter()
        .map(|layer| picture.values(&format!("{layer}.{channel}")))
        .collect()
}

/// The sum of numbers of each pixel.
fn sum(parts: &[Vec<f64>]) -> Vec<f64> {
    let pixels = parts.first().map_or(0, Vec::len);
    (0..pixels)
        .map(|pixel| parts.iter().map(|part| part[pixel]).sum())
        .collect()
}

/// Asserts that the layers of a picture add up to it.
fn assert_adds_up(name: &str, picture: &Linear) {
    for (channel, whole) in ["R", "G", "B"].into_iter().zip(picture.light()) {
        let parts = parts(picture, channel);
        let sums = sum(&parts);
        assert_eq!(sums.len(), whole.len(), "{name}");
        for (pixel, (sum, whole)) in sums.into_iter().zip(whole).enumerate() {
            // Two roundings: that of the layers and that of the picture.
            let off = rounding(sum.max(whole), parts.len() + 1);
            assert!(
                whole > MAX_LIGHT || (sum - whole).abs() <= off,
                "{name}: {channel} of pixel {pixel} is {whole}, and its layers have {sum}"
            );
        }
    }
    let mut shares = parts(picture, "A");
    shares.push(picture.values("cover_hole.Y"));
    for (pixel, (sum, whole)) in sum(&shares)
        .into_iter()
        .zip(picture.values("A"))
        .enumerate()
    {
        let off = rounding(1.0, shares.len());
        assert!(
            (sum - whole).abs() <= off,
            "{name}: the shares of pixel {pixel} add up to {sum}, and it has {whole}"
        );
    }
}

/// Asserts that so many pixels have light of a layer.
fn assert_shines(name: &str, picture: &Linear, layer: &str, least: usize) {
    let green = picture.values(&format!("{layer}.G"));
    let lit = green.iter().filter(|light| **light > 0.0).count();
    assert!(lit >= least, "{name}: {lit} pixels have light of {layer}");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn layers_add_up_to_the_picture() {
    let [sky, stars, hit1, hit2, volume, _] = LAYERS;
    for (number, expected) in [
        (2, &[sky, stars, hit1, hit2][..]),
        (9, &[sky, stars, hit1, hit2]),
        (14, &[sky, stars, volume]),
        (18, &[sky, stars, hit1, hit2, volume]),
    ] {
        let mut scene = small(number);
        scene.sky.mode = SkyMode::Stars;
        let name = format!("preset {number}");
        let picture = linear(&scene, "--layers");
        assert_eq!(layers_of(&picture), expected, "{name}");
        assert_adds_up(&name, &picture);
        // Little of the second crossing is seen through an opaque disk.
        for layer in expected.iter().filter(|layer| **layer != hit2) {
            assert_shines(&name, &picture, layer, 20);
        }
        let holes = picture.values("cover_hole.Y");
        assert!(holes.iter().any(|share| *share > 0.9), "{name}: no hole");
        // The picture is that without layers, drawn by another shader, which may round another way and so
        // refine another pixel.
        let plain = linear(&scene, "");
        let (own, other) = (picture.light(), plain.light());
        let alike = (0..own[0].len()).filter(|i| {
            (0..3).all(|c| {
                let (a, b) = (own[c][*i], other[c][*i]);
                (a - b).abs() <= 2.0 * rounding(a.max(b), 1)
            })
        });
        let share = alike.count() as f64 / own[0].len() as f64;
        assert!(share > 0.99, "{name}: {share}");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn layers_add_up_within_the_circle_of_a_fisheye_picture() {
    let mut scene = small(2);
    scene.camera.projection = Projection::Fisheye;
    scene.picture.bypass = true;
    for antialias in [true, false] {
        scene.picture.antialias = antialias;
        let picture = linear(&scene, "--layers --size 160x120");
        assert_adds_up("fisheye", &picture);
        let size = DVec2::new(160.0, 120.0);
        let sky = picture.values("light_sky.A");
        let (mut edge, mut outside) = (0, 0);
        for (at, share) in picture.values("A").into_iter().enumerate() {
            let place = DVec2::new((at % 160) as f64, (at / 160) as f64) + 0.5;
            let coverage = scene.camera.coverage(place, size);
            assert!((share - coverage).abs() <= rounding(1.0, 0), "{place}");
            assert!(sky[at] <= coverage + rounding(1.0, 0), "{place}");
            edge += usize::from(coverage > 0.0 && coverage < 1.0);
            outside += usize::from(coverage == 0.0);
        }
        assert!(edge > 100 && outside > 5000, "{edge} {outside}");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_probe_is_a_layer_in_front_of_the_others() {
    for antialias in [true, false] {
        let mut scene = small(6);
        scene.probe.antialias = antialias;
        let picture = linear(&scene, "--layers --aov depth");
        assert_adds_up("preset 6", &picture);
        let probe = picture.values("light_probe.A");
        let behind = parts(&picture, "A");
        let mut covered = 0;
        for (at, depth) in picture.values("depth.Z").into_iter().enumerate() {
            if probe[at] == 1.0 {
                let others: f64 = behind.iter().map(|share| share[at]).sum::<f64>() - 1.0;
                assert_eq!(others, 0.0, "pixel {at}");
            }
            covered += usize::from(depth.is_finite() && probe[at] > 0.0);
        }
        assert!(covered > 100, "{covered}");
        assert_shines("preset 6", &picture, "light_probe", 100);
    }
}

/// What is cut out of a picture is what a background shows through, so that the picture over its own sky is
/// the picture: no rim remains about the disk, the shadow or the jets.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_picture_without_its_sky_over_its_sky_is_the_picture() {
    for number in [2, 18] {
        let mut scene = small(number);
        scene.sky.mode = SkyMode::Stars;
        let whole = linear(&scene, "--layers");
        let cut = linear(&scene, "--layers --alpha sky");
        let sky = whole.values("light_sky.A");
        let mut mixed = 0;
        for (pixel, alpha) in cut.values("A").into_iter().enumerate() {
            let off = rounding(1.0, 2);
            assert!((alpha + sky[pixel] - 1.0).abs() <= off, "pixel {pixel}");
            mixed += usize::from(alpha > 0.1 && alpha < 0.9);
        }
        assert!(mixed > 50, "preset {number}: {mixed} pixels at edges");
        for (channel, (whole_light, cut_light)) in ["R", "G", "B"]
            .into_iter()
            .zip(whole.light().into_iter().zip(cut.light()))
        {
            let sky = whole.values(&format!("light_sky.{channel}"));
            let stars = whole.values(&format!("light_stars.{channel}"));
            for pixel in 0..sky.len() {
                let over = cut_light[pixel] + sky[pixel] + stars[pixel];
                let expected = whole_light[pixel];
                assert!(
                    expected > MAX_LIGHT
                        || (over - expected).abs() <= rounding(over.max(expected), 4),
                    "preset {number}, {channel} of pixel {pixel}: {over} and {expected}"
                );
            }
        }
        // The hole is opaque then, and it alone is transparent otherwise.
        let hole = whole.values("cover_hole.Y");
        let through = linear(&scene, "--alpha hole");
        for (pixel, alpha) in through.values("A").into_iter().enumerate() {
            let off = rounding(1.0, 2);
            assert!((alpha + hole[pixel] - 1.0).abs() <= off, "pixel {pixel}");
        }
        assert!(!through.has("light_sky.R"), "nobody asked for layers");
    }
}

/// Writes a scene with its layers in tiles of this size.
fn write_tiles(scene: &Scene, tiles: Tiles, file: &Path) -> Result<(), PictureError> {
    let channels = Channels::default().with_layers_of([scene.clone()]);
    let form = ExrForm::default();
    let options = HeadlessOptions {
        light: true,
        part: tiles.strips().next().and_then(|mut strip| strip.next()),
        ..HeadlessOptions::default()
    };
    let mut studio = Studio::with_options(scene, UVec2::ONE, options)?;
    studio.show_layers(channels.drawn_layers(form));
    let record = studio.record(scene);
    let mut large = LargePicture {
        scene,
        tiles,
        on_tile: &mut || {},
    };
    let mut picture = Picture {
        scene,
        record,
        light: Captured::empty(),
        first_row: 0,
        channels: &channels,
        samples: Vec::new(),
        form,
        commit: None,
        fps: None,
    };
    if tiles.count() > 1 {
        return large.write_exr(&mut studio, file, &picture, None);
    }
    let (light, _, layers) = large.light(&mut studio, &channels)?;
    (picture.light, picture.samples) = (light, layers);
    write_exr(file, picture)
}

#[test]
#[ignore = "needs a graphics adapter"]
fn tiles_have_the_layers_of_the_whole_picture() {
    let size = UVec2::new(480, 270);
    let folder = tempfile::tempdir().unwrap();
    let [whole, parts] = ["whole.exr", "tiles.exr"].map(|name| folder.path().join(name));
    for number in [2, 18] {
        let scene = exposed(&scene(number, size)).unwrap();
        write_tiles(&scene, Tiles::one(size), &whole).unwrap();
        let tiles = Tiles::with_size(size, UVec2::new(128, 64));
        write_tiles(&scene, tiles, &parts).unwrap();
        assert!(
            fs::read(&whole).unwrap() == fs::read(&parts).unwrap(),
            "preset {number}: the files differ"
        );
    }
}
