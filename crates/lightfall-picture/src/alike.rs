//! Whether two scenes give the same picture.

use super::still::filled;
use super::{PictureError, Still, Studio};
use glam::UVec2;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Scene, resized};

/// The size of the pictures that are compared first, in pixels.
const SMALL: UVec2 = UVec2::new(160, 90);

impl Studio {
    /// Whether `other` gives the same bytes as `picture`, which `scene` gave. A scene that cannot be
    /// drawn gives none.
    ///
    /// Small pictures of both come first: nearly always they differ, and the comparison is cheap.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn draws_alike(
        &mut self,
        picture: &Still,
        scene: &Scene,
        other: &Scene,
    ) -> Result<bool, PictureError> {
        if Drawable::new(other.clone()).is_err() {
            return Ok(false);
        }
        if picture.size.cmpgt(SMALL).all() {
            let small = |scene: &Scene| {
                let mut small = scene.clone();
                small.picture = resized(&scene.picture, SMALL);
                small.picture.samples = 1;
                small
            };
            if self.draw(&small(scene))?.rgb != self.draw(&small(other))?.rgb {
                return Ok(false);
            }
        }
        Ok(self.draw(other)?.rgb == picture.rgb)
    }

    /// The picture of a scene, as it is drawn for a file.
    fn draw(&mut self, scene: &Scene) -> Result<Still, PictureError> {
        self.show(&filled(scene))?;
        self.settle()?;
        self.picture()
    }
}
