//! Pictures in tiles, against the same pictures drawn at once: all light and all levels have to be the
//! same, because a tile's rays, edges, stars and means are those of the same pixels of the whole picture.

use super::preset;
use glam::UVec2;
use lightfall_core::scene::Scene;
use lightfall_picture::{
    Captured, Channels, ExrForm, HeadlessOptions, LargePicture, Linear, PixelRays, PngBits, Still,
    Studio, Tiles, exposed, png_sweeps, write_exr,
};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Between the sizes there are tiles that are wider than high and the other way round, and the last ones
/// of a row and of a column are cut.
pub(super) const SIZE: UVec2 = UVec2::new(480, 270);
pub(super) const TILES: [UVec2; 2] = [UVec2::new(128, 64), UVec2::new(96, 112)];

/// The preset without cells, in a picture of this size.
pub(super) fn scene(number: usize, size: UVec2) -> Scene {
    let mut scene = preset(number);
    (scene.picture.width, scene.picture.height) = size.into();
    (scene.picture.grid_width, scene.picture.grid_height) = (size / 2).into();
    scene.picture.bypass = true;
    scene
}

/// Scenes with a disk and stars, with stars by a mesh, and with matter that has depth, one of them as the
/// mean of several frames.
fn scenes(size: UVec2) -> Vec<(&'static str, Scene)> {
    let mut means = scene(2, size);
    means.picture.samples = 4;
    vec![
        ("2", scene(2, size)),
        ("2 with four samples", means),
        ("9", scene(9, size)),
        ("14", scene(14, size)),
    ]
}

fn about<'a>(scene: &'a Scene, studio: &Studio, channels: &'a Channels) -> Linear<'a> {
    Linear {
        scene,
        record: studio.record(scene),
        light: Captured::empty(),
        first_row: 0,
        channels,
        samples: Vec::new(),
        form: ExrForm::default(),
        commit: None,
        fps: None,
    }
}

/// Draws the whole scene at once, as a picture that a window would show and as an EXR.
fn write_whole(scene: &Scene, size: UVec2, channels: &Channels, folder: &Path) -> Still {
    let options = HeadlessOptions {
        light: true,
        ..HeadlessOptions::default()
    };
    let mut studio = Studio::with_options(scene, size, options).unwrap();
    let still = studio.picture().unwrap();
    let light = studio.light().unwrap();
    let depth = studio.depth().unwrap();
    let samples = PixelRays::open()
        .unwrap()
        .sample(scene, channels, &depth)
        .unwrap();
    let picture = Linear {
        light,
        samples,
        ..about(scene, &studio, channels)
    };
    write_exr(&folder.join("whole.exr"), picture).unwrap();
    still
}

/// Draws the scene in tiles, as PNG and EXR. Returns how many tiles were drawn.
fn write_tiles(scene: &Scene, tiles: Tiles, channels: &Channels, folder: &Path) -> usize {
    let options = HeadlessOptions {
        light: true,
        levels: Some(PngBits::Eight.top()),
        part: tiles.strips().next().unwrap().next(),
        ..HeadlessOptions::default()
    };
    let mut studio = Studio::with_options(scene, UVec2::ONE, options).unwrap();
    let mut drawn = 0;
    let mut large = LargePicture {
        scene,
        tiles,
        on_tile: &mut || drawn += 1,
    };
    let record = studio.record(scene);
    let png = folder.join("tiles.png");
    large
        .write_png(&mut studio, (&png, PngBits::Eight), &record)
        .unwrap();
    let exr = folder.join("tiles.exr");
    let picture = about(scene, &studio, channels);
    let mut rays = PixelRays::open().unwrap();
    large
        .write_exr(&mut studio, &exr, &picture, Some(&mut rays))
        .unwrap();
    drawn
}

/// The levels of a PNG.
fn levels(png: &Path) -> Vec<u8> {
    image::open(png).unwrap().to_rgb8().into_raw()
}

