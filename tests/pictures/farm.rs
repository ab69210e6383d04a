//! Sequences that several processes draw, without a graphics adapter: which frames each of them draws, which
//! pictures are there already, and manifests.

mod existing;
mod manifests;

use super::preset;
use glam::UVec2;
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::scene::Scene;
use lightfall_picture::{FrameList, Shard, Still, write_png};
use lightfall_platform::storage::PictureRecord;
use std::path::Path;

const SIZE: UVec2 = UVec2::new(37, 21);

fn scene() -> Scene {
    let mut scene = preset(2);
    (scene.picture.width, scene.picture.height) = SIZE.into();
    scene
}

/// The record of a picture of this scene, by this version.
fn record(scene: &Scene) -> PictureRecord {
    PictureRecord::new(scene, Catalogue::built_in(), None)
}

fn write_as_png(path: &Path, size: UVec2, record: &PictureRecord) {
    let pixels = 3 * size.x * size.y;
    let still = Still {
        size,
        rgb: (0..pixels).map(|at| (at * 31 % 251) as u8).collect(),
    };
    write_png(path, &still, record).unwrap();
}

fn list(text: &str) -> FrameList {
    text.parse().unwrap()
}

#[test]
fn a_list_of_frames_has_runs_steps_and_single_numbers_each_once_in_its_order() {
    for (text, numbers) in [
        ("5", &[5][..]),
        ("2..4", &[2, 3, 4]),
        ("2-4", &[2, 3, 4]),
        ("0..9:3", &[0, 3, 6, 9]),
        ("0-9x4", &[0, 4, 8]),
        ("0..9:100", &[0]),
        ("0-2,20,30-50x10", &[0, 1, 2, 20, 30, 40, 50]),
        // The coarse pass first, and then what it left out.
        ("0..4:2,0..4", &[0, 2, 4, 1, 3]),
        ("7,7,6..7", &[7, 6]),
    ] {
        assert_eq!(list(text).numbers(), numbers, "{text}");
    }
    // A step makes few frames of a long run.
    assert_eq!(list("0..999999999:100000").numbers().len(), 10_000);
    let is_run = |text: &str| list(text).run().is_some();
    assert!(is_run("3..9") && is_run("3,4,5") && is_run("3"));
    assert!(!is_run("0..4:2") && !is_run("5,4") && !is_run("1,3"));
}

#[test]
fn shards_draw_every_frame_of_a_list_exactly_once() {
    for text in ["0..239", "0..239:10", "5", "9,1..3,40-80x7", "0..4:2,0..4"] {
        let all = list(text);
        let mut sorted = all.numbers().to_vec();
        sorted.sort_unstable();
        for count in (1..=40).chain([239, 240, 241, 130_000]) {
            let shards: Vec<Vec<u32>> = (1..=count.min(300))
                .map(|number| Shard { number, count }.of(&all))
                .collect();
            let mut drawn = shards.concat();
            drawn.sort_unstable();
            assert_eq!(drawn, sorted, "{text} in {count} shards");
            // None has more than one frame more than another of those that have any work.
            let (least, most) = (all.numbers().len() / count as usize, shards[0].len());
            assert!(shards.iter().all(|own| (least..=most).contains(&own.len())));
            assert!(most <= least + 1, "{text} in {count} shards");
        }
    }
    let first = "1/4".parse::<Shard>().unwrap();
    assert_eq!(first.of(&list("0..9")), [0, 4, 8]);
}
