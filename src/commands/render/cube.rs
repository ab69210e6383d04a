//! Pictures of the six sides of a cube about the camera: in one file, or in a file for each.

use super::large::Tiling;
use super::writer::{PictureWriter, on_tile};
use crate::commands::stop::Stop;
use lightfall_core::optics::exposure::exposed;
use lightfall_core::scene::{CubeLayout, CubeSide, Projection, Scene};
use lightfall_picture as picture;
use lightfall_picture::{Format, LargePicture, Still};
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

/// The file of a side.
pub(super) fn file_of(file: &Path, side: &CubeSide) -> PathBuf {
    with_face(file, side.name)
}

/// A file that is about all sides, of a name that may stand for those of the sides.
pub(super) fn file_of_all(file: &Path) -> PathBuf {
    with_face(file, "cube")
}

fn with_face(file: &Path, word: &str) -> PathBuf {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    file.with_file_name(name.replace(FACE, word))
}

/// The layout of a file of this format.
pub(super) fn layout(format: Format, file: &Path) -> CubeLayout {
    match format {
        Format::Exr if !is_of_side(file) => CubeLayout::COLUMN,
        _ => CubeLayout::THREE_BY_TWO,
    }
}

/// The number of pixels along the edges of the cube in a scene's picture, which has the shape of
/// [`CubeLayout::THREE_BY_TWO`].
pub(super) fn side_of(scene: &Scene) -> u32 {
    (scene.picture.width / CubeLayout::THREE_BY_TWO.columns).max(1)
}

/// The scene that is drawn at once: that of a cube's first side, or the scene itself.
pub(super) fn drawn_at_once(scene: &Scene) -> Scene {
    match scene.camera.projection {
        Projection::Cube => {
            let first = &CubeLayout::THREE_BY_TWO.sides[0];
            scene.cube_side(first, side_of(scene))
        }
        _ => scene.clone(),
    }
}

/// How many such scenes a picture is drawn of.
pub(super) fn pictures_at_once(scene: &Scene) -> usize {
    match scene.camera.projection {
        Projection::Cube => CubeLayout::THREE_BY_TWO.sides.len(),
        _ => 1,
    }
}

/// The sides of a scene's cube, in the order of the layout, each with its scene. One exposure serves all of
/// them, so each has it as one that was chosen.
pub(super) fn sides(scene: &Scene, layout: CubeLayout) -> Vec<(CubeSide, Scene)> {
    let side = side_of(scene);
    let mut chosen = scene.clone();
    chosen.picture.automatic_exposure = false;
    let sides = layout.sides.into_iter();
    sides
        .map(|face| (face, chosen.cube_side(&face, side)))
        .collect()
}

impl PictureWriter {
    /// Draws and writes the sides of a cube. One exposure, metered over the whole sky, serves them all.
    pub(super) fn write_cube(
        &mut self,
        scene: &Scene,
        file: &Path,
        tiling: Tiling,
    ) -> Result<(), Stop> {
        let scene = exposed(scene);
        let layout = layout(self.format, file);
        if is_of_side(file) {
            for (face, own) in sides(&scene, layout) {
                self.write_large(&own, &file_of(file, &face), tiling)?;
            }
            return Ok(());
        }
        let (mut levels, mut lights, mut channels) = (Vec::new(), Vec::new(), Vec::new());
        for (_, own) in sides(&scene, layout) {
            let mut on_tile = on_tile(&mut self.progress, file);
            let mut large = LargePicture {
                scene: &own,
                tiles: tiling.tiles,
                on_tile: &mut on_tile,
            };
            if self.format != Format::Exr {
                levels.push(large.levels(&mut self.studio)?);
                continue;
            }
            let (light, depth, layers) = large.light(&mut self.studio, &self.channels)?;
            drop(on_tile);
            lights.push(light);
            let mut samples = self.samples(&own, &depth)?;
            samples.extend(layers);
            channels.push(samples);
        }
        let side = side_of(&scene);
        if self.format == Format::Exr {
            let light = picture::joined_light(layout, &lights);
            let samples = picture::joined_channels(layout, side, &channels);
            return self.write_linear(&scene, file, (light, samples));
        }
        let (size, levels) = (
            layout.size(side),
            picture::joined_levels(layout, side, &levels),
        );
        if let Some(film) = &mut self.film {
            return Ok(film.add_levels(&levels, file)?);
        }
        if self.format == Format::Apng {
            let rgb = levels.into_iter().map(|level| level as u8).collect();
            return Ok(self.add_frame(&scene, file, &Still { size, rgb })?);
        }
        let record = self.studio.record(&scene);
        Ok(picture::write_png_levels(
            file,
            (size, tiling.bits),
            &levels,
            &record,
        )?)
    }
}
