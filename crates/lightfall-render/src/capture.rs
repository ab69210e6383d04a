//! Copies of the traced light and the depth, taken before bloom and tone mapping, for pictures of
//! linear light. A chain copies them only where there is a [`Capture`].

use crate::accumulate::accumulate_frame;
use crate::camera_markers::SceneCamera;
use crate::drawn_scene::DrawnPart;
use crate::given_light::traces_light;
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
use lightfall_core::scene::Part;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Bytes of a pixel's light: four half floats.
pub const LIGHT_BYTES: usize = 8;

/// Makes the chain copy what it draws, and holds the last copy. It must be inserted before the
/// first frame.
#[derive(Resource, Clone, Default, ExtractResource)]
pub struct Capture(Arc<Mutex<Option<Copies>>>);

/// Copies of the scene camera's textures, with padded rows.
struct Copies {
    /// Size of the scene camera's textures, and the part of them that was asked for.
    target: UVec2,
    part: Part,
    /// The light of the part.
    light: Buffer,
    /// The depth of the whole textures, of which no part can be copied. `None` where a pixel has several
    /// samples.
    depth: Option<Buffer>,
}

/// A picture of linear light, or the part of it that was drawn.
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

impl Captured {
    /// A picture without pixels.
    #[must_use]
    pub fn empty() -> Self {
        Self {
            size: UVec2::ZERO,
            rgba: Vec::new(),
            depth: None,
        }
    }
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
        let copies = copies.as_ref().ok_or("nothing has been drawn yet")?;
        let Part { origin, size } = copies.part;
        let rgba = read_rows(device, &copies.light, size, LIGHT_BYTES)?
            .chunks_exact(LIGHT_BYTES)
            .map(|pixel| [0, 2, 4, 6].map(|at| u16::from_le_bytes([pixel[at], pixel[at + 1]])))
            .collect();
        let depth = copies.depth.as_ref();
        let depth = depth
            .map(|depth| read_rows(device, depth, copies.target, 4))
            .transpose()?;
        let columns = 4 * origin.x as usize..4 * (origin.x + size.x) as usize;
        let depth = depth.map(|bytes| {
            let rows = bytes.chunks_exact(4 * copies.target.x as usize);
            rows.skip(origin.y as usize)
                .take(size.y as usize)
                .flat_map(|row| row[columns.clone()].chunks_exact(4))
                .map(|depth| f32::from_le_bytes([depth[0], depth[1], depth[2], depth[3]]))
                .collect()
        });
        Ok(Captured { size, rgba, depth })
    }
}

/// Length of a padded row of `width` pixels, in bytes.
pub(super) fn padded_row(width: u32, pixel_bytes: usize) -> usize {
    RenderDevice::align_copy_bytes_per_row(width as usize * pixel_bytes)
}

/// Copies a part of a texture to a buffer for padded rows of pixels with so many bytes.
pub(super) fn copy_part(
    encoder: &mut CommandEncoder,
    source: TexelCopyTextureInfo,
    Part { origin, size }: Part,
    (buffer, pixel_bytes): (&Buffer, usize),
) {
    encoder.copy_texture_to_buffer(
        TexelCopyTextureInfo {
            origin: Origin3d {
                x: origin.x,
                y: origin.y,
                z: 0,
            },
            ..source
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
}

/// The rows of a copy, without their padding.
pub(super) fn read_rows(
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
            .run_if(resource_exists::<Capture>.and_then(traces_light)),
    );
}

fn copy_light_and_depth(
    view: ViewQuery<(&ViewTarget, &ViewDepthTexture), With<SceneCamera>>,
    (capture, part): (Res<Capture>, Res<DrawnPart>),
    mut context: RenderContext,
) {
    let (target, depth) = view.into_inner();
    let size = picture_size(target);
    let part = part.in_target(size);
    let samples = depth.texture.sample_count();
    let mut copies = capture.copies();
    if copies.as_ref().is_none_or(|copies| {
        (copies.target, copies.part) != (size, part) || copies.depth.is_some() != (samples == 1)
    }) {
        let device = context.render_device();
        let buffer = |label, size: UVec2, pixel_bytes| {
            let bytes = (padded_row(size.x, pixel_bytes) * size.y as usize) as u64;
            let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
            create_buffer(device, label, bytes, usage)
        };
        let depth = (samples == 1).then(|| buffer("captured depth", size, 4));
        *copies = Some(Copies {
            target: size,
            part,
            light: buffer("captured light", part.size, LIGHT_BYTES),
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
    let encoder = context.command_encoder();
    let source = target.main_texture().as_image_copy();
    copy_part(encoder, source, part, (light, LIGHT_BYTES));
    if let Some(depths) = depths {
        let source = TexelCopyTextureInfo {
            aspect: TextureAspect::DepthOnly,
            ..depth.texture.as_image_copy()
        };
        copy_part(encoder, source, Part::whole(size), (depths, 4));
    }
}
