//! Pictures that are drawn tile by tile, and never are in memory as a whole.

use super::exr_rows::{rows_at_once, write_exr_rows};
use super::file::PictureError;
use super::headless::drawable;
use super::png_rows::{PngBits, TakeRows, write_png_rows};
use super::{Channels, Linear, PixelRays, Studio, Tiles};
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
        take: TakeRows,
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

    /// Draws the picture and returns its light and, where the channels have them, the depth of its
    /// foreground and the numbers of its layers. The studio must keep light.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn light(
        &mut self,
        studio: &mut Studio,
        channels: &Channels,
    ) -> Result<(Captured, Vec<f32>, Vec<Vec<f32>>), PictureError> {
        let mut drawn = Rows::of(channels);
        for strip in self.tiles.strips() {
            let mut rows = Rows::of(channels);
            for part in strip {
                rows.draw(studio, (self.scene, part), channels)?;
                (self.on_tile)();
            }
            drawn.append(rows);
        }
        let light = Captured {
            size: self.tiles.whole(),
            rgba: drawn.light,
            depth: None,
        };
        Ok((light, drawn.depth, drawn.layers))
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
        let channels = picture.channels;
        write_exr_rows(path, whole, picture, |take| {
            // The rows that are drawn and not written yet, from `top` on.
            let (mut top, mut waiting) = (0, Rows::of(channels));
            for strip in self.tiles.strips() {
                let mut rows = Rows::of(channels);
                let (mut drawn, mut tiles) = (top, 0);
                for part in strip {
                    rows.draw(studio, (self.scene, part), channels)?;
                    drawn = part.origin.y + part.size.y;
                    tiles += 1;
                }
                waiting.append(rows);
                while top < drawn && (drawn - top >= at_once || drawn == whole.y) {
                    let size = UVec2::new(whole.x, at_once.min(drawn - top));
                    let next = waiting.take(size.as_usizevec2().element_product());
                    let block = Captured {
                        size,
                        rgba: next.light,
                        depth: None,
                    };
                    let mut samples = match &mut rays {
                        Some(rays) => rays
                            .sample_rows(self.scene, channels, top..top + size.y, &next.depth)
                            .map_err(PictureError::from)?,
                        None => Vec::new(),
                    };
                    samples.extend(next.layers);
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

/// What is drawn of some rows of a picture: their light, and where the channels have them the depth of the
/// foreground and the numbers of layers.
struct Rows {
    light: Vec<[u16; 4]>,
    depth: Vec<f32>,
    layers: Vec<Vec<f32>>,
}

impl Rows {
    /// No rows of a picture with these channels.
    fn of(channels: &Channels) -> Self {
        Self {
            light: Vec::new(),
            depth: Vec::new(),
            layers: vec![Vec::new(); channels.of_layers().len()],
        }
    }

    /// Draws a part of a scene's picture into the rows of its strip.
    fn draw(
        &mut self,
        studio: &mut Studio,
        (scene, part): (&Scene, Part),
        channels: &Channels,
    ) -> Result<(), PictureError> {
        let columns = scene.picture.width;
        studio.show_part(scene, part)?;
        place(&mut self.light, &studio.light()?.rgba, (part, columns, 1));
        if channels.with_depth() {
            place(&mut self.depth, &studio.depth()?, (part, columns, 1));
        }
        for (rows, numbers) in self.layers.iter_mut().zip(studio.layers(channels)?) {
            place(rows, &numbers, (part, columns, 1));
        }
        Ok(())
    }

    /// Adds rows below.
    fn append(&mut self, mut below: Self) {
        self.light.append(&mut below.light);
        self.depth.append(&mut below.depth);
        for (rows, below) in self.layers.iter_mut().zip(&mut below.layers) {
            rows.append(below);
        }
    }

    /// Takes the first pixels away.
    fn take(&mut self, pixels: usize) -> Self {
        fn first<T>(rows: &mut Vec<T>, pixels: usize) -> Vec<T> {
            rows.drain(..pixels.min(rows.len())).collect()
        }
        Self {
            light: first(&mut self.light, pixels),
            depth: first(&mut self.depth, pixels),
            layers: self
                .layers
                .iter_mut()
                .map(|rows| first(rows, pixels))
                .collect(),
        }
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
