//! Two whole pictures side by side.

use super::comparison::{HALF, SIZE, light, small, smaller, studio};
use super::without_spin;
use glam::DVec2;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Scene, SkyMode};
use lightfall_render::ComparisonMode;

#[test]
#[ignore = "needs a graphics adapter"]
fn each_of_two_whole_pictures_is_that_of_its_scene_alone_at_half_the_width() {
    let pinned = smaller(without_spin(2));
    let mut turned = pinned.clone();
    // Stars, which another kernel finds beside a spinning hole, and edges.
    turned.sky.mode = SkyMode::Stars;
    turned.picture.antialias = true;
    let mut spinning = turned.clone();
    spinning.hole.spin = 0.9;
    let mut grid = turned.clone();
    grid.sky.mode = SkyMode::Grid;
    let mut alone = studio(&pinned);
    let mut studio = studio(&pinned);
    for (what, left, right) in [
        ("spin", &turned, &spinning),
        ("spin on the left", &spinning, &turned),
        ("sky", &grid, &turned),
    ] {
        studio.show(right).unwrap();
        studio.compare(Some((left, ComparisonMode::TwoPictures)));
        let both = studio.light().unwrap();
        // The pinned scene takes over the picture of the current one.
        let left = Scene {
            picture: right.picture,
            ..left.clone()
        };
        let sides = [&left, right].map(|scene| light(&mut alone, &scene.widened(2.0, 80)));
        assert!(sides[0].rgba != sides[1].rgba, "{what} changes nothing");
        for (i, pixel) in both.rgba.iter().enumerate() {
            let (row, column) = (i / SIZE.x as usize, i % SIZE.x as usize);
            let side = &sides[column / HALF];
            let own = side.rgba[row * HALF + column % HALF];
            assert_eq!(pixel[..3], own[..3], "{what}: pixel {column}, {row}");
        }
    }
}

#[test]
fn a_widened_scene_shows_from_left_to_right_what_the_whole_one_shows() {
    let scene = small(2);
    let half = scene.widened(2.0, 80);
    let [whole_size, half_size] = [&scene, &half].map(|scene| scene.picture.size().as_dvec2());
    for across in [0.0, 20.0, 100.0, 160.0] {
        let whole = scene.camera.looking(DVec2::new(across, 45.0), whole_size);
        let seen = half.camera.pixel_of(whole, half_size).unwrap();
        assert!(
            (seen - DVec2::new(across / 2.0, 45.0)).length() < 1e-9,
            "{seen}"
        );
    }
    // A field of view has an end.
    let mut wide = scene.clone();
    wide.camera.fov_deg = 178.0;
    let widest = wide.widened(100.0, 80);
    assert!(Drawable::new(widest).is_ok());
}
