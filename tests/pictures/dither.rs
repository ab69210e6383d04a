//! The dither in frames that were really drawn: its pattern is Bayer's matrix, upright, and stands
//! still while disk and camera move.

use super::preset;
use glam::UVec2;
use lightfall_core::scene::Scene;
use lightfall_picture::{HeadlessOptions, Still, Studio};

/// Cells of the picture, each one pixel of the output and 2 x 2 pixels of the light.
const CELLS: UVec2 = UVec2::new(160, 90);
/// Levels of the dithered pictures, which divide 255, and those of a picture that shows a cell's
/// light itself.
const FEW_LEVELS: u32 = 6;
const ALL_LEVELS: u32 = 256;

/// Bayer's matrix of order 4 as a picture shows it: rows from the top, columns from the left.
const BAYER: [[u32; 4]; 4] = [
    [0, 8, 2, 10], //
    [12, 4, 14, 6],
    [3, 11, 1, 9],
    [15, 7, 13, 5],
];

/// A disk that lives, without what depends on more than a cell's own light.
fn living() -> Scene {
    let mut scene = preset(2);
    scene.picture.automatic_exposure = false;
    scene.picture.exposure_ev += 1.0;
    scene.picture.bloom = 0.0;
    (scene.picture.width, scene.picture.height) = (2 * CELLS.x, 2 * CELLS.y);
    (scene.picture.grid_width, scene.picture.grid_height) = (CELLS.x, CELLS.y);
    scene
}

/// A frame: its cells dithered and not, and the bits of the light of all pixels.
struct Frame {
    dithered: Still,
    plain: Still,
    light: Vec<[u16; 4]>,
}

/// Draws the scenes as frames of one studio, one after the other.
fn frames<const N: usize>(scenes: [Scene; N]) -> [Frame; N] {
    let options = HeadlessOptions {
        light: true,
        ..HeadlessOptions::default()
    };
    let mut studio = Studio::with_options(&scenes[0], CELLS, options).unwrap();
    scenes.map(|scene| {
        let [dithered, plain] =
            [(FEW_LEVELS, true), (ALL_LEVELS, false)].map(|(levels, dither)| {
                let mut scene = scene.clone();
                (scene.picture.levels, scene.picture.dither) = (levels, dither);
                studio.show(&scene).unwrap();
                studio.settle().unwrap();
                studio.picture().unwrap()
            });
        let light = studio.light().unwrap().rgba;
        Frame {
            dithered,
            plain,
            light,
        }
    })
}

fn moved(time: f64, phi_deg: f64, roll_deg: f64) -> Scene {
    let mut scene = living();
    scene.disk.time = time;
    scene.camera.phi_deg = phi_deg;
    scene.camera.roll_deg = roll_deg;
    scene
}

fn cells() -> impl Iterator<Item = (u32, u32)> {
    (0..CELLS.y).flat_map(|y| (0..CELLS.x).map(move |x| (x, y)))
}

#[test]
#[ignore = "needs a graphics adapter"]
fn every_frame_is_dithered_by_the_same_upright_matrix_however_disk_and_camera_move() {
    let scenes = [
        moved(0.0, 0.0, 0.0),
        moved(2.0, 0.0, 0.0),
        moved(2.0, 3.0, 0.0),
        moved(2.0, 3.0, 7.0),
    ];
    for (number, frame) in frames(scenes).into_iter().enumerate() {
        let mut compared = 0;
        for (place, (x, y)) in cells().enumerate() {
            for channel in 0..3 {
                let [plain, dithered] =
                    [&frame.plain, &frame.dithered].map(|still| still.rgb[3 * place + channel]);
                let level = f64::from(plain) / 255.0 * f64::from(FEW_LEVELS - 1);
                let rank = BAYER[y as usize % 4][x as usize % 4];
                let sum = level + (f64::from(rank) + 0.5) / 16.0;
                // Below the first level the dither fades. The plain picture has the value rounded to
                // 1/255, so next to a threshold it does not say on which side the cell is.
                let is_near = (sum - sum.round()).abs() < f64::from(FEW_LEVELS - 1) / 255.0;
                if level < 1.0 || is_near {
                    continue;
                }
                let step = 255 / (FEW_LEVELS - 1);
                let expected = step * (sum as u32).min(FEW_LEVELS - 1);
                assert_eq!(
                    u32::from(dithered),
                    expected,
                    "frame {number}, channel {channel} of the cell in column {x}, row {y}: level {level}"
                );
                compared += 1;
            }
        }
        println!("frame {number}: {compared} values");
        assert!(compared > 1_500, "frame {number}: {compared} values");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn cells_whose_light_does_not_change_keep_their_bytes_while_the_disk_moves() {
    let [before, after] = frames([moved(0.0, 0.0, 0.0), moved(2.0, 0.0, 0.0)]);
    let light = |frame: &Frame, (x, y): (u32, u32)| {
        let pixels = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| (2 * x + i, 2 * y + j));
        pixels.map(|(x, y)| frame.light[(y * 2 * CELLS.x + x) as usize])
    };
    let (mut kept, mut changed) = (0, 0);
    for (place, cell) in cells().enumerate() {
        let bytes = |still: &Still| still.rgb[3 * place..3 * place + 3].to_vec();
        if light(&before, cell) == light(&after, cell) {
            assert_eq!(
                bytes(&before.dithered),
                bytes(&after.dithered),
                "the cell at {cell:?}"
            );
            // Cells between levels, in which another pattern would show.
            kept += u32::from(bytes(&before.dithered) != bytes(&before.plain));
        } else {
            changed += 1;
        }
    }
    assert!(
        kept > 1_000 && changed > 1_000,
        "{kept} cells between levels keep their light, {changed} change it"
    );
}
