//! The tiles of a picture that is too large to be drawn at once.

use glam::UVec2;
use lightfall_core::gpu::BloomLevels;
use lightfall_core::scene::Part;

/// Most columns and rows of a tile. A tile takes a few hundred MiB on the graphics device. A strip of tiles
/// takes memory in proportion to the picture's width.
const MAX_TILE: UVec2 = UVec2::new(4096, 512);

/// Most pixels of a picture that is drawn at once, unless it is shown in cells: one frame of digital
/// cinema. Up to there no edge and no star has to be simplified for want of room.
pub const MAX_UNTILED_PIXELS: u64 = 4096 * 2160;

/// Where the tiles of a picture lie. Each begins at an even column and row, and at whole squares of the
/// base of the picture's bloom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tiles {
    whole: UVec2,
    tile: UVec2,
}

impl Tiles {
    /// The tiles of a picture of this size, all about as large.
    #[must_use]
    pub fn of(whole: UVec2) -> Self {
        let step = step(whole);
        let most = (MAX_TILE / step * step).max(UVec2::splat(step));
        let along = |whole: u32, most: u32| whole.div_ceil(whole.div_ceil(most).max(1));
        let tile = UVec2::new(along(whole.x, most.x), along(whole.y, most.y));
        Self::with_size(whole, tile)
    }

    /// Tiles of at least this size.
    #[must_use]
    pub fn with_size(whole: UVec2, tile: UVec2) -> Self {
        let step = step(whole);
        let tile = (tile.max(UVec2::ONE) + (step - 1)) / step * step;
        Self { whole, tile }
    }

    /// The picture as one tile.
    #[must_use]
    pub fn one(whole: UVec2) -> Self {
        Self { whole, tile: whole }
    }

    /// Width and height of the picture.
    #[must_use]
    pub fn whole(&self) -> UVec2 {
        self.whole
    }

    /// The number of tiles.
    #[must_use]
    pub fn count(&self) -> usize {
        self.strips().map(Iterator::count).sum()
    }

    /// The rows of tiles, from the top, each from the left.
    pub fn strips(self) -> impl Iterator<Item = impl Iterator<Item = Part> + Clone> {
        let Self { whole, tile } = self;
        let begins = |whole: u32, tile: u32| (0..whole).step_by(tile.max(1) as usize);
        begins(whole.y, tile.y).map(move |top| {
            begins(whole.x, tile.x).map(move |left| {
                let origin = UVec2::new(left, top);
                Part {
                    origin,
                    size: tile.min(whole - origin),
                }
            })
        })
    }
}

/// What the columns and rows at which tiles begin are multiples of.
fn step(whole: UVec2) -> u32 {
    2 * BloomLevels {
        picture: whole,
        rows: 1,
    }
    .square()
}
