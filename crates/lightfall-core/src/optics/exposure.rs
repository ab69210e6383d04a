//! A light meter: how bright a scene's picture is, from a few of its rays.

use crate::geometry::observer::ObserverError;
use crate::optics::reference::Reference;
use crate::optics::{disk, spectrum};
use crate::scene::Scene;
use glam::{DVec2, DVec3};

/// Rays across and down the picture.
const RAYS: [usize; 2] = [16, 9];
/// The light that is exposed for: this share of the lit rays is darker.
const PERCENTILE: f64 = 0.85;
/// Light after exposure that such a place gets: bright, and not yet bleached by the tone mapping.
const WANTED: f64 = 0.7;
/// Luminance of linear sRGB.
const LUMINANCE: DVec3 = DVec3::new(0.2126, 0.7152, 0.0722);

/// The exposure, in powers of two, that suits the light of the scene's disk as the camera sees it,
/// `scale` being the disk's linear light per unit of brightness and relative flux. None where no
/// ray of the meter meets the disk: stars need no meter.
///
/// # ErrorSummary
/// If the scene's observer cannot exist.
pub fn suiting(scene: &Scene, scale: f64) -> Result<Option<f64>, ObserverError> {
    let reference = Reference::new(scene)?;
    let profile = disk::Profile::new(scene);
    let axes = scene.camera.tetrad_from_camera();
    let size = DVec2::new(
        f64::from(scene.picture.width),
        f64::from(scene.picture.height),
    );
    let [across, down] = RAYS;
    let mut lights: Vec<f64> = (0..across * down)
        .filter_map(|i| {
            let place = DVec2::new((i % across) as f64 + 0.5, (i / across) as f64 + 0.5);
            let pixel = place / DVec2::new(across as f64, down as f64) * size;
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
            let light = LUMINANCE.dot(seen) * flux * beaming * scene.disk.brightness * scale;
            (light.is_finite() && light > 0.0).then_some(light)
        })
        .collect();
    lights.sort_by(f64::total_cmp);
    let bright = lights.get((PERCENTILE * lights.len() as f64) as usize);
    Ok(bright.map(|light| (WANTED / light).log2()))
}
