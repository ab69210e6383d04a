//! The list of stars as the GPU reads it: sixteen bytes a star.

use glam::Vec3;
use lightfall_optics::spectrum::{TABLE_MAX_TEMPERATURE, TABLE_MIN_TEMPERATURE};
use lightfall_optics::stars::images::ORDERS;
use lightfall_optics::stars::{Star, ZERO_MAGNITUDE_FLUX};

/// Bits of the mantissa of a packed flux, whose error is 1.2e-4.
const MANTISSA_BITS: u32 = 12;
/// Bits of f32's mantissa that a packed flux leaves out.
const DROPPED_BITS: u32 = 23 - MANTISSA_BITS;
/// Number of bits of a packed flux: 64 octaves.
const FLUX_BITS: u32 = 6 + MANTISSA_BITS;
/// Number of bits of a packed temperature.
const TEMPERATURE_BITS: u32 = 32 - FLUX_BITS;
/// The offset of a packed flux from the upper bits of an f32: its smallest value is 2^-40, a star
/// of V = 20.5.
pub(super) const FLUX_BIAS: u32 = (127 - 40) << MANTISSA_BITS;
/// Number of steps of a packed temperature, between the ends of the table of thermal colours. Its
/// error is 2.4e-4.
pub(super) const TEMPERATURE_STEPS: u32 = (1 << TEMPERATURE_BITS) - 1;

/// Maximum number of images in the list of images, which then takes 64 MiB.
pub const MAX_IMAGES: u32 = 1 << 21;

/// Capacity of each list of candidates, per star. Outside the horizon the longest list has at most
/// 3 per star; a falling observer next to the horizon sees all stars several times, in cells each
/// of which sees a large part of the sky.
const CANDIDATES_PER_STAR: u32 = 14;

/// Minimum capacity of each list: one list has up to eight parts of each wide cell.
const MIN_CANDIDATES: u32 = 1 << 18;

/// Maximum capacity of each list: 64 MiB for all four.
pub const MAX_CANDIDATES: u32 = 1 << 21;

/// Stars in the form that the kernels read, brightest first.
#[derive(Clone, Debug, PartialEq)]
pub struct PackedStars {
    bytes: Vec<u8>,
    fluxes: Vec<f32>,
}

impl PackedStars {
    /// Packs stars that are sorted by their magnitude.
    pub fn new(stars: &[Star]) -> Self {
        let flux = |star: &Star| {
            (ZERO_MAGNITUDE_FLUX * 10_f64.powf(-0.4 * f64::from(star.magnitude))) as f32
        };
        let bytes = stars.iter().flat_map(|star| {
            let [x, y, z] = star.direction.to_array().map(f32::to_bits);
            let light =
                packed_flux(flux(star)) << TEMPERATURE_BITS | packed_temperature(star.temperature);
            [x, y, z, light].map(u32::to_le_bytes).concat()
        });
        Self {
            bytes: bytes.collect(),
            fluxes: stars.iter().map(flux).collect(),
        }
    }

    /// The contents of `STAR_LIST`.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Number of stars.
    pub fn len(&self) -> u32 {
        self.fluxes.len() as u32
    }

    /// Whether there are no stars.
    pub fn is_empty(&self) -> bool {
        self.fluxes.is_empty()
    }

    /// The stars' directions, in their order.
    pub fn directions(&self) -> impl Iterator<Item = Vec3> {
        self.bytes.chunks_exact(16).map(|bytes| {
            let number =
                |i: usize| f32::from_le_bytes([0, 1, 2, 3].map(|byte| bytes[4 * i + byte]));
            Vec3::from_array([0, 1, 2].map(number))
        })
    }

    /// The capacity of the list of images: all that these stars can have, up to [`MAX_IMAGES`].
    /// Further ones are not drawn.
    pub fn max_images(&self) -> u32 {
        self.len().saturating_mul(ORDERS).clamp(1, MAX_IMAGES)
    }

    /// The capacity of each list of candidates: more than these stars have in any picture, up to
    /// [`MAX_CANDIDATES`]. Further ones are dropped in no fixed order.
    pub fn max_candidates(&self) -> u32 {
        let count = self.len().saturating_mul(CANDIDATES_PER_STAR);
        count.clamp(MIN_CANDIDATES, MAX_CANDIDATES)
    }

    /// How many stars have at least this luminous flux.
    pub fn count_brighter(&self, luminous_flux: f64) -> u32 {
        let brighter = |flux: &f32| f64::from(*flux) >= luminous_flux;
        self.fluxes.partition_point(brighter) as u32
    }
}

/// The upper bits of the flux's f32 without its sign, rounded, from [`FLUX_BIAS`] on.
fn packed_flux(flux: f32) -> u32 {
    let rounded = (flux.max(0.0).to_bits() + (1 << (DROPPED_BITS - 1))) >> DROPPED_BITS;
    rounded.saturating_sub(FLUX_BIAS).min((1 << FLUX_BITS) - 1)
}

/// The temperature's place in the table of thermal colours.
fn packed_temperature(temperature: f32) -> u32 {
    let range = TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE;
    let share = (f64::from(temperature) / TABLE_MIN_TEMPERATURE).ln() / range.ln();
    (share.clamp(0.0, 1.0) * f64::from(TEMPERATURE_STEPS)).round() as u32
}
