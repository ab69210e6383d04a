//! The light of the picture: the disk's edges, the shadow under bloom, and the exposure.

use super::{Drawer, luminance, pixel, plain, preset, smooth};
use glam::{DVec2, UVec2};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::optics::worldline::Worldline;
use lightfall_core::scene::presets::PRESETS;
use lightfall_core::scene::{Method, ObserverKind, Scene, SkyMode, ToneCurve};
use lightfall_picture::{HeadlessOptions, Still, Studio, render};

/// The scene at an eighth of its size, without cells.
fn eighth(mut scene: Scene) -> (Scene, UVec2) {
    let size = scene.picture.size() / 8;
    scene.picture.bypass = true;
    (scene.picture.width, scene.picture.height) = size.into();
    (scene.picture.grid_width, scene.picture.grid_height) = size.into();
    (scene, size)
}

/// Whether each pixel lies in the shadow, rows from the top: the rays through its middle and its
/// corners end in the hole and meet no disk, so that no rounding decides.
fn shadow(scene: &Scene) -> Vec<bool> {
    let reference = Reference::new(scene).unwrap();
    let (size, axes) = (scene.picture.size(), scene.camera.tetrad_from_camera());
    let dark = |x: f64, y: f64| {
        let looking = scene.camera.looking(DVec2::new(x, y), size.as_dvec2());
        let trace = reference.trace(axes * looking);
        trace.outcome == Outcome::Captured && trace.hits[0].is_none()
    };
    let row = |y: u32| -> Vec<bool> {
        let corners = 0..=size.x;
        corners.map(|x| dark(f64::from(x), f64::from(y))).collect()
    };
    let corners: Vec<Vec<bool>> = (0..=size.y).map(row).collect();
    (0..size.y)
        .flat_map(|y| (0..size.x).map(move |x| (x, y)))
        .map(|(x, y)| {
            let rows = [&corners[y as usize], &corners[y as usize + 1]];
            rows.into_iter()
                .all(|row| row[x as usize] && row[x as usize + 1])
                && dark(f64::from(x) + 0.5, f64::from(y) + 0.5)
        })
        .collect()
}

