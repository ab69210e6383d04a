//! The light along a line of sight, in two bands.

use crate::galaxy::place;
use crate::neighbours;
use glam::DVec3;

/// The stars' light in V at the Sun, in solar luminosities per cubic parsec. It is chosen so that
/// the light of the whole sky is that of the counts of stars.
const LOCAL_LIGHT: f64 = 0.0666;

/// The brightness of one solar luminosity per square parsec, in magnitudes V per square second of
/// arc: 26.40 for the Sun's absolute magnitude 4.83.
const SOLAR_BRIGHTNESS: f64 = 26.40;

/// Colour B-V of the old and the young stars of the disk and of the bulge, without dust.
const OLD_B_V: f64 = 0.70;
const YOUNG_B_V: f64 = 0.30;
const BULGE_B_V: f64 = 0.95;

/// Extinction in B over that in V (Cardelli, Clayton & Mathis 1989, ApJ 345, 245: 1.32 for
/// R_V = 3.1).
const BLUE_EXTINCTION: f64 = 1.32;

/// A line of sight is followed to this distance in kpc, in steps that grow with the distance.
const LAST_DISTANCE: f64 = 25.0;
const FIRST_STEP: f64 = 0.006;
const STEP_GROWTH: f64 = 0.03;

/// Structure smaller than this, in radians, is left out: it is smaller than a texel of the map.
const FINEST_ANGLE: f64 = 0.006;

/// The diffuse light from a galactic direction (unit vector), in stars of V = 0 per steradian: V,
/// and B where a star of B-V = 0 counts the same in both.
///
/// I = integral of j 10^(-0.4 A) ds, with the stars' light j per volume and the extinction A of the
/// dust before them.
pub fn light_from(direction: DVec3) -> [f64; 2] {
    let mut light = [0.0; 2];
    let (mut distance, mut extinction) = (0.0, 0.0);
    let [old, young, bulge] = [OLD_B_V, YOUNG_B_V, BULGE_B_V].map(|b_v| 10_f64.powf(-0.4 * b_v));
    while distance < LAST_DISTANCE {
        let step = FIRST_STEP + STEP_GROWTH * distance;
        let here = place(direction * (distance + 0.5 * step), FINEST_ANGLE * distance);
        let across = here.extinction * step;
        let seen = |band: f64| 10_f64.powf(-0.4 * band * (extinction + 0.5 * across)) * step;
        light[0] += (here.old + here.young + here.bulge) * seen(1.0);
        light[1] +=
            (old * here.old + young * here.young + bulge * here.bulge) * seen(BLUE_EXTINCTION);
        extinction += across;
        distance += step;
    }
    // Per square parsec, and from square seconds to steradians.
    let unit =
        1000.0 * LOCAL_LIGHT * 10_f64.powf(-0.4 * SOLAR_BRIGHTNESS) * 3600_f64.to_degrees().powi(2);
    let [v, b] = neighbours::light_from(direction);
    [light[0] * unit + v, light[1] * unit + b]
}
