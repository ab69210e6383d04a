//! The pass that gives the developed picture the levels of a file, and the copy of them. It runs only
//! where there are [`Prints`].

use crate::bloom::BloomPass;
use crate::camera_markers::SceneCamera;
use crate::capture::{copy_part, padded_row, read_rows};
use crate::develop::{develop, waits_for_bloom};
use crate::drawn_scene::{DrawnPart, DrawnScene};
use crate::full_screen_pass::{FullScreenPass, Stage, attachment};
use crate::graphics::{Graphics, create_buffer, picture_size};
use crate::live_shaders::add_shader;
use bevy::asset::uuid_handle;
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::image::ToExtents;
use bevy::prelude::*;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, ViewQuery};
use bevy::render::view::ViewTarget;
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use lightfall_core::gpu::Print;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

const SHADER: Handle<Shader> = uuid_handle!("d0c3f1b6-7b5e-4d92-8a40-2f6e9c5b1e73");

/// Format of the levels, and the size of a pixel in bytes.
const FORMAT: TextureFormat = TextureFormat::Rgba16Uint;
const PIXEL_BYTES: usize = 8;

const STAGE: Stage = ("print", [Some(FORMAT), None]);

/// Makes the chain give its picture the levels of a file, and holds the last ones. It must be inserted
/// before the first frame.
#[derive(Resource, Clone, ExtractResource)]
pub struct Prints {
    /// The highest level.
    top: u16,
    copy: Arc<Mutex<Option<Copied>>>,
}

/// The levels of the part of the picture that was drawn, with padded rows.
struct Copied {
    size: UVec2,
    buffer: Buffer,
}

/// A picture in the levels of a file, or the part of it that was drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Printed {
    /// Width and height, in pixels.
    pub size: UVec2,
    /// Red, green and blue, in sRGB; rows from the top.
    pub rgb: Vec<u16>,
}

impl Prints {
    /// Levels from zero to `top`.
    #[must_use]
    pub fn to(top: u16) -> Self {
        Self {
            top,
            copy: Arc::default(),
        }
    }

    fn copy(&self) -> MutexGuard<'_, Option<Copied>> {
        self.copy.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The picture that was drawn last.
    ///
    /// # Errors
    /// Nothing has been drawn yet, or the device failed; in one sentence.
    pub fn read(&self, device: &RenderDevice) -> Result<Printed, String> {
        let copy = self.copy();
        let Copied { size, buffer } = copy.as_ref().ok_or("nothing has been drawn yet")?;
        let rgb = read_rows(device, buffer, *size, PIXEL_BYTES)?
            .chunks_exact(PIXEL_BYTES)
            .flat_map(|pixel| [0, 2, 4].map(|at| u16::from_le_bytes([pixel[at], pixel[at + 1]])))
            .collect();
        Ok(Printed { size: *size, rgb })
    }
}

#[derive(Resource)]
struct PrintPass {
    full_screen: FullScreenPass<Print>,
    levels: Option<(UVec2, Texture, TextureView)>,
}

pub(super) fn plugin(app: &mut App) {
    add_shader(app, &SHADER, Print::shader(), "lightfall/print.wgsl");
    app.add_plugins(ExtractResourcePlugin::<Prints>::default());
    app.sub_app_mut(RenderApp)
        .add_systems(RenderStartup, create_print_pass)
        .add_systems(
            Render,
            prepare_print_pass
                .in_set(RenderSystems::PrepareBindGroups)
                .run_if(resource_exists::<Prints>),
        )
        .add_systems(
            Core3d,
            print_picture
                .in_set(Core3dSystems::PostProcess)
                .after(develop)
                .run_if(resource_exists::<Prints>.and_then(not(waits_for_bloom))),
        );
}

fn create_print_pass(mut commands: Commands) {
    commands.insert_resource(PrintPass {
        full_screen: FullScreenPass::new("print layout", SHADER, 1),
        levels: None,
    });
}

/// Writes the uniform and creates the texture of the levels.
fn prepare_print_pass(
    (scene, part, prints): (Res<DrawnScene>, Res<DrawnPart>, Res<Prints>),
    (If(bloom), If(mut pass)): (If<Res<BloomPass>>, If<ResMut<PrintPass>>),
    graphics: Graphics,
) {
    let PrintPass {
        full_screen,
        levels,
    } = &mut *pass;
    full_screen.queue(STAGE, &graphics.cache);
    let drawn = part.drawn();
    let numbers = Print {
        origin: part.first_pixel(),
        top: prints.top.into(),
        bloom: bloom.is_on().into(),
    };
    full_screen.write(numbers, &graphics);
    let size = drawn.map_or(scene.picture.size(), |part| part.size);
    if levels.as_ref().is_none_or(|(known, ..)| *known != size) {
        let texture = graphics.device.create_texture(&TextureDescriptor {
            label: Some("levels of a file"),
            size: size.to_extents(),
            mip_level_count: 1,
            sample_count: 1,
            dimension: TextureDimension::D2,
            format: FORMAT,
            usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = texture.create_view(&default());
        *levels = Some((size, texture, view));
    }
}

/// Draws the levels and copies them.
fn print_picture(
    view: ViewQuery<&ViewTarget, With<SceneCamera>>,
    (part, prints): (Res<DrawnPart>, Res<Prints>),
    If(pass): If<Res<PrintPass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let target = view.into_inner();
    let drawn = picture_size(target);
    let Some((size, texture, levels)) = &pass.levels else {
        return;
    };
    let is_drawn = *size == drawn
        && pass.full_screen.draw(
            &mut context,
            &cache,
            STAGE,
            &[target.main_texture_view()],
            &[attachment(levels)],
        );
    if !is_drawn {
        return;
    }
    let part = part.in_target(drawn);
    let size = part.size;
    let mut copy = prints.copy();
    if copy.as_ref().is_none_or(|copy| copy.size != size) {
        let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
        let bytes = padded_row(size.x, PIXEL_BYTES) as u64 * u64::from(size.y);
        let buffer = create_buffer(context.render_device(), "copied levels", bytes, usage);
        *copy = Some(Copied { size, buffer });
    }
    let Some(Copied { buffer, .. }) = &*copy else {
        return;
    };
    let source = texture.as_image_copy();
    copy_part(
        context.command_encoder(),
        source,
        part,
        (buffer, PIXEL_BYTES),
    );
}
