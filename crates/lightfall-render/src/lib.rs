//! The passes that turn a [`Scene`](lightfall_core::scene::Scene) into pixels. The window, stills
//! and tests all run this chain.
//!
//! ```text
//! scene camera (Core3d, picture size, Rgba16Float, no output; redraw.rs: idle unless changed)
//!   probe.rs         main_opaque_pass_3d     the foreground craft, with depth
//!   geodesic.rs      GEODESIC                traced light where the depth is zero
//!   comparison.rs    (DIFFERENCE)            two scenes' light, only while they are compared so
//!                    main_transparent_pass_3d
//!   refine.rs        (EDGES -> REFINE)       more rays where edges pass, unless switched off
//!   accumulate.rs    (ACCUMULATE)            the mean of several frames, where it is asked for
//!   capture.rs       (copy)                  light and depth, only for pictures of linear light
//!   bloom.rs         bloom                   blurred light, where the scene has bloom
//!   develop.rs       DEVELOP                 bloom, exposure and tone curve
//! screen camera (Core2d, window or still)
//!   presentation.rs  PIXELATE                area reduction, quantization, Bayer pattern
//!                    EXPAND                  nearest expansion, letterbox (or FIT, when bypassed)
//!                    egui, output            Bevy's own
//! ```
//!
//! error_map.rs computes what the view `error` shows, on a background thread.

mod accumulate;
mod antialias;
mod bloom;
mod camera_markers;
mod capture;
mod chain;
mod comparison;
mod cost_report;
mod detail_limits;
mod develop;
mod device;
mod draw_request;
mod drawn_layers;
mod drawn_scene;
mod error_map;
mod full_screen_pass;
mod geodesic;
mod given_light;
mod graphics;
mod live_shaders;
mod pass_shaders;
mod presentation;
mod print;
mod probe;
mod progress;
pub mod recovery;
mod redraw;
mod refine;
mod resting_frames;
mod scene_camera;
mod shader_reload;
mod stars;

pub use camera_markers::{SceneCamera, ScreenCamera};
pub use capture::{Capture, Captured, LIGHT_BYTES};
pub use chain::{Chain, EMPTY_PASSES, WrittenTexture};
pub use comparison::{
    ComparedScene, Comparison, ComparisonLayout, ComparisonMode, Pinned, TwoScenes,
};
pub use cost_report::{cost_report, cost_rows};
pub use detail_limits::DetailLimits;
pub use device::render_plugin;
pub use draw_request::AlwaysDraw;
pub use drawn_layers::DrawnLayers;
pub use drawn_scene::{CurrentFrame, CurrentScene, DrawnScene, FrameScene, draw_scene_in_frame};
pub use error_map::AwaitErrorMap;
pub use given_light::GivenLight;
pub use live_shaders::{LiveShaders, ShaderNews};
pub use pass_shaders::{PassShader, pass_shaders};
pub use presentation::{Letterbox, PictureArea, RestingSizes, letterbox};
pub use print::{Printed, Prints};
pub use progress::Progress;
pub use redraw::is_drawn;
pub use resting_frames::RestingFrames;
pub use scene_camera::NEAR_PLANE;
pub use stars::StarCatalogue;

use bevy::camera::RenderTarget;
use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResourcePlugin;
use lightfall_core::gpu::Drawable;

/// The whole chain, drawing [`CurrentScene`] in its [`CurrentFrame`] to a window or an image. It
/// needs Bevy's renderer ([`render_plugin`]).
pub struct LightfallRenderPlugin {
    /// The first scene to draw.
    pub scene: Drawable,
    /// Where the last pass writes.
    pub target: RenderTarget,
}

impl Plugin for LightfallRenderPlugin {
    fn build(&self, app: &mut App) {
        drawn_scene::insert(app, self.scene.clone());
        app.insert_resource(ClearColor(Color::BLACK))
            .init_resource::<StarCatalogue>()
            .init_resource::<DetailLimits>()
            .init_resource::<RestingFrames>()
            .init_resource::<GivenLight>()
            .init_resource::<DrawnLayers>()
            .add_plugins((
                ExtractResourcePlugin::<DetailLimits>::default(),
                ExtractResourcePlugin::<DrawnLayers>::default(),
            ))
            .add_plugins(comparison::plugin);
        scene_camera::insert(app, self.target.clone());
        app.add_plugins((
            probe::plugin,
            geodesic::plugin,
            antialias::plugin,
            stars::plugin,
            refine::plugin,
            accumulate::plugin,
            given_light::plugin,
            bloom::plugin,
            develop::plugin,
            print::plugin,
            error_map::plugin,
            capture::plugin,
            redraw::plugin,
            presentation::plugin,
            shader_reload::plugin,
        ));
    }
}
