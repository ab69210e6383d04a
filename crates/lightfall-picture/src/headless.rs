//! The chain of passes as a Bevy app without a window.

use super::{PictureError, Studio};
use bevy::app::PluginsState;
use bevy::asset::RenderAssetUsages;
use bevy::camera::RenderTarget;
use bevy::log::LogPlugin;
use bevy::prelude::*;
use bevy::render::diagnostic::RenderDiagnosticsPlugin;
use bevy::render::error_handler::{ErrorType, RenderError, RenderErrorHandler, RenderErrorPolicy};
use bevy::render::pipelined_rendering::PipelinedRenderingPlugin;
use bevy::render::render_resource::{PollType, TextureFormat, TextureUsages};
use bevy::render::renderer::RenderDevice;
use bevy::window::ExitCondition;
use bevy::winit::WinitPlugin;
use lightfall_core::gpu::{Drawable, driver_advice};
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::scene::{Frame, MAX_PICTURE_SIDE, Part, Scene};
use lightfall_platform::log::quiet_log;
use lightfall_platform::termination;
use lightfall_render::{
    AwaitErrorMap, Capture, CurrentFrame, LightfallRenderPlugin, Prints, Progress, RestingFrames,
    StarCatalogue, is_drawn, render_plugin,
};
use std::env::consts::OS;

/// Maximum number of frames to wait for a picture, or for the next frame of one that is a mean. Compiling every pipeline takes a few frames.
pub(super) const MAX_UPDATES: usize = 600;

/// Bevy's exit status after Ctrl+C.
const INTERRUPTED: u8 = 130;

/// What a [`Studio`] does in addition to drawing.
#[derive(Clone, Copy, Debug)]
pub struct HeadlessOptions {
    /// Measure the GPU time of each pass.
    pub timed: bool,
    /// Keep the linear light and the depth of each picture.
    pub light: bool,
    /// Draw pictures as a window on a software renderer does while something moves.
    pub moving: bool,
    /// Make the levels of a file, of which this is the highest.
    pub levels: Option<u16>,
    /// Draw this part of the first scene's picture; `None` for all of it.
    pub part: Option<Part>,
    /// Draw these stars.
    pub stars: &'static Catalogue,
}

impl Default for HeadlessOptions {
    fn default() -> Self {
        Self {
            timed: false,
            light: false,
            moving: false,
            levels: None,
            part: None,
            stars: Catalogue::built_in(),
        }
    }
}

/// An app that is ready to draw a first scene, and its output of `size` pixels.
///
/// # Errors
/// The size is too large, or the scene cannot be drawn.
pub(super) fn headless(
    scene: &Scene,
    size: UVec2,
    options: HeadlessOptions,
) -> Result<(App, Handle<Image>), PictureError> {
    let mut app = App::new();
    app.add_plugins(
        DefaultPlugins
            .set(WindowPlugin {
                primary_window: None,
                exit_condition: ExitCondition::DontExit,
                ..default()
            })
            .set(render_plugin(true))
            .build()
            .disable::<LogPlugin>()
            .disable::<WinitPlugin>()
            .disable::<PipelinedRenderingPlugin>(),
    );
    // A process has only one log, and the window program may have begun it.
    static LOG: std::sync::Once = std::sync::Once::new();
    LOG.call_once(|| {
        if !bevy::log::tracing::dispatcher::has_been_set() {
            app.add_plugins(quiet_log());
        }
    });
    if options.timed {
        app.add_plugins(RenderDiagnosticsPlugin);
    }
    while app.plugins_state() == PluginsState::Adding {
        bevy::tasks::tick_global_task_pools_on_main_thread();
    }
    check_size("size", size)?;
    let picture = scene.picture.size();
    check_size("picture", options.part.map_or(picture, |part| part.size))?;
    let scene = drawable(scene)?;
    let mut image = Image::new_target_texture(size.x, size.y, TextureFormat::Rgba8UnormSrgb, None);
    image.asset_usage = RenderAssetUsages::RENDER_WORLD;
    image.texture_descriptor.usage |= TextureUsages::COPY_SRC;
    let output = app.world_mut().resource_mut::<Assets<Image>>().add(image);
    if options.light {
        app.init_resource::<Capture>();
    }
    app.insert_resource(AwaitErrorMap(true))
        .insert_resource(RenderErrorHandler(end_with_fault));
    if let Some(top) = options.levels {
        app.insert_resource(Prints::to(top));
    }
    let frame = Frame::of(&scene).with_part(options.part);
    app.insert_resource(StarCatalogue(options.stars))
        .add_plugins(LightfallRenderPlugin {
            scene,
            target: RenderTarget::Image(output.clone().into()),
        })
        .insert_resource(CurrentFrame(frame));
    if options.moving {
        app.insert_resource(RestingFrames::in_motion());
    }
    app.finish();
    app.cleanup();
    Ok((app, output))
}

