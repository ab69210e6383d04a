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
    /// The form of an .exr, and what is transparent in a .png, too.
    pub(super) form: ExrForm,
    /// The moments whose light is averaged for the next picture; none for a picture of one moment.
    pub(super) moments: Vec<Scene>,
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
        if self.moments.is_empty() {
            self.studio.settle()?;
        }
        // The file's preset holds the exposure that was metered.
        let mut scene = scene.clone();
        scene.picture.exposure_ev = self.studio.scene().picture.exposure_ev;
        match self.format {
            Format::Png if self.form.transparent.is_some() => {
                let still = self.studio.transparent_picture()?;
                let record = self.studio.record(&scene);
                Ok(picture::write_transparent_png(file, &still, &record)?)
            }
            Format::Png => {
                let still = self.still()?;
                picture::write_png(file, &still, &self.studio.record(&scene))?;
                self.still = Some(still);
                Ok(())
            }
            Format::Apng => {
                let still = self.still()?;
                Ok(self.add_frame(&scene, file, &still)?)
            }
            Format::Exr => self.write_exr(&scene, file),
            Format::Film => Ok(self.add_to_film(&scene, file)?),
        }
    }

    /// Adds the picture of the scene that is shown to the film.
    fn add_to_film(&mut self, scene: &Scene, file: &Path) -> Result<(), PictureError> {
        if !self.film.as_ref().is_some_and(FilmMaker::is_of_light) {
            let still = self.still()?;
            return self
                .film
                .as_mut()
                .map_or(Ok(()), |film| film.add_still(&still, file));
        }
        let light = if self.moments.is_empty() {
            self.studio.light()?
        } else {
            self.mean_light()?.0
        };
        let film = self.film.as_mut();
        film.map_or(Ok(()), |film| film.add_light(&light, scene, file))
    }

    /// The picture of the scene that is shown, or that of the mean light of its moments.
    fn still(&mut self) -> Result<Still, PictureError> {
        if self.moments.is_empty() {
            return self.studio.picture();
        }
        let exposed = self.studio.scene().clone();
        let (light, _) = self.mean_light()?;
        self.studio.developed(&exposed, &light)
    }

    /// The mean of the light and of the layers of the moments.
    fn mean_light(&mut self) -> Result<(Captured, Vec<Vec<f32>>), PictureError> {
        let moments: Vec<Scene> = self
            .moments
            .iter()
            .map(|moment| drawn_scene(moment, self.format))
            .collect();
        self.studio.mean_light(&moments, &self.channels)
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
        let rays = opened_rays(&mut self.rays, &self.channels)?;
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
        let own = if self.moments.is_empty() {
            Some(self.studio.light()?)
        } else {
            None
        };
        // Depth and rays are those of the frame's own moment: their means would mean nothing.
        let depth = if self.channels.with_depth() {
            self.studio.depth()?
        } else {
            Vec::new()
        };
        let mut samples = self.samples(scene, &depth)?;
        let (light, layers) = match own {
            Some(light) => (light, self.studio.layers(&self.channels)?),
            None => self.mean_light()?,
        };
        samples.extend(layers);
        self.write_linear(scene, file, (light, samples))
    }

    /// The numbers of the channels of rays of a scene's picture, which has this depth.
    pub(super) fn samples(&mut self, scene: &Scene, depth: &[f32]) -> Result<Vec<Vec<f32>>, Stop> {
        let Some(rays) = opened_rays(&mut self.rays, &self.channels)? else {
            return Ok(Vec::new());
        };
        let samples = rays.sample(scene, &self.channels, depth);
        samples.map_err(|error| PictureError::from(error).into())
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

/// What traces the rays of channels, which is opened for the first picture that has any; `None` without them.
fn opened_rays<'a>(
    rays: &'a mut Option<PixelRays>,
    channels: &Channels,
) -> Result<Option<&'a mut PixelRays>, Stop> {
    if channels.of_rays().is_empty() {
        return Ok(None);
    }
    Ok(Some(match rays {
        Some(rays) => rays,
        none => none.insert(PixelRays::open().map_err(Stop::without_device)?),
    }))
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
