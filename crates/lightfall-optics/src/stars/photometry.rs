//! From a star's magnitude and colour to its light.

use crate::spectrum;
use glam::{DVec3, Vec3};
use std::sync::LazyLock;

/// Luminous flux of a star of V = 0: linear light times steradians. The value is a choice. It puts
/// the brightest pixel of such a star at 15 in a picture of 960x540 pixels and 50 degrees, and that
/// of a star of V = 6.5 at 0.04.
pub const ZERO_MAGNITUDE_FLUX: f64 = 1.5e-4;

/// Range of B-V of [`temperature_from_b_v`]. Redder carbon stars count as the last.
pub const MIN_B_V: f64 = -0.4;
/// See [`MIN_B_V`].
pub const MAX_B_V: f64 = 2.5;

/// B-V of a star like the Sun, for stars whose colour is not known.
pub const SOLAR_B_V: f64 = 0.65;

/// Gaia's BP-RP of a star like the Sun (Casagrande and VandenBerg 2018, MNRAS 479, L102).
pub const SOLAR_BP_RP: f64 = 0.82;

/// The range of BP-RP in which [`v_from_gaia`] holds.
pub const BP_RP: [f64; 2] = [-0.5, 5.0];

/// The Sun from one astronomical unit: V, temperature in kelvin and angular radius in radians. The
/// last two follow from the nominal values of IAU 2015 resolution B3; V is known to 0.02.
const SUN_MAGNITUDE: f64 = -26.74;
const SUN_TEMPERATURE: f64 = 5772.0;
const SUN_RADIUS: f64 = 695_700.0 / 149_597_870.7;

/// A star: 20 bytes, because a list may have a million.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Star {
    /// Unit vector, J2000; f32 holds it to 0.02 arc seconds.
    pub direction: Vec3,
    /// Johnson V.
    pub magnitude: f32,
    /// Temperature of the black body of its colour, in kelvin.
    pub temperature: f32,
}

impl Star {
    /// See [`flux`].
    pub fn flux(&self) -> f64 {
        flux(self.magnitude.into(), self.temperature.into())
    }

    /// See [`angular_radius`].
    pub fn angular_radius(&self) -> f64 {
        angular_radius(self.magnitude.into(), self.temperature.into())
    }
}

/// Temperature in kelvin of a star with the colour `b_v`, limited to [`MIN_B_V`] and [`MAX_B_V`]:
/// T = 4600 K (1/(0.92 (B-V) + 1.7) + 1/(0.92 (B-V) + 0.62)); Ballesteros 2012, EPL 97, 34008,
/// eq. 14.
pub fn temperature_from_b_v(b_v: f64) -> f64 {
    let x = 0.92 * b_v.clamp(MIN_B_V, MAX_B_V);
    4600.0 * (1.0 / (x + 1.7) + 1.0 / (x + 0.62))
}

/// Temperature in kelvin of a star with Gaia's colour BP-RP: 5040 K / (0.4929 + 0.5092 x - 0.0353
/// x^2); Mucciarelli, Bellazzini and Massari 2021, A&A 653, A90, table 1, for dwarfs of solar
/// metallicity and BP-RP from 0.39 to 1.50. The polynomial is continued to [`BP_RP`], and colours
/// beyond it count as its ends.
#[must_use]
pub fn temperature_from_bp_rp(bp_rp: f64) -> f64 {
    let x = bp_rp.clamp(BP_RP[0], BP_RP[1]);
    5040.0 / (0.4929 + 0.5092 * x - 0.0353 * x * x)
}

/// Johnson's V from Gaia's G and BP-RP, to 0.03 magnitudes: Riello et al. 2021, A&A 649, A3, table
/// C.2, for BP-RP within [`BP_RP`].
#[must_use]
pub fn v_from_gaia(g: f64, bp_rp: f64) -> f64 {
    let x = bp_rp.clamp(BP_RP[0], BP_RP[1]);
    g + 0.02704 - 0.01424 * x + 0.2156 * x * x - 0.01426 * x.powi(3)
}

/// Luminance Y of thermal light of `temperature` (kelvin) per unit of bolometric flux, as the
/// shader's table of colours has it.
pub fn luminance(temperature: f64) -> f64 {
    let (table, weights) = &*COLOURS;
    weights.dot(DVec3::from(spectrum::sample(table, temperature)))
}

/// The shader's table of colours, and the share of each primary in luminance.
static COLOURS: LazyLock<(Vec<[f32; 4]>, DVec3)> =
    LazyLock::new(|| (spectrum::table(), spectrum::rgb_from_xyz().inverse().row(1)));

/// Bolometric flux of a star of `magnitude` V and `temperature` (kelvin): the factor of its
/// `thermal_colour`, in linear light times steradians.
///
/// V is taken for luminance: F = F_0 10^(-0.4 V) / Y(T). For black bodies the two differ by
/// -0.09 mag at 2700 K, -0.02 at 5800 K and 0.007 at 18 000 K.
pub fn flux(magnitude: f64, temperature: f64) -> f64 {
    ZERO_MAGNITUDE_FLUX * 10_f64.powf(-0.4 * magnitude) / luminance(temperature)
}

/// Angular radius in radians of a star of `magnitude` V and `temperature` (kelvin), as seen from
/// Earth: a black body's flux is proportional to T^4 times the radius squared, and the Sun gives
/// the unit.
pub fn angular_radius(magnitude: f64, temperature: f64) -> f64 {
    let flux_ratio = flux(magnitude, temperature) / flux(SUN_MAGNITUDE, SUN_TEMPERATURE);
    SUN_RADIUS * flux_ratio.sqrt() * (SUN_TEMPERATURE / temperature).powi(2)
}
