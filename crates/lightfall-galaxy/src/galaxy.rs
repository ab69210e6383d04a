//! The light of a galaxy like ours: a disk with spiral arms, and a bulge.
//!
//! Lengths are in kpc. The axes are galactic, with the Sun at the origin: x toward the centre, y
//! toward longitude 90 degrees, z toward the north galactic pole.

use crate::dust;
use crate::turbulence::Turbulence;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The Sun's distance from the centre and its height above the plane, of which 0.016 to 0.025 is
/// known (Freudenreich 1996, ApJ 468, 663; Bland-Hawthorn & Gerhard 2016, ARA&A 54, 529).
const SUN_RADIUS: f64 = 8.2;
const SUN_HEIGHT: f64 = 0.018;

/// Scale length and scale height of the disk's old stars (Freudenreich 1996: 2.64, and 0.333 as
/// sech^2), and scale height of its young ones.
const DISK_LENGTH: f64 = 2.64;
const OLD_HEIGHT: f64 = 0.27;
const YOUNG_HEIGHT: f64 = 0.09;

/// The disk is empty in the middle, where the bar is (Freudenreich 1996: 2.97).
const HOLE_RADIUS: f64 = 2.97;

/// The young stars' share of the light in the plane, and the clouds that they lie in: the exponent
/// of their density is this many times a random field, less a number that keeps the mean.
const YOUNG_SHARE: f64 = 0.50;
const STAR_CLOUDS: Turbulence = Turbulence {
    seed: 11,
    scale: 0.9,
    octaves: 5,
    persistence: 0.6,
};
const STAR_CLOUD_CONTRAST: f64 = 3.5;
const STAR_CLOUD_MEAN: f64 = 0.34;

/// Light of the bulge's centre over that of the disk at the Sun; its half axes, and the angle in
/// radians of the long one to the line from the Sun. The near end is at positive longitudes.
const BULGE_LIGHT: f64 = 2.1;
const BULGE_AXES: DVec3 = DVec3::new(1.7, 1.0, 0.7);
const BULGE_ANGLE: f64 = 0.4;

/// Spiral arms: their number, their pitch in radians, and where one crosses the line from the Sun
/// to the centre, as the Sagittarius arm does (after Reid et al. 2019, ApJ 885, 131).
const ARMS: f64 = 4.0;
const ARM_PITCH: f64 = 0.225;
const ARM_RADIUS: f64 = 6.7;

/// Farther from the plane there are neither young stars nor dust.
const MAX_LAYER_HEIGHT: f64 = 0.7;

/// What is at a point. The light of all stars of the disk at the Sun is about 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// Light in V of old stars of the disk per volume.
    pub old: f64,
    /// The same of young ones.
    pub young: f64,
    /// The same of the bulge.
    pub bulge: f64,
    /// Extinction in magnitudes V per kpc.
    pub extinction: f64,
}

/// What is at a point, without structure smaller than `finest`.
pub(crate) fn place(point: DVec3, finest: f64) -> Place {
    let from_centre = point - DVec3::X * SUN_RADIUS;
    let radius = from_centre.truncate().length();
    let outward = radius - SUN_RADIUS;
    let height = point.z + SUN_HEIGHT;
    let disk = (-outward / DISK_LENGTH).exp() * (1.0 - (-(radius / HOLE_RADIUS).powi(3)).exp());
    let old = (1.0 - YOUNG_SHARE) * disk * (-height.abs() / OLD_HEIGHT).exp();
    let bulge = BULGE_LIGHT * bulge(from_centre);
    if height.abs() > MAX_LAYER_HEIGHT {
        return Place {
            old,
            young: 0.0,
            bulge,
            extinction: 0.0,
        };
    }
    let arms = arms(from_centre.truncate(), radius);
    let clouds = (STAR_CLOUD_CONTRAST * STAR_CLOUDS.at(point, finest) - STAR_CLOUD_MEAN).exp();
    Place {
        old,
        young: YOUNG_SHARE * disk * arms * clouds * (-height.abs() / YOUNG_HEIGHT).exp(),
        bulge,
        extinction: dust::layer(point, outward, height, arms, finest) + dust::near_clouds(point),
    }
}

/// The light of the bulge over that of its centre: a bar like a bell.
fn bulge(from_centre: DVec3) -> f64 {
    let toward_sun = DVec2::new(-from_centre.x, from_centre.y);
    let along = DVec2::from_angle(-BULGE_ANGLE).rotate(toward_sun);
    let place = along.extend(from_centre.z) / BULGE_AXES;
    (-0.5 * place.length_squared()).exp()
}

/// The density of young stars over its mean on a circle: trailing arms in the shape of logarithmic
/// spirals.
fn arms(from_centre: DVec2, radius: f64) -> f64 {
    // The disk turns from the Sun toward longitude 90 degrees.
    let ahead = from_centre.y.atan2(-from_centre.x);
    let turns = (radius / ARM_RADIUS).max(1e-3).ln() / (TAU * ARM_PITCH.tan()) + ahead / TAU;
    let crest = 0.5 + 0.5 * (TAU * ARMS * turns).cos();
    // The square of the crest has the mean 3/8.
    0.4 + 1.6 * crest * crest
}
