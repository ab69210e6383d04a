//! Draws scenes and writes their pictures.

use super::film::FilmMaker;
use super::large::Tiling;
use super::pictures::drawn_scene;
use crate::commands::circumstances::commit;
use crate::commands::progress::Progress;
use crate::commands::stop::Stop;
use lightfall_core::scene::{Projection, Scene};
use lightfall_picture as picture;
use lightfall_picture::{
    Animation, Captured, Channels, ExrForm, Format, LargePicture, Linear, PictureError, PixelRays,
    Still, Studio,
};
use std::path::Path;

/// Draws scenes and writes their pictures.
pub(super) struct PictureWriter {
    pub(super) studio: Studio,
    pub(super) format: Format,
    /// How pictures are drawn in tiles; `None` if they are drawn at once.
    pub(super) tiling: Option<Tiling>,
    /// How many tiles are drawn.
    pub(super) progress: Option<Progress>,
    pub(super) channels: Channels,
    /// The form of an .exr.
    pub(super) form: ExrForm,
    /// Opened for the first picture that needs it.
    pub(super) rays: Option<PixelRays>,
    /// The last picture of a .png.
    pub(super) still: Option<Still>,
    /// Begun with the first frame.
    pub(super) animation: Option<Animation>,
    /// The film, if the pictures are given to one.
    pub(super) film: Option<FilmMaker>,
    /// How many pictures there will be.
    pub(super) frames: u32,
    pub(super) fps: Option<f64>,
}

impl PictureWriter {
    pub(super) fn write(&mut self, scene: &Scene, file: &Path) -> Result<(), Stop> {
        if let Some(tiling) = self.tiling {
            return match scene.camera.projection {
                Projection::Cube => self.write_cube(scene, file, tiling),
                _ => self.write_large(scene, file, tiling),
            };
        }
        let drawn = drawn_scene(scene, self.format);
        self.studio.show(&drawn)?;
        self.studio.settle()?;
        // The file's preset holds the exposure that was metered.
        let mut scene = scene.clone();
        scene.picture.exposure_ev = self.studio.scene().picture.exposure_ev;
        match self.format {
            Format::Png => {
                let still = self.studio.picture()?;
                picture::write_png(file, &still, &self.studio.record(&scene))?;
                self.still = Some(still);
                Ok(())
            }
            Format::Apng => {
                let still = self.studio.picture()?;
                Ok(self.add_frame(&scene, file, &still)?)
            }
            Format::Exr => self.write_exr(&scene, file),
            Format::Film => match &mut self.film {
                Some(film) => film.add(&mut self.studio, &scene, file),
                None => Ok(()),
            },
        }
    }

    /// Draws a picture in tiles and writes it.
    pub(super) fn write_large(
        &mut self,
        scene: &Scene,
        file: &Path,
        tiling: Tiling,
    ) -> Result<(), Stop> {
        let drawn = picture::exposed(scene)?;
        let mut scene = scene.clone();
        scene.picture.exposure_ev = drawn.picture.exposure_ev;
        let record = self.studio.record(&scene);
        let on_tile = &mut on_tile(&mut self.progress, file);
        let mut large = LargePicture {
            scene: &drawn,
            tiles: tiling.tiles,
            on_tile,
        };
        if let Some(film) = &mut self.film {
            return film.add_large(&mut self.studio, &mut large, file);
        }
        if self.format == Format::Png {
            let path = (file, tiling.bits);
            return Ok(large.write_png(&mut self.studio, path, &record)?);
        }
        let rays = if self.channels.list().is_empty() {
            None
        } else {
            if self.rays.is_none() {
                self.rays = Some(PixelRays::open().map_err(Stop::without_device)?);
            }
            self.rays.as_mut()
        };
        let commit = commit();
        let about = Linear {
            scene: &scene,
            record,
            light: Captured::empty(),
            first_row: 0,
            channels: &self.channels,
            samples: Vec::new(),
            form: self.form,
            commit: commit.as_deref(),
            fps: self.fps,
        };
        Ok(large.write_exr(&mut self.studio, file, &about, rays)?)
    }

    pub(super) fn add_frame(
        &mut self,
        scene: &Scene,
        file: &Path,
        still: &Still,
    ) -> Result<(), PictureError> {
        let animation = match &mut self.animation {
            Some(animation) => animation,
            none => {
                let pace = (self.frames, self.fps.unwrap_or(1.0));
                let record = self.studio.record(scene);
                none.insert(Animation::new(file, still.size, pace, &record)?)
            }
        };
        animation.add(still)
    }

    fn write_exr(&mut self, scene: &Scene, file: &Path) -> Result<(), Stop> {
        let light = self.studio.light()?;
        let depth = if self.channels.with_depth() {
            self.studio.depth()?
        } else {
            Vec::new()
        };
        let samples = self.samples(scene, &depth)?;
        self.write_linear(scene, file, (light, samples))
    }

    /// The numbers of the channels of a scene's picture, which has this depth.
    pub(super) fn samples(&mut self, scene: &Scene, depth: &[f32]) -> Result<Vec<Vec<f32>>, Stop> {
        if self.channels.list().is_empty() {
            return Ok(Vec::new());
        }
        let rays = match &mut self.rays {
            Some(rays) => rays,
            none => none.insert(PixelRays::open().map_err(Stop::without_device)?),
        };
        rays.sample(scene, &self.channels, depth)
            .map_err(Stop::failed)
    }

    /// Writes the light and the numbers of the channels of a scene's picture.
    pub(super) fn write_linear(
        &mut self,
        scene: &Scene,
        file: &Path,
        (light, samples): (Captured, Vec<Vec<f32>>),
    ) -> Result<(), Stop> {
        let commit = commit();
        let picture = Linear {
            scene,
            record: self.studio.record(scene),
            light,
            first_row: 0,
            channels: &self.channels,
            samples,
            form: self.form,
            commit: commit.as_deref(),
            fps: self.fps,
        };
        Ok(picture::write_exr(file, picture)?)
    }
}

/// What notes that a tile of a file's picture is drawn.
pub(super) fn on_tile(progress: &mut Option<Progress>, file: &Path) -> impl FnMut() {
    let task = file.display().to_string();
    move || {
        if let Some(progress) = progress {
            progress.advance(task.clone(), 1.0);
        }
    }
}
