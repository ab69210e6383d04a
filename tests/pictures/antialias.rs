//! Smooth edges and means of frames, against pictures of many single rays.

use super::{Drawer, half, pixel, plain, preset, smooth};
use glam::{DVec2, DVec3, UVec2};
use lightfall_core::geometry::schwarzschild::shadow_half_angle_static;
use lightfall_core::scene::{Scene, SkyMode};
use lightfall_lab::bench::{PictureError, PictureSetting, measured_part};
use lightfall_picture::{HeadlessOptions, Studio, brightness, render};
use std::f64::consts::TAU;

/// Frames of a truth in these tests. Its own error, by that of 64 frames and the rate 1/N of
/// Sobol's sequence, is a fifth of the bars; `lightfall bench --pictures` takes 1024, which would
/// take minutes here.
const TRUE_SAMPLES: u32 = 128;

/// A studio that keeps the light of pictures of this scene.
fn studio(scene: &Scene) -> Studio {
    let options = HeadlessOptions {
        light: true,
        ..HeadlessOptions::default()
    };
    let first = PictureSetting::new(false, 1).of(scene);
    Studio::with_options(&first, scene.picture.size(), options).unwrap()
}

/// The shown brightness of a part of the scene's picture (left, top, width, height).
fn shown(studio: &mut Studio, scene: &Scene, setting: PictureSetting, part: [u32; 4]) -> Vec<f64> {
    let drawn = setting.of(scene);
    studio.show(&drawn).unwrap();
    let captured = studio.light().unwrap();
    brightness(&captured, part, drawn.picture.exposure_ev)
}

