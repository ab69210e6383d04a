//! Two scenes side by side, and their difference.

use super::{preset, without_spin};
use glam::UVec2;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Method, Scene, SkyMode, View};
use lightfall_picture::{HeadlessOptions, PassTime, Studio, render};
use lightfall_render::{Captured, Chain, ComparedScene, ComparisonLayout, ComparisonMode};
use lightfall_render::{EMPTY_PASSES, Pinned, TwoScenes};

pub(super) const SIZE: UVec2 = UVec2::new(160, 90);
/// The first column right of a divider in the middle.
pub(super) const HALF: usize = 80;
const MIDDLE: ComparisonMode = ComparisonMode::SideBySide { divider: 0.5 };

/// A small picture of a preset.
pub(super) fn small(number: usize) -> Scene {
    smaller(preset(number))
}

/// The scene as a small picture without bloom, which would spread over the divider, and of single
/// rays: whether a pixel beside the divider is refined depends on what is not drawn there. It is
/// shown pixel by pixel, at a fixed exposure: the pinned scene takes over that of the current one,
/// and the light of stars is counted in units that follow the exposure.
pub(super) fn smaller(mut scene: Scene) -> Scene {
    (scene.picture.width, scene.picture.height) = SIZE.into();
    (scene.picture.grid_width, scene.picture.grid_height) = (80, 45);
    (scene.picture.bypass, scene.picture.bloom) = (true, 0.0);
    (scene.picture.antialias, scene.picture.automatic_exposure) = (false, false);
    scene
}

pub(super) fn studio(scene: &Scene) -> Studio {
    let options = HeadlessOptions {
        timed: true,
        light: true,
        ..HeadlessOptions::default()
    };
    Studio::with_options(scene, SIZE, options).unwrap()
}

/// The light of a scene alone, by passes that may have drawn other ones.
pub(super) fn light(alone: &mut Studio, scene: &Scene) -> Captured {
    alone.show(scene).unwrap();
    alone.light().unwrap()
}

/// The number that the bits of a half float stand for (IEEE 754 binary16).
fn number(bits: u16) -> f64 {
    let (exponent, mantissa) = (i32::from(bits >> 10 & 31), f64::from(bits & 1023));
    let size = match exponent {
        0 => mantissa * 2f64.powi(-24),
        31 => f64::INFINITY,
        _ => (1.0 + mantissa / 1024.0) * 2f64.powi(exponent - 15),
    };
    if bits >> 15 == 1 { -size } else { size }
}

