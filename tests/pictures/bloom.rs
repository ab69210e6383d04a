//! The light of stars in the bloom, against the light that the stars have.

use super::tiles::scene;
use exr::prelude::f16;
use glam::{DVec2, UVec2};
use lightfall_core::scene::{SkyMode, ToneCurve};
use lightfall_picture::{HeadlessOptions, PngBits, Studio};

/// Share of the light that bloom spreads.
const BLOOM: f64 = 0.5;

/// Light of a star on a pixel of a picture with 1080 rows.
const PEAK: f64 = 3.0;

/// Places of stars, in heights of the picture: far apart, and each at another place within its texel.
fn star_places() -> impl Iterator<Item = DVec2> {
    (0..5).flat_map(|row| {
        (0..5).map(move |column| {
            let turn = f64::from(5 * row + column);
            let beside = DVec2::new((0.618 * turn).fract(), (0.755 * turn).fract()) * 0.01;
            DVec2::new(f64::from(column), f64::from(row)) * 0.18 + 0.14 + beside
        })
    })
}

/// The light of white stars as half floats, each with the image that the star passes draw: a cubic
/// B-spline, one pixel wide up to 1080 rows and wider in proportion above. A star's light over its solid
/// angle is that of `peak` on a pixel of a picture with 1080 rows.
fn stars_on_black(rows: u32, peak: f64) -> Vec<u8> {
    let stretch = (f64::from(rows) / 1080.0).max(1.0);
    let spline = |x: f64| {
        let x = x.abs() / stretch;
        let cube = |x: f64| x.max(0.0).powi(3);
        (cube(2.0 - x) - 4.0 * cube(1.0 - x)) / 6.0 / stretch
    };
    let flux = peak * (f64::from(rows) / 1080.0).powi(2);
    let mut light = vec![0.0; (rows * rows) as usize];
    for star in star_places() {
        let place = star * f64::from(rows);
        let reach = (2.0 * stretch).ceil() as i32 + 1;
        for y in -reach..=reach {
            for x in -reach..=reach {
                let pixel = place.floor() + DVec2::new(f64::from(x), f64::from(y));
                let off = pixel + 0.5 - place;
                let at = pixel.y as usize * rows as usize + pixel.x as usize;
                light[at] += flux * spline(off.x) * spline(off.y);
            }
        }
    }
    let half = |value: f64| f16::from_f64(value).to_bits().to_le_bytes();
    light
        .into_iter()
        .flat_map(|light| [light, light, light, 1.0].map(half))
        .flatten()
        .collect()
}

/// The light in a picture with 1080 rows' worth of solid angle that bloom adds beside the stars.
fn light_beside_stars(rows: u32, peak: f64) -> f64 {
    let mut scene = scene(2, UVec2::splat(rows));
    (scene.disk.enabled, scene.sky.mode) = (false, SkyMode::Off);
    scene.picture.automatic_exposure = false;
    (scene.picture.exposure_ev, scene.picture.tone_curve) = (0.0, ToneCurve::Reinhard);
    (scene.picture.bloom, scene.picture.antialias) = (BLOOM, false);
    let options = HeadlessOptions {
        levels: Some(PngBits::Sixteen.top()),
        ..HeadlessOptions::default()
    };
    let mut studio = Studio::with_options(&scene, UVec2::ONE, options).unwrap();
    let mut shown = |peak: f64| {
        studio.give_light(Some(stars_on_black(rows, peak)));
        let levels = studio.levels().unwrap();
        let green = levels.rgb.into_iter().skip(1).step_by(3);
        green
            .map(|level| {
                let encoded = f64::from(level) / 65535.0;
                let level = match encoded {
                    dark if dark <= 0.04045 => dark / 12.92,
                    bright => ((bright + 0.055) / 1.055).powf(2.4),
                };
                level / (1.0 - level)
            })
            .sum::<f64>()
    };
    let pixel = (1080.0 / f64::from(rows)).powi(2);
    let own = 25.0 * peak * (1.0 - f64::from(BLOOM as f32));
    (shown(peak) - shown(0.0)) * pixel - own
}

/// Stars keep their light as the mean over stars at many places within a texel. The largest level has a
/// row for 4.2 of the base, and the thirteen samples for it see a place up to an eighth more or less than
/// another one; over 25 places that is 2 %. Stars lose up to 2 % to what keeps bright pixels from
/// flickering. The bar is the sum of both. Beyond that every size alike loses what the six bits of the
/// levels' numbers cut off in a dozen steps, up to a sixth on a software renderer.
#[test]
#[ignore = "needs a graphics adapter"]
fn bloom_keeps_the_light_of_stars_at_every_size() {
    let shares = [1080, 540, 2160, 4320].map(|rows| {
        let share = light_beside_stars(rows, PEAK) / (25.0 * PEAK * BLOOM);
        println!("{rows} rows: {share:.4} of the light");
        share
    });
    for share in shares {
        assert!(share > 0.8 && share < 1.04, "{shares:?}");
        assert!((share / shares[0] - 1.0).abs() < 0.04, "{shares:?}");
    }
}
