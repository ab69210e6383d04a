//! Draws scenes and writes their pictures.

use super::pictures::drawn_scene;
use crate::commands::circumstances::commit;
use crate::commands::stop::Stop;
use lightfall_core::scene::{Projection, Scene};
use lightfall_picture as picture;
use lightfall_picture::{
    Animation, ChannelNames, Channels, Format, Linear, PictureError, PixelRays, Still, Studio,
};
use lightfall_render::Captured;
use std::path::Path;

/// Draws scenes and writes their pictures.
pub(super) struct PictureWriter {
    pub(super) studio: Studio,
    pub(super) format: Format,
    pub(super) channels: Channels,
    pub(super) names: ChannelNames,
    /// Opened for the first picture that needs it.
    pub(super) rays: Option<PixelRays>,
    /// The last picture of a .png.
    pub(super) still: Option<Still>,
    /// Begun with the first frame.
    pub(super) animation: Option<Animation>,
    /// How many pictures there will be.
    pub(super) frames: u32,
    pub(super) fps: Option<f64>,
}

impl PictureWriter {
    pub(super) fn write(&mut self, scene: &Scene, file: &Path) -> Result<(), Stop> {
        if scene.camera.projection == Projection::Cube {
            return self.write_cube(scene, file);
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
        }
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

    pub(super) fn write_exr(&mut self, scene: &Scene, file: &Path) -> Result<(), Stop> {
        let (light, samples) = self.data(scene)?;
        self.write_linear(scene, file, light, samples)
    }

    /// The light of the picture that is shown, and the numbers of its channels.
    pub(super) fn data(&mut self, scene: &Scene) -> Result<(Captured, Vec<Vec<f32>>), Stop> {
        let light = self.studio.light()?;
        let depth = if self.channels.with_depth() {
            self.studio.depth()?
        } else {
            Vec::new()
        };
        let samples = if self.channels.list().is_empty() {
            Vec::new()
        } else {
            let rays = match &mut self.rays {
                Some(rays) => rays,
                none => none.insert(PixelRays::open().map_err(Stop::without_device)?),
            };
            rays.sample(scene, &self.channels, &depth)
                .map_err(Stop::failed)?
        };
        Ok((light, samples))
    }

    /// Writes the light and the numbers of channels of a scene's picture.
    pub(super) fn write_linear(
        &mut self,
        scene: &Scene,
        file: &Path,
        light: Captured,
        samples: Vec<Vec<f32>>,
    ) -> Result<(), Stop> {
        let commit = commit();
        let picture = Linear {
            scene,
            record: self.studio.record(scene),
            light,
            channels: &self.channels,
            samples,
            names: self.names,
            commit: commit.as_deref(),
            fps: self.fps,
        };
        Ok(picture::write_exr(file, picture)?)
    }
}
