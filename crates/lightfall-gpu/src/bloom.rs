//! The shader of the bloom, its uniform, and the sizes of what it draws to.

use super::shader::ShaderText;
use encase::ShaderType;
use glam::{IVec2, UVec2, Vec2};

/// Most rows of the base. A star's image is one pixel wide up to this height of a picture and wider in
/// proportion above, so that a texel of the base sees the same light at every size.
const MAX_BASE_ROWS: u32 = 1080;

/// Lower levels get more than the scene's share: up to `LOW_LEVELS_BOOST` of the rest, at the smallest
/// level. Bevy's curve with a curvature of 0.95: the power 1 / (1 - 0.95).
const LOW_LEVELS_BOOST: f64 = 0.7;
const BOOST_POWER: f64 = 20.0;

/// Mirror of `Bloom` in shaders/bloom.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct Bloom {
    pub whole: UVec2,
    pub origin: IVec2,
    pub filled: Vec2,
    pub square: u32,
}

/// The textures of the bloom of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BloomLevels {
    /// Size of the picture, in pixels.
    pub picture: UVec2,
    /// Rows of the largest level.
    pub rows: u32,
}

impl Bloom {
    /// The numbers of a picture, of which what is drawn begins at `origin`.
    pub fn new(levels: BloomLevels, origin: IVec2) -> Self {
        let BloomLevels { picture, .. } = levels;
        let square = levels.square();
        let reach = (levels.base() * square).as_vec2();
        Self {
            whole: picture,
            origin,
            filled: picture.as_vec2() / reach,
            square,
        }
    }

    /// The entry points of its shader: the vertices, and the steps.
    pub const ENTRIES: [&'static str; 5] = [
        "over_all",
        "bloom_base",
        "bloom_first",
        "bloom_shrink",
        "bloom_spread",
    ];

    /// The shader, with [`ENTRIES`](Self::ENTRIES).
    pub fn shader() -> ShaderText {
        ShaderText::new(String::new(), &Self::ENTRIES, Vec::new())
    }
}

impl BloomLevels {
    /// Most columns of the base and of a level: the widest texture that WebGPU lets every device create.
    pub const MAX_COLUMNS: u32 = 8192;

    /// Side of the squares of pixels that are one texel of the base.
    pub fn square(self) -> u32 {
        let UVec2 { x, y } = self.picture;
        y.div_ceil(MAX_BASE_ROWS)
            .max(x.div_ceil(Self::MAX_COLUMNS))
            .max(1)
    }

    /// Size of the base.
    pub fn base(self) -> UVec2 {
        let square = UVec2::splat(self.square());
        ((self.picture + square - 1) / square).max(UVec2::ONE)
    }

    /// Size of the largest level.
    pub fn size(self) -> UVec2 {
        let share = self.rows as f32 / self.picture.y.max(1) as f32;
        (self.picture.as_vec2() * share)
            .round()
            .as_uvec2()
            .max(UVec2::ONE)
    }

    /// The number of levels: the smallest has from four to seven rows.
    pub fn count(self) -> u32 {
        self.rows.ilog2().max(2) - 1
    }

    /// The share of the light of a level in the mean of it and the level above, for a scene whose bloom
    /// has this share of the picture's light. Level zero is the largest one, and the level above it is
    /// the picture.
    pub fn share(self, level: u32, of_picture: f64) -> f64 {
        let last = f64::from(self.count() - 1).max(1.0);
        let boost = 1.0 - (1.0 - f64::from(level) / last).powf(BOOST_POWER);
        of_picture + boost * LOW_LEVELS_BOOST * (1.0 - of_picture)
    }
}
