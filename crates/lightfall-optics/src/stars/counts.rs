//! How many stars there are, and how much of their light comes from faint ones.

/// The number of stars of the whole sky that are brighter than `magnitude` V, for 4 <= V <= 25:
/// log10 N = 0.795 + 0.484 V + 0.0019 V^2 - 0.0003 V^3.
///
/// An empirical fit (Oesper 2020, "Counting Stars", cosmicreflections.skythisweek.info). It has
/// 5042 stars brighter than 6, where the Bright Star Catalogue has 5022, and 25 400 brighter than
/// 7.5, where Tycho has 26 500.
pub fn number_brighter(magnitude: f64) -> f64 {
    let v = magnitude;
    10_f64.powf(0.795 + v * (0.484 + v * (0.0019 - 0.0003 * v)))
}

/// Coefficients, from the constant one, of the cubic p in the share of all starlight that comes
/// from stars fainter than a magnitude V: 1 / (1 + exp(p(V - 11))). It differs by less than 0.01
/// from the share by the catalogue's stars to V = 6 and [`number_brighter`] beyond.
pub const FAINTER_SHARE: [f64; 4] = [0.226_21, 0.330_94, 0.007_313, 0.001_000_7];
