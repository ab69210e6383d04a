//! The images of a catalogue's named stars.

use super::StarImage;
use super::inversion::{Inversion, InversionError};
use super::mesh_layout::MeshLayout;
use super::ray_mesh::RayMesh;
use crate::stars::{Catalogue, hole_from_celestial};
use glam::DVec3;
use lightfall_model::scene::Scene;

/// Cells of the mesh with spin: its spacing is four times that of the picture's own, which loses
/// only images of less than a twentieth of the star's light.
const CELLS: f64 = MeshLayout::CELLS / 16.0;

/// An image of a star that has a name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedImage {
    /// The star's name.
    pub name: String,
    /// V of the image: the star's own, less 2.5 log10 of the image's gain.
    pub magnitude: f64,
    /// The image.
    pub image: StarImage,
}

/// The images of the brightest `count` named stars that are not fainter than `faintest` V,
/// brightest first. Around a hole with spin these are the images in the scene's picture; else they
/// are those on the whole sky.
///
/// # Errors
/// The scene's observer does not exist.
pub fn named_images(
    scene: &Scene,
    catalogue: &Catalogue,
    count: usize,
    faintest: f64,
) -> Result<Vec<NamedImage>, InversionError> {
    let find: Box<dyn Fn(DVec3) -> Vec<StarImage>> =
        if scene.effects.lensing && scene.hole.spin != 0.0 {
            let mesh = RayMesh::new(scene, CELLS)?;
            Box::new(move |star| mesh.images(star))
        } else {
            let inversion = Inversion::new(scene)?;
            Box::new(move |star| inversion.images(star).collect())
        };
    let sky = &scene.sky;
    let turn = hole_from_celestial(sky.ra_deg, sky.dec_deg, sky.roll_deg);
    let mut named = Vec::new();
    for known in catalogue.names().iter().take(count) {
        let star = turn * known.star.direction.as_dvec3();
        for image in find(star.normalize()) {
            let magnitude = f64::from(known.star.magnitude) - 2.5 * image.gain.log10();
            if magnitude <= faintest {
                named.push(NamedImage {
                    name: known.name.clone(),
                    magnitude,
                    image,
                });
            }
        }
    }
    named.sort_by(|a, b| a.magnitude.total_cmp(&b.magnitude));
    Ok(named)
}
