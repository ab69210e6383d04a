//! The layers of a picture's light.

use super::shader::text::add_u32;

/// Some of the layers that the light of a picture comes from. Each takes a share of the rays of a pixel,
/// and so does the hole, which gives no light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Layers(u32);

impl Layers {
    /// None of them.
    pub const NONE: Self = Self(0);
    /// The sky without the stars that are drawn as points.
    pub const SKY: Self = Self(1);
    /// Those stars, which take no share of the rays: they are added to what is behind them.
    pub const STARS: Self = Self(1 << 1);
    /// The first crossing of a disk without thickness.
    pub const HIT1: Self = Self(1 << 2);
    /// The second one; among jets, also further ones.
    pub const HIT2: Self = Self(1 << 3);
    /// Matter with depth: a disk with thickness, and jets.
    pub const VOLUME: Self = Self(1 << 4);
    /// The hole, and rays that their method has not finished.
    pub const HOLE: Self = Self(1 << 5);
    /// All of them.
    pub const ALL: Self = Self((1 << 6) - 1);

    /// Each of them, with its name in the shaders.
    const NAMED: [(&'static str, Self); 6] = [
        ("LAYER_SKY", Self::SKY),
        ("LAYER_STARS", Self::STARS),
        ("LAYER_HIT1", Self::HIT1),
        ("LAYER_HIT2", Self::HIT2),
        ("LAYER_VOLUME", Self::VOLUME),
        ("LAYER_HOLE", Self::HOLE),
    ];

    /// These layers without others.
    #[must_use]
    pub const fn without(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }

    /// A bit for each of them, as the shaders read them.
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.0
    }

    /// Adds the bits to the constants of a shader.
    pub(super) fn add_constants(prelude: &mut String) {
        for (name, layer) in Self::NAMED {
            add_u32(prelude, name, layer.0);
        }
    }
}
