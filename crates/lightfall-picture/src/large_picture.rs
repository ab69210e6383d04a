//! Pictures that are drawn tile by tile, and never are in memory as a whole.

use super::exr_rows::{rows_at_once, write_exr_rows};
use super::file::PictureError;
use super::headless::drawable;
use super::png_rows::{PngBits, TakeRows, write_png_rows};
use super::{Linear, PixelRays, Studio, Tiles};
use glam::UVec2;
use lightfall_core::scene::{Part, Scene};
use lightfall_platform::storage::{PictureRecord, WriteError, scratch_file};
use lightfall_render::{Captured, Chain, LIGHT_BYTES};
use std::fs::File;
use std::io::{BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A picture that is drawn tile by tile.
pub struct LargePicture<'a> {
    /// The scene as it is drawn, without cells, by [`exposed`].
    pub scene: &'a Scene,
    /// Its tiles.
    pub tiles: Tiles,
    /// Called after each tile of each sweep.
    pub on_tile: &'a mut dyn FnMut(),
}

/// The scene with the exposure that its light meter chooses for the whole picture, as one that was
/// chosen by hand.
///
/// # Errors
/// The scene cannot be drawn.
pub fn exposed(scene: &Scene) -> Result<Scene, PictureError> {
    let mut scene = drawable(scene)?.into_scene();
    scene.picture.automatic_exposure = false;
    Ok(scene)
}

/// How often the tiles of a scene's picture are drawn for a PNG. Bloom needs the light of the whole
/// picture before any of it can be developed, so there are two sweeps.
#[must_use]
pub fn png_sweeps(scene: &Scene, tiles: &Tiles) -> usize {
    let has_bloom = Chain::of(scene).bloom.is_some();
    if has_bloom && tiles.count() > 1 { 2 } else { 1 }
}

