//! The passes that turn a [`Scene`] into pixels. The window, stills and tests all run this very
//! chain.
//!
//! ```text
//! eye camera (Core3d, HDR picture size, Rgba16Float, no output of its own; redraw.rs: at rest while nothing changes)
//!   probe.rs         main_opaque_pass_3d     the foreground craft, with depth
//!   geodesic.rs      GEODESIC                traced light where depth is zero (error_map.rs: what the view `error` shows)
//!                    main_transparent_pass_3d
//!   capture.rs       (copy)                  light and depth aside, for a picture of linear light only
//!   scene_camera.rs           bloom -> tonemapping    Bevy's own
//! screen camera (Core2d, window or still)
//!   presentation.rs  PIXELATE                area reduction, quantization, Bayer pattern
//!                    EXPAND                  nearest expansion, letterbox (or FIT, when bypassed)
//!                    egui, output            Bevy's own
//! ```

mod capture;
mod chain;
mod cost_report;
mod error_map;
mod geodesic;
mod presentation;
mod probe;
pub mod recovery;
mod redraw;
mod scene_camera;

pub use capture::{Capture, Captured, ROW_ALIGNMENT};
pub use chain::{Chain, EMPTY_PASSES, Written};
pub use cost_report::cost_report;
pub use error_map::AwaitErrors;
pub use presentation::{Letterbox, letterbox};
pub use redraw::{AlwaysDraw, DrawRequest};
pub use scene_camera::{NEAR, SceneCamera, Screen};

use bevy::camera::RenderTarget;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::settings::WgpuSettings;
use lightfall_core::gpu::Drawable;

/// The scene that is being drawn.
#[derive(Resource, Clone, Deref, ExtractResource)]
pub struct CurrentScene(pub Drawable);

/// The whole chain, drawing [`CurrentScene`] to a window or an image.
pub struct LightfallRenderPlugin {
    /// What is drawn first.
    pub scene: Drawable,
    /// Where the last pass writes.
    pub target: RenderTarget,
}

impl Plugin for LightfallRenderPlugin {
    fn build(&self, app: &mut App) {
        app.insert_resource(CurrentScene(self.scene.clone()))
            .insert_resource(ClearColor(Color::BLACK))
            .add_plugins(ExtractResourcePlugin::<CurrentScene>::default())
            .add_plugins((
                scene_camera::SceneCameraPlugin {
                    target: self.target.clone(),
                },
                probe::plugin,
            ))
            .add_plugins((
                geodesic::plugin,
                error_map::plugin,
                capture::plugin,
                redraw::plugin,
                presentation::plugin,
            ));
    }
}

/// Bevy's renderer on the same backends as [`Gpu::headless`](lightfall_core::gpu::Gpu::headless). A still
/// waits for its pipelines, a window does not.
pub fn render_plugin(synchronous_pipeline_compilation: bool) -> RenderPlugin {
    RenderPlugin {
        render_creation: wgpu_settings().into(),
        synchronous_pipeline_compilation,
        ..default()
    }
}

fn wgpu_settings() -> WgpuSettings {
    let (backends, adapter_name) = lightfall_core::gpu::chosen();
    WgpuSettings {
        backends: Some(backends),
        adapter_name,
        ..default()
    }
}

/// Whether the whole of the present scene has been drawn, asked after an update. An error names
/// what failed.
///
/// # PictureErrors
/// A pipeline that could not be made: a shader error, or a limit of the device. PictureErrors that could
/// not be worked out.
pub fn is_drawn(app: &App) -> Result<bool, String> {
    use bevy::render::{
        RenderApp, render_resource::CachedPipelineState, render_resource::PipelineCache,
    };
    let Some(cache) = app
        .get_sub_app(RenderApp)
        .and_then(|render| render.world().get_resource::<PipelineCache>())
    else {
        return Ok(false);
    };
    for pipeline in cache.pipelines() {
        if let CachedPipelineState::Err(error) = &pipeline.state
            && !matches!(error, bevy::shader::ShaderCacheError::ShaderNotLoaded(_))
        {
            return Err(format!("a render pipeline could not be made: {error}"));
        }
    }
    let world = app.world();
    let (Some(scene), Some(work), Some(request)) = (
        world.get_resource::<CurrentScene>(),
        world.get_resource::<error_map::Work>(),
        world.get_resource::<DrawRequest>(),
    ) else {
        return Ok(false);
    };
    Ok(work.is_done(scene)? && request.is_drawn())
}