/// Compares a scene in tiles of these sizes with the scene drawn at once.
pub(super) fn check_scene(name: &str, scene: &Scene, tile_sizes: &[UVec2]) {
    let channels: Channels = "sky,hit1,depth".parse().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let (scene, size) = (exposed(scene).unwrap(), scene.picture.size());
    let still = write_whole(&scene, size, &channels, folder.path());
    write_tiles(&scene, Tiles::one(size), &channels, folder.path());
    let whole = levels(&path("tiles.png"));
    let seen: BTreeSet<u8> = whole.iter().copied().collect();
    assert!(seen.len() > 50, "{name}: there is nothing to see");
    // FIT and PRINT are two shaders. A compiler may join a product and a sum in one of them and not in
    // the other, which moves the noise of the rounding by up to a thousandth of a level.
    let apart = |(a, b): (&u8, &u8)| a.abs_diff(*b);
    let apart: Vec<u8> = whole.iter().zip(&still.rgb).map(apart).collect();
    assert!(apart.iter().all(|apart| *apart <= 1), "{name}");
    let moved = apart.iter().filter(|apart| **apart > 0).count();
    assert!(moved <= whole.len() / 1000, "{name}: {moved} levels");
    for tile in tile_sizes {
        let tiles = Tiles::with_size(size, *tile);
        let drawn = write_tiles(&scene, tiles, &channels, folder.path());
        assert_eq!(drawn, (png_sweeps(&scene, &tiles) + 1) * tiles.count());
        assert!(
            fs::read(path("tiles.exr")).unwrap() == fs::read(path("whole.exr")).unwrap(),
            "{name}, {tile}: the EXR files differ"
        );
        let image = levels(&path("tiles.png"));
        let differ = image.iter().zip(&whole).filter(|(a, b)| a != b).count();
        assert_eq!(differ, 0, "{name}, {tile}: levels of {}", whole.len());
    }
}

fn check(size: UVec2, tile_sizes: &[UVec2]) {
    for (name, scene) in scenes(size) {
        check_scene(name, &scene, tile_sizes);
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn tiles_have_the_light_and_levels_of_the_whole_picture() {
    check(SIZE, &TILES);
}

/// At this size a texel of the base of the bloom is a square of two by two pixels. It takes minutes with a
/// software renderer.
#[test]
#[ignore = "takes minutes with a software renderer: run it by name"]
fn large_tiles_have_the_light_and_levels_of_the_whole_picture() {
    check(
        UVec2::new(4096, 2160),
        &[UVec2::new(512, 512), UVec2::new(768, 256)],
    );
}

#[test]
fn tiles_cover_a_picture_once_and_begin_at_whole_squares_of_the_bloom() {
    for size in [
        (1, 1),
        (4096, 2160),
        (16384, 8192),
        (32768, 16384),
        (16384, 32768),
        (9001, 7003),
    ] {
        let size = UVec2::from(size);
        let tiles = Tiles::of(size);
        // A texel of the base is a square of as many pixels as the rows over 1080.
        let square = size.y.div_ceil(1080).max(size.x.div_ceil(8192));
        let (mut area, mut next) = (0, UVec2::ZERO);
        for part in tiles.strips().flatten() {
            assert_eq!(part.origin, next, "{size}: tiles come in rows");
            assert_eq!(part.origin % (2 * square), UVec2::ZERO, "{size}");
            assert!(
                part.size.cmple(UVec2::new(4096, 512)).all(),
                "{size}: {part:?}"
            );
            let end = part.origin + part.size;
            assert!(end.cmple(size).all());
            next = UVec2::new(end.x, part.origin.y);
            if end.x == size.x {
                next = UVec2::new(0, end.y);
            }
            area += u64::from(part.size.x) * u64::from(part.size.y);
        }
        assert_eq!(area, u64::from(size.x) * u64::from(size.y), "{size}");
    }
}

/// The levels of sixteen bits are those of eight, but for the rounding: noise moves each by less than a
/// level.
#[test]
#[ignore = "needs a graphics adapter"]
fn sixteen_bits_show_the_picture_of_eight_bits_more_finely() {
    let scene = exposed(&scene(2, SIZE)).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("deep.png");
    let tiles = Tiles::one(SIZE);
    let options = HeadlessOptions {
        levels: Some(PngBits::Sixteen.top()),
        ..HeadlessOptions::default()
    };
    let mut studio = Studio::with_options(&scene, SIZE, options).unwrap();
    let still = studio.picture().unwrap();
    let record = studio.record(&scene);
    let mut large = LargePicture {
        scene: &scene,
        tiles,
        on_tile: &mut || {},
    };
    large
        .write_png(&mut studio, (&file, PngBits::Sixteen), &record)
        .unwrap();
    let decoder = png::Decoder::new(std::io::BufReader::new(fs::File::open(&file).unwrap()));
    let info = decoder.read_info().unwrap();
    assert_eq!(info.info().bit_depth, png::BitDepth::Sixteen);
    assert!(info.info().srgb.is_some(), "nothing says that it is sRGB");
    let deep = image::open(&file).unwrap().into_rgb16().into_raw();
    let mut fine = BTreeSet::new();
    for (deep, level) in deep.iter().zip(&still.rgb) {
        let difference = f64::from(*deep) / 257.0 - f64::from(*level);
        assert!(difference.abs() <= 1.0, "{deep} and {level}");
        fine.insert(*deep);
    }
    assert!(fine.len() > 2000, "only {} levels", fine.len());
}