impl LargePicture<'_> {
    /// Draws the picture as a PNG. The studio must keep light where there are two sweeps, and make the
    /// levels of a file. The file appears under its name only when it is complete.
    ///
    /// # Errors
    /// Drawing failed, or the file or the temporary file beside it cannot be written.
    pub fn write_png(
        &mut self,
        studio: &mut Studio,
        (path, bits): (&Path, PngBits),
        record: &PictureRecord,
    ) -> Result<(), PictureError> {
        let whole = self.tiles.whole();
        write_png_rows(path, (whole, bits), record, |take| {
            self.draw_rows(studio, path, take)
        })
    }

    /// Draws the picture and gives its rows from the top: levels of red, green and blue of each pixel. The
    /// studio must keep light where there are two sweeps, and make the levels of a file. The light of the
    /// first sweep stands in a temporary file beside `path`.
    ///
    /// # Errors
    /// Those of `take`; or drawing failed, or the temporary file cannot be written.
    pub fn draw_rows(
        &mut self,
        studio: &mut Studio,
        path: &Path,
        take: &mut dyn FnMut(&[u16]) -> Result<(), PictureError>,
    ) -> Result<(), PictureError> {
        let mut light = None;
        if png_sweeps(self.scene, &self.tiles) > 1 {
            light = Some(self.draw_light(studio, path)?);
        }
        // What is given is light with the foreground, and the mean of all samples.
        let mut developed = self.scene.clone();
        if light.is_some() {
            developed.probe.enabled = false;
            developed.picture.samples = 1;
        }
        let drawn = self.draw_levels(studio, (&developed, light.as_mut()), take);
        studio.give_light(None);
        drawn
    }

    /// Draws the picture and returns its levels: red, green and blue of each pixel, rows from the top. The
    /// scene must have no bloom, unless there is one tile. The studio must make the levels of a file.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn levels(&mut self, studio: &mut Studio) -> Result<Vec<u16>, PictureError> {
        let mut levels = Vec::new();
        self.draw_levels(studio, (self.scene, None), &mut |rows| {
            levels.extend_from_slice(rows);
            Ok(())
        })?;
        Ok(levels)
    }

    /// Draws the levels of a scene, from its light if that is given.
    fn draw_levels(
        &mut self,
        studio: &mut Studio,
        (scene, mut light): (&Scene, Option<&mut Light>),
        take: TakeRows,
    ) -> Result<(), PictureError> {
        let columns = self.tiles.whole().x;
        for strip in self.tiles.strips() {
            let mut rows = Vec::new();
            for part in strip {
                let given = light.as_mut().map(|light| light.read(part)).transpose()?;
                studio.give_light(given);
                studio.show_part(scene, part)?;
                let levels = studio.levels()?.rgb;
                place(&mut rows, &levels, (part, columns, 3));
                (self.on_tile)();
            }
            take(&rows)?;
        }
        Ok(())
    }

    /// Draws the picture and returns its light and, if asked for, the depth of its foreground. The studio
    /// must keep light.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn light(
        &mut self,
        studio: &mut Studio,
        with_depth: bool,
    ) -> Result<(Captured, Vec<f32>), PictureError> {
        let size = self.tiles.whole();
        let (mut rgba, mut depth) = (Vec::new(), Vec::new());
        for strip in self.tiles.strips() {
            let (mut rows, mut depths) = (Vec::new(), Vec::new());
            for part in strip {
                studio.show_part(self.scene, part)?;
                place(&mut rows, &studio.light()?.rgba, (part, size.x, 1));
                if with_depth {
                    place(&mut depths, &studio.depth()?, (part, size.x, 1));
                }
                (self.on_tile)();
            }
            rgba.append(&mut rows);
            depth.append(&mut depths);
        }
        let light = Captured {
            size,
            rgba,
            depth: None,
        };
        Ok((light, depth))
    }

    /// Draws the light of all tiles to a temporary file beside `path`.
    fn draw_light(&mut self, studio: &mut Studio, path: &Path) -> Result<Light, PictureError> {
        let written = |error| WriteError::new(path, error);
        let mut file = BufWriter::new(scratch_file(path)?);
        let columns = self.tiles.whole().x;
        for strip in self.tiles.strips() {
            let mut rows = Vec::new();
            for part in strip {
                studio.show_part(self.scene, part)?;
                let light = studio.light()?;
                place(&mut rows, &light.rgba, (part, columns, 1));
                (self.on_tile)();
            }
            let bytes: Vec<u8> = rows
                .iter()
                .flatten()
                .flat_map(|half| half.to_le_bytes())
                .collect();
            file.write_all(&bytes).map_err(written)?;
        }
        let file = file
            .into_inner()
            .map_err(|error| written(error.into_error()))?;
        Ok(Light {
            file,
            columns,
            path: path.into(),
        })
    }

    /// Draws the picture as an EXR, of which `picture` says everything but the pixels. The studio must
    /// keep light. The file appears under its name only when it is complete.
    ///
    /// # Errors
    /// Drawing or tracing failed, or the file cannot be written.
    pub fn write_exr(
        &mut self,
        studio: &mut Studio,
        path: &Path,
        picture: &Linear,
        mut rays: Option<&mut PixelRays>,
    ) -> Result<(), PictureError> {
        let whole = self.tiles.whole();
        let at_once = rows_at_once(picture.form.compression);
        let with_depth = picture.channels.with_depth();
        write_exr_rows(path, whole, picture, |take| {
            // The rows that are drawn and not written yet, from `top` on.
            let (mut top, mut light, mut depth) = (0, Vec::new(), Vec::new());
            for strip in self.tiles.strips() {
                let (mut rows, mut depths) = (Vec::new(), Vec::new());
                let (mut drawn, mut tiles) = (top, 0);
                for part in strip {
                    studio.show_part(self.scene, part)?;
                    place(&mut rows, &studio.light()?.rgba, (part, whole.x, 1));
                    if with_depth {
                        place(&mut depths, &studio.depth()?, (part, whole.x, 1));
                    }
                    drawn = part.origin.y + part.size.y;
                    tiles += 1;
                }
                light.append(&mut rows);
                depth.append(&mut depths);
                while top < drawn && (drawn - top >= at_once || drawn == whole.y) {
                    let size = UVec2::new(whole.x, at_once.min(drawn - top));
                    let pixels = size.as_usizevec2().element_product();
                    let block = Captured {
                        size,
                        rgba: light.drain(..pixels).collect(),
                        depth: None,
                    };
                    let depths: Vec<f32> = depth.drain(..pixels.min(depth.len())).collect();
                    let samples = match &mut rays {
                        Some(rays) => rays
                            .sample_rows(self.scene, picture.channels, top..top + size.y, &depths)
                            .map_err(|error| PictureError::Draw(error.to_string()))?,
                        None => Vec::new(),
                    };
                    take(block, samples)?;
                    top += size.y;
                }
                // Their rays take about as long as the tiles do.
                for _ in 0..tiles {
                    (self.on_tile)();
                }
            }
            Ok(())
        })
    }
}

/// Puts the values of a part into the rows of its strip: `per_pixel` numbers for each of a strip's
/// `columns`.
fn place<T: Copy + Default>(
    rows: &mut Vec<T>,
    values: &[T],
    (part, columns, per_pixel): (Part, u32, usize),
) {
    let [columns, left, width] =
        [columns, part.origin.x, part.size.x].map(|pixels| pixels as usize * per_pixel);
    rows.resize(columns * part.size.y as usize, T::default());
    let strip = rows.chunks_exact_mut(columns);
    for (row, values) in strip.zip(values.chunks_exact(width)) {
        row[left..left + width].copy_from_slice(values);
    }
}

/// The light of a picture in a temporary file, in rows from the top.
struct Light {
    file: File,
    columns: u32,
    /// The file beside it, for errors.
    path: PathBuf,
}

impl Light {
    /// The light of a part.
    fn read(&mut self, part: Part) -> Result<Vec<u8>, PictureError> {
        let row_bytes = part.size.x as usize * LIGHT_BYTES;
        let mut bytes = vec![0; row_bytes * part.size.y as usize];
        for (y, row) in (part.origin.y..).zip(bytes.chunks_exact_mut(row_bytes)) {
            let pixel = u64::from(y) * u64::from(self.columns) + u64::from(part.origin.x);
            self.file
                .seek(SeekFrom::Start(pixel * LIGHT_BYTES as u64))
                .and_then(|_| self.file.read_exact(row))
                .map_err(|error| WriteError::new(&self.path, error))?;
        }
        Ok(bytes)
    }
}
