//! The faintest stars that a picture shows as points.

use super::list::MAX_MAGNITUDE;
use crate::camera_rays::CameraRays;
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::scene::Scene;

/// V of the faintest stars in a picture whose pixels have [`PIXEL_SOLID_ANGLE`]: the brightest
/// pixel of such a star is a third of the diffuse background.
const FAINTEST: f64 = 8.0;

/// Solid angle in steradians of a pixel in the middle of a picture of 960x540 pixels with a field
/// of view of 50 degrees.
const PIXEL_SOLID_ANGLE: f64 = 2.983e-6;

/// Largest magnification by the lens, in magnitudes, for which images are found: it magnifies few
/// images more, except close to the Einstein ring.
const LENS_ALLOWANCE: f64 = 0.5;

/// Largest ratio of frequencies that counts.
const MAX_SHIFT: f64 = 1e3;

/// How deep a picture's stars go, in V.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Depth {
    /// The faintest image that is drawn as a point has the flux of a star of this magnitude.
    pub limit: f64,
    /// The faintest star of which an image is drawn, at any magnification.
    pub last: f64,
}

impl Depth {
    /// No star is a point: the diffuse light holds all.
    pub const NO_POINTS: Self = Self {
        limit: -30.0,
        last: -30.0,
    };

    /// The depth of a scene's picture, on a device that draws stars down to `deepest`.
    ///
    /// A pixel's background is proportional to its solid angle and a star's light is not, so
    /// fainter stars stand out on smaller pixels.
    ///
    /// # Errors
    /// The scene's observer does not exist.
    pub fn new(scene: &Scene, deepest: f64) -> Result<Self, ObserverError> {
        let deepest = deepest.min(MAX_MAGNITUDE);
        let pixel = scene.pixel_angle().powi(2);
        let visible = FAINTEST + 2.5 * (PIXEL_SOLID_ANGLE / pixel).log10();
        let limit = visible.min(scene.sky.magnitude_limit).min(deepest);
        let [rest, outward, theta, phi] = CameraRays::new(scene)?.matrix.rows[0];
        let least_energy = rest - glam::DVec3::new(outward, theta, phi).length();
        let shift = 1.0 / least_energy.clamp(1.0 / MAX_SHIFT, 1.0);
        // A moving observer sees the flux grow with the square of the shift, and aberration takes
        // the rest of the fourth power; one who hovers sees much the same.
        let brightening = 5.0 * shift.log10() + LENS_ALLOWANCE;
        Ok(Self {
            limit,
            last: (limit + brightening).min(deepest),
        })
    }
}
