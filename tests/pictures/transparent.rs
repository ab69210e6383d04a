//! A PNG with transparent parts: over black it is the picture.

use super::linear::{program, small};
use lightfall_core::scene::SkyMode;
use lightfall_picture::{filled, render, straight};

/// The level of a colour over black.
fn over_black(level: u8, alpha: u8) -> f64 {
    f64::from(level) * f64::from(alpha) / 255.0
}

/// The colour is rounded to a level, and what is rounded off counts by the opacity: half a level at most.
#[test]
fn over_black_a_pixel_has_its_levels_whatever_its_opacity() {
    for share in [0.0, 0.001, 0.3, 0.5, 0.9, 1.0] {
        for level in 0..=u8::MAX {
            let rgb = [level, level / 2, level / 7];
            let [r, g, b, alpha] = straight(rgb, share);
            assert!(f64::from(alpha) >= (255.0 * f64::from(share)).round());
            for (own, colour) in rgb.into_iter().zip([r, g, b]) {
                let over = over_black(colour, alpha);
                assert!((over - f64::from(own)).abs() <= 0.5, "{rgb:?} {share}");
            }
        }
    }
    assert_eq!(straight([0; 3], 1.0), [0, 0, 0, 255]);
    assert_eq!(straight([0; 3], 0.0), [0; 4]);
    assert_eq!(straight([9, 8, 7], 1.0), [9, 8, 7, 255]);
}

/// Without its sky a picture over black is that of a scene without a sky, but for the rounding of the colours
/// and its noise. The edges of both would be refined in other pixels.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_png_without_its_sky_over_black_is_the_picture_of_a_black_sky() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = small(2);
    (scene.picture.bypass, scene.picture.antialias) = (true, false);
    (scene.picture.automatic_exposure, scene.picture.exposure_ev) = (false, -2.0);
    let mut black = scene.clone();
    black.sky.mode = SkyMode::Off;
    let size = scene.picture.size();
    for bloom in [0.0, 0.1] {
        (scene.picture.bloom, black.picture.bloom) = (bloom, bloom);
        program(folder.path(), &scene, "--alpha sky -o cut.png");
        let cut = image::open(folder.path().join("cut.png")).unwrap();
        assert_eq!(cut.color(), image::ColorType::Rgba8);
        let cut = cut.into_rgba8();
        let plain = render(&filled(&black), size).unwrap();
        let (mut clear, mut opaque, mut worst) = (0, 0, 0.0_f64);
        for (pixel, levels) in cut.pixels().zip(plain.rgb.chunks_exact(3)) {
            let [r, g, b, alpha] = pixel.0;
            clear += usize::from(alpha == 0);
            opaque += usize::from(alpha == 255);
            // With bloom the edges of the shadow are darker in a picture of all light.
            if bloom == 0.0 || alpha == 255 {
                for (own, level) in [r, g, b].into_iter().zip(levels) {
                    worst = worst.max((over_black(own, alpha) - f64::from(*level)).abs());
                }
            }
        }
        println!("bloom {bloom}: {clear} clear, {opaque} opaque, {worst} levels");
        assert!(bloom > 0.0 || clear > 5000, "{clear} pixels of the sky");
        assert!(opaque > 5000, "{opaque} pixels of disk and hole");
        assert!(worst <= 2.0, "{worst} levels");
    }
}
