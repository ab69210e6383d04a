//! The light meter, against what it is for: a picture that is neither black nor white, and steady.

use lightfall_core::gpu::Drawable;
use lightfall_core::optics::exposure::exposed;
use lightfall_core::optics::exposure::metered_exposure;
use lightfall_core::optics::worldline::Worldline;
use lightfall_core::scene::journey;
use lightfall_core::scene::{ObserverKind, Scene, SkyMode, ToneCurve, View, presets};

fn preset(number: &str) -> Scene {
    presets::find(number).unwrap().scene(&[]).unwrap()
}

fn metered(scene: &Scene) -> f64 {
    metered_exposure(scene).unwrap().unwrap()
}

#[test]
fn a_disk_twice_as_bright_gets_half_the_exposure() {
    let mut scene = preset("2");
    scene.sky.mode = SkyMode::Off;
    let once = metered(&scene);
    scene.disk.brightness *= 2.0;
    // One power of two; the meter rounds to a thousandth, twice.
    assert!((once - metered(&scene) - 1.0).abs() < 2e-3);
}

#[test]
fn the_metered_exposure_of_a_metered_scene_is_the_same() {
    for number in ["2", "7", "8"] {
        let mut scene = preset(number);
        scene.picture.automatic_exposure = true;
        let once = exposed(&scene);
        assert_eq!(exposed(&once), once);
        scene.picture.automatic_exposure = false;
        assert_eq!(exposed(&scene), scene);
    }
}

#[test]
fn nothing_that_shines_asks_for_no_exposure() {
    let mut scene = preset("2");
    (scene.disk.enabled, scene.sky.mode) = (false, SkyMode::Off);
    assert_eq!(metered_exposure(&scene).unwrap(), None);
    // Nor does a view whose colours look the same at every exposure.
    let classes = Scene {
        view: View::Classes,
        ..preset("2")
    };
    assert_eq!(metered_exposure(&classes).unwrap(), None);
}

#[test]
fn a_sky_alone_has_the_exposure_that_suits_stars() {
    let mut scene = preset("1");
    scene.disk.enabled = false;
    scene.camera.r = 1e4;
    (scene.picture.tone_curve, scene.picture.exposure_bias) = (ToneCurve::Neutral, 0.0);
    // Far away no light is shifted. Light of 6500 K is not quite white: its largest channel is 4 %
    // above its luminance, a seventeenth of a power of two.
    assert!((metered(&scene) - 1.2).abs() < 0.1, "{}", metered(&scene));
}

#[test]
fn the_exposure_is_steady_along_the_journey_and_down_a_fall() {
    let journey = journey::load("journey", journey::DEFAULT).unwrap();
    let mut exposures = Vec::new();
    let frames = 30.0;
    let mut scene = preset("2");
    for frame in 0..(20.0 * frames) as u32 {
        journey.apply(40.0 + f64::from(frame) / frames, &mut scene);
        if Drawable::new(scene.clone()).is_ok() {
            exposures.push(metered(&scene));
        }
    }
    let largest = |exposures: &[f64]| {
        let steps = exposures.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        steps.fold(0.0, f64::max)
    };
    // A fifth of a power of two in a thirtieth of a second is what the eye takes for a flicker
    // where it goes up and down; the path itself asks for less than a twentieth.
    assert!(largest(&exposures) < 0.2, "{}", largest(&exposures));
    assert!(exposures.len() > 500);
    let mut falling = preset("8");
    falling.observer.kind = ObserverKind::Rain;
    let mut worldline = Worldline::start(&falling).unwrap();
    let mut exposures = vec![metered(&falling)];
    // The fall as the window shows it: 0.1 r^(3/2) a second, in thirtieths.
    while worldline
        .advance(0.1 / frames * falling.camera.r.powf(1.5), &mut falling)
        .is_none()
    {
        exposures.extend(metered_exposure(&falling).unwrap());
    }
    assert!(largest(&exposures) < 0.4, "{}", largest(&exposures));
}
