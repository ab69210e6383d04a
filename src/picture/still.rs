//! One picture of a scene, by the very chain of the window, with no window.

use super::PictureError;
use crate::gpu::GpuScene;
use crate::render::{AlwaysDraw, AwaitErrors, CurrentScene, LightfallRenderPlugin, is_drawn, render_plugin};
use crate::scene::{LONGEST_SIDE, Scene};
use bevy::app::PluginsState;
use bevy::asset::RenderAssetUsages;
use bevy::camera::RenderTarget;
use bevy::diagnostic::DiagnosticsStore;
use bevy::log::LogPlugin;
use bevy::prelude::*;
use bevy::render::diagnostic::RenderDiagnosticsPlugin;
use bevy::render::gpu_readback::{Readback, ReadbackComplete};
use bevy::render::pipelined_rendering::PipelinedRenderingPlugin;
use bevy::render::render_resource::{PollType, TextureFormat, TextureUsages};
use bevy::render::renderer::RenderDevice;
use bevy::window::ExitCondition;
use bevy::winit::WinitPlugin;
use std::collections::BTreeMap;
use std::time::Instant;

/// A finished picture.
pub struct Still {
    /// Width, in pixels.
    pub width: u32,
    /// Height, in pixels.
    pub height: u32,
    /// 8-bit sRGB, rows from the top, three bytes a pixel.
    pub rgb: Vec<u8>,
}

/// GPU time of one pass.
#[derive(Clone, Debug, PartialEq)]
pub struct PassTime {
    /// Name of the pass.
    pub pass: String,
    /// Median over the timed frames, in milliseconds.
    pub median_ms: f64,
    /// The same over frames in which nothing changed; zero where the pass did not run in them.
    pub kept_ms: f64,
}

/// Frames after which a picture that still isn't there is given up; compiling every pipeline takes a handful.
const MOST_UPDATES: usize = 600;

/// Bytes that a row of a texture copy is padded to (WebGPU's COPY_BYTES_PER_ROW_ALIGNMENT).
const ROW_ALIGNMENT: usize = 256;

/// The chain without a window, drawing one scene after another at one output size.
pub struct Studio {
    app: App,
    size: UVec2,
}

impl Studio {
    /// Draws a first scene; later ones come from the same device and its compiled passes.
    ///
    /// # Errors
    /// A size the device can't do, or a chain that failed.
    pub fn open(scene: &Scene, size: UVec2) -> Result<Self, PictureError> {
        let mut studio = Self { app: headless(scene, size, true)?, size };
        studio.settle()?;
        Ok(studio)
    }

    /// Shows a scene from the next frame on.
    pub fn show(&mut self, scene: &Scene) {
        self.app.world_mut().resource_mut::<CurrentScene>().0 = scene.clone();
    }

    /// Draws frames until the scene is drawn whole.
    ///
    /// # Errors
    /// A chain that failed.
    pub fn settle(&mut self) -> Result<(), PictureError> {
        warm_up(&mut self.app)
    }

    /// The picture of the next frame.
    ///
    /// # Errors
    /// A chain that failed.
    pub fn picture(&mut self) -> Result<Still, PictureError> {
        read_back(&mut self.app, self.size)
    }

    /// Draws the scene `frames` more times to tell each pass's GPU time, and as many frames in which nothing changes. A
    /// device without timestamps gives an empty list.
    ///
    /// # Errors
    /// A chain that failed.
    pub fn time(&mut self, frames: usize) -> Result<Vec<PassTime>, PictureError> {
        self.app.world_mut().resource_mut::<AlwaysDraw>().0 = true;
        let drawn = medians(&mut self.app, frames)?;
        self.app.world_mut().resource_mut::<AlwaysDraw>().0 = false;
        let kept = medians(&mut self.app, frames)?;
        let times = drawn.into_iter().map(|(pass, median_ms)| {
            let kept_ms = kept.get(&pass).copied().unwrap_or_default();
            PassTime { pass, median_ms, kept_ms }
        });
        Ok(times.collect())
    }
}

/// Draws one picture of the scene at the given output size. The same scene and size give the same bytes.
///
/// # Errors
/// A size the device can't do, or a chain that failed.
pub fn render(scene: &Scene, size: UVec2) -> Result<Still, PictureError> {
    let mut app = headless(scene, size, false)?;
    warm_up(&mut app)?;
    read_back(&mut app, size)
}

/// Like [`render`], with the GPU time of each pass, see [`Studio::time`].
///
/// # Errors
/// As [`render`].
pub fn render_timed(scene: &Scene, size: UVec2, frames: usize) -> Result<(Still, Vec<PassTime>), PictureError> {
    let mut studio = Studio::open(scene, size)?;
    Ok((studio.picture()?, studio.time(frames)?))
}

/// Frames until what the device measured has arrived.
const LATEST_MEASUREMENT: usize = 6;

