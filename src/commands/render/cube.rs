//! Pictures of the six sides of a cube about the camera: in one file, or in a file for each.

use super::writer::PictureWriter;
use crate::commands::stop::Stop;
use lightfall_core::optics::exposure::exposed;
use lightfall_core::scene::{CubeLayout, CubeSide, Projection, Scene};
use lightfall_picture as picture;
use lightfall_picture::Format;
use std::path::{Path, PathBuf};

/// What stands for the side's name in the name of a file.
const FACE: &str = "{face}";

/// The files of a picture: one, or one for each side of a cube.
pub(super) fn files_of(file: &Path) -> Vec<PathBuf> {
    if !is_of_side(file) {
        return vec![file.into()];
    }
    let sides = CubeLayout::THREE_BY_TWO.sides;
    sides.iter().map(|side| file_of(file, side)).collect()
}

/// Whether a name stands for the files of the sides.
pub(super) fn is_of_side(file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default();
    name.to_string_lossy().contains(FACE)
}

fn file_of(file: &Path, side: &CubeSide) -> PathBuf {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    file.with_file_name(name.replace(FACE, side.name))
}

/// The layout of a file of this format.
fn layout(format: Format, file: &Path) -> CubeLayout {
    match format {
        Format::Exr if !is_of_side(file) => CubeLayout::COLUMN,
        _ => CubeLayout::THREE_BY_TWO,
    }
}

/// The number of pixels along the edges of the cube in a scene's picture, which has the shape of
/// [`CubeLayout::THREE_BY_TWO`].
fn side_of(scene: &Scene) -> u32 {
    (scene.picture.width / CubeLayout::THREE_BY_TWO.columns).max(1)
}

/// The scene that is drawn at once: that of a cube's first side, or the scene itself.
pub(super) fn first_drawn(scene: &Scene) -> Scene {
    match scene.camera.projection {
        Projection::Cube => {
            let first = &CubeLayout::THREE_BY_TWO.sides[0];
            scene.cube_side(first, side_of(scene))
        }
        _ => scene.clone(),
    }
}

impl PictureWriter {
    /// Writes the sides of a cube. One exposure, metered over the whole sky, serves them all.
    pub(super) fn write_cube(&mut self, scene: &Scene, file: &Path) -> Result<(), Stop> {
        let scene = exposed(scene);
        let (layout, side) = (layout(self.format, file), side_of(&scene));
        let (mut stills, mut lights, mut channels) = (Vec::new(), Vec::new(), Vec::new());
        for face in &layout.sides {
            let mut drawn = scene.cube_side(face, side);
            drawn.picture.automatic_exposure = false;
            self.studio.show(&drawn)?;
            self.studio.settle()?;
            let own = is_of_side(file).then(|| file_of(file, face));
            match (self.format, own) {
                (Format::Exr, Some(own)) => self.write_exr(&drawn, &own)?,
                (Format::Exr, None) => {
                    let (light, samples) = self.data(&drawn)?;
                    lights.push(light);
                    channels.push(samples);
                }
                (_, Some(own)) => {
                    let still = self.studio.picture()?;
                    picture::write_png(&own, &still, &self.studio.record(&drawn))?;
                }
                (_, None) => stills.push(self.studio.picture()?),
            }
        }
        match self.format {
            _ if is_of_side(file) => Ok(()),
            Format::Exr => {
                let light = picture::joined_light(layout, &lights);
                let samples = picture::joined_channels(layout, side, &channels);
                self.write_linear(&scene, file, light, samples)
            }
            Format::Png => {
                let still = picture::joined_stills(layout, &stills);
                let record = self.studio.record(&scene);
                Ok(picture::write_png(file, &still, &record)?)
            }
            Format::Apng => {
                let still = picture::joined_stills(layout, &stills);
                Ok(self.add_frame(&scene, file, &still)?)
            }
        }
    }
}