#[test]
#[ignore = "needs a graphics adapter"]
fn refined_edges_are_as_right_as_many_rays_in_every_pixel() {
    let scene = smooth(2);
    let part = measured_part(scene.picture.size().to_array());
    let mut studio = studio(&scene);
    let mut part_of = |setting| shown(&mut studio, &scene, setting, part);
    let truth = part_of(PictureSetting::new(false, TRUE_SAMPLES));
    let error = |found: &[f64]| PictureError::between(found, &truth);
    let single = error(&part_of(PictureSetting::new(false, 1)));
    let refined = error(&part_of(PictureSetting::new(true, 1)));
    let mean = error(&part_of(PictureSetting::new(true, 16)));
    // The bars: errors that nobody sees. One ray a pixel does not hold them, so they test something.
    assert!(single.rms > 0.003, "{single:?}");
    assert!(refined.rms <= 0.003 && refined.p99 <= 0.006, "{refined:?}");
    // Frames at other places bring the picture nearer to the truth, to the truth's own error.
    assert!(mean.rms < 0.7 * refined.rms, "{mean:?}, {refined:?}");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_mean_of_frames_errs_less_the_more_there_are() {
    // The disk's structure is filtered by the footprint of a ray, which must shrink with the number
    // of rays: else the picture would tend to one that is blurred.
    let mut scene = preset(3);
    scene.hole.spin = 0.0;
    (scene.picture.width, scene.picture.height) = (480, 270);
    let part = measured_part(scene.picture.size().to_array());
    let mut studio = studio(&scene);
    let mut part_of = |setting| shown(&mut studio, &scene, setting, part);
    let truth = part_of(PictureSetting::new(false, 2 * TRUE_SAMPLES));
    for antialias in [false, true] {
        let errors = [1, 4, 16].map(|samples| {
            let found = part_of(PictureSetting::new(antialias, samples));
            PictureError::between(&found, &truth).rms
        });
        // Random places would halve the error with every step. Sobol's do better at edges; with
        // refined edges little but the truth's own error is left.
        assert!(
            errors[1] < 0.75 * errors[0] && errors[2] < 0.75 * errors[1],
            "antialias {antialias}: {errors:?}"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_photon_ring_has_no_dashes() {
    let scene = smooth(3);
    let size = scene.picture.size();
    let mut studio = studio(&scene);
    let mut deviation = |setting| {
        let whole = shown(&mut studio, &scene, setting, [0, 0, size.x, size.y]);
        deviation_along_ring(&scene, &whole)
    };
    let truth = deviation(PictureSetting::new(false, TRUE_SAMPLES));
    let single = deviation(PictureSetting::new(false, 1));
    let refined = deviation(PictureSetting::new(true, 1));
    // What is left is the ring's own change of brightness. One ray a pixel breaks it into dashes.
    assert!(single > 1.2 * truth, "single {single}, truth {truth}");
    assert!(refined <= 1.2 * truth, "refined {refined}, truth {truth}");
}

/// A picture as small as a window on a software renderer draws it while something moves.
fn small(mut scene: Scene) -> Scene {
    let picture = &mut scene.picture;
    (picture.width, picture.height) = (360, 202);
    (picture.grid_width, picture.grid_height) = (360, 202);
    scene
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_photon_ring_is_whole_in_the_small_pictures_of_a_slow_machine_in_motion() {
    for number in [1, 3] {
        let scene = small(smooth(number));
        let size = scene.picture.size();
        let deviation = |moving: bool, setting: PictureSetting| {
            let options = HeadlessOptions {
                light: true,
                moving,
                ..HeadlessOptions::default()
            };
            let first = setting.of(&scene);
            let mut studio = Studio::with_options(&first, size, options).unwrap();
            let whole = shown(&mut studio, &scene, setting, [0, 0, size.x, size.y]);
            deviation_along_ring(&scene, &whole)
        };
        let truth = deviation(false, PictureSetting::new(false, TRUE_SAMPLES));
        let single = deviation(false, PictureSetting::new(false, 1));
        let quick = deviation(true, PictureSetting::new(true, 1));
        println!("preset {number}: truth {truth:.4}, single {single:.4}, quick {quick:.4}");
        // What is left is the ring's own change of brightness. One ray a pixel breaks it into beads.
        assert!(
            single > 1.2 * truth,
            "{number}: single {single}, truth {truth}"
        );
        assert!(
            quick <= 1.2 * truth,
            "{number}: quick {quick}, truth {truth}"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn an_einstein_ring_is_whole_at_every_resolution_and_its_second_image_has_no_dashes() {
    let mut scene = preset(5);
    // Without other stars.
    scene.sky.magnitude_limit = -2.0;
    for size in [
        UVec2::new(240, 135),
        UVec2::new(360, 202),
        UVec2::new(960, 540),
    ] {
        let mut scene = scene.clone();
        let picture = &mut scene.picture;
        (picture.width, picture.height) = size.into();
        (picture.grid_width, picture.grid_height) = size.into();
        let mut studio = studio(&scene);
        for antialias in [false, true] {
            // Bench's settings leave the star out.
            scene.picture.antialias = antialias;
            studio.show(&scene).unwrap();
            let captured = studio.light().unwrap();
            let part = [0, 0, size.x, size.y];
            let brightness = brightness(&captured, part, scene.picture.exposure_ev);
            let at = |x: u32, y: u32| brightness[(y * size.x + x) as usize];
            // The brightest pixel in each direction from the middle, outside the shadow.
            let shadow = shadow_half_angle_static(scene.camera.r).tan() / scene.pixel_angle();
            let along = |inner: f64, outer: f64| -> Vec<f64> {
                (0..720)
                    .map(|i| {
                        let (sin, cos) = (TAU * f64::from(i) / 720.0).sin_cos();
                        let middle = 0.5 * size.as_dvec2();
                        let steps = ((outer - inner) / 0.25) as u32;
                        (0..=steps)
                            .map(|step| {
                                middle + (inner + 0.25 * f64::from(step)) * DVec2::new(cos, sin)
                            })
                            .map(|place| at(place.x as u32, place.y as u32))
                            .fold(0.0, f64::max)
                    })
                    .collect()
            };
            let first = along(1.5 * shadow, 5.0 * shadow);
            let (least, most) = first
                .iter()
                .fold((1.0, 0.0), |(least, most): (f64, f64), x| {
                    (least.min(*x), most.max(*x))
                });
            println!("{size}, {antialias}: from {least:.3} to {most:.3}");
            // A break would be as dark as the sky beside it, which has a tenth at most.
            assert!(least > 0.4, "{size}, {antialias}: from {least} to {most}");
            // Light that went once around makes a ring of less than a thousandth of a pixel, whose light
            // is a hundredth of the star's: single rays that meet the star would be dashes.
            let second = along(shadow - 1.0, shadow + 1.5);
            let brightest = second.iter().copied().fold(0.0, f64::max);
            println!("second: up to {brightest:.3}");
            assert!(
                brightest < 0.35,
                "{size}, {antialias}: a dash of {brightest}"
            );
        }
    }
}

/// Standard deviation over mean of the brightness along the circle half a pixel outside the edge of
/// the shadow of a hole without spin, by bilinear interpolation.
fn deviation_along_ring(scene: &Scene, brightness: &[f64]) -> f64 {
    let size = scene.picture.size();
    let outside = shadow_half_angle_static(scene.camera.r) + 0.5 * scene.pixel_angle();
    let camera_from_tetrad = scene.camera.tetrad_from_camera().transpose();
    let at = |place: DVec2| {
        let corner = (place - 0.5).floor();
        let share = place - 0.5 - corner;
        let of = |x: f64, y: f64| brightness[(y * f64::from(size.x) + x) as usize];
        let row = |y: f64| of(corner.x, y) * (1.0 - share.x) + of(corner.x + 1.0, y) * share.x;
        row(corner.y) * (1.0 - share.y) + row(corner.y + 1.0) * share.y
    };
    let along: Vec<f64> = (0..2000)
        .map(|i| {
            let angle = TAU * f64::from(i) / 2000.0;
            let (sideways, inward) = outside.sin_cos();
            let direction = DVec3::new(-inward, sideways * angle.cos(), sideways * angle.sin());
            let place = scene
                .camera
                .pixel_of(camera_from_tetrad * direction, size.as_dvec2());
            at(place.unwrap())
        })
        .collect();
    let mean = along.iter().sum::<f64>() / along.len() as f64;
    let squares: f64 = along.iter().map(|x| (x - mean).powi(2)).sum();
    assert!(mean > 0.02, "there is no ring: {mean}");
    (squares / along.len() as f64).sqrt() / mean
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_mean_has_the_same_bytes_in_every_run_and_begins_anew_after_a_change() {
    let mut scene = preset(3);
    (scene.picture.width, scene.picture.height) = (320, 180);
    (scene.picture.grid_width, scene.picture.grid_height) = (320, 180);
    scene.picture.samples = 4;
    let size = scene.picture.size();
    let first = render(&scene, size).unwrap().rgb;
    assert!(render(&scene, size).unwrap().rgb == first);
    let mut other = scene.clone();
    other.camera.phi_deg = 30.0;
    let mut studio = Studio::with_options(&other, size, HeadlessOptions::default()).unwrap();
    assert!(studio.picture().unwrap().rgb != first);
    studio.show(&scene).unwrap();
    // A frame of the mean, which must not be left in the next one.
    studio.picture().unwrap();
    studio.show(&other).unwrap();
    studio.picture().unwrap();
    studio.show(&scene).unwrap();
    studio.settle().unwrap();
    assert!(studio.picture().unwrap().rgb == first);
}

#[test]
#[ignore = "needs a graphics adapter"]
fn what_the_foreground_covers_even_in_part_is_not_refined() {
    let (mut scene, size) = plain(half(preset(6)));
    scene.probe.antialias = true;
    let mut drawer = Drawer::default();
    let mut picture = |antialias: bool, probe: bool| {
        let mut scene = scene.clone();
        (scene.picture.antialias, scene.probe.enabled) = (antialias, probe);
        drawer.draw(&scene, size)
    };
    let (refined, single) = (picture(true, true), picture(false, true));
    let without = [picture(true, false), picture(false, false)];
    let (mut craft, mut edges) = (0, 0);
    for y in 0..size.y {
        for x in 0..size.x {
            let shown = pixel(&single, x, y);
            let is_craft = without.iter().all(|still| pixel(still, x, y) != shown);
            let same = pixel(&refined, x, y) == shown;
            assert!(!is_craft || same, "the probe changed at {x}, {y}");
            craft += u32::from(is_craft);
            edges += u32::from(!same);
        }
    }
    assert!(craft > 500, "the probe covers only {craft} pixels");
    assert!(edges > 200, "only {edges} pixels are refined");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn squeezed_lines_of_the_grid_do_not_break_up() {
    // A hole without a disk before the grid: between the shadow and Einstein's ring the whole sky is
    // squeezed into a few pixels.
    let mut scene = smooth(3);
    scene.disk.enabled = false;
    scene.sky.mode = SkyMode::Grid;
    (scene.picture.exposure_ev, scene.camera.pitch_deg) = (2.0, 0.0);
    let draw = |samples: u32| {
        let (mut scene, size) = plain(scene.clone());
        (scene.picture.antialias, scene.picture.samples) = (false, samples);
        render(&scene, size).unwrap()
    };
    let (single, truth) = (draw(1), draw(64));
    let radius = shadow_half_angle_static(scene.camera.r).tan() / scene.pixel_angle();
    let centre = 0.5 * scene.picture.size().as_dvec2();
    let mut squares = 0.0;
    let mut count = 0.0;
    for y in 0..scene.picture.height {
        for x in 0..scene.picture.width {
            let distance = (UVec2::new(x, y).as_dvec2() + 0.5 - centre).length() - radius;
            if (3.0..20.0).contains(&distance) {
                let level = |still| f64::from(pixel(still, x, y)[1]) / 255.0;
                squares += (level(&single) - level(&truth)).powi(2);
                count += 1.0;
            }
        }
    }
    let rms = f64::sqrt(squares / count);
    // Lines as thin as the lens makes them err by 0.1 and more here. Filtered ones are softer than
    // the mean of 64 rays, by a fifth of a line's own contrast of 0.3.
    assert!(count > 1000.0 && rms < 0.06, "rms {rms} of {count} pixels");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn edges_in_motion_take_less_than_half_of_the_time_of_edges_at_rest() {
    let scene = small(preset(2));
    let size = scene.picture.size();
    let times = [true, false].map(|moving| {
        let options = HeadlessOptions {
            timed: true,
            moving,
            ..HeadlessOptions::default()
        };
        let mut studio = Studio::with_options(&scene, size, options).unwrap();
        let passes = studio.time(15).unwrap();
        let of = |name: &str| {
            let found = passes.iter().find(|pass| pass.pass == name);
            found.map_or(0.0, |pass| pass.median_ms)
        };
        let all: f64 = passes.iter().map(|pass| pass.median_ms).sum();
        [of("refine"), of("edges"), all]
    });
    println!("refine, edges and all, in motion and at rest: {times:?}");
    let [[in_motion, ..], [at_rest, ..]] = times;
    // A quarter of the rays at edges, and none in the filaments of the disk.
    assert!(in_motion > 0.0 && in_motion < 0.5 * at_rest, "{times:?}");
}
