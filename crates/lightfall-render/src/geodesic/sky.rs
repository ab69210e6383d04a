//! Pictures of the sky on the GPU.

use crate::graphics::Graphics;
use bevy::render::render_resource::*;
use lightfall_core::gpu::SkyTexture;
use lightfall_core::optics::sky_picture::SkyPicture;
use std::sync::Arc;

/// Maximum number of pictures: one for each of two compared scenes.
const MAX_PICTURES: usize = 2;

/// The pictures that scenes have shown last, the most recent one last.
#[derive(Default)]
pub(super) struct SkyPictures(Vec<SkyOnGpu>);

/// A picture of the sky, and its texture.
#[derive(Clone)]
pub(super) struct SkyOnGpu {
    picture: Arc<SkyPicture>,
    view: TextureView,
}

impl SkyOnGpu {
    /// Whether it is the texture of this picture.
    pub(super) fn shows(&self, picture: &Arc<SkyPicture>) -> bool {
        Arc::ptr_eq(&self.picture, picture)
    }

    /// The texture as a cube.
    pub(super) fn view(&self) -> &TextureView {
        &self.view
    }
}

impl SkyPictures {
    /// The texture of a picture, which is made at its first use.
    pub(super) fn get(&mut self, picture: &Arc<SkyPicture>, graphics: &Graphics) -> SkyOnGpu {
        let Self(pictures) = self;
        let sky = match pictures.iter().position(|known| known.shows(picture)) {
            Some(index) => pictures.remove(index),
            None => {
                let texture = graphics.device.create_texture_with_data(
                    &graphics.queue,
                    &SkyTexture::descriptor_of_picture(picture),
                    TextureDataOrder::LayerMajor,
                    &SkyTexture::bytes_of_picture(picture),
                );
                SkyOnGpu {
                    picture: Arc::clone(picture),
                    view: texture.create_view(&SkyTexture::view()),
                }
            }
        };
        if pictures.len() >= MAX_PICTURES {
            pictures.remove(0);
        }
        pictures.push(sky.clone());
        sky
    }
}
