//! Pictures of the user's own as the sky: their light is where the reference says, as bright as its
//! shift says, and none of it is lost.

use super::linear::rgb;
use super::preset;
use super::projections::light as captured;
use exr::prelude::write_rgb_file;
use glam::{DVec2, DVec3, UVec2};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::shift::Shift;
use lightfall_core::optics::sky_picture::{SkyPicture, picture_from_hole};
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::{Method, ObserverKind, Scene, SkyFrame, SkyMode};
use lightfall_platform::storage::{PictureRecord, read_scene};
use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::Path;

const SIZE: UVec2 = UVec2::new(320, 180);

/// The scene of a hole under the picture of a file, without anything else that shines, one ray a
/// pixel.
fn under(path: &Path, spin: f64) -> Scene {
    let mut scene = preset(2);
    (scene.hole.spin, scene.disk.enabled) = (spin, false);
    scene.sky.mode = SkyMode::Picture;
    scene.sky.picture = path.to_str().unwrap().into();
    scene.sky.brightness = 1.0;
    (scene.picture.width, scene.picture.height) = SIZE.into();
    (scene.picture.grid_width, scene.picture.grid_height) = SIZE.into();
    (scene.picture.bypass, scene.picture.antialias) = (true, false);
    (scene.picture.samples, scene.picture.automatic_exposure) = (1, false);
    scene
}

/// The linear light of each pixel, rows from the top.
fn light(scene: &Scene) -> Vec<DVec3> {
    let light = captured(scene);
    assert_eq!(light.size, SIZE);
    light.rgba.into_iter().map(rgb).collect()
}

/// What the reference says of each pixel: the direction of its light on the picture's axes and its
/// shift; `None` in the shadow.
fn seen(scene: &Scene) -> Vec<Option<(DVec3, f64)>> {
    let reference = Reference::new(scene).unwrap();
    let axes = scene.camera.tetrad_from_camera();
    let to_picture = picture_from_hole(scene);
    let pixels = (0..SIZE.y).flat_map(|y| (0..SIZE.x).map(move |x| (x, y)));
    pixels
        .map(|(x, y)| {
            let pixel = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let looking = axes * scene.camera.looking(pixel, SIZE.as_dvec2());
            let trace = reference.trace(looking);
            let g = 1.0 / reference.photon(looking.normalize()).energy;
            let sky = trace.sky.filter(|_| trace.outcome == Outcome::Sky)?;
            Some((to_picture * sky, g))
        })
        .collect()
}

/// The pixels whose neighbours all show the sky from nearly the same direction: next to the shadow a
/// pixel holds much of the sky, and one ray in f64 does not say what.
fn calm(seen: &[Option<(DVec3, f64)>]) -> Vec<usize> {
    const MOST: f64 = 0.03;
    let columns = SIZE.x as usize;
    let inside = (0..seen.len()).filter(|at| {
        let (x, y) = (at % columns, at / columns);
        (2..columns - 2).contains(&x) && (2..SIZE.y as usize - 2).contains(&y)
    });
    inside
        .filter(|at| {
            let near = [at - 2, at + 2, at - 2 * columns, at + 2 * columns];
            let is_near = |other: usize| match (seen[*at], seen[other]) {
                (Some((own, _)), Some((other, _))) => (own - other).length() < 2.0 * MOST,
                _ => false,
            };
            near.into_iter().all(is_near)
        })
        .collect()
}

/// The light of a scene's picture from a direction, shifted by g.
fn shifted_light(scene: &Scene) -> impl Fn(DVec3, f64) -> DVec3 {
    let picture = SkyPicture::of(scene).unwrap().unwrap();
    let shift = Shift::new(scene);
    move |direction, g| shift.beaming_factor(g) * picture.light(direction, g, 0)
}

/// Half floats and the shader's table of thermal colours, which is linear between 512 entries.
const ROUNDING: f64 = 4e-3;

