//! The automatic resolution: every share of every picture can be drawn, and the scene's own
//! resolution is never lost.

use crate::random::Random;
use lightfall::app::Resolution;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Frame, MAX_PICTURE_SIDE, MAX_PIXELS_PER_CELL, Scene};

/// A random size of a picture's side, and a number of cells that fits it; often the extremes.
fn random_side(random: &mut Random) -> (u32, u32) {
    let longest = random.of(&[1, 2, 70, 1000, MAX_PICTURE_SIDE]);
    let side = random.integer(1, longest);
    let min = side.div_ceil(MAX_PIXELS_PER_CELL);
    let cells = random.integer(min, side);
    (side, random.of(&[min, cells, side]))
}

#[test]
fn every_share_of_random_pictures_can_be_drawn_and_leads_back_to_the_whole() {
    let mut random = Random::new();
    for case in 0..2000 {
        let mut scene = Scene::default();
        let picture = &mut scene.picture;
        (picture.width, picture.grid_width) = random_side(&mut random);
        (picture.height, picture.grid_height) = random_side(&mut random);
        let full = Drawable::new(scene).unwrap();
        let mut resolution = Resolution::default();
        for sixteenths in [4, random.integer(4, 15)] {
            let share = f64::from(sixteenths) / 16.0;
            resolution.set_share(share);
            let drawn = full.shown_in(&resolution.frame(&full));
            let given = format!("case {case}: {share} of {:?}", full.picture);
            // At least one pixel stays on each side.
            let wanted = [full.picture.width, full.picture.height]
                .map(|side| (f64::from(side) * share).round().max(1.0) as u32);
            assert_eq!(
                [drawn.picture.width, drawn.picture.height],
                wanted,
                "{given}"
            );
            assert_eq!(drawn.shown_in(&Frame::of(&full)), full, "{given}");
        }
        resolution.set_share(1.0);
        assert_eq!(resolution.frame(&full), Frame::of(&full), "case {case}");
    }
}
