//! The passes that turn a [`Scene`] into pixels. The window, stills and tests all run this very
//! chain.
//!
//! ```text
//! eye camera (Core3d, HDR picture size, Rgba16Float, no output of its own; kept.rs: at rest while nothing changes)
//!   probe.rs         main_opaque_pass_3d     the foreground craft, with depth
//!   geodesic.rs      GEODESIC                traced light where depth is zero (errors.rs: what the view `error` shows)
//!                    main_transparent_pass_3d
//!   capture.rs       (copy)                  light and depth aside, for a picture of linear light only
//!   eye.rs           bloom -> tonemapping    Bevy's own
//! screen camera (Core2d, window or still)
//!   presentation.rs  PIXELATE                area reduction, quantization, Bayer pattern
//!                    EXPAND                  nearest expansion, letterbox (or FIT, when bypassed)
//!                    egui, output            Bevy's own
//! ```

mod capture;
mod chain;
mod errors;
mod eye;
mod geodesic;
mod kept;
mod needs;
mod presentation;
mod probe;
pub mod recovery;

pub use capture::{Capture, Captured, ROW_ALIGNMENT};
pub use chain::{Chain, EMPTY_PASSES, Written};
pub use errors::AwaitErrors;
pub use eye::{Eye, NEAR, Screen};
pub use kept::{AlwaysDraw, Sight};
pub use needs::needs;
pub use presentation::{Letterbox, letterbox};

use crate::scene::Scene;
use bevy::camera::RenderTarget;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::settings::WgpuSettings;

/// The scene that is being drawn. It must have passed [`Scene::check`]; what writes it, checks it.
#[derive(Resource, Clone, Deref, DerefMut, ExtractResource)]
pub struct CurrentScene(pub Scene);

/// The whole chain, drawing [`CurrentScene`] to a window or an image.
pub struct LightfallRenderPlugin {
    /// What is drawn first.
    pub scene: Scene,
    /// Where the last pass writes.
    pub target: RenderTarget,
}

impl Plugin for LightfallRenderPlugin {
    fn build(&self, app: &mut App) {
        app.insert_resource(CurrentScene(self.scene.clone()))
            .insert_resource(ClearColor(Color::BLACK))
            .add_plugins(ExtractResourcePlugin::<CurrentScene>::default())
            .add_plugins((
                eye::EyePlugin {
                    target: self.target.clone(),
                },
                probe::plugin,
            ))
            .add_plugins((
                geodesic::plugin,
                errors::plugin,
                capture::plugin,
                kept::plugin,
                presentation::plugin,
            ));
    }
}

/// Bevy's renderer on the same backends as [`Gpu::headless`](crate::gpu::Gpu::headless). A still
/// waits for its pipelines, a window does not.
pub fn render_plugin(synchronous_pipeline_compilation: bool) -> RenderPlugin {
    RenderPlugin {
        render_creation: wgpu_settings().into(),
        synchronous_pipeline_compilation,
        ..default()
    }
}

fn wgpu_settings() -> WgpuSettings {
    let (backends, adapter_name) = crate::gpu::chosen();
    WgpuSettings {
        backends: Some(backends),
        adapter_name,
        ..default()
    }
}

/// Whether the whole of the present scene has been drawn, asked after an update. An error names
/// what failed.
///
/// # Errors
/// A pipeline that could not be made: a shader error, or a limit of the device. Errors that could
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
    let (Some(scene), Some(work), Some(sight)) = (
        world.get_resource::<CurrentScene>(),
        world.get_resource::<errors::Work>(),
        world.get_resource::<Sight>(),
    ) else {
        return Ok(false);
    };
    Ok(work.is_done(scene)? && sight.is_drawn())
}