#[test]
#[ignore = "needs a graphics adapter"]
fn a_picture_of_one_light_is_this_light_times_its_shift() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("even.exr");
    write_rgb_file(&path, 64, 32, |_, _| (0.8_f32, 0.5_f32, 0.3_f32)).unwrap();
    for (spin, observer, velocity) in [
        (0.0, ObserverKind::Static, [0.0; 3]),
        (0.9, ObserverKind::Zamo, [0.0; 3]),
        (0.0, ObserverKind::Static, [-0.4, 0.1, 0.2]),
    ] {
        let mut scene = under(&path, spin);
        scene.observer.kind = observer;
        scene.observer.velocity = velocity;
        let (light, seen) = (light(&scene), seen(&scene));
        let shifted_light = shifted_light(&scene);
        let calm = calm(&seen);
        assert!(2 * calm.len() > seen.len(), "{} calm pixels", calm.len());
        for at in calm {
            let (direction, g) = seen[at].unwrap();
            let expected = shifted_light(direction, g);
            let error = (light[at] - expected).abs().max_element() / expected.max_element();
            assert!(
                error < ROUNDING,
                "pixel {at}, g {g}: {}, not {expected}",
                light[at]
            );
        }
        // The shadow is black.
        let dark = light.iter().zip(&seen).filter(|(_, seen)| seen.is_none());
        assert!(dark.clone().count() > 50);
        let lit = dark.filter(|(light, _)| light.max_element() > 0.0).count();
        // Rays within f32's rounding of the shadow's edge may end on either side.
        assert!(lit < 20, "{lit} pixels of the shadow shine");
    }
}

/// The pixels that see the block and those that do not are those of the reference, but for its edge: a
/// texel, and the linear mean of texels, are about as wide as a pixel of the file.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_bright_block_appears_where_the_reference_says() {
    let folder = tempfile::tempdir().unwrap();
    let (width, height) = (256_usize, 128_usize);
    // Behind the hole in the middle of the file, and across the seam.
    for (number, frame, first) in [(0, SkyFrame::Equatorial, 120), (1, SkyFrame::Galactic, 248)] {
        let file = folder.path().join(format!("block-{number}.exr"));
        let is_block =
            |x: usize, y: usize| (x + width - first) % width < 16 && (52..68).contains(&y);
        write_rgb_file(&file, width, height, |x, y| {
            let light = if is_block(x, y) { 4.0_f32 } else { 0.0 };
            (light, light, light)
        })
        .unwrap();
        for method in [Method::Closed, Method::Mino] {
            let mut scene = under(&file, if method == Method::Mino { 0.7 } else { 0.0 });
            (scene.method, scene.sky.frame) = (method, frame);
            // The middle of the block is behind the hole, or a little beside it.
            let (ra, dec) = match frame {
                SkyFrame::Equatorial => (8.0, 3.0),
                // On the other side of the galactic centre: longitude 180, latitude 0.
                SkyFrame::Galactic => (86.4, 28.9),
            };
            (scene.sky.ra_deg, scene.sky.dec_deg) = (ra, dec);
            let (light, seen) = (light(&scene), seen(&scene));
            let place = |direction: DVec3| {
                let across = 0.5 - direction.y.atan2(direction.x) / TAU;
                let down = 0.5 - direction.z.asin() / PI;
                DVec2::new(across * width as f64, down * height as f64)
            };
            let (mut inside, mut outside) = (0, 0);
            for at in calm(&seen) {
                let (direction, _) = seen[at].unwrap();
                let at_place = place(direction);
                // How deep in the block, in pixels of the file; below zero outside.
                let middle = DVec2::new(first as f64 + 8.0, 60.0);
                let mut offset = (at_place - middle).abs();
                offset.x = offset.x.min(width as f64 - offset.x);
                let depth = 8.0 - offset.max_element();
                let shines = light[at].max_element();
                if depth > 5.0 {
                    inside += 1;
                    assert!(
                        shines > 1.0,
                        "{method:?}, pixel {at}, {depth} deep: {shines}"
                    );
                } else if depth < -5.0 {
                    outside += 1;
                    assert!(shines < 0.2, "{method:?}, pixel {at}, {depth}: {shines}");
                }
            }
            assert!(inside > 20 && outside > 1000, "{inside}, {outside}");
        }
    }
}

