//! What the eye sees, copied aside before bloom and tone mapping change it: for pictures of linear
//! light. Only a chain that has been given a [`Capture`] copies anything.

use super::SceneCamera;
use bevy::core_pipeline::core_3d::main_transparent_pass_3d;
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::prelude::*;
use bevy::render::RenderApp;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, ViewQuery};
use bevy::render::view::{ViewDepthTexture, ViewTarget};
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Bytes that a row of a texture copy is padded to (WebGPU's COPY_BYTES_PER_ROW_ALIGNMENT).
pub const ROW_ALIGNMENT: usize = 256;

/// Asks a chain to copy aside what it draws, and holds the last copy. It has to be there before the
/// chain's first frame.
#[derive(Resource, Clone, Default, ExtractResource)]
pub struct Capture(Arc<Mutex<Option<Copies>>>);

/// Copies of the eye's textures, with padded rows.
struct Copies {
    size: UVec2,
    light: Buffer,
    /// There is none where a pixel has several samples.
    depth: Option<Buffer>,
}

/// What the eye saw.
#[derive(Clone, Debug, PartialEq)]
pub struct Captured {
    /// Width and height, in pixels.
    pub size: UVec2,
    /// Linear light and opacity, as the bits of half floats; rows from the top.
    pub rgba: Vec<[u16; 4]>,
    /// The depth buffer, rows from the top: nearest distance over distance, zero where only traced
    /// light is. There is none where a pixel has several samples.
    pub depth: Option<Vec<f32>>,
}

impl Capture {
    fn copies(&self) -> MutexGuard<'_, Option<Copies>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What was drawn last.
    ///
    /// # PictureErrors
    /// Nothing has been drawn yet, or the device failed.
    pub fn read(&self, device: &RenderDevice) -> Result<Captured, String> {
        let copies = self.copies();
        let Copies { size, light, depth } = copies.as_ref().ok_or("nothing has been drawn yet")?;
        let half = |bytes: &[u8]| u16::from_le_bytes([bytes[0], bytes[1]]);
        let rgba = rows(device, light, *size, 8)?
            .chunks_exact(8)
            .map(|pixel| {
                [
                    half(pixel),
                    half(&pixel[2..]),
                    half(&pixel[4..]),
                    half(&pixel[6..]),
                ]
            })
            .collect();
        let depth = depth
            .as_ref()
            .map(|depth| rows(device, depth, *size, 4))
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

/// Bytes of a padded row of `width` pixels.
fn padded(width: u32, pixel_bytes: usize) -> usize {
    (width as usize * pixel_bytes).next_multiple_of(ROW_ALIGNMENT)
}

/// The rows of a copy, without what they are padded by.
fn rows(
    device: &RenderDevice,
    copy: &Buffer,
    size: UVec2,
    pixel_bytes: usize,
) -> Result<Vec<u8>, String> {
    let (sender, receiver) = channel();
    copy.slice(..).map_async(MapMode::Read, move |result| {
        // Nobody listens once the device has failed.
        let _ = sender.send(result);
    });
    let waited = device.poll(PollType::Wait {
        submission_index: None,
        timeout: None,
    });
    waited.map_err(|error| error.to_string())?;
    receiver
        .recv()
        .map_err(|error| error.to_string())?
        .map_err(|error| error.to_string())?;
    let bytes = copy.slice(..).get_mapped_range();
    let row = size.x as usize * pixel_bytes;
    let rows = bytes
        .chunks(padded(size.x, pixel_bytes))
        .flat_map(|line| &line[..row])
        .copied()
        .collect();
    drop(bytes);
    copy.unmap();
    Ok(rows)
}

pub(super) fn plugin(app: &mut App) {
    app.add_plugins(ExtractResourcePlugin::<Capture>::default());
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app.add_systems(
        Core3d,
        copy.in_set(Core3dSystems::MainPass)
            .after(main_transparent_pass_3d)
            .run_if(resource_exists::<Capture>),
    );
}

fn copy(
    view: ViewQuery<(&ViewTarget, &ViewDepthTexture), With<SceneCamera>>,
    capture: Res<Capture>,
    mut context: RenderContext,
) {
    let (target, depth) = view.into_inner();
    let size = UVec2::new(
        target.main_texture().width(),
        target.main_texture().height(),
    );
    let samples = depth.texture.sample_count();
    let mut copies = capture.copies();
    if copies
        .as_ref()
        .is_none_or(|copies| copies.size != size || copies.depth.is_some() != (samples == 1))
    {
        let device = context.render_device();
        let buffer = |label, pixel_bytes| {
            device.create_buffer(&BufferDescriptor {
                label: Some(label),
                size: (padded(size.x, pixel_bytes) * size.y as usize) as u64,
                usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
                mapped_at_creation: false,
            })
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
                texture,
                mip_level: 0,
                origin: Origin3d::ZERO,
                aspect,
            },
            TexelCopyBufferInfo {
                buffer,
                layout: TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(padded(size.x, pixel_bytes) as u32),
                    rows_per_image: None,
                },
            },
            Extent3d {
                width: size.x,
                height: size.y,
                depth_or_array_layers: 1,
            },
        );
    };
    to_buffer(target.main_texture(), TextureAspect::All, light, 8);
    if let Some(depths) = depths {
        to_buffer(&depth.texture, TextureAspect::DepthOnly, depths, 4);
    }
}
