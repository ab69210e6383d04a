//! Whole pictures, judged by quantities that physics or the presentation's own rules give.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

mod animation;
mod antialias;
mod bloom;
mod comparison;
mod dither;
mod embedded;
mod exr_file;
mod farm;
#[cfg(unix)]
mod farm_runs;
mod films;
mod finite;
mod idle;
mod layers;
mod light;
mod linear;
mod linear_matter;
#[path = "../../crates/lightfall-core/tests/physics/moved_camera.rs"]
#[allow(
    dead_code,
    reason = "pictures need the scene of the twin, and not the directions of its rays"
)]
mod moved_camera;
mod night;
mod probe_tiles;
mod projection_tiles;
mod projections;
#[path = "../../crates/lightfall-core/tests/physics/random.rs"]
mod random;
#[path = "../../crates/lightfall-core/tests/gpu/random_scene.rs"]
mod random_scene;
mod redraw;
mod sequences;
mod sky_pictures;
mod stars;
mod tiles;
mod tilt;
mod transparent;
mod two_pictures;
mod unit_of_light;

use glam::UVec2;
use lightfall_core::scene::{
    DiskStructure, LimbDarkening, Method, Scene, SkyMode, ToneCurve, View, presets,
};
use lightfall_picture::{Still, Studio, check_path, render, write_png};
use lightfall_platform::storage::PictureRecord;

fn preset(number: usize) -> Scene {
    presets::find(&number.to_string())
        .unwrap()
        .scene(&[])
        .unwrap()
}

/// The preset with a hole without spin, which every method traces.
fn without_spin(number: usize) -> Scene {
    let mut scene = preset(number);
    scene.hole.spin = 0.0;
    scene
}

/// The preset with a hole without spin and a smooth disk, for tests about something else.
fn smooth(number: usize) -> Scene {
    let mut scene = without_spin(number);
    (scene.disk.structure, scene.disk.limb) = (DiskStructure::None, LimbDarkening::None);
    scene
}

fn pixel(still: &Still, x: u32, y: u32) -> [u8; 3] {
    let at = 3 * (y * still.size.x + x) as usize;
    [still.rgb[at], still.rgb[at + 1], still.rgb[at + 2]]
}

