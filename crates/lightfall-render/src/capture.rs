//! Copies of the traced light and the depth, taken before bloom and tone mapping, for pictures of
//! linear light. A chain copies them only where there is a [`Capture`].

use crate::accumulate::accumulate_frame;
use crate::camera_markers::SceneCamera;
use crate::graphics::{create_buffer, picture_size};
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::image::ToExtents;
use bevy::prelude::*;
use bevy::render::RenderApp;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, ViewQuery};
use bevy::render::view::{ViewDepthTexture, ViewTarget};
use lightfall_core::gpu::read_back;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Makes the chain copy what it draws, and holds the last copy. It must be inserted before the
/// first frame.
#[derive(Resource, Clone, Default, ExtractResource)]
pub struct Capture(Arc<Mutex<Option<Copies>>>);

/// Copies of the scene camera's textures, with padded rows.
struct Copies {
    size: UVec2,
    light: Buffer,
    /// `None` where a pixel has several samples.
    depth: Option<Buffer>,
}

/// A picture of linear light.
#[derive(Clone, Debug, PartialEq)]
pub struct Captured {
    /// Width and height, in pixels.
    pub size: UVec2,
    /// Linear light, and the alpha of the picture's shader (zero in the shadow), as the bits of half
    /// floats; rows from the top.
    pub rgba: Vec<[u16; 4]>,
    /// The depth buffer, rows from the top: the near plane's distance over the distance, zero where
    /// there is only traced light. `None` where a pixel has several samples.
    pub depth: Option<Vec<f32>>,
}

impl Capture {
    fn copies(&self) -> MutexGuard<'_, Option<Copies>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The picture that was drawn last.
    ///
    /// # Errors
    /// Nothing has been drawn yet, or the device failed; in one sentence.
    pub fn read(&self, device: &RenderDevice) -> Result<Captured, String> {
        let copies = self.copies();
        let Copies { size, light, depth } = copies.as_ref().ok_or("nothing has been drawn yet")?;
        let rgba = read_rows(device, light, *size, 8)?
            .chunks_exact(8)
            .map(|pixel| [0, 2, 4, 6].map(|at| u16::from_le_bytes([pixel[at], pixel[at + 1]])))
            .collect();
        let depth = depth
            .as_ref()
            .map(|depth| read_rows(device, depth, *size, 4))
            .transpose()?
            .map(|bytes| {
                bytes
                    .chunks_exact(4)
                    .map(|depth| f32::from_le_bytes([depth[0], depth[1], depth[2], depth[3]]))
                    .collect()
            });
        Ok(Captured {
            size: *size,
            rgba,
            depth,
        })
    }
}

/// Length of a padded row of `width` pixels, in bytes.
fn padded_row(width: u32, pixel_bytes: usize) -> usize {
    RenderDevice::align_copy_bytes_per_row(width as usize * pixel_bytes)
}

/// The rows of a copy, without their padding.
fn read_rows(
    device: &RenderDevice,
    copy: &Buffer,
    size: UVec2,
    pixel_bytes: usize,
) -> Result<Vec<u8>, String> {
    let bytes = read_back(device.wgpu_device(), copy).map_err(|error| error.to_string())?;
    let row = size.x as usize * pixel_bytes;
    Ok(bytes
        .chunks(padded_row(size.x, pixel_bytes))
        .flat_map(|line| &line[..row])
        .copied()
        .collect())
}

pub(super) fn plugin(app: &mut App) {
    app.add_plugins(ExtractResourcePlugin::<Capture>::default());
    app.sub_app_mut(RenderApp).add_systems(
        Core3d,
        copy_light_and_depth
            .in_set(Core3dSystems::MainPass)
            .after(accumulate_frame)
            .run_if(resource_exists::<Capture>),
    );
}

fn copy_light_and_depth(
    view: ViewQuery<(&ViewTarget, &ViewDepthTexture), With<SceneCamera>>,
    capture: Res<Capture>,
    mut context: RenderContext,
) {
    let (target, depth) = view.into_inner();
    let size = picture_size(target);
    let samples = depth.texture.sample_count();
    let mut copies = capture.copies();
    if copies
        .as_ref()
        .is_none_or(|copies| copies.size != size || copies.depth.is_some() != (samples == 1))
    {
        let device = context.render_device();
        let buffer = |label, pixel_bytes| {
            let bytes = (padded_row(size.x, pixel_bytes) * size.y as usize) as u64;
            let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
            create_buffer(device, label, bytes, usage)
        };
        let depth = (samples == 1).then(|| buffer("captured depth", 4));
        *copies = Some(Copies {
            size,
            light: buffer("captured light", 8),
            depth,
        });
    }
    let Some(Copies {
        light,
        depth: depths,
        ..
    }) = &*copies
    else {
        return;
    };
    let mut to_buffer = |texture: &Texture, aspect, buffer: &Buffer, pixel_bytes| {
        context.command_encoder().copy_texture_to_buffer(
            TexelCopyTextureInfo {
                aspect,
                ..texture.as_image_copy()
            },
            TexelCopyBufferInfo {
                buffer,
                layout: TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(padded_row(size.x, pixel_bytes) as u32),
                    rows_per_image: None,
                },
            },
            size.to_extents(),
        );
    };
    to_buffer(target.main_texture(), TextureAspect::All, light, 8);
    if let Some(depths) = depths {
        to_buffer(&depth.texture, TextureAspect::DepthOnly, depths, 4);
    }
}