/// Changes of one thing each of preset 2 without spin, all of which can be drawn.
fn changes() -> [(&'static str, fn(&mut Scene)); 6] {
    [
        ("lensing", |scene| scene.effects.lensing = false),
        ("method", |scene| scene.method = Method::Verlet),
        ("spin", |scene| scene.hole.spin = 0.9),
        ("view", |scene| scene.view = View::Redshift),
        ("sky", |scene| scene.sky.mode = SkyMode::Grid),
        ("disk", |scene| scene.disk.temperature_k = 5000.0),
    ]
}

/// Asserts that `picture` is `left` in the first columns and `right` in the others.
fn assert_halves(
    what: &str,
    picture: &Captured,
    left: &Captured,
    right: &Captured,
    columns: usize,
) {
    let mut differ = 0;
    for (i, pixel) in picture.rgba.iter().enumerate() {
        let side = if i % SIZE.x as usize >= columns {
            right
        } else {
            left
        };
        assert_eq!(pixel[..3], side.rgba[i][..3], "{what}: pixel {i}");
        differ += usize::from(left.rgba[i][..3] != right.rgba[i][..3]);
    }
    assert!(differ > 250, "{what} changes nothing, so it tests nothing");
}

/// Asserts that `shown` is the gain times the difference of two pictures.
fn assert_difference(what: &str, gain: u32, shown: &Captured, left: &Captured, right: &Captured) {
    let mut lit = 0;
    for (i, pixel) in shown.rgba.iter().enumerate() {
        for (channel, shown) in pixel[..3].iter().enumerate() {
            let [a, b] = [left, right].map(|light| number(light.rgba[i][channel]));
            let expected = (f64::from(gain) * (a - b).abs()).min(60_000.0);
            // One rounding to a half float, whose last place is 2^-10 of a number, and 2^-24 of the
            // smallest ones; a device may round either way.
            let tolerance = expected * 2f64.powi(-10) + 2f64.powi(-24);
            let shown = number(*shown);
            assert!(
                (shown - expected).abs() <= tolerance,
                "{what} x{gain}, pixel {i}: {shown} and not {expected}"
            );
            lit += usize::from(shown > 0.0);
        }
    }
    assert!(lit > 250, "{what}: only {lit} channels differ");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn each_side_of_the_divider_shows_its_scene_and_a_difference_is_the_gain_times_that_of_the_two() {
    let pinned = smaller(without_spin(2));
    let (mut alone, mut studio) = (studio(&pinned), studio(&pinned));
    let left = light(&mut alone, &pinned);
    for (what, change) in changes() {
        let mut scene = pinned.clone();
        change(&mut scene);
        let right = light(&mut alone, &scene);
        studio.show(&scene).unwrap();
        let mut compared = |mode| {
            studio.compare(Some((&pinned, mode)));
            studio.light().unwrap()
        };
        for (divider, columns) in [(0.5, HALF), (0.25, 40), (0.49, 78), (0.0, 0), (1.0, 160)] {
            let both = compared(ComparisonMode::SideBySide { divider });
            assert_halves(what, &both, &left, &right, columns);
        }
        for gain in [1, 16, 256] {
            let difference = compared(ComparisonMode::Difference { gain });
            if scene.view == pinned.view {
                assert_difference(what, gain, &difference, &left, &right);
            } else {
                // Colours with other meanings have no difference: the current scene is drawn.
                assert!(difference.rgba == right.rgba, "{what}");
            }
        }
        studio.compare(None);
        assert!(
            studio.light().unwrap() == right,
            "{what}: the comparison has not ended"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn edges_are_refined_on_both_sides_of_the_divider_also_beside_a_view_that_shows_no_light() {
    let refined = |mut scene: Scene| {
        scene.picture.antialias = true;
        scene
    };
    let pinned = refined(smaller(without_spin(2)));
    let (mut alone, mut studio) = (studio(&pinned), studio(&pinned));
    let single = light(&mut alone, &smaller(without_spin(2)));
    let left = light(&mut alone, &pinned);
    assert!(left.rgba != single.rgba, "there is nothing to refine");
    for (what, change) in changes() {
        let mut scene = pinned.clone();
        change(&mut scene);
        let right = light(&mut alone, &scene);
        studio.show(&scene).unwrap();
        studio.compare(Some((&pinned, MIDDLE)));
        let both = studio.light().unwrap();
        for (i, pixel) in both.rgba.iter().enumerate() {
            // In the two columns beside the divider, marks depend on what is not drawn.
            let column = i % SIZE.x as usize;
            let side = if column >= HALF { &right } else { &left };
            let beside = (HALF - 1..=HALF).contains(&column);
            assert!(
                beside || pixel[..3] == side.rgba[i][..3],
                "{what}: pixel {i}"
            );
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_pinned_scene_has_the_camera_and_the_probe_of_the_current_one() {
    // The disk of the current scene lights the probe, so both have the same disk.
    let mut pinned = Scene {
        disk: preset(6).disk,
        ..small(2)
    };
    pinned.hole.spin = preset(6).hole.spin;
    let mut alone = studio(&pinned);
    for antialias in [false, true] {
        let mut scene = small(6);
        scene.probe.antialias = antialias;
        scene.effects.lensing = false;
        let seen = Scene {
            camera: scene.camera,
            observer: scene.observer,
            probe: scene.probe,
            picture: scene.picture,
            ..pinned.clone()
        };
        let mut studio = studio(&pinned);
        studio.compare(Some((&pinned, MIDDLE)));
        studio.settle().unwrap();
        studio.show(&scene).unwrap();
        let both = studio.light().unwrap();
        let [left, right] = [&seen, &scene].map(|scene| light(&mut alone, scene));
        assert_halves("another camera", &both, &left, &right, HALF);
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_cell_shows_one_of_the_two_scenes() {
    let with_cells = |mut scene: Scene| {
        scene.picture.bypass = false;
        // 2.5 pixels to a cell: most dividers would cut through one.
        (scene.picture.grid_width, scene.picture.grid_height) = (64, 36);
        scene
    };
    let (pinned, mut scene) = (with_cells(small(2)), with_cells(small(2)));
    scene.sky.mode = SkyMode::Grid;
    let size = UVec2::new(64, 36);
    let [left, right] = [&pinned, &scene].map(|scene| render(scene, size).unwrap().rgb);
    let mut studio = Studio::open(&scene, size).unwrap();
    for divider in [0.3, 0.5, 0.71] {
        studio.compare(Some((&pinned, ComparisonMode::SideBySide { divider })));
        studio.settle().unwrap();
        let both = studio.picture().unwrap().rgb;
        let columns = (64.0 * divider).round() as usize;
        // Where 2.5 pixels to a cell end within a pixel, the pixel belongs to the left cell.
        let beside = columns % 2 == 1;
        for (i, pixel) in both.chunks_exact(3).enumerate() {
            let column = i % 64;
            if beside && column == columns {
                continue;
            }
            let side = if column >= columns { &right } else { &left };
            assert_eq!(
                pixel,
                &side[3 * i..3 * i + 3],
                "cell {i}, divider {divider}"
            );
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_difference_of_a_scene_with_itself_is_black() {
    for number in [2, 6, 8] {
        let mut scene = small(number);
        scene.picture.bloom = 0.1;
        scene.probe.antialias = true;
        let mut studio = studio(&scene);
        studio.compare(Some((&scene, ComparisonMode::Difference { gain: 256 })));
        let black = studio.light().unwrap().rgba;
        assert!(
            black.iter().all(|pixel| pixel[..3] == [0; 3]),
            "preset {number}"
        );
        let shown = studio.picture().unwrap().rgb;
        assert!(shown.iter().all(|channel| *channel == 0), "preset {number}");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_comparison_runs_the_passes_of_its_chain_and_none_while_nothing_changes() {
    let mut scene = small(6);
    scene.picture.bloom = 0.1;
    let mut pinned = scene.clone();
    pinned.effects.lensing = false;
    let mut studio = studio(&scene);
    let modes = [
        (MIDDLE, ComparisonLayout::SideBySide { columns: 80 }),
        (
            ComparisonMode::TwoPictures,
            ComparisonLayout::TwoPictures { columns: 80 },
        ),
        (
            ComparisonMode::Difference { gain: 16 },
            ComparisonLayout::Difference { gain: 16.0 },
        ),
    ];
    for (mode, layout) in modes {
        studio.compare(Some((&pinned, mode)));
        studio.settle().unwrap();
        let times = studio.time(5).unwrap();
        if times.is_empty() {
            println!("skipped: the device has no timestamps");
            return;
        }
        for PassTime {
            pass, median_ms, ..
        } in &times
        {
            println!("{mode:?}: {pass} {median_ms:.3} ms");
        }
        let compared = Drawable::new(pinned.clone()).unwrap();
        let compared = ComparedScene::Drawn(Box::new(TwoScenes {
            pinned: compared,
            current: None,
            layout,
        }));
        let chain = Chain::of(&scene).comparing(&compared);
        let sorted = |mut names: Vec<&str>| {
            names.retain(|name| !EMPTY_PASSES.contains(name));
            names.sort_unstable();
            names.join(" ")
        };
        let ran = times.iter().filter(|pass| pass.median_ms > 0.0);
        let kept = times.iter().filter(|pass| pass.kept_ms > 0.0);
        assert_eq!(
            sorted(ran.map(|pass| pass.pass.as_str()).collect()),
            sorted(chain.passes())
        );
        assert_eq!(
            sorted(kept.map(|pass| pass.pass.as_str()).collect()),
            sorted(chain.idle_passes().to_vec())
        );
    }
    studio.compare(None);
    studio.settle().unwrap();
    assert!(studio.light().unwrap() == self::studio(&scene).light().unwrap());
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_moved_divider_and_another_gain_show_in_the_next_frame() {
    let scene = small(2);
    let mut pinned = small(2);
    pinned.disk.enabled = false;
    let mut studio = studio(&scene);
    for modes in [
        [0.5, 0.6].map(|divider| ComparisonMode::SideBySide { divider }),
        [4, 64].map(|gain| ComparisonMode::Difference { gain }),
    ] {
        let pictures = modes.map(|mode| {
            studio.compare(Some((&pinned, mode)));
            studio.settle().unwrap();
            studio.picture().unwrap().rgb
        });
        assert!(pictures[0] != pictures[1], "{modes:?}");
        studio.compare(Some((&pinned, modes[0])));
        assert!(studio.picture().unwrap().rgb == pictures[0], "{modes:?}");
    }
}

#[test]
fn the_pinned_observer_follows_flights_but_not_a_choice() {
    use lightfall_core::scene::ObserverKind::{Rain, Static, Zamo};
    // The horizon is at 1 r_s.
    let start = without_spin(2);
    let mut pinned = Pinned::new(&start);
    let drawn = |pinned: &Pinned| pinned.drawable().unwrap().observer.kind;
    // A flight that changes the observer changes both.
    let mut flown = start.clone();
    flown.camera.r -= 1.0;
    flown.observer.kind = Zamo;
    pinned.follow(&flown);
    assert_eq!(drawn(&pinned), Zamo);
    // A choice changes the current scene alone, and a flight afterwards leaves both as they are.
    flown.observer.kind = Rain;
    pinned.follow(&flown);
    flown.camera.r -= 1.0;
    pinned.follow(&flown);
    assert_eq!(drawn(&pinned), Zamo);
    assert_eq!(pinned.drawable().unwrap().camera, flown.camera);
    // Where the pinned observer cannot exist, the current one replaces it.
    let mut pinned = Pinned::new(&start);
    assert_eq!(drawn(&pinned), Static);
    let mut inside = start.clone();
    inside.observer.kind = Rain;
    pinned.follow(&inside);
    assert_eq!(drawn(&pinned), Static);
    inside.camera.r = 0.9;
    pinned.follow(&inside);
    assert_eq!(drawn(&pinned), Rain);
    // What no observer can see from there is refused with the reason.
    let mut flat = start.clone();
    flat.effects.lensing = false;
    let mut pinned = Pinned::new(&flat);
    pinned.follow(&inside);
    assert!(pinned.drawable().is_err());
}