/// The scenes of preset 8's fall as the window flies it, a second apart.
fn fall_of_preset_8() -> Vec<Scene> {
    let mut scene = preset(8);
    scene.observer.kind = ObserverKind::Rain;
    let mut worldline = Worldline::start(&scene).unwrap();
    let mut fall = vec![scene.clone()];
    loop {
        let limit = worldline.advance(0.1 * scene.camera.r.powf(1.5), &mut scene);
        fall.push(scene.clone());
        if limit.is_some() {
            return fall;
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn bloom_lightens_no_shadow_and_the_fall_of_preset_8_is_neither_black_nor_white() {
    // Matter with depth stands before the shadow.
    let presets = PRESETS.iter().map(|found| found.scene(&[]).unwrap());
    let presets = presets.filter(|scene| !scene.has_medium());
    let fall = fall_of_preset_8().into_iter().step_by(3);
    let scenes = presets.map(|scene| (scene, false));
    let scenes = scenes.chain(fall.map(|scene| (scene, true)));
    let mut shadows = 0;
    let mut drawer = Drawer::default();
    for (scene, falls) in scenes {
        let (mut scene, size) = eighth(scene);
        // The craft may stand before the shadow.
        scene.probe.enabled = false;
        let what = format!("{} at r {}", scene.name, scene.camera.r);
        let shadow = shadow(&scene);
        if falls {
            assert_neither_black_nor_white(&what, &drawer.draw(&scene, size), &shadow);
        }
        // With much more bloom than any preset has.
        scene.picture.bloom = 0.3;
        let still = drawer.draw(&scene, size);
        let pixels = still.rgb.chunks_exact(3).zip(&shadow);
        let dark = pixels.filter_map(|(pixel, dark)| dark.then_some(pixel.iter().max()?));
        let brightest = dark.max().copied().unwrap_or(0);
        assert!(brightest <= 1, "{what}: {brightest}/255 in the shadow");
        shadows += usize::from(shadow.iter().filter(|dark| **dark).count() > 12);
    }
    assert!(shadows > 15, "only {shadows} pictures show a shadow");
}

/// Asserts that most of the pixels outside the shadow are less than white, and some more than black.
fn assert_neither_black_nor_white(what: &str, still: &Still, shadow: &[bool]) {
    let pixels = still.rgb.chunks_exact(3).zip(shadow);
    let lit: Vec<u8> = pixels
        .filter_map(|(pixel, dark)| (!dark).then_some(pixel.iter().copied().min()?))
        .collect();
    let white = lit.iter().filter(|least| **least > 250).count() as f64 / lit.len() as f64;
    let bright = still.rgb.iter().filter(|channel| **channel > 60).count();
    assert!(
        white < 0.4 && bright > 250,
        "{what}: {white} of the lit pixels are white, {bright} channels bright"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn no_dark_rim_surrounds_the_disk() {
    for (method, spin) in [(Method::Closed, 0.0), (Method::Mino, 0.9)] {
        let (mut scene, size) = plain(preset(2));
        (scene.method, scene.hole.spin) = (method, spin);
        // Single rays: the mean of several can lie between the sky and the shadow.
        scene.picture.antialias = false;
        scene.sky.mode = SkyMode::Grid;
        scene.picture.exposure_ev = 2.0;
        // So hot that every part of the disk outshines the sky: only a rim can be darker.
        scene.disk.temperature_k = 18_000.0;
        let with_disk = render(&scene, size).unwrap();
        scene.disk.enabled = false;
        let behind = render(&scene, size).unwrap();
        // What lies behind at least, wherever the sky is: its colour between the lines.
        let sky = |still: &Still, x, y| luminance(still, x, y);
        let all = || (0..size.y).flat_map(|y| (0..size.x).map(move |x| (x, y)));
        let fill = all()
            .map(|(x, y)| sky(&behind, x, y))
            .filter(|light| *light > 1e-4)
            .fold(f64::INFINITY, f64::min);
        // Cuts along the horizon line, through both ends of the disk, and upward from the shadow,
        // through the inner and the outer edge of the arch.
        let (row, column) = (size.y / 2 + 20, size.x / 2);
        let cuts = (0..size.x).map(|x| (x, row));
        let cuts = cuts.chain((0..size.y / 2).map(|y| (column, y)));
        let mut edges = 0;
        for (x, y) in cuts {
            if sky(&behind, x, y) > 0.0 {
                let light = sky(&with_disk, x, y);
                // One level of eight bits, up or down by noise.
                assert!(
                    light > 0.8 * fill,
                    "{light} at {x}, {y}, where {fill} lies behind"
                );
                edges += u32::from(pixel(&with_disk, x, y) != pixel(&behind, x, y));
            }
        }
        assert!(edges > 300, "the cuts cross the disk: {edges} pixels");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_spinning_hole_with_a_wide_disk_is_well_exposed() {
    // The light meter alone. Preset 2 asks for a darker picture, by its bias, and its disk has broad
    // fades and is too cool to shine far out.
    let (mut scene, size) = eighth(smooth(2));
    (scene.disk.temperature_k, scene.disk.edge_taper) = (8500.0, 0.12);
    (scene.picture.exposure_bias, scene.picture.tone_curve) = (0.0, ToneCurve::Neutral);
    for spin in [0.0, 0.9, 0.998] {
        (scene.hole.spin, scene.disk.follow_isco) = (spin, true);
        let studio = Studio::with_options(&scene, size, HeadlessOptions::default());
        let mut studio = studio.unwrap();
        let still = studio.picture().unwrap();
        assert!(studio.scene().picture.automatic_exposure);
        let reference = Reference::new(&scene).unwrap();
        let axes = scene.camera.tetrad_from_camera();
        // The outer half of the disk, as the camera sees it.
        let outer: Vec<f64> = (0..size.y)
            .flat_map(|y| (0..size.x).map(move |x| (x, y)))
            .filter_map(|(x, y)| {
                let place = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                let looking = scene.camera.looking(place, size.as_dvec2());
                let hit = reference.trace(axes * looking).hits[0]?;
                (7.0..10.5)
                    .contains(&hit.r)
                    .then(|| luminance(&still, x, y))
            })
            .collect();
        let visible = outer.iter().filter(|light| **light > 0.004).count();
        // Half a percent of white is level 20 of 255.
        assert!(
            outer.len() > 120 && visible as f64 > 0.9 * outer.len() as f64,
            "spin {spin}: {visible} of {} pixels of the outer disk are visible",
            outer.len()
        );
    }
}
