//! The automatic resolution: every share of every picture can be drawn, and the scene's own
//! resolution is never lost.

use crate::random::Random;
use lightfall::app::{Resolution, ViewPoint, next_share, wanted_rate};
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

/// A machine that needs this many seconds for a frame of the whole picture, and no less than `fixed`.
fn settled_share(whole: f64, fixed: f64, rate: f64, mut share: f64) -> Vec<f64> {
    let mut shares = Vec::new();
    for _ in 0..40 {
        share = next_share(share, (fixed + (whole - fixed) * share * share) * rate);
        shares.push(share);
    }
    shares
}

#[test]
fn the_resolution_rises_again_when_a_movement_slows_down_and_never_swings() {
    for (whole, fixed) in [(0.25, 0.05), (0.12, 0.0), (0.3, 0.02), (0.05, 0.03)] {
        let fast = *settled_share(whole, fixed, 30.0, 1.0).last().unwrap();
        let slow = settled_share(whole, fixed, wanted_rate(0.0, 30.0), fast);
        let end = *slow.last().unwrap();
        let frame = fixed + (whole - fixed) * end * end;
        assert!(end > fast, "{whole}: {fast}, then {end}");
        // A step more would miss the frame rate if all of the time went into pixels.
        let finer = frame * (1.0 + 1.0 / 16.0 / end).powi(2);
        assert!(
            frame <= 0.1 && (end == 1.0 || finer > 0.1),
            "{whole}: {end}, {frame}"
        );
        // Within a second and a half: fifteen frames, of which four make a step.
        assert!(slow[3] >= 0.8 * end, "{whole}: {slow:?}");
        assert!(slow[10..].iter().all(|share| *share == end), "{slow:?}");
    }
}

#[test]
fn a_fast_flight_wants_the_whole_frame_rate_and_a_slow_one_a_third() {
    let scene = Scene::default();
    let moved = |change: fn(&mut Scene)| {
        let mut next = scene.clone();
        change(&mut next);
        ViewPoint::from(&scene).picture_motion(&ViewPoint::from(&next))
    };
    // A tenth of the field of view, whichever axis the camera turns about.
    let tenth = moved(|scene| scene.camera.yaw_deg += 0.1 * scene.camera.fov_deg);
    assert!((tenth - 0.1).abs() < 1e-6, "{tenth}");
    let around = moved(|scene| scene.camera.theta_deg -= 0.1 * scene.camera.fov_deg);
    assert!((around - 0.1).abs() < 1e-6, "{around}");
    // What lies at the edge, half a height from the middle, goes out by a tenth of that.
    let nearer = moved(|scene| scene.camera.r /= 1.1);
    assert!((nearer - 0.5 * 1.1_f64.ln()).abs() < 1e-6, "{nearer}");
    assert_eq!(moved(|scene| scene.disk.time += 1.0), 0.0);
    // A turn of a picture in ten seconds is followed at 20 frames a second, one in a second at 30.
    assert!((wanted_rate(0.1, 30.0) - 20.0).abs() < 1e-9);
    assert_eq!(wanted_rate(1.0, 30.0), 30.0);
    assert_eq!(wanted_rate(0.0, 30.0), 10.0);
}
