//! The diffuse light as a cube map, which is computed once and kept as an asset.

use super::asset::{self, NUMBERS};
use super::photograph::photographed;
use crate::cube_map::{face_column_row, halved, layer_major, solid_angle};
use crate::stars::{ZERO_MAGNITUDE_FLUX, flux, temperature_from_b_v};
use half::f16;
use std::array;
use std::sync::LazyLock;

/// The finest level. This command makes it:
/// `cargo run -p lightfall-galaxy --release -- assets/sky/milky_way.png`
const ASSET: &[u8] = include_bytes!("../../../../assets/sky/milky_way.png");

/// The diffuse light of the sky on J2000 axes, as a cube map with all its levels.
///
/// A texel is the light of two temperatures, [`MilkyWay::temperatures`], and of nebulae: radiance in
/// linear light as [`crate::spectrum`] and [`super::nebular`] have it. Seen with the frequency ratio
/// g, a texel [a, b, n] is the light g^4 (a colour(g T_a) + b colour(g T_b) + n nebular(g)).
///
/// The starlight is that of all stars. The share of those that are drawn as points is taken out by
/// [`FAINTER_SHARE`](crate::stars::FAINTER_SHARE).
#[derive(Clone, Debug, PartialEq)]
pub struct MilkyWay {
    levels: Vec<Vec<[f32; NUMBERS]>>,
}

impl MilkyWay {
    /// Texels along one side of a face of the finest level.
    pub const SIZE: usize = asset::SIZE;

    /// Number of levels. The last one has one texel a face.
    pub const LEVELS: usize = Self::SIZE.ilog2() as usize + 1;

    /// Cells a side of a face, in which faint stars are counted: the texels of a level.
    pub const CELLS: usize = 64;

    /// The Milky Way as the model of the galaxy gives it. It is decoded at the first call.
    pub fn model() -> &'static Self {
        &MODEL
    }

    /// The Milky Way as pictures show it: with the contrast and the colours of a photograph. It is
    /// decoded at the first call.
    pub fn photograph() -> &'static Self {
        &PHOTOGRAPH
    }

    /// The temperatures of the two lights in kelvin, the bluer one first.
    pub fn temperatures() -> [f64; 2] {
        asset::B_V.map(temperature_from_b_v)
    }

    /// The texels of a level, 0 the finest, in WebGPU's order of faces.
    ///
    /// # Panics
    /// There are [`MilkyWay::LEVELS`] levels.
    pub fn texels(&self, level: usize) -> &[[f32; NUMBERS]] {
        &self.levels[level]
    }

    /// All texels as half floats, the fourth of each zero, face by face, and each face level by
    /// level: what a texture of the format `Rgba16Float` takes in the order `LayerMajor`.
    pub fn half_floats(&self) -> Vec<[u16; 4]> {
        let mut halves = Vec::with_capacity(self.levels.iter().map(Vec::len).sum());
        halves.extend(layer_major(&self.levels).map(|[blue, red, nebular]| {
            [*blue, *red, *nebular, 0.0].map(|x| f16::from_f32(x).to_bits())
        }));
        halves
    }

    /// For each cell the brightness of its stars to `power` times its solid angle.
    pub(crate) fn cell_light_to_power(&self, power: f64) -> Vec<f64> {
        let level = (Self::SIZE / Self::CELLS).ilog2() as usize;
        let [blue, red] = star_fluxes();
        let weight = |(cell, light): (usize, &[f32; NUMBERS])| {
            let (_, column, row) = face_column_row(Self::CELLS, cell);
            let light = f64::from(light[0]) / blue + f64::from(light[1]) / red;
            light.powf(power) * solid_angle(Self::CELLS, column, row)
        };
        self.levels[level].iter().enumerate().map(weight).collect()
    }

    /// From the brightness of the lights of each texel, in stars of V = 0 per steradian.
    fn new(texels: impl Iterator<Item = [f64; NUMBERS]>) -> Self {
        let [blue, red] = star_fluxes();
        let units = [blue, red, ZERO_MAGNITUDE_FLUX];
        let finest = texels.map(|light| array::from_fn(|i| (light[i] * units[i]) as f32));
        let mut levels = vec![finest.collect::<Vec<_>>()];
        for level in 1..Self::LEVELS {
            levels.push(halved(&levels[level - 1], Self::SIZE >> (level - 1)));
        }
        Self { levels }
    }
}

/// Bolometric flux of a star of V = 0 of each of the two temperatures.
fn star_fluxes() -> [f64; 2] {
    MilkyWay::temperatures().map(|temperature| flux(0.0, temperature))
}

/// See [`MilkyWay::model`].
static MODEL: LazyLock<MilkyWay> = LazyLock::new(|| MilkyWay::new(lights().into_iter()));

/// See [`MilkyWay::photograph`].
static PHOTOGRAPH: LazyLock<MilkyWay> =
    LazyLock::new(|| MilkyWay::new(lights().into_iter().map(photographed)));

fn lights() -> Vec<[f64; NUMBERS]> {
    asset::read(ASSET).expect("assets/sky/milky_way.png is compiled in and a test reads it")
}
