//! The steps of the article's methods: its named qualities, and fields that leave the choice to the
//! program.

use lightfall_core::gpu::{bands, max_pixels_of_call};
use lightfall_core::scene::{
    ARTICLE_MAX_STEPS, ArticleQuality, MAX_STEP_BUDGET, Method, Override, Scene, load,
};

fn with(sets: &[&str]) -> Scene {
    let sets: Vec<Override> = sets
        .iter()
        .map(|set| Override::assignment(set).unwrap())
        .collect();
    load("my.toml", "", &sets).unwrap()
}

/// The numbers of the article's own program.
#[test]
fn the_articles_qualities_have_its_scales_and_budgets() {
    let default = Scene::default().quality;
    assert_eq!(
        default.article(),
        None,
        "its step is balanced, its budget high"
    );
    for (word, scale, steps) in [
        ("cheap", 1.55, 128),
        ("balanced", 0.85, 256),
        ("high", 0.45, 768),
    ] {
        let named = ArticleQuality::from_word(word).unwrap();
        let quality = default.with_steps_of(named);
        assert_eq!((quality.step_scale, quality.max_steps), (scale, steps));
        assert_eq!(quality.article(), Some(named));
        assert_eq!(quality.max_affine, default.max_affine);
    }
}

#[test]
fn an_escape_radius_is_never_less_than_the_radii_of_camera_and_disk() {
    for (sets, radius) in [
        // The article's rule: three times the disk's edge at 11, or 1.15 times the camera's radius.
        (&[][..], 33.0),
        (&["camera.r=100"], 115.0),
        (&["quality.escape_radius=50"], 50.0),
        (&["quality.escape_radius=50", "camera.r=60"], 60.0),
        (&["quality.escape_radius=2", "camera.r=5"], 11.0),
    ] {
        let found = with(sets).escape_radius();
        assert!((found - radius).abs() < 1e-12, "{sets:?}: {found}");
    }
}

#[test]
fn the_least_step_is_the_articles_own_unless_it_is_set() {
    for (method, own) in [
        (Method::Verlet, 0.018),
        (Method::KerrSchild, 0.008),
        (Method::Closed, 0.0),
        (Method::Auto, 0.0),
    ] {
        let mut scene = Scene {
            method,
            ..Scene::default()
        };
        assert_eq!(scene.min_step(), own, "{method:?}");
        scene.quality.min_step = 0.001;
        let set = if own > 0.0 { 0.001 } else { 0.0 };
        assert_eq!(scene.min_step(), set, "{method:?}");
    }
}

/// A driver ends a device that does not answer for some seconds. One call with the article's 768
/// steps for each pixel of a full HD picture has always been drawn.
#[test]
fn no_draw_call_takes_more_steps_than_a_full_hd_picture_with_the_articles_budget() {
    let article = f64::from(1920 * 1080) * f64::from(ARTICLE_MAX_STEPS);
    for max_steps in [1, 256, ARTICLE_MAX_STEPS, 1000, MAX_STEP_BUDGET] {
        let mut scene = Scene {
            method: Method::Verlet,
            ..Scene::default()
        };
        scene.quality.max_steps = max_steps;
        for [width, height] in [[960, 540], [1920, 1080], [8192, 8192], [1, 1]] {
            let mut drawn = 0;
            for (top, rows) in bands(width, height, max_pixels_of_call(&scene)) {
                assert_eq!(top, drawn);
                drawn += rows;
                let steps = f64::from(rows * width) * f64::from(max_steps);
                assert!(steps <= article, "{max_steps} steps, {width}x{height}");
            }
            assert_eq!(drawn, height, "{max_steps} steps, {width}x{height}");
        }
        // Methods without a budget draw full bands.
        scene.method = Method::Closed;
        assert_eq!(max_pixels_of_call(&scene), 1920 * 1080);
    }
}