/// The mean over the calm pixels of a picture with waves of a few degrees. Filters take light from the
/// neighbours and give as much to them, so that the mean is that of single rays to a percent.
#[test]
#[ignore = "needs a graphics adapter"]
fn the_mean_light_is_that_of_the_reference() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("waves.exr");
    write_rgb_file(&path, 512, 256, |x, y| {
        let wave = (0.3 * x as f32).sin() * (0.25 * y as f32).cos();
        (1.0 + 0.7 * wave, 0.9 + 0.5 * wave, 0.7 + 0.3 * wave)
    })
    .unwrap();
    for spin in [0.0, 0.8] {
        let scene = under(&path, spin);
        let (light, seen) = (light(&scene), seen(&scene));
        let shifted_light = shifted_light(&scene);
        let (mut drawn, mut expected) = (DVec3::ZERO, DVec3::ZERO);
        for at in calm(&seen) {
            let (direction, g) = seen[at].unwrap();
            drawn += light[at];
            expected += shifted_light(direction, g);
        }
        let error = (drawn / expected - 1.0).abs().max_element();
        assert!(error < 0.01, "spin {spin}: {drawn}, not {expected}");
    }
}

/// In front of a black picture stands what the sky mode `stars` shows without the Milky Way: no pixel is
/// brighter than there, and the brightest one, a star of some magnitudes above the Milky Way's light,
/// is as bright.
#[test]
#[ignore = "needs a graphics adapter"]
fn stars_are_drawn_in_front_of_a_picture_only_where_they_are_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("black.exr");
    write_rgb_file(&path, 16, 8, |_, _| (0.0_f32, 0.0_f32, 0.0_f32)).unwrap();
    let mut scene = under(&path, 0.0);
    assert!(light(&scene).iter().all(|light| *light == DVec3::ZERO));
    scene.sky.stars = true;
    let points = light(&scene);
    scene.sky.mode = SkyMode::Stars;
    let whole = light(&scene);
    for (at, (points, whole)) in points.iter().zip(&whole).enumerate() {
        // Both are rounded to half floats.
        let most = 1.002 * *whole + 1e-6;
        assert!(points.cmple(most).all(), "pixel {at}: {points}, {whole}");
    }
    let lit = points.iter().filter(|light| light.max_element() > 0.0);
    assert!(lit.count() > 50);
    let brightest = |light: &[DVec3]| light.iter().map(|light| light.y).fold(0.0, f64::max);
    let share = brightest(&points) / brightest(&whole);
    assert!(share > 0.95, "{share}");
}

/// A preset names its picture from its own folder, and what is drawn of it keeps the path and says
/// which file it was.
#[test]
fn a_preset_finds_its_picture_beside_itself_and_the_record_names_it() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("even.exr");
    write_rgb_file(&picture, 16, 8, |_, _| (0.5_f32, 0.5_f32, 0.5_f32)).unwrap();
    let preset = folder.path().join("mine.toml");
    fs::write(
        &preset,
        "[sky]\nmode = \"picture\"\npicture = \"even.exr\"\n",
    )
    .unwrap();
    let scene = read_scene(&preset, &[]).unwrap();
    assert_eq!(Path::new(&scene.sky.picture), picture);
    let stars = Catalogue::built_in();
    let record = PictureRecord::new(&scene, stars, None);
    let sky = record
        .texts
        .iter()
        .find(|(name, _)| *name == "lightfall.sky");
    let text = &sky.unwrap().1;
    assert!(text.starts_with("even.exr, 16x8, sha256 "), "{text}");
    assert_eq!(text.rsplit(' ').next().unwrap().len(), 64);
    assert!(record.preset.contains("even.exr"));
    // Stars are in the picture where they are asked for.
    let mut starry = scene.clone();
    assert!(!scene.sky.has_star_points());
    starry.sky.stars = true;
    assert!(starry.sky.has_star_points());
    // A file of another sky is not named.
    starry.sky.mode = SkyMode::Stars;
    let record = PictureRecord::new(&starry, stars, None);
    assert!(
        record
            .texts
            .iter()
            .all(|(name, _)| *name != "lightfall.sky")
    );
}
