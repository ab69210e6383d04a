//! The light of all stars, and the share of the faint ones: the catalogue's stars as far as V = 6, the
//! counts beyond.

use lightfall_core::optics::stars::{Catalogue, number_brighter};
use std::sync::LazyLock;

/// The sum is taken from V = -2 to 25, in steps of a tenth. What is fainter is less than a ten
/// thousandth.
const FIRST: f64 = -2.0;
const STEPS: usize = 270;
const STEPS_PER_MAGNITUDE: f64 = 10.0;
/// The catalogue is complete down to this magnitude.
const CATALOGUE_MAGNITUDE: f64 = 6.0;

/// The light of all stars, in stars of V = 0.
pub(crate) fn total_light() -> f64 {
    LIGHT[0]
}

/// The share of the light of all stars that comes from stars fainter than `magnitude` V.
pub(crate) fn fainter_share(magnitude: f64) -> f64 {
    let place = ((magnitude - FIRST) * STEPS_PER_MAGNITUDE).clamp(0.0, STEPS as f64);
    let low = (place as usize).min(STEPS - 1);
    let weight = place - low as f64;
    ((1.0 - weight) * LIGHT[low] + weight * LIGHT[low + 1]) / total_light()
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
