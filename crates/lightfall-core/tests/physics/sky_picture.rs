//! Pictures of the sky: read from every format, refused with a sentence, and where their light lies on
//! the cube map.

mod refused;

use glam::DVec3;
use lightfall_core::optics::cube_map::{FACES, face_and_place, place};
use lightfall_core::optics::sky_picture::colour::{shifted, temperature};
use lightfall_core::optics::sky_picture::{SkyPicture, picture_from_hole};
use lightfall_core::optics::spectrum;
use lightfall_core::optics::stars::{celestial_direction, hole_from_celestial};
use lightfall_core::scene::{Scene, SkyFrame, SkyMode};
use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

/// The northern half of its sky has the level 188 of sRGB, and the southern half is dark.
const JPEG: &[u8] = include_bytes!("../northern-light.jpg");

/// Linear light of the level 188 of 255 (IEC 61966-2-1).
const LEVEL_188: f64 = 0.502_886;

/// Rounding of half floats.
const HALF: f64 = 1.0 / 1024.0;

/// A folder for one test, which goes when the test ends.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let name = format!("lightfall-{name}-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    fn path(&self, name: &str) -> String {
        self.0.join(name).to_str().unwrap().to_owned()
    }

    fn file(&self, name: &str, bytes: &[u8]) -> String {
        let path = self.path(name);
        fs::write(&path, bytes).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // Of no further use, whether it is still there or not.
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// A scene under the picture of this file.
fn under(path: &str) -> Scene {
    let mut scene = Scene::default();
    scene.sky.mode = SkyMode::Picture;
    scene.sky.picture = path.into();
    scene
}

fn picture(path: &str) -> Arc<SkyPicture> {
    SkyPicture::of(&under(path)).unwrap().unwrap()
}

fn png(width: u32, height: u32, rgb: impl Fn(u32, u32) -> [u8; 3]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let levels: Vec<u8> = pixels.flat_map(|(x, y)| rgb(x, y)).collect();
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&levels).unwrap();
    writer.finish().unwrap();
    bytes
}

/// An HDR file of the light 0.5, of rows of runs or of whole pixels.
fn hdr(width: usize, height: usize, in_runs: bool) -> Vec<u8> {
    let head = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n");
    let mut bytes = head.into_bytes();
    for _ in 0..height {
        if in_runs {
            bytes.extend([2, 2, (width >> 8) as u8, width as u8]);
            // Mantissas of a half and the exponent of one: a repeated byte, and bytes one by one.
            for _ in 0..4 {
                bytes.extend([128 + 3, 128, (width - 3) as u8]);
                bytes.extend(vec![128; width - 3]);
            }
        } else {
            bytes.extend([128; 4].repeat(width));
        }
    }
    bytes
}

fn exr(path: &str, [width, height]: [usize; 2], light: impl Sync + Fn(usize, usize) -> f32) {
    let rgb = |x, y| (light(x, y), light(x, y), light(x, y));
    exr::prelude::write_rgb_file(path, width, height, rgb).unwrap();
}

/// The direction on the picture's axes of a place in it, from 0 to 1 across and down, as the
/// reference states it: u = 1/2 - longitude / 2 pi, w = 1/2 - latitude / pi.
fn direction([across, down]: [f64; 2]) -> DVec3 {
    let longitude = TAU * (0.5 - across);
    let latitude = PI * (0.5 - down);
    celestial_direction(longitude.to_degrees(), latitude.to_degrees())
}

/// Directions all around: the poles, the seam, and between them.
fn all_around() -> impl Iterator<Item = [f64; 2]> {
    (0..=16).flat_map(|across| {
        (0..=8).map(move |down| [f64::from(across) / 16.0, f64::from(down) / 8.0])
    })
}

#[test]
fn a_picture_of_one_light_is_this_light_all_over_in_every_format() {
    let folder = Folder::new("one-light");
    let open_exr = folder.path("a.exr");
    exr(&open_exr, [64, 32], |_, _| 0.5);
    let files = [
        (folder.file("a.hdr", &hdr(64, 32, true)), 0.5),
        (folder.file("b.hdr", &hdr(64, 32, false)), 0.5),
        (open_exr, 0.5),
        (
            folder.file("a.png", &png(64, 32, |_, _| [188; 3])),
            LEVEL_188,
        ),
    ];
    for (path, expected) in files {
        let picture = picture(&path);
        assert_eq!(picture.size, [64, 32], "{path}");
        for level in 0..picture.level_count() {
            for at in all_around() {
                let light = picture.light(direction(at), 1.0, level);
                let error = (light - DVec3::splat(expected)).abs().max_element();
                assert!(error < HALF * expected, "{path}, level {level}: {light}");
            }
        }
    }
    // The lossy format keeps levels to about one of 255 away from edges.
    let picture = picture(&folder.file("a.jpg", JPEG));
    for (at, expected) in [([0.3, 0.1], LEVEL_188), ([0.3, 0.9], 0.0)] {
        let light = picture.light(direction(at), 1.0, 0);
        let error = (light - DVec3::splat(expected)).abs().max_element();
        assert!(error < 0.01, "{light}, not {expected}");
    }
}

