//! The presentation: reduces the tone-mapped picture to a grid of cells, quantizes them, and
//! expands them to the output.

mod letterbox;

pub use letterbox::{Letterbox, PictureArea, RestingSizes, letterbox};

use crate::camera_markers::{SceneCamera, ScreenCamera};
use crate::chain::Chain;
use crate::drawn_scene::DrawnScene;
use crate::full_screen_pass::{FullScreenPass, Stage, attachment};
use crate::graphics::{Graphics, create_target};
use crate::live_shaders::add_shader;
use bevy::asset::uuid_handle;
use bevy::core_pipeline::core_2d::main_transparent_pass_2d;
use bevy::core_pipeline::schedule::{Core2d, Core2dSystems};
use bevy::prelude::*;
use bevy::render::camera::ExtractedCamera;
use bevy::render::extract_resource::ExtractResourcePlugin;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, ViewQuery};
use bevy::render::view::{ExtractedView, ViewTarget};
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use lightfall_core::gpu::Presentation;
use lightfall_core::scene::Picture;

/// The shader of all stages.
const SHADER: Handle<Shader> = uuid_handle!("6f0f7c0e-5b7d-4c0c-9a55-0f3f1c1d7a11");

/// Format of the cells: linear light encoded with the sRGB transfer function, so that 8 bits keep
/// every quantization level apart.
const GRID_FORMAT: TextureFormat = TextureFormat::Rgba8UnormSrgb;

/// The stage that reduces the picture to cells.
const PIXELATE: Stage = ("pixelate", [Some(GRID_FORMAT), None]);

/// As many levels as eight bits tell apart.
const EXACT_LEVELS: u32 = 256;

/// The presentation grid and the settings it was filled with.
struct Cells {
    view: TextureView,
    settings: CellSettings,
    /// Whether the cells show the scene camera's last picture.
    filled: bool,
}

/// What cells are filled with besides the picture.
#[derive(Clone, Copy, PartialEq)]
struct CellSettings {
    grid: UVec2,
    levels: f32,
    dither: u32,
}

/// What the scene camera's last picture shows. A new scene's picture may not be drawn yet.
#[derive(Clone, Copy, Default)]
struct LastPicture {
    /// Whether it shows light, rather than colours that have a meaning.
    shows_light: bool,
    /// Whether bloom is added to it.
    bloom: bool,
}

#[derive(Resource)]
struct PresentationPass {
    full_screen: FullScreenPass<Presentation>,
    /// The cells, which last as long as the picture; `None` when they are bypassed.
    cells: Option<Cells>,
    /// Format of the screen camera's main texture.
    output: TextureFormat,
    last_picture: LastPicture,
}

impl PresentationPass {
    /// The stage that draws to the output: it expands the cells, or scales the picture itself.
    fn last_stage(&self) -> Stage {
        let name = if self.cells.is_some() {
            "expand"
        } else {
            "fit"
        };
        (name, [Some(self.output), None])
    }
}

pub(super) fn plugin(app: &mut App) {
    add_shader(
        app,
        &SHADER,
        Presentation::shader(),
        "lightfall/presentation.wgsl",
    );
    app.init_resource::<PictureArea>()
        .add_plugins(ExtractResourcePlugin::<PictureArea>::default());
    app.sub_app_mut(RenderApp)
        .add_systems(RenderStartup, create_presentation_pass)
        .add_systems(
            Render,
            prepare_presentation_pass.in_set(RenderSystems::PrepareResources),
        )
        .add_systems(
            Core2d,
            (draw_cells, draw_output)
                .chain()
                .in_set(Core2dSystems::MainPass)
                .after(main_transparent_pass_2d),
        );
}

fn create_presentation_pass(mut commands: Commands) {
    commands.insert_resource(PresentationPass {
        full_screen: FullScreenPass::new("presentation layout", SHADER, 1),
        cells: None,
        output: TextureFormat::Rgba8UnormSrgb,
        last_picture: LastPicture::default(),
    });
}