/// The checked scene, with the exposure that its light meter chooses where it is automatic.
///
/// # Errors
/// The scene cannot be drawn.
pub(super) fn drawable(scene: &Scene) -> Result<Drawable, PictureError> {
    Drawable::new(scene.clone())
        .map(Drawable::exposed)
        .map_err(|reason| PictureError::Draw(reason.to_string()))
}

/// Checks that a picture of this size can be drawn. `field` names the size in the error.
///
/// # Errors
/// A side is zero, or longer than the passes can draw on every device.
pub fn check_size(field: &'static str, size: UVec2) -> Result<(), PictureError> {
    if size.min_element() == 0 || size.max_element() > MAX_PICTURE_SIDE {
        return Err(PictureError::Size { field, size });
    }
    Ok(())
}

/// Why the device draws no more, if it may draw again later.
#[derive(Resource)]
struct PassingFault(&'static str);

/// Ends the app after an error of the device, and notes whether another attempt may succeed.
fn end_with_fault(error: &RenderError, main: &mut World, _: &mut World) -> RenderErrorPolicy {
    let fault = match error.ty {
        ErrorType::DeviceLost => Some("the graphics device was lost"),
        ErrorType::OutOfMemory => Some("the graphics device has too little free memory"),
        ErrorType::Validation | ErrorType::Internal => None,
    };
    if let Some(fault) = fault {
        main.insert_resource(PassingFault(fault));
    }
    main.write_message(AppExit::error());
    RenderErrorPolicy::StopRendering
}

/// Checks that nothing has asked the program to end.
pub(super) fn check_not_asked_to_end() -> Result<(), PictureError> {
    if termination::is_asked() {
        return Err(PictureError::Terminated);
    }
    Ok(())
}

impl Studio {
    /// Draws a frame and waits until the device is done.
    pub(super) fn update(&mut self) -> Result<(), PictureError> {
        check_not_asked_to_end()?;
        self.app.update();
        match self.app.should_exit() {
            None | Some(AppExit::Success) => {}
            Some(AppExit::Error(code)) if code.get() == INTERRUPTED => {
                return Err(PictureError::Interrupted);
            }
            Some(AppExit::Error(_)) => {
                if let Some(PassingFault(fault)) = self.app.world().get_resource::<PassingFault>() {
                    return Err(PictureError::Device((*fault).into()));
                }
                return Err(PictureError::Draw(format!(
                    "the graphics device reported an error, which the log names: {}, or choose another adapter with --gpu",
                    driver_advice::with_old_driver(OS)
                )));
            }
        }
        if let Some(device) = self.app.world().get_resource::<RenderDevice>() {
            let waited = device.poll(PollType::Wait {
                submission_index: None,
                timeout: None,
            });
            waited.map_err(|error| PictureError::Draw(error.to_string()))?;
        }
        Ok(())
    }

    /// Draws frames until the scene is completely drawn.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn settle(&mut self) -> Result<(), PictureError> {
        let (mut waited, mut progress) = (0, Progress::default());
        while waited < MAX_UPDATES {
            self.update()?;
            if is_drawn(&self.app).map_err(PictureError::Draw)? {
                return Ok(());
            }
            // Every frame of a mean may take as long as a picture of one.
            let now = *self.app.world().resource::<Progress>();
            waited = if now == progress { waited + 1 } else { 0 };
            progress = now;
        }
        Err(PictureError::Draw("its passes did not become ready".into()))
    }
}
