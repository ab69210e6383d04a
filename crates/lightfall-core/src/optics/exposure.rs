//! A light meter: measures how bright the disk is in a scene's picture, with a few rays.

use crate::geometry::observer::ObserverError;
use crate::optics::photometry::DISK_HDR_SCALE;
use crate::optics::reference::Reference;
use crate::optics::{disk, spectrum};
use crate::scene::Scene;
use glam::{DVec2, DVec3};

/// Columns and rows of rays over the picture.
const RAYS: [usize; 2] = [16, 9];
/// The exposure is for the light of this quantile: this share of the rays that meet the disk is
/// darker.
const QUANTILE: f64 = 0.85;
/// Luminance of that quantile after exposure: bright, and not yet desaturated by the tone mapping.
const TARGET_LUMINANCE: f64 = 0.7;
/// Luminance of the channels of linear sRGB (Rec. 709).
const LUMINANCE: DVec3 = DVec3::new(0.2126, 0.7152, 0.0722);

/// The exposure, in powers of two, for the disk's light as the scene's camera sees it. `None` where
/// no ray of the meter meets the disk: the exposure does not depend on the stars.
///
/// # Errors
/// If the scene's observer cannot exist.
pub fn metered_exposure(scene: &Scene) -> Result<Option<f64>, ObserverError> {
    let reference = Reference::new(scene)?;
    let profile = disk::Profile::new(scene);
    let axes = scene.camera.tetrad_from_camera();
    let size = scene.picture.size().as_dvec2();
    let [columns, rows] = RAYS;
    let mut lights: Vec<f64> = (0..columns * rows)
        .filter_map(|i| {
            let cell = DVec2::new((i % columns) as f64 + 0.5, (i / columns) as f64 + 0.5);
            let pixel = cell / DVec2::new(columns as f64, rows as f64) * size;
            let hit = reference
                .trace(axes * scene.camera.looking(pixel, size))
                .hits[0]?;
            let flux = profile.flux(hit.r);
            let seen = DVec3::from(spectrum::colour(
                hit.g * disk::temperature(&scene.disk, flux),
            ));
            let beaming = if scene.effects.beaming {
                hit.g.powi(4)
            } else {
                1.0
            };
            let light =
                LUMINANCE.dot(seen) * flux * beaming * scene.disk.brightness * DISK_HDR_SCALE;
            (light.is_finite() && light > 0.0).then_some(light)
        })
        .collect();
    lights.sort_by(f64::total_cmp);
    let bright = lights.get((QUANTILE * lights.len() as f64) as usize);
    Ok(bright.map(|light| (TARGET_LUMINANCE / light).log2()))
}
