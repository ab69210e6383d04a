//! The window program: fly the camera, press the keys, see the scene.

mod controls;
mod input;
mod motion;
mod session;
mod state;
mod ui;

pub use controls::bindings::{Bindings, Bound, PadBindings, Switch};
pub use controls::edits::edited;
pub use controls::table::{Action, CONTROLS, Command, Control, FlightInput, Group, control_named};
pub use input::gamepad::{NO_GAMEPAD, deflection, squeeze};
pub use input::key_feedback::remark;
pub use motion::free_fall::FreeFall;
pub use motion::journey_player::{JourneyPlayer, Moment};
pub use motion::pilot::{Steering, steered};
pub use session::display::display;
pub use session::frame_pacing::FramePacing;
pub use session::resolution::Resolution;
pub use state::history::History;
pub use state::settings::{Automatic, Settings};
pub use ui::inspector::pixel_at;
pub use ui::legend::{Swatch, legend};
pub use ui::panel::shown_number;

use crate::picture::quiet_log;
use crate::render::{CurrentScene, LightfallRenderPlugin, ScreenCamera, render_plugin};
use bevy::camera::RenderTarget;
use bevy::prelude::*;
use bevy::window::{PresentMode, WindowResolution};
use bevy::winit::WinitPlugin;
use bevy_egui::{EguiGlobalSettings, EguiPlugin, PrimaryEguiContext};
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::Journey;

/// Three output pixels to a cell of the default grid, which fits a common laptop's screen.
const WINDOW_SIZE: [u32; 2] = [1440, 810];

/// Opens the window and flies until it is closed. The journey begins at once if it is `guided`,
/// else when it is asked for.
pub fn fly(scene: Drawable, journey: Journey, guided: bool) -> AppExit {
    program(scene, journey, guided).run()
}

/// The whole window program, as [`fly`] runs it.
pub fn program(scene: Drawable, journey: Journey, guided: bool) -> App {
    let mut guide = JourneyPlayer::new(journey);
    if guided {
        guide.restart();
    }
    let (mut preferences, fault) = session::window::Preferences::load();
    // Before the renderer opens a device.
    let adapter = session::adapter::AdapterChoice::apply(&mut preferences);
    let mut app = App::new();
    session::window::insert(&mut app, preferences, fault);
    app.add_plugins(
        DefaultPlugins
            .set(quiet_log())
            .set(render_plugin(false))
            .set(any_thread())
            .set(WindowPlugin {
                primary_window: Some(Window {
                    title: title(&scene),
                    name: Some("lightfall".into()),
                    resolution: WindowResolution::new(WINDOW_SIZE[0], WINDOW_SIZE[1]),
                    present_mode: PresentMode::AutoVsync,
                    ..default()
                }),
                ..default()
            }),
    )
    .add_plugins(EguiPlugin::default())
    .insert_resource(EguiGlobalSettings {
        auto_create_primary_context: false,
        ..default()
    })
    .insert_resource(History::new(scene.scene().clone()))
    .insert_resource(Resolution::new(&scene))
    .insert_resource(guide)
    .insert_resource(adapter)
    .add_plugins(LightfallRenderPlugin {
        scene,
        target: RenderTarget::default(),
    })
    .add_plugins((
        state::toast::plugin,
        session::window::plugin,
        input::keyboard::plugin,
        motion::pilot::plugin,
        session::frame_pacing::plugin,
        session::resolution::plugin,
    ))
    .add_plugins((
        session::recovery::RecoveryPlugin,
        session::adapter::plugin,
        input::gamepad::plugin,
    ))
    .add_plugins((
        ui::end_card::plugin,
        motion::journey_player::plugin,
        motion::free_fall::plugin,
        session::exposure::plugin,
    ))
    .add_plugins((
        session::screenshot::plugin,
        ui::status_bar::plugin,
        ui::legend::plugin,
        ui::help::plugin,
        ui::panel::plugin,
        ui::inspector::plugin,
        session::clipboard::plugin,
    ))
    .add_systems(
        Update,
        (attach_ui, retitle.run_if(resource_changed::<CurrentScene>)),
    );
    app
}

/// Where the system does not mind, the program may be run by a thread that is not the first, as
/// tests are.
fn any_thread() -> WinitPlugin {
    WinitPlugin {
        run_on_any_thread: true,
    }
}

/// The user interface belongs to the screen, at its native resolution, and not to the picture.
fn attach_ui(mut commands: Commands, screens: Query<Entity, Added<ScreenCamera>>) {
    for screen in &screens {
        commands.entity(screen).insert(PrimaryEguiContext);
    }
}

fn title(scene: &Scene) -> String {
    if scene.title.is_empty() {
        "Lightfall".into()
    } else {
        format!("Lightfall: {}", scene.title)
    }
}

fn retitle(scene: Res<CurrentScene>, mut window: Single<&mut Window>) {
    let title = title(&scene);
    if window.title != title {
        window.title = title;
    }
}
