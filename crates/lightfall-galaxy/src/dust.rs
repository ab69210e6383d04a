//! The dust of the galaxy: a layer full of clouds, and great clouds near the Sun. Lengths and axes
//! are those of the galaxy's light.

use crate::clouds;
use crate::turbulence::Turbulence;
use glam::DVec3;

/// Scale length and scale height of the layer, and its mean extinction at the Sun in magnitudes V
/// per kpc. Toward the centre it grows no further than this far inside the Sun's circle.
const LENGTH: f64 = 4.0;
const HEIGHT: f64 = 0.12;
const LOCAL_EXTINCTION: f64 = 0.9;
const MAX_INWARD: f64 = 5.0;

/// The layer's middle is a wavy sheet.
const WAVES: Turbulence = Turbulence {
    seed: 47,
    scale: 0.8,
    octaves: 3,
    persistence: 0.5,
};
const WAVE_HEIGHT: f64 = 0.09;

/// The layer's clouds and sheets: the exponent of its density is a sum of two random fields, less a
/// number that keeps the mean. Both are bent by a third one, as by winds.
const CLOUDS: Turbulence = Turbulence {
    seed: 29,
    scale: 0.3,
    octaves: 8,
    persistence: 0.76,
};
const CLOUD_CONTRAST: f64 = 6.0;
const SHEETS: Turbulence = Turbulence {
    seed: 83,
    scale: 0.25,
    octaves: 7,
    persistence: 0.7,
};
const SHEET_CONTRAST: f64 = 4.0;
const LAYER_MEAN: f64 = 1.6;
const WINDS: Turbulence = Turbulence {
    seed: 61,
    scale: 0.25,
    octaves: 3,
    persistence: 0.5,
};
const WIND_LENGTH: f64 = 0.16;

/// Dust is rare this close to the Sun (the Local Bubble).
const BUBBLE_RADIUS: f64 = 0.1;

/// The structure of the great clouds is given by angle, in radians, because each of them is at one
/// distance: wisps, which winds bend, and no smaller than a texel.
const WISPS: Turbulence = Turbulence {
    seed: 97,
    scale: 0.14,
    octaves: 5,
    persistence: 0.75,
};
const WISP_CONTRASTS: [f64; 2] = [7.8, 6.5];
const WISP_WINDS: Turbulence = Turbulence {
    seed: 71,
    scale: 0.25,
    octaves: 3,
    persistence: 0.6,
};
const WISP_WIND_ANGLE: f64 = 0.13;
const FINEST_WISP: f64 = 0.006;

/// There are no great clouds farther from the Sun, or farther from its height.
const MAX_CLOUD_DISTANCE: f64 = 1.5;
const MAX_CLOUD_HEIGHT: f64 = 0.3;

/// Extinction of the layer in magnitudes V per kpc: at a point, `outward` of the Sun's circle and
/// at a `height` above the plane, where the spiral arms have so many times the mean density.
pub(crate) fn layer(point: DVec3, outward: f64, height: f64, arms: f64, finest: f64) -> f64 {
    let bent = point + WIND_LENGTH * WINDS.vector_at(point, finest);
    let middle = WAVE_HEIGHT * WAVES.at(DVec3::new(bent.x, bent.y, 0.5), finest);
    let smooth = (-outward.max(-MAX_INWARD) / LENGTH - (height - middle).abs() / HEIGHT).exp();
    let clouds = CLOUD_CONTRAST * CLOUDS.at(bent, finest);
    let sheets = SHEET_CONTRAST * SHEETS.ridges(bent, finest);
    let bubble = (point.length() / BUBBLE_RADIUS).powi(4);
    let mean = LOCAL_EXTINCTION * smooth * (0.5 + 0.5 * arms) * bubble / (1.0 + bubble);
    mean * (clouds + sheets - LAYER_MEAN).exp()
}

/// Extinction of the great clouds near the Sun at a point, in magnitudes V per kpc.
pub(crate) fn near_clouds(point: DVec3) -> f64 {
    let distance = point.length();
    if distance > MAX_CLOUD_DISTANCE || point.z.abs() > MAX_CLOUD_HEIGHT {
        return 0.0;
    }
    let angles = point / distance + 0.3 * point;
    let bend = WISP_WIND_ANGLE * WISP_WINDS.vector_at(angles, FINEST_WISP);
    let smooth = clouds::extinction(point + distance * bend);
    if smooth == 0.0 {
        return 0.0;
    }
    let [clouds, sheets] = WISP_CONTRASTS;
    let wisps = clouds * WISPS.at(angles + bend, FINEST_WISP)
        + sheets * WISPS.ridges(angles + bend, FINEST_WISP);
    // With these wisps the fraction has the mean 0.53.
    smooth * (0.15 + 1.6 / (1.0 + (-wisps).exp()))
}