/// Writes the uniform, and creates the cells and pipelines that the settings need.
fn prepare_presentation_pass(
    scene: Res<DrawnScene>,
    area: Res<PictureArea>,
    screen: Query<(&ExtractedCamera, &ExtractedView), With<ScreenCamera>>,
    scene_camera: Query<(&ViewTarget, Has<ExtractedCamera>), With<SceneCamera>>,
    If(mut pass): If<ResMut<PresentationPass>>,
    graphics: Graphics,
) {
    let (Ok((camera, view)), Ok((source, active))) = (screen.single(), scene_camera.single())
    else {
        return;
    };
    let Some(output) = camera
        .physical_target_size
        .filter(|size| size.min_element() > 0)
    else {
        return;
    };
    // While a new scene is not drawn yet, the last picture is shown, whose size may be another.
    let size = source.main_texture().size();
    let grid = area
        .at_rest
        .map_or(scene.picture.grid(), |at_rest| at_rest.grid);
    let picture = Picture {
        width: size.width,
        height: size.height,
        grid_width: grid.x,
        grid_height: grid.y,
        ..scene.picture
    };
    let Letterbox { offset, extent } = area.letterbox(&picture, output);
    if active {
        pass.last_picture = LastPicture {
            shows_light: scene.view.shows_light(),
            bloom: Chain::of(&scene).bloom.is_some(),
        };
    }
    let LastPicture { shows_light, bloom } = pass.last_picture;
    // A view's colours have meanings, so they are shown as they are.
    let (levels, dither) = if shows_light {
        (picture.levels, picture.dither)
    } else {
        (EXACT_LEVELS, false)
    };
    let uniform = Presentation {
        picture: picture.size(),
        grid,
        offset,
        extent,
        levels: levels as f32,
        dither: u32::from(dither),
        bloom: u32::from(bloom),
    };
    pass.output = view.target_format;
    let cells = pass.cells.take();
    pass.cells = Chain::of(&scene).cells.map(|_| {
        let settings = CellSettings {
            grid,
            levels: uniform.levels,
            dither: uniform.dither,
        };
        let same_grid = cells.filter(|cells| cells.settings.grid == grid);
        let is_kept = |cells: &Cells| cells.filled && cells.settings == settings && !active;
        Cells {
            filled: same_grid.as_ref().is_some_and(is_kept),
            view: same_grid.map_or_else(
                || create_target(&graphics.device, "presentation grid", grid, GRID_FORMAT, 1),
                |cells| cells.view,
            ),
            settings,
        }
    });
    pass.full_screen.write(uniform, &graphics);
    let last = pass.last_stage();
    pass.full_screen.queue(last, &graphics.cache);
    if pass.cells.is_some() {
        pass.full_screen.queue(PIXELATE, &graphics.cache);
    }
}

/// Reduces the picture to cells, unless they are already filled with it.
fn draw_cells(
    _screen: ViewQuery<&ViewTarget, With<ScreenCamera>>,
    scene_camera: Query<&ViewTarget, With<SceneCamera>>,
    If(mut pass): If<ResMut<PresentationPass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let (Some(cells), Ok(source)) = (&pass.cells, scene_camera.single()) else {
        return;
    };
    if cells.filled {
        return;
    }
    let filled = pass.full_screen.draw(
        &mut context,
        &cache,
        PIXELATE,
        &[source.main_texture_view()],
        &[attachment(&cells.view)],
    );
    if let Some(cells) = &mut pass.cells {
        cells.filled = filled;
    }
}

/// Draws the cells to the output, or the picture itself when the cells are bypassed.
fn draw_output(
    screen: ViewQuery<&ViewTarget, With<ScreenCamera>>,
    scene_camera: Query<&ViewTarget, With<SceneCamera>>,
    If(pass): If<Res<PresentationPass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let screen = screen.into_inner();
    let Ok(picture) = scene_camera.single() else {
        return;
    };
    let cells = pass.cells.as_ref().map(|cells| &cells.view);
    pass.full_screen.draw(
        &mut context,
        &cache,
        pass.last_stage(),
        &[cells.unwrap_or(picture.main_texture_view())],
        &[attachment(screen.main_texture_view())],
    );
}