/// Median GPU time of each pass that runs in the next frames, in milliseconds.
fn medians(app: &mut App, frames: usize) -> Result<BTreeMap<String, f64>, PictureError> {
    for _ in 0..LATEST_MEASUREMENT {
        update(app)?;
    }
    let mut samples: BTreeMap<String, Vec<f64>> = default();
    for _ in 0..frames {
        let begin = Instant::now();
        update(app)?;
        for diagnostic in app.world().resource::<DiagnosticsStore>().iter() {
            let path = diagnostic.path().as_str();
            let pass = path.strip_prefix("render/").and_then(|path| path.strip_suffix("/elapsed_gpu"));
            // What a pass took when it last ran stays there.
            let fresh = diagnostic.measurement().filter(|measurement| measurement.time >= begin);
            if let (Some(pass), Some(measurement)) = (pass, fresh) {
                samples.entry(pass.into()).or_default().push(measurement.value);
            }
        }
    }
    let median = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    Ok(samples.into_iter().map(|(pass, values)| (pass, median(values))).collect())
}

#[derive(Resource)]
struct Output(Handle<Image>);

#[derive(Resource, Default)]
struct Finished(Option<Vec<u8>>);

fn headless(scene: &Scene, size: UVec2, timed: bool) -> Result<App, PictureError> {
    let mut app = App::new();
    app.add_plugins(
        DefaultPlugins
            .set(WindowPlugin { primary_window: None, exit_condition: ExitCondition::DontExit, ..default() })
            .set(render_plugin(true))
            .build()
            .disable::<LogPlugin>()
            .disable::<WinitPlugin>()
            .disable::<PipelinedRenderingPlugin>(),
    );
    // A process has one log, however many pictures it draws.
    static LOG: std::sync::Once = std::sync::Once::new();
    LOG.call_once(|| {
        app.add_plugins(quiet_log());
    });
    if timed {
        app.add_plugins(RenderDiagnosticsPlugin);
    }
    while app.plugins_state() == PluginsState::Adding {
        bevy::tasks::tick_global_task_pools_on_main_thread();
    }
    check_size("size", size)?;
    let picture = UVec2::new(scene.picture.width, scene.picture.height);
    check_size("picture", picture)?;
    GpuScene::new(scene, picture).map_err(|error| PictureError::Draw(error.to_string()))?;
    let mut image = Image::new_target_texture(size.x, size.y, TextureFormat::Rgba8UnormSrgb, None);
    image.asset_usage = RenderAssetUsages::RENDER_WORLD;
    image.texture_descriptor.usage |= TextureUsages::COPY_SRC;
    let output = app.world_mut().resource_mut::<Assets<Image>>().add(image);
    app.insert_resource(Output(output.clone()))
        .init_resource::<Finished>()
        .insert_resource(AwaitErrors(true))
        .add_plugins(LightfallRenderPlugin { scene: scene.clone(), target: RenderTarget::Image(output.into()) });
    app.finish();
    app.cleanup();
    Ok(app)
}

/// Checks that a device can draw a picture of this size; `field` names it in the error.
///
/// # Errors
/// A side of zero, or longer than every device that the passes run on can do.
pub fn check_size(field: &'static str, size: UVec2) -> Result<(), PictureError> {
    let limit = LONGEST_SIDE;
    if size.min_element() == 0 || size.max_element() > limit {
        return Err(PictureError::Size { field, width: size.x, height: size.y, limit });
    }
    Ok(())
}

/// Warnings and errors only, on the standard error stream, unless RUST_LOG says otherwise.
pub(crate) fn quiet_log() -> LogPlugin {
    LogPlugin { filter: "error,lightfall=warn".into(), level: bevy::log::Level::WARN, ..default() }
}

fn update(app: &mut App) -> Result<(), PictureError> {
    app.update();
    if let Some(exit) = app.should_exit()
        && exit.is_error()
    {
        return Err(PictureError::Draw("the graphics device reported an error".into()));
    }
    if let Some(device) = app.world().get_resource::<RenderDevice>() {
        let waited = device.poll(PollType::Wait { submission_index: None, timeout: None });
        waited.map_err(|error| PictureError::Draw(error.to_string()))?;
    }
    Ok(())
}

/// Updates until the scene is drawn, so that the picture is complete the first time it is taken.
fn warm_up(app: &mut App) -> Result<(), PictureError> {
    for _ in 0..MOST_UPDATES {
        update(app)?;
        if is_drawn(app).map_err(PictureError::Draw)? {
            return Ok(());
        }
    }
    Err(PictureError::Draw("its passes did not become ready".into()))
}

fn read_back(app: &mut App, size: UVec2) -> Result<Still, PictureError> {
    let output = app.world().resource::<Output>().0.clone();
    let reader = app
        .world_mut()
        .spawn(Readback::texture(output))
        .observe(|complete: On<ReadbackComplete>, mut finished: ResMut<Finished>| {
            finished.0 = Some(complete.data.clone());
        })
        .id();
    for _ in 0..MOST_UPDATES {
        update(app)?;
        if let Some(bytes) = app.world_mut().resource_mut::<Finished>().0.take() {
            app.world_mut().despawn(reader);
            return Ok(still(size, &bytes));
        }
    }
    Err(PictureError::Draw("it did not arrive from the graphics device".into()))
}

/// Drops the padding of rows and the alpha channel.
fn still(size: UVec2, bytes: &[u8]) -> Still {
    let row = size.x as usize * 4;
    let padded = if bytes.len() == row * size.y as usize { row } else { row.next_multiple_of(ROW_ALIGNMENT) };
    let rgb = bytes
        .chunks(padded)
        .take(size.y as usize)
        .flat_map(|line| line[..row].chunks_exact(4))
        .flat_map(|pixel| [pixel[0], pixel[1], pixel[2]])
        .collect();
    Still { width: size.x, height: size.y, rgb }
}
