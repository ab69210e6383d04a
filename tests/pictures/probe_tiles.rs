//! The probe in tiles, against the picture drawn at once.

use super::linear::rgb;
use super::tiles::{SIZE, TILES, scene};
use glam::UVec2;
use lightfall_picture::{HeadlessOptions, Studio, Tiles, exposed};

/// The depth and the light of a picture that has the probe in it.
struct ProbePicture {
    size: UVec2,
    depth: Vec<f32>,
    /// The sum of the three colours.
    light: Vec<f64>,
}

impl ProbePicture {
    fn new(studio: &mut Studio, size: UVec2) -> Self {
        let light = studio.light().unwrap();
        let sum = |rgba: &[u16; 4]| rgb(*rgba).element_sum();
        Self {
            size,
            depth: studio.depth().unwrap(),
            light: light.rgba.iter().map(sum).collect(),
        }
    }

    fn index(&self, [x, y]: [u32; 2]) -> usize {
        (y * self.size.x + x) as usize
    }

    /// The largest change of depth from a pixel to one beside it.
    fn slope(&self, [x, y]: [u32; 2]) -> f32 {
        let here = self.depth[self.index([x, y])];
        [[1, 0], [-1, 0], [0, 1], [0, -1]]
            .into_iter()
            .map(|[dx, dy]| [x.saturating_add_signed(dx), y.saturating_add_signed(dy)])
            .filter(|[x, y]| *x < self.size.x && *y < self.size.y)
            .map(|place| (self.depth[self.index(place)] - here).abs())
            .fold(0.0, f32::max)
    }

    /// Whether a pixel of a tile agrees with the pixel of the whole picture at `place`. The grid of
    /// rasterizers is 1/256 of a pixel, and a corner in a tile is rounded to it once more; a
    /// sixteenth of a pixel is much more than this and much less than one pixel.
    fn agrees(&self, place: [u32; 2], (depth, light): (f32, f64)) -> bool {
        let at = self.index(place);
        if !depth.is_finite() || !self.depth[at].is_finite() {
            return depth == self.depth[at];
        }
        (depth - self.depth[at]).abs() <= self.slope(place) / 16.0 + 1e-5 * depth.min(1e3)
            && (light - self.light[at]).abs() <= 0.02 * self.light[at]
    }
}

/// The probe is drawn by Bevy, with a projection of each tile. A few pixels on edges may show what is
/// behind them, because the tile rounds corners anew. A tile that lay one pixel beside its place would
/// change the whole outline.
#[test]
#[ignore = "needs a graphics adapter"]
fn tiles_have_the_probe_of_the_whole_picture() {
    let mut scene = scene(6, SIZE);
    scene.probe.antialias = false;
    let scene = exposed(&scene).unwrap();
    let options = HeadlessOptions {
        light: true,
        ..HeadlessOptions::default()
    };
    let mut studio = Studio::with_options(&scene, SIZE, options).unwrap();
    let whole = ProbePicture::new(&mut studio, SIZE);
    drop(studio);
    let covered = whole.depth.iter().filter(|depth| depth.is_finite()).count();
    assert!(covered > 1000, "the probe covers {covered} pixels");
    for tile in TILES {
        let tiles = Tiles::with_size(SIZE, tile);
        let options = HeadlessOptions {
            part: tiles.strips().next().unwrap().next(),
            ..options
        };
        let mut studio = Studio::with_options(&scene, UVec2::ONE, options).unwrap();
        let mut differ = 0;
        for part in tiles.strips().flatten() {
            studio.show_part(&scene, part).unwrap();
            let drawn = ProbePicture::new(&mut studio, part.size);
            for (y, x) in (0..part.size.y).flat_map(|y| (0..part.size.x).map(move |x| (y, x))) {
                let at = drawn.index([x, y]);
                let place = [part.origin.x + x, part.origin.y + y];
                differ += usize::from(!whole.agrees(place, (drawn.depth[at], drawn.light[at])));
            }
        }
        assert!(
            differ * 100 < covered,
            "{tile}: {differ} of {covered} pixels"
        );
    }
}