fn luminance(still: &Still, x: u32, y: u32) -> f64 {
    let [r, g, b] = pixel(still, x, y).map(|channel| (f64::from(channel) / 255.0).powf(2.2));
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Light that falls on a rectangle, as a mean.
fn mean(still: &Still, x: std::ops::Range<u32>, y: std::ops::Range<u32>) -> f64 {
    let count = f64::from(x.len() as u32 * y.len() as u32);
    y.flat_map(|y| x.clone().map(move |x| (x, y)))
        .map(|(x, y)| luminance(still, x, y))
        .sum::<f64>()
        / count
}

/// Mean of all channels' light, by sRGB's own curve.
fn mean_light(still: &Still) -> f64 {
    let linear = |level: &u8| match f64::from(*level) / 255.0 {
        level if level <= 0.04045 => level / 12.92,
        level => ((level + 0.055) / 1.055).powf(2.4),
    };
    still.rgb.iter().map(linear).sum::<f64>() / still.rgb.len() as f64
}

/// Draws pictures one after another by chains of passes that it keeps, one for each size: the tests
/// of redraw.rs hold such a chain to what a new one draws.
#[derive(Default)]
struct Drawer(Vec<(UVec2, Studio)>);

impl Drawer {
    fn draw(&mut self, scene: &Scene, size: UVec2) -> Still {
        let kept = self.0.iter().position(|(of, _)| *of == size);
        let at = kept.unwrap_or_else(|| {
            self.0.push((size, Studio::open(scene, size).unwrap()));
            self.0.len() - 1
        });
        let studio = &mut self.0[at].1;
        studio.show(scene).unwrap();
        studio.settle().unwrap();
        studio.picture().unwrap()
    }
}

/// The scene with a picture of half its width and height.
fn half(mut scene: Scene) -> Scene {
    scene.picture.width /= 2;
    scene.picture.height /= 2;
    scene
}

/// The scene shown pixel by pixel at its preset's exposure: no cells, no bloom, output as large as
/// the HDR picture.
fn plain(mut scene: Scene) -> (Scene, UVec2) {
    scene.picture.automatic_exposure = false;
    scene.picture.bypass = true;
    scene.picture.bloom = 0.0;
    let size = UVec2::new(scene.picture.width, scene.picture.height);
    (scene, size)
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_shadow_has_the_area_that_theory_gives() {
    let (mut scene, size) = plain(without_spin(2));
    scene.disk.enabled = false;
    scene.sky.mode = SkyMode::Grid;
    scene.camera.fov_deg = 24.0;
    let still = render(&scene, size).unwrap();
    let dark = (0..size.y)
        .flat_map(|y| (0..size.x).map(move |x| (x, y)))
        .filter(|&(x, y)| pixel(&still, x, y) == [0; 3]);
    // A cone of half-angle alpha about the line of sight is a circle of radius tan(alpha) on the
    // picture's plane.
    let alpha = lightfall_core::geometry::schwarzschild::shadow_half_angle_static(scene.camera.r);
    let pixels_per_unit = f64::from(size.y) / 2.0 / (scene.camera.fov_deg.to_radians() / 2.0).tan();
    let radius = (dark.count() as f64 / std::f64::consts::PI).sqrt();
    let expected = alpha.tan() * pixels_per_unit;
    // The edge itself is exact; pixels count whole, and faint light beside it may be rounded to
    // black: 2 pixels.
    assert!(
        (radius - expected).abs() < 2.0,
        "radius {radius} pixels, theory {expected}"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_stepping_methods_errors_are_brighter_than_those_of_the_closed_form() {
    let light = |method: Method| {
        let (scene, size) = plain(Scene {
            view: View::Error,
            method,
            ..smooth(2)
        });
        mean(&render(&scene, size).unwrap(), 0..size.x, 0..size.y)
    };
    let (verlet, closed) = (light(Method::Verlet), light(Method::Closed));
    // A hundredth of a pixel and more against less than a thousandth: more than a quarter of the
    // scale, which is even in lightness, and so at least four times the light.
    assert!(
        closed > 0.0 && verlet > 4.0 * closed,
        "verlet {verlet}, closed {closed}"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_approaching_side_of_the_disk_is_the_brighter_one() {
    let (scene, size) = plain(preset(2));
    let still = render(&scene, size).unwrap();
    // The disk turns toward growing phi, which is to the right on the near side: its left side
    // approaches.
    let left = mean(&still, 0..size.x / 2, 0..size.y);
    let right = mean(&still, size.x / 2..size.x, 0..size.y);
    assert!(left > 1.3 * right, "left {left}, right {right}");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn preset_2_shows_the_disk_above_and_below_the_shadow() {
    let (mut scene, size) = plain(preset(2));
    scene.sky.mode = SkyMode::Off;
    let still = render(&scene, size).unwrap();
    let bright = |y: u32| luminance(&still, size.x / 2, y) > 0.02;
    let centre = size.y / 2;
    // Going up from the middle of the shadow: dark, then the far side of the disk, lifted over the
    // hole.
    let shadow_rows = (0..centre).rev().take_while(|&y| !bright(y)).count();
    assert!(shadow_rows > 5, "the middle of the picture is not dark");
    assert!(
        (0..centre - shadow_rows as u32).any(bright),
        "no image above the shadow"
    );
    assert!((centre..size.y).any(bright), "no image below the shadow");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn cells_are_constant_four_by_four_blocks_at_1920_by_1080() {
    let still = render(&preset(2), UVec2::new(1920, 1080)).unwrap();
    let mut colours = std::collections::BTreeSet::new();
    for y in 0..still.size.y {
        for x in 0..still.size.x {
            assert_eq!(
                pixel(&still, x, y),
                pixel(&still, x & !3, y & !3),
                "at {x}, {y}"
            );
            colours.insert(pixel(&still, x, y));
        }
    }
    assert!(
        colours.len() > 50,
        "only {} colours: there is nothing to see",
        colours.len()
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn channels_take_no_more_values_than_the_levels_allow() {
    let mut scene = preset(2);
    scene.picture.levels = 6;
    let still = render(&scene, UVec2::new(960, 540)).unwrap();
    let values: std::collections::BTreeSet<u8> = still.rgb.iter().copied().collect();
    assert_eq!(values, [0, 51, 102, 153, 204, 255].into());
}

#[test]
#[ignore = "needs a graphics adapter"]
fn hiding_the_disk_leaves_the_probe_alone_and_changes_what_is_around_it() {
    let (mut scene, size) = plain(half(preset(6)));
    // Each pixel shows either the craft or what is behind it.
    scene.probe.antialias = false;
    let mut drawer = Drawer::default();
    let with_disk = drawer.draw(&scene, size);
    scene.disk.enabled = false;
    let without_disk = drawer.draw(&scene, size);
    // Where the craft is: what taking it away changes, in either picture.
    scene.probe.enabled = false;
    let without_both = drawer.draw(&scene, size);
    scene.disk.enabled = true;
    let without_probe = drawer.draw(&scene, size);
    let (mut craft, mut around) = (0, 0);
    for y in 0..size.y {
        for x in 0..size.x {
            let is_craft = pixel(&without_disk, x, y) != pixel(&without_both, x, y)
                && pixel(&with_disk, x, y) != pixel(&without_probe, x, y);
            let same = pixel(&with_disk, x, y) == pixel(&without_disk, x, y);
            assert!(!is_craft || same, "the probe changed at {x}, {y}");
            craft += u32::from(is_craft);
            around += u32::from(!same);
        }
    }
    assert!(craft > 500, "the probe covers only {craft} pixels");
    assert!(
        around > 2_500,
        "hiding the disk changed only {around} pixels"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn fractional_cells_average_the_light_that_falls_on_them() {
    // The mean light of a picture does not depend on how many cells it is cut into, whole pixels to
    // a cell or not. Procedural stars have pixels without any light beside them. The sky is so
    // bright that its mean is more than a level above black, which is dithered in steps, and so dim
    // that no star is brighter than white, where light is lost.
    let mut drawer = Drawer::default();
    let disk = preset(3);
    let stars = ToneCurve::ALL.into_iter().flat_map(|curve| {
        [SkyMode::Stars, SkyMode::Procedural].map(|mode| {
            let mut scene = disk.clone();
            (scene.disk.enabled, scene.sky.mode) = (false, mode);
            (scene.picture.tone_curve, scene.sky.brightness) = (curve, 0.4);
            scene
        })
    });
    for scene in stars.chain([disk.clone()]) {
        let (mut scene, _) = plain(scene);
        scene.picture.bypass = false;
        scene.picture.dither = true;
        scene.picture.levels = 256;
        let mut of_grid = |width: u32, height: u32| {
            scene.picture.grid_width = width;
            scene.picture.grid_height = height;
            mean_light(&drawer.draw(&scene, UVec2::new(width, height)))
        };
        let whole = of_grid(480, 270);
        let fractional = of_grid(437, 251);
        // Rounding to 256 levels moves a channel by half a level at most, and its mean over a
        // picture by far less.
        assert!(
            whole > 0.0 && (fractional / whole - 1.0).abs() < 1e-3,
            "{:?}, sky {:?}, disk {}: {whole} and {fractional}",
            scene.picture.tone_curve,
            scene.sky.mode,
            scene.disk.enabled
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn odd_sizes_are_drawn_with_bars_where_the_cells_do_not_fit() {
    let scene = preset(3);
    let still = render(&scene, UVec2::new(1000, 601)).unwrap();
    assert_eq!(still.size, UVec2::new(1000, 601));
    // Two output pixels to a cell: 960 x 540, 20 pixels of bar on the left, 30 above.
    let bar = |x: u32, y: u32| !((20..980).contains(&x) && (30..570).contains(&y));
    let mut lit = 0;
    for y in 0..still.size.y {
        for x in 0..still.size.x {
            let black = pixel(&still, x, y) == [0; 3];
            assert!(!bar(x, y) || black, "light in the bar at {x}, {y}");
            lit += u32::from(!black);
        }
    }
    assert!(lit > 20_000);
}

#[test]
fn a_picture_file_appears_complete_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let here = |name: &str| folder.path().join(name);
    let sentence = |name: &str| check_path(&here(name)).unwrap_err().to_string();
    assert!(sentence("a.bmp").ends_with(
        "unknown picture format \"bmp\"; allowed are .png, .apng, .exr, .mp4, .mov and .webm"
    ));
    assert!(sentence("nowhere/a.png").ends_with("cannot be written: there is no such folder"));
    std::fs::create_dir(here("folder.png")).unwrap();
    assert!(sentence("folder.png").ends_with("cannot be written: it is a folder"));

    // Too few bytes for its size: refused, with nothing left behind.
    let still = |rgb: &[u8]| Still {
        size: UVec2::new(2, 1),
        rgb: rgb.to_vec(),
    };
    let record = PictureRecord::default();
    assert!(write_png(&here("short.png"), &still(&[0; 3]), &record).is_err());
    check_path(&here("a.png")).unwrap();
    assert_eq!(
        std::fs::read_dir(folder.path()).unwrap().count(),
        1,
        "something was left behind"
    );

    let rgb = [10, 20, 30, 40, 50, 60];
    write_png(&here("a.png"), &still(&rgb), &record).unwrap();
    write_png(&here("a.png"), &still(&rgb), &record).unwrap();
    assert_eq!(
        image::open(here("a.png")).unwrap().to_rgb8().into_raw(),
        rgb
    );
    // As readable as any other new file.
    std::fs::write(here("other"), b"").unwrap();
    let rights = |name: &str| std::fs::metadata(here(name)).unwrap().permissions();
    assert_eq!(rights("a.png"), rights("other"));
}
