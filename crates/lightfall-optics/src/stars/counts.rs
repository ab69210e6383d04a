//! How many stars there are, and how their light is shared among bright and faint ones.

use super::catalogue::Catalogue;
use std::sync::LazyLock;

/// The sum of the light of all stars is taken from V = -2 to 25, in steps of a tenth. What is
/// fainter is less than a ten thousandth.
const FIRST: f64 = -2.0;
const STEPS: usize = 270;
const STEPS_PER_MAGNITUDE: f64 = 10.0;

/// Down to here the catalogue's own stars are summed. It is complete so far.
const CATALOGUE_MAGNITUDE: f64 = 6.0;

/// The number of stars of the whole sky that are brighter than `magnitude` V, for 4 <= V <= 25:
/// log10 N = 0.795 + 0.484 V + 0.0019 V^2 - 0.0003 V^3.
///
/// An empirical fit (Oesper 2020, "Counting Stars", cosmicreflections.skythisweek.info). It has
/// 5042 stars brighter than 6, where the Bright Star Catalogue has 5022, and 25 400 brighter than
/// 7.5, where Tycho has 26 500.
#[must_use]
pub fn number_brighter(magnitude: f64) -> f64 {
    let v = magnitude;
    10_f64.powf(0.795 + v * (0.484 + v * (0.0019 - 0.0003 * v)))
}

/// The light of all stars, in stars of V = 0.
#[must_use]
pub fn total_light() -> f64 {
    LIGHT[0]
}

/// The share of the light of all stars that comes from stars fainter than `magnitude` V: the
/// catalogue's stars as far as V = 6, [`number_brighter`] beyond.
#[must_use]
pub fn fainter_share(magnitude: f64) -> f64 {
    let place = ((magnitude - FIRST) * STEPS_PER_MAGNITUDE).clamp(0.0, STEPS as f64);
    let low = (place as usize).min(STEPS - 1);
    let weight = place - low as f64;
    ((1.0 - weight) * LIGHT[low] + weight * LIGHT[low + 1]) / total_light()
}

/// Coefficients of the cubic of [`fitted_fainter_share`], from the constant one.
pub const FAINTER_SHARE: [f64; 4] = [0.226_21, 0.330_94, 0.007_313, 0.001_000_7];

/// [`fainter_share`] as a shader computes it: 1 / (1 + exp(p(V - 11))) with a cubic p. The two
/// differ by less than 0.01 at any magnitude.
#[must_use]
pub fn fitted_fainter_share(magnitude: f64) -> f64 {
    let x = magnitude - 11.0;
    let [a, b, c, d] = FAINTER_SHARE;
    1.0 / (1.0 + (a + x * (b + x * (c + x * d))).exp())
}

/// The light of the stars fainter than each step, in stars of V = 0.
static LIGHT: LazyLock<Vec<f64>> = LazyLock::new(|| {
    let edge = |step: usize| FIRST + step as f64 / STEPS_PER_MAGNITUDE;
    let light_of_one = |magnitude: f64| 10_f64.powf(-0.4 * magnitude);
    let stars = Catalogue::built_in().stars();
    let mut light = vec![0.0; STEPS + 1];
    for step in (0..STEPS).rev() {
        let (bright, faint) = (edge(step), edge(step + 1));
        let between = if faint > CATALOGUE_MAGNITUDE {
            let number = number_brighter(faint) - number_brighter(bright);
            number * light_of_one(0.5 * (bright + faint))
        } else {
            stars
                .iter()
                .map(|star| f64::from(star.magnitude))
                .filter(|magnitude| (bright..faint).contains(magnitude))
                .map(light_of_one)
                .sum()
        };
        light[step] = light[step + 1] + between;
    }
    light
});