/// A texel of the map is about as large as a pixel of the picture, so that half of the block's light
/// is in the texel at the middle of 2 x 2 pixels. None is in a texel that lies wholly more than half a
/// pixel beyond their edge, which is as far as light is linear between pixels.
#[test]
fn a_bright_block_lies_at_its_longitude_and_latitude() {
    let folder = Folder::new("block");
    let (width, height) = (256, 128);
    // In the middle, next to the seam, and far north.
    for (number, [x, y]) in [[128, 64], [30, 40], [254, 90], [70, 12]]
        .into_iter()
        .enumerate()
    {
        let path = folder.path(&format!("{number}.exr"));
        exr(&path, [width, height], |px, py| {
            let inside = (x..x + 2).contains(&px) && (y..y + 2).contains(&py);
            if inside { 8.0 } else { 0.0 }
        });
        let picture = picture(&path);
        let seen = |dx: f64, dy: f64| {
            let across = (x as f64 + 1.0 + dx) / width as f64;
            let down = (y as f64 + 1.0 + dy) / height as f64;
            picture.light(direction([across, down]), 1.0, 0).y
        };
        // Pixels are narrower toward the pole, where a texel holds several.
        let (wide, least) = if y < 20 { (12.0, 0.5) } else { (4.0, 3.5) };
        assert!(seen(0.0, 0.0) > least, "{x}, {y}: {}", seen(0.0, 0.0));
        for (dx, dy) in [(wide, 0.0), (-wide, 0.0), (0.0, 4.0), (0.0, -4.0)] {
            assert_eq!(seen(dx, dy), 0.0, "{x}, {y}, off by {dx}, {dy}");
        }
    }
}

/// The sum over the picture's pixels, weighted with their solid angles, against that over the map's
/// texels with theirs, and against the six texels of the last level, which are equal parts of the
/// sky. Light that differs from column to column next to the poles counts as well. The map takes a
/// mean of few places in a texel, so it is right to half a percent.
#[test]
fn the_mean_light_of_the_map_is_that_of_the_picture() {
    let folder = Folder::new("mean");
    let path = folder.path("a.exr");
    let (width, height) = (128, 64);
    let light = |x: usize, y: usize| {
        let wave = (TAU * 5.0 * x as f64 / width as f64).sin();
        (1.0 + 0.9 * wave + 0.02 * y as f64 + ((7 * x + 3 * y) % 5) as f64) as f32
    };
    exr(&path, [width, height], light);
    let (mut sum, mut all) = (0.0, 0.0);
    for y in 0..height {
        let weight = (PI * (y as f64 + 0.5) / height as f64).sin();
        sum += weight * (0..width).map(|x| f64::from(light(x, y))).sum::<f64>();
        all += weight * width as f64;
    }
    let expected = sum / all;
    let picture = picture(&path);
    let mean = picture.mean_light().y;
    assert!((mean / expected - 1.0).abs() < 5e-3, "{mean}, {expected}");
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let faces = axes.into_iter().flat_map(|axis| [axis, -axis]);
    let last = picture.level_count() - 1;
    let coarse: f64 = faces.map(|face| picture.light(face, 1.0, last).y).sum();
    assert!((coarse / 6.0 / mean - 1.0).abs() < 2e-3, "{coarse}, {mean}");
}

/// The place that `sky.ra_deg` and `sky.dec_deg` name is behind the hole, on either set of axes; and a
/// picture seen from outside has it on the other side of its middle.
#[test]
fn the_fields_of_the_sky_turn_a_picture() {
    let mut scene = Scene::default();
    (scene.sky.ra_deg, scene.sky.dec_deg) = (30.0, 20.0);
    let behind = |scene: &Scene| picture_from_hole(scene) * DVec3::NEG_X;
    let expected = celestial_direction(30.0, 20.0);
    assert!((behind(&scene) - expected).length() < 1e-12);
    scene.sky.mirror = true;
    let mirrored = celestial_direction(-30.0, 20.0);
    assert!((behind(&scene) - mirrored).length() < 1e-12);
    // The galactic centre (J2000; SIMBAD's Sgr A* is within 0.06 degrees of longitude 0, latitude 0).
    scene.sky.mirror = false;
    scene.sky.frame = SkyFrame::Galactic;
    (scene.sky.ra_deg, scene.sky.dec_deg) = (266.4168, -29.0078);
    assert!((behind(&scene) - DVec3::X).length() < 2e-3);
    // A rotation does not change angles.
    let turn = picture_from_hole(&scene) * hole_from_celestial(266.4168, -29.0078, 0.0);
    assert!((turn.determinant() - 1.0).abs() < 1e-12);
}

#[test]
fn a_direction_is_found_on_the_face_that_it_was_made_from() {
    for face in 0..FACES {
        for (u, v) in [(0.01, 0.02), (0.5, 0.5), (0.99, 0.3), (0.2, 0.97)] {
            let (found, found_u, found_v) = face_and_place(place(face, u, v).normalize());
            assert_eq!(found, face);
            assert!((found_u - u).abs() < 1e-12 && (found_v - v).abs() < 1e-12);
        }
    }
}

/// Thermal light is shifted as `spectrum` shifts it. A channel is exact to the smallest share of the
/// brightest one that counts, 1e-3, of the light that is divided and of the one that is multiplied.
#[test]
fn thermal_light_is_shifted_as_thermal_light_and_no_shift_changes_nothing() {
    for kelvin in [2500.0, 4000.0, 6500.0, 12_000.0, 30_000.0] {
        let light = DVec3::from(spectrum::colour(kelvin)).max(DVec3::ZERO);
        let found = temperature(light.to_array());
        assert!((found / kelvin - 1.0).abs() < 5e-3, "{found} of {kelvin}");
        for g in [0.5, 0.8, 1.25, 2.0] {
            let seen = shifted(light, found, g);
            let exact = DVec3::from(spectrum::colour(g * kelvin)).max(DVec3::ZERO);
            let error = (seen - exact).abs().max_element() / exact.max_element();
            assert!(error < 0.02, "{kelvin} K, g = {g}: {seen}, not {exact}");
        }
    }
    for light in [[1.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.2, 0.1, 9.0], [0.0; 3]] {
        let light = DVec3::from(light);
        assert_eq!(shifted(light, temperature(light.to_array()), 1.0), light);
    }
}
